# SPDX-License-Identifier: MIT
# A step of the dock: a sentence, one main button, options in rows.
tool
extends VBoxContainer

var sentence: Label


func _init() -> void:
	sentence = Label.new()
	sentence.autowrap = true
	add_child(sentence)


func button(text: String, hint: String, target: Object, method: String, words: Array = []) -> Button:
	var made = Button.new()
	made.text = text
	made.hint_tooltip = hint
	made.connect("pressed", target, method, words)
	add_child(made)
	return made


func row(text: String, control: Control, hint: String) -> HBoxContainer:
	var line = HBoxContainer.new()
	var label = Label.new()
	label.text = text
	label.size_flags_horizontal = SIZE_EXPAND_FILL
	control.hint_tooltip = hint
	line.add_child(label)
	line.add_child(control)
	add_child(line)
	return line


# A row with the name of a file, and a dialog to choose it.
func file_row(text: String, filters: String, mode: int, hint: String) -> LineEdit:
	var edit = LineEdit.new()
	edit.size_flags_horizontal = SIZE_EXPAND_FILL
	edit.size_flags_stretch_ratio = 3
	var line = row(text, edit, hint)
	var choose = Button.new()
	choose.text = "…"
	choose.hint_tooltip = hint
	choose.connect("pressed", self, "ask_for_files", [text, filters, mode, edit, "set_text"])
	line.add_child(choose)
	return edit


# Calls `method` of `target` with the path, or the paths, that the user chooses.
func ask_for_files(title: String, filters: String, mode: int, target: Object, method: String) -> void:
	var dialog = FileDialog.new()
	dialog.mode = mode
	dialog.access = FileDialog.ACCESS_FILESYSTEM
	dialog.window_title = title
	dialog.filters = PoolStringArray(["%s ; %s" % [filters.replace(",", ", "), title]])
	dialog.current_dir = ProjectSettings.globalize_path("res://")
	dialog.connect("files_selected" if mode == FileDialog.MODE_OPEN_FILES else "file_selected", target, method)
	dialog.connect("popup_hide", dialog, "queue_free")
	add_child(dialog)
	dialog.popup_centered_ratio(0.6)
