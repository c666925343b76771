#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Time of sinew.bind() in Python beside the command's own (its sinew_bind() alone), on samples made finer to about 10,000 vertices.

    tests/bench/python_bind.py COMMAND [ROUNDS]      with the package sinew installed

Prints CSV: character, vertices, medians in ms, their ratio, and the hash of both results, so that a wrong result cannot look fast."""
import statistics
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "samples" / "python" / "tests"))
import common  # noqa: E402
import numpy as np  # noqa: E402

import sinew  # noqa: E402


def finer(positions, faces, wanted):
    """Every triangle becomes four, until there are as many vertices as wanted."""
    triangles = np.array([[f[0], f[i], f[i + 1]] for f in faces for i in range(1, len(f) - 1)])
    while len(positions) < wanted:
        edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), 1)
        unique, place = np.unique(edges, axis=0, return_inverse=True)
        middle = len(positions) + place.reshape(-1, 3)
        positions = np.concatenate([positions, positions[unique].mean(1)])
        a, b, c = triangles.T
        ab, bc, ca = middle.T
        triangles = np.concatenate([np.stack(t, 1) for t in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))])
    return positions.astype(np.float32), triangles


def main():
    common.COMMAND = sys.argv[1]
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 9
    print("character,vertices,python_ms,command_ms,ratio,python_hash,command_hash")
    for name in ("biped__robed", "quadruped__tailed", "biped__robot"):
        positions, faces, skeleton, _ = common.read_character(name)
        positions, faces = finer(positions, faces, 5000)
        with common.folder() as where:
            with open(f"{where}/mesh.obj", "w", encoding="utf-8") as obj:
                obj.writelines(f"v {x:.9g} {y:.9g} {z:.9g}\n" for x, y, z in positions)
                obj.writelines("f " + " ".join(str(v + 1) for v in f) + "\n" for f in faces)
            python, command = [], []
            for _ in range(rounds):  # in turns, so that both see the same machine
                begin = time.perf_counter()
                skin = sinew.bind(positions, faces, skeleton)
                python.append(time.perf_counter() - begin)
                told = common.command("bind", f"{where}/mesh.obj", "--skeleton", common.DATA / f"{name}.rig.txt", "--joints", "all",
                                      "--keep-tips", "-o", f"{where}/out.rig.txt", "--json")
                command.append(told["seconds"])
        ms = [1e3 * statistics.median(times) for times in (python, command)]
        print(f"{name},{len(positions)},{ms[0]:.1f},{ms[1]:.1f},{ms[0] / ms[1]:.2f},{common.fnv(skin)},{told['hash']}", flush=True)


if __name__ == "__main__":
    main()
