# SPDX-License-Identifier: MIT
# Export: the selected character as a file for other programs, and what sinew check finds in it.
tool
extends "step.gd"

const Character = preload("character.gd")
const Command = preload("command.gd")
const FileKinds = preload("file_kinds.gd")
const ANY = "any program"

var program: OptionButton
var author: LineEdit
var author_row: HBoxContainer
var file: LineEdit
var said: Label
var findings: VBoxContainer


func _init() -> void:
	name = "Export"


# `target` has a method export_character().
func build(target: Object) -> void:
	button("Export", "The selected character as a file, with the weights that it has", target, "export_character")
	program = OptionButton.new()
	row("For", program, "Names, axes and rest pose as a program wants them")
	program.connect("item_selected", self, "show_author")
	author = LineEdit.new()
	author.size_flags_horizontal = SIZE_EXPAND_FILL
	author_row = row("Author", author, "A VRM names who made it")
	author_row.hide()
	file = file_row("File", FileKinds.EXPORTS, FileDialog.MODE_SAVE_FILE, "What to write; beside the character where it is empty")
	said = Label.new()
	said.text = "Check the rig"
	add_child(said)
	findings = VBoxContainer.new()
	add_child(findings)
	connect("visibility_changed", self, "fill_programs")


func fill_programs() -> void:
	if program.get_item_count() == 0 and is_inside_tree() and is_visible_in_tree():
		ask_for_programs()


# Asks the command which programs it writes for.
func ask_for_programs() -> void:
	var names = Command.profiles()
	for name in ([ANY] + names if not names.empty() else []):
		program.add_item(name)


func chosen() -> String:
	return ANY if program.get_item_count() == 0 else program.get_item_text(program.selected)


func show_author(_item: int) -> void:
	author_row.visible = chosen().begins_with("vrm")


# Writes the character with the weights that it has. Returns { error, lines, path } as motion_step.gd does.
func write(character: Dictionary) -> Dictionary:
	var path = file.text if file.text != "" else Character.free_file(character.beside, "export")
	var words = ["bind", character.path, "--lock", "all", "--influences", 12, "-o", ProjectSettings.globalize_path(path)]
	if character.skeleton != "":
		words += ["--skeleton", character.skeleton]
	if chosen() != ANY:
		words += ["--for", chosen()]
	if author_row.visible and author.text != "":
		words += ["--author", author.text]
	var answer = Command.answer(words)
	for line in answer.lines.duplicate():  # of the rig alone; check() lists what it finds in the motion too
		if line.strip_edges().begins_with("checked: "):
			answer.lines.erase(line)
	answer.path = path
	return answer


# Lists what sinew check finds in a file. Returns "" or one line for the user.
func check(path: String) -> String:
	clear_findings()
	var answer = Command.answer(["check", ProjectSettings.globalize_path(path), "--json"])
	if answer.error != "":
		return answer.error
	var parsed = JSON.parse(answer.lines.back()) if not answer.lines.empty() else null
	if parsed == null or parsed.error != OK or not parsed.result is Dictionary or not parsed.result.has("findings"):
		return "sinew: error: 'sinew check --json' answered something else: %s" % PoolStringArray(answer.lines).join(" ")
	show_findings(parsed.result.findings)
	return ""


func clear_findings() -> void:
	said.text = "Check the rig"
	for child in findings.get_children():
		findings.remove_child(child)
		child.free()


# [{ severity, what, cure }], as sinew check has them.
func show_findings(found: Array) -> void:
	clear_findings()
	said.text = "Check the rig: %s" % ("nothing found" if found.empty() else "%d found" % found.size())
	for one in found:
		var label = Label.new()
		label.autowrap = true
		label.mouse_filter = MOUSE_FILTER_STOP  # for the hint
		label.text = "%s: %s" % [one.severity, one.what]
		label.hint_tooltip = one.cure
		if has_color("%s_color" % one.severity, "Editor"):
			label.add_color_override("font_color", get_color("%s_color" % one.severity, "Editor"))
		findings.add_child(label)
