#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# NAME.obj and NAME.rig.txt as a C header for main.c:  make_character.py NAME.obj COMMAND > character.h
# COMMAND, free text, is how the OBJ was made.
import struct
import sys

path, made_with = sys.argv[1:]
positions, triangles, joints, parents = [], [], {}, {}
for words in map(str.split, open(path)):
    if words[:1] == ["v"]:
        positions.append([float(x) for x in words[1:4]])
    elif words[:1] == ["f"]:
        corners = [int(w.split("/")[0]) - 1 for w in words[1:]]
        triangles += [[corners[0], corners[i], corners[i + 1]] for i in range(1, len(corners) - 1)]
for words in map(str.split, open(path[:-4] + ".rig.txt")):
    if words[:1] == ["joints"]:
        joints[words[1]] = [float(x) for x in words[2:5]]
    elif words[:1] == ["hier"]:
        parents[words[2]] = words[1]
names = list(joints)


def single(x):  # the shortest decimal that is this float
    bits = struct.pack("f", x)
    text = next(t for t in (f"{x:.{n}g}" for n in range(1, 10)) if struct.pack("f", float(t)) == bits)
    return (text if "." in text or "e" in text else text + ".0") + "f"


def array(kind, name, rows, show):
    print(f"static const {kind} {name}[] = {{")
    line = "   "
    for row in rows:
        for x in row:
            word = " " + show(x) + ","
            if len(line) + len(word) > 118:
                print(line)
                line = "   "
            line += word
    print(line + "\n};")


print("/* SPDX-License-Identifier: CC0-1.0 */\n/* clang-format off */")
print(f"/* A character of our own, written by make_character.py from an OBJ made with\n *   {made_with} */")
print(f"enum {{ kVertices = {len(positions)}, kTriangles = {len(triangles)}, kJoints = {len(names)} }};")
array("float", "kPositions", positions, single)
array("uint32_t", "kCorners", triangles, str)
array("float", "kJointPositions", [joints[n] for n in names], single)
array("int32_t", "kJointParents", [[names.index(parents[n]) if n in parents else -1 for n in names]], str)
print("/* clang-format on */")
