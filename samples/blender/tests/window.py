# SPDX-License-Identifier: MIT
"""The add-on in a window, by simulated events: the button is clicked, undone and redone; a bind in a thread is stopped by Esc and finished.

    window_test.sh starts Blender for it, under Xvfb
"""
import os
import sys
import traceback

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import bpy

from blender_common import add_armature, character, common, select, sinew_blender, state, weights

SHOTS = sys.argv[-1]
panel = sinew_blender.panel.SINEW_PT_tab


def window():
    return bpy.context.window_manager.windows[0]


def view():
    return next(a for a in window().screen.areas if a.type == "VIEW_3D")


def shot(name):
    with bpy.context.temp_override(window=window(), screen=window().screen):
        bpy.ops.screen.screenshot(filepath=os.path.join(SHOTS, name + ".png"))


def key(kind, **held):
    for value in ("PRESS", "RELEASE"):
        window().event_simulate(type=kind, value=value, x=300, y=300, **held)


def click(place):
    window().event_simulate(type="MOUSEMOVE", value="NOTHING", x=place[0], y=place[1])
    yield 0.3
    window().event_simulate(type="LEFTMOUSE", value="PRESS", x=place[0], y=place[1])
    window().event_simulate(type="LEFTMOUSE", value="RELEASE", x=place[0], y=place[1])
    yield 0.8


def sidebar():
    """Its tabs stand below each other at the right edge."""
    return next(r for r in view().regions if r.type == "UI")


def invoke(**options):
    area = view()
    with bpy.context.temp_override(window=window(), area=area, region=next(r for r in area.regions if r.type == "WINDOW")):
        return bpy.ops.sinew.bind("INVOKE_DEFAULT", **options)


def steps():
    for item in list(bpy.data.objects):
        bpy.data.objects.remove(item)
    item, armature, _, _ = character()
    name = item.name
    view().spaces[0].show_region_ui = True
    yield 1.0
    bpy.ops.ed.undo_push(message="character")
    shot("1_sidebar")
    region, found = sidebar(), False
    x = region.x + region.width - 10
    for y in range(region.y + region.height - 30, region.y + region.height // 3, -25):  # down the tabs until ours is drawn
        drawn = panel.drawn
        yield from click((x, y))
        if panel.drawn == drawn:
            continue
        for down in range(130, 260, 10):  # below the rail until the step's main button is there
            bpy.context.window_manager.sinew_step = "Weights"
            before = state(bpy.data.objects[name])
            yield from click((region.x + region.width // 2 - 15, region.y + region.height - down))
            if len(bpy.data.objects[name].vertex_groups):
                found = True
                break
        break
    shot("2_bound")
    assert found, "no click below the rail bound the mesh"
    item = bpy.data.objects[name]
    after = state(item)
    assert after[0] and after != before
    key("Z", ctrl=True)
    yield 1.0
    assert state(bpy.data.objects[name]) == before, "undo is not exact"
    key("Z", ctrl=True, shift=True)
    yield 1.0
    assert state(bpy.data.objects[name]) == after, "redo is not exact"
    # In a thread: Esc leaves everything as it was.
    item = bpy.data.objects[name]
    kept = state(item)
    assert invoke(method="heat", threaded_from=0, influences=2) == {"RUNNING_MODAL"}
    key("ESC")
    yield 2.0
    assert state(bpy.data.objects[name]) == kept, "Esc changed the object"
    # And without Esc it ends as the blocking one does.
    assert invoke(method="heat", threaded_from=0) == {"RUNNING_MODAL"}
    for _ in range(100):
        yield 0.2
        if state(bpy.data.objects[name]) != kept:
            break
    threaded = weights(bpy.data.objects[name])
    yield 0.5
    assert invoke(method="heat") == {"FINISHED"}
    blocking = weights(bpy.data.objects[name])
    assert threaded.keys() == blocking.keys() and all((threaded[n] == blocking[n]).all() for n in threaded)
    view().spaces[0].shading.type = "SOLID"
    item = bpy.data.objects[name]
    select([item, bpy.data.objects["Armature"]], item)
    bpy.ops.object.mode_set(mode="WEIGHT_PAINT")
    item.vertex_groups.active_index = item.vertex_groups["chest"].index
    with bpy.context.temp_override(window=window(), area=view(), region=next(r for r in view().regions if r.type == "WINDOW")):
        bpy.ops.view3d.view_axis(type="FRONT")
        bpy.ops.view3d.view_all()
    yield 1.0
    shot("3_weights")
    # The panel draws a map and questions; Show Doubt's colors are seen.
    bpy.ops.object.mode_set(mode="OBJECT")
    other = add_armature(common.read_character("biped__robot")[2], "Source")
    other.location = (1.5, 0, 0)
    select([bpy.data.objects["Armature"], other], bpy.data.objects["Armature"])
    assert bpy.ops.sinew.map_bones() == {"FINISHED"}
    bpy.context.window_manager.sinew_step = "Motion"
    yield 1.0
    shot("4_map")
    bpy.context.scene.sinew_map.clear()
    select([item, bpy.data.objects["Armature"]], item)
    assert bpy.ops.sinew.bind(questions=3) == {"FINISHED"}
    assert bpy.ops.sinew.look() == {"FINISHED"}
    other.hide_set(True)
    bpy.context.window_manager.sinew_step = "Weights"
    view().spaces[0].shading.color_type = "VERTEX"
    yield 1.0
    shot("5_questions_and_doubt")
    # Controls, one of them pulled.
    bpy.context.window_manager.sinew_step = "Skeleton"
    view().spaces[0].shading.color_type = "MATERIAL"
    assert bpy.ops.sinew.controls() == {"FINISHED"}
    pose = bpy.context.object.pose.bones
    pose["IK arm.L"].location = (0, 0.1, -0.3)
    bpy.context.object.data.bones.active = pose["IK leg.L"].bone
    pose["IK leg.L"]["roll"] = 40.0
    bpy.context.object.update_tag()
    yield 1.0
    shot("6_controls")
    assert bpy.ops.sinew.bake_controls() == {"FINISHED"}
    print("WINDOW OK")


def tick(run=steps()):
    try:
        return next(run)
    except StopIteration:
        pass
    except BaseException:
        traceback.print_exc()
        shot("failed")
    sys.stdout.flush()
    os._exit(0)


bpy.app.timers.register(tick, first_interval=1.0)
