# SPDX-License-Identifier: MIT
"""bind(): skin weights of a mesh for a skeleton."""
from __future__ import annotations

import ctypes
from typing import Any, Callable, Iterable, List, Literal, Optional, Sequence, Tuple, Union, get_args

import numpy as np

from . import binding, declarations
from .arrays import Mesh, chosen, mask
from .binding import Array
from .character import Alternative, Question, Skeleton, Skin, skin_of
from .models import Model, model_for

METHODS, ANSWERS = declarations.METHOD, declarations.ANSWER_KIND
DTYPES = (np.uint16, np.uint8, np.float32)  # of declarations.WEIGHT_FORMAT
UpAxis = Literal["y", "z"]
UP = get_args(UpAxis)
UP_AXES = tuple(declarations.UP.index(u) for u in UP)  # sinew_up of each

Joints = Optional[Iterable[Union[str, int]]]
ProgressFunction = Optional[Callable[[float], Any]]


def bind(positions: Any, faces: Any, skeleton: Optional[Skeleton], *, method: declarations.Method = "model",
         model: Union[None, str, Model] = None, influences: int = 4, weight_format: declarations.WeightFormat = "unorm16", up: UpAxis = "y",
         deform: Joints = None, never: Joints = None, symmetric: bool = False, rigid_parts: declarations.RigidParts = "auto",
         softness: float = 1.0, surface_vertices: int = 0, locked: Any = None, hints: Any = None, given: Any = None,
         questions: int = 0, answers: Sequence[Tuple[Any, ...]] = (), threads: int = 1, progress: ProgressFunction = None) -> Skin:
    """Predicts the skin weights of a mesh. The same bytes on every machine and for any number of threads.

    positions     [n, 3] rest pose, any unit
    faces         [f, 3], [f, 4], ragged lists, meshio's cells, or None; see arrays.Mesh
    skeleton      joints in the same space; its `ends` get no weight
    method        "model": the network; "heat": heat fields alone; "distance": by distance to bones
    model         file or Model; None: the bundled one
    influences    maximum number of joints per vertex, 1 to 12
    weight_format "unorm16", "unorm8" or "float"
    up            axis that points up, "y" or "z"
    deform        joints, by name or number, that deform; all others get no weight
    never         joints that must not get weight
    symmetric     mirrored vertices get mirrored rows, equal to the last bit
    rigid_parts   when connected pieces move as a whole: "auto", "always", "never"
    softness      0.25 to 4: softness of the blend, 2 is twice as soft
    surface_vertices  larger meshes are bound on a surface reduced to this many vertices; 0: 32768
    locked        mask [n] of bool or uint8, or indices (wider integers) of vertices that keep their rows of `given`
    hints         the same; their rows also guide the vertices around them
    given         Skin, (joints, weights) or dense [n, j]: rows of locked and hinted vertices; others are ignored
    questions     maximum number of questions about parts
    answers       (vertex, kind) or (vertex, "rigid", joint), with a final True for this part only; kinds: ANSWERS
    threads       number of threads, 1 to 64
    progress      called with the share of the work that is done, 0 to 1; returns True to stop
    Raises ValueError with the argument for wrong shapes and values, Error if the engine rejects the input, and Cancelled.
    Arguments are not changed. Other Python threads run meanwhile.
    """
    if skeleton is None:
        raise ValueError("skeleton: the character has none; make one with rig()")
    mesh = Mesh(positions, faces)
    count = len(mesh.positions)
    options = binding.init(binding.sinew_bind_options)
    options.method = chosen(method, METHODS, "method")
    options.influence_count = _within(influences, 1, binding.MAX_INFLUENCES, "influences")
    options.weight_format = chosen(weight_format, declarations.WEIGHT_FORMAT, "weight_format")
    options.symmetric = int(bool(symmetric))
    options.rigid_parts = chosen(rigid_parts, declarations.RIGID_PARTS, "rigid_parts")
    options.softness_percent = _within(round(100 * softness), 25, 400, "softness (in percent)")
    options.surface_vertices = surface_vertices
    options.question_count = _within(questions, 0, binding.MAX_QUESTIONS, "questions")
    said = answers_of(answers, count, skeleton)
    options.answers, options.answer_count = said, len(said)
    joints = np.zeros((count, influences), np.uint16)
    weights = np.zeros((count, influences), DTYPES[options.weight_format])
    locked, hints = mask(locked, count, "locked"), mask(hints, count, "hints")
    _fill_given(given, locked, hints, skeleton, joints, weights)
    options.locked, options.hints = binding.address(locked), binding.address(hints)
    used = model_for(model, "weights") if method == "model" else None

    outputs = binding.init(binding.sinew_bind_outputs)
    outputs.joint_indices, outputs.weights = binding.address(joints), binding.address(weights)
    confidence = np.empty(count, np.uint8)
    outputs.confidence = binding.address(confidence)
    asked = (binding.sinew_question * questions)()
    parts = [np.empty(count, np.uint32) if questions else None for _ in range(2)]
    if questions:
        outputs.questions = asked
        outputs.vertex_questions, outputs.vertex_parts = (binding.address(p) for p in parts)
    flags = joint_flags(skeleton, deform, never)
    view = skeleton_view(skeleton, flags, UP_AXES[chosen(up, UP, "up")])
    with binding.Progress(progress) as report, binding.Threads(threads) as pool:
        options.progress = report.callback
        options.thread_count, options.parallel_for = pool.count, pool.callback
        pointer = used.pointer() if used is not None else None
        block = binding.block("sinew_bind_workspace_size", "bind", pointer, *mesh.counts, len(skeleton), ctypes.byref(options))
        status = binding.library().sinew_bind(pointer, mesh.pointer(), ctypes.byref(view), ctypes.byref(options), block.address,
                                              block.size_bytes, ctypes.byref(outputs))
    report.finish(status, "bind")
    listed = [question_of(q) for q in asked[:outputs.questions_written]]
    return Skin(joints, weights, confidence, outputs.symmetric_vertices, listed, *parts)


def joint_flags(skeleton: Skeleton, deform: Joints, never: Joints) -> Array:
    """[j] uint8 of sinew_skeleton::flags."""
    flags = np.zeros(len(skeleton), np.uint8)
    if skeleton.ends is not None:
        flags[skeleton.ends] |= binding.JOINT_NEVER
    for joints, flag, name in ((deform, binding.JOINT_DEFORMS, "deform"), (never, binding.JOINT_NEVER, "never")):
        for joint in joints if joints is not None else ():
            flags[skeleton.index(joint, name)] |= flag
    return flags


def skeleton_view(skeleton: Skeleton, flags: Optional[Array], up: int = 0) -> Any:
    """The engine's view; it borrows the arrays. up: sinew_up."""
    view = binding.init(binding.sinew_skeleton)
    view.joint_count, view.up = len(skeleton), up
    view.positions, view.parents = binding.address(skeleton.positions), binding.address(skeleton.parents)
    view.flags = binding.address(flags)
    return view


def _within(value: Any, low: int, high: int, name: str) -> int:
    if not low <= value <= high:
        raise ValueError(f"{name}: expected {low} to {high}, found {value}")
    return int(value)


def _fill_given(given: Any, locked: Optional[Array], hints: Optional[Array], skeleton: Skeleton,
                joints: Array, weights: Array) -> None:
    """Rows of locked and hinted vertices, rounded as the engine rounds, into the outputs."""
    if locked is None and hints is None:
        return
    if given is None:
        raise ValueError("given: expected a Skin or an array [n, j] for locked and hinted vertices, found None")
    skin = skin_of(given, len(joints), len(skeleton), "given").rounded(
        joints.shape[1], 255 if weights.dtype == np.uint8 else 65535)
    kept = np.zeros(len(joints), bool)
    for one in (locked, hints):
        if one is not None:
            kept |= one != 0
    empty = np.flatnonzero(kept & (skin.weights.sum(1) == 0))
    if len(empty):
        raise ValueError(f"given: vertex {empty[0]} is locked or a hint and has no weight; leave it out or give it one")
    joints[kept] = skin.joints[kept]
    rows = skin.weights[kept]
    weights[kept] = rows.astype(np.float32) / np.float32(65535) if weights.dtype == np.float32 else rows


def answers_of(answers: Sequence[Tuple[Any, ...]], vertex_count: int, skeleton: Skeleton) -> Any:
    """sinew_answer of what callers write. Raises ValueError."""
    out = (binding.sinew_answer * len(answers))()
    for i, answer in enumerate(answers):
        name = f"answers[{i}]"
        rest: List[Any] = list(answer)
        alone = rest.pop() if len(rest) > 2 and isinstance(rest[-1], bool) else False
        if len(rest) not in (2, 3) or (len(rest) == 3) != (rest[1] == "rigid"):
            raise ValueError(f"{name}: expected (vertex, kind) or (vertex, 'rigid', joint), found {answer!r}")
        if not 0 <= rest[0] < vertex_count:
            raise ValueError(f"{name}: the mesh has vertices 0 to {vertex_count - 1}, found {rest[0]}")
        joint = skeleton.index(rest[2], name) if len(rest) == 3 else 0
        out[i] = binding.sinew_answer(rest[0], chosen(rest[1], ANSWERS, name), joint, int(alone))
    return out


def question_of(q: binding.sinew_question) -> Question:
    """A Question from a sinew_question."""
    alternatives = [Alternative(ANSWERS[a.kind], a.joint, a.change / 65536) for a in q.alternatives[:q.alternative_count]]
    return Question(q.vertex, q.part_count, q.vertex_count, q.joint, q.share / 65535, q.doubt / 65536, q.gain / 65536, alternatives)
