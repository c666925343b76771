# SPDX-License-Identifier: MIT
"""Retarget in Blender, headless."""
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import bpy
import numpy as np
from mathutils import Quaternion, Vector

from blender_common import add_armature, character, clear, common, run, select, sinew_blender

sinew = sinew_blender.sinew


def direction(armature, name, child):
    """Where a bone points in the world, from its head to its child's."""
    update()
    evaluated = armature.evaluated_get(bpy.context.evaluated_depsgraph_get())
    heads = [evaluated.matrix_world @ evaluated.pose.bones[n].head for n in (name, child)]
    return np.array((heads[1] - heads[0]).normalized())


def update():
    bpy.context.view_layer.update()


class Retarget(unittest.TestCase):
    def setUp(self):
        clear()
        self.item, self.target, _, _ = character()
        bpy.ops.sinew.bind()
        self.source = add_armature(common.read_character("biped__robot")[2], "Source")
        self.source.location = (2, 0.5, 0)
        self.source.rotation_mode = "QUATERNION"
        action = bpy.data.actions.new("wave")
        self.source.animation_data_create().action = action
        for frame in range(1, 21):
            for name, axis in (("upper_arm.L", (1, 0, 0)), ("forearm.R", (0, 0, 1)), ("thigh.L", (1, 0, 0))):
                bone = self.source.pose.bones[name]
                bone.rotation_mode = "QUATERNION"
                bone.rotation_quaternion = Quaternion(axis, 0.9 * np.sin(frame / 4))
                bone.keyframe_insert("rotation_quaternion", frame=frame)
            hips = self.source.pose.bones["hips"]
            hips.location = (0.03 * frame, 0, 0)
            hips.keyframe_insert("location", frame=frame)
        select([self.target, self.source], self.target)

    def test_limbs_point_where_the_sources_do(self):
        bpy.context.scene.frame_set(7)
        self.assertEqual(bpy.ops.sinew.retarget(hold_feet=False), {"FINISHED"})
        self.assertEqual(bpy.context.scene.frame_current, 7)
        self.assertEqual(self.target.animation_data.action.name, "wave on Armature")
        self.assertEqual(self.source.animation_data.action.name, "wave")
        worst = 0
        for frame in (1, 5, 12, 20):
            bpy.context.scene.frame_set(frame)
            for name, child in (("upper_arm.L", "forearm.L"), ("forearm.R", "hand.R"), ("thigh.L", "shin.L")):
                off = direction(self.target, name, child) @ direction(self.source, name, child)
                worst = max(worst, float(np.degrees(np.arccos(np.clip(off, -1, 1)))))
        print(f"limbs are off by at most {worst:.2f} degrees")
        self.assertLess(worst, 1)
        curves = self.target.animation_data.action.fcurves
        self.assertEqual(len(curves[0].keyframe_points), 20)

    def test_same_as_the_package(self):
        self.assertEqual(bpy.ops.sinew.retarget(hold_feet=False), {"FINISHED"})
        operator = sinew_blender.retarget
        rigs = operator.rig_of(self.source), operator.rig_of(self.target)
        taken = operator.SINEW_OT_retarget._clip(bpy.context, self.source, rigs[0], 1, 20)
        expected = sinew.retarget(taken, *rigs, joint_map=operator.find_map(self.target, self.source), source_up="z", target_up="z")
        found = operator.SINEW_OT_retarget._clip(bpy.context, self.target, rigs[1], 1, 20)
        np.testing.assert_allclose(np.abs((found.rotations * expected.rotations).sum(2)), 1, atol=1e-4)
        np.testing.assert_allclose(found.translations, expected.translations, atol=2e-3)

    def test_a_source_that_lies_in_the_scene(self):
        """A z-up BVH that was imported as y-up lies on its back; its motion stands on a character that stands."""
        self.source.rotation_euler = (-np.pi / 2, 0, 0)
        self.source.rotation_mode = "XYZ"
        self.source.rotation_euler = (-np.pi / 2, 0, 0)
        update()
        self.assertEqual(sinew_blender.retarget.up_of(self.source), "auto")
        self.assertEqual(sinew_blender.retarget.up_of(self.target), "z")
        self.assertEqual(bpy.ops.sinew.retarget(hold_feet=False), {"FINISHED"})
        raised = Quaternion((1, 0, 0), np.pi / 2)
        for frame in (1, 12, 20):
            bpy.context.scene.frame_set(frame)
            self.assertGreater(direction(self.target, "hips", "head")[2], 0.9)
            for name, child in (("upper_arm.L", "forearm.L"), ("thigh.L", "shin.L")):
                wanted = np.array(raised @ Vector(direction(self.source, name, child).tolist()))
                self.assertGreater(direction(self.target, name, child) @ wanted, 0.99, name)

    def test_the_map_is_shown_and_edited(self):
        self.assertEqual(bpy.ops.sinew.map_bones(), {"FINISHED"})
        pairs = {p.target: p for p in bpy.context.scene.sinew_map}
        self.assertEqual(pairs["forearm.L"].source, "forearm.L")
        self.assertGreater(pairs["forearm.L"].confidence, 0.3)
        pairs["upper_arm.L"].source = ""
        self.assertEqual(bpy.ops.sinew.retarget(hold_feet=False), {"FINISHED"})
        bpy.context.scene.frame_set(5)
        rest = np.array((self.target.data.bones["forearm.L"].head_local - self.target.data.bones["upper_arm.L"].head_local).normalized())
        np.testing.assert_allclose(direction(self.target, "upper_arm.L", "forearm.L"), rest, atol=0.05)
        pairs["upper_arm.L"].source = "no such bone"
        with self.assertRaisesRegex(RuntimeError, "has no such bone"):
            bpy.ops.sinew.retarget()

    def test_feet_in_place_and_what_was_there(self):
        old = bpy.data.actions.new("mine")
        self.target.animation_data_create().action = old
        self.assertEqual(bpy.ops.sinew.retarget(in_place=True), {"FINISHED"})
        self.assertTrue(old.use_fake_user)
        places = []
        for frame in (1, 20):
            bpy.context.scene.frame_set(frame)
            update()
            places.append((self.target.matrix_world @ self.target.pose.bones["hips"].head).x)
        self.assertLess(abs(places[1] - places[0]), 0.02)

    def test_errors_change_nothing(self):
        select([self.target], self.target)
        with self.assertRaisesRegex(RuntimeError, "select one other armature"):
            bpy.ops.sinew.retarget()
        self.source.animation_data_clear()
        select([self.target, self.source], self.target)
        with self.assertRaisesRegex(RuntimeError, "Source has no action"):
            bpy.ops.sinew.retarget()
        self.assertIsNone(self.target.animation_data)


run(__name__)
