# SPDX-License-Identifier: MIT
"""Correct Bends in Blender, headless."""
import math
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import bpy
import numpy as np
from mathutils import Quaternion

from blender_common import add_mesh, character, clear, run, scene, select, sinew_blender, state

sinew = sinew_blender.sinew


def posed(item):
    """What Blender shows, [n, 3] in the world."""
    bpy.context.view_layer.update()
    evaluated = item.evaluated_get(bpy.context.evaluated_depsgraph_get())
    out = np.empty(3 * len(evaluated.data.vertices), np.float32)
    evaluated.data.vertices.foreach_get("co", out)
    return scene.moved(out.reshape(-1, 3).astype(np.float64), scene.world_of(evaluated))


class Correct(unittest.TestCase):
    def setUp(self):
        clear()
        self.item, self.armature, _, _ = character()
        bpy.ops.sinew.bind()

    def wanted(self, bone, angle):
        """The engine's pose with volume, the linear one."""
        rig = sinew_blender.retarget.rig_of(self.armature)
        joined = scene.join([self.item])
        weights = scene.weights_of(self.item, list(rig.names))
        order = np.argsort(-weights, axis=1, kind="stable")[:, :12]
        skin = sinew.Skin(order.astype(np.uint16), np.take_along_axis(weights, order, 1))
        rotations, _ = rig.rest()
        joint = rig.index(bone)
        rotations[joint] = sinew.multiply(rotations[joint], np.array([math.sin(angle / 2), 0, 0, math.cos(angle / 2)]))
        return [sinew.Deformer(joined.positions, joined.faces, rig, skin, method=m).pose(rig.matrices(rotations)) for m in ("volume", "linear")]

    def turn(self, bone, angle):
        one = self.armature.pose.bones[bone]
        one.rotation_mode = "QUATERNION"
        one.rotation_quaternion = Quaternion((1, 0, 0), angle)

    def test_bends_keep_their_volume(self):
        rest = posed(self.item)
        self.assertEqual(bpy.ops.sinew.correct(), {"FINISHED"})
        np.testing.assert_allclose(posed(self.item), rest, atol=1e-6)
        keys = self.item.data.shape_keys.key_blocks
        self.assertIn("sinew bend forearm.L +X", keys)
        self.assertFalse(any("head" in k.name for k in keys))
        for bone, angle in (("forearm.L", math.pi / 2), ("shin.R", -math.pi / 2), ("forearm.L", math.pi / 4)):
            self.turn(bone, angle)
            volume, linear = self.wanted(bone, angle)
            off = [float(np.linalg.norm(p - volume, axis=1).max()) for p in (linear, posed(self.item))]
            print(f"{bone} at {math.degrees(angle):.0f} degrees: off by {off[0]:.4f} with linear blending, {off[1]:.4f} corrected")
            self.assertLess(off[1], (0.1 if abs(angle) > 1 else 0.8) * off[0])
            self.turn(bone, 0)
        np.testing.assert_allclose(posed(self.item), rest, atol=1e-6)
        # Once more: the same keys, none doubled.
        count = len(keys)
        bpy.ops.sinew.correct()
        self.assertEqual(len(self.item.data.shape_keys.key_blocks), count)

    def test_all_selected_meshes(self):
        """Each gets the keys that it would get alone."""
        other = self.item.copy()
        other.data = self.item.data.copy()
        other.name = "Half"
        bpy.context.scene.collection.objects.link(other)
        select([self.item, other, self.armature], self.armature)
        self.assertEqual(bpy.ops.sinew.correct(), {"FINISHED"})
        names = [[k.name for k in i.data.shape_keys.key_blocks] for i in (self.item, other)]
        self.assertIn("sinew bend forearm.L +X", names[0])
        self.assertEqual(names[0], names[1])
        self.assertEqual(len(other.data.shape_keys.animation_data.drivers), len(names[1]) - 1)
        bare = add_mesh("Bare", [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
        select([self.item, bare, self.armature], self.armature)
        with self.assertRaisesRegex(RuntimeError, "Bare has no weights"):
            bpy.ops.sinew.correct()

    def test_selected_bones_and_errors(self):
        for bone in self.armature.data.bones:
            bone.select = bone.name == "neck"
        self.assertEqual(bpy.ops.sinew.correct(only_selected_bones=True, axes="XZ", angle=math.radians(60)), {"FINISHED"})
        names = [k.name for k in self.item.data.shape_keys.key_blocks]
        self.assertEqual(sorted(names), ["Basis"] + [f"sinew bend neck {s}{a}" for s in "+-" for a in "XZ"])
        self.item.modifiers[0].use_deform_preserve_volume = True
        before = state(self.item)
        with self.assertRaisesRegex(RuntimeError, "switch off Preserve Volume"):
            bpy.ops.sinew.correct()
        self.item.modifiers[0].use_deform_preserve_volume = False
        for bone in self.armature.data.bones:
            bone.select = False
        with self.assertRaisesRegex(RuntimeError, "no bone is selected"):
            bpy.ops.sinew.correct(only_selected_bones=True)
        self.assertEqual(state(self.item), before)
        self.assertEqual([k.name for k in self.item.data.shape_keys.key_blocks], names)


run(__name__)
