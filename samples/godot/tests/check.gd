# SPDX-License-Identifier: MIT
# What the plug-in imports and binds beside the command's own answers; tests/integration/godot_test.sh makes the project around it.
extends SceneTree

const Command = preload("res://addons/sinew/command.gd")
const Skinning = preload("res://addons/sinew/skinning.gd")

var failed = 0
var checked = 0


func _init():
	call_deferred("check")


func check():
	for name in ["rigged", "bound"]:
		var scene = instance("res://%s.obj" % name)
		var mesh = find(scene, MeshInstance)
		expect(mesh.skin != null, name + ": the mesh has a skin")
		same_skeleton(name, skeleton_of(mesh), "res://expected/%s.rig.txt" % name)
		same_weights(name, mesh, "res://%s.obj" % name, "res://expected/%s.rig.txt" % name)
		unmoved(name, mesh, mesh.global_transform, mesh.mesh)
		scene.free()
	motion()
	bind_in_scene()
	rig_in_scene()
	shapes()
	errors()
	stage()
	if failed == 0:
		print("GODOT OK: %d checks" % checked)
	quit()


func expect(condition: bool, what: String) -> void:
	checked += 1
	if not condition:
		failed += 1
		print("FAILED: " + what)


func instance(path: String) -> Node:
	var scene = load(path).instance()
	get_root().add_child(scene)
	return scene


func find(node: Node, type) -> Node:
	if node is type:
		return node
	for child in node.get_children():
		var found = find(child, type)
		if found != null:
			return found
	return null


func skeleton_of(mesh: MeshInstance) -> Skeleton:
	return mesh.get_node(mesh.skeleton) as Skeleton


func same_skeleton(what: String, skeleton: Skeleton, expected: String) -> void:
	var rig = Skinning.read_rig(expected)
	expect(rig.error == "" and rig.names.size() > 10, what + ": " + expected)
	expect(skeleton.get_bone_count() == rig.names.size(), what + ": as many bones as the command's joints")
	for i in rig.names.size():
		var bone = bone_named(skeleton, rig.names[i])
		expect(bone >= 0, what + ": a bone " + rig.names[i])
		expect(Skinning.rest_global(skeleton, bone).origin.distance_to(rig.positions[i]) < 1e-5, what + ": place of " + rig.names[i])


# Godot's glTF importer turns LeftFoot and thigh.L into left_foot and thigh_l.
func plain(name: String) -> String:
	return name.to_lower().replace("_", "").replace(".", "")


func bone_named(skeleton: Skeleton, name: String) -> int:
	for bone in skeleton.get_bone_count():
		if plain(skeleton.get_bone_name(bone)) == plain(name):
			return bone
	return -1


# A vertex by its place: Godot's glTF importer puts vertices in another order.
func place(p: Vector3) -> String:
	return "%d %d %d" % [round(p.x * 1e4 + 0.137), round(p.y * 1e4 + 0.137), round(p.z * 1e4 + 0.137)]


func obj_vertices(path: String) -> Array:
	var vertices = []
	var file = File.new()
	file.open(path, File.READ)
	for line in file.get_as_text().split("\n"):
		var words = line.split(" ", false)
		if words.size() >= 4 and words[0] == "v":
			vertices.append(Vector3(float(words[1]), float(words[2]), float(words[3])))
	return vertices


# "bone weight" in 1/65535, by the bones' names.
func row_text(weights: Dictionary) -> String:
	var words = []
	for name in weights:
		if weights[name] > 0:
			words.append("%s %d" % [plain(name), weights[name]])
	words.sort()
	return PoolStringArray(words).join(" ")


# By the places of the vertices of `obj` what weights `expected` has there: { place: [row_text(), ...] }.
func rows_by_place(obj: String, expected: String) -> Dictionary:
	var rig = Skinning.read_rig(expected)
	var rows = {}
	var vertices = obj_vertices(obj)
	for v in vertices.size():
		var row = rig.skin.get(v, [])
		var wanted = {}
		for k in range(0, row.size(), 2):
			wanted[rig.names[row[k]]] = row[k + 1]
		if not rows.has(place(vertices[v])):
			rows[place(vertices[v])] = []
		rows[place(vertices[v])].append(row_text(wanted))
	return rows


# To the last of 65535. `expected` has the weights of the vertices of `obj`.
func same_weights(what: String, mesh: MeshInstance, obj: String, expected: String) -> void:
	var rows = rows_by_place(obj, expected)
	var vertices = obj_vertices(obj)
	var skeleton = skeleton_of(mesh)
	var count = 0
	var differing = 0
	for surface in mesh.mesh.get_surface_count():
		var arrays = mesh.mesh.surface_get_arrays(surface)
		for v in arrays[Mesh.ARRAY_VERTEX].size():
			var found = {}
			for k in 4:
				var bone = skeleton.get_bone_name(Skinning.bone_of_bind(mesh.skin, arrays[Mesh.ARRAY_BONES][4 * v + k], skeleton))
				found[bone] = found.get(bone, 0) + int(round(arrays[Mesh.ARRAY_WEIGHTS][4 * v + k] * 65535))
			count += 1
			var wanted = rows.get(place(arrays[Mesh.ARRAY_VERTEX][v]), [])
			if not row_text(found) in wanted:
				differing += 1
				if differing <= 3:
					print("%s: vertex %d has %s, the command's %s" % [what, v, row_text(found), wanted])
	expect(count == vertices.size() and differing == 0, "%s: %d of %d vertices differ from %s" % [what, differing, count, expected])


# The skinned surface at rest lies where the bare one was.
func unmoved(what: String, mesh: MeshInstance, before: Transform, bare: Mesh) -> void:
	var skeleton = skeleton_of(mesh)
	var farthest = 0.0
	for surface in bare.get_surface_count():
		var vertices = bare.surface_get_arrays(surface)[Mesh.ARRAY_VERTEX]
		var arrays = mesh.mesh.surface_get_arrays(surface)
		for v in range(0, vertices.size(), 7):
			var at = Vector3()
			for k in 4:
				var bind = arrays[Mesh.ARRAY_BONES][4 * v + k]
				var bone = Skinning.bone_of_bind(mesh.skin, bind, skeleton)
				at += arrays[Mesh.ARRAY_WEIGHTS][4 * v + k] * (Skinning.rest_global(skeleton, bone) * mesh.skin.get_bind_pose(bind)).xform(arrays[Mesh.ARRAY_VERTEX][v])
			farthest = max(farthest, mesh.global_transform.xform(at).distance_to(before.xform(vertices[v])))
	expect(farthest < 1e-3, "%s: the surface at rest moved by %s" % [what, farthest])


func bare(mesh: Mesh) -> ArrayMesh:
	var made = ArrayMesh.new()
	for surface in mesh.get_surface_count():
		var arrays = mesh.surface_get_arrays(surface)
		arrays[Mesh.ARRAY_BONES] = null
		arrays[Mesh.ARRAY_WEIGHTS] = null
		made.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	return made


func motion() -> void:
	var scene = instance("res://moved.obj")
	var player = find(scene, AnimationPlayer)
	expect(player != null and player.get_animation_list().size() == 1, "moved: one animation")
	var animation = player.get_animation(player.get_animation_list()[0])
	var skeleton = skeleton_of(find(scene, MeshInstance))
	expect(animation.length > 0.03 and animation.get_track_count() > 0, "moved: tracks")
	for track in animation.get_track_count():
		var path = animation.track_get_path(track)
		expect(player.get_node(player.root_node).get_node(String(path).split(":")[0]) == skeleton, "moved: track %s of the skeleton" % path)
		expect(skeleton.find_bone(path.get_subname(0)) >= 0, "moved: bone of track %s" % path)
	scene.free()


func bind_in_scene() -> void:
	var scene = instance("res://bound.obj")
	var mesh = find(scene, MeshInstance)
	var skeleton = skeleton_of(mesh)
	var before = mesh.mesh
	# Some weights as they are: only their bones get some again.
	var answer = Skinning.bind([mesh], skeleton, [])
	expect(answer.error == "", answer.error)
	var undo = UndoRedo.new()
	Skinning.commit(undo, "Bind", answer, null, scene)
	expect(mesh.mesh != before, "bind: a new mesh")
	same_weights("bind again", mesh, "res://bound.obj", "res://expected/bound_again.rig.txt")
	undo.undo()
	expect(mesh.mesh == before, "bind: undone")
	# None, no skin, beside the skeleton: it stays where it is.
	var without = bare(before)
	mesh.mesh = without
	mesh.skin = null
	mesh.translation = Vector3(0.25, 0.5, -0.125)
	var stood = mesh.global_transform
	skeleton.translation = mesh.translation
	mesh.global_transform = stood
	answer = Skinning.bind([mesh], skeleton, [])
	expect(answer.error == "", answer.error)
	Skinning.commit(undo, "Bind", answer, null, scene)
	unmoved("bind, no skin", mesh, stood, without)
	mesh.skin = null
	mesh.mesh = without
	skeleton.translation = Vector3()
	mesh.global_transform = Transform()
	answer = Skinning.bind([mesh], skeleton, [])
	Skinning.commit(undo, "Bind", answer, null, scene)
	same_weights("bind, bare", mesh, "res://bound.obj", "res://expected/bound_bare.rig.txt")
	undo.undo()
	expect(mesh.mesh == without and mesh.skin == null, "bind, bare: undone")
	undo.redo()
	same_weights("bind, redone", mesh, "res://bound.obj", "res://expected/bound_bare.rig.txt")
	undo.free()
	scene.free()


func rig_in_scene() -> void:
	var scene = instance("res://rigged.obj")
	var without = bare(find(scene, MeshInstance).mesh)
	var place = Spatial.new()
	get_root().add_child(place)
	place.rotation_degrees = Vector3(0, 30, 0)
	var mesh = MeshInstance.new()
	mesh.mesh = without
	place.add_child(mesh)
	mesh.translation = Vector3(1, 2, 3)
	var stood = mesh.global_transform
	var answer = Skinning.rig([mesh], place, [])
	expect(answer.error == "", answer.error)
	var undo = UndoRedo.new()
	Skinning.commit(undo, "Rig", answer, place, place)
	same_skeleton("rig", skeleton_of(mesh), "res://expected/rigged.rig.txt")
	same_weights("rig", mesh, "res://rigged.obj", "res://expected/rigged.rig.txt")
	unmoved("rig", mesh, stood, without)
	undo.undo()
	expect(mesh.mesh == without and mesh.skin == null and find(place, Skeleton) == null, "rig: undone")
	undo.redo()
	expect(find(place, Skeleton) != null, "rig: redone")
	unmoved("rig, redone", mesh, stood, without)
	place.free()
	undo.free()
	scene.free()


# Blend shapes, their names and materials stay.
func shapes() -> void:
	var scene = instance("res://bound.obj")
	var mesh = find(scene, MeshInstance)
	var arrays = mesh.mesh.surface_get_arrays(0)
	var moved = arrays[Mesh.ARRAY_VERTEX]
	for v in moved.size():
		moved[v] += Vector3(0, 1, 0)
	var shape = arrays.duplicate()
	shape[Mesh.ARRAY_VERTEX] = moved
	shape[Mesh.ARRAY_INDEX] = null
	var made = ArrayMesh.new()
	made.add_blend_shape("up")
	made.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays, [shape])
	made.surface_set_material(0, SpatialMaterial.new())
	made.surface_set_name(0, "skin")
	mesh.mesh = made
	var answer = Skinning.bind([mesh], skeleton_of(mesh), [])
	expect(answer.error == "", answer.error)
	var bound = answer.changes[0].mesh
	expect(bound.get_blend_shape_count() == 1 and bound.get_blend_shape_name(0) == "up", "shapes: kept")
	var kept = bound.surface_get_blend_shape_arrays(0)
	var was = made.surface_get_blend_shape_arrays(0)
	expect(kept.size() == was.size() and (was.size() == 0 or kept[0][Mesh.ARRAY_VERTEX] == was[0][Mesh.ARRAY_VERTEX]), "shapes: same places")
	expect(bound.surface_get_material(0) == made.surface_get_material(0) and bound.surface_get_name(0) == "skin", "shapes: material and name")
	scene.free()


func errors() -> void:
	# OS.execute() goes through a shell.
	expect(Command.run(["inspect", ProjectSettings.globalize_path("res://") + "../odd $HOME `id` \\ name.obj"]) == "", "odd file names")
	expect(Command.run(["inspect", "/nowhere.obj"]) == "sinew: error: /nowhere.obj: no such file", "the command's own line")
	var scene = instance("res://bound.obj")
	var mesh = find(scene, MeshInstance)
	var before = mesh.mesh
	var capsule = MeshInstance.new()
	capsule.mesh = CapsuleMesh.new()
	get_root().add_child(capsule)
	var made = Skinning.rig([capsule], get_root(), [])
	expect(made.error == "" and made.changes[0].mesh.surface_get_arrays(0)[Mesh.ARRAY_WEIGHTS].size() > 0, "a mesh of Godot's own: " + made.error)
	made.skeleton.free()
	ProjectSettings.set_setting(Command.SETTING, "/nowhere/sinew")
	capsule.free()
	var answer = Skinning.bind([mesh], skeleton_of(mesh), [])
	expect(answer.error.begins_with("sinew: error: no command at '/nowhere/sinew'; set Project Settings"), "no command: " + answer.error)
	expect(answer.changes.empty() and mesh.mesh == before, "no command: nothing changes")
	scene.free()


# The scene of window/window.gd: a bare mesh.
func stage() -> void:
	var scene = instance("res://rigged.obj")
	var root = Spatial.new()
	root.name = "Stage"
	var mesh = MeshInstance.new()
	mesh.name = "Mesh"
	mesh.mesh = bare(find(scene, MeshInstance).mesh)
	mesh.translation = Vector3(0.5, 0, 0)
	root.add_child(mesh)
	mesh.owner = root
	mesh.material_override = SpatialMaterial.new()
	mesh.material_override.albedo_color = Color(0.9, 0.6, 0.3)
	var light = DirectionalLight.new()
	light.rotation_degrees = Vector3(-40, 30, 0)
	light.name = "Light"
	root.add_child(light)
	light.owner = root
	var packed = PackedScene.new()
	expect(packed.pack(root) == OK and ResourceSaver.save("res://stage.tscn", packed) == OK, "a stage")
	root.free()
	scene.free()
