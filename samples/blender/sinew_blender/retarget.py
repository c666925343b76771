# SPDX-License-Identifier: MIT
"""Retarget: the action of another armature on the active one; the map of their bones is shown and can be edited."""
import bpy
import numpy as np
from mathutils import Matrix, Quaternion, Vector

from . import scene, sinew
from .work import EngineOperator, Problem


class SINEW_PG_pair(bpy.types.PropertyGroup):
    """A bone of the target, and the source's bone that it moves as; empty: none."""

    target: bpy.props.StringProperty()
    source: bpy.props.StringProperty(name="Source")
    confidence: bpy.props.FloatProperty()


def chosen(context):
    """The target, which is active, and the source. Raises Problem."""
    target = context.object
    if target is None or target.type != "ARMATURE":
        raise Problem("select the armature with the motion, then the one that gets it last")
    sources = [o for o in context.selected_objects if o.type == "ARMATURE" and o != target]
    if len(sources) != 1:
        raise Problem("select one other armature with the motion" if not sources else "select one other armature, there are several")
    return target, sources[0]


def rig_of(armature):
    """Its skeleton with the bones' axes at rest in the world."""
    skeleton = scene.skeleton_of(armature)
    turns = [(armature.matrix_world @ bone.matrix_local).to_quaternion() for bone in armature.data.bones]
    skeleton.rotations = np.array([(q.x, q.y, q.z, q.w) for q in turns], np.float32)
    return skeleton


def up_of(armature):
    """"z" for an armature that stands in the scene; "auto", which is found from its legs, for one that lies or hangs in it: a z-up BVH
    that was imported as the y-up that most are."""
    skeleton = scene.skeleton_of(armature)
    names = [sinew.CLASSES[c] for c in sinew.joint_classes(skeleton, "auto")]
    places = skeleton.positions.astype(np.float64)
    upper = [j for j, n in enumerate(names) if n in ("neck", "head")]
    lower = [j for j, n in enumerate(names) if n in ("calf", "foot", "toe")]
    if not upper or not lower:
        return "z"
    up = places[upper].mean(0) - places[lower].mean(0)
    return "z" if up[2] > 0.3 * np.linalg.norm(up) else "auto"


def find_map(target, source):
    return sinew.map(scene.skeleton_of(target), scene.skeleton_of(source), target_up=up_of(target), source_up=up_of(source))


class SINEW_OT_map(bpy.types.Operator):
    """Match the bones of the active armature to those of the other selected one, for review and editing"""

    bl_idname = "sinew.map_bones"
    bl_label = "Map Bones"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        try:
            target, source = chosen(context)
            found = find_map(target, source)
        except (Problem, ValueError, sinew.Error) as error:
            self.report({"ERROR"}, f"Map: {error}")
            return {"CANCELLED"}
        scene_ = context.scene
        scene_.sinew_map.clear()
        scene_.sinew_map_target, scene_.sinew_map_source = target, source
        for bone, joint, sure in zip(target.data.bones, found.sources, found.confidence):
            pair = scene_.sinew_map.add()
            pair.target, pair.confidence = bone.name, float(sure)
            pair.source = source.data.bones[joint].name if joint >= 0 else ""
        doubt = "; the front is uncertain, so left and right may be exchanged; check the map" if found.certainty < 0.5 else ""
        self.report({"INFO"}, f"Map: {int((found.sources >= 0).sum())} of {len(found.sources)} bones have a source{doubt}")
        return {"FINISHED"}


class SINEW_OT_retarget(EngineOperator, bpy.types.Operator):
    """Retarget the action of the other selected armature to the active one, as a new action"""

    bl_idname = "sinew.retarget"
    bl_label = "Retarget with sinew"
    bl_options = {"REGISTER", "UNDO"}
    label = "Retarget"

    hold_feet: bpy.props.BoolProperty(name="Hold Feet", description="Keep planted feet in place; needs a bound mesh", default=True)
    in_place: bpy.props.BoolProperty(name="In Place", description="Keep the character above its rest position")

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.type == "ARMATURE"

    def gather(self, context):
        target, source = chosen(context)
        action = source.animation_data.action if source.animation_data else None
        if action is None:
            raise Problem(f"{source.name} has no action to retarget")
        first, last = (int(round(f)) for f in action.frame_range)
        if last < first:
            raise Problem(f"{action.name} has no frames")
        rigs = rig_of(source), rig_of(target)
        joints = self._joints(context, target, source)
        clip = self._clip(context, source, rigs[0], first, last)
        body = self._body(context, target, rigs[1]) if self.hold_feet else None
        self.vertex_count = 0 if body is None else len(body.positions)
        return target, rigs, clip, joints, body, action, first, (up_of(source), up_of(target))

    @staticmethod
    def _joints(context, target, source):
        """[target bones] of the edited map, or of a new one."""
        scene_ = context.scene
        if scene_.sinew_map_target != target or scene_.sinew_map_source != source or not len(scene_.sinew_map):
            return find_map(target, source)
        numbers = {bone.name: i for i, bone in enumerate(source.data.bones)}
        said = {}
        for pair in scene_.sinew_map:
            if pair.source and pair.source not in numbers:
                raise Problem(f"the map names {pair.source}, and {source.name} has no such bone")
            said[pair.target] = numbers.get(pair.source, -1)
        return np.array([said.get(bone.name, -1) for bone in target.data.bones], np.int32)

    @staticmethod
    def _clip(context, source, rig, first, last):
        frames = last - first + 1
        worlds = np.empty((frames, len(rig), 4, 4))
        now, part = context.scene.frame_current, context.scene.frame_subframe
        try:
            for f in range(frames):
                context.scene.frame_set(first + f)
                evaluated = source.evaluated_get(context.evaluated_depsgraph_get())
                for j, name in enumerate(rig.names):
                    worlds[f, j] = evaluated.matrix_world @ evaluated.pose.bones[name].matrix
        finally:
            context.scene.frame_set(now, subframe=part)
        rotations, translations = np.empty((frames, len(rig), 4)), np.empty((frames, len(rig), 3))
        for j, parent in enumerate(rig.parents):
            pose = worlds[:, j] if parent < 0 else np.linalg.inv(_rigid(worlds[:, parent])) @ _rigid(worlds[:, j])
            for f in range(frames):
                q = Matrix(pose[f]).to_quaternion()
                rotations[f, j] = q.x, q.y, q.z, q.w
            translations[:, j] = pose[:, :3, 3]
        fps = context.scene.render.fps / context.scene.render.fps_base
        return sinew.Clip(rotations, translations, fps, "retargeted")

    @staticmethod
    def _body(context, target, rig):
        found = body_of(sorted((o for o in context.scene.objects if o.type == "MESH" and scene.armature_of(o) == target), key=lambda o: o.name), rig)
        return None if found is None else found[0]

    def compute(self, gathered, progress):
        _, (source, target), clip, joints, body, _, _, (source_up, target_up) = gathered
        return sinew.retarget(clip, source, target, joint_map=joints, in_place=self.in_place, source_up=source_up, target_up=target_up,
                              target_body=body, progress=progress)

    def apply(self, context, gathered, clip):
        target, (_, rig), _, joints, _, action, first, _ = gathered
        basis = _basis(target, rig, clip)
        made = bpy.data.actions.new(f"{action.name} on {target.name}")
        data = target.animation_data_create()
        if data.action is not None:
            data.action.use_fake_user = True  # what was there is not lost
        data.action = made
        size = max(float(np.ptp(rig.positions, axis=0).max()), 1e-9)
        frames = first + np.arange(len(clip.rotations))
        for j, name in enumerate(rig.names):
            bone = target.pose.bones[name]
            bone.rotation_mode = "QUATERNION"
            turns, places = basis[j]
            _write(target, made, bone, "rotation_quaternion", frames, turns)
            moves = np.abs(places).max() > 1e-4 * size and not target.data.bones[name].use_connect
            if rig.parents[j] < 0 or moves:
                _write(target, made, bone, "location", frames, places)
        sources = joints.sources if isinstance(joints, sinew.JointMap) else joints
        self.report({"INFO"}, f"Retarget: {made.name}, {len(frames)} frames, {int((np.asarray(sources) >= 0).sum())} of {len(rig)} bones move")


def body_of(meshes, rig):
    """(sinew.Character, scene.JoinedMesh) of meshes with weights of these bones; None where none has any."""
    weights = [scene.weights_of(o, list(rig.names)) for o in meshes]
    meshes = [m for m, w in zip(meshes, weights) if w.any()]
    if not meshes:
        return None
    dense = np.concatenate([w for w in weights if w.any()])
    joined = scene.join(meshes)
    order = np.argsort(-dense, axis=1, kind="stable")[:, :4]
    rows = np.take_along_axis(dense, order, 1)
    rows[rows.sum(1) == 0, 0] = 1  # the engine wants a full row
    own = [b[(b < joined.own).all(1)] for b in joined.faces]
    return sinew.Character(joined.positions[:joined.own], own, rig, sinew.Skin(order.astype(np.uint16), rows)), joined


def _rigid(matrices):
    """Without scale and shear."""
    out = matrices.copy()
    out[..., :3, :3] /= np.maximum(np.linalg.norm(out[..., :3, :3], axis=-2, keepdims=True), 1e-12)
    return out


def _basis(target, rig, clip):
    """[(rotations [t, 4] w x y z, locations [t, 3])] of every bone against its rest."""
    frames = len(clip.rotations)
    inside = target.matrix_world.inverted()
    rest = [Matrix(bone.matrix_local) for bone in target.data.bones]
    out = [(np.empty((frames, 4)), np.empty((frames, 3))) for _ in rest]
    order = rig.order()
    for f in range(frames):
        world, pose = {}, {}
        for j in order:
            x, y, z, w = (float(v) for v in clip.rotations[f, j])
            own = Matrix.Translation(Vector(clip.translations[f, j].tolist())) @ Quaternion((w, x, y, z)).to_matrix().to_4x4()
            parent = rig.parents[j]
            world[j] = own if parent < 0 else world[parent] @ own
            place, turn, _ = (inside @ world[j]).decompose()
            pose[j] = Matrix.Translation(place) @ turn.to_matrix().to_4x4()
            local = rest[j] if parent < 0 else rest[parent].inverted() @ rest[j]
            base = local if parent < 0 else pose[parent] @ local
            place, turn, _ = (base.inverted() @ pose[j]).decompose()
            before = out[j][0][f - 1] if f else (1, 0, 0, 0)
            sign = -1 if sum(a * b for a, b in zip(turn, before)) < 0 else 1
            out[j][0][f], out[j][1][f] = [sign * v for v in turn], place
    return out


def _write(target, action, bone, path, frames, values):
    """Keys of one channel in an action."""
    full = bone.path_from_id(path)
    if not hasattr(action, "fcurves"):  # actions with slots
        for frame, value in zip(frames, values):
            setattr(bone, path, value)
            target.keyframe_insert(full, frame=int(frame), group=bone.name)
        return
    for index in range(values.shape[1]):
        curve = action.fcurves.new(full, index=index, action_group=bone.name)
        curve.keyframe_points.add(len(frames))
        curve.keyframe_points.foreach_set("co", np.stack([frames, values[:, index]], 1).astype(np.float32).ravel())
        curve.update()


_CLASSES = (SINEW_PG_pair, SINEW_OT_map, SINEW_OT_retarget)


def register():
    for one in _CLASSES:
        bpy.utils.register_class(one)
    bpy.types.Scene.sinew_map = bpy.props.CollectionProperty(type=SINEW_PG_pair)
    bpy.types.Scene.sinew_map_target = bpy.props.PointerProperty(type=bpy.types.Object)
    bpy.types.Scene.sinew_map_source = bpy.props.PointerProperty(type=bpy.types.Object)


def unregister():
    del bpy.types.Scene.sinew_map_source
    del bpy.types.Scene.sinew_map_target
    del bpy.types.Scene.sinew_map
    for one in reversed(_CLASSES):
        bpy.utils.unregister_class(one)
