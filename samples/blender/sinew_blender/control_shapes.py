# SPDX-License-Identifier: MIT
"""How bones of a control rig are seen: layers, lines in place of bones."""
import math

import bpy

LAYERS = ("Controls", "FK", "Mechanism")


def lay_out(item, layers, hips):
    """Bones of a kind together; controls as lines that are easy to hit."""
    data = item.data
    data.display_type, item.show_in_front = "STICK", True
    if hips in data.bones:
        layers["FK"].remove(hips)
        layers["Controls"].append(hips)
    for number, (kind, names) in enumerate(layers.items()):
        if hasattr(data, "collections"):  # Blender 4
            collection = data.collections.new(kind)
            collection.is_visible = kind != "Mechanism"
            for name in names:
                collection.assign(data.bones[name])
        else:
            for name in names:
                data.bones[name].layers = [layer == number for layer in range(32)]
            data.layers[number] = kind != "Mechanism"
    for name in layers["Controls"]:
        item.pose.bones[name].custom_shape = _shape("cube" if name.startswith("IK ") else "circle")


def _shape(kind):
    name = f"sinew {kind}"
    if name in bpy.data.objects:
        return bpy.data.objects[name]
    if kind == "cube":
        points = [(x, y, z) for x in (-0.25, 0.25) for y in (0, 1) for z in (-0.15, 0.15)]
        edges = [(a, b) for a in range(8) for b in range(a) if bin(a ^ b).count("1") == 1]
    else:
        points = [(0.5 * math.cos(math.pi * k / 12), 0, 0.5 * math.sin(math.pi * k / 12)) for k in range(24)]
        edges = [(k, (k + 1) % 24) for k in range(24)]
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points, edges, [])
    return bpy.data.objects.new(name, mesh)
