# SPDX-License-Identifier: MIT
"""Check the rig: lists faults of weights and joints as `sinew check` does; a click selects them."""
import bpy
import numpy as np

from . import groups, retarget, scene, sinew
from .work import EngineOperator, Problem


class SINEW_PG_finding(bpy.types.PropertyGroup):
    """`vertices`: indices in the mesh, separated by spaces."""

    what: bpy.props.StringProperty()
    cure: bpy.props.StringProperty()
    severity: bpy.props.StringProperty()
    item: bpy.props.PointerProperty(type=bpy.types.Object)
    vertices: bpy.props.StringProperty()
    bone: bpy.props.StringProperty()


class SINEW_OT_check(EngineOperator, bpy.types.Operator):
    """Find faults of the skeleton and the weights of the selected meshes; changes nothing"""

    bl_idname = "sinew.check"
    bl_label = "Check the Rig"
    bl_options = {"REGISTER"}
    label = "Check"

    poses: bpy.props.BoolProperty(name="Test Poses", description="Also bend the body and find tears, lost volume and crossings", default=True)

    @classmethod
    def poll(cls, context):
        return context.object is not None

    def gather(self, context):
        meshes, armature = scene.chosen(context)
        body = retarget.body_of(meshes, scene.skeleton_of(armature))
        if body is None:
            raise Problem(f"no selected mesh has weights of {armature.name}; bind it first")
        return (*body, armature)

    def compute(self, gathered, progress):
        character, _, _ = gathered
        with sinew.create(character) as one:
            return one.check(poses=self.poses, clips=False)

    def apply(self, context, gathered, result):
        character, joined, armature = gathered
        listed = context.scene.sinew_findings
        listed.clear()
        for found in result.findings:
            one = listed.add()
            one.what, one.cure, one.severity = found.what, found.cure, found.severity
            one.bone = character.skeleton.names[found.joint] if found.joint >= 0 else ""
            own = np.asarray(found.vertices, np.int64)
            part = next((p for p in joined.parts if len(own) and p.first <= own[0] < p.first + p.count), None)
            one.item = part.object if part is not None else armature
            if part is not None:
                one.vertices = " ".join(str(v - part.first) for v in own if v < part.first + part.count)
        count = len(result.findings)
        self.report({"INFO"}, f"Check: {count} finding{'' if count == 1 else 's'}{', listed in the step Export' if count else ''}")


class SINEW_OT_show_finding(bpy.types.Operator):
    """Select the vertices or bones of a finding"""

    bl_idname = "sinew.show_finding"
    bl_label = "Show Finding"
    bl_options = {"REGISTER", "UNDO"}
    finding: bpy.props.IntProperty()

    def execute(self, context):
        listed = context.scene.sinew_findings
        if not 0 <= self.finding < len(listed) or listed[self.finding].item is None:
            self.report({"ERROR"}, f"Show finding: found {len(listed)} findings, expected the index of one whose object exists")
            return {"CANCELLED"}
        one = listed[self.finding]
        vertices = [int(v) for v in one.vertices.split()]
        if one.item.type == "MESH":
            with groups.ObjectMode(context, one.item):
                mesh = one.item.data
                if vertices and max(vertices) >= len(mesh.vertices):
                    self.report({"ERROR"}, f"Show finding: {one.item.name} has changed since it was checked; check it again")
                    return {"CANCELLED"}
                chosen = np.zeros(len(mesh.vertices), bool)
                chosen[vertices] = True
                mesh.polygons.foreach_set("select", np.zeros(len(mesh.polygons), bool))
                mesh.edges.foreach_set("select", np.zeros(len(mesh.edges), bool))
                mesh.vertices.foreach_set("select", chosen)
                mesh.update()
        elif one.bone in one.item.data.bones:
            one.item.data.bones.active = one.item.data.bones[one.bone]
        self.report({"INFO"}, f"{one.what}: {one.cure}")
        return {"FINISHED"}


_CLASSES = (SINEW_PG_finding, SINEW_OT_check, SINEW_OT_show_finding)


def register():
    for one in _CLASSES:
        bpy.utils.register_class(one)
    bpy.types.Scene.sinew_findings = bpy.props.CollectionProperty(type=SINEW_PG_finding)


def unregister():
    del bpy.types.Scene.sinew_findings
    for one in reversed(_CLASSES):
        bpy.utils.unregister_class(one)
