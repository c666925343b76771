# SPDX-License-Identifier: MIT
"""Rig: an armature for selected meshes, or the selected armature fitted into them."""
import re

import bpy
import numpy as np

from . import groups, scene, sinew
from .bind import attach
from .work import EngineOperator, Problem, thread_count


def blender_name(name):
    """LeftHandThumb1 -> HandThumb1.L, as Blender's mirroring wants it."""
    found = re.match(r"(Left|Right)(.+)$", name)
    return f"{found.group(2)}.{found.group(1)[0]}" if found else name


class SINEW_OT_rig(EngineOperator, bpy.types.Operator):
    """An armature for the selected meshes; or, with an armature selected too, that one fitted into them"""

    bl_idname = "sinew.rig"
    bl_label = "Rig with sinew"
    bl_options = {"REGISTER", "UNDO"}
    label = "Rig"

    names: bpy.props.EnumProperty(name="Names", items=[("blender", "Arm.L", "For Blender's mirrored editing"),
                                                       ("sides", "LeftArm", "As game engines have them")])
    spine: bpy.props.IntProperty(name="Spine", description="Bones between hips and neck, 0: as predicted", default=0, min=0, max=16)
    fingers: bpy.props.BoolProperty(name="Fingers", description="Where the mesh shows any")
    face: bpy.props.BoolProperty(name="Face", description="Eyes that are balls of their own, and a jaw")
    props: bpy.props.BoolProperty(name="Props", description="A bone for what hands hold, where it is a loose part")
    toes: bpy.props.BoolProperty(name="Toes", default=True)
    mirror: bpy.props.EnumProperty(name="Mirror", items=[("auto", "As the Mesh", ""), ("always", "Always", ""), ("never", "Never", "")])
    method: bpy.props.EnumProperty(name="Method", items=[("votes", "Network", ""), ("shape", "Middle Line", "For what no model knows")])
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
        found = sinew.rig(joined.positions, joined.faces, up="z", method=self.method, mirror=self.mirror, spine=self.spine,
                          toes=self.toes, fingers=self.fingers and self.method == "votes", face=self.face, props=self.props,
                          progress=lambda share: progress(share / 2 if self.bind else share))
        if armature is None:
            heads, _, parents = bones_of(found.skeleton)
            number = {joint: i for i, joint in enumerate(parents)}
            names = [self._name(found.skeleton.names[j]) for j in parents]
            bones = sinew.Skeleton(heads[list(parents)], [number.get(p, -1) for p in parents.values()], names)
            never = []
        else:
            bones = sinew.Skeleton(fitted(skeleton, found.skeleton), skeleton.parents, skeleton.names)
            never = [b.name for b in armature.data.bones if not b.use_deform]
        skin = None
        if self.bind:
            skin = sinew.bind(joined.positions, joined.faces, bones, weight_format="unorm8", up="z", never=never,
                              threads=thread_count(self.vertex_count), progress=lambda share: progress(0.5 + share / 2))
        return found, bones, skin

    def apply(self, context, gathered, result):
        joined, armature, skeleton = gathered
        found, bones, skin = result
        if armature is not None:
            move_bones(context, armature, skeleton, bones.positions.astype(np.float64))
            self.report({"INFO"}, f"Rig: {armature.name} fitted, {len(skeleton)} bones")
        else:
            armature = self._new_armature(context, joined, found.skeleton)
            doubt = "; the mesh resembles nothing that the model knows, look at it" if found.spread > 0.08 else ""
            self.report({"INFO"}, f"Rig: {len(armature.data.bones)} bones{doubt}")
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
            groups.write(part.object, list(bones.names), skin.joints[own], skin.weights[own] / np.float32(255), np.ones(part.count, bool))
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


def fitted(skeleton, predicted):
    """Places [j, 3] of a skeleton's joints in a mesh: those with a counterpart in the predicted skeleton go there, others between
    and beyond them as they lay. Raises Problem."""
    found = sinew.map(skeleton, predicted, target_up="z", source_up="z")
    mapped = found.sources >= 0
    if mapped.sum() < 2:
        raise Problem("too few bones have a counterpart in the mesh; rig it without the armature selected")
    old, new = skeleton.positions.astype(np.float64), skeleton.positions.astype(np.float64).copy()
    new[mapped] = predicted.positions[found.sources[mapped]]
    spread = [np.linalg.norm(p[mapped] - p[mapped].mean(0), axis=1).mean() for p in (old, new)]
    turns = np.tile(np.eye(3) * spread[1] / max(spread[0], 1e-12), (len(skeleton), 1, 1))
    order = skeleton.order()
    below = np.full(len(skeleton), -1)  # the nearest mapped joint at or below
    for joint in reversed(order):
        if mapped[joint]:
            below[joint] = joint
        parent = skeleton.parents[joint]
        if parent >= 0 and below[parent] < 0:
            below[parent] = below[joint]
    roots = [j for j in order if skeleton.parents[j] < 0]
    for root in roots:
        if not mapped[root]:
            target = below[root] if below[root] >= 0 else int(np.flatnonzero(mapped)[0])
            new[root] = new[target] + turns[root] @ (old[root] - old[target])
    for joint in order:
        parent = skeleton.parents[joint]
        if parent < 0:
            continue
        end = below[joint]
        turned = None if end < 0 else _turn_between(old[end] - old[parent], new[end] - new[parent])
        turns[joint] = turned if turned is not None else turns[parent]
        if not mapped[joint]:
            new[joint] = new[parent] + turns[joint] @ (old[joint] - old[parent])
    return new


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
