# SPDX-License-Identifier: MIT
"""Runs inside Blender: installs the add-on's zip, makes characters of the repository's samples.

    blender -b --factory-startup --python-exit-code 1 --python test_bind.py -- ZIP SOURCE COMMAND
"""
import os
import sys
import unittest

import bpy
import numpy as np

ZIP, SOURCE, COMMAND = sys.argv[sys.argv.index("--") + 1:][:3]
os.environ["SINEW_COMMAND"], os.environ["SINEW_SOURCE_DIR"] = COMMAND, SOURCE
sys.dont_write_bytecode = True


def install():
    """From the zip, as a user does it."""
    bpy.ops.preferences.addon_install(filepath=ZIP, overwrite=True)
    bpy.ops.preferences.addon_enable(module="sinew_blender")
    import sinew_blender
    assert os.path.join(SOURCE, "samples") not in sinew_blender.__file__, sinew_blender.__file__
    sys.modules["sinew"] = sinew_blender.sinew
    sys.path.insert(0, os.path.join(SOURCE, "samples", "python", "tests"))


install()
import common  # noqa: E402  of the Python package's tests
import sinew_blender  # noqa: E402
from sinew_blender import scene  # noqa: E402


def z_up(points):
    return np.asarray(points)[:, [0, 2, 1]] * [1, -1, 1]


def clear():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.preferences.addon_enable(module="sinew_blender")


def add_mesh(name, positions, faces):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([tuple(map(float, p)) for p in positions], [], faces)
    item = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(item)
    return item


def add_armature(skeleton, name="Armature"):
    """Bones at z-up places of a sinew skeleton."""
    places = z_up(skeleton.positions)
    item = bpy.data.objects.new(name, bpy.data.armatures.new(name))
    bpy.context.scene.collection.objects.link(item)
    select([item], item)
    bpy.ops.object.mode_set(mode="EDIT")
    bones = [item.data.edit_bones.new(n) for n in skeleton.names]
    for joint, parent in enumerate(skeleton.parents):
        bones[joint].head = places[joint]
        children = np.flatnonzero(skeleton.parents == joint)
        way = places[children[0]] - places[joint] if len(children) else np.array([0, 0, 0.1])
        bones[joint].tail = places[joint] + (way if np.linalg.norm(way) > 1e-4 else [0, 0, 0.1])
        if parent >= 0:
            bones[joint].parent = bones[parent]
    bpy.ops.object.mode_set(mode="OBJECT")
    return item


def select(items, active):
    if bpy.context.object is not None and bpy.context.object.mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    for one in bpy.context.scene.objects:
        one.select_set(one in items)
    bpy.context.view_layer.objects.active = active


def character(name="biped__robed"):
    """A mesh, an armature, both selected; ragged faces, the artist's rows."""
    positions, faces, skeleton, rows = common.read_character(name)
    item, armature = add_mesh(name, z_up(positions), faces), add_armature(skeleton)
    select([item, armature], armature)
    return item, armature, rows, skeleton


def weights(item):
    """{group name: [n] float32}."""
    out = {g.name: np.zeros(len(item.data.vertices), np.float32) for g in item.vertex_groups}
    names = {g.index: g.name for g in item.vertex_groups}
    for v in item.data.vertices:
        for element in v.groups:
            out[names[element.group]][v.index] = element.weight
    return out


def state(item):
    """What an error must leave alone."""
    return ({n: w.tolist() for n, w in weights(item).items()}, [(m.name, m.type) for m in item.modifiers],
            item.parent.name if item.parent else None, [list(r) for r in item.matrix_world])


def run(module):
    result = unittest.TextTestRunner(verbosity=2).run(unittest.defaultTestLoader.loadTestsFromModule(sys.modules[module]))
    sys.stdout.flush()
    if not result.wasSuccessful() or result.testsRun == 0:
        raise SystemExit(1)
