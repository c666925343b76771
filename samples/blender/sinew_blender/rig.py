# SPDX-License-Identifier: MIT
"""Rig: an armature for selected meshes, or the selected armature fitted into them."""
import re

import bpy
import numpy as np

from . import groups, scene, sinew
from .bind import attach, rounded
from .work import EngineOperator, Problem, thread_count


def blender_name(name):
    """LeftHandThumb1 -> HandThumb1.L, as Blender's mirroring wants it."""
    found = re.match(r"(Left|Right)(.+)$", name)
    return f"{found.group(2)}.{found.group(1)[0]}" if found else name


class SINEW_OT_rig(EngineOperator, bpy.types.Operator):
    """Make an armature for the selected meshes, or fit a selected armature into them"""

    bl_idname = "sinew.rig"
    bl_label = "Rig with sinew"
    bl_options = {"REGISTER", "UNDO"}
    label = "Rig"

    names: bpy.props.EnumProperty(name="Names", items=[("blender", "Arm.L", "Names for Blender's mirrored editing"),
                                                       ("sides", "LeftArm", "Names as in game engines")])
    spine: bpy.props.IntProperty(name="Spine", description="Bones between hips and neck, 0: as predicted", default=0, min=0, max=16)
    detail: bpy.props.EnumProperty(name="Detail", items=[("body", "Body", "Down to the hands"), ("hands", "Hands", "With fingers, where the mesh has them"),
                                                         ("full", "Full", "Also with eyes, a jaw and props in hands")])
    toes: bpy.props.BoolProperty(name="Toes", default=True)
    mirror: bpy.props.EnumProperty(name="Mirror", items=[("auto", "As the Mesh", ""), ("always", "Always", ""), ("never", "Never", "")])
    method: bpy.props.EnumProperty(name="Method", items=[("auto", "Automatic", "The network, with special cases for solid parts, flat figures and hands without a body"), ("votes", "Network", ""),
                                                         ("shape", "Middle Line", "For meshes unlike the training data")])
    bind: bpy.props.BoolProperty(name="Bind", description="Bind the meshes to the new armature as well", default=True)

    @classmethod
    def poll(cls, context):
        return any(o.type == "MESH" for o in context.selected_objects)

    def gather(self, context):
        meshes = sorted((o for o in context.selected_objects if o.type == "MESH"), key=lambda o: o.name)
        armatures = [o for o in context.selected_objects if o.type == "ARMATURE"]
        if len(armatures) > 1:
            raise Problem("select one armature to fit, or none for a new one; there are several")
        if armatures and armatures[0].data.library is not None:
            raise Problem(f"{armatures[0].name} is linked from another file; make it local first")
        if any(o.mode == "EDIT" for o in context.selected_objects):
            raise Problem("leave edit mode first")
        joined = scene.join(meshes)
        self.vertex_count = len(joined.positions)
        return joined, armatures[0] if armatures else None, scene.skeleton_of(armatures[0]) if armatures else None

    def compute(self, gathered, progress):
        joined, armature, skeleton = gathered
        with sinew.create(sinew.Character(joined.positions, joined.faces)) as one:
            own = None
            if armature is not None:
                skeleton.ends = np.array([not b.use_deform for b in armature.data.bones])
                own = sinew.create(sinew.Character(np.zeros((0, 3), np.float32), [], skeleton, name=armature.name))
            told = one.rig(method=self.method, detail=self.detail, mirror=self.mirror, spine=self.spine, toes=self.toes, up="z", bind=self.bind,
                           skeleton=own, threads=thread_count(self.vertex_count), progress=progress)
            found = one.skeleton
            found.ends = told.ends if own is None else None
            return told, found, rounded(one.skin, 4) if self.bind else None, one.notes

    def apply(self, context, gathered, result):
        joined, armature, skeleton = gathered
        told, found, skin, notes = result
        names = list(found.names) if armature is not None else [self._name(n) for n in found.names]
        warnings = "".join(f"; {note.removeprefix('warning: ')}" for note in notes if note.startswith("warning: "))
        if armature is not None:
            order = [found.index(n) for n in skeleton.names]
            move_bones(context, armature, skeleton, found.positions[order].astype(np.float64))
            self.report({"INFO"}, f"Rig: {armature.name} fitted, {told.matched} of {len(skeleton)} bones match the mesh{warnings}")
        else:
            armature = self._new_armature(context, joined, found)
            self.report({"INFO"}, f"Rig: {len(armature.data.bones)} bones{warnings}")
        meshes = [part.object for part in joined.parts]
        for one in list(context.selected_objects):
            one.select_set(False)
        for one in (*meshes, armature):
            one.select_set(True)
        context.view_layer.objects.active = armature
        if skin is None:
            return
        for part in joined.parts:
            own = slice(part.first, part.first + part.count)
            groups.write(part.object, names, skin.joints[own], skin.weights[own] / np.float32(255), np.ones(part.count, bool))
            attach(part.object, armature)

    def _name(self, name):
        return blender_name(str(name)) if self.names == "blender" else str(name)

    def _new_armature(self, context, joined, skeleton):
        data = bpy.data.armatures.new("Armature")
        armature = bpy.data.objects.new("Armature", data)
        (joined.parts[0].object.users_collection or (context.scene.collection,))[0].objects.link(armature)
        context.view_layer.objects.active = armature
        bpy.ops.object.mode_set(mode="EDIT")
        heads, tails, parents = bones_of(skeleton)
        made = {}
        for joint, parent in parents.items():
            bone = data.edit_bones.new(self._name(skeleton.names[joint]))
            bone.head, bone.tail = heads[joint], tails[joint]
            if parent >= 0:
                bone.parent = made[parent]
                bone.use_connect = bool(np.allclose(tails[parent], heads[joint], atol=1e-6))
            made[joint] = bone
        bpy.ops.object.mode_set(mode="OBJECT")
        return armature


def bones_of(skeleton):
    """Heads and tails [j, 3] and {joint: parent}: an end is its parent's tail and no bone. A bone points to the child that goes on
    the straightest, a leaf on as its parent does."""
    heads = skeleton.positions.astype(np.float64)
    ends = skeleton.ends if skeleton.ends is not None else np.zeros(len(skeleton), bool)
    size = np.ptp(heads, axis=0).max() or 1.0
    tails, parents = heads.copy(), {}
    for joint in skeleton.order():
        if ends[joint]:
            continue
        parent = int(skeleton.parents[joint])
        parents[joint] = parent
        children = np.flatnonzero(skeleton.parents == joint)
        ways = heads[children] - heads[joint]
        lengths = np.linalg.norm(ways, axis=1)
        before = heads[joint] - heads[parent] if parent >= 0 else np.array([0, 0, 1.0])
        before = before / max(np.linalg.norm(before), 1e-12)
        long = lengths > 1e-4 * size
        if long.any():
            straight = np.where(long, (ways @ before) / np.maximum(lengths, 1e-12), -2)
            tails[joint] = heads[children[straight.argmax()]]
        else:
            reach = 0.5 * np.linalg.norm(heads[joint] - heads[parent]) if parent >= 0 else 0
            tails[joint] = heads[joint] + before * max(reach, 0.03 * size)
    return heads, tails, parents


def _turn_between(a, b):
    """3x3 rotation times scale that brings vector a to b the shortest way."""
    la, lb = np.linalg.norm(a), np.linalg.norm(b)
    if la < 1e-12 or lb < 1e-12:
        return None
    u, v = a / la, b / lb
    cross, cosine = np.cross(u, v), float(u @ v)
    if cosine < -0.999999:
        return None
    k = np.array([[0, -cross[2], cross[1]], [cross[2], 0, -cross[0]], [-cross[1], cross[0], 0]])
    return (np.eye(3) + k + k @ k / (1 + cosine)) * lb / la


def move_bones(context, armature, skeleton, places):
    """Heads go to places of the world; tails keep their direction against the bone, rolls follow."""
    inside = np.linalg.inv(scene.world_of(armature))
    heads = scene.moved(places, inside)
    context.view_layer.objects.active = armature
    bpy.ops.object.mode_set(mode="EDIT")
    bones = [armature.data.edit_bones[name] for name in skeleton.names]
    old = np.array([bone.head for bone in bones], np.float64)
    tails = np.array([bone.tail for bone in bones], np.float64)
    rolls = [np.array(bone.z_axis, np.float64) for bone in bones]
    connected = [bone.use_connect for bone in bones]
    for bone in bones:
        bone.use_connect = False
    for joint, bone in enumerate(bones):
        children = np.flatnonzero(skeleton.parents == joint)
        gaps = np.linalg.norm(old[children] - tails[joint], axis=1)
        parent = skeleton.parents[joint]
        if len(children) and gaps.min() < 1e-4 * max(np.ptp(old, axis=0).max(), 1e-9):
            tail = heads[children[gaps.argmin()]]
        else:
            turned = None
            if len(children):
                turned = _turn_between(old[children[0]] - old[joint], heads[children[0]] - heads[joint])
            elif parent >= 0:
                turned = _turn_between(old[joint] - old[parent], heads[joint] - heads[parent])
            tail = heads[joint] + (turned if turned is not None else np.eye(3)) @ (tails[joint] - old[joint])
        if np.linalg.norm(tail - heads[joint]) < 1e-6:
            tail = heads[joint] + [0, 0, 1e-3]
        bone.head, bone.tail = heads[joint], tail
        turned = _turn_between(tails[joint] - old[joint], np.asarray(tail) - heads[joint])
        bone.align_roll((turned if turned is not None else np.eye(3)) @ rolls[joint])
    for bone, was in zip(bones, connected):
        bone.use_connect = was
    bpy.ops.object.mode_set(mode="OBJECT")


def register():
    bpy.utils.register_class(SINEW_OT_rig)


def unregister():
    bpy.utils.unregister_class(SINEW_OT_rig)
