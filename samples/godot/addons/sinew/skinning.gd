# SPDX-License-Identifier: MIT
# Meshes of the open scene to the command and its answer back: an OBJ and a rig.txt (formats/spec/rig.md) each way.
# Nothing is changed here: the answer is a list of properties that the caller sets, with undo.
tool
extends Reference

const Command = preload("command.gd")
const INFLUENCES = 4  # what Godot 3 has a vertex


# New weights for mesh instances of one skeleton, bound together. `extra` are more words for `sinew bind`.
# Returns { error, changes }: error is "" or one line; each change { node, mesh, skin, skeleton, transform } is of one mesh instance.
static func bind(instances: Array, skeleton: Skeleton, extra: Array) -> Dictionary:
	var joints = joints_at_bind(instances, skeleton)
	var names = joint_names(skeleton)
	var files = [Command.temporary("mesh.obj"), Command.temporary("skeleton.rig.txt"), Command.temporary("answer.rig.txt")]
	var placements = []
	for instance in instances:
		placements.append(placement(instance, skeleton, joints))
	var error = write_obj(files[0], instances, placements)
	if error == "":
		error = write_rig(files[1], skeleton, joints, instances)
	if error == "":
		error = Command.run(["bind", files[0], "--skeleton", files[1], "-o", files[2], "--influences", INFLUENCES] + extra)
	var answer = {}
	if error == "":
		answer = read_rig(files[2])
		error = answer.error
	Command.remove(files)
	if error != "":
		return { "error": error, "changes": [] }
	var changes = []
	var first = 0
	for i in instances.size():
		var instance = instances[i]
		var change = { "node": instance, "skeleton": instance.get_path_to(skeleton), "transform": instance.transform }
		if instance.skin != null and instance.skin.get_bind_count() > 0:
			change.skin = with_all_bones(instance.skin, skeleton, joints, placements[i])
		else:
			change.skin = new_skin(skeleton.get_bone_count(), joints, placements[i])
			change.transform = transform_at(instance, skeleton.global_transform)
		var by_bone = binds_of_bones(change.skin, skeleton)
		var binds = []
		for name in answer.names:
			binds.append(by_bone[names.find(name)])
		change.mesh = with_weights(instance.mesh, first, answer.skin, binds)
		if change.mesh == null:
			return { "error": not_taken(instance), "changes": [] }
		first += vertex_count(instance.mesh)
		changes.append(change)
	return { "error": "", "changes": changes }


# A skeleton for bare meshes and their weights. Returns what bind() does, and `skeleton`, a node that is not in a scene yet:
# it belongs below `parent` under the name it has.
static func rig(instances: Array, parent: Node, extra: Array) -> Dictionary:
	var space = instances[0].global_transform
	var placements = []
	for instance in instances:
		placements.append(space.affine_inverse() * instance.global_transform)
	var files = [Command.temporary("mesh.obj"), Command.temporary("answer.rig.txt")]
	var error = write_obj(files[0], instances, placements)
	if error == "":
		error = Command.run(["rig", files[0], "-o", files[1], "--influences", INFLUENCES] + extra)
	var answer = {}
	if error == "":
		answer = read_rig(files[1])
		error = answer.error
	Command.remove(files)
	if error != "":
		return { "error": error, "changes": [] }
	var first = 0
	var bones = range(answer.names.size())
	var meshes = []
	for instance in instances:
		meshes.append(with_weights(instance.mesh, first, answer.skin, bones))
		if meshes.back() == null:
			return { "error": not_taken(instance), "changes": [] }
		first += vertex_count(instance.mesh)
	var skeleton = Skeleton.new()
	skeleton.name = "Skeleton"
	while parent.has_node(skeleton.name):
		skeleton.name += "_"
	for i in answer.names.size():
		skeleton.add_bone(answer.names[i])
	var joints = []
	for i in answer.names.size():
		var above = answer.parents[i]
		joints.append(Transform(Basis(), answer.positions[i]))
		skeleton.set_bone_parent(i, above)
		skeleton.set_bone_rest(i, Transform(Basis(), answer.positions[i] - (answer.positions[above] if above >= 0 else Vector3())))
	skeleton.transform = space if not parent is Spatial else parent.global_transform.affine_inverse() * space
	var changes = []
	for i in instances.size():
		var instance = instances[i]
		changes.append({
			"node": instance,
			"skeleton": NodePath("%s/%s" % [instance.get_path_to(parent), skeleton.name]),
			"transform": transform_at(instance, space),
			"skin": new_skin(bones.size(), joints, placements[i]),
			"mesh": meshes[i],
		})
	return { "error": "", "changes": changes, "skeleton": skeleton }


static func not_taken(instance: MeshInstance) -> String:
	return "sinew: error: %s: Godot does not take its surfaces with weights" % instance.name


# The transform of a node that stands at `global` in the world.
static func transform_at(node: Spatial, global: Transform) -> Transform:
	var parent = node.get_parent()
	return global if not parent is Spatial else parent.global_transform.affine_inverse() * global


# The skeleton of a mesh: that of its property, else the next one above it.
static func skeleton_of(instance: MeshInstance) -> Skeleton:
	if not instance.skeleton.is_empty() and instance.get_node_or_null(instance.skeleton) is Skeleton:
		return instance.get_node(instance.skeleton) as Skeleton
	var node = instance.get_parent()
	while node != null and not node is Skeleton:
		node = node.get_parent()
	return node as Skeleton


static func bone_of_bind(skin: Skin, bind: int, skeleton: Skeleton) -> int:
	var name = skin.get_bind_name(bind)
	return skeleton.find_bone(name) if name != "" else skin.get_bind_bone(bind)


# Per bone the index of its bind, -1 without one. ARRAY_BONES holds binds, not bones.
static func binds_of_bones(skin: Skin, skeleton: Skeleton) -> Array:
	var binds = []
	for _bone in skeleton.get_bone_count():
		binds.append(-1)
	for bind in skin.get_bind_count():
		var bone = bone_of_bind(skin, bind, skeleton)
		if bone >= 0 and binds[bone] < 0:
			binds[bone] = bind
	return binds


static func rest_global(skeleton: Skeleton, bone: int) -> Transform:
	var transform = skeleton.get_bone_rest(bone)
	while skeleton.get_bone_parent(bone) >= 0:
		bone = skeleton.get_bone_parent(bone)
		transform = skeleton.get_bone_rest(bone) * transform
	return transform


# Per bone where it stands while the meshes are unmoved: as the first skin says, other bones by their rest below those that it has.
static func joints_at_bind(instances: Array, skeleton: Skeleton) -> Array:
	var binds = []
	var skin = null
	for instance in instances:
		if skin == null and instance.skin != null and instance.skin.get_bind_count() > 0:
			skin = instance.skin
			binds = binds_of_bones(skin, skeleton)
	var joints = []
	for bone in skeleton.get_bone_count():
		var above = bone
		while skin != null and above >= 0 and binds[above] < 0:
			above = skeleton.get_bone_parent(above)
		if skin == null or above < 0:
			joints.append(rest_global(skeleton, bone))
		else:
			joints.append(skin.get_bind_pose(binds[above]).affine_inverse() * rest_global(skeleton, above).affine_inverse() * rest_global(skeleton, bone))
	return joints


# From an instance's vertices to the space of the joints: through its skin, else as it stands beside the skeleton.
static func placement(instance: MeshInstance, skeleton: Skeleton, joints: Array) -> Transform:
	if instance.skin != null:
		for bind in instance.skin.get_bind_count():
			var bone = bone_of_bind(instance.skin, bind, skeleton)
			if bone >= 0:
				return joints[bone] * instance.skin.get_bind_pose(bind)
	var beside = skeleton.global_transform.affine_inverse() * instance.global_transform
	return joints[0] * rest_global(skeleton, 0).affine_inverse() * beside


static func new_skin(bone_count: int, joints: Array, placed: Transform) -> Skin:
	var skin = Skin.new()
	for bone in bone_count:
		skin.add_bind(bone, joints[bone].affine_inverse() * placed)
	return skin


static func with_all_bones(old: Skin, skeleton: Skeleton, joints: Array, placed: Transform) -> Skin:
	var binds = binds_of_bones(old, skeleton)
	if not -1 in binds:
		return old
	var skin = old.duplicate()
	for bone in binds.size():
		if binds[bone] < 0:
			skin.add_bind(bone, joints[bone].affine_inverse() * placed)
	return skin


static func vertex_count(mesh: Mesh) -> int:
	var count = 0
	for surface in mesh.get_surface_count():
		count += mesh.surface_get_array_len(surface) if mesh is ArrayMesh else mesh.surface_get_arrays(surface)[Mesh.ARRAY_VERTEX].size()
	return count


static func number(value: float) -> String:
	return "%.9f" % value


# Names of mesh instances as OBJ can have them, each once.
static func object_names(instances: Array) -> Array:
	var names = []
	for instance in instances:
		var name = instance.name.replace(" ", "_")
		names.append(name if not name in names else "%s_%d" % [name, names.size()])
	return names


# Vertices of all surfaces in their order. Godot's faces are clockwise, OBJ's are not.
static func write_obj(path: String, instances: Array, placements: Array) -> String:
	var lines = PoolStringArray()
	var names = object_names(instances)
	var first = 1
	for i in instances.size():
		var mesh = instances[i].mesh
		lines.append("o %s" % names[i])
		for surface in mesh.get_surface_count():
			var arrays = mesh.surface_get_arrays(surface)
			var vertices = arrays[Mesh.ARRAY_VERTEX]
			for vertex in vertices:
				var p = placements[i].xform(vertex)
				lines.append("v %s %s %s" % [number(p.x), number(p.y), number(p.z)])
			if mesh is ArrayMesh and mesh.surface_get_primitive_type(surface) != Mesh.PRIMITIVE_TRIANGLES:
				return "sinew: error: %s: surface %d: expected triangles" % [instances[i].name, surface]
			var index = arrays[Mesh.ARRAY_INDEX]
			if index == null or index.size() == 0:
				index = range(vertices.size())
			for corner in range(0, index.size() - 2, 3):
				lines.append("f %d %d %d" % [first + index[corner], first + index[corner + 2], first + index[corner + 1]])
			first += vertices.size()
	return write(path, lines)


# Names of the bones as rig.txt can have them, each once.
static func joint_names(skeleton: Skeleton) -> Array:
	var names = []
	for bone in skeleton.get_bone_count():
		var name = PoolStringArray(skeleton.get_bone_name(bone).split(" ")).join("_").replace("\t", "_")
		if name == "":
			name = "joint"
		while name in names:
			name += "_%d" % bone
		names.append(name)
	return names


# The skeleton, and the weights that the meshes have: then only bones that have some are given weight again.
static func write_rig(path: String, skeleton: Skeleton, joints: Array, instances: Array) -> String:
	if skeleton.get_bone_count() == 0:
		return "sinew: error: %s has no bones" % skeleton.name
	var names = joint_names(skeleton)
	var lines = PoolStringArray()
	var root = ""
	for bone in names.size():
		var p = joints[bone].origin
		lines.append("joints %s %s %s %s" % [names[bone], number(p.x), number(p.y), number(p.z)])
	for bone in names.size():
		var parent = skeleton.get_bone_parent(bone)
		if parent >= 0:
			lines.append("hier %s %s" % [names[parent], names[bone]])
		elif root == "":
			root = names[bone]
			lines.append("root %s" % root)
	var vertex = 0
	for instance in instances:
		for surface in instance.mesh.get_surface_count():
			var arrays = instance.mesh.surface_get_arrays(surface)
			var count = arrays[Mesh.ARRAY_VERTEX].size()
			if arrays[Mesh.ARRAY_BONES] != null and arrays[Mesh.ARRAY_WEIGHTS] != null:
				for v in count:
					var words = skin_words(instance, skeleton, arrays, v, names)
					if words != "":
						lines.append("skin %d%s" % [vertex + v, words])
			vertex += count
	return write(path, lines)


static func skin_words(instance: MeshInstance, skeleton: Skeleton, arrays: Array, vertex: int, names: Array) -> String:
	var sums = {}
	for k in INFLUENCES:
		var bone = int(arrays[Mesh.ARRAY_BONES][vertex * INFLUENCES + k])
		var weight = arrays[Mesh.ARRAY_WEIGHTS][vertex * INFLUENCES + k]
		if weight <= 0:
			continue
		if instance.skin != null and bone < instance.skin.get_bind_count():
			bone = bone_of_bind(instance.skin, bone, skeleton)
		if bone >= 0 and bone < names.size():
			sums[bone] = sums.get(bone, 0.0) + weight
	var words = ""
	for bone in sums:
		words += " %s %s" % [names[bone], number(sums[bone])]
	return words


static func write(path: String, lines: PoolStringArray) -> String:
	var file = File.new()
	if file.open(path, File.WRITE) != OK:
		return "sinew: error: %s: cannot write" % path
	file.store_string(lines.join("\n") + "\n")
	var failed = file.get_error() != OK
	file.close()
	return "sinew: error: %s: cannot write" % path if failed else ""


# { error, names, positions, parents, skin }; skin has by vertex [joint, weight, joint, weight, ...], weights in 1/65535.
static func read_rig(path: String) -> Dictionary:
	var rig = { "error": "", "names": [], "positions": [], "parents": [], "skin": {} }
	var file = File.new()
	if file.open(path, File.READ) != OK:
		rig.error = "sinew: error: %s: cannot read the command's answer" % path
		return rig
	var index = {}
	var lines = file.get_as_text().split("\n")
	file.close()
	for line in lines:
		var words = line.split(" ", false)
		if words.size() == 5 and words[0] == "joints":
			index[words[1]] = rig.names.size()
			rig.names.append(words[1])
			rig.positions.append(Vector3(float(words[2]), float(words[3]), float(words[4])))
			rig.parents.append(-1)
	for line in lines:
		var words = line.split(" ", false)
		if words.size() == 3 and words[0] == "hier":
			rig.parents[index[words[2]]] = index[words[1]]
		elif words.size() > 3 and words[0] == "skin":
			var row = []
			for k in range(2, words.size() - 1, 2):
				row += [index[words[k]], int(round(float(words[k + 1]) * 65535))]
			rig.skin[int(words[1])] = row
	return rig


# The mesh with other bones and weights; `first` is its first vertex in `skin`, `binds` has each joint's bind. All else stays.
# Null where Godot does not take a surface back.
static func with_weights(mesh: Mesh, first: int, skin: Dictionary, binds: Array) -> ArrayMesh:
	var made = ArrayMesh.new()
	made.resource_name = mesh.resource_name
	if mesh is ArrayMesh:
		made.blend_shape_mode = mesh.blend_shape_mode
		for shape in mesh.get_blend_shape_count():
			made.add_blend_shape(mesh.get_blend_shape_name(shape))
		made.custom_aabb = mesh.custom_aabb
	for surface in mesh.get_surface_count():
		var arrays = mesh.surface_get_arrays(surface)
		var count = arrays[Mesh.ARRAY_VERTEX].size()
		var bones = PoolIntArray()
		var weights = PoolRealArray()
		bones.resize(count * INFLUENCES)
		weights.resize(count * INFLUENCES)
		for v in count:
			var row = skin.get(first + v, [])
			for k in INFLUENCES:
				var known = 2 * k < row.size()
				bones[v * INFLUENCES + k] = binds[row[2 * k]] if known else 0
				# Godot keeps 16 bits and cuts the rest off: a half above comes out whole.
				weights[v * INFLUENCES + k] = min(1.0, (row[2 * k + 1] + 0.5) / 65535.0) if known else 0.0
		first += count
		var shapes = mesh.surface_get_blend_shape_arrays(surface) if mesh is ArrayMesh else []
		for shape in shapes:
			shape[Mesh.ARRAY_BONES] = bones
			shape[Mesh.ARRAY_WEIGHTS] = weights
			shape[Mesh.ARRAY_INDEX] = null
		arrays[Mesh.ARRAY_BONES] = bones
		arrays[Mesh.ARRAY_WEIGHTS] = weights
		made.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays, shapes)  # as write_obj() wants them
		if made.get_surface_count() != surface + 1:
			return null
		made.surface_set_material(surface, mesh.surface_get_material(surface))
		if mesh is ArrayMesh:
			made.surface_set_name(surface, mesh.surface_get_name(surface))
	return made


# Makes an answer of bind() or rig() one step of `undo_redo`; a new skeleton goes below `parent` and belongs to scene `root`.
static func commit(undo_redo: UndoRedo, name: String, answer: Dictionary, parent: Node, root: Node) -> void:
	undo_redo.create_action(name)
	if answer.has("skeleton"):
		undo_redo.add_do_method(parent, "add_child", answer.skeleton)
		undo_redo.add_do_method(answer.skeleton, "set_owner", root)
		undo_redo.add_do_reference(answer.skeleton)
	for change in answer.changes:
		for property in ["mesh", "skin", "skeleton", "transform"]:
			undo_redo.add_do_property(change.node, property, change[property])
			undo_redo.add_undo_property(change.node, property, change.node.get(property))
	if answer.has("skeleton"):
		undo_redo.add_undo_method(parent, "remove_child", answer.skeleton)
	undo_redo.commit_action()
