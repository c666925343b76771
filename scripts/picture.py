#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the README's picture, an animated PNG, by the command: a bare mesh, the skeleton that it gets, and its weights in a walk.

    scripts/picture.py build/release/sinew samples/data/quadruped__tailed.obj samples/data/picture.png

Needs Python alone. Takes half a minute.
"""
import colorsys
import json
import math
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

WIDTH, HEIGHT = 260, 400  # of one of the three panels
SAMPLES = 2  # along each side of a pixel
FRAMES = 16  # of the walk's cycle
YAW, PITCH = math.radians(32), math.radians(10)
LIGHT = (0.35, 0.55, 0.76)
PAPER, BARE, BONE = (247, 248, 250), (178, 184, 194), (214, 60, 48)


def run(*words):
    subprocess.run([str(word) for word in words], check=True, stdout=subprocess.DEVNULL)


def read_obj(path):
    points, triangles = [], []
    for line in open(path, encoding="utf-8"):
        words = line.split()
        if words[:1] == ["v"]:
            points.append(tuple(float(x) for x in words[1:4]))
        elif words[:1] == ["f"]:
            corners = [int(word.split("/")[0]) - 1 for word in words[1:]]
            triangles += [(corners[0], b, c) for b, c in zip(corners[1:], corners[2:])]
    return points, triangles


def read_rig(path):
    """Joints' positions by name, (parent, child) pairs, and the row of each vertex."""
    joints, bones, skin = {}, [], {}
    for line in open(path, encoding="utf-8"):
        words = line.split()
        if words[:1] == ["joints"]:
            joints[words[1]] = tuple(float(x) for x in words[2:5])
        elif words[:1] == ["hier"]:
            bones.append((words[1], words[2]))
        elif words[:1] == ["skin"]:
            skin[int(words[1])] = [(words[i], float(words[i + 1])) for i in range(2, len(words), 2)]
    return joints, bones, skin


def weight_colors(joints, skin, count):
    palette = {name: colorsys.hsv_to_rgb(i * 0.61803398875 % 1, 0.62 if i % 2 else 0.42, 0.95) for i, name in enumerate(joints)}
    colors = []
    for vertex in range(count):
        row = skin.get(vertex, [])
        colors.append(tuple(255 * sum(palette[name][i] * weight for name, weight in row) for i in range(3)) if row else BARE)
    return colors


def view(point):
    """World axes to image axes: x right, y up, z toward the viewer."""
    x, y, z = point
    x, z = x * math.cos(YAW) - z * math.sin(YAW), x * math.sin(YAW) + z * math.cos(YAW)
    y, z = y * math.cos(PITCH) - z * math.sin(PITCH), y * math.sin(PITCH) + z * math.cos(PITCH)
    return x, y, z


class Frame:
    """What all panels share: which part of the image plane they show."""

    def __init__(self, points):
        seen = [view(p) for p in points]
        low = [min(p[i] for p in seen) for i in (0, 1)]
        high = [max(p[i] for p in seen) for i in (0, 1)]
        self.scale = SAMPLES * min(0.92 * WIDTH / (high[0] - low[0]), 0.92 * HEIGHT / (high[1] - low[1]))
        self.middle = [(low[i] + high[i]) / 2 for i in (0, 1)]

    def pixel(self, point):
        x, y, z = view(point)
        return SAMPLES * WIDTH / 2 + (x - self.middle[0]) * self.scale, SAMPLES * HEIGHT / 2 - (y - self.middle[1]) * self.scale, z


def normals_of(points, triangles):
    normals = [[0.0, 0.0, 0.0] for _ in points]
    for triangle in triangles:
        a, b, c = (points[v] for v in triangle)
        u, w = [b[i] - a[i] for i in range(3)], [c[i] - a[i] for i in range(3)]
        n = (u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0])
        for vertex in triangle:
            for i in range(3):
                normals[vertex][i] += n[i]
    return normals


def draw(frame, points, triangles, colors):
    """Rows of (r, g, b) at SAMPLES times the panel's size, smooth shading and a depth buffer."""
    width, height = SAMPLES * WIDTH, SAMPLES * HEIGHT
    rows = [[PAPER] * width for _ in range(height)]
    depth = [[-1e30] * width for _ in range(height)]
    pixels = [frame.pixel(p) for p in points]
    shaded = []
    for normal, color in zip(normals_of(points, triangles), colors):
        n = view(normal)
        length = math.sqrt(sum(x * x for x in n)) or 1
        shade = 0.42 + 0.58 * abs(sum(x * y for x, y in zip(n, LIGHT))) / length
        shaded.append(tuple(x * shade for x in color))
    for triangle in triangles:
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (pixels[v] for v in triangle)
        area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
        if area == 0:
            continue
        color = [shaded[v] for v in triangle]
        for y in range(max(0, math.ceil(min(ay, by, cy))), min(height - 1, math.floor(max(ay, by, cy))) + 1):
            for x in range(max(0, math.ceil(min(ax, bx, cx))), min(width - 1, math.floor(max(ax, bx, cx))) + 1):
                v = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / area
                w = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / area
                u = 1 - v - w
                if u < 0 or v < 0 or w < 0:
                    continue
                z = u * az + v * bz + w * cz
                if z > depth[y][x]:
                    depth[y][x] = z
                    rows[y][x] = tuple(u * a + v * b + w * c for a, b, c in zip(*color))
    return rows


def draw_bones(frame, rows, joints, bones):
    def disk(x, y, radius, color):
        for j in range(math.ceil(y - radius), math.floor(y + radius) + 1):
            for i in range(math.ceil(x - radius), math.floor(x + radius) + 1):
                if (i - x) ** 2 + (j - y) ** 2 <= radius * radius and 0 <= j < len(rows) and 0 <= i < len(rows[0]):
                    rows[j][i] = color

    for parent, child in bones:
        (ax, ay, _), (bx, by, _) = frame.pixel(joints[parent]), frame.pixel(joints[child])
        steps = max(1, math.ceil(math.hypot(bx - ax, by - ay)))
        for step in range(steps + 1):
            t = step / steps
            disk(ax + t * (bx - ax), ay + t * (by - ay), SAMPLES * (2.6 - 1.4 * t), BONE)
    for point in joints.values():
        x, y, _ = frame.pixel(point)
        disk(x, y, SAMPLES * 3.4, BONE)
        disk(x, y, SAMPLES * 1.8, (255, 255, 255))


def smaller(rows):
    """Means of SAMPLES x SAMPLES, five bits a channel."""
    share = SAMPLES * SAMPLES
    out = []
    for y in range(0, len(rows), SAMPLES):
        line = []
        for x in range(0, len(rows[0]), SAMPLES):
            cell = [rows[y + j][x + i] for j in range(SAMPLES) for i in range(SAMPLES)]
            line.append(tuple(min(31, round(sum(p[c] for p in cell) / share / 255 * 31)) for c in range(3)))
        out.append(line)
    return out


def palette_of(pictures):
    counts = {}
    for picture in pictures:
        for line in picture:
            for color in line:
                counts[color] = counts.get(color, 0) + 1
    palette = sorted(counts, key=lambda color: (-counts[color], color))[:256]
    index = {color: i for i, color in enumerate(palette)}
    for color in counts:
        if color not in index:
            index[color] = min(range(len(palette)), key=lambda i: sum((a - b) ** 2 for a, b in zip(palette[i], color)))
    return palette, index


def packed(picture, index):
    return zlib.compress(b"".join(b"\0" + bytes(index[color] for color in line) for line in picture), 9)


def write_apng(path, still, moving, seconds):
    """`still` is left of `moving`, whose pictures follow each other for ever, all of them in `seconds`."""
    palette, index = palette_of([still, *moving])
    left, width = len(still[0]), len(moving[0][0])
    sequence = 0
    out = [b"\x89PNG\r\n\x1a\n"]

    def chunk(name, data):
        out.append(struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data)))

    chunk(b"IHDR", struct.pack(">IIBBBBB", left + width, HEIGHT, 8, 3, 0, 0, 0))
    chunk(b"acTL", struct.pack(">II", len(moving), 0))
    chunk(b"PLTE", b"".join(bytes(round(x / 31 * 255) for x in color) for color in palette))
    for number, picture in enumerate(moving):
        x, shown = (left, picture) if number else (0, [a + b for a, b in zip(still, picture)])
        chunk(b"fcTL", struct.pack(">IIIIIHHBB", sequence, len(shown[0]), HEIGHT, x, 0, round(1000 * seconds / len(moving)), 1000, 0, 0))
        sequence += 1
        if number:
            chunk(b"fdAT", struct.pack(">I", sequence) + packed(shown, index))
            sequence += 1
        else:
            chunk(b"IDAT", packed(shown, index))
    chunk(b"IEND", b"")
    pathlib.Path(path).write_bytes(b"".join(out))


def walk_of(sinew, mesh, folder):
    """Points of every frame, triangles, colors by weight, and how long the cycle is."""
    run(sinew, "animate", mesh, "--motion", "builtin:walk", "--in-place", "-o", folder / "walk.glb")
    run(sinew, "bind", folder / "walk.glb", "--lock", "all", "-o", folder / "walk.rig.txt")
    joints, _, skin = read_rig(folder / "walk.rig.txt")
    answer = subprocess.run([sinew, "inspect", folder / "walk.glb", "--json"], check=True, capture_output=True, text=True).stdout
    seconds = json.loads(answer)["motion"]["clips"][0]["seconds"]
    frames = []
    for number in range(FRAMES):
        run(sinew, "pose", folder / "walk.glb", "--animation", "walk", "--time", f"{number * seconds / FRAMES:.4f}", "-o", folder / "frame.obj")
        points, triangles = read_obj(folder / "frame.obj")
        frames.append(points)
    return frames, triangles, weight_colors(joints, skin, len(points)), seconds


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    sinew, mesh, picture = sys.argv[1:]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        bare = shutil.copy(mesh, folder / "bare.obj")  # without a skeleton beside it
        run(sinew, "rig", bare, "-o", folder / "rig.rig.txt")
        joints, bones, _ = read_rig(folder / "rig.rig.txt")
        frames, walked, colors, seconds = walk_of(sinew, bare, folder)
    points, triangles = read_obj(mesh)
    frame = Frame([p for moved in frames for p in moved] + points)
    plain = draw(frame, points, triangles, [BARE] * len(points))
    rigged = draw(frame, points, triangles, [tuple(255 - 0.55 * (255 - x) for x in BARE)] * len(points))
    draw_bones(frame, rigged, joints, bones)
    still = [a + b for a, b in zip(smaller(plain), smaller(rigged))]
    write_apng(picture, still, [smaller(draw(frame, moved, walked, colors)) for moved in frames], seconds)


if __name__ == "__main__":
    main()
