# SPDX-License-Identifier: MIT
"""Bind: skin weights of the selected meshes for an armature, predicted together."""
from dataclasses import dataclass, field

import bpy
import numpy as np

from . import groups, scene, sinew
from .work import EngineOperator, Problem, thread_count


_OPTIONS = ("method", "joints", "influences", "softness", "rigid_parts", "symmetric", "existing", "only_selected_bones", "questions",
            "precision", "style")


@dataclass
class Gathered:
    mesh: scene.JoinedMesh
    armature: object
    skeleton: object
    never: list
    kept: np.ndarray  # [own, j] float32, weights of groups that stay
    rows: np.ndarray  # [own] bool, vertices that may change
    given: object = None  # [all, j] dense, of hints or locked vertices
    hints: object = None
    locked: object = None
    answers: list = field(default_factory=list)
    style: str = ""
    replaced: list = field(default_factory=list)  # bones whose groups are written


class SINEW_OT_bind(EngineOperator, bpy.types.Operator):
    """Predict skin weights of the selected meshes for the armature, for all of them together"""

    bl_idname = "sinew.bind"
    bl_label = "Bind with sinew"
    bl_options = {"REGISTER", "UNDO"}
    label = "Bind"

    method: bpy.props.EnumProperty(name="Method", items=[("model", "Network", "Network trained on artists' characters"),
                                                         ("heat", "Heat", "Heat diffusion only")])
    joints: bpy.props.EnumProperty(name="Bones", items=[("names", "That Deform", "All but controls, slots, ends and bones beside the mesh, as in the command"),
                                                        ("all", "All", "Every bone with Deform on")])
    influences: bpy.props.IntProperty(name="Influences", description="Maximum number of bones per vertex", default=4, min=1, max=12)
    symmetric: bpy.props.BoolProperty(name="Symmetric", description="Give mirrored vertices mirrored weights, equal to the last bit, across the world x axis")
    rigid_parts: bpy.props.EnumProperty(name="Loose Parts", description="When connected pieces move as a whole",
                                        items=[("auto", "As Predicted", ""), ("always", "Rigid", "Bind every piece to one bone"),
                                               ("never", "Soft", "Blend pieces that are only predicted to be rigid")])
    softness: bpy.props.FloatProperty(name="Softness", description="Softness of the blend between bones; 2 is twice as soft", default=1, min=0.25, max=4)
    existing: bpy.props.EnumProperty(name="Painted", description="Treatment of vertices that already have weight",
                                     items=[("replace", "Replaced", "Predict their weights again"),
                                            ("hints", "Hints", "Keep them, as hints for the vertices around them"),
                                            ("keep", "Kept", "They stay")])
    only_selected_bones: bpy.props.BoolProperty(name="Selected Bones Only", description="Keep the weights of other bones; the selected ones share the rest")
    questions: bpy.props.IntProperty(name="Questions", description="Maximum number of undecided parts to list", default=0, min=0, max=64)
    precision: bpy.props.EnumProperty(name="Steps", description="Of a weight", items=[("8", "255", ""), ("16", "65535", "Slower to write")])
    style: bpy.props.StringProperty(name="Style", description="Style file with answers about a similar character, from sinew bind --save-style",
                                    subtype="FILE_PATH")

    @classmethod
    def poll(cls, context):
        return any(o.type == "MESH" for o in context.selected_objects) or (context.object is not None and context.object.type == "MESH")

    def draw(self, _context):
        layout = self.layout
        layout.use_property_split = True
        for name in _OPTIONS:
            layout.prop(self, name)

    def gather(self, context):
        meshes, armature = scene.chosen(context)
        for item in meshes:
            if item.data.library is not None or item.library is not None:
                raise Problem(f"{item.name} is linked from another file; make it local first")
        joined = scene.join(meshes)
        self.vertex_count = len(joined.positions)
        skeleton = scene.skeleton_of(armature)
        names = list(skeleton.names)
        never = [bone.name for bone in armature.data.bones if not bone.use_deform]
        outside = [bone.name for bone in armature.data.bones if self.only_selected_bones and not scene.is_selected(armature, bone)]
        if self.only_selected_bones and len(outside) == len(names):
            raise Problem("Selected Bones Only is on, but no bone is selected")
        kept = np.zeros((joined.own, len(names)), np.float32)
        rows = np.ones(joined.own, bool)
        had = np.zeros((joined.own, len(names)), np.float32) if self.existing != "replace" else None
        locked_names = set(outside)
        for part in joined.parts:
            item, own = part.object, slice(part.first, part.first + part.count)
            selected = scene.selected_vertices(item)
            if selected is not None:
                rows[own] = selected
            locked = {g.name for g in item.vertex_groups if g.lock_weight and g.name in names}
            locked_names |= locked
            fixed = [n for n in names if n in locked or n in outside]
            if fixed or had is not None:
                weights = scene.weights_of(item, names)
                columns = [names.index(n) for n in fixed]
                kept[own, columns] = weights[:, columns]
                if had is not None:
                    had[own] = weights
        if not rows.any():
            raise Problem("no vertex is selected")
        never = sorted(set(never) | locked_names)
        if len(never) == len(names):
            raise Problem(f"{armature.name}: every bone has Deform off, is locked or not selected; no bone may get weight")
        out = Gathered(joined, armature, skeleton, never, kept, rows)
        out.replaced = [n for n in names if n not in locked_names]
        if had is not None:
            self._take_painted(out, had)
        out.style = bpy.path.abspath(self.style) if self.style else ""
        out.answers = [tuple(a) for a in answers_of(joined, names)]
        return out

    def _take_painted(self, out, had):
        """Painted vertices become hints or locked rows; weights of locked groups are excluded."""
        names = list(out.skeleton.names)
        had = had.copy()
        had[:, [names.index(n) for n in out.never]] = 0
        painted = np.zeros(len(out.mesh.positions), bool)
        painted[:out.mesh.own] = had.sum(1) > 1e-4
        out.given = np.zeros((len(painted), len(names)), np.float32)
        out.given[:out.mesh.own] = had
        if self.existing == "hints":
            out.hints = painted
        else:
            out.locked = painted

    def compute(self, gathered, progress):
        joined = gathered.mesh
        with sinew.create(sinew.Character(joined.positions, joined.faces, gathered.skeleton)) as one:
            if gathered.given is not None:
                one.set_skin(gathered.given)
            told = one.bind(method=self.method, joints=self.joints, keep_tips=self.joints == "all", influences=self.influences, up="z",
                            never=gathered.never, symmetric=self.symmetric, rigid_parts=self.rigid_parts, softness=self.softness,
                            hints=gathered.hints, locked=gathered.locked, style=gathered.style or None, answers=gathered.answers,
                            questions=self.questions, threads=thread_count(self.vertex_count), progress=progress)
            return told, rounded(one.skin, self.influences, self.precision)

    def apply(self, context, gathered, result):
        told, skin = result
        names = list(gathered.skeleton.names)
        own = slice(0, gathered.mesh.own)
        weights = skin.weights[own].astype(np.float32) / np.float32(skin.unit())
        weights *= np.clip(1 - gathered.kept.sum(1, keepdims=True), 0, 1)
        rows = gathered.rows
        if self.existing != "replace":
            painted = gathered.hints if gathered.hints is not None else gathered.locked
            rows = rows & ~painted[own]
        for part in gathered.mesh.parts:
            at = slice(part.first, part.first + part.count)
            with groups.ObjectMode(context, part.object):
                fresh = _with_names(names, gathered.replaced)
                groups.write(part.object, fresh, skin.joints[at], weights[at], rows[at])
            attach(part.object, gathered.armature)
        remember(context, gathered, told.questions)
        context.scene["sinew_bind"] = {name: getattr(self, name) for name in _OPTIONS}
        doubtful = int((skin.confidence[own] < 128).sum())
        self.report({"INFO"}, f"Bind: {gathered.mesh.own} vertices of {len(gathered.mesh.parts)} meshes, {len(names)} bones"
                    + (f"; {doubtful} vertices are doubtful" if doubtful else "")
                    + ("; no mirror plane was found" if self.symmetric and told.symmetric_vertices == 0 else "")
                    + left_out_line(told, gathered.never))


def left_out_line(told, never):
    """Bones with Deform on that still get no weight."""
    others = [f"{name} ({why})" for name, why in told.left_out.items() if name not in set(never)]
    if not others:
        return ""
    return f"; no weight, by their names: {', '.join(others[:3])}{f' and {len(others) - 3} more' if len(others) > 3 else ''}; Bones: All binds them"


def rounded(skin, influences, precision="8"):
    """A skin in steps of 1/255 or 1/65535, as the engine rounds it."""
    out = skin.rounded(influences, 255 if precision == "8" else 65535)
    out.confidence = skin.confidence
    return out


def _with_names(names, replaced):
    """Names by joint index; None for bones whose groups are kept."""
    inside = set(replaced)
    return [n if n in inside else "" for n in names]


def attach(item, armature):
    """Makes the object follow the armature: adds a modifier and a parent unless it has them."""
    if not any(m.type == "ARMATURE" and m.object == armature for m in item.modifiers) and not (
            item.parent == armature and item.parent_type == "ARMATURE"):
        item.modifiers.new("Armature", "ARMATURE").object = armature
    if item.parent is None:
        world = item.matrix_world.copy()
        item.parent = armature
        item.matrix_parent_inverse = armature.matrix_world.inverted()
        item.matrix_world = world


class SINEW_PG_question(bpy.types.PropertyGroup):
    """A part that geometry alone does not decide. `alternatives`: kind:bone, one per line."""

    item: bpy.props.PointerProperty(type=bpy.types.Object)
    vertex: bpy.props.IntProperty()
    text: bpy.props.StringProperty()
    alternatives: bpy.props.StringProperty()


class SINEW_PG_answer(bpy.types.PropertyGroup):
    item: bpy.props.PointerProperty(type=bpy.types.Object)
    vertex: bpy.props.IntProperty()
    kind: bpy.props.StringProperty()
    bone: bpy.props.StringProperty()


def answers_of(joined, names):
    """(vertex, kind) or (vertex, "rigid", bone) of the scene's answers about these objects."""
    out = []
    for answer in bpy.context.scene.sinew_answers:
        for part in joined.parts:
            if part.object == answer.item and answer.vertex < part.count and (not answer.bone or answer.bone in names):
                out.append((part.first + answer.vertex, answer.kind) + ((answer.bone,) if answer.bone else ()))
    return out


def remember(context, gathered, questions):
    """The questions of a bind, for the panel."""
    listed = context.scene.sinew_questions
    listed.clear()
    for question in questions:
        part = next((p for p in gathered.mesh.parts if p.first <= question.vertex < p.first + p.count), None)
        if part is None:
            continue  # of a mirrored copy
        one = listed.add()
        one.item, one.vertex = part.object, question.vertex - part.first
        names = gathered.skeleton.names
        alike = f" and {question.part_count - 1} alike" if question.part_count > 1 else ""
        one.text = f"{question.vertex_count} vertices{alike}\n{100 * question.share:.0f} % with {names[question.joint]}"
        one.alternatives = "\n".join(f"{a.kind}:{names[a.joint]}" if a.kind == "rigid" else a.kind for a in question.alternatives)


class SINEW_OT_answer(bpy.types.Operator):
    """Choose how a part moves, and bind again"""

    bl_idname = "sinew.answer"
    bl_label = "Answer"
    bl_options = {"REGISTER", "UNDO"}
    question: bpy.props.IntProperty()
    answer: bpy.props.StringProperty()

    def execute(self, context):
        listed = context.scene.sinew_questions
        if not 0 <= self.question < len(listed):
            self.report({"ERROR"}, f"Answer: found {len(listed)} questions, expected the index of one")
            return {"CANCELLED"}
        question = listed[self.question]
        one = context.scene.sinew_answers.add()
        one.item, one.vertex = question.item, question.vertex
        one.kind, _, one.bone = self.answer.partition(":")
        done = bpy.ops.sinew.bind("EXEC_DEFAULT", **dict(context.scene.get("sinew_bind", {})))
        if "FINISHED" not in done:
            context.scene.sinew_answers.remove(len(context.scene.sinew_answers) - 1)
        return done


class SINEW_OT_show(bpy.types.Operator):
    """Select the part of the mesh in question"""

    bl_idname = "sinew.show"
    bl_label = "Show Part"
    bl_options = {"REGISTER", "UNDO"}
    question: bpy.props.IntProperty()

    def execute(self, context):
        listed = context.scene.sinew_questions
        if not 0 <= self.question < len(listed) or listed[self.question].item is None:
            self.report({"ERROR"}, f"Show part: found {len(listed)} questions, expected the index of one whose mesh exists")
            return {"CANCELLED"}
        item, vertex = listed[self.question].item, listed[self.question].vertex
        mesh = item.data
        if vertex >= len(mesh.vertices):
            self.report({"ERROR"}, f"Show part: {item.name} has changed since it was bound; bind it again")
            return {"CANCELLED"}
        with groups.ObjectMode(context, item):
            edges = np.empty(2 * len(mesh.edges), np.int32)
            mesh.edges.foreach_get("vertices", edges)
            edges, part = edges.reshape(-1, 2), np.zeros(len(mesh.vertices), bool)
            part[vertex], count = True, 0
            while part.sum() != count:
                count = part.sum()
                part[edges[part[edges].any(1)]] = True
            mesh.polygons.foreach_set("select", np.zeros(len(mesh.polygons), bool))
            mesh.edges.foreach_set("select", part[edges].all(1))
            mesh.vertices.foreach_set("select", part)
            mesh.update()
        self.report({"INFO"}, f"Show part: {int(count)} vertices of {item.name} are selected")
        return {"FINISHED"}


class SINEW_OT_forget(bpy.types.Operator):
    """Remove all answers; the next bind ignores them"""

    bl_idname = "sinew.forget"
    bl_label = "Forget Answers"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        context.scene.sinew_answers.clear()
        return {"FINISHED"}


_CLASSES = (SINEW_PG_question, SINEW_PG_answer, SINEW_OT_bind, SINEW_OT_answer, SINEW_OT_show, SINEW_OT_forget)


def _parent_menu(self, _context):
    self.layout.operator(SINEW_OT_bind.bl_idname, text="Armature Deform with sinew Weights")


def _weights_menu(self, _context):
    self.layout.operator(SINEW_OT_bind.bl_idname, text="sinew Weights")


def register():
    for one in _CLASSES:
        bpy.utils.register_class(one)
    bpy.types.Scene.sinew_questions = bpy.props.CollectionProperty(type=SINEW_PG_question)
    bpy.types.Scene.sinew_answers = bpy.props.CollectionProperty(type=SINEW_PG_answer)
    bpy.types.VIEW3D_MT_object_parent.append(_parent_menu)
    bpy.types.VIEW3D_MT_paint_weight.append(_weights_menu)


def unregister():
    bpy.types.VIEW3D_MT_paint_weight.remove(_weights_menu)
    bpy.types.VIEW3D_MT_object_parent.remove(_parent_menu)
    del bpy.types.Scene.sinew_answers
    del bpy.types.Scene.sinew_questions
    for one in reversed(_CLASSES):
        bpy.utils.unregister_class(one)
