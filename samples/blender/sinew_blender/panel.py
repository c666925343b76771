# SPDX-License-Identifier: MIT
"""The tab in the sidebar of the 3D view."""
import bpy

_ACTIONS = (("sinew.bind", "MOD_ARMATURE"), ("sinew.look", "VIEWZOOM"), ("sinew.rig", "OUTLINER_OB_ARMATURE"),
            ("sinew.transfer", "MOD_DATA_TRANSFER"), ("sinew.correct", "SHAPEKEY_DATA"))


class InTab:
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "sinew"


class SINEW_PT_tab(InTab, bpy.types.Panel):
    bl_idname = "SINEW_PT_tab"
    bl_label = "sinew"

    def draw(self, context):
        layout = self.layout
        for name, icon in _ACTIONS:
            layout.operator(name, icon=icon)
        scene = context.scene
        for number, question in enumerate(scene.sinew_questions):
            if question.item is None:
                continue  # it was deleted
            box = layout.box()
            box.operator("sinew.show", text=question.item.name, icon="QUESTION").question = number
            for line in question.text.split("\n"):
                box.label(text=line)
            for alternative in question.alternatives.split("\n"):
                said = box.operator("sinew.answer", text=alternative.replace(":", ": "))
                said.question, said.answer = number, alternative
        if len(scene.sinew_answers):
            layout.operator("sinew.forget", icon="LOOP_BACK")


class SINEW_PT_motion(InTab, bpy.types.Panel):
    bl_idname = "SINEW_PT_motion"
    bl_label = "Motion"
    bl_parent_id = "SINEW_PT_tab"

    def draw(self, context):
        layout = self.layout
        layout.operator("sinew.retarget", icon="ACTION")
        layout.operator("sinew.map_bones", icon="BONE_DATA")
        scene = context.scene
        if scene.sinew_map_target is None or scene.sinew_map_source is None or not len(scene.sinew_map):
            return
        layout.label(text=f"{scene.sinew_map_target.name} moves as {scene.sinew_map_source.name}")
        column = layout.column(align=True)
        for pair in scene.sinew_map:
            row = column.row(align=True)
            row.alert = bool(pair.source) and pair.confidence < 0.5
            row.label(text=pair.target)
            row.prop_search(pair, "source", scene.sinew_map_source.data, "bones", text="")


_CLASSES = (SINEW_PT_tab, SINEW_PT_motion)


def register():
    for one in _CLASSES:
        bpy.utils.register_class(one)


def unregister():
    for one in reversed(_CLASSES):
        bpy.utils.unregister_class(one)
