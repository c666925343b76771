#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Commands and options that the Markdown pages name exist, as the programs' own --help-all has them.

  commands.py SOURCE_DIR BUILD_DIR     prints each command or option that does not exist; exits with 1 when there is one
"""
import pathlib
import re
import shlex
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "package"))
import describe
import pages

PROGRAMS = ("sinew", "sinew-lab")
CALL = re.compile(r"(?:^|(?<=[\s(|;&]))(?:\S*/)?(sinew(?:-lab)?) (?=\S)")
OPTION = re.compile(r"--[a-z][a-z0-9-]*")
# A command of the first without one of these subcommands is the second.
USUAL_SUBCOMMAND = {("eval",): "weights"}
OTHER_PROGRAMS = {"--allow-run-as-root", "--bind-to"}  # mpirun's
SCRIPTS = ["scripts", "tests", "samples", "package", "engine/cmake"]


def options_of(command):
    return {name for names, _, _ in command.options() for name in names} | {"--help", "--help-all", "--version"}


def programs(build):
    """program -> path of the command -> (its options, its subcommands)."""
    return {program: {tuple(command.path): (options_of(command), command.subcommands) for command in describe.commands_of(str(build / program))} for program in PROGRAMS}


def words_of(text):
    """Words of the call that text begins with, up to what ends it in a shell."""
    text = re.split(r"\s#|\s[|&;>]|\s2>|[;|&`]\s", text)[0]
    try:
        return shlex.split(text)
    except ValueError:  # a quote of prose
        return text.split()


def is_placeholder(word):
    return not re.fullmatch(r"[a-z][a-z-]*", word)


def check_call(text, known):
    """What is wrong with a call: "" or a line."""
    found = CALL.search(text)
    program, words = found.group(1), words_of(text[found.end():])
    path, commands = (), known[program]
    while commands[path][1] and words and (not is_placeholder(words[0]) or path in USUAL_SUBCOMMAND):
        usual = USUAL_SUBCOMMAND.get(path)
        name = words[0].rstrip(",.:")
        if name in commands[path][1]:
            path, words = (*path, name), words[1:]
        elif usual:
            path = (*path, usual)
        else:
            return f"{' '.join((program, *path, name))}: no such command"
    if words and is_placeholder(words[0]) and not path and not words[0].startswith("-"):
        return ""  # sinew COMMAND --help
    for word in words:
        option = OPTION.match(word.lstrip("["))
        if option and option.group(0) not in commands[path][0]:
            return f"{' '.join((program, *path))} has no option {option.group(0)}"
    return ""


def calls_of(page):
    """(line number, text) of every call of a program, in blocks of code and between backquotes."""
    for block in page.blocks:
        if block.language not in ("", "sh", "console", "yaml", "text"):
            continue
        number, text = block.line, ""
        for offset, line in enumerate(block.lines):
            text += line
            if line.endswith("\\"):
                text = text[:-1] + " "
                continue
            for found in CALL.finditer(text.split(" #")[0]):
                yield number, text[found.start():]
            number, text = block.line + offset + 1, ""
    for number, code in page.spans():
        for found in CALL.finditer(code):
            yield number, code[found.start():]


def script_options(root):
    found = set(OTHER_PROGRAMS)
    for folder in SCRIPTS:
        for path in (root / folder).rglob("*"):
            if path.suffix in (".sh", ".py", ".cpp", ".mjs", ".cmake", ".txt") and "samples/cli" not in path.as_posix() and "integration" not in path.as_posix() and path.is_file():
                found |= set(OPTION.findall(path.read_text(encoding="utf-8", errors="ignore")))
    return found


def check_commands(root, all_pages, known):
    faults, calls, spans = [], 0, 0
    options = script_options(root).union(*(names for program in known.values() for names, _ in program.values()))
    for page in all_pages:
        if page.name == "CHANGELOG.md":
            continue
        for number, text in calls_of(page):
            calls += 1
            fault = check_call(text, known)
            if fault:
                faults.append(f"{page.name}:{number}: {fault}")
        for number, code in page.spans():
            if code.startswith("--"):
                spans += 1
                faults += [f"{page.name}:{number}: no program has an option {name}" for name in OPTION.findall(code) if name not in options]
    return faults, f"{calls} calls of the commands, {spans} options alone"


def main():
    root, build = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    faults, counted = check_commands(root, pages.pages_of(root), programs(build))
    print(f"commands: {counted}, {len(faults)} faults")
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
