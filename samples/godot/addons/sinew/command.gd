# SPDX-License-Identifier: MIT
# Runs the command `sinew`. Everything that this plug-in knows about skeletons and weights comes from there.
tool
extends Reference

const SETTING = "sinew/command"


# Where the command is: the project setting sinew/command, else the environment's SINEW, else `sinew` on the PATH.
static func path() -> String:
	if ProjectSettings.has_setting(SETTING) and ProjectSettings.get_setting(SETTING) != "":
		return ProjectSettings.globalize_path(ProjectSettings.get_setting(SETTING))
	if OS.get_environment("SINEW") != "":
		return OS.get_environment("SINEW")
	return "sinew"


# OS.execute() hands a line to the shell and puts each word between double quotes, without a look at what is in it.
static func shell_word(word: String) -> String:
	if OS.get_name() in ["Windows", "UWP"]:
		return word
	for letter in ["\\", "\"", "$", "`"]:
		word = word.replace(letter, "\\" + letter)
	return word


# Runs `sinew ARGUMENTS` and waits. Returns "" when it is done, else one line for the user.
static func run(arguments: Array) -> String:
	return answer(arguments).error


# The same, with what the command says: { error, lines }; error is "" or one line.
static func answer(arguments: Array) -> Dictionary:
	var words = []
	for argument in arguments:
		words.append(shell_word(str(argument)))
	var printed = []
	var status = OS.execute(shell_word(path()), words, true, printed, true)
	var lines = []
	for line in PoolStringArray(printed).join("\n").split("\n", false):
		lines.append(line.strip_edges())
	if status == 0:
		return { "error": "", "lines": lines }
	for line in lines:
		if line.begins_with("sinew: error: "):
			return { "error": line, "lines": lines }
	var version = []
	if OS.execute(shell_word(path()), ["--version"], true, version, true) != 0 or not PoolStringArray(version).join("").begins_with("sinew "):
		return { "error": "sinew: error: no command at '%s'; set Project Settings > Sinew > Command, or SINEW in the environment, to the program sinew" % path(), "lines": [] }
	return { "error": "sinew: error: 'sinew %s' stopped: %s" % [PoolStringArray(arguments).join(" "), PoolStringArray(lines).join(" ")], "lines": lines }


# Names of the clips that ship, each once; empty without a command. `builtin:` alone is refused with the list of them:
# "... with person: walk, run; quadruped: walk, trot; found no name".
static func clips() -> Array:
	var names = []
	var said = run(["map", "builtin:", "--from", "builtin:"])
	for kind in said.right(said.find(" with ") + 6).split("; "):
		var of_kind = kind.split(": ")
		for clip in (of_kind[1].split(", ") if of_kind.size() == 2 and said.find(" with ") >= 0 else []):
			if not clip in names:
				names.append(clip)
	return names


# Names of the programs that `--for` writes for; empty without a command. The help has them as a|b|c.
static func profiles() -> Array:
	for line in answer(["bind", "--help-all"]).lines:
		if line.begins_with("--for "):
			return Array(line.split(" ", false)[1].split("|"))
	return []


# A path for a file of the command's that nobody else uses. The caller removes the file.
static func temporary(name: String) -> String:
	return OS.get_user_data_dir().plus_file("sinew-%d-%d-%s" % [OS.get_process_id(), OS.get_ticks_usec(), name])


# Files, and folders when they are empty.
static func remove(paths: Array) -> void:
	var directory = Directory.new()
	for path in paths:
		if directory.file_exists(path) or directory.dir_exists(path):
			directory.remove(path)
