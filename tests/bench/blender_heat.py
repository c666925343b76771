# SPDX-License-Identifier: MIT
"""Seconds that Blender's "With Automatic Weights" takes per character of a folder: CSV on standard output.

    blender --background --factory-startup --python tests/bench/blender_heat.py -- DIR [repeats]

Characters are NAME.obj + NAME.rig.txt. A bone runs from its joint to the mean of its children, a leaf's half its parent bone on.
Only the operator is timed, as processor time; `bound` is the share of vertices that got a weight.
"""
import glob
import os
import statistics
import sys
import time

import bpy
from mathutils import Vector


def read(path):
    vertices, faces = [], []
    with open(path) as lines:
        for line in lines:
            words = line.split()
            if words[:1] == ["v"]:
                vertices.append([float(w) for w in words[1:4]])
            elif words[:1] == ["f"]:
                corners = [int(w.split("/")[0]) for w in words[1:]]
                faces.append([c - 1 if c > 0 else c + len(vertices) for c in corners])
    joints, parents = {}, {}
    with open(path[: -len(".obj")] + ".rig.txt") as lines:
        for line in lines:
            words = line.split()
            if words[:1] == ["joints"]:
                joints[words[1]] = Vector([float(w) for w in words[2:5]])
            elif words[:1] == ["hier"]:
                parents[words[2]] = words[1]
    return vertices, faces, joints, parents


def weigh(vertices, faces, joints, parents):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    mesh = bpy.data.meshes.new("body")
    mesh.from_pydata(vertices, [], faces)
    body = bpy.data.objects.new("body", mesh)
    rig = bpy.data.objects.new("rig", bpy.data.armatures.new("rig"))
    for item in (body, rig):
        bpy.context.collection.objects.link(item)
    bpy.context.view_layer.objects.active = rig
    bpy.ops.object.mode_set(mode="EDIT")
    size = max(max(v[a] for v in vertices) - min(v[a] for v in vertices) for a in range(3))
    for name, head in joints.items():
        children = [joints[child] for child, parent in parents.items() if parent == name]
        if children:
            tail = sum(children, Vector()) / len(children)
        else:
            tail = head + (head - joints[parents[name]]) / 2 if name in parents else head
        if (tail - head).length < 1e-4 * size:  # Blender deletes bones without a length
            tail = head + Vector((0, 1e-3 * size, 0))
        bone = rig.data.edit_bones.new(name)
        bone.head, bone.tail = head, tail
    for child, parent in parents.items():
        rig.data.edit_bones[child].parent = rig.data.edit_bones[parent]
    bpy.ops.object.mode_set(mode="OBJECT")
    body.select_set(True)
    rig.select_set(True)
    start = time.process_time()
    bpy.ops.object.parent_set(type="ARMATURE_AUTO")
    seconds = time.process_time() - start
    return seconds, sum(1 for v in mesh.vertices if v.groups) / len(vertices)


def main():
    arguments = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
    if not arguments or not os.path.isdir(arguments[0]):
        sys.exit("usage: blender --background --factory-startup --python blender_heat.py -- DIR [repeats]")
    repeats = int(arguments[1]) if len(arguments) > 1 else 3
    print("character,vertices,joints,blender_s,bound")
    for path in sorted(glob.glob(os.path.join(arguments[0], "*.obj"))):
        character = read(path)
        runs = [weigh(*character) for _ in range(repeats)]
        name = os.path.basename(path)[: -len(".obj")]
        print(f"{name},{len(character[0])},{len(character[2])},{statistics.median(r[0] for r in runs):.6f},{runs[0][1]:.3f}")
        sys.stdout.flush()


main()
