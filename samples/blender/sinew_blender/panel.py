# SPDX-License-Identifier: MIT
"""The tab in the sidebar of the 3D view: the five steps of the page (samples/web), with the current one below them."""
import bpy

from . import control_rig, scene

STEPS = ("Mesh", "Skeleton", "Weights", "Motion", "Export")


def selected_meshes(context):
    return sorted({o for o in context.selected_objects if o.type == "MESH"} |
                  ({context.object} if context.object is not None and context.object.type == "MESH" else set()), key=lambda o: o.name)


def selected_armature(context):
    """The armature that the selection is about, or None."""
    item = context.object
    if item is not None and item.type == "ARMATURE":
        return item.parent if control_rig.CONTROLS in item and item.parent is not None else item
    found = [scene.armature_of(mesh) for mesh in selected_meshes(context)]
    return next((armature for armature in found if armature is not None), None)


def is_bound(context):
    armature, meshes = selected_armature(context), selected_meshes(context)
    if armature is None:
        return False
    if not meshes:
        meshes = [o for o in context.scene.objects if o.type == "MESH" and scene.armature_of(o) == armature]
    bones = armature.data.bones
    return any(scene.armature_of(mesh) == armature and any(g.name in bones for g in mesh.vertex_groups) for mesh in meshes)


def is_done(context, step):
    """Whether a step has what it is for: its tick."""
    armature = selected_armature(context)
    if step == "Mesh":
        return bool(selected_meshes(context))
    if step == "Skeleton":
        return armature is not None
    if step == "Weights":
        return is_bound(context)
    if step == "Motion":
        return armature is not None and armature.animation_data is not None and armature.animation_data.action is not None
    return False


def sentence(context, step):
    meshes, armature = selected_meshes(context), selected_armature(context)
    if step == "Mesh":
        if not meshes:
            return "Select the meshes of a character."
        size = max(max(mesh.dimensions) for mesh in meshes)
        return f"{sum(len(m.data.vertices) for m in meshes):,} vertices, {sum(len(m.data.polygons) for m in meshes):,} faces, {size:.2f} along its longest side."
    if step == "Skeleton":
        return "No joints yet." if armature is None else f"{len(armature.data.bones)} joints."
    if step == "Weights":
        parts = len(context.scene.sinew_questions)
        if not is_bound(context):
            return "Not bound yet."
        return f"Bound; {parts} part{'s' if parts > 1 else ''} may move differently." if parts else "Bound, no part in doubt."
    if step == "Motion":
        return f"Moves by {armature.animation_data.action.name}." if is_done(context, step) else "No motion yet."
    return "A file for other programs."


class InTab:
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "sinew"


class SINEW_PT_tab(InTab, bpy.types.Panel):
    bl_idname = "SINEW_PT_tab"
    bl_label = "sinew"
    drawn = 0

    def draw(self, context):
        SINEW_PT_tab.drawn += 1
        layout, manager = self.layout, context.window_manager
        rail = layout.column(align=True)
        for step in STEPS:
            rail.prop_enum(manager, "sinew_step", step, text=step, icon="CHECKMARK" if is_done(context, step) else "BLANK1")
        layout.label(text=sentence(context, manager.sinew_step))
        main = _MAIN.get(manager.sinew_step)
        if main is not None:
            name, text, icon = main
            row = layout.row()
            row.scale_y = 1.3
            row.operator(name, text=text, icon=icon)
        _REST[manager.sinew_step](layout, context)


# One main button a step.
_MAIN = {"Skeleton": ("sinew.rig", "New Skeleton", "OUTLINER_OB_ARMATURE"), "Weights": ("sinew.bind", "Bind", "MOD_ARMATURE"),
         "Motion": ("sinew.retarget", "Retarget", "ACTION"), "Export": ("export_scene.gltf", "GLB", "EXPORT")}


def _mesh(layout, context):
    for mesh in selected_meshes(context)[:8]:
        layout.label(text=mesh.name, icon="MESH_DATA")


def _skeleton(layout, context):
    armature = selected_armature(context)
    if armature is not None and control_rig.controls_of(armature) is not None:
        layout.operator("sinew.bake_controls", icon="ARMATURE_DATA")
    else:
        layout.operator("sinew.controls", icon="CON_KINEMATIC")
    item = context.object
    if item is None or control_rig.CONTROLS not in item or context.active_pose_bone is None:
        return
    for name in ("FK", "roll", "curl"):
        if name in context.active_pose_bone:
            layout.prop(context.active_pose_bone, f'["{name}"]', text={"FK": "FK", "roll": "Foot Roll", "curl": "Fingers' Curl"}[name])


def _weights(layout, context):
    layout.operator("sinew.transfer", text="Transfer", icon="MOD_DATA_TRANSFER")
    layout.operator("sinew.look", text="Doubt", icon="VIEWZOOM")
    layout.operator("sinew.correct", text="Bends", icon="SHAPEKEY_DATA")
    questions = context.scene.sinew_questions
    if len(questions):
        layout.label(text="Parts in doubt")
    for number, question in enumerate(questions):
        if question.item is None:
            continue  # it was deleted
        box = layout.box()
        box.operator("sinew.show", text=question.item.name, icon="QUESTION").question = number
        for line in question.text.split("\n"):
            box.label(text=line)
        for alternative in question.alternatives.split("\n"):
            said = box.operator("sinew.answer", text=alternative.replace(":", ": "))
            said.question, said.answer = number, alternative
    if len(context.scene.sinew_answers):
        layout.operator("sinew.forget", icon="LOOP_BACK")


def _motion(layout, context):
    layout.operator("sinew.map_bones", text="Map", icon="BONE_DATA")
    own = context.scene
    if own.sinew_map_target is None or own.sinew_map_source is None or not len(own.sinew_map):
        return
    layout.label(text=f"{own.sinew_map_target.name} moves as {own.sinew_map_source.name}")
    column = layout.column(align=True)
    for pair in own.sinew_map:
        row = column.row(align=True)
        row.alert = bool(pair.source) and pair.confidence < 0.5
        row.label(text=pair.target)
        row.prop_search(pair, "source", own.sinew_map_source.data, "bones", text="")


def _export(layout, context):
    layout.operator("export_scene.fbx", text="FBX")
    layout.operator("sinew.check", icon="CHECKMARK")
    for number, finding in enumerate(context.scene.sinew_findings):
        row = layout.row()
        row.alert = finding.severity == "error"
        row.operator("sinew.show_finding", text=finding.what, icon={"error": "CANCEL", "warning": "ERROR"}.get(finding.severity, "INFO")).finding = number


_REST = {"Mesh": _mesh, "Skeleton": _skeleton, "Weights": _weights, "Motion": _motion, "Export": _export}


def register():
    bpy.utils.register_class(SINEW_PT_tab)
    bpy.types.WindowManager.sinew_step = bpy.props.EnumProperty(name="Step", items=[(step, step, "") for step in STEPS], default="Mesh")


def unregister():
    del bpy.types.WindowManager.sinew_step
    bpy.utils.unregister_class(SINEW_PT_tab)
