# SPDX-License-Identifier: MIT
"""Time of the button Bind in Blender beside the command's own bind (its sinew_bind() alone), on samples of about 10,000 vertices.

    blender -b --factory-startup --python tests/bench/blender_bind.py -- ZIP SOURCE COMMAND [ROUNDS]

Prints CSV: character, vertices, medians in ms, their ratio. The rows are compared by ctest -L blender."""
import os
import statistics
import sys
import time

source = sys.argv[sys.argv.index("--") + 2]
sys.path[:0] = [os.path.join(source, "samples", "blender", "tests"), os.path.join(source, "tests", "bench")]
import blender_common as blender  # noqa: E402
import bpy  # noqa: E402
import python_bind  # noqa: E402

rounds = int(sys.argv[-1]) if sys.argv[-1].isdigit() else 7
print("character,vertices,blender_ms,command_ms,ratio")
for name in ("biped__robed", "quadruped__tailed", "biped__robot"):
    positions, faces, skeleton, _ = blender.common.read_character(name)
    positions, faces = python_bind.finer(positions, faces, 5000)
    blender.clear()
    item, armature = blender.add_mesh(name, blender.z_up(positions), faces.tolist()), blender.add_armature(skeleton)
    blender.select([item, armature], armature)
    clicks, command = [], []
    with blender.common.folder() as where:
        blender.write_obj(f"{where}/mesh.obj", positions, faces)
        for _ in range(rounds):  # in turns, so that both see the same machine
            item.vertex_groups.clear()
            begin = time.perf_counter()
            bpy.ops.sinew.bind()
            clicks.append(time.perf_counter() - begin)
            told = blender.common.command("bind", f"{where}/mesh.obj", "--skeleton", blender.common.DATA / f"{name}.rig.txt", "--joints",
                                          "all", "--keep-tips", "-o", f"{where}/out.rig.txt", "--json")
            command.append(told["seconds"])
    ms = [1e3 * statistics.median(times) for times in (clicks, command)]
    print(f"{name},{len(positions)},{ms[0]:.1f},{ms[1]:.1f},{ms[0] / ms[1]:.2f}", flush=True)
