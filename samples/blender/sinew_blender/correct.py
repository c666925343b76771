# SPDX-License-Identifier: MIT
"""Correct bends: shape keys with drivers that restore the volume that linear blending loses where bones bend."""
import math
from dataclasses import dataclass

import bpy
import numpy as np

from . import retarget, scene, sinew
from .work import EngineOperator, Problem

PREFIX = "sinew bend "
# Limbs, whose joints bend far; classes of sinew.CLASSES.
_LIMBS = ("upper-arm", "forearm", "thigh", "calf")
_AXES = {"X": (1, 0, 0), "Z": (0, 0, 1)}  # of the bone; it lies along its Y


@dataclass
class Bend:
    """A pose: one bone turned about one of its own axes. The key is full there, and driven by the bone's swing."""

    joint: int
    bone: str
    axis: str
    sign: int

    @property
    def name(self):
        return f"{PREFIX}{self.bone} {'+' if self.sign > 0 else '-'}{self.axis}"


class SINEW_OT_correct(EngineOperator, bpy.types.Operator):
    """Add shape keys, driven by the bones, that keep the volume of bends: for the selected bones, or for arms and legs"""

    bl_idname = "sinew.correct"
    bl_label = "Correct Bends"
    bl_options = {"REGISTER", "UNDO"}
    label = "Correct bends"

    angle: bpy.props.FloatProperty(name="Angle", description="Angle of the bend at which a key is full", default=math.radians(90), min=math.radians(20),
                                   max=math.radians(150), subtype="ANGLE")
    axes: bpy.props.EnumProperty(name="Axes", description="Bend axes of the bones, whose length is along Y", default="X",
                                 items=[("X", "X", "Both directions about X"), ("Z", "Z", "Both directions about Z"), ("XZ", "X and Z", "All four directions")])
    only_selected_bones: bpy.props.BoolProperty(name="Selected Bones Only")

    @classmethod
    def poll(cls, context):
        return any(o.type == "MESH" for o in context.selected_objects) or (context.object is not None and context.object.type == "MESH")

    def gather(self, context):
        meshes, armature = scene.chosen(context)
        rig = retarget.rig_of(armature)
        bones = [j for j, bone in enumerate(armature.data.bones) if scene.is_selected(armature, bone)]
        if not self.only_selected_bones:
            classes = sinew.joint_classes(rig, retarget.up_of(armature))
            bones = [j for j in range(len(rig)) if sinew.CLASSES[classes[j]] in _LIMBS]
        if not bones:
            raise Problem("Selected Bones Only, and no bone is selected" if self.only_selected_bones else
                          "no bone is known as one of an arm or leg; select bones in pose mode and tick Selected Bones Only")
        tasks, shared = [], {}
        for item in meshes:
            if item.mode == "EDIT":
                raise Problem("leave edit mode first")
            if any(m.type == "ARMATURE" and m.object == armature and m.use_deform_preserve_volume for m in item.modifiers):
                raise Problem(f"{item.name}: switch off Preserve Volume of its armature modifier; keys correct linear blending")
            if item.data in shared:
                raise Problem(f"{item.name} and {shared[item.data]} share one mesh, whose keys would be of both; make it a single user")
            shared[item.data] = item.name
            weights = scene.weights_of(item, list(rig.names))
            if not weights.any():
                raise Problem(f"{item.name} has no weights of {armature.name}'s bones; bind it first, or do not select it")
            moving = [j for j in bones if self.only_selected_bones or weights[:, j].any()]
            bends = [Bend(j, rig.names[j], axis, sign) for j in moving for axis in self.axes for sign in (1, -1)]
            tasks.append((item, scene.join([item]), weights, bends))
        if not any(bends for *_, bends in tasks):
            raise Problem("no bone of an arm or leg has weight here; select bones in pose mode and tick Selected Bones Only")
        self.vertex_count = sum(joined.own for _, joined, _, _ in tasks)
        return armature, rig, tasks

    def compute(self, gathered, progress):
        _, rig, tasks = gathered

        def step(i):
            return lambda share: progress((i + share) / len(tasks))

        return [self._deltas(rig, *task, step(i)) for i, task in enumerate(tasks)]

    def _deltas(self, rig, item, joined, weights, bends, progress):
        """What the key of each bend adds to the mesh, [n, 3] in the object's space."""
        positions = joined.positions[:joined.own]
        faces = [b[(b < joined.own).all(1)] for b in joined.faces]
        order = np.argsort(-weights, axis=1, kind="stable")[:, :sinew.binding.MAX_INFLUENCES]
        rows = np.take_along_axis(weights, order, 1)
        bare = rows.sum(1) == 0
        rows[bare, 0] = 1
        skin = sinew.Skin(order.astype(np.uint16), rows).rounded(order.shape[1])
        deformer = sinew.Deformer(positions, faces, rig, skin)
        linear = sinew.Deformer(positions, faces, rig, skin, method="linear")
        dense = skin.dense(len(rig)).astype(np.float64)
        inside = np.linalg.inv(scene.world_of(item)[:3, :3])
        size = float(np.ptp(positions, axis=0).max())
        rest, _ = rig.rest()
        out = []
        for i, bend in enumerate(bends):
            if progress(i / len(bends)):
                raise sinew.Cancelled("stopped")
            turned = rest.copy()
            half = bend.sign * self.angle / 2
            own = np.array([*(math.sin(half) * a for a in _AXES[bend.axis]), math.cos(half)])
            turned[bend.joint] = sinew.multiply(rest[bend.joint], own)
            matrices = rig.matrices(turned)
            moved = deformer.pose(matrices).astype(np.float64) - linear.pose(matrices)
            blended = np.einsum("nj,jab->nab", dense, matrices[:, :, :3].astype(np.float64))
            # Where blending flattens the surface there is no way back; what is left of it is not blown up.
            u, s, v = np.linalg.svd(blended)
            delta = np.einsum("nba,nb->na", v, np.einsum("nba,nb->na", u, moved) / np.maximum(s, 0.25))
            delta[bare | (np.linalg.norm(delta, axis=1) < 1e-4 * size)] = 0
            out.append(delta @ inside.T)
        return out

    def apply(self, context, gathered, results):
        armature, _, tasks = gathered
        made = sum(self._write(item, armature, bends, deltas) for (item, _, _, bends), deltas in zip(tasks, results))
        bones = {b.bone for _, _, _, bends in tasks for b in bends}
        where = "" if len(tasks) == 1 else f" in {len(tasks)} meshes"
        self.report({"INFO"}, f"Correct bends: {made} keys for {len(bones)} bones{where}, full at {math.degrees(self.angle):.0f} degrees")

    def _write(self, item, armature, bends, deltas):
        """Keys with their drivers; how many."""
        basis = scene.rest_positions(item)
        if item.data.shape_keys is None:
            item.shape_key_add(name="Basis", from_mix=False)
        active, made = item.active_shape_key_index, 0
        for bend, delta in zip(bends, deltas):
            key = item.data.shape_keys.key_blocks.get(bend.name)
            if not np.any(delta):
                if key is not None:
                    item.shape_key_remove(key)
                continue
            if key is None:
                key = item.shape_key_add(name=bend.name, from_mix=False)
            key.data.foreach_set("co", (basis + delta).astype(np.float32).ravel())
            key.driver_remove("value")
            driver = key.driver_add("value").driver
            driver.type = "SCRIPTED"
            variable = driver.variables.new()
            variable.name, variable.type = "swing", "TRANSFORMS"
            target = variable.targets[0]
            target.id, target.bone_target = armature, bend.bone
            target.transform_type, target.transform_space, target.rotation_mode = f"ROT_{bend.axis}", "LOCAL_SPACE", "SWING_TWIST_Y"
            driver.expression = f"min(max(swing / {bend.sign * self.angle:.6f}, 0), 1)"
            made += 1
        item.active_shape_key_index = active
        item.data.update()
        return made


def register():
    bpy.utils.register_class(SINEW_OT_correct)


def unregister():
    bpy.utils.unregister_class(SINEW_OT_correct)
