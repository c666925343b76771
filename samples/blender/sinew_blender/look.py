# SPDX-License-Identifier: MIT
"""Show doubt: selects and colors the least certain vertices of a bind."""
import bpy
import numpy as np

from . import scene, sinew
from .work import EngineOperator, thread_count

ATTRIBUTE = "sinew doubt"


class SINEW_OT_look(EngineOperator, bpy.types.Operator):
    """Select the vertices with the least certain weights, and color all by doubt. Keeps the weights"""

    bl_idname = "sinew.look"
    bl_label = "Show Doubt"
    bl_options = {"REGISTER", "UNDO"}
    label = "Show doubt"

    share: bpy.props.FloatProperty(name="Share", description="Share of the vertices to select, the least certain ones", default=0.1, min=0.001,
                                   max=1, subtype="FACTOR")

    @classmethod
    def poll(cls, context):
        return any(o.type == "MESH" for o in context.selected_objects) or (context.object is not None and context.object.type == "MESH")

    def gather(self, context):
        meshes, armature = scene.chosen(context)
        joined = scene.join(meshes)
        self.vertex_count = len(joined.positions)
        never = [b.name for b in armature.data.bones if not b.use_deform]
        return joined, scene.skeleton_of(armature), never

    def compute(self, gathered, progress):
        joined, skeleton, never = gathered
        return sinew.bind(joined.positions, joined.faces, skeleton, up="z", never=never, threads=thread_count(self.vertex_count), progress=progress)

    def apply(self, context, gathered, skin):
        joined, _, _ = gathered
        sure = skin.confidence[:joined.own].astype(np.int64)
        count = max(1, int(round(self.share * joined.own)))
        doubtful = np.zeros(joined.own, bool)
        doubtful[np.lexsort((np.arange(joined.own), sure))[:count]] = True
        doubtful &= sure < 255
        doubt = 1 - sure / 255
        shade = doubt / max(doubt.max(), 1e-6)
        colors = np.stack([np.clip(1.5 * shade, 0, 1), np.clip(2 * shade - 1, 0, 1) * 0.8, 0.35 * (1 - shade), np.ones(joined.own)], 1)
        for part in joined.parts:
            item, own = part.object, slice(part.first, part.first + part.count)
            mode = item.mode
            if mode == "EDIT":
                with context.temp_override(active_object=item, object=item):
                    bpy.ops.object.mode_set(mode="OBJECT")
            mesh = item.data
            mesh.polygons.foreach_set("select", np.zeros(len(mesh.polygons), bool))
            mesh.edges.foreach_set("select", np.zeros(len(mesh.edges), bool))
            mesh.vertices.foreach_set("select", doubtful[own])
            attribute = mesh.color_attributes.get(ATTRIBUTE) or mesh.color_attributes.new(ATTRIBUTE, "FLOAT_COLOR", "POINT")
            attribute.data.foreach_set("color", colors[own].astype(np.float32).ravel())
            mesh.color_attributes.active_color = attribute
            mesh.update()
            if mode == "EDIT":
                with context.temp_override(active_object=item, object=item):
                    bpy.ops.object.mode_set(mode="EDIT")
        self.report({"INFO"}, f"Show doubt: {int(doubtful.sum())} of {joined.own} vertices are selected, the color attribute is {ATTRIBUTE}")


def register():
    bpy.utils.register_class(SINEW_OT_look)


def unregister():
    bpy.utils.unregister_class(SINEW_OT_look)
