# SPDX-License-Identifier: MIT
# The dock in an editor: Rig, undo, redo and Bind with the mesh of res://stage.tscn; a picture to WINDOW_PICTURE-bound.png, in an editor
# without a window "none".
tool
extends EditorPlugin

var failed = 0


func _ready() -> void:
	if OS.get_environment("WINDOW_PICTURE") != "":
		call_deferred("press")


func has_window() -> bool:
	return OS.get_environment("WINDOW_PICTURE") != "none"


func expect(condition: bool, what: String) -> void:
	if not condition:
		failed += 1
		print("FAILED: " + what)


func press():
	yield(get_editor_interface().get_resource_filesystem(), "filesystem_changed")  # all is imported already
	yield(get_tree(), "idle_frame")
	get_editor_interface().open_scene_from_path("res://stage.tscn")
	get_editor_interface().set_main_screen_editor("3D")
	while get_editor_interface().get_edited_scene_root() == null:
		yield(get_tree(), "idle_frame")
	yield(get_tree(), "idle_frame")
	var dock = get_editor_interface().get_base_control().find_node("Sinew", true, false)
	expect(dock != null, "the dock is there")
	dock.get_parent().current_tab = dock.get_index()
	var root = get_editor_interface().get_edited_scene_root()
	var mesh = root.get_node("Mesh")
	var before = mesh.mesh
	dock.bind()
	expect(dock.message.text.begins_with("sinew: error: no mesh is selected"), "nothing selected: " + dock.message.text)
	get_editor_interface().get_selection().add_node(mesh)
	dock.bind()
	expect(dock.message.text.begins_with("sinew: error: Mesh has no skeleton"), "no skeleton: " + dock.message.text)
	dock.rig()
	expect(dock.message.text == "Rig: 1 meshes", dock.message.text)
	expect(root.has_node("Skeleton") and root.get_node("Skeleton").owner == root and mesh.mesh != before, "a skeleton of the scene")
	get_undo_redo().undo()
	expect(not root.has_node("Skeleton") and mesh.mesh == before and mesh.skin == null, "undone")
	get_undo_redo().redo()
	var rigged = mesh.mesh
	dock.bind()
	expect(dock.message.text == "Bind: 1 meshes" and mesh.mesh != rigged, dock.message.text)
	get_undo_redo().undo()
	expect(mesh.mesh == rigged, "the bind undone")
	get_undo_redo().redo()
	# Bent, so that the picture shows that the surface follows.
	var skeleton = root.get_node("Skeleton")
	skeleton.set_bone_pose(skeleton.find_bone("LeftArm"), Transform(Basis(Vector3(0, 0, 1), 1.0)))
	skeleton.set_bone_pose(skeleton.find_bone("RightUpLeg"), Transform(Basis(Vector3(1, 0, 0), -0.8)))
	yield(picture("bound"), "completed")
	print("WINDOW OK" if failed == 0 else "WINDOW FAILED")
	if has_window():
		get_tree().quit()
	else:
		OS.kill(OS.get_process_id())  # quit() waits for pictures of new files, which godot3-server never draws


# Of the editor, to WINDOW_PICTURE-NAME.png.
func picture(name: String):
	yield(get_tree(), "idle_frame")
	if not has_window():
		return
	for frame in 10:  # layout, then the viewport, are drawn again
		get_editor_interface().get_base_control().update()  # an editor without focus draws what has changed
		yield(VisualServer, "frame_post_draw")
	var image = get_tree().get_root().get_texture().get_data()
	image.flip_y()
	expect(image.save_png("%s-%s.png" % [OS.get_environment("WINDOW_PICTURE"), name]) == OK, "a picture")
