# SPDX-License-Identifier: MIT
"""Controls in Blender, headless: what they pull and turn, the switch to single bones, the bake, what stays."""
import math
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import bpy
import numpy as np
from mathutils import Vector

from blender_common import add_armature, clear, common, run, select, sinew_blender

if "bool" not in np.__dict__:
    np.bool = bool  # Debian's importer of glTF is older than its numpy
sinew = sinew_blender.sinew
control_rig = sinew_blender.control_rig


def person():
    """A sample with the 65 joints of Mixamo, as Blender imports it: bones point anywhere."""
    clear()
    with common.folder() as where:
        common.command("rig", common.DATA / "biped__robot.obj", "--skeleton", "template:mixamo", "-o", f"{where}/person.glb")
        bpy.ops.import_scene.gltf(filepath=f"{where}/person.glb")
    armature = next(o for o in bpy.data.objects if o.type == "ARMATURE")
    item = next(o for o in bpy.data.objects if o.type == "MESH" and o.vertex_groups)
    select([armature], armature)
    return item, armature


def controlled():
    item, armature = person()
    rest = matrices(armature)
    assert bpy.ops.sinew.controls() == {"FINISHED"}
    return item, armature, control_rig.controls_of(armature), rest


def matrices(armature):
    """{bone: [4, 4]} as it is seen."""
    bpy.context.view_layer.update()
    seen = armature.evaluated_get(bpy.context.evaluated_depsgraph_get())
    return {bone.name: np.array(bone.matrix) for bone in seen.pose.bones}


def heads(armature):
    return {name: matrix[:3, 3] for name, matrix in matrices(armature).items()}


def lengths(armature):
    at = heads(armature)
    return {bone.name: np.linalg.norm(at[bone.name] - at[bone.parent.name]) for bone in armature.data.bones if bone.parent}


def largest(a, b):
    return max(np.abs(a[name] - b[name]).max() for name in a)


def size_of(armature):
    return np.ptp(np.array(list(heads(armature).values())), axis=0).max()


def changed(controls):
    controls.update_tag()
    bpy.context.view_layer.update()


def limbs(armature):
    with sinew.create(sinew.Character(np.zeros((0, 3), np.float32), [], sinew_blender.scene.skeleton_of(armature))) as one:
        return {limb["name"]: limb for limb in one.controls()["limbs"]}


class Controls(unittest.TestCase):
    def test_rest_stays_and_the_armature_is_its_own(self):
        item, armature, controls, rest = controlled()
        off = largest(rest, matrices(armature)) / size_of(armature)
        print(f"at rest the bones are off by {off:.2e} of the size")
        self.assertLess(off, 1e-3)
        self.assertEqual(set(limbs(armature)), {"leg.left", "leg.right", "arm.left", "arm.right"})
        for bone in controls.data.bones:
            self.assertFalse(bone.use_deform)
        self.assertEqual({len(b.constraints) for b in armature.pose.bones}, {1})

    def test_a_pose_stays(self):
        _, armature = person()
        for name, turn in (("LeftArm", (0.4, 0.2, -0.3)), ("LeftForeArm", (0.1, 0.5, 0.6)), ("RightUpLeg", (0.5, 0.1, 0.1)), ("RightLeg", (-0.6, 0, 0)),
                           ("Spine1", (0.2, 0.1, 0)), ("Head", (0.1, 0.4, 0)), ("LeftHandIndex2", (0.3, 0, 0.2))):
            bone = armature.pose.bones["mixamorig:" + name]
            bone.rotation_mode = "XYZ"
            bone.rotation_euler = turn
        armature.pose.bones["mixamorig:Hips"].location = (0.05, 0.1, 0)
        before = matrices(armature)
        self.assertEqual(bpy.ops.sinew.controls(), {"FINISHED"})
        off = largest(before, matrices(armature)) / size_of(armature)
        controls = control_rig.controls_of(armature)
        for name in limbs(armature):
            self.assertEqual(controls.pose.bones[control_rig.label("IK", name)]["FK"], 1)
            controls.pose.bones[control_rig.label("IK", name)]["FK"] = 0.0
        changed(controls)
        pulled, ends = heads(armature), [n for limb in limbs(armature).values() for n in (limb["middle"], limb["joints"][-1])]
        near = max(np.linalg.norm(pulled[n] - before[n][:3, 3]) for n in ends) / size_of(armature)
        print(f"posed bones are off by {off:.2e} of the size, knees, elbows, feet and hands that are pulled by {near:.2e}")
        self.assertLess(off, 1e-4)
        self.assertLess(near, 1e-3)

    def test_limbs_follow_and_bones_keep_their_lengths(self):
        _, armature, controls, _ = controlled()
        size, before = size_of(armature), lengths(armature)
        worst = stretched = 0
        for name, limb in limbs(armature).items():
            control = controls.pose.bones[control_rig.label("IK", name)]
            upper, middle, end = (armature.data.bones[n].head_local for n in (limb["joints"][0], limb["middle"], limb["joints"][-1]))
            reach = (middle - upper).length + (end - middle).length
            for way in (Vector((0, -0.3, 0.2)), Vector((0.15, -0.2, 0.4)), Vector((-0.2, 0.1, 0.3))):
                wanted = upper + 0.8 * ((end - upper) + way * reach).normalized() * reach
                matrix = control.matrix.copy()
                matrix.translation = wanted
                control.matrix = matrix
                changed(controls)
                worst = max(worst, np.linalg.norm(heads(armature)[limb["joints"][-1]] - np.array(wanted)) / size)
                now = lengths(armature)
                stretched = max(stretched, max(abs(now[n] - before[n]) for n in now) / size)
        print(f"ends of limbs are off their controls by {worst:.2e} of the size, lengths of bones by {stretched:.2e}")
        self.assertLess(worst, 1e-3)
        self.assertLess(stretched, 1e-4)

    def test_knees_point_to_their_poles(self):
        _, armature, controls, _ = controlled()
        for name, limb in limbs(armature).items():
            at = heads(armature)
            upper, end = (at[limb["joints"][k]] for k in (0, -1))
            control = controls.pose.bones[control_rig.label("IK", name)]
            matrix = control.matrix.copy()
            matrix.translation = Vector(upper + 0.7 * (end - upper))
            control.matrix = matrix
            changed(controls)
            at = heads(armature)
            knee = at[limb["middle"]] - 0.5 * (at[limb["joints"][0]] + at[limb["joints"][-1]])
            self.assertGreater(knee @ limb["pole"] / np.linalg.norm(knee), 0.8, name)

    def test_the_switch_to_single_bones(self):
        _, armature, controls, rest = controlled()
        limb = limbs(armature)["arm.left"]
        control = controls.pose.bones["IK arm.L"]
        control.location = (0, 0, 0.3)
        changed(controls)
        pulled = matrices(armature)
        control["FK"] = 1.0
        changed(controls)
        self.assertLess(largest(rest, matrices(armature)), 1e-4)
        bone = controls.pose.bones[limb["middle"]]
        bone.rotation_mode = "XYZ"
        bone.rotation_euler = (0.7, 0, 0)
        changed(controls)
        now = matrices(armature)
        np.testing.assert_allclose(now[limb["joints"][0]], rest[limb["joints"][0]], atol=1e-4)
        turned = now[limb["middle"]][:3, :3] @ rest[limb["middle"]][:3, :3].T
        self.assertAlmostEqual(math.acos((np.trace(turned) - 1) / 2), 0.7, places=3)
        control["FK"] = 0.0
        changed(controls)
        self.assertLess(largest(pulled, matrices(armature)), 1e-3)

    def test_a_foot_rolls(self):
        _, armature, controls, rest = controlled()
        limb = limbs(armature)["leg.left"]
        end, ball = limb["joints"][-1], limb["ball"]
        self.assertTrue(ball)
        control, size = controls.pose.bones["IK leg.L"], size_of(armature)
        control["roll"] = 30.0
        changed(controls)
        now = matrices(armature)
        self.assertGreater(now[end][2, 3] - rest[end][2, 3], 0.01 * size)  # the ankle is lifted
        self.assertLess(np.abs(now[ball] - rest[ball]).max(), 2e-3)  # the toes stay as they were
        control["roll"] = -30.0
        changed(controls)
        self.assertGreater(heads(armature)[ball][2] - rest[ball][2, 3], 0.01 * size)

    def test_spine_head_and_fingers(self):
        _, armature, controls, rest = controlled()
        pose = controls.pose.bones
        with sinew.create(sinew.Character(np.zeros((0, 3), np.float32), [], sinew_blender.scene.skeleton_of(armature))) as one:
            told = one.controls()
        self.assertTrue(told["spine"] and told["head"] and told["fingers"])

        def angle(name):
            turned = matrices(armature)[name][:3, :3] @ rest[name][:3, :3].T
            return math.degrees(math.acos(np.clip((np.trace(turned) - 1) / 2, -1, 1)))

        for control, last in (("turn spine", told["spine"][-1]), ("turn head", told["head"])):
            pose[control].rotation_mode = "XYZ"
            pose[control].rotation_euler = (0, math.radians(40), 0)
            changed(controls)
            self.assertAlmostEqual(angle(last), 40, delta=4)
            pose[control].rotation_euler = (0, 0, 0)
        changed(controls)
        finger = next(f for f in told["fingers"] if f["side"] == "left" and not f["name"].startswith("thumb"))
        tip = finger["joints"][-1]
        pose["IK arm.L"]["curl"] = 30.0
        changed(controls)
        self.assertAlmostEqual(angle(tip), 30 * len(finger["joints"]), delta=3)
        # The palm of an arm that hangs or is held out looks down or in: fingers of this rig curl down.
        moved = heads(armature)[tip] - rest[tip][:3, 3]
        self.assertLess(moved[2], 0)
        pose["IK arm.L"]["curl"] = 0.0
        pose[control_rig.label("curl", finger["name"])].rotation_mode = "XYZ"
        pose[control_rig.label("curl", finger["name"])].rotation_euler = (math.radians(20), 0, 0)
        changed(controls)
        self.assertAlmostEqual(angle(tip), 20 * len(finger["joints"]), delta=2)
        self.assertLess(heads(armature)[tip][2] - rest[tip][2, 3], 0)

    def test_baked_is_what_was_seen(self):
        _, armature, controls, _ = controlled()
        control = controls.pose.bones["IK leg.L"]
        for frame, place in ((1, (0, 0, 0)), (6, (0, 0.2, 0.3))):
            control.location = place
            control.keyframe_insert("location", frame=frame)
        seen = {}
        for frame in range(1, 7):
            bpy.context.scene.frame_set(frame)
            seen[frame] = matrices(armature)
        self.assertGreater(largest(seen[1], seen[6]), 0.05)
        self.assertEqual(bpy.ops.sinew.bake_controls(), {"FINISHED"})
        self.assertEqual({len(b.constraints) for b in armature.pose.bones}, {0})
        self.assertFalse([o for o in bpy.data.objects if control_rig.CONTROLS in o])
        worst = 0
        for frame in range(1, 7):
            bpy.context.scene.frame_set(frame)
            worst = max(worst, largest(seen[frame], matrices(armature)))
        print(f"baked bones are off what was seen by {worst:.2e}")
        self.assertLess(worst, 1e-4)
        with self.assertRaisesRegex(RuntimeError, "has no controls"):
            bpy.ops.sinew.bake_controls()

    def test_a_pose_without_keys_is_baked_and_exported_as_it_was(self):
        item, armature = person()

        def exported(path):
            select([item, armature], armature)
            bpy.ops.export_scene.gltf(filepath=path, use_selection=True, export_animations=False)
            return sinew.open(path)

        with common.folder() as where:
            before = exported(f"{where}/before.glb")
            self.assertEqual(bpy.ops.sinew.controls(), {"FINISHED"})
            with_controls = exported(f"{where}/with.glb")
            controls = control_rig.controls_of(armature)
            controls.pose.bones["IK arm.R"].location = (0, 0, 0.2)
            changed(controls)
            seen = matrices(armature)
            select([armature], armature)
            self.assertEqual(bpy.ops.sinew.bake_controls(), {"FINISHED"})
            self.assertLess(largest(seen, matrices(armature)), 1e-4)
            after = exported(f"{where}/after.glb")
            for other in (with_controls, after):
                self.assertEqual(list(other.skeleton.names), list(before.skeleton.names))
                np.testing.assert_allclose(other.positions, before.positions, atol=1e-6)
                np.testing.assert_allclose(other.skeleton.positions, before.skeleton.positions, atol=1e-4)

    def test_from_a_file_and_a_glb(self):
        with common.folder() as where:
            common.command("rig", common.DATA / "biped__robot.obj", "-o", f"{where}/robot.glb", "--controls", f"{where}/robot.controls.json")
            for file in ("robot.controls.json", "robot.glb"):
                clear()
                bpy.ops.import_scene.gltf(filepath=f"{where}/robot.glb")
                armature = next(o for o in bpy.data.objects if o.type == "ARMATURE")
                select([armature], armature)
                rest = matrices(armature)
                self.assertEqual(bpy.ops.sinew.controls(file=f"{where}/{file}"), {"FINISHED"})
                self.assertLess(largest(rest, matrices(armature)) / size_of(armature), 1e-3)
                self.assertIn("IK leg.L", control_rig.controls_of(armature).pose.bones)
            with self.assertRaisesRegex(RuntimeError, "has controls already"):
                bpy.ops.sinew.controls()
            # Of another skeleton, and no controls at all.
            _, _, skeleton, _ = common.read_character("snake__long")
            clear()
            other = add_armature(skeleton)
            select([other], other)
            objects = len(bpy.data.objects)
            with self.assertRaisesRegex(RuntimeError, "another skeleton"):
                bpy.ops.sinew.controls(file=f"{where}/robot.controls.json")
            with open(f"{where}/none.json", "w") as file:
                file.write("{}")
            with self.assertRaisesRegex(RuntimeError, "has no controls; expected a file"):
                bpy.ops.sinew.controls(file=f"{where}/none.json")
            self.assertEqual(len(bpy.data.objects), objects)

    def test_a_snake_has_no_limbs(self):
        clear()
        _, _, skeleton, _ = common.read_character("snake__long")
        armature = add_armature(skeleton)
        select([armature], armature)
        self.assertEqual(bpy.ops.sinew.controls(), {"FINISHED"})
        controls = control_rig.controls_of(armature)
        self.assertFalse([b.name for b in controls.data.bones if b.name.startswith("IK ")])
        bone = controls.pose.bones[skeleton.names[2]]
        bone.rotation_mode = "XYZ"
        before = matrices(armature)
        bone.rotation_euler = (0.5, 0, 0)
        changed(controls)
        self.assertGreater(largest(before, matrices(armature)), 0.01)


run(__name__)
