# SPDX-License-Identifier: MIT
"""transfer(): weights of a bound character for another mesh."""
from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import Any, List, Optional, Sequence, Tuple, Union

import numpy as np

from . import binding, declarations
from .arrays import Mesh, chosen, mask, whole
from .binding import Array
from .binder import UP, UP_AXES, Joints, ProgressFunction, UpAxis, joint_flags, skeleton_view
from .character import Character, Skeleton, Skin, skin_of
from .mapping import map as map_joints
from .models import Model, model_for

TRANSFER_METHODS, TRANSFER_REASONS = declarations.TRANSFER_METHOD, declarations.TRANSFER_REASON


@dataclass
class TransferredPart:
    """A connected piece of the target. `carried`: share of its weights that was transferred; the rest was rebound."""

    vertex: int
    vertex_count: int
    reason: str
    carried: float


@dataclass
class Transferred:
    """skin: rows of the target; carried: share of all weights that was transferred; parts by descending size."""

    skin: Skin
    carried: float
    parts: List[TransferredPart]


def transfer(source: Character, positions: Any, faces: Any, skeleton: Optional[Skeleton] = None, *, method: declarations.TransferMethod = "auto",
             joint_map: Any = None, garment: bool = False, heat: bool = False, model: Union[None, str, Model] = None,
             influences: int = 4, up: UpAxis = "y", source_up: Optional[UpAxis] = None, never: Joints = None, locked: Any = None,
             given: Any = None, pairs: Sequence[Tuple[int, int]] = (), threads: int = 1,
             progress: ProgressFunction = None) -> Transferred:
    """Transfers weights to another mesh. The same bytes on every machine and for any number of threads.

    source      bound character: mesh, skeleton and skin
    positions   [n, 3] of the target; faces as bind() takes them
    skeleton    of the target; None: the source's own
    method      "auto": a blend of nearest and rebind; "nearest", "biharmonic", "rebind"
    joint_map   [source j] the matching joint of the target, -1 for none; None: joints of equal names, else map()
    garment     the source wears the target: same space, same skeleton
    heat        rebinds by heat only; else by `model`, None: the bundled one
    influences  maximum number of joints per vertex, 1 to 12
    up, source_up  axes that point up, "y" or "z"; source_up None: as up
    never       joints of the target that must not get weight
    locked      mask [n] of bool or uint8, or indices (wider integers) of vertices that keep their rows of `given`
    pairs       (source vertex, target vertex) at the same point of the body, for "biharmonic"
    Raises ValueError, Error and Cancelled as bind() does.
    """
    if source.skin is None or source.skeleton is None:
        raise ValueError("source: has no skin to transfer; bind it first")
    skeleton = source.skeleton if skeleton is None else skeleton
    of_mesh, mesh = Mesh(source.positions, source.faces, "source."), Mesh(positions, faces)
    count = len(mesh.positions)
    of_skin = skin_of(source.skin, len(of_mesh.positions), len(source.skeleton), "source.skin")
    mapped = _joint_map(joint_map, source.skeleton, skeleton, up, source_up or up)
    options = binding.init(binding.sinew_transfer_options)
    options.method = chosen(method, TRANSFER_METHODS, "method")
    if not 1 <= influences <= binding.MAX_INFLUENCES:
        raise ValueError(f"influences: expected 1 to {binding.MAX_INFLUENCES}, found {influences}")
    options.influence_count = influences
    ups = UP_AXES[chosen(source_up or up, UP, "source_up")], UP_AXES[chosen(up, UP, "up")]
    if garment and method == "biharmonic":
        raise ValueError("garment: does not work with method 'biharmonic'; give 'auto', 'nearest' or 'rebind'")
    options.garment = int(bool(garment))
    listed = (binding.sinew_vertex_pair * len(pairs))(*[binding.sinew_vertex_pair(int(s), int(t)) for s, t in pairs])
    options.pairs, options.pair_count = listed, len(pairs)
    joints, weights = np.zeros((count, influences), np.uint16), np.zeros((count, influences), np.uint16)
    locked = mask(locked, count, "locked")
    if locked is not None:
        if given is None:
            raise ValueError("given: expected a Skin or an array [n, j] for locked vertices, found None")
        kept = skin_of(given, count, len(skeleton), "given").rounded(influences)
        joints[locked != 0], weights[locked != 0] = kept.joints[locked != 0], kept.weights[locked != 0]
    options.locked = binding.address(locked)
    confidence, parts = np.empty(count, np.uint8), (binding.sinew_transfer_part * 64)()
    vertex_parts = np.empty(count, np.uint32)
    outputs = binding.init(binding.sinew_transfer_outputs)
    outputs.joint_indices, outputs.weights = binding.address(joints), binding.address(weights)
    outputs.confidence, outputs.vertex_parts = binding.address(confidence), binding.address(vertex_parts)
    outputs.parts, outputs.part_capacity = parts, len(parts)
    views = [skeleton_view(source.skeleton, joint_flags(source.skeleton, None, None), ups[0]),
             skeleton_view(skeleton, joint_flags(skeleton, None, never), ups[1])]
    bound = binding.sinew_bound_character(
        mesh=ctypes.pointer(of_mesh.struct), skeleton=ctypes.pointer(views[0]),
        skin=binding.sinew_skin(binding.address(of_skin.joints), binding.address(of_skin.weights), of_skin.joints.shape[1],
                                {1: 1, 2: 0}.get(of_skin.weights.dtype.itemsize, 2)), joint_map=binding.address(mapped))
    used = None if heat else model_for(model, "weights")
    pointer = None if used is None else used.pointer()
    with binding.Progress(progress) as report, binding.Threads(threads) as pool:
        options.progress = report.callback
        options.thread_count, options.parallel_for = pool.count, pool.callback
        common = (pointer, ctypes.byref(bound), mesh.pointer(), ctypes.byref(views[1]), ctypes.byref(options))
        block = binding.block("sinew_transfer_workspace_size", "transfer", *common)
        status = binding.library().sinew_transfer(*common, block.address, block.size_bytes, ctypes.byref(outputs))
    report.finish(status, "transfer")
    skin = Skin(joints, weights, confidence, vertex_parts=vertex_parts)
    told = [TransferredPart(p.vertex, p.vertex_count, TRANSFER_REASONS[p.reason], p.carried_q16 / 65536)
            for p in parts[:min(outputs.part_count, len(parts))]]
    return Transferred(skin, outputs.carried_q16 / 65536, told)


def _joint_map(joint_map: Any, source: Skeleton, target: Skeleton, up: UpAxis, source_up: UpAxis) -> Array:
    """[source j] int32."""
    if joint_map is not None:
        return whole(joint_map, (len(source),), "joint_map", np.int32, -1, len(target))
    numbers = {name: i for i, name in enumerate(target.names)}
    by_name = np.array([numbers.get(name, -1) for name in source.names], np.int32)
    if (by_name >= 0).sum() * 2 >= min(len(source), len(target)):
        return by_name
    found = map_joints(source, target, target_up=source_up, source_up=up).sources
    return np.where(by_name >= 0, by_name, found).astype(np.int32)
