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
	var words = []
	for argument in arguments:
		words.append(shell_word(str(argument)))
	var printed = []
	if OS.execute(shell_word(path()), words, true, printed, true) == 0:
		return ""
	var lines = PoolStringArray(printed).join("\n").split("\n", false)
	for line in lines:
		if line.strip_edges().begins_with("sinew: error: "):
			return line.strip_edges()
	var version = []
	if OS.execute(shell_word(path()), ["--version"], true, version, true) != 0 or not PoolStringArray(version).join("").begins_with("sinew "):
		return "sinew: error: no command at '%s'; set Project Settings > Sinew > Command, or SINEW in the environment, to the program sinew" % path()
	return "sinew: error: 'sinew %s' stopped: %s" % [PoolStringArray(arguments).join(" "), lines.join(" ")]


# A path for a file of the command's that nobody else uses. The caller removes the file.
static func temporary(name: String) -> String:
	return OS.get_user_data_dir().plus_file("sinew-%d-%d-%s" % [OS.get_process_id(), OS.get_ticks_usec(), name])


# Files, and folders when they are empty.
static func remove(paths: Array) -> void:
	var directory = Directory.new()
	for path in paths:
		if directory.file_exists(path) or directory.dir_exists(path):
			directory.remove(path)
