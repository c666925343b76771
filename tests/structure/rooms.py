#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Who includes whom: the rooms of engine and character by the order that their READMEs state, the engine's namespaces, and the houses above the engine.

  rooms.py SOURCE_DIR     prints each include that goes the wrong way and each namespace of another room; exits with 1 when there is one
"""
import pathlib
import re
import sys

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*["<]([^">]+)[">]', re.MULTILINE)
SENTENCE = re.compile(r"A room includes only rooms that stand before it in this list:\s*([^.]+)\.")
OWN_NAMESPACES = re.compile(r"Rooms with a namespace of their own:\s*([^.]+)\.")
NAMESPACE = re.compile(r"^(?:inline )?namespace (sinew[\w:]*) \{", re.MULTILINE)
# Above the engine's rooms; no room includes it, so the sentence does not name it.
DOOR = "api"
# Stands last in the sentence, and defines functions that other rooms declare, in their namespaces.
PUBLISHED = "published"
# A house whose README orders its rooms: the folders that hold one folder a room, and how an include of a room begins.
ROOM_HOUSES = {
    "engine": (["src"], [""]),
    "character": (["src", "include/sinew_character"], ["", "sinew_character/"]),
}
# A house with its folders, and what it must not include. A folder belongs to the house with the longest name that fits.
HOUSES = {
    "engine": (["engine/include", "engine/src"], ["formats", "character", "data_sets", "trainer", "quant"]),
    "formats": (["formats/include", "formats/src"], ["character", "data_sets", "trainer", "quant"]),
    "character": (["character/include", "character/src"], ["data_sets", "trainer", "quant"]),
    "data_sets": (["trainer/data_sets/include", "trainer/data_sets/src"], ["trainer", "quant"]),
    "trainer": (["trainer/include", "trainer/src"], ["quant"]),
    "quant": (["quant/include", "quant/src"], ["trainer"]),
}


def sources(folder):
    return sorted(p for p in folder.rglob("*") if p.suffix in (".hpp", ".cpp", ".h", ".c"))


def includes(path):
    """(line, name) of every include."""
    text = path.read_text(encoding="utf-8")
    return [(text.count("\n", 0, m.start(1)) + 1, m.group(1)) for m in INCLUDE.finditer(text)]


def allowed_rooms(readme, house="engine"):
    """room -> the rooms that it may include, as the sentence of the README says."""
    found = SENTENCE.search(readme)
    if not found:
        raise SystemExit(f'rooms: {house}/README.md has no sentence "A room includes only rooms that stand before it in this list: ..."')
    allowed, before = {}, []
    for entry in re.split(r",\s*(?![^(]*\))", " ".join(found.group(1).split())):
        names, _, note = entry.partition(" (")
        group = names.split(" and ")
        note = note.rstrip(")")
        if note.endswith(" alone"):
            may = re.split(r", | and ", note[: -len(" alone")])
            unknown = [room for room in may if room not in before]
            if unknown:
                raise SystemExit(f"rooms: {house}/README.md lets {names} include {unknown[0]}, which does not stand before it")
        elif note in ("", "neither knows the other"):
            may = list(before)
        else:
            raise SystemExit(f'rooms: {house}/README.md says "({note})" of {names}; this test knows "(neither knows the other)" and "(... alone)"')
        for room in group:
            allowed[room] = set(may)
        before += group
    return allowed


def own_namespaces(readme):
    """room -> its namespace, of the rooms that have one beside sinew's."""
    found = OWN_NAMESPACES.search(readme)
    entries = " ".join(found.group(1).split()).split(", ") if found else []
    return {room: "sinew::" + (other.rstrip(")") or room) for room, _, other in (entry.partition(" (") for entry in entries)}


def check_namespaces(source):
    faults, own = [], own_namespaces((source / "engine/README.md").read_text(encoding="utf-8"))
    for path in sources(source / "engine/src"):
        room = path.parent.name
        for found in NAMESPACE.finditer(path.read_text(encoding="utf-8")):
            space = found.group(1)
            if room in (DOOR, PUBLISHED) or space in ([own[room]] if room in own else ["sinew", "sinew::" + room]):
                continue
            faults.append(f"{path.relative_to(source)}: opens {space}; engine/README.md gives {room} {own.get(room, 'sinew')}")
    return faults, f"{len(own)} rooms with a namespace of their own"


def check_house_rooms(source, house):
    faults, count = [], 0
    folders, beginnings = ROOM_HOUSES[house]
    folders = [source / house / folder for folder in folders]
    readme = f"{house}/README.md"
    allowed = allowed_rooms((source / readme).read_text(encoding="utf-8"), house)
    rooms = {p.name for folder in folders if folder.is_dir() for p in folder.iterdir() if p.is_dir() and sources(p)}
    faults += [f"{readme}'s list of rooms lacks {house}/src/{room}" for room in sorted(rooms - set(allowed) - {DOOR})]
    faults += [f"{readme}'s list names a room {room} that {house}/src has not" for room in sorted(set(allowed) - rooms)]
    for folder in folders:
        for room in sorted(rooms):
            for path in sources(folder / room):
                for line, name in includes(path):
                    for beginning in beginnings:
                        other, slash, _ = name.removeprefix(beginning).partition("/")
                        if not name.startswith(beginning) or not slash or other == room or other not in rooms:
                            continue
                        count += 1
                        if room == DOOR or room not in allowed or other in allowed[room]:
                            continue
                        faults.append(f"{path.relative_to(source)}:{line}: {room} includes {name}, and {other} does not stand before it in {readme}")
    return faults, f"{len(rooms)} rooms of {house}, {count} includes between them"


def check_rooms(source):
    found = [check_house_rooms(source, house) for house in ROOM_HOUSES]
    return [fault for faults, _ in found for fault in faults], "; ".join(said for _, said in found)


def check_houses(source):
    faults, count = [], 0
    folders = {house: [source / f for f in given if (source / f).is_dir()] for house, (given, _) in HOUSES.items()}
    faults += [f"the house {house} has no folder {' or '.join(HOUSES[house][0])}" for house in folders if not folders[house]]
    for house, (_, forbidden) in HOUSES.items():
        lower = [other for other in HOUSES if other not in forbidden]
        for folder in folders[house]:
            for path in sources(folder):
                for line, name in includes(path):
                    if (path.parent / name).is_file() or any((f / name).is_file() for other in lower for f in folders[other]):
                        continue
                    count += 1
                    for other in forbidden:
                        if name.startswith(f"sinew_{other}/") or any((f / name).is_file() for f in folders[other]):
                            faults.append(f"{path.relative_to(source)}:{line}: {house} includes {name} of {other}")
    return faults, f"{len(HOUSES)} houses, {count} includes of what lies outside their own and lower ones"


def main():
    source = pathlib.Path(sys.argv[1])
    faults = []
    for check in (check_rooms, check_namespaces, check_houses):
        found, said = check(source)
        faults += found
        print(f"rooms: {said}, {len(found)} faults")
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
