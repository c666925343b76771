# SPDX-License-Identifier: MIT
# Motion: a clip that ships, or a motion of a file, on the selected character.
tool
extends "step.gd"

const Character = preload("character.gd")
const Command = preload("command.gd")
const FileKinds = preload("file_kinds.gd")

var clip: OptionButton  # clips that ship by their names, then motions of files; metadata: what --motion gets
var map: LineEdit
var in_place: CheckBox
var force: CheckBox


func _init() -> void:
	name = "Motion"


# `target` has a method animate().
func build(target: Object) -> void:
	button("Animate", "The selected character with this motion, as a file beside it and in the scene", target, "animate")
	clip = OptionButton.new()
	row("Clip", clip, "A clip that ships, or a motion of a file")
	button("Motions of files…", "Motions, or the animations of a character's file", self, "ask_for_files",
		["Motions of files", FileKinds.MOTIONS, FileDialog.MODE_OPEN_FILES, self, "add_motions"])
	in_place = CheckBox.new()
	row("In place", in_place, "Stays above where it stands at rest")
	force = CheckBox.new()
	row("Force", force, "Play a motion that does not fit the character, such as a person's on a horse")
	map = file_row("Map", "*.txt", FileDialog.MODE_OPEN_FILE, "Which joint is which: lines TARGET_JOINT SOURCE_JOINT, - for none. By anatomy and names where it is empty")
	connect("visibility_changed", self, "fill_clips")


func fill_clips() -> void:
	if clip.get_item_count() == 0 and is_inside_tree() and is_visible_in_tree():
		ask_for_clips()


# Asks the command which clips ship.
func ask_for_clips() -> void:
	for name in Command.clips():
		add_motion(name, "builtin:" + name)


func add_motions(paths: Array) -> void:
	for path in paths:
		add_motion(path.get_file(), path)
		clip.select(clip.get_item_count() - 1)


func add_motion(text: String, motion: String) -> void:
	clip.add_item(text)
	clip.set_item_metadata(clip.get_item_count() - 1, motion)


# Writes the character with the chosen motion beside it. Returns { error, lines, path }: error is "" or one line, lines are what the
# command says, path is what was written.
func write(character: Dictionary) -> Dictionary:
	if clip.get_item_count() == 0:
		ask_for_clips()
	if clip.get_item_count() == 0:
		return { "error": Command.run(["map", "builtin:", "--from", "builtin:"]), "lines": [], "path": "" }
	var path = Character.free_file(character.beside, clip.get_item_text(clip.selected).get_basename())
	var motion = clip.get_item_metadata(clip.selected)
	if not motion.begins_with("builtin:"):
		motion = ProjectSettings.globalize_path(motion)
	var words = ["animate", character.path, "--motion", motion, "-o", ProjectSettings.globalize_path(path)]
	if map.text != "":
		words += ["--map", ProjectSettings.globalize_path(map.text)]
	if in_place.pressed:
		words.append("--in-place")
	if force.pressed:
		words.append("--force")
	var answer = Command.answer(words)
	answer.path = path
	return answer
