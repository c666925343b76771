# SPDX-License-Identifier: MIT
"""Controls: legs and arms that hands and feet pull, rolling feet, a spine, a head, fingers that curl. What they move says the library
(formats/spec/controls.md); control_rig.py makes them of Blender's constraints."""
import json
import struct

import bpy
import numpy as np

from . import control_rig, retarget, scene, sinew
from .work import EngineOperator, Problem

_GLB, _JSON = 0x46546C67, 0x4E4F534A


def read_controls(path):
    """The controls of a .controls.json, or of the extras of a .glb or .gltf. Raises Problem."""
    try:
        with open(path, "rb") as file:
            content = file.read()
    except OSError as error:
        raise Problem(f"{path}: cannot be read, {error.strerror}") from None
    try:
        if len(content) >= 20 and struct.unpack_from("<I", content)[0] == _GLB:
            size, kind = struct.unpack_from("<II", content, 12)
            content = content[20:20 + size] if kind == _JSON else b""
        found = json.loads(content)
        found = found if "sinew_controls" in found else found.get("extras", {})["sinew_controls"]
        version = found["sinew_controls"]
    except (ValueError, KeyError, TypeError, AttributeError):
        raise Problem(f"{path}: has no controls; expected a file of sinew rig --controls") from None
    if version != 1:
        raise Problem(f"{path}: controls version {version}, expected 1; update the add-on")
    return found


def armature_of(context):
    """The armature that is meant: the active one, or that of the active mesh. Raises Problem."""
    item = context.object
    found = item if item is not None and item.type == "ARMATURE" else scene.armature_of(item) if item is not None else None
    if found is not None and control_rig.CONTROLS in found:
        found = found.parent
    if found is None:
        raise Problem("select an armature, or a mesh that is bound to one")
    return found


class SINEW_OT_controls(EngineOperator, bpy.types.Operator):
    """Add a control rig to the armature: IK for legs and arms, foot roll, and one bone each to rotate spine, head and fingers"""

    bl_idname = "sinew.controls"
    bl_label = "Add Controls"
    bl_options = {"REGISTER", "UNDO"}
    label = "Controls"

    file: bpy.props.StringProperty(name="File", description="File of sinew rig --controls, or a GLB with controls; empty: by names and positions of bones",
                                   subtype="FILE_PATH")

    @classmethod
    def poll(cls, context):
        return context.object is not None

    def gather(self, context):
        armature = armature_of(context)
        if control_rig.controls_of(armature) is not None:
            raise Problem(f"{armature.name} has controls already; bake them first")
        if armature.data.library is not None or armature.library is not None:
            raise Problem(f"{armature.name} is linked from another file; make it local first")
        path = bpy.path.abspath(self.file) if self.file else ""
        return armature, scene.skeleton_of(armature), path

    def compute(self, gathered, progress):
        _, skeleton, path = gathered
        if path:
            return read_controls(path)
        with sinew.create(sinew.Character(np.zeros((0, 3), np.float32), [], skeleton)) as one:
            return one.controls()

    def apply(self, context, gathered, result):
        armature, _, _ = gathered
        made, notes = control_rig.build(context, armature, result)
        notes = "".join(f"; {note}" for note in [*result.get("notes", []), *notes])
        self.report({"INFO"}, f"Controls: {made} for {armature.name}{notes}")


class SINEW_OT_bake_controls(bpy.types.Operator):
    """Bake the pose, or every frame of the controls' action, into the bones and remove the controls"""

    bl_idname = "sinew.bake_controls"
    bl_label = "Bake Controls"
    bl_options = {"REGISTER", "UNDO"}

    keep: bpy.props.BoolProperty(name="Keep Controls", description="Keep the controls without effect on the armature")

    @classmethod
    def poll(cls, context):
        return context.object is not None

    def execute(self, context):
        try:
            armature = armature_of(context)
            controls = control_rig.controls_of(armature)
            if controls is None:
                raise Problem(f"{armature.name} has no controls; add them first")
        except Problem as problem:
            self.report({"ERROR"}, f"Bake: {problem}")
            return {"CANCELLED"}
        if context.object is not armature:
            if context.object.mode != "OBJECT":
                bpy.ops.object.mode_set(mode="OBJECT")
            armature.select_set(True)
            context.view_layer.objects.active = armature
        frames, poses = control_rig.poses_of(context, armature, controls)
        control_rig.release(armature, controls, self.keep)
        self._write(armature, frames, poses)
        self.report({"INFO"}, f"Bake: {len(frames)} frames of {len(armature.pose.bones)} bones" if len(frames) > 1 else
                    f"Bake: the pose of {len(armature.pose.bones)} bones")
        return {"FINISHED"}

    @staticmethod
    def _write(armature, frames, poses):
        basis = {bone.name: [] for bone in armature.pose.bones}
        for pose in poses:
            for bone in armature.pose.bones:
                above = {} if bone.parent is None else {"parent_matrix": pose[bone.parent.name], "parent_matrix_local": bone.parent.bone.matrix_local}
                basis[bone.name].append(bone.bone.convert_local_to_pose(pose[bone.name], bone.bone.matrix_local, invert=True, **above))
        if len(frames) == 1:
            for bone in armature.pose.bones:
                bone.matrix_basis = basis[bone.name][0]
            return
        data = armature.animation_data_create()
        if data.action is not None:
            data.action.use_fake_user = True  # what was there is not lost
        made = data.action = bpy.data.actions.new(f"{armature.name} baked")
        for bone in armature.pose.bones:
            bone.rotation_mode = "QUATERNION"
            turns = np.array([b.to_quaternion() for b in basis[bone.name]])
            for f in range(1, len(turns)):  # the shorter way between frames
                if turns[f] @ turns[f - 1] < 0:
                    turns[f] = -turns[f]
            retarget._write(armature, made, bone, "rotation_quaternion", frames, turns)
            places = np.array([b.to_translation() for b in basis[bone.name]])
            if not bone.bone.use_connect and (bone.parent is None or np.abs(places).max() > 1e-6 * bone.length):
                retarget._write(armature, made, bone, "location", frames, places)


_CLASSES = (SINEW_OT_controls, SINEW_OT_bake_controls)


def register():
    for one in _CLASSES:
        bpy.utils.register_class(one)


def unregister():
    for one in reversed(_CLASSES):
        bpy.utils.unregister_class(one)
