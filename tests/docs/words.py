#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Words of help, messages, public headers and pages are the field's, American and about the present; a help screen fits a screen.

  words.py SOURCE_DIR               prints each word that is on a list below, with what to write instead
  words.py SOURCE_DIR BUILD_DIR     prints each --help that is too long
Exits with 1 if there is one. To add a word: a row of the table whose texts it should be kept out of.
"""
import pathlib
import re
import subprocess
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "package"))
import describe
import pages

SCREEN = (40, 100)  # lines and columns of a --help
PROGRAMS = ("sinew", "sinew-lab")

# Pattern -> what to write. In comments of public headers and in texts that a user reads.
FIELD = {
    r"told": "a warning, or a verb with its subject",
    r"(?:is|are|was|not|what is) said": "given, known",
    r"says? (?:so|that|which|where|what|how)": "a verb: returns, has, lists, means",
    r"at one place|the places? (?:of|that|where)|places alone|its place": "position",
    r"(?:which|both|every|either|another) ways?|way round|on (?:the|its) way": "direction, path",
    r"turn(?:s|ed|ing)? (?:about|by|to|upright|against)|(?:half|quarter) (?:a )?turns?|is turned": "rotation, rotate",
    r"wish(?:es)?": "constraint, option",
    r"hang(?:s|ing)? (?:on|off|below)": "is a child of, is carried by",
    r"grown together": "fused",
    r"coin toss": "uncertain",
    r"carr(?:y|ies|ied) (?:\w+ )?over": "transfer",
    r"bound anew": "rebound",
    r"unless (?:given|told|asked)": "by default",
    r"in place of": "instead of",
    r"looked at": "used, read, checked",
    r"taken care of": "managed",
    r"nobody (?:knows|said|says)|no one knows": "unknown",
    r"falling (?:gain|size|weight|doubt)": "descending",
    r"(?:is|are) to be (?:asked|mended|left)": "a verb in the active voice",
    r"resembles (?:little|nothing)": "is unlike the training data",
    r"stands? (?:in|for|where|so|elsewhere|as it)": "is in, matches, is at, unchanged",
    r"out of its range": "out of range",
    r"a (?:frame|second|vertex|joint|clip|side|line|key|axis|pixel) each": "one per ...",
    r"frames a second|meters a second|joints a vertex|numbers a (?:frame|key|rotation)": "per",
}
# The project's past is for the CHANGELOG.
PAST = {
    r"no longer": "the present state alone",
    r"as before|like before": "unchanged",
    r"used to (?:be|have|do|need)": "the present state alone",
    r"any ?more(?! than)": "the present state alone",
    r"(?:is|are|has|can|does|do|have) now\b|\bnow (?:is|are|has|can|does|do|have)": "the present state alone",
    r"formerly|previously|in earlier versions": "the present state alone",
}
BRITISH = re.compile(r"colour|neighbour|behaviour|favour|armour|grey(?!hound)|centre|\bcentring|metre|licence|learnt|spelt\b|labell|modell|"
                     r"(?:normal|quant|optim|initial|summar|recogn|organ|minim|maxim|special|visual|raster)is(?:e|es|ed|ing|ation|er)(?![a-z])|"
                     r"analys(?:e|ed|es|ing)\b", re.IGNORECASE)
# Names that others chose, or that files and callers depend on.
KEPT = re.compile(r"learnt_poses|LearntPoses|centre_ratio|centre_distance|pair\.centre_|--license,--licence|initialise_monitor_handles|\"centimetre\"|\"centre\", \"center\"|\"armour\"|[Mm]odelling", re.IGNORECASE)

HEADERS = ("engine/include", "character/include", "formats/include")
MESSAGES = ("engine/src", "formats/src", "character/src", "quant", "trainer", "samples/cli")
NOT_TEXT = {".png", ".jpg", ".obj", ".glb", ".gltf", ".sinew", ".ckpt", ".fbx", ".dae", ".bvh", ".npz", ".npy", ".wasm", ".bin"}
OWN = ("tests/docs/", "samples/web/", "trainer/configs/groups")  # the list itself; the page, whose texts have their own tests


def matches(table, text):
    for pattern, instead in table.items():
        spaced = pattern.replace(" ", r"\s+")
        for found in re.finditer(rf"(?<![\w-])(?:{spaced})(?![\w-])", text, re.IGNORECASE):
            yield found.start(), " ".join(found.group(0).split()), instead


def comments_of(text):
    """(offset, text) of every comment, its line starts blanked so that phrases go on over lines."""
    for found in re.finditer(r"/\*.*?\*/|(?:[ \t]*//[^\n]*\n)*[ \t]*//[^\n]*", text, re.DOTALL):
        yield found.start(), re.sub(r"\n([ \t]*(?:///?<?|\*)?)", lambda m: " " * len(m.group(0)), found.group(0))


def literals_of(text):
    """(offset, text) of every string, adjacent ones joined; those of one word are names."""
    bare = re.sub(r"//[^\n]*|/\*.*?\*/", lambda m: re.sub(r"[^\n]", " ", m.group(0)) if '"' in m.group(0) else m.group(0), text, flags=re.DOTALL)
    for found in re.finditer(r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*', bare):
        joined = re.sub(r'"\s*"', lambda m: " " * 0, found.group(0))
        if " " in joined:
            yield found.start(), joined


def line_of(text, offset):
    return text.count("\n", 0, offset) + 1


def check_headers(root):
    faults, count = [], 0
    for folder in HEADERS:
        for path in sorted((root / folder).rglob("*.h*")):
            text = path.read_text(encoding="utf-8")
            count += 1
            for start, comment in comments_of(text):
                for offset, word, instead in matches({**FIELD, **PAST}, comment):
                    faults.append(f"{path.relative_to(root).as_posix()}:{line_of(text, start) + text.count(chr(10), start, start + offset)}: '{word}'; write {instead}")
    return faults, f"{count} headers"


def check_messages(root):
    faults, count = [], 0
    for folder in MESSAGES:
        for path in sorted((root / folder).rglob("*.?pp")):
            text = path.read_text(encoding="utf-8")
            for start, literal in literals_of(text):
                count += 1
                for _, word, instead in matches({**FIELD, **PAST}, literal):
                    faults.append(f"{path.relative_to(root).as_posix()}:{line_of(text, start)}: '{word}' in {literal[:60]}; write {instead}")
    return faults, f"{count} texts of messages and help"


def check_pages(root):
    faults, all_pages = [], pages.pages_of(root)
    for page in all_pages:
        if page.name == "CHANGELOG.md" or page.name.startswith("samples/web/"):
            continue
        table = {**FIELD, **PAST} if page.name == "README.md" or page.name.startswith("docs/") else PAST
        for number, line in page.prose:
            faults += [f"{page.name}:{number}: '{word}'; write {instead}" for _, word, instead in matches(table, re.sub(r"`[^`]*`", "", line))]
    return faults, f"{len(all_pages)} pages"


def files_of(root):
    listed = subprocess.run(["git", "-C", str(root), "ls-files"], capture_output=True, text=True, encoding="utf-8")
    if listed.returncode == 0:
        return [root / name for name in listed.stdout.splitlines()]
    return [path for path in root.rglob("*") if path.is_file() and not set(path.relative_to(root).parts) & pages.LEFT_OUT]


def check_spelling(root):
    faults, files = [], files_of(root)
    for path in files:
        name = path.relative_to(root).as_posix()
        if name.startswith(OWN) or path.suffix in NOT_TEXT or not path.is_file():
            continue
        text = path.read_text(encoding="utf-8", errors="ignore")
        for number, line in enumerate(text.splitlines(), 1):
            found = BRITISH.search(KEPT.sub("", line))
            if found:
                faults.append(f"{name}:{number}: '{found.group(0)}'; American spelling throughout")
    return faults, f"{len(files)} files in American spelling"


def check_help(programs, help_of):
    """A help that needs scrolling hides its first lines."""
    faults, count = [], 0
    for path in programs:
        lines = help_of(path).splitlines()
        count += 1
        if len(lines) > SCREEN[0]:
            faults.append(f"{' '.join(path)} --help: {len(lines)} lines, expected {SCREEN[0]} at most; move options behind a heading of their own, --help-all lists them")
        faults += [f"{' '.join(path)} --help: {len(line)} columns, expected {SCREEN[1]} at most: {line}" for line in lines if len(line) > SCREEN[1]]
    return faults, f"{count} help screens"


def built_programs(build):
    """Path of each command, and a function that runs its --help."""
    def help_of(path):
        return subprocess.run([str(build / path[0]), *path[1:], "--help"], check=True, capture_output=True, text=True, encoding="utf-8").stdout
    return [(program, *command.path) for program in PROGRAMS for command in describe.commands_of(str(build / program))], help_of


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    checks = [lambda: check_help(*built_programs(pathlib.Path(sys.argv[2])))] if len(sys.argv) > 2 else [lambda check=check: check(root) for check in (check_headers, check_messages, check_pages, check_spelling)]
    faults = []
    for check in checks:
        found, counted = check()
        faults += found
        print(f"words: {counted}, {len(found)} faults")
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
