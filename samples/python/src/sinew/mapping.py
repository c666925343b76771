# SPDX-License-Identifier: MIT
"""map(): matches the joints of one skeleton to those of another."""
from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import Any, Mapping, Optional, Union

import numpy as np

from . import binding, declarations
from .arrays import chosen
from .binding import Array
from .character import Skeleton

MAP_METHODS, REASONS = declarations.MAP_METHOD, declarations.MAP_REASON


@dataclass
class JointMap:
    """sources     [target j] int32, the source's joint, -1 for none
    confidence  [target j] float32, 0 to 1, 0 without a source
    reasons     [target j] uint8, indices of REASONS
    certainty   0 to 1, certainty of the front and sides of both; below 0.5 left and right may be exchanged
    method      "sinew", which is by anatomy, or "branches"
    """

    sources: Array
    confidence: Array
    reasons: Array
    certainty: float
    method: str


def map(target: Skeleton, source: Skeleton, *, method: declarations.MapMethod = "auto",
        pins: Optional[Mapping[Union[str, int], Union[str, int, None]]] = None, names: bool = True,
        target_up: declarations.Up = "y", source_up: declarations.Up = "y") -> JointMap:
    """Finds a source for each joint of the target that has a match. The same bytes on every machine.

    pins       {target joint: source joint or None}, by names or indices: fixed pairs that the rest must agree with
    names      uses joint names
    target_up, source_up  "x", "y", "z", or "auto" if unknown
    Raises ValueError and Error.
    """
    options = binding.init(binding.sinew_map_options)
    options.method = chosen(method, MAP_METHODS, "method")
    said = pins or {}
    listed = (binding.sinew_map_pin * len(said))()
    for i, (to, of) in enumerate(said.items()):
        listed[i] = binding.sinew_map_pin(target.index(to, "pins"), -1 if of is None else source.index(of, "pins"))
    options.pins, options.pin_count = listed, len(said)
    views = [view_with_names(target, names, target_up, "target_up"), view_with_names(source, names, source_up, "source_up")]
    sources = np.zeros(len(target), np.int32)
    confidence, reasons = np.zeros(len(target), np.uint16), np.zeros(len(target), np.uint8)
    outputs = binding.init(binding.sinew_map_outputs)
    outputs.sources, outputs.confidence, outputs.reasons = binding.address(sources), binding.address(confidence), binding.address(reasons)
    block = binding.block("sinew_map_workspace_size", "map", len(target), len(source))
    binding.check(binding.library().sinew_map(ctypes.byref(views[0]), ctypes.byref(views[1]), ctypes.byref(options),
                                              block.address, block.size_bytes, ctypes.byref(outputs)), "map")
    return JointMap(sources, confidence.astype(np.float32) / np.float32(32768), reasons, outputs.certainty / 32768,
                    MAP_METHODS[outputs.method])


def view_with_names(skeleton: Skeleton, names: bool, up: str, argument: str) -> Any:
    """The engine's view of a skeleton with names, ends and up; it borrows the arrays."""
    view = binding.init(binding.sinew_skeleton)
    view.up = chosen(up, declarations.UP, argument)
    view.joint_count = len(skeleton)
    view.positions, view.parents = binding.address(skeleton.positions), binding.address(skeleton.parents)
    if names:
        view.names = (ctypes.c_char_p * len(skeleton))(*[str(n).encode() for n in skeleton.names])
    if skeleton.ends is not None:
        view.kept_ends = skeleton.ends.astype(np.uint8)  # the view borrows it
        view.ends = binding.address(view.kept_ends)
    return view
