# SPDX-License-Identifier: MIT
# The dock Sinew: the five steps of the page for the meshes that are selected in the open scene, each press one step of undo.
tool
extends VBoxContainer

signal done  # a press that waited for an import is through

const Character = preload("character.gd")
const Command = preload("command.gd")
const ExportStep = preload("export_step.gd")
const MotionStep = preload("motion_step.gd")
const Skinning = preload("skinning.gd")
const Step = preload("step.gd")
const STEPS = ["Mesh", "Skeleton", "Weights", "Motion", "Export"]  # those of the page (samples/web)

var plugin: EditorPlugin
var rail: VBoxContainer  # a button a step, with a tick where it has what it is for
var steps: TabContainer
var facts: Label
var rigid_parts: OptionButton
var softness: SpinBox
var all_bones: CheckBox
var symmetric: CheckBox
var motion: MotionStep
var export_step: ExportStep
var message: Label


func _init() -> void:
	name = "Sinew"
	rail = VBoxContainer.new()
	rail.add_constant_override("separation", 0)
	add_child(rail)
	steps = TabContainer.new()
	steps.tabs_visible = false
	motion = MotionStep.new()
	export_step = ExportStep.new()
	var group = ButtonGroup.new()
	for step in STEPS:
		var page = motion if step == "Motion" else export_step if step == "Export" else Step.new()
		page.name = step
		steps.add_child(page)
		var opener = Button.new()
		opener.text = step
		opener.align = Button.ALIGN_LEFT
		opener.toggle_mode = true
		opener.group = group
		opener.connect("pressed", steps, "set_current_tab", [rail.get_child_count()])
		rail.add_child(opener)
	add_child(steps)
	facts = page("Mesh").sentence
	page("Skeleton").button("New skeleton", "Make a skeleton for the selected meshes, and bind them to it", self, "rig")
	build_weights(page("Weights"))
	motion.build(self)
	export_step.build(self)
	export_step.sentence.text = "A file for other programs."
	message = Label.new()
	message.autowrap = true
	add_child(message)
	steps.connect("tab_changed", self, "show_step")
	show_meshes([])
	show_step(steps.current_tab)


func build_weights(step: Step) -> void:
	step.button("Bind", "Predict weights of the selected meshes for their skeleton, or for a selected Skeleton", self, "bind")
	rigid_parts = OptionButton.new()
	for text in ["auto", "always", "never"]:
		rigid_parts.add_item(text)
	step.row("Rigid parts", rigid_parts, "always: every connected part moves with one bone, as in robots and toys")
	softness = SpinBox.new()
	softness.min_value = 0.25
	softness.max_value = 4
	softness.step = 0.05
	softness.value = 1
	step.row("Soft", softness, "How softly weights blend between bones: 2 twice as softly, 0.5 harder")
	symmetric = CheckBox.new()
	step.row("Symmetric weights", symmetric, "Both sides get mirrored weights")
	all_bones = CheckBox.new()
	step.row("All bones", all_bones, "Every bone may get weight; else those that have some, or by their names those that deform")


func page(step: String) -> Node:
	return steps.get_child(STEPS.find(step))


func show_step(step: int) -> void:
	rail.get_child(step).pressed = true


func show_selected() -> void:
	show_meshes(selected_characters())


# Says what is selected, and opens the first step that is still to do.
func show_meshes(instances: Array) -> void:
	steps.current_tab = tell(instances).find(false)


# Says what is selected, and ticks what is done. Returns which steps are.
func tell(instances: Array) -> Array:
	var vertices = 0
	var joints = 0
	var bound = not instances.empty()
	var rigged = not instances.empty()
	for instance in instances:
		var skeleton = Skinning.skeleton_of(instance)
		vertices += Skinning.vertex_count(instance.mesh)
		joints = int(max(joints, skeleton.get_bone_count() if skeleton != null else 0))
		bound = bound and instance.skin != null
		rigged = rigged and skeleton != null
	var moves = motion_of(instances[0]) if bound else ""
	facts.text = "Select the meshes of a character." if instances.empty() else "%d vertices in %d meshes." % [vertices, instances.size()]
	page("Skeleton").sentence.text = "%d joints." % joints if rigged else "No joints yet."
	page("Weights").sentence.text = "Bound." if bound else "Not bound yet."
	motion.sentence.text = "No motion yet." if moves == "" else "Moves by %s." % moves
	var finished = [not instances.empty(), rigged, bound, moves != "", false]
	for step in STEPS.size():
		tick(rail.get_child(step), finished[step])
	return finished


# A button with a tick, or with as much room for one.
func tick(opener: Button, is_done: bool) -> void:
	opener.set_meta("done", is_done)
	if not has_icon("StatusSuccess", "EditorIcons"):
		return
	var icon = get_icon("StatusSuccess", "EditorIcons")
	if not is_done:
		var blank = Image.new()
		blank.create(int(icon.get_width()), int(icon.get_height()), false, Image.FORMAT_RGBA8)
		icon = ImageTexture.new()
		icon.create_from_image(blank)
	opener.icon = icon


# The first animation of the players beside a mesh's skeleton, or "".
static func motion_of(instance: MeshInstance) -> String:
	var skeleton = Skinning.skeleton_of(instance)
	var beside = skeleton.get_parent() if skeleton != null else null
	for node in (beside.get_children() if beside != null else []):
		if node is AnimationPlayer and not node.get_animation_list().empty():
			return node.get_animation_list()[0]
	return ""


func selected(type) -> Array:
	var found = []
	for node in plugin.get_editor_interface().get_selection().get_selected_nodes():
		if node is type and (not node is MeshInstance or node.mesh != null):
			found.append(node)
	return found


# The selected meshes; those below what is selected, a character's scene say, where none is.
func selected_characters() -> Array:
	var found = selected(MeshInstance)
	if found.empty():
		for node in plugin.get_editor_interface().get_selection().get_selected_nodes():
			find_meshes(node, found)
	return found


static func find_meshes(node: Node, found: Array) -> void:
	if node is MeshInstance and node.mesh != null and not node in found:
		found.append(node)
	for child in node.get_children():
		find_meshes(child, found)


func say(text: String):
	message.text = text
	if text.begins_with("sinew: error: "):
		push_error(text)


func options() -> Array:
	return ["--rigid-parts", rigid_parts.get_item_text(rigid_parts.selected), "--softness", softness.value]


func bind():
	var instances = selected(MeshInstance)
	var skeletons = selected(Skeleton)
	if instances.empty():
		return say("sinew: error: no mesh is selected; select MeshInstances, and a Skeleton where they have none")
	var skeleton = skeletons[0] if skeletons.size() == 1 else Skinning.skeleton_of(instances[0])
	if skeleton == null:
		return say("sinew: error: %s has no skeleton; select one beside it, or press New skeleton" % instances[0].name)
	for instance in instances:
		if skeletons.empty() and Skinning.skeleton_of(instance) != skeleton:
			return say("sinew: error: %s and %s have different skeletons; bind them apart" % [instances[0].name, instance.name])
	var extra = options()
	if symmetric.pressed:
		extra.append("--symmetric")
	if all_bones.pressed:
		extra += ["--joints", "all"]
	finish("Bind", Skinning.bind(instances, skeleton, extra), null)


func rig():
	var instances = selected(MeshInstance)
	if instances.empty():
		return say("sinew: error: no mesh is selected; select MeshInstances")
	var root = plugin.get_editor_interface().get_edited_scene_root()
	var parent = instances[0] if instances[0] == root else instances[0].get_parent()
	finish("Rig", Skinning.rig(instances, parent, options() + (["--mirror"] if symmetric.pressed else [])), parent)


func finish(name: String, answer: Dictionary, parent: Node):
	if answer.error != "":
		return say(answer.error)
	Skinning.commit(plugin.get_undo_redo(), "Sinew: %s" % name, answer, parent, plugin.get_editor_interface().get_edited_scene_root())
	say("%s: %d meshes" % [name, answer.changes.size()])
	tell(selected_characters())


# The character of `instances` with the chosen motion, in a file beside it. Returns what motion_step.gd's write() does, and `character`.
func write_motion(instances: Array, root: Node) -> Dictionary:
	return written(motion, "Animate", instances, root)


# The same of the step Export, with what sinew check finds.
func write_export(instances: Array, root: Node) -> Dictionary:
	export_step.clear_findings()
	var answer = written(export_step, "Export", instances, root)
	if answer.error == "":
		answer.error = export_step.check(answer.path)
		if answer.error != "":
			say(answer.error)
	return answer


func written(step: Step, name: String, instances: Array, root: Node) -> Dictionary:
	var character = Character.of(instances, root)
	var answer = { "error": character.error, "lines": [], "path": "" }
	if answer.error == "":
		answer = step.write(character)
	Command.remove(character.files)
	answer.character = character
	if answer.error != "":
		say(Character.plain(answer.error, character))
		return answer
	var lines = PoolStringArray(["%s: %s" % [name, ProjectSettings.localize_path(answer.path)]])
	for line in answer.lines:
		if not line.begins_with("wrote "):
			lines.append(Character.plain(line, character))
	say(lines.join("\n"))
	return answer


func animate():
	var editor = plugin.get_editor_interface()
	var root = editor.get_edited_scene_root()
	var answer = write_motion(selected_characters(), root)
	if answer.error != "":
		emit_signal("done")
		return
	yield(imported(answer.path), "completed")
	var scene = load(answer.path) if ResourceLoader.exists(answer.path) else null
	if not scene is PackedScene:
		say("%s\nGodot could not import it." % message.text)
	elif editor.get_edited_scene_root() == root and root != null and is_instance_valid(answer.character.nodes[0]):
		var instance = scene.instance()
		instance.name = answer.path.get_file().get_basename().replace(".", "_")
		put(instance, answer.character, root)
		editor.get_selection().clear()
		editor.get_selection().add_node(instance)
		yield(get_tree(), "idle_frame")
		steps.current_tab = STEPS.find("Motion")  # a selection opens the next
		say("%s\nIt is in the scene; what it stands for is hidden." % message.text)
	emit_signal("done")


func export_character():
	var answer = write_export(selected_characters(), plugin.get_editor_interface().get_edited_scene_root())
	var files = plugin.get_editor_interface().get_resource_filesystem()
	if answer.error == "" and not files.is_scanning():
		files.call_deferred("scan")  # where it lies in the project, the editor shows it


# Waits until the editor has imported a new file of the project. A scan within an import of another would end the editor, so each begins
# when the one before is through.
func imported(path: String):
	var files = plugin.get_editor_interface().get_resource_filesystem()
	if not files.is_scanning():
		files.call_deferred("scan")
	for scan in 3:
		yield(files, "filesystem_changed")
		yield(get_tree(), "idle_frame")
		if ResourceLoader.exists(path):
			return
		files.call_deferred("scan")  # the last had passed the file by


# The written character in the scene in place of what it was made from, which is hidden: one step of undo.
func put(instance: Node, character: Dictionary, root: Node) -> void:
	var shown = character.nodes[0]
	var parent = root if shown == root else shown.get_parent()
	if instance is Spatial:
		instance.transform = character.place if not parent is Spatial else parent.global_transform.affine_inverse() * character.place
	var undo_redo = plugin.get_undo_redo()
	undo_redo.create_action("Sinew: Animate")
	undo_redo.add_do_method(parent, "add_child", instance, true)
	undo_redo.add_do_method(instance, "set_owner", root)
	undo_redo.add_do_reference(instance)
	undo_redo.add_undo_method(parent, "remove_child", instance)
	for node in character.nodes:
		if node is Spatial and node != root:
			undo_redo.add_do_property(node, "visible", false)
			undo_redo.add_undo_property(node, "visible", node.visible)
	undo_redo.commit_action()
	for child in instance.get_children():
		if child is AnimationPlayer and not child.get_animation_list().empty():
			child.play(child.get_animation_list()[0])  # a look at it; the scene does not keep that it plays
