#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Learns what kind of body an outline is of, and writes the table of character/src/picture/outline_class_table.hpp.

    scripts/outline_class.py SINEW CHARACTERS OPENCLIPART OUT.hpp [--seed 0]

SINEW        the command: finds the figures of pictures; sinew-lab beside it makes characters (`dataset synthesize`)
CHARACTERS   folder of NAME.obj + NAME.rig.txt that are trained on; kinds of body come from their names (KINDS)
OPENCLIPART  png folder of Debian's openclipart-png (public domain); kinds in trainer/configs/outline_class.tsv

Characters are sampled, posed in the picture plane (every joint turned at random) and seen from where their kind is
drawn, with large heads and short legs, in dresses, capes and hair, with things in hand, on shadows and grounds, as
drawings have them (`worn`); figures of clip art are turned, sheared and stretched a little. The network is that of outline_class.cpp, whose integers are made of its weights.
Deterministic for one version of numpy and PIL; about half an hour. Needs numpy and PIL.
"""
import argparse
import glob
import os
import re
import subprocess
import tempfile
import zlib

import numpy as np
from PIL import Image, ImageDraw, ImageFilter

CLASSES = ["biped", "quadruped", "bird", "fish", "snake", "many-legged"]
SHARES = [2.6, 1.5, 0.9, 0.6, 0.3, 0.5]  # how often a kind is drawn; most drawings are of people
CELLS, FINE, CHANNELS, HIDDEN = 24, 72, (8, 16, 24), 32
STEPS, BATCH, RATE, DECAY, SMOOTH, DROPPED = 12000, 128, 2e-3, 1e-2, 0.08, 0.1
PICTURE_SHARE = 0.4  # of the draws
WORN_SHARE = 0.6  # of the characters
# Of names, the first that matches; None: left out, as what is no body or of two kinds is.
KINDS = [
    (r"animalworld__004_Frog|Kangaroo|Koala|Monkey|hackmit__000|Fauna_|sk_kianga|dmobs__001|draconis__00[01]|YellowDragon|sk_bamba|sk_crimson42|scene_transformed", None),
    (r"hand|gun|fruit|dead_tree|scary_tree|q_monsters20__Tree|lower|Flora|robot_(allegro|barrett|kuka|panda|ur|widowx|racecar)|finger_edu|Tank|elysed_ghost|q_monsters20__Ghost|vr_|JoeJeff|firstperson|FP_|Enemy_Small|ExtraSmall|Skull|Gooey|drone|fantasma", None),
    (r"cdogs|fantasywarrior|kaiopua|petz|sk_reactorous|0ad_horse_old__001", None),
    (r"snake", "snake"),
    (r"antlion|[Cc]rab|Lobster|lobster|Locust|Scorpion|[Ss]pider|Roach|ant_queen|mantis|kraken|aspiremint", "many-legged"),
    (r"wyvern|wasp|(monsters20|platformer)__Bee$|butterfly|[Cc]hicken|_owl$|Blackgrouse|Parrot|Eagle|eagle|Tern|Chick|gull|kiwi|phoenix|penguin|yofrankie__001|q_monsters20__Bat|Enemy_Flying|0ad_(hawk|peacock)|extremetux|sk_(al_dezel|carbofos|tigerndv)|stk_pidgin", "bird"),
    (r"[Ff]ish|Whale|Piranha|Betta|Puffer|[Ss]hark|[Rr]ay$|jelly|q_fish|0ad_tuna|sk_(dannzjs|dashdu|meleagor)", "fish"),
    (r"robot_(hyq|quadruped)|q_animals|q_farm|animalia|animalworld|krupnov|q_cube__(Animals|cat)|yofrankie__00[2-9]|_Rat$|_rat$|[Ff]ox|_sheep$|horse|nssm__00[26]|_cat$|crystal_deer|giraffe|_bear$|_lion$|sk_gekkoslo|0ad_(?!biped)|assimp_wuson|exeterdad|fishywet|mistere|sk_(firoh|jose_ranieri|ladymito|mirenatxurra|rougher|shakiller)", "quadruped"),
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
    head = [j for j, name in enumerate(names) if re.search("head", name, re.I)][:1]  # and what hangs on it
    for j in order:
        if head and parents.get(j) in head:
            head.append(j)
    return samples, strongest[triangles[t, share.argmax(1)]], np.array(places), parents, order, head


def direction(kind, rng):
    """Yaw and elevation in degrees from which a kind of body is drawn."""
    r, side = rng.random(), rng.choice([-90, 90])
    yaw = {"biped": rng.normal(0, 22) if r < 0.75 else side + rng.normal(0, 20),
           "quadruped": side + rng.normal(0, 18) if r < 0.75 else side * 5 / 9 + rng.normal(0, 10) if r < 0.9 else rng.normal(0, 15),
           "bird": rng.normal(0, 20) if r < 0.35 else side + rng.normal(0, 25),
           "many-legged": rng.uniform(-180, 180)}.get(kind, side + rng.normal(0, 18))
    up = {"many-legged": rng.uniform(0, 90), "snake": rng.uniform(0, 70)}.get(kind, rng.normal(6, 7))
    return yaw, rng.uniform(-60, 60) if kind == "bird" and r > 0.8 else up


def drawn(character, kind, rng):
    """[24, 24] how much of a cell the posed body covers, 0..255."""
    joint, parents, order = character[1], character[3], character[4]
    samples, places = stylized(character, kind, rng)
    yaw, up = np.radians(direction(kind, rng))
    turn = np.array([[np.cos(yaw), 0, np.sin(yaw)], [0, 1, 0], [-np.sin(yaw), 0, np.cos(yaw)]])
    tilt = np.array([[1, 0, 0], [0, np.cos(up), -np.sin(up)], [0, np.sin(up), np.cos(up)]])
    flat, centers = ((tilt @ turn) @ samples.T).T[:, :2], ((tilt @ turn) @ places.T).T[:, :2]
    spread = rng.choice([0, 6, 14, 25, 40], p=[0.2, 0.2, 0.25, 0.2, 0.15])
    angles = np.radians(rng.normal(0, 1, len(places)) * spread) * (rng.random(len(places)) < 0.6)
    at = np.zeros((len(places), 2, 3))
    for j in order:
        c, s = np.cos(angles[j]), np.sin(angles[j])
        r = np.array([[c, -s], [s, c]])
        own = np.concatenate([r, (centers[j] - r @ centers[j])[:, None]], 1)
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
    dots = np.zeros((2 * FINE, 2 * FINE), np.uint8)
    dots[3 * FINE // 2 - 1 - q[:, 1], q[:, 0] + FINE // 2] = 255
    closed = Image.fromarray(dots).filter(ImageFilter.MaxFilter(5)).filter(ImageFilter.MinFilter(5))
    if rng.random() < WORN_SHARE:
        closed = worn(closed, kind, rng)
    return cells_of(np.asarray(closed) > 127)


def stylized(character, kind, rng):
    """A body with a larger head and shorter legs, as many are drawn."""
    samples, joint, places, parents, order, head = character
    if kind not in ("biped", "quadruped") or not head or rng.random() < 0.5:
        return samples, places
    samples, places = samples.copy(), places.copy()
    hip = samples[:, 1].min() + 0.5 * np.ptp(samples[:, 1])
    legs = rng.uniform(0.4, 1)
    for points in (samples, places):
        points[:, 1] = np.where(points[:, 1] < hip, hip + legs * (points[:, 1] - hip), points[:, 1])
    neck, larger = places[head[0]].copy(), rng.uniform(1, 2.3 if kind == "biped" else 1.7)
    for points, own in ((samples, np.isin(joint, head)), (places, np.isin(np.arange(len(places)), head))):
        points[own] = neck + larger * (points[own] - neck)
    return samples, places


def worn(image, kind, rng):
    """The figure with what drawings add to a body: clothes and hair on people; things, shadows and grounds on all."""
    ys, xs = np.nonzero(np.asarray(image) > 127)
    top, bottom = ys.min(), ys.max()
    high, wide, middle = bottom - top + 1, np.ptp(xs) + 1, np.median(xs)
    pen = ImageDraw.Draw(image)

    def ellipse(x, y, rx, ry):
        pen.ellipse([x - rx, y - ry, x + rx, y + ry], fill=255)

    def flared(y0, w0, y1, w1, x1):
        pen.polygon([(middle - w0, y0), (middle + w0, y0), (x1 + w1, y1), (x1 - w1, y1)], fill=255)

    if kind == "biped":
        feet = np.median(xs[ys > bottom - 0.15 * high])
        if rng.random() < 0.3:  # a dress, a coat, wide trousers
            flared(top + rng.uniform(0.4, 0.6) * high, rng.uniform(0.06, 0.14) * high,
                   top + rng.uniform(0.7, 1.0) * high, rng.uniform(0.12, 0.38) * high, feet)
        if rng.random() < 0.12:  # a cape
            flared(top + rng.uniform(0.15, 0.3) * high, rng.uniform(0.08, 0.16) * high,
                   top + rng.uniform(0.55, 1.0) * high, rng.uniform(0.15, 0.4) * high, middle + rng.normal(0, 0.12) * high)
        if rng.random() < 0.35:  # hair, a hat
            crown = np.median(xs[ys < top + 0.1 * high])
            rx, ry = rng.uniform(0.07, 0.2) * high, rng.uniform(0.06, 0.16) * high
            ellipse(crown, top + ry * rng.uniform(0, 1.4), rx, ry)
            if rng.random() < 0.4:
                ellipse(crown + rng.normal(0, 0.1) * high, top + rng.uniform(0.15, 0.3) * high, rx, rng.uniform(0.1, 0.28) * high)
    if rng.random() < 0.25:  # a thing in hand, a sign, a bag
        side = xs.argmin() if rng.random() < 0.5 else xs.argmax()
        x, y = xs[side], ys[side]
        angle, length = rng.uniform(0, 2 * np.pi), rng.uniform(0.1, 0.6) * high
        end = x + length * np.cos(angle), y + length * np.sin(angle)
        pen.line([x, y, *end], fill=255, width=int(rng.integers(1, 5)))
        if rng.random() < 0.5:
            ellipse(*end, rng.uniform(0.03, 0.15) * high, rng.uniform(0.03, 0.15) * high)
    if rng.random() < 0.15:  # fur, feathers, thick lines
        image = image.filter(ImageFilter.MaxFilter(int(rng.choice([3, 5]))))
        pen = ImageDraw.Draw(image)
    if kind != "fish" and rng.random() < 0.2:  # a shadow, a ground
        flat = rng.uniform(0.02, 0.08) * high
        if rng.random() < 0.75:
            ellipse(middle, bottom, rng.uniform(0.35, 0.75) * max(wide, 0.4 * high), flat)
        else:
            half = rng.uniform(0.5, 0.9) * max(wide, 0.4 * high)
            pen.rectangle([middle - half, bottom - flat, middle + half, bottom + flat], fill=255)
    return image


def cells_of(mask):
    """As outline_cells() of outline_class.cpp."""
    ys, xs = np.nonzero(mask)
    mask = mask[ys.min():ys.max() + 1, xs.min():xs.max() + 1].astype(np.int64)
    size = max(mask.shape)
    square = np.zeros((size, size), np.int64)
    y, x = (size - mask.shape[0]) // 2, (size - mask.shape[1]) // 2
    square[y:y + mask.shape[0], x:x + mask.shape[1]] = mask
    sums = np.pad(square, ((1, 0), (1, 0))).cumsum(0).cumsum(1)
    low = np.arange(CELLS) * size // CELLS
    high = np.maximum(np.arange(1, CELLS + 1) * size // CELLS, low + 1)
    inside = sums[high][:, high] - sums[low][:, high] - sums[high][:, low] + sums[low][:, low]
    return (255 * inside // np.outer(high - low, high - low)).astype(np.uint8)


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


def patches(x):
    """[N, H, W, C] to [N H W, 9 C]: what a kernel of 3 x 3 sees, zeros around; rows of the kernel, columns, channels."""
    n, h, w, c = x.shape
    around = np.pad(x, ((0, 0), (1, 1), (1, 1), (0, 0)))
    return np.concatenate([around[:, i:i + h, j:j + w] for i in range(3) for j in range(3)], 3).reshape(n * h * w, 9 * c)


def forward(w, x, keep=None):
    """[N, 24, 24] in 0..1 to logits [N, 6], and what the way back needs."""
    seen, a = [], x[..., None].astype(np.float32)
    for k in range(len(CHANNELS)):
        n, h = a.shape[:2]
        p = patches(a)
        z = p @ w[2 * k] + w[2 * k + 1]
        seen.append((a.shape, p, z > 0))
        a = np.maximum(z, 0).reshape(n, h // 2, 2, h // 2, 2, -1).mean((2, 4))
    flat = a.reshape(len(x), -1)
    if keep is not None:
        flat = flat * keep(flat.shape)
    z = flat @ w[-4] + w[-3]
    hidden = np.maximum(z, 0)
    return hidden @ w[-2] + w[-1], (seen, a.shape, flat, hidden, z > 0)


def backward(w, saved, g):
    seen, shape, flat, hidden, active = saved
    out = [hidden.T @ g, g.sum(0)]
    d = (g @ w[-2].T) * active
    out = [flat.T @ d, d.sum(0), *out]
    d = (d @ w[-4].T).reshape(shape)
    for k in reversed(range(len(CHANNELS))):
        (n, h, _, c), p, positive = seen[k]
        d = np.repeat(np.repeat(d, 2, 1), 2, 2).reshape(n * h * h, -1) / 4 * positive
        out = [p.T @ d, d.sum(0), *out]
        if k == 0:
            break
        back = (d @ w[2 * k].T).reshape(n, h, h, 9, c)
        around = np.zeros((n, h + 2, h + 2, c), np.float32)
        for i in range(9):
            around[:, i // 3:i // 3 + h, i % 3:i % 3 + h] += back[:, :, :, i]
        d = around[:, 1:-1, 1:-1]
    return out


def trained(cells, kinds, weight, seed):
    """Three layers of 3 x 3 with the mean of four after each, one hidden layer; Adam, labels smoothed, figures mirrored,
    shifted by a cell and noisy, averaged weights."""
    rng = np.random.default_rng(seed)
    upto, w, before = np.cumsum(weight) / weight.sum(), [], 1
    for count in CHANNELS:
        w += [rng.normal(0, np.sqrt(2 / (9 * before)), (9 * before, count)), np.zeros(count)]
        before = count
    flat = before * (CELLS >> len(CHANNELS))**2
    w += [rng.normal(0, np.sqrt(2 / flat), (flat, HIDDEN)), np.zeros(HIDDEN),
          rng.normal(0, 1 / np.sqrt(HIDDEN), (HIDDEN, len(CLASSES))), np.zeros(len(CLASSES))]
    w = [a.astype(np.float32) for a in w]
    mean, square, average = [0 * a for a in w], [0 * a for a in w], [a.copy() for a in w]
    for t in range(1, STEPS + 1):
        i = np.minimum(np.searchsorted(upto, rng.random(BATCH)), len(cells) - 1)
        x = cells[i].astype(np.float32) / 255
        x = np.where((rng.random(BATCH) < 0.5)[:, None, None], x[:, :, ::-1], x)
        for k, shift in enumerate(rng.integers(-1, 2, (BATCH, 2))):
            x[k] = np.roll(x[k], shift, (0, 1))
        x = x + rng.normal(0, 0.08, x.shape)
        logits, saved = forward(w, x, lambda shape: (rng.random(shape) > DROPPED) / (1 - DROPPED))
        e = np.exp(logits - logits.max(1, keepdims=True))
        wanted = np.full(logits.shape, SMOOTH / len(CLASSES))
        wanted[np.arange(BATCH), kinds[i]] += 1 - SMOOTH
        gradients = backward(w, saved, ((e / e.sum(1, keepdims=True) - wanted) / BATCH).astype(np.float32))
        rate = RATE * (0.5 + 0.5 * np.cos(np.pi * t / STEPS))
        for k, d in enumerate(gradients):
            mean[k] = 0.9 * mean[k] + 0.1 * d
            square[k] = 0.999 * square[k] + 0.001 * d * d
            step = mean[k] / (1 - 0.9**t) / (np.sqrt(square[k] / (1 - 0.999**t)) + 1e-8)
            w[k] = (w[k] - rate * (step + (DECAY * w[k] if w[k].ndim == 2 else 0))).astype(np.float32)
            average[k] = 0.995 * average[k] + 0.005 * w[k]
        if t % 1000 == 0:
            print(f"step {t} of {STEPS}", flush=True)
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
    print(f"{first} of characters, {len(cells) - first} of pictures", flush=True)
    w = trained(cells, kinds, weight, o.seed)
    # Cells stay 0..255 and what layers give is Q10: weights of the first layer Q18 for 255 times as much, of the others Q12, biases of both.
    matrices = [np.round(w[0] / 255 * 2**18), *(np.round(a * 2**12) for a in w[2::2])]
    biases = [np.round(w[1] * 2**18), *(np.round(a * 2**22) for a in w[3::2])]
    with open(o.out, "w") as f:
        f.write("// SPDX-License-Identifier: MIT\n// Made by scripts/outline_class.py.\n"
                "#ifndef SINEW_CHARACTER_PICTURE_OUTLINE_CLASS_TABLE_HPP\n"
                "#define SINEW_CHARACTER_PICTURE_OUTLINE_CLASS_TABLE_HPP\n\n#include <cstdint>\n\n// clang-format off\n"
                "namespace sinew {\n\n"
                f"inline constexpr int kOutlineChannels[{len(CHANNELS)}] = {{{', '.join(map(str, CHANNELS))}}}, kOutlineHidden = {HIDDEN};\n"
                "// Layer by layer [inputs x outputs], Q18 and Q12; inputs of a kernel by its rows, columns, channels.\n")
        f.write(table_of("kOutlineWeights", np.concatenate([a.reshape(-1) for a in matrices]).astype(int), "int16_t"))
        f.write("// [outputs] of every layer, Q18 and Q22.\n")
        f.write(table_of("kOutlineBiases", np.concatenate(biases).astype(int), "int32_t"))
        f.write("\n}  // namespace sinew\n// clang-format on\n#endif\n")


if __name__ == "__main__":
    main()
