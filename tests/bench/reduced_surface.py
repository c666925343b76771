#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a reduced surface costs in accuracy and wins in time: every OBJ + rig.txt character of a folder that is large enough is
subdivided at its edges' midpoints, weights with it, and evaluated with several limits (sinew eval --surface-vertices).
    tests/bench/reduced_surface.py SINEW CHARACTERS OUT_FOLDER [LIMIT ...]      default: 16384 32768 65536 4000000
Prints a Markdown table; OUT_FOLDER gets the subdivided characters."""
import json
import pathlib
import subprocess
import sys

ROUNDS = 2  # of subdivision: sixteen times the triangles
LEAST_VERTICES = 2600  # of the original: above the largest usual limit afterwards


def read(obj):
    vertices, triangles, head, weights = [], [], [], {}
    for line in obj.read_text(errors="replace").splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            vertices.append([float(x) for x in words[1:4]])
        elif words[:1] == ["f"]:
            corners = [int(w.split("/")[0]) - 1 for w in words[1:]]
            triangles += [(corners[0], corners[i], corners[i + 1]) for i in range(1, len(corners) - 1)]
    for line in obj.with_name(obj.stem + ".rig.txt").read_text().splitlines():
        words = line.split()
        if words[:1] == ["skin"]:
            weights[int(words[1])] = {j: float(w) for j, w in zip(words[2::2], words[3::2])}
        else:
            head.append(line)
    return vertices, triangles, head, [weights.get(v, {}) for v in range(len(vertices))]


def subdivide(vertices, triangles, weights):
    middle = {}

    def between(a, b):
        key = (min(a, b), max(a, b))
        if key not in middle:
            middle[key] = len(vertices)
            vertices.append([(x + y) / 2 for x, y in zip(vertices[a], vertices[b])])
            row = {}
            for side in (weights[a], weights[b]) if weights[a] and weights[b] else ():
                for joint, weight in side.items():
                    row[joint] = row.get(joint, 0) + weight / 2
            weights.append(row)
        return middle[key]

    finer = []
    for a, b, c in triangles:
        ab, bc, ca = between(a, b), between(b, c), between(c, a)
        finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return finer


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    sinew, source, out = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    limits = [int(x) for x in sys.argv[4:]] or [16384, 32768, 65536, 4000000]
    out.mkdir(parents=True, exist_ok=True)
    for obj in sorted(source.glob("*.obj")):
        vertices, triangles, head, weights = read(obj)
        if len(vertices) < LEAST_VERTICES or not any(weights):
            continue
        for _ in range(ROUNDS):
            triangles = subdivide(vertices, triangles, weights)
        with open(out / obj.name, "w") as file:
            file.writelines("v %.7g %.7g %.7g\n" % tuple(v) for v in vertices)
            file.writelines("f %d %d %d\n" % tuple(c + 1 for c in t) for t in triangles)
        with open(out / (obj.stem + ".rig.txt"), "w") as file:
            file.writelines(line + "\n" for line in head)
            for v, row in enumerate(weights):
                if row:
                    file.write("skin %d %s\n" % (v, " ".join("%s %.6f" % item for item in row.items())))
    print("| limit | characters | vertices | L1 | argmax % | mean distance | s a character |")
    print("|---|---|---|---|---|---|---|")
    for limit in limits:
        found = subprocess.run(
            [sinew, "eval", str(out), "--surface-vertices", str(limit), "--jobs", "1", "--json"],
            check=True, capture_output=True, text=True)
        rows = list(next(one for one in json.loads(found.stdout).values() if isinstance(one, dict))["characters"].values())
        mean = lambda key: sum(row[key] for row in rows) / len(rows)
        print("| %d | %d | %d to %d | %.4f | %.1f | %.5f | %.2f |" % (
            limit, len(rows), min(r["vertices"] for r in rows), max(r["vertices"] for r in rows), mean("l1"),
            100 * mean("argmax"), mean("avg_dist"), mean("seconds")), flush=True)


if __name__ == "__main__":
    main()
