# SPDX-License-Identifier: MIT
"""Transfer: copies the weights of the active mesh to the other selected ones."""
import bpy
import numpy as np

from . import groups, scene, sinew
from .bind import attach
from .work import EngineOperator, Problem, thread_count


class SINEW_OT_transfer(EngineOperator, bpy.types.Operator):
    """Transfer the weights of the active mesh to the other selected meshes, with the same or another skeleton"""

    bl_idname = "sinew.transfer"
    bl_label = "Transfer with sinew"
    bl_options = {"REGISTER", "UNDO"}
    label = "Transfer"

    method: bpy.props.EnumProperty(name="Method", items=[
        ("auto", "Balanced", "Blend of nearest and rebind, per vertex"), ("nearest", "Nearest", "The active mesh's weights only"),
        ("biharmonic", "Along the Surface", "By distances along the surface"), ("rebind", "Rebind", "By the binder that suits the active mesh")])
    garment: bpy.props.BoolProperty(name="Garment", description="The active mesh wears the others: near it they get its "
                                                                "weights, elsewhere a bind of the dressed character")
    influences: bpy.props.IntProperty(name="Influences", description="Maximum number of bones per vertex", default=4, min=1, max=12)

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.type == "MESH"

    def gather(self, context):
        source = context.object
        targets = sorted((o for o in context.selected_objects if o.type == "MESH" and o != source), key=lambda o: o.name)
        if not targets:
            raise Problem("select the meshes that get weights, then the bound one last")
        armature = scene.armature_of(source)
        if armature is None:
            raise Problem(f"{source.name} has no armature to transfer from; bind it first")
        skeleton = scene.skeleton_of(armature)
        weights = scene.weights_of(source, list(skeleton.names))
        if not weights.any():
            raise Problem(f"{source.name} has no weights of {armature.name}'s bones; bind it first")
        joined = scene.join([source])
        order = np.argsort(-weights, axis=1, kind="stable")[:, :sinew.binding.MAX_INFLUENCES]
        skin = sinew.Skin(order.astype(np.uint16), np.take_along_axis(weights, order, 1))
        own = [b[(b < joined.own).all(1)] for b in joined.faces]
        character = sinew.Character(joined.positions[:joined.own], own, skeleton, skin)
        meshes, others = [], []
        for target in targets:
            other = scene.armature_of(target)
            others.append(armature if other is None or self.garment else other)
            meshes.append(scene.join([target]))
        self.vertex_count = joined.own + sum(m.own for m in meshes)
        return character, armature, meshes, others, [scene.skeleton_of(o) for o in others], [scene.selected_vertices(t) for t in targets]

    def compute(self, gathered, progress):
        character, armature, meshes, others, skeletons, _ = gathered
        out = []
        for i, (mesh, other, skeleton) in enumerate(zip(meshes, others, skeletons)):
            never = [b.name for b in other.data.bones if not b.use_deform]
            out.append(sinew.transfer(character, mesh.positions[:mesh.own], [b[(b < mesh.own).all(1)] for b in mesh.faces],
                                      None if other == armature else skeleton, method=self.method, garment=self.garment,
                                      influences=self.influences, up="z", never=never, threads=thread_count(self.vertex_count),
                                      progress=lambda share, i=i: progress((i + share) / len(meshes))))
        return out

    def apply(self, context, gathered, result):
        _, _, meshes, others, skeletons, selected = gathered
        for mesh, other, skeleton, rows, done in zip(meshes, others, skeletons, selected, result):
            item = mesh.parts[0].object
            rows_of = done.skin.rounded(self.influences, 255)  # steps of 8 bits, so that lists of equal weight are long
            with groups.ObjectMode(context, item):
                groups.write(item, list(skeleton.names), rows_of.joints, rows_of.weights / np.float32(255), np.ones(mesh.own, bool) if rows is None else rows)
            attach(item, other)
        told = ", ".join(f"{m.parts[0].object.name} {100 * r.carried:.0f} % transferred" for m, r in zip(meshes, result))
        self.report({"INFO"}, f"Transfer: {told}")


def register():
    bpy.utils.register_class(SINEW_OT_transfer)


def unregister():
    bpy.utils.unregister_class(SINEW_OT_transfer)
