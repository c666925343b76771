# SPDX-License-Identifier: MIT
"""Inputs and outputs: skeletons, skins (weights), clips, and characters that contain them. n vertices, j joints, k
influences, t frames."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, List, Optional, Sequence, Tuple, Union

import numpy as np

from . import binding, declarations
from .arrays import real, whole
from .binding import Array

# sinew_joint_class: what a joint is for.
CLASSES = declarations.JOINT_CLASS


@dataclass(init=False, repr=False)
class Skeleton:
    """Joints at rest, in the space of the mesh.

    positions  [j, 3] float32
    parents    [j] int32, -1 for a root; any order
    names      j strings; default "joint_0" and so on
    rotations  [j, 4] float32 x y z w, rotations of the joints' axes in the world; None: world axes
    classes    [j] uint8, indices of CLASSES; None: not known
    ends       [j] bool, joints that only mark the end of a bone; they get no weight. None: unknown
    Raises ValueError, which names the argument.
    """

    positions: Array
    parents: Array
    names: Sequence[str]
    rotations: Optional[Array]
    classes: Optional[Array]
    ends: Optional[Array]

    def __init__(self, positions: Any, parents: Any, names: Sequence[str] = (), rotations: Any = None, classes: Any = None, ends: Any = None) -> None:
        self.positions = real(positions, (None, 3), "skeleton.positions")
        count = len(self.positions)
        self.parents = whole(parents, (count,), "skeleton.parents", np.int32, -1, count)
        self.names = list(names) if len(names) else [f"joint_{i}" for i in range(count)]
        if len(self.names) != count:
            raise ValueError(f"skeleton.names: expected {count} names, found {len(self.names)}")
        self.rotations = None if rotations is None else real(rotations, (count, 4), "skeleton.rotations")
        self.classes = None if classes is None else whole(classes, (count,), "skeleton.classes", np.uint8, 0, len(CLASSES))
        self.ends = None if ends is None else np.ascontiguousarray(ends, bool)
        if self.ends is not None:
            if self.ends.shape != (count,):
                raise ValueError(f"skeleton.ends: expected shape ({count},), found {self.ends.shape}")

    def __len__(self) -> int:
        return len(self.positions)

    def __repr__(self) -> str:
        return f"<sinew.Skeleton: {len(self)} joints{f', {self.names[0]!r} to {self.names[-1]!r}' if len(self) else ''}>"

    def index(self, joint: Union[str, int], name: str = "joint") -> int:
        """Index of a joint given by name or index. Raises ValueError."""
        if isinstance(joint, str):
            if joint not in self.names:
                raise ValueError(f"{name}: the skeleton has no joint {joint!r}; its joints are {self.names[0]} to {self.names[-1]}")
            return list(self.names).index(joint)
        if not 0 <= int(joint) < len(self):
            raise ValueError(f"{name}: the skeleton has joints 0 to {len(self) - 1}, found {joint}")
        return int(joint)

    def order(self) -> List[int]:
        """Joints with parents before their children. Raises ValueError if parents form a cycle."""
        children: List[List[int]] = [[] for _ in self.parents]
        out: List[int] = []
        for joint, parent in enumerate(self.parents):
            (children[parent] if parent >= 0 else out).append(joint)
        for joint in out:
            out.extend(children[joint])
        if len(out) != len(self):
            raise ValueError("skeleton.parents: joints form a cycle")
        return out

    def rest(self) -> Tuple[Array, Array]:
        """The rest pose as local rotations [j, 4] and translations [j, 3], float64."""
        world = self.world_rotations()
        rotations, translations = world.copy(), self.positions.astype(np.float64)
        inner = self.parents >= 0
        above = self.parents[inner]
        back = world[above] * [-1, -1, -1, 1]
        rotations[inner] = multiply(back, world[inner])
        translations[inner] = turn(back, translations[inner] - self.positions[above].astype(np.float64))
        return rotations, translations

    def world_rotations(self) -> Array:
        """[j, 4] float64 unit quaternions."""
        if self.rotations is None:
            return np.tile([0.0, 0.0, 0.0, 1.0], (len(self), 1))
        q = self.rotations.astype(np.float64)
        return np.asarray(q / np.maximum(np.linalg.norm(q, axis=1, keepdims=True), 1e-30))

    def matrices(self, rotations: Any = None, translations: Any = None) -> Array:
        """Pose times inverse bind per joint, for Deformer.pose().

        rotations     [j, 4] x y z w local, in the axes of the parent; None: at rest
        translations  [j, 3] local; None: at rest
        Returns [j, 3, 4] float32.
        """
        q, p = self.rest()
        if rotations is not None:
            q = real(rotations, (len(self), 4), "rotations").astype(np.float64)
            q = q / np.maximum(np.linalg.norm(q, axis=1, keepdims=True), 1e-30)
        if translations is not None:
            p = real(translations, (len(self), 3), "translations").astype(np.float64)
        q, p = q.copy(), p.copy()
        for joint in self.order():
            parent = self.parents[joint]
            if parent >= 0:
                p[joint] = p[parent] + turn(q[parent], p[joint])
                q[joint] = multiply(q[parent], q[joint])
        turned = multiply(q, self.world_rotations() * [-1, -1, -1, 1])
        out = np.empty((len(self), 3, 4), np.float64)
        for axis in range(3):
            out[:, :, axis] = turn(turned, np.eye(3)[axis])
        out[:, :, 3] = p - turn(turned, self.positions.astype(np.float64))
        return out.astype(np.float32)


@dataclass
class Alternative:
    """One answer to a question. `change`: change of the part's weights, 0 to 2."""

    kind: str
    joint: int
    change: float


@dataclass
class Question:
    """A part of the mesh that geometry alone does not decide; see sinew/questions.h. Questions are sorted by `gain`."""

    vertex: int
    part_count: int
    vertex_count: int
    joint: int
    share: float
    doubt: float
    gain: float
    alternatives: List[Alternative]


@dataclass(repr=False)
class Skin:
    """Weights of a mesh.

    joints      [n, k] uint16, by descending weight; unused slots are joint 0 with weight 0
    weights     [n, k] uint16 (a row sums to 65535), uint8 (255) or float32 (1)
    confidence  [n] uint8, confidence of the strongest joint, 0..255 = 0..100 %; or None
    """

    joints: Array
    weights: Array
    confidence: Optional[Array] = None
    symmetric_vertices: int = 0  # with symmetric=True: how many have a mirror image; 0: the mesh has no mirror plane
    questions: List[Question] = field(default_factory=list)
    vertex_questions: Optional[Array] = None  # [n] uint32, binding.NO_QUESTION for none
    vertex_parts: Optional[Array] = None  # [n] uint32

    def __post_init__(self) -> None:
        self.joints = whole(self.joints, (None, None), "skin.joints", np.uint16, 0, 65536)
        self.weights = np.ascontiguousarray(self.weights)
        if self.weights.dtype not in (np.uint8, np.uint16):
            self.weights = real(self.weights, (None, None), "skin.weights")
        if self.weights.shape != self.joints.shape:
            raise ValueError(f"skin.weights: expected shape {self.joints.shape} as skin.joints, found {self.weights.shape}")
        if not 1 <= self.joints.shape[1] <= binding.MAX_INFLUENCES:
            raise ValueError(f"skin.joints: expected 1 to {binding.MAX_INFLUENCES} influences, found {self.joints.shape[1]}")

    def __repr__(self) -> str:
        return f"<sinew.Skin: {len(self.joints)} vertices, {self.joints.shape[1]} influences, {self.weights.dtype}>"

    def unit(self) -> float:
        """Sum of the weights of a row."""
        return {1: 255.0, 2: 65535.0}.get(self.weights.dtype.itemsize, 1.0)

    def dense(self, joint_count: int) -> Array:
        """[n, joint_count] float32, rows sum to 1."""
        out = np.zeros((len(self.joints), joint_count), np.float32)
        rows = np.arange(len(self.joints))
        for k in range(self.joints.shape[1]):
            np.add.at(out, (rows, self.joints[:, k]), self.weights[:, k].astype(np.float32) / np.float32(self.unit()))
        return out

    def rounded(self, influences: int, total: int = 65535) -> "Skin":
        """The largest `influences` of every row as integers that sum to `total`, 65535 (uint16) or 255 (uint8), sorted and
        rounded as the engine does it. Rows that are such rows already, as text
        or float32 too, and rows of zeros keep their values."""
        scaled = self.weights.astype(np.float64)
        sums = scaled.sum(1, keepdims=True)
        share = np.divide(scaled, sums, out=np.zeros_like(scaled), where=sums > 0)
        nearest = np.rint(share * total)
        exact = (nearest.sum(1, keepdims=True) == total) & (np.abs(share * total - nearest).max(1, keepdims=True) < 0.04)
        steps = np.where(exact, nearest, np.floor(share * 65535 + 0.5)).astype(np.int64)
        order = np.lexsort((self.joints, -steps), axis=1)[:, :influences]
        joints = np.take_along_axis(self.joints, order, 1).astype(np.uint16)
        steps = np.take_along_axis(steps, order, 1)
        sums = steps.sum(1, keepdims=True)
        weights = steps * total // np.maximum(sums, 1)
        weights[:, 0] += np.where(sums[:, 0] > 0, total - weights.sum(1), 0)
        joints[weights == 0] = 0
        order = np.lexsort((joints, -weights), axis=1)  # what became equal goes to the lower joint
        joints, weights = np.take_along_axis(joints, order, 1), np.take_along_axis(weights, order, 1)
        missing = max(0, influences - joints.shape[1])
        dtype = np.uint8 if total == 255 else np.uint16
        return Skin(np.pad(joints, ((0, 0), (0, missing))), np.pad(weights, ((0, 0), (0, missing))).astype(dtype))


def skin_of(value: Any, vertex_count: int, joint_count: int, name: str) -> Skin:
    """A Skin, a pair (joints, weights), or a dense array [n, j] of weights. Raises ValueError."""
    if isinstance(value, Skin):
        skin = value
    elif isinstance(value, tuple) and len(value) == 2:
        skin = Skin(*value)
    else:
        dense = real(value, (vertex_count, joint_count), name)
        keep = min(binding.MAX_INFLUENCES, joint_count)
        order = np.argsort(-dense, axis=1, kind="stable")[:, :keep]
        skin = Skin(order.astype(np.uint16), np.take_along_axis(dense, order, 1))
    if len(skin.joints) != vertex_count:
        raise ValueError(f"{name}: expected rows of {vertex_count} vertices, found {len(skin.joints)}")
    if skin.joints.size and skin.joints.max() >= joint_count:
        raise ValueError(f"{name}: names joint {skin.joints.max()}, but the skeleton has joints 0 to {joint_count - 1}")
    return skin


@dataclass(repr=False)
class Clip:
    """A motion: local poses of a skeleton, in the axes of each joint's parent.

    rotations     [t, j, 4] float32 x y z w
    translations  [t, j, 3] float32
    fps           frames per second
    """

    rotations: Array
    translations: Array
    fps: float = 30.0
    name: str = "motion"

    def __post_init__(self) -> None:
        self.rotations = real(self.rotations, (None, None, 4), "clip.rotations")
        self.translations = real(self.translations, (*self.rotations.shape[:2], 3), "clip.translations")
        if not (self.fps > 0 and np.isfinite(self.fps)):
            raise ValueError(f"clip.fps: expected frames per second above 0, found {self.fps}")

    def __repr__(self) -> str:
        frames, joints = self.rotations.shape[:2]
        return f"<sinew.Clip {self.name!r}: {frames} frames of {joints} joints, {self.fps:g} a second>"


@dataclass(repr=False)
class Character:
    """A mesh with skeleton, weights and clips, for load() and save().

    positions  [n, 3] float32 at rest
    faces      as bind() takes them; load() gives [f, 3] uint32
    """

    positions: Array
    faces: Any
    skeleton: Optional[Skeleton] = None
    skin: Optional[Skin] = None
    clips: List[Clip] = field(default_factory=list)
    name: str = "character"
    document: Any = None  # the OpenCharacter that it came from: save() keeps what is not here
    loaded: Any = field(default=(None, None, ()), repr=False, compare=False)  # skeleton, skin and clips that document has

    def __repr__(self) -> str:
        return (f"<sinew.Character {self.name!r}: {len(self.positions)} vertices, {0 if self.skeleton is None else len(self.skeleton)} joints, "
                f"{'no ' if self.skin is None else ''}weights, {len(self.clips)} clips>")


def multiply(a: Array, b: Array) -> Array:
    """Products of quaternions x y z w, [..., 4]."""
    ax, ay, az, aw = np.moveaxis(np.asarray(a), -1, 0)
    bx, by, bz, bw = np.moveaxis(np.asarray(b), -1, 0)
    return np.stack([aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
                     aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz], -1)


def turn(q: Array, p: Array) -> Array:
    """Points [..., 3] rotated by unit quaternions [..., 4]."""
    v, w = np.asarray(q)[..., :3], np.asarray(q)[..., 3:]
    cross = 2 * np.cross(v, p)
    return np.asarray(p + w * cross + np.cross(v, cross))
