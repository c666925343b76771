# SPDX-License-Identifier: MIT
"""Rig, Transfer, Show Doubt in Blender, headless."""
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import bpy
import numpy as np

from blender_common import add_armature, add_mesh, character, clear, common, run, scene, select, sinew_blender, state, weights, z_up

sinew = sinew_blender.sinew


def heads(armature):
    return scene.skeleton_of(armature).positions


def dense(item, names):
    rows = weights(item)
    return np.stack([rows.get(n, np.zeros(len(item.data.vertices), np.float32)) for n in names], 1)


class Rig(unittest.TestCase):
    def setUp(self):
        clear()

    def test_a_new_armature_is_the_commands_skeleton(self):
        positions, faces, _, _ = common.read_character("biped__robed")
        item = add_mesh("body", z_up(positions), faces)
        select([item], item)
        self.assertEqual(bpy.ops.sinew.rig(names="sides"), {"FINISHED"})
        armature = bpy.context.object
        with common.folder() as where:
            common.command("rig", common.DATA / "biped__robed.obj", "-o", f"{where}/rig.rig.txt")
            expected, rows = common.read_rig(f"{where}/rig.rig.txt", len(positions))
        bones = [n for n in expected.names if not n.endswith("_end")]
        self.assertEqual({b.name for b in armature.data.bones}, set(bones))
        for bone in armature.data.bones:
            joint = expected.index(bone.name)
            np.testing.assert_allclose(bone.head_local, z_up(expected.positions[joint:joint + 1])[0], atol=1e-5)
            parent = expected.parents[joint]
            self.assertEqual(bone.parent.name if bone.parent else None, expected.names[parent] if parent >= 0 else None)
            self.assertGreater(bone.length, 1e-4)
        self.assertEqual(item.parent, armature)
        names = [b.name for b in armature.data.bones]
        # The command's weights in steps of 1/255.
        np.testing.assert_allclose(dense(item, names), rows[:, [expected.index(n) for n in names]], atol=3.01 / 255)

    def test_names_fingers_and_spine(self):
        positions, faces, _, _ = common.read_character("biped__robed")
        item = add_mesh("body", z_up(positions), faces)
        select([item], item)
        self.assertEqual(bpy.ops.sinew.rig(spine=4, toes=False, bind=False), {"FINISHED"})
        names = [b.name for b in bpy.context.object.data.bones]
        self.assertIn("Arm.L", names)
        self.assertIn("Arm.R", names)
        self.assertEqual(sum(n.startswith("Spine") for n in names), 4)
        self.assertEqual(len(item.vertex_groups), 0)

    def test_the_selected_armature_is_fitted(self):
        item, armature, _, skeleton = character()
        bpy.ops.object.select_all(action="DESELECT")
        right = heads(armature).copy()
        # The same skeleton, larger and elsewhere.
        moved = sinew.Skeleton(skeleton.positions * 1.7 + [0.5, 0.2, 0], skeleton.parents, skeleton.names)
        bpy.data.objects.remove(armature)
        other = add_armature(moved)
        select([item, other], other)
        off = np.linalg.norm(heads(other) - right, axis=1).mean()
        self.assertEqual(bpy.ops.sinew.rig(), {"FINISHED"})
        self.assertEqual([b.name for b in other.data.bones], list(scene.skeleton_of(other).names))
        fitted = np.linalg.norm(heads(other) - right, axis=1).mean()
        print(f"the armature's joints are off by {off:.3f}, fitted by {fitted:.3f}")
        self.assertLess(fitted, 0.25 * off)
        self.assertTrue(all(b.length > 1e-5 for b in other.data.bones))
        self.assertEqual(item.parent, other)

    def test_errors_change_nothing(self):
        item, armature, _, _ = character()
        second = add_armature(scene.skeleton_of(armature), "Second")
        select([item, armature, second], armature)
        before, objects = state(item), len(bpy.data.objects)
        with self.assertRaisesRegex(RuntimeError, "there are several"):
            bpy.ops.sinew.rig()
        select([item], item)
        item.data.vertices[0].co = (float("nan"), 0, 0)
        before = state(item)
        with self.assertRaisesRegex(RuntimeError, "Rig: character.positions: element"):
            bpy.ops.sinew.rig()
        self.assertEqual((state(item), len(bpy.data.objects)), (before, objects))


class Transfer(unittest.TestCase):
    def setUp(self):
        clear()

    def paint(self, item, rows, names):
        for j, name in enumerate(names):
            group = item.vertex_groups.new(name=name)
            for v in np.flatnonzero(rows[:, j]):
                group.add([int(v)], float(rows[v, j]), "REPLACE")

    def test_weights_of_the_active_go_to_the_selected(self):
        item, armature, rows, skeleton = character()
        self.paint(item, rows, skeleton.names)
        item.modifiers.new("Armature", "ARMATURE").object = armature
        other = add_mesh("other", scene.rest_positions(item) * [1.1, 1, 0.95], [list(p.vertices) for p in item.data.polygons])
        select([item, other], item)
        self.assertEqual(bpy.ops.sinew.transfer(), {"FINISHED"})
        joined = scene.join([other])
        own = scene.skeleton_of(armature)
        order = np.argsort(-dense(item, own.names), axis=1, kind="stable")[:, :12]
        source = sinew.Character(scene.join([item]).positions, scene.join([item]).faces, own,
                                 sinew.Skin(order, np.take_along_axis(dense(item, own.names), order, 1)))
        expected = sinew.transfer(source, joined.positions, joined.faces, up="z").skin.dense(len(own))
        np.testing.assert_allclose(dense(other, own.names), expected, atol=3.01 / 255)  # what three rounded down leave to the first
        self.assertEqual(scene.armature_of(other), armature)
        nearest = np.abs(dense(other, own.names) - dense(item, own.names)).sum(1).mean()
        self.assertLess(nearest, 0.3)

    def test_a_garment_and_errors(self):
        item, armature, rows, skeleton = character()
        select([item], item)
        with self.assertRaisesRegex(RuntimeError, "select the meshes that get weights"):
            bpy.ops.sinew.transfer()
        other = add_mesh("jacket", scene.rest_positions(item) * 1.02, [list(p.vertices) for p in item.data.polygons])
        select([item, other], item)
        before = state(other)
        with self.assertRaisesRegex(RuntimeError, "bind it first"):
            bpy.ops.sinew.transfer()
        self.assertEqual(state(other), before)
        self.paint(item, rows, skeleton.names)
        item.modifiers.new("Armature", "ARMATURE").object = armature
        self.assertEqual(bpy.ops.sinew.transfer(garment=True), {"FINISHED"})
        np.testing.assert_allclose(dense(other, skeleton.names).sum(1), 1, atol=1e-5)
        with self.assertRaisesRegex(RuntimeError, "Transfer: garment: does not work with"):
            bpy.ops.sinew.transfer(garment=True, method="biharmonic")


class Look(unittest.TestCase):
    def test_the_least_sure_are_selected_and_colored(self):
        clear()
        item, armature, _, _ = character()
        bpy.ops.sinew.bind()
        before = state(item)
        self.assertEqual(bpy.ops.sinew.look(share=0.05), {"FINISHED"})
        self.assertEqual(state(item), before)
        joined = scene.join([item])
        sure = sinew.bind(joined.positions, joined.faces, scene.skeleton_of(armature), up="z").confidence
        chosen = np.array([v.select for v in item.data.vertices])
        self.assertEqual(int(chosen.sum()), round(0.05 * len(sure)))
        self.assertLessEqual(sure[chosen].max(), sure[~chosen].min())
        attribute = item.data.color_attributes["sinew doubt"]
        colors = np.empty(4 * len(sure), np.float32)
        attribute.data.foreach_get("color", colors)
        red = colors.reshape(-1, 4)[:, 0]
        self.assertGreaterEqual(red[chosen].min(), red[~chosen].max())
        self.assertGreater(red.max(), red.min() + 0.5)
        bpy.ops.sinew.look()
        self.assertEqual(len(item.data.color_attributes), 1)


run(__name__)
