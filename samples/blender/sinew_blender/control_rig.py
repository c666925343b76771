# SPDX-License-Identifier: MIT
"""A control rig beside an armature, which follows it bone by bone. Of every joint there is a bone of its name, which turns it by hand (FK); a
bone `follow NAME` at rest as the joint's own is, which the armature copies; and what pulls or turns several of them: `IK leg.L`, `pole leg.L`,
`turn spine`, `turn head`, `curl index.L`. The armature itself gets a constraint a bone and nothing else."""
import math

import bpy
import numpy as np
from mathutils import Matrix, Quaternion, Vector

from .control_shapes import LAYERS, lay_out
from .work import Problem

CONTROLS = "sinew_controls"  # property of the controls' object
CONSTRAINT = "sinew controls"
_BALL_DEGREES = 45  # the ball lifts the heel so far, then the foot goes onto its tip
_PRE_BEND = math.radians(1)  # of a straight limb: says the solver to which side it bends


def controls_of(armature):
    """The object of an armature's controls, or None."""
    for bone in armature.pose.bones:
        one = bone.constraints.get(CONSTRAINT)
        if one is not None and one.target is not None:
            return one.target
    return None


def label(kind, name):
    """IK leg.L of "leg.left", as Blender's mirroring wants it."""
    words = name.split(".")
    side = ".L" if "left" in words else ".R" if "right" in words else ""
    return f"{kind} {'.'.join(w for w in words if w not in ('left', 'right'))}{side}"


def fit(controls, armature):
    """3x3 rotation from the directions of controls to the armature's own space, by joints of the same name. Raises Problem."""
    bones = armature.data.bones
    pairs = [(joint["name"], joint["position"], bones[joint["name"]].head_local) for joint in controls["joints"] if joint["name"] in bones]
    if len(pairs) < 3:
        raise Problem(f"the controls belong to another skeleton: {len(pairs)} of their {len(controls['joints'])} joints are bones of {armature.name}")
    theirs = np.array([p for _, p, _ in pairs], np.float64)
    own = np.array([tuple(p) for _, _, p in pairs], np.float64)
    theirs, own = theirs - theirs.mean(0), own - own.mean(0)
    u, s, v = np.linalg.svd(theirs.T @ own)
    flip = np.diag([1, 1, np.sign(np.linalg.det(u @ v))])
    turn = v.T @ flip @ u.T
    scale = (s * np.diag(flip)).sum() / max((theirs ** 2).sum(), 1e-30)
    off = np.linalg.norm(scale * theirs @ turn.T - own, axis=1)
    size = max(np.ptp(own, axis=0).max(), 1e-9)
    if off.max() > 0.02 * size:
        raise Problem(f"the controls belong to another rest pose: {pairs[int(off.argmax())][0]} lies {100 * off.max() / size:.0f} % of the size apart")
    return turn


class _Builder:
    def __init__(self, armature, controls, turn):
        self.armature, self.controls, self.turn = armature, controls, turn
        self.up = self.direction(controls["up"])
        self.front = self.direction(controls["front"])
        self.rest = {bone.name: bone.matrix_local.copy() for bone in armature.data.bones}
        self.head = {bone.name: bone.head_local.copy() for bone in armature.data.bones}
        self.tail = {bone.name: bone.tail_local.copy() for bone in armature.data.bones}
        self.parent = {bone.name: bone.parent.name if bone.parent else None for bone in armature.data.bones}
        self.size = max(max((a - b).length for a in self.head.values() for b in list(self.head.values())[:1]), 1e-6)
        self.later, self.notes, self.made = [], [], 0  # what wants pose bones

    def direction(self, vector):
        return Vector(self.turn @ np.array(vector, np.float64))

    # ---- bones, in edit mode

    def bone(self, name, head, tail, z=None, parent=None, layer="Mechanism", like=None):
        """An edit bone; its name, which is another where a joint has it."""
        bone = self.bones.new(name)
        bone.head, bone.tail = head, tail
        if like is not None:
            bone.matrix = like  # keeps the length
        elif z is not None and z.length > 0:
            bone.align_roll(z)
        bone.parent = self.bones[parent] if parent else None
        bone.use_deform = bone.use_connect = False
        self.layers[layer].append(bone.name)
        return bone.name

    def like_joint(self, name, joint, parent, layer="Mechanism"):
        """A bone that is at rest as the joint's FK bone is."""
        own = self.bones[joint]
        return self.bone(name, own.head, own.tail, own.z_axis.copy(), parent, layer)

    def joints(self):
        """FK bones. Of a limb they point to its next joint, of all others as the armature's do."""
        tails = {}
        for limb in self.limbs:
            upper, middle, end = limb["joints"][0], limb["middle"], limb["joints"][-1]
            tails[upper], tails[middle] = self.head[middle], self.head[end]
            if limb["ball"]:
                tails[end] = self.head[limb["ball"]]
        for name in self.order():
            parent = self.parent[name] or self.root
            if name in tails and (tails[name] - self.head[name]).length > 1e-4 * self.size:
                self.bone(name, self.head[name], tails[name], self.front if abs(self.front.dot((tails[name] - self.head[name]).normalized())) < 0.9
                          else self.up, parent, "FK")
            else:
                self.bone(name, self.head[name], self.tail[name], None, parent, "FK", like=self.rest[name])
        for name in self.order():
            follow = self.bone(f"follow {name}", self.head[name], self.tail[name], None, name, like=self.rest[name])
            self.follow[name] = follow

    def order(self):
        """Joints, parents first."""
        def depth(name):
            return 0 if self.parent[name] is None else 1 + depth(self.parent[name])
        return sorted(self.head, key=depth)

    def add_limb(self, limb):
        upper, middle, end = limb["joints"][0], limb["middle"], limb["joints"][-1]
        at = [self.head[name] for name in (upper, middle, end)]
        reach = (at[1] - at[0]).length + (at[2] - at[1]).length
        pole = self.direction(limb["pole"])
        z = pole if pole.length > 0 else self.front
        parent = self.parent[upper] or self.root
        first = self.like_joint(f"ik {upper}", upper, parent)
        second = self.like_joint(f"ik {middle}", middle, first)
        control = self.foot(limb, reach) if limb["kind"] == "leg" else self.like_joint(label("IK", limb["name"]), end, self.root, "Controls")
        target = self.foot_target if limb["kind"] == "leg" else control
        pulled = None
        if pole.length > 0:
            place = at[1] + pole.normalized() * reach
            pulled = self.bone(label("pole", limb["name"]), place, place + z.normalized() * 0.1 * reach, self.up, self.root, "Controls")
        straight = (at[1] - at[0]).normalized().dot((at[2] - at[1]).normalized()) > math.cos(math.radians(3))
        self.made += 1
        self.later.append(lambda pose: self.constrain_limb(pose, limb, first, second, control, target, pulled, pole if straight else None))

    def foot(self, limb, reach):
        """The control of a foot, with pivots of heel, tip and ball above its target where it rolls."""
        end, ball = limb["joints"][-1], limb["ball"]
        ankle = self.head[end]
        flat = (self.head[ball] if ball else self.tail[end]) - ankle
        flat -= flat.dot(self.up) * self.up
        if flat.length < 1e-3 * reach:
            flat = (self.front if self.front.length > 0 else Vector((0, -1, 0))) * 0.2 * reach
        along = flat.normalized()
        control = self.bone(label("IK", limb["name"]), ankle, ankle + along * 0.25 * reach, self.up, self.root, "Controls")
        if not ball:
            self.foot_target = self.like_joint(label("target", limb["name"]), end, control)
            return control
        floor = min(self.up.dot(ankle), self.up.dot(self.head[ball]))

        def pivot(word, place, parent):
            place = place - (self.up.dot(place) - floor) * self.up
            return self.bone(label(word, limb["name"]), place, place + along * 0.1 * reach, self.up, parent)

        toe = (self.tail[ball] - self.head[ball]).dot(along)
        heel = pivot("heel", ankle - 0.25 * flat, control)
        tip = pivot("tip", self.head[ball] + along * max(toe, 0.4 * flat.length), heel)
        lift = self.bone(label("ball", limb["name"]), self.head[ball], self.head[ball] + along * 0.1 * reach, self.up, tip)
        self.foot_target = self.like_joint(label("target", limb["name"]), end, lift)
        toes = self.like_joint(label("toes", limb["name"]), ball, tip)
        self.later.append(lambda pose: self.constrain_foot(pose, control, ball, toes, heel, tip, lift))
        return control

    def add_turn(self, word, joints):
        """One bone that turns several, each by its share."""
        first, last = joints[0], joints[-1]
        parent = self.parent[first] or self.root
        way = self.head[last] - self.head[first]
        if len(joints) == 1 or way.length < 1e-4 * self.size:
            way = self.up * 0.1 * self.size
        place = self.head[last] if word == "head" else self.head[first]
        name = self.bone(label("turn", word), place, place + way.normalized() * 0.15 * self.size, self.front, parent, "Controls")
        self.made += 1

        def constrain(pose):
            for joint in joints:
                self.copy_turn(pose[joint], name, 1 / len(joints))
        self.later.append(constrain)

    def add_finger(self, finger):
        joints = finger["joints"]
        axis = self.direction(finger["axis"])
        if axis.length < 0.5:
            self.notes.append(f"{finger['name']}: nothing tells how it curls")
            return
        first = joints[0]
        parent = self.parent[first] or self.root
        way = self.head[joints[-1]] - self.head[first] if len(joints) > 1 else self.tail[first] - self.head[first]
        way -= way.dot(axis) * axis
        length = max(way.length, 1e-3 * self.size)
        place, z = self.head[first], axis.cross(way)
        name = self.bone(label("curl", finger["name"]), place, place + way.normalized() * length, z, parent, "Controls")
        arm = next((limb for limb in self.limbs if limb["kind"] == "arm" and limb["joints"][-1] == finger["hand"]), None)
        fist = self.bone(label("fist", finger["name"]), place, place + way.normalized() * length, z, parent) if arm else None
        self.made += 1

        def constrain(pose):
            for joint in joints:
                for source in (fist, name):
                    if source is not None:
                        self.copy_turn(pose[joint], source, 1)
            if fist is not None:
                control = label("IK", arm["name"])
                own_property(pose[control], "curl", 0, -20, 90, "Bend of each joint of the finger, in degrees")
                pose[fist].rotation_mode = "XYZ"
                self.drive(pose[fist], "rotation_euler", 0, control, "curl", f"curl * {math.pi / 180:.9f}")
        self.later.append(constrain)

    # ---- constraints, in pose mode

    def copy_turn(self, bone, source, influence):
        one = bone.constraints.new("COPY_ROTATION")
        one.target, one.subtarget = self.object, source
        one.target_space, one.owner_space, one.mix_mode = "LOCAL_OWNER_ORIENT", "LOCAL", "AFTER"
        one.influence = influence

    def copy(self, kind, bone, source, control):
        """The bone goes where another is, as far as its limb is not turned by hand."""
        one = bone.constraints.new(kind)
        one.target, one.subtarget = self.object, source
        self.drive(one, "influence", -1, control, "FK", "1 - FK")

    def drive(self, owner, path, index, control, name, expression):
        driver = (owner.driver_add(path, index) if index >= 0 else owner.driver_add(path)).driver
        driver.type = "SCRIPTED"
        variable = driver.variables.new()
        variable.name, variable.type = name, "SINGLE_PROP"
        variable.targets[0].id = self.object
        variable.targets[0].data_path = f'pose.bones["{bpy.utils.escape_identifier(control)}"]["{name}"]'
        driver.expression = expression

    def constrain_limb(self, pose, limb, first, second, control, target, pole, straight):
        own_property(pose[control], "FK", 0.0, 0.0, 1.0, "0: the limb follows this control (IK); 1: its bones are rotated directly (FK)")
        one = pose[second].constraints.new("IK")
        one.target, one.subtarget, one.chain_count, one.use_stretch = self.object, target, 2, False
        one.iterations = 500
        if pole is not None:
            one.pole_target, one.pole_subtarget = self.object, pole
            one.pole_angle = pole_angle(pose[first].bone, pose[second].bone, self.object.data.bones[pole].head_local)
        if straight is not None:
            # The bone beyond goes away from the pole.
            along = (pose[second].bone.tail_local - pose[second].bone.head_local).normalized()
            axis = pose[second].bone.matrix_local.to_3x3().inverted() @ straight.cross(along)
            pose[second].rotation_mode = "QUATERNION"
            pose[second].rotation_quaternion = Quaternion(axis.normalized(), _PRE_BEND) if axis.length > 0 else Quaternion()
        upper, middle, end = limb["joints"][0], limb["middle"], limb["joints"][-1]
        self.copy("COPY_TRANSFORMS", pose[upper], first, control)
        self.copy("COPY_TRANSFORMS", pose[middle], second, control)
        self.copy("COPY_ROTATION", pose[end], target, control)

    def constrain_foot(self, pose, control, ball, toes, heel, tip, lift):
        own_property(pose[control], "roll", 0.0, -60.0, 90.0, "Degrees: below 0 onto the heel, above 0 onto the ball, then onto the tip")
        for name, expression in ((heel, "max(-roll, 0)"), (lift, f"-min(max(roll, 0), {_BALL_DEGREES})"), (tip, f"-max(roll - {_BALL_DEGREES}, 0)")):
            pose[name].rotation_mode = "XYZ"
            self.drive(pose[name], "rotation_euler", 0, control, "roll", f"{math.pi / 180:.9f} * ({expression})")
        self.copy("COPY_ROTATION", pose[ball], toes, control)

    def take_pose(self, seen):
        """Controls go where the armature stands. Limbs begin with FK then, as two bones that are pulled cannot stand in any pose.

        seen  {joint: 4x4} of the armature before
        """
        moved = {name: seen[name] @ self.rest[name].inverted() for name in seen}
        if all((moved[name].translation.length < 1e-5 * self.size and moved[name].to_quaternion().angle < 1e-5) for name in moved):
            return  # at rest
        pose = self.object.pose.bones
        wanted = {}
        for name in self.order():
            self.put(pose[name], moved[name], wanted)
        for limb in self.limbs:
            self.put(pose[label("IK", limb["name"])], moved[limb["joints"][-1]], wanted)
            pose[label("IK", limb["name"])]["FK"] = 1.0
            if label("pole", limb["name"]) in pose:
                self.put(pose[label("pole", limb["name"])], self.pole_moved(limb, seen, moved, pose), wanted)

    def pole_moved(self, limb, seen, moved, pose):
        """To where a bent knee or elbow points; of a straight limb as the bone above it turns."""
        first, middle, last = (seen[name].translation for name in (limb["joints"][0], limb["middle"], limb["joints"][-1]))
        along = (last - first).normalized()
        aside = middle - first - (middle - first).dot(along) * along
        reach = (middle - first).length + (last - middle).length
        if aside.length < 0.02 * reach:
            return moved[limb["joints"][0]]
        rest = pose[label("pole", limb["name"])].bone.head_local
        return Matrix.Translation(middle + aside.normalized() * reach - rest)

    @staticmethod
    def put(bone, moved, wanted):
        """A bone is moved from its rest; `wanted` has those that were."""
        rest, parent = bone.bone.matrix_local, bone.parent
        wanted[bone.name] = moved @ rest
        bone.matrix_basis = bone.bone.convert_local_to_pose(
            wanted[bone.name], rest, invert=True, parent_matrix=wanted.get(parent.name, parent.bone.matrix_local), parent_matrix_local=parent.bone.matrix_local)

    def known(self, joints):
        missing = [name for name in joints if name and name not in self.head]
        if missing:
            self.notes.append(f"no bone is called {missing[0]}, whose controls are left out")
        return not missing

    def run(self, context):
        seen = poses_now(context, self.armature)
        if self.armature.animation_data is not None and self.armature.animation_data.action is not None:
            self.notes.append(f"its action {self.armature.animation_data.action.name} is not seen while it follows controls")
        data = bpy.data.armatures.new(f"{self.armature.name} controls")
        self.object = bpy.data.objects.new(data.name, data)
        self.object[CONTROLS] = 1
        (self.armature.users_collection or (context.scene.collection,))[0].objects.link(self.object)
        self.object.parent = self.armature
        if context.object is not None and context.object.mode != "OBJECT":
            bpy.ops.object.mode_set(mode="OBJECT")
        for one in list(context.selected_objects):
            one.select_set(False)
        self.object.select_set(True)
        context.view_layer.objects.active = self.object
        bpy.ops.object.mode_set(mode="EDIT")
        self.bones, self.layers, self.follow = data.edit_bones, {name: [] for name in LAYERS}, {}
        low = min((self.up.dot(p) for p in self.head.values()))
        middle = sum(self.head.values(), Vector()) / len(self.head)
        floor = middle - (self.up.dot(middle) - low) * self.up
        self.root = self.bone("move all", floor, floor + (self.front if self.front.length > 0 else Vector((0, 1, 0))) * 0.2 * self.size, self.up, None, "Controls")
        self.limbs = [limb for limb in self.controls["limbs"] if self.known([*limb["joints"], limb["ball"]])]
        self.joints()
        for limb in self.limbs:
            self.add_limb(limb)
        for word, joints in (("spine", self.controls["spine"]), ("head", [*self.controls["neck"], self.controls["head"]])):
            joints = [name for name in joints if name]
            if joints and self.known(joints):
                self.add_turn(word, joints)
        for finger in self.controls["fingers"]:
            if self.known(finger["joints"]):
                self.add_finger(finger)
        bpy.ops.object.mode_set(mode="OBJECT")
        pose = self.object.pose.bones
        for constrain in self.later:
            constrain(pose)
        self.take_pose(seen)
        lay_out(self.object, self.layers, self.controls["hips"])
        for bone in self.armature.pose.bones:
            one = bone.constraints.new("COPY_TRANSFORMS")
            one.name, one.target, one.subtarget = CONSTRAINT, self.object, self.follow[bone.name]
        bpy.ops.object.mode_set(mode="POSE")
        return self.made, self.notes


def build(context, armature, controls):
    """Controls for an armature; how many, and what is told. Raises Problem before anything is changed."""
    return _Builder(armature, controls, fit(controls, armature)).run(context)


def own_property(bone, name, value, least, most, about):
    if name in bone:
        return
    bone[name] = float(value)
    bone.id_properties_ui(name).update(min=float(least), max=float(most), soft_min=float(least), soft_max=float(most), default=float(value), description=about)
    bone.property_overridable_library_set(f'["{name}"]', True)


def pole_angle(first, second, pole):
    """What leaves the rest pose of a chain of two bones as it is: from the pole to the first bone's x, about the bone."""
    along = first.tail_local - first.head_local
    normal = (second.tail_local - first.head_local).cross(pole - first.head_local)
    wanted = normal.cross(along)
    x = first.matrix_local.to_3x3().col[0]
    angle = x.angle(wanted, 0)
    return -angle if x.cross(wanted).dot(along) > 0 else angle


def poses_now(context, armature):
    """{bone: 4x4 in the armature's space} as it is seen."""
    context.view_layer.update()
    seen = armature.evaluated_get(context.evaluated_depsgraph_get())
    return {bone.name: bone.matrix.copy() for bone in seen.pose.bones}


def poses_of(context, armature, controls):
    """Frames of the controls' action, or the present one, and {bone: 4x4 in the armature's space} in each."""
    data = controls.animation_data
    action = data.action if data is not None else None
    now = context.scene.frame_current
    frames = [now] if action is None else list(range(math.floor(action.frame_range[0]), math.ceil(action.frame_range[1]) + 1))
    poses = []
    for frame in frames:
        if action is not None:
            context.scene.frame_set(frame)
        poses.append(poses_now(context, armature))
    if action is not None:
        context.scene.frame_set(now)
    return frames, poses


def release(armature, controls, keep):
    """The armature no longer follows its controls."""
    for bone in armature.pose.bones:
        one = bone.constraints.get(CONSTRAINT)
        if one is not None:
            bone.constraints.remove(one)
    if keep:
        return
    data = controls.data
    bpy.data.objects.remove(controls)
    if data.users == 0:
        bpy.data.armatures.remove(data)
