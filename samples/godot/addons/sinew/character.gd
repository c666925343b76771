# SPDX-License-Identifier: MIT
# The selected character as a file that the command reads: the file that it was imported from while the scene has it unchanged,
# else meshes, skeleton and weights as the scene has them, without materials.
tool
extends Reference

const Command = preload("command.gd")
const FileKinds = preload("file_kinds.gd")
const Importer = preload("character_import.gd")
const Skinning = preload("skinning.gd")


# Returns { error, path, skeleton, name, beside, place, nodes, files }: error is "" or one line.
#   path, skeleton  what the command reads; skeleton is "" where `path` has it
#   name            how the user knows it
#   beside          res://FOLDER/NAME, for what is written beside it
#   place           where its origin stands in the world
#   nodes           nodes of the scene that show it
#   files           for Command.remove() by the caller
static func of(instances: Array, root: Node) -> Dictionary:
	if instances.empty():
		return { "error": "sinew: error: no mesh is selected; select the meshes of a character", "files": [] }
	var file = file_of(instances)
	return of_file(file, instances, root) if file != "" else of_scene(instances, root)


# The imported file that shows these meshes with these weights, "" where the scene has others.
static func file_of(instances: Array) -> String:
	var top = top_of(instances[0])
	if top == null:
		var file = instances[0].mesh.resource_path  # an OBJ is imported as a mesh alone
		return file if instances.size() == 1 and instances[0].skin == null and is_mesh_file(file) else ""
	# From the disk: what was imported while the editor runs does not say which file it is of.
	var scene = ResourceLoader.load(top.filename, "PackedScene", true)
	var imported = scene.instance() if scene != null else null
	var same = imported != null
	for instance in instances:
		var own = imported.get_node_or_null(top.get_path_to(instance)) if same and top.is_a_parent_of(instance) else null
		same = same and own is MeshInstance and own.mesh != null and is_same(own.mesh, instance.mesh) and (own.skin == null) == (instance.skin == null)
	if imported != null:
		imported.free()
	return top.filename if same else ""


static func is_mesh_file(file: String) -> bool:
	return file.get_extension().to_lower() in FileKinds.MESHES


# The node above a mesh, or itself, that is the root of an imported file; null without one.
static func top_of(instance: Node) -> Node:
	var node = instance
	while node != null and not is_mesh_file(node.filename):
		node = node.get_parent()
	return node


# Whether two meshes have the same vertices and weights.
static func is_same(a: Mesh, b: Mesh) -> bool:
	if a == b:
		return true
	if a.get_surface_count() != b.get_surface_count():
		return false
	for surface in a.get_surface_count():
		var one = a.surface_get_arrays(surface)
		var other = b.surface_get_arrays(surface)
		for array in [Mesh.ARRAY_VERTEX, Mesh.ARRAY_BONES, Mesh.ARRAY_WEIGHTS]:
			if one[array] != other[array]:
				return false
	return true


static func of_file(file: String, instances: Array, root: Node) -> Dictionary:
	var top = top_of(instances[0])
	if top == null:
		top = instances[0]
	var made = {
		"error": "", "path": ProjectSettings.globalize_path(file), "skeleton": "", "name": file, "beside": file.get_basename(),
		"place": top.global_transform if top is Spatial else Transform(), "nodes": instances if top == root else [top], "files": [],
	}
	var config = ConfigFile.new()
	if config.load(file + ".import") != OK or config.get_value("remap", "importer", "") != "sinew.character":
		return made
	# It got skeleton, weights or motion when it was imported, and gets them again.
	var options = {}
	for key in config.get_section_keys("params"):
		options[key] = config.get_value("params", key)
	var output = Command.temporary("character.glb")
	for run in Importer.runs(made.path, output, options):
		made.error = Command.run(run)
		made.path = output
		made.files = [output]
		if made.error != "":
			break
	return made


static func of_scene(instances: Array, root: Node) -> Dictionary:
	var skeleton = Skinning.skeleton_of(instances[0])
	var made = { "error": "", "skeleton": "", "nodes": instances, "files": [], "name": instances[0].name }
	for instance in instances:
		if Skinning.skeleton_of(instance) != skeleton:
			made.error = "sinew: error: %s and %s have different skeletons; take one character after the other" % [instances[0].name, instance.name]
			return made
	var scene = root.filename if root != null else ""
	var stem = made.name.replace(" ", "_")
	made.beside = (scene.get_base_dir() if scene != "" else "res://").plus_file(stem)
	made.place = instances[0].global_transform if skeleton == null else skeleton.global_transform
	var folder = Command.temporary("character")
	if Directory.new().make_dir(folder) != OK:
		made.error = "sinew: error: %s: cannot write" % folder
		return made
	made.path = folder.plus_file(stem + ".obj")
	made.files = [made.path, folder]
	var joints = [] if skeleton == null else Skinning.joints_at_bind(instances, skeleton)
	var placements = []
	for instance in instances:
		placements.append(made.place.affine_inverse() * instance.global_transform if skeleton == null else Skinning.placement(instance, skeleton, joints))
	made.error = Skinning.write_obj(made.path, instances, placements)
	if made.error == "" and skeleton != null:
		made.skeleton = made.path.get_basename() + ".rig.txt"  # beside the mesh, where the command finds it
		made.files.push_front(made.skeleton)
		made.error = Skinning.write_rig(made.skeleton, skeleton, joints, instances)
	return made


# A file that is not there yet: BESIDE.WORD.glb, else BESIDE.WORD_2.glb ...
static func free_file(beside: String, word: String) -> String:
	var directory = Directory.new()
	var path = "%s.%s.glb" % [beside, word]
	var number = 1
	while directory.file_exists(path):
		number += 1
		path = "%s.%s_%d.glb" % [beside, word, number]
	return path


# What the command says, with the names that the dock has for files and options.
static func plain(text: String, character: Dictionary) -> String:
	for known in [[character.get("path", ""), character.get("name", "")], [ProjectSettings.globalize_path("res://"), "res://"], ["--map FILE", "Map"],
			["--force", "Force"], ["give --author", "fill in Author"], ["give one with --skeleton FILE", "press New skeleton"]]:
		if known[0] != "":
			text = text.replace(known[0], known[1])
	return text
