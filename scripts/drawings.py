#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws the pictures of samples/data: capsules and ellipses with outlines, by distances, as PNG. Needs numpy.

  drawings.py [FOLDER]     writes drawing__*.png into FOLDER (samples/data unless given); the same bytes every time
"""
import pathlib
import struct
import sys
import zlib

import numpy as np

INK = (38, 34, 46)
SUPER = 3  # samples a pixel and axis


def capsule(ax, ay, bx, by, ra, rb=None):
    """A limb from a to b, ra thick at a and rb at b."""
    rb = ra if rb is None else rb

    def distance(x, y):
        dx, dy = bx - ax, by - ay
        t = np.clip(((x - ax) * dx + (y - ay) * dy) / max(dx * dx + dy * dy, 1e-9), 0, 1)
        return np.hypot(x - ax - t * dx, y - ay - t * dy) - (ra + (rb - ra) * t)

    return distance


def ellipse(cx, cy, rx, ry):
    def distance(x, y):
        k = np.hypot((x - cx) / rx, (y - cy) / ry)
        return (k - 1) * min(rx, ry)

    return distance


def draw(width, height, shapes, background, ink=2.2):
    """Each shape (distance, color or None for a stroke of ink alone) over the ones before, its outline with it."""
    n = SUPER
    y, x = np.mgrid[0 : height * n, 0 : width * n]
    x, y = (x + 0.5) / n, (y + 0.5) / n
    color = background(x, y)
    for distance, fill in shapes:
        d = distance(x, y)
        color[d < ink] = (*INK, 255)
        if fill is not None:
            color[d < 0] = (*fill, 255)
    sums = color.reshape(height, n, width, n, 4).astype(float)
    alpha = sums[..., 3:].sum((1, 3))
    rgb = (sums[..., :3] * sums[..., 3:]).sum((1, 3)) / np.maximum(alpha, 1)
    return np.concatenate([rgb, alpha / (n * n)], 2).round().astype(np.uint8)


def png(path, pixels, alpha):
    height, width = pixels.shape[:2]
    rows = pixels if alpha else pixels[..., :3]
    raw = b"".join(b"\0" + rows[y].tobytes() for y in range(height))
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    header = struct.pack(">IIBBBBB", width, height, 8, 6 if alpha else 2, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


def flat(color):
    return lambda x, y: np.broadcast_to(np.array(color, np.uint8), (*x.shape, 4)).copy()


def ruled(x, y):
    """Paper that darkens downwards, with blue lines and a red margin."""
    shade = (244 - 16 * (y / y.max())).astype(np.uint8)
    paper = np.stack([shade, shade, (shade * 0.97).astype(np.uint8), np.full_like(shade, 255)], -1)
    paper[(y % 26) < 1] = (168, 188, 214, 255)
    paper[np.abs(x - 40) < 0.6] = (214, 140, 150, 255)
    return paper


def child():
    """From the front, arms apart, on white."""
    skin, shirt, trousers, shoe, hair = (250, 205, 170), (86, 152, 214), (70, 82, 120), (196, 72, 66), (122, 76, 44)
    both = lambda make, fill: [(make(1), fill), (make(-1), fill)]
    c = 180
    shapes = []
    shapes += both(lambda s: capsule(c + s * 22, 300, c + s * 34, 420, 19, 14), trousers)
    shapes += both(lambda s: capsule(c + s * 36, 436, c + s * 54, 440, 13, 11), shoe)
    shapes += both(lambda s: capsule(c + s * 42, 200, c + s * 92, 246, 15, 12), shirt)
    shapes += both(lambda s: capsule(c + s * 92, 246, c + s * 134, 276, 11, 9), skin)
    shapes += both(lambda s: ellipse(c + s * 142, 282, 14, 14), skin)
    shapes += [(capsule(c, 212, c, 290, 46, 40), shirt), (capsule(c, 150, c, 170, 14), skin)]
    shapes += [(ellipse(c, 84, 66, 60), hair), (ellipse(c, 100, 56, 56), skin)]
    shapes += both(lambda s: ellipse(c + s * 20, 94, 6, 8), INK) + [(capsule(c - 16, 124, c + 16, 124, 1), None)]
    return draw(360, 480, shapes, flat((255, 255, 255, 255)))


def cat():
    """From its side, facing right, cut out."""
    fur, far, inner = (232, 160, 84), (196, 126, 60), (246, 206, 176)
    shapes = [(capsule(120, 190, 118, 280, 20, 12), far), (capsule(312, 190, 322, 280, 18, 12), far)]
    shapes += [(capsule(88, 170, 44, 120, 12, 10), fur), (capsule(44, 120, 52, 66, 10, 8), fur)]
    shapes += [(capsule(120, 172, 316, 168, 46, 42), fur), (capsule(318, 160, 368, 116, 34, 30), fur)]
    shapes += [(capsule(92, 190, 84, 282, 22, 13), fur), (capsule(340, 190, 352, 282, 19, 13), fur)]
    shapes += [(capsule(364, 78, 358, 44, 13, 3), fur), (capsule(398, 78, 408, 46, 13, 3), fur)]
    shapes += [(ellipse(384, 104, 46, 42), fur), (ellipse(408, 118, 20, 15), inner), (ellipse(396, 92, 5, 7), INK)]
    return draw(460, 310, shapes, flat((255, 255, 255, 0)))


def sketch():
    """Pen outlines on ruled paper, filled with nothing."""
    c = 190
    limbs = [capsule(c, 150, c, 190, 18), capsule(c - 24, 280, c - 44, 400, 15, 13), capsule(c + 24, 280, c + 44, 400, 15, 13), capsule(c - 40, 190, c - 120, 130, 13, 11),
             capsule(c + 40, 190, c + 120, 130, 13, 11), ellipse(c, 236, 56, 66), ellipse(c, 108, 52, 56), capsule(c - 30, 62, c - 44, 26, 9, 4),
             capsule(c + 30, 62, c + 44, 26, 9, 4)]
    body = lambda x, y: np.min([d(x, y) for d in limbs], axis=0)
    pen = lambda x, y: np.abs(body(x, y)) + 1
    shapes = [(pen, None), (ellipse(c - 18, 100, 4, 4), INK), (ellipse(c + 18, 100, 4, 4), INK), (capsule(c - 14, 132, c + 14, 132, 0.5), None)]
    return draw(380, 460, shapes, ruled)


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[1] / "samples/data")
    png(folder / "drawing__child.png", child(), False)
    png(folder / "drawing__cat.png", cat(), True)
    png(folder / "drawing__sketch.png", sketch(), False)


if __name__ == "__main__":
    main()
