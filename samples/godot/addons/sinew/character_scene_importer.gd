# SPDX-License-Identifier: MIT
# Reads a GLB by Godot's own importer: EditorSceneImporter hands that out to scripts only through an instance.
tool
extends EditorSceneImporter


func read(path: String) -> Node:
	return import_scene_from_other_importer(path, IMPORT_SCENE | IMPORT_ANIMATION | IMPORT_GENERATE_TANGENT_ARRAYS, 15)


func _get_import_flags() -> int:
	return 0


func _get_extensions() -> Array:
	return []
