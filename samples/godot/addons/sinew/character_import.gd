# SPDX-License-Identifier: MIT
# Import As > Sinew Character: the command gives a file a skeleton, weights and motion; Godot imports the GLB that comes out.
tool
extends EditorImportPlugin

const Command = preload("command.gd")
const FileKinds = preload("file_kinds.gd")
const SceneImporter = preload("character_scene_importer.gd")

enum { RIG, BIND, KEEP }
const RIGID_PARTS = ["auto", "always", "never"]
const DETAILS = ["body", "hands", "full"]


func get_importer_name() -> String:
	return "sinew.character"


func get_visible_name() -> String:
	return "Sinew Character"


func get_recognized_extensions() -> Array:
	return FileKinds.MESHES


func get_save_extension() -> String:
	return "scn"


func get_resource_type() -> String:
	return "PackedScene"


# Below 1, so that Godot's own importers stay the first choice.
func get_priority() -> float:
	return 0.5


func get_import_order() -> int:
	return 100


func get_preset_count() -> int:
	return 3


func get_preset_name(preset: int) -> String:
	return ["Rig: a skeleton for a bare mesh", "Bind: weights for a skeleton", "Keep: motion for a finished character"][preset]


func get_import_options(preset: int) -> Array:
	return [
		{ "name": "weights", "default_value": preset, "property_hint": PROPERTY_HINT_ENUM, "hint_string": "Rig,Bind,Keep" },
		{ "name": "skeleton", "default_value": "", "property_hint": PROPERTY_HINT_FILE, "hint_string": FileKinds.SKELETONS },
		{ "name": "detail", "default_value": 0, "property_hint": PROPERTY_HINT_ENUM, "hint_string": "Body,Hands,Full" },
		{ "name": "rigid_parts", "default_value": 0, "property_hint": PROPERTY_HINT_ENUM, "hint_string": "Auto,Always,Never" },
		{ "name": "softness", "default_value": 1.0, "property_hint": PROPERTY_HINT_RANGE, "hint_string": "0.25,4,0.05" },
		{ "name": "symmetric", "default_value": false },
		{ "name": "motion/file", "default_value": "", "property_hint": PROPERTY_HINT_FILE, "hint_string": FileKinds.MOTIONS },
		{ "name": "motion/map", "default_value": "", "property_hint": PROPERTY_HINT_FILE, "hint_string": "*.txt" },
		{ "name": "motion/in_place", "default_value": false },
		{ "name": "motion/force", "default_value": false },
	]


func get_option_visibility(option: String, options: Dictionary) -> bool:
	match option:
		"skeleton", "rigid_parts", "softness":
			return options.weights != KEEP
		"detail":
			return options.weights == RIG
		"symmetric":
			return options.weights != KEEP
		"motion/map", "motion/in_place", "motion/force":
			return options["motion/file"] != ""
	return true


# The command's runs that make `output` from `source`, the first with the weights, the last with the motion.
static func runs(source: String, output: String, options: Dictionary) -> Array:
	var made = []
	var character = source
	if options.weights != KEEP:
		var run = ["bind" if options.weights == BIND else "rig", source, "-o", output,
			"--rigid-parts", RIGID_PARTS[options.rigid_parts], "--softness", options.softness]
		if options.weights == RIG:
			run += ["--detail", DETAILS[options.detail]]
		if options.symmetric:
			run.append("--symmetric" if options.weights == BIND else "--mirror")
		if options.skeleton != "":
			run += ["--skeleton", ProjectSettings.globalize_path(options.skeleton)]
		made.append(run)
		character = output
	if options["motion/file"] != "":
		var run = ["animate", character, "--motion", ProjectSettings.globalize_path(options["motion/file"]), "-o", output]
		if options["motion/map"] != "":
			run += ["--map", ProjectSettings.globalize_path(options["motion/map"])]
		if options["motion/in_place"]:
			run.append("--in-place")
		if options["motion/force"]:
			run.append("--force")
		made.append(run)
	return made


func import(source_file: String, save_path: String, options: Dictionary, platform_variants: Array, gen_files: Array) -> int:
	var output = Command.temporary("import.glb")
	var todo = runs(ProjectSettings.globalize_path(source_file), output, options)
	if todo.empty():
		return refuse(source_file, "sinew: error: nothing to do: weights are kept and there is no motion file; choose one, or use Godot's own importer")
	for run in todo:
		var error = Command.run(run)
		if error != "":
			Command.remove([output])
			return refuse(source_file, error)
	var scene = SceneImporter.new().read(output)
	Command.remove([output])
	if scene == null:
		return refuse(source_file, "sinew: error: Godot could not read the GLB that the command wrote")
	scene.name = source_file.get_file().get_basename()
	var packed = PackedScene.new()
	var status = packed.pack(scene)
	scene.free()
	if status == OK:
		status = ResourceSaver.save("%s.%s" % [save_path, get_save_extension()], packed)
	return status


func refuse(source_file: String, error: String) -> int:
	push_error("%s: %s" % [source_file, error])
	return ERR_CANT_CREATE
