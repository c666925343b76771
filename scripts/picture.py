#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws bound characters (NAME.obj + NAME.rig.txt) side by side as one SVG: faces shaded and coloured by their joints' weights.

    scripts/picture.py OUT.svg NAME.obj:NAME.rig.txt [...]

The README's picture, from the repository's root after the README's build:

    for n in biped__robed quadruped__tailed; do
      build/release/sinew bind samples/data/$n.obj --skeleton samples/data/$n.rig.txt -o build/$n.rig.txt
    done
    scripts/picture.py samples/data/picture.svg samples/data/biped__robed.obj:build/biped__robed.rig.txt \\
      samples/data/quadruped__tailed.obj:build/quadruped__tailed.rig.txt
"""
import colorsys
import math
import sys

HEIGHT = 420  # pixels of one panel
YAW, PITCH = math.radians(32), math.radians(12)
LIGHT = (0.35, 0.6, 0.72)


def read(obj, rig):
    points, faces, names, skin = [], [], {}, {}
    for line in open(obj):
        w = line.split()
        if w[:1] == ["v"]:
            points.append([float(x) for x in w[1:4]])
        elif w[:1] == ["f"]:
            faces.append([int(t.split("/")[0]) - 1 for t in w[1:]])
    for line in open(rig):
        w = line.split()
        if w[:1] == ["joints"]:
            names[w[1]] = len(names)
        elif w[:1] == ["skin"]:
            skin[int(w[1])] = [(names[w[i]], float(w[i + 1])) for i in range(2, len(w), 2)]
    return points, faces, skin


def joint_colour(joint):
    return colorsys.hsv_to_rgb(joint * 0.61803398875 % 1, 0.62 if joint % 2 else 0.45, 0.95)


def turn(p):
    x, y, z = p
    x, z = x * math.cos(YAW) - z * math.sin(YAW), x * math.sin(YAW) + z * math.cos(YAW)
    y, z = y * math.cos(PITCH) - z * math.sin(PITCH), y * math.sin(PITCH) + z * math.cos(PITCH)
    return x, y, z


def panel(points, faces, skin, left):
    turned = [turn(p) for p in points]
    low = [min(p[i] for p in turned) for i in (0, 1)]
    high = [max(p[i] for p in turned) for i in (0, 1)]
    scale = (HEIGHT - 20) / max(high[1] - low[1], (high[0] - low[0]) * 0.8)
    width = (high[0] - low[0]) * scale + 40
    out = []
    for face in sorted(faces, key=lambda f: sum(turned[v][2] for v in f) / len(f)):
        a, b, c = (turned[v] for v in face[:3])
        u, w = [b[i] - a[i] for i in range(3)], [c[i] - a[i] for i in range(3)]
        n = [u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]]
        length = math.sqrt(sum(x * x for x in n)) or 1
        shade = 0.45 + 0.55 * abs(sum(n[i] * LIGHT[i] for i in range(3))) / length
        rgb = [0.0, 0.0, 0.0]
        for v in face:
            for joint, weight in skin.get(v, []):
                for i, x in enumerate(joint_colour(joint)):
                    rgb[i] += x * weight / len(face)
        colour = "#" + "".join("%02x" % min(255, int(255 * x * shade)) for x in rgb)
        path = " ".join("%d,%d" % (left + 20 + (turned[v][0] - low[0]) * scale, HEIGHT - 10 - (turned[v][1] - low[1]) * scale)
                        for v in face)
        out.append('<polygon points="%s" fill="%s" stroke="%s"/>' % (path, colour, colour))
    return out, left + width


def main():
    if len(sys.argv) < 3 or any(":" not in pair for pair in sys.argv[2:]):
        sys.exit(__doc__)
    shapes, left = [], 0.0
    for pair in sys.argv[2:]:
        more, left = panel(*read(*pair.split(":")), left)
        shapes += more
    with open(sys.argv[1], "w") as f:
        f.write('<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d" stroke-width="0.6">\n' % (left, HEIGHT))
        f.write("\n".join(shapes) + "\n</svg>\n")


if __name__ == "__main__":
    main()
