# SPDX-License-Identifier: MIT
# The plug-in of the editor: a project setting, an importer and a dock.
tool
extends EditorPlugin

const Command = preload("command.gd")

var importer
var dock


func _enter_tree() -> void:
	if not ProjectSettings.has_setting(Command.SETTING):
		ProjectSettings.set_setting(Command.SETTING, "")
	ProjectSettings.set_initial_value(Command.SETTING, "")
	ProjectSettings.add_property_info({ "name": Command.SETTING, "type": TYPE_STRING, "hint": PROPERTY_HINT_GLOBAL_FILE })
	importer = preload("character_import.gd").new()
	add_import_plugin(importer)
	dock = preload("dock.gd").new()
	dock.plugin = self
	add_control_to_dock(DOCK_SLOT_RIGHT_UL, dock)


func _exit_tree() -> void:
	remove_import_plugin(importer)
	importer = null
	remove_control_from_docks(dock)
	dock.queue_free()
