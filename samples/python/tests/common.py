# SPDX-License-Identifier: MIT
"""The sample characters of the repository, and the command to compare with."""
import json
import os
import subprocess
import tempfile
from pathlib import Path

import numpy as np

import sinew

ROOT = Path(os.environ.get("SINEW_SOURCE_DIR", Path(__file__).resolve().parents[3]))
DATA = ROOT / "samples" / "data"
COMMAND = os.environ.get("SINEW_COMMAND", str(ROOT / "build" / "release" / "sinew"))
CHARACTERS = ("biped__robed", "biped__robot", "bird__winged", "many-legged__plated", "quadruped__tailed", "snake__long")


def read_rig(path, vertex_count=0):
    """Skeleton and dense weights [vertex_count, j] of a .rig.txt."""
    names, places, parents, rows = {}, [], {}, np.zeros((vertex_count, 0), np.float32)
    for line in Path(path).read_text(encoding="utf-8").splitlines():
        words = line.split()
        if words[0] == "joints":
            names[words[1]] = len(names)
            places.append([float(w) for w in words[2:5]])
            rows = np.zeros((vertex_count, len(names)), np.float32)
        elif words[0] == "hier":
            parents[words[2]] = words[1]
        elif words[0] == "skin" and vertex_count:
            for name, weight in zip(words[2::2], words[3::2]):
                rows[int(words[1]), names[name]] += float(weight)
    above = [names[parents[n]] if n in parents else -1 for n in names]
    return sinew.Skeleton(places, above, list(names)), rows


def read_character(name):
    """Positions, ragged faces, skeleton, the artist's dense weights."""
    positions, faces = [], []
    for line in (DATA / f"{name}.obj").read_text(encoding="utf-8").splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            positions.append([float(w) for w in words[1:4]])
        elif words[:1] == ["f"]:
            faces.append([int(w.split("/")[0]) - 1 for w in words[1:]])
    positions = np.array(positions)
    skeleton, rows = read_rig(DATA / f"{name}.rig.txt", len(positions))
    return positions, faces, skeleton, rows


def as_the_command_reads(rows):
    """Dense weights of a file as the command hands them to the engine: four joints a row, rounded down, the rest to the first."""
    order = np.argsort(-rows, axis=1, kind="stable")[:, :4]
    weights = np.take_along_axis(rows, order, 1).astype(np.float64)
    steps = np.floor(weights / rows.astype(np.float64).sum(1, keepdims=True) * 65535 + 0.5).astype(np.int64)
    weights = steps * 65535 // steps.sum(1, keepdims=True)
    weights[:, 0] += 65535 - weights.sum(1)
    return sinew.Skin(np.where(weights > 0, order, 0), weights.astype(np.uint16))


def command(*arguments):
    """Runs the command; its JSON, if it prints any."""
    done = subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout) if "--json" in arguments else None


def folder():
    return tempfile.TemporaryDirectory(prefix="sinew_python_")


def fnv(skin):
    """The hash that `sinew bind --json` prints: FNV-1a over the joints, then the weights."""
    value = 1469598103934665603
    for byte in skin.joints.astype("<u2").tobytes() + skin.weights.astype("<u2").tobytes():
        value = ((value ^ byte) * 1099511628211) & (2 ** 64 - 1)
    return f"{value:016x}"
