#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Learns what kind of body an outline is of, and writes the table of character/src/picture/outline_class_table.hpp.

    scripts/outline_class.py SINEW CHARACTERS OPENCLIPART OUT.hpp [--seed 0]

SINEW        the command: finds the figures of pictures; sinew-lab beside it makes characters (`dataset synthesize`)
CHARACTERS   folder of NAME.obj + NAME.rig.txt that are trained on; kinds of body come from their names (KINDS)
OPENCLIPART  png folder of Debian's openclipart-png (public domain); kinds in trainer/configs/outline_class.tsv

Characters are sampled, posed in the picture plane (every joint turned at random) and seen from where their kind is
drawn; figures of clip art are turned, sheared and stretched a little. Features and network are those of
outline_class.cpp, in the same integers. Deterministic for one version of numpy and PIL; about three minutes. Needs numpy and PIL.
"""
import argparse
import glob
import os
import re
import subprocess
import tempfile
import zlib

import numpy as np
from PIL import Image, ImageFilter

CLASSES = ["biped", "quadruped", "bird", "fish", "snake", "many-legged"]
SHARES = [3.0, 1.5, 0.8, 0.6, 0.15, 0.25]  # how often a kind is drawn; most drawings are of people
CELLS, FINE, HIDDEN, STEPS = 24, 72, 48, 9000
PICTURE_SHARE = 0.4  # of the draws
# Of names, the first that matches; None: left out, as what is no body or of two kinds is.
KINDS = [
    (r"animalworld__004_Frog|Kangaroo|Koala|Monkey|hackmit__000|Fauna_|sk_kianga|dmobs__001|draconis__00[01]|YellowDragon|sk_bamba|sk_crimson42|scene_transformed", None),
    (r"hand|gun|fruit|dead_tree|scary_tree|q_monsters20__Tree|lower|Flora|robot_(allegro|barrett|kuka|panda|ur|widowx|racecar)|finger_edu|Tank|elysed_ghost|q_monsters20__Ghost|vr_|JoeJeff|firstperson|FP_|Enemy_Small|ExtraSmall|Skull|Gooey|drone|fantasma", None),
    (r"snake", "snake"),
    (r"antlion|[Cc]rab|Lobster|lobster|Locust|Scorpion|[Ss]pider|Roach|ant_queen|mantis|kraken", "many-legged"),
    (r"wyvern|wasp|(monsters20|platformer)__Bee$|butterfly|[Cc]hicken|_owl$|Blackgrouse|Parrot|Eagle|eagle|Tern|Chick|gull|kiwi|phoenix|penguin|yofrankie__001|q_monsters20__Bat|Enemy_Flying", "bird"),
    (r"[Ff]ish|Whale|Piranha|Betta|Puffer|[Ss]hark|[Rr]ay$|jelly|q_fish", "fish"),
    (r"robot_(hyq|quadruped)|q_animals|q_farm|animalia|animalworld|krupnov|q_cube__(Animals|cat)|yofrankie__00[2-9]|_Rat$|_rat$|[Ff]ox|_sheep$|horse|nssm__00[26]|_cat$|crystal_deer|giraffe|_bear$|_lion$|sk_gekkoslo", "quadruped"),
    (r"", "biped"),
]
PLANS = {"biped": "biped", "toy": "biped", "blob": "biped", "mascot": "biped", "dinosaur": "biped",
         "quadruped": "quadruped", "beast": "quadruped", "bird": "bird", "fowl": "bird", "fish": "fish",
         "snake": "snake", "many-legged": "many-legged", "crawler": "many-legged"}


def kind_of(name):
    return next(kind for pattern, kind in KINDS if re.search(pattern, name))


def read_character(path, count):
    """Points of the surface with the joint they follow most, joints, parents (parents first)."""
    points, triangles = [], []
    for line in open(path):
        w = line.split()
        if w[:1] == ["v"]:
            points.append([float(x) for x in w[1:4]])
        elif w[:1] == ["f"]:
            f = [int(t.split("/")[0]) - 1 for t in w[1:]]
            triangles += [(f[0], f[k], f[k + 1]) for k in range(1, len(f) - 1)]
    names, places, parents, strongest = {}, [], {}, np.zeros(len(points), int)
    for line in open(path[:-4] + ".rig.txt"):
        w = line.split()
        if w[:1] == ["joints"]:
            names[w[1]] = len(names)
            places.append([float(x) for x in w[2:5]])
        elif w[:1] == ["hier"]:
            parents[names[w[2]]] = names[w[1]]
        elif w[:1] == ["skin"]:
            rows = [(float(w[i + 1]), names[w[i]]) for i in range(2, len(w), 2)]
            strongest[int(w[1])] = max(rows)[1] if rows else 0
    points, triangles = np.array(points), np.array(triangles)
    corners = points[triangles]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    rng = np.random.default_rng(1)
    t = rng.choice(len(triangles), count, p=area / area.sum())
    u = rng.random((count, 2))
    u[u.sum(1) > 1] = 1 - u[u.sum(1) > 1]
    share = np.stack([1 - u.sum(1), u[:, 0], u[:, 1]], 1)
    order, known = [], set()
    while len(order) < len(places):
        new = [j for j in range(len(places)) if j not in known and parents.get(j, -1) in known | {-1}]
        if not new:
            return None
        order += new
        known |= set(new)
    samples = (corners[t] * share[:, :, None]).sum(1)
    return samples, strongest[triangles[t, share.argmax(1)]], np.array(places), parents, order


def direction(kind, rng):
    """Yaw and elevation in degrees from which a kind of body is drawn."""
    r, side = rng.random(), rng.choice([-90, 90])
    yaw = {"biped": rng.normal(0, 22) if r < 0.75 else side + rng.normal(0, 20),
           "quadruped": side + rng.normal(0, 18) if r < 0.88 else side * 5 / 9 + rng.normal(0, 10),
           "bird": rng.normal(0, 20) if r < 0.35 else side + rng.normal(0, 25),
           "many-legged": rng.uniform(-180, 180)}.get(kind, side + rng.normal(0, 18))
    up = {"many-legged": rng.uniform(0, 90), "snake": rng.uniform(0, 70)}.get(kind, rng.normal(6, 7))
    return yaw, rng.uniform(-60, 60) if kind == "bird" and r > 0.8 else up


def drawn(character, kind, rng):
    """[24, 24] how much of a cell the posed body covers, 0..255."""
    samples, joint, places, parents, order = character
    yaw, up = np.radians(direction(kind, rng))
    turn = np.array([[np.cos(yaw), 0, np.sin(yaw)], [0, 1, 0], [-np.sin(yaw), 0, np.cos(yaw)]])
    tilt = np.array([[1, 0, 0], [0, np.cos(up), -np.sin(up)], [0, np.sin(up), np.cos(up)]])
    flat, centres = ((tilt @ turn) @ samples.T).T[:, :2], ((tilt @ turn) @ places.T).T[:, :2]
    spread = rng.choice([0, 6, 14, 25, 40], p=[0.2, 0.2, 0.25, 0.2, 0.15])
    angles = np.radians(rng.normal(0, 1, len(places)) * spread) * (rng.random(len(places)) < 0.6)
    at = np.zeros((len(places), 2, 3))
    for j in order:
        c, s = np.cos(angles[j]), np.sin(angles[j])
        r = np.array([[c, -s], [s, c]])
        own = np.concatenate([r, (centres[j] - r @ centres[j])[:, None]], 1)
        if j in parents:
            above = at[parents[j]]
            own = np.concatenate([above[:, :2] @ own[:, :2], (above[:, :2] @ own[:, 2] + above[:, 2])[:, None]], 1)
        at[j] = own
    p = np.einsum("nij,nj->ni", at[joint][:, :, :2], flat) + at[joint][:, :, 2]
    lean = np.radians(rng.normal(0, 7))
    p = p @ np.array([[np.cos(lean), np.sin(lean)], [-np.sin(lean), np.cos(lean)]])
    low, high = p.min(0), p.max(0)
    size = max((high - low).max(), 1e-9) * 1.0001
    q = np.clip((p - low + (size - (high - low)) / 2) / size * FINE, 0, FINE - 1).astype(int)
    dots = np.zeros((FINE + 8, FINE + 8), np.uint8)
    dots[FINE + 3 - q[:, 1], q[:, 0] + 4] = 255
    closed = Image.fromarray(dots).filter(ImageFilter.MaxFilter(5)).filter(ImageFilter.MinFilter(5))
    fine = np.asarray(closed)[4:-4, 4:-4].reshape(CELLS, FINE // CELLS, CELLS, FINE // CELLS)
    return fine.mean((1, 3)).astype(np.uint8)


def cells_of(mask):
    """As outline_cells() of outline_class.cpp."""
    ys, xs = np.nonzero(mask)
    mask = mask[ys.min():ys.max() + 1, xs.min():xs.max() + 1].astype(np.int64)
    size = max(mask.shape)
    square = np.zeros((size, size), np.int64)
    y, x = (size - mask.shape[0]) // 2, (size - mask.shape[1]) // 2
    square[y:y + mask.shape[0], x:x + mask.shape[1]] = mask
    edges = np.arange(CELLS + 1) * size // CELLS
    out = np.zeros((CELLS, CELLS), np.uint8)
    for i in range(CELLS):
        for j in range(CELLS):
            part = square[edges[i]:max(edges[i + 1], edges[i] + 1), edges[j]:max(edges[j + 1], edges[j] + 1)]
            out[i, j] = 255 * part.sum() // part.size
    return out


def features(cells):
    """[N, 24, 24] to [N, 245], 0..255: as outline_features() of outline_class.cpp."""
    x = cells.astype(np.int64)
    n, solid = len(x), x > 64
    across = x.transpose(0, 2, 1)

    def pairs(a, f):
        return f(a.reshape(n, CELLS // 2, 2), 2)

    def runs(b):
        before = np.concatenate([np.zeros((n, CELLS, 1), bool), b[:, :, :-1]], 2)
        return np.minimum(pairs((b & ~before).sum(2), np.max), 4) * 63

    def ends(b):
        some = b.any(2)
        first = np.where(some, b.argmax(2), CELLS // 2)
        last = np.where(some, CELLS - 1 - b[:, :, ::-1].argmax(2), CELLS // 2)
        return [pairs(first, np.min) * 10, pairs(last, np.max) * 10]

    total = x.sum((1, 2))
    wide, high = np.maximum(solid.any(1).sum(1), 1), np.maximum(solid.any(2).sum(1), 1)
    flipped = x[:, :, ::-1]
    alike = 255 * np.minimum(x, flipped).sum((1, 2)) // np.maximum(np.maximum(x, flipped).sum((1, 2)), 1)
    shape = np.stack([wide * 10, high * 10, total // CELLS**2, np.minimum(255, total // (wide * high)), alike], 1)
    half = x.reshape(n, CELLS // 2, 2, CELLS // 2, 2).sum((2, 4)) // 4
    cover = [a.reshape(n, CELLS // 2, 2 * CELLS).sum(2) // (2 * CELLS) for a in (x, across)]
    down = solid.transpose(0, 2, 1)
    return np.concatenate([runs(solid), runs(down), *cover, *ends(solid), *ends(down), shape, half.reshape(n, -1)], 1)


def of_characters(sinew, folder):
    with tempfile.TemporaryDirectory() as made:
        for plan in PLANS:
            subprocess.run([sinew + "-lab", "dataset", "synthesize", "--plan", plan, "--seed", "2000", "--count", "60",
                            "--resolution", "24", "-o", made], check=True, stdout=subprocess.DEVNULL)
        for path in sorted(glob.glob(folder + "/*.obj")) + sorted(glob.glob(made + "/*.obj")):
            name = os.path.basename(path)[:-4]
            synthetic = path.startswith(made)
            family = name.split("__")[0]
            kind = PLANS[family] if synthetic else kind_of(name)
            number = re.search(r"__(\d+)", name)
            if family in ("mh_train", "mh_ponytail_train") and int(number[1]) % 6:
                continue
            if family == "rocketbox" and int(number[1]) % 3:
                continue
            character = read_character(path, 5000) if kind else None
            if character is None:
                continue
            rng = np.random.default_rng(zlib.crc32(name.encode()))
            many = 16 if synthetic else 60
            yield [drawn(character, kind, rng) for _ in range(many)], kind, ("made " if synthetic else "") + family


def of_pictures(sinew, folder, rng):
    table = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "trainer/configs/outline_class.tsv")
    with tempfile.TemporaryDirectory() as scratch:
        for line in open(table):
            if line.startswith("#"):
                continue
            name, kind = line.rstrip("\n").split("\t")
            mask, rig = scratch + "/mask.png", scratch + "/x.rig.txt"
            if subprocess.run([sinew, "rig", os.path.join(folder, name), "--class", kind, "--no-bind", "--mask-out", mask,
                               "-o", rig], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode:
                continue
            image = Image.open(mask).convert("L")
            cells = [cells_of(np.asarray(image) > 127)]
            image.thumbnail((260, 260))
            for _ in range(12):
                lean, size, shear = rng.normal(0, 9), np.exp(rng.normal(0, 0.12)), rng.normal(0, 0.12)
                scaled = image.resize((max(8, int(image.width * size)), max(8, int(image.height / size))))
                side = scaled.width + scaled.height
                big = Image.new("L", (side, side))
                big.paste(scaled, ((side - scaled.width) // 2, (side - scaled.height) // 2))
                big = big.rotate(lean, Image.BILINEAR)
                big = big.transform((side, side), Image.AFFINE, (1, shear, -shear * side / 2, 0, 1, 0), Image.BILINEAR)
                solid = np.asarray(big) > 127
                if solid.sum() >= 100:
                    cells.append(cells_of(solid))
            yield cells, kind


def shares_of(kinds, families):
    _, index = np.unique(families, return_inverse=True)
    weight = 1 / np.sqrt(np.bincount(index)[index])
    for k, share in enumerate(SHARES):
        weight[kinds == k] *= share / max(weight[kinds == k].sum(), 1e-9)
    return weight / weight.sum()


def trained(x, kinds, weight, seed):
    """One hidden layer, ReLU; Adam, labels smoothed, noise on inputs, averaged weights. x is standardised."""
    rng = np.random.default_rng(seed)
    upto = np.cumsum(weight) / weight.sum()
    n, count, batch, smooth = x.shape[1], len(CLASSES), 256, 0.08
    w = [rng.normal(0, 1 / np.sqrt(n), (n, HIDDEN)), np.zeros(HIDDEN),
         rng.normal(0, 1 / np.sqrt(HIDDEN), (HIDDEN, count)), np.zeros(count)]
    mean, square, average = [0 * a for a in w], [0 * a for a in w], [a.copy() for a in w]
    for t in range(1, STEPS + 1):
        i = np.minimum(np.searchsorted(upto, rng.random(batch)), len(x) - 1)
        b = x[i] + rng.normal(0, 0.4, (batch, n))
        h = b @ w[0] + w[1]
        a = np.maximum(h, 0)
        o = a @ w[2] + w[3]
        e = np.exp(o - o.max(1, keepdims=True))
        wanted = np.full((batch, count), smooth / count)
        wanted[np.arange(batch), kinds[i]] += 1 - smooth
        g = (e / e.sum(1, keepdims=True) - wanted) / batch
        back = (g @ w[2].T) * (h > 0)
        rate = 3e-3 * (0.5 + 0.5 * np.cos(np.pi * t / STEPS))
        for k, d in enumerate((b.T @ back, back.sum(0), a.T @ g, g.sum(0))):
            mean[k] = 0.9 * mean[k] + 0.1 * d
            square[k] = 0.999 * square[k] + 0.001 * d * d
            step = mean[k] / (1 - 0.9**t) / (np.sqrt(square[k] / (1 - 0.999**t)) + 1e-8)
            w[k] = w[k] - rate * (step + (3e-3 * w[k] if k in (0, 2) else 0))
            average[k] = 0.995 * average[k] + 0.005 * w[k]
    return average


def table_of(name, values, kind):
    lines, line = [], "   "
    for v in np.asarray(values).reshape(-1):
        if len(line) + len(str(v)) + 2 > 140:
            lines.append(line)
            line = "   "
        line += " " + str(v) + ","
    return f"inline constexpr {kind} {name}[{np.asarray(values).size}] = {{\n" + "\n".join([*lines, line]) + "\n};\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("sinew", "characters", "openclipart", "out"):
        parser.add_argument(name)
    parser.add_argument("--seed", type=int, default=0)
    o = parser.parse_args()
    cells, kinds, families = [], [], []
    for drawn_cells, kind, family in of_characters(o.sinew, o.characters):
        cells += drawn_cells
        kinds += [CLASSES.index(kind)] * len(drawn_cells)
        families += [family] * len(drawn_cells)
    weight = shares_of(np.array(kinds), np.array(families)) * (1 - PICTURE_SHARE)
    first = len(cells)
    for found, kind in of_pictures(o.sinew, o.openclipart, np.random.default_rng(3)):
        cells += found
        kinds += [CLASSES.index(kind)] * len(found)
    of_picture = np.array(kinds[first:])
    picture_weight = shares_of(of_picture, np.zeros(len(of_picture)))
    weight = np.concatenate([weight, picture_weight * PICTURE_SHARE])
    cells, kinds = np.array(cells), np.array(kinds)
    x = np.concatenate([features(cells), features(cells[:, :, ::-1])]) / 255
    middle, spread = x[:2 * first].mean(0), x[:2 * first].std(0) + 0.05
    w = trained((x - middle) / spread, np.concatenate([kinds, kinds]), np.concatenate([weight, weight]), o.seed)
    print(f"{first} of characters, {len(cells) - first} of pictures")
    # Inputs stay 0..255; weights Q18 and Q12, biases Q18 and Q20.
    first_weights = np.round(w[0] / spread[:, None] / 255 * 2**18).astype(int)
    first_biases = np.round((w[1] - (middle / spread) @ w[0]) * 2**18).astype(int)
    with open(o.out, "w") as f:
        f.write("// SPDX-License-Identifier: MIT\n// Made by scripts/outline_class.py.\n"
                "#ifndef SINEW_CHARACTER_PICTURE_OUTLINE_CLASS_TABLE_HPP\n"
                "#define SINEW_CHARACTER_PICTURE_OUTLINE_CLASS_TABLE_HPP\n\n#include <cstdint>\n\n// clang-format off\n"
                "namespace sinew {\n\n"
                f"inline constexpr int kOutlineHidden = {HIDDEN};\n"
                "// [245 x hidden] Q18, [hidden] Q18, [hidden x 6] Q12, [6] Q20.\n")
        f.write(table_of("kOutlineFirst", first_weights, "int16_t"))
        f.write(table_of("kOutlineFirstBias", first_biases, "int32_t"))
        f.write(table_of("kOutlineSecond", np.round(w[2] * 2**12).astype(int), "int16_t"))
        f.write(table_of("kOutlineSecondBias", np.round(w[3] * 2**20).astype(int), "int32_t"))
        f.write("\n}  // namespace sinew\n// clang-format on\n#endif\n")


main()
