# SPDX-License-Identifier: MIT
"""The C interface of the engine (engine/include/sinew/*.h) by ctypes: structs, functions, errors, blocks of memory.

Classes and functions have the names of C, and the headers are their reference. Nothing here depends on the version of
Python. ctypes lets other threads run while a call is in the library.
"""
from __future__ import annotations

import concurrent.futures
import ctypes
import os
import sys
from ctypes import CFUNCTYPE, POINTER, Structure, c_char_p, c_float, c_int, c_int32, c_size_t, c_uint16, c_uint32, c_void_p
from pathlib import Path
from typing import Any, Callable, Optional

import numpy as np

MAX_INFLUENCES = 12
MAX_RIG_JOINTS = 192
MAX_QUESTIONS = 1024
MAX_ALTERNATIVES = 8
MAX_THREADS = 64
WORKSPACE_ALIGNMENT = 64
JOINT_NAME_BYTES = 32
JOINT_NEVER = 1
JOINT_DEFORMS = 2
DETAIL_HANDS, DETAIL_FACE, DETAIL_PROPS = 1, 2, 4
NO_QUESTION = 0xFFFFFFFF

_CANCELLED = -8
_VERSION = "0.1."  # structs of one minor version have the same layout

PROGRESS = CFUNCTYPE(c_int, c_void_p, c_uint32)
BODY = CFUNCTYPE(None, c_void_p, c_uint32)
PARALLEL_FOR = CFUNCTYPE(None, c_void_p, c_uint32, BODY, c_void_p)


class Error(RuntimeError):
    """What the engine or a file says against a call, in one line. `status` is the sinew_status, 0 for other causes."""

    def __init__(self, message: str, status: int = 0) -> None:
        super().__init__(message)
        self.status = status


class Cancelled(Error):
    """The progress function asked to stop; nothing was changed."""


class sinew_mesh(Structure):
    _fields_ = [("positions", c_void_p), ("vertex_count", c_uint32), ("face_offsets", c_void_p), ("face_vertices", c_void_p),
                ("face_count", c_uint32), ("corner_count", c_uint32)]


class sinew_skeleton(Structure):
    _fields_ = [("struct_size", c_uint32), ("joint_count", c_uint32), ("positions", c_void_p), ("parents", c_void_p),
                ("flags", c_void_p), ("ends", c_void_p), ("names", POINTER(c_char_p)), ("rotations", c_void_p),
                ("up", c_uint32), ("reserved", c_uint32)]


class sinew_skin(Structure):
    _fields_ = [("joint_indices", c_void_p), ("weights", c_void_p), ("influence_count", c_uint32), ("weight_format", c_uint32)]


class sinew_model(Structure):
    _fields_ = [("bytes", c_void_p), ("size_bytes", c_size_t), ("packed", c_void_p), ("format_version", c_uint32),
                ("candidate_count", c_uint32), ("grid_size", c_uint32), ("feature_set", c_uint32),
                ("fixed_candidates", c_uint32), ("layer_count", c_uint32), ("parameter_count", c_uint32),
                ("checksum", c_uint32), ("confidence_offset", c_uint32), ("confidence_count", c_uint32), ("task", c_uint32),
                ("input_count", c_uint32), ("reserved", c_uint32 * 14)]


class sinew_answer(Structure):
    _fields_ = [("vertex", c_uint32), ("kind", c_uint16), ("joint", c_uint16), ("alone", c_uint32)]


class sinew_alternative(Structure):
    _fields_ = [("kind", c_uint16), ("joint", c_uint16), ("change", c_uint32)]


class sinew_question(Structure):
    _fields_ = [("vertex", c_uint32), ("part_count", c_uint32), ("vertex_count", c_uint32), ("joint", c_uint16),
                ("share", c_uint16), ("doubt", c_uint32), ("gain", c_uint32), ("alternative_count", c_uint32),
                ("reserved", c_uint32), ("alternatives", sinew_alternative * MAX_ALTERNATIVES)]


class sinew_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("method", c_uint32), ("influence_count", c_uint32), ("weight_format", c_uint32),
                ("candidate_count", c_uint32), ("grid_size", c_uint32), ("surface_vertices", c_uint32),
                ("symmetric", c_uint32), ("rigid_parts", c_uint32), ("softness_percent", c_uint32),
                ("weights_in_place", c_uint32), ("kernel", c_uint32), ("thread_count", c_uint32), ("reserved", c_uint32), ("locked", c_void_p),
                ("hints", c_void_p), ("parallel_for", PARALLEL_FOR), ("parallel_user", c_void_p), ("progress", PROGRESS),
                ("progress_user", c_void_p), ("answers", POINTER(sinew_answer)), ("answer_count", c_uint32),
                ("question_count", c_uint32)]


class sinew_bind_outputs(Structure):
    _fields_ = [("struct_size", c_uint32), ("symmetric_vertices", c_uint32), ("joint_indices", c_void_p),
                ("weights", c_void_p), ("confidence", c_void_p), ("used_bytes", c_size_t),
                ("questions", POINTER(sinew_question)), ("vertex_questions", c_void_p), ("vertex_parts", c_void_p),
                ("questions_written", c_uint32), ("reserved", c_uint32)]


class sinew_rig_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("up", c_uint32), ("mirror", c_uint32), ("spine_count", c_uint32),
                ("no_toes", c_uint32), ("no_ends", c_uint32), ("weights_in_place", c_uint32), ("kernel", c_uint32),
                ("progress", PROGRESS), ("progress_user", c_void_p), ("method", c_uint32), ("reserved", c_uint32)]


class sinew_rig_outputs(Structure):
    _fields_ = [("struct_size", c_uint32), ("joint_count", c_uint32), ("positions", c_void_p), ("parents", c_void_p),
                ("flags", c_void_p), ("joint_classes", c_void_p), ("partners", c_void_p), ("confidence", c_void_p),
                ("parent_confidence", c_void_p), ("names", c_void_p), ("mirrored", c_uint32), ("facing", c_uint32),
                ("plane", c_float), ("spread", c_float), ("used_bytes", c_size_t)]


class sinew_map_pin(Structure):
    _fields_ = [("target", c_uint32), ("source", c_int32)]


class sinew_map_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("method", c_uint32), ("pin_count", c_uint32), ("reserved", c_uint32),
                ("pins", POINTER(sinew_map_pin))]


class sinew_map_outputs(Structure):
    _fields_ = [("struct_size", c_uint32), ("method", c_uint32), ("sources", c_void_p), ("confidence", c_void_p),
                ("reasons", c_void_p), ("mapped", c_uint32), ("certainty", c_uint32), ("used_bytes", c_size_t)]


class sinew_retarget_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("method", c_uint32), ("in_place", c_uint32), ("scale", c_float)]


class sinew_motion_body(Structure):
    _fields_ = [("positions", c_void_p), ("triangles", c_void_p), ("skin", sinew_skin), ("vertex_count", c_uint32),
                ("triangle_count", c_uint32)]


class sinew_contact_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("fps", c_float), ("progress", PROGRESS), ("progress_user", c_void_p)]


class sinew_motion_clip(Structure):
    _fields_ = [("source_rotations", c_void_p), ("source_translations", c_void_p), ("rotations", c_void_p),
                ("translations", c_void_p), ("frame_count", c_uint32), ("ground", c_float)]


class sinew_bound_character(Structure):
    _fields_ = [("mesh", POINTER(sinew_mesh)), ("skeleton", POINTER(sinew_skeleton)), ("skin", sinew_skin),
                ("joint_map", c_void_p)]


class sinew_vertex_pair(Structure):
    _fields_ = [("source", c_uint32), ("target", c_uint32)]


class sinew_transfer_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("method", c_uint32), ("influence_count", c_uint32), ("weight_format", c_uint32),
                ("garment", c_uint32), ("as_drawn", c_uint32),
                ("weights_in_place", c_uint32), ("kernel", c_uint32), ("thread_count", c_uint32), ("pair_count", c_uint32),
                ("locked", c_void_p), ("pairs", POINTER(sinew_vertex_pair)), ("parallel_for", PARALLEL_FOR),
                ("parallel_user", c_void_p), ("progress", PROGRESS), ("progress_user", c_void_p)]


class sinew_transfer_part(Structure):
    _fields_ = [("vertex", c_uint32), ("vertex_count", c_uint32), ("reason", c_uint32), ("carried_q16", c_uint32),
                ("style_q16", c_uint32), ("mismatch_q16", c_uint32), ("distance_q16", c_uint32), ("reserved", c_uint32)]


class sinew_transfer_outputs(Structure):
    _fields_ = [("struct_size", c_uint32), ("part_capacity", c_uint32), ("joint_indices", c_void_p), ("weights", c_void_p),
                ("confidence", c_void_p), ("parts", POINTER(sinew_transfer_part)), ("vertex_parts", c_void_p),
                ("part_count", c_uint32), ("bound_by", c_uint32), ("carried_q16", c_uint32), ("style_q16", c_uint32),
                ("mismatch_q16", c_uint32), ("reference_count", c_uint32), ("used_bytes", c_size_t)]


class sinew_deform_options(Structure):
    _fields_ = [("struct_size", c_uint32), ("method", c_uint32), ("cell_count", c_uint32), ("round_count", c_uint32),
                ("softness", c_uint32), ("no_twist_spread", c_uint32), ("no_contact", c_uint32), ("no_smoothing", c_uint32),
                ("parallel_for", PARALLEL_FOR), ("parallel_user", c_void_p), ("thread_count", c_uint32),
                ("body_contact", c_uint32)]


class sinew_deformer(Structure):
    _fields_ = [("memory", c_void_p), ("pose_bytes", c_size_t), ("vertex_count", c_uint32), ("joint_count", c_uint32),
                ("tetrahedron_count", c_uint32), ("node_count", c_uint32), ("split_cell_count", c_uint32),
                ("reserved", c_uint32 * 7)]


class sinew_deform_outputs(Structure):
    _fields_ = [("struct_size", c_uint32), ("corrected", c_uint32), ("positions", c_void_p), ("active_tetrahedra", c_uint32),
                ("inverted_tetrahedra", c_uint32)]


_SIZE = POINTER(c_size_t)
_COUNTS = [c_uint32, c_uint32, c_uint32]
_MODEL, _MESH, _SKELETON = POINTER(sinew_model), POINTER(sinew_mesh), POINTER(sinew_skeleton)
_BLOCK = [c_void_p, c_size_t]
_SKINNED = [c_void_p, c_uint32, POINTER(sinew_skin), c_void_p, c_uint32, c_void_p]

_STATUS_FUNCTIONS = {
    "sinew_model_open": [c_void_p, c_size_t, _MODEL],
    "sinew_rig_model_open": [c_void_p, c_size_t, _MODEL],
    "sinew_model_pack": [_MODEL, *_BLOCK],
    "sinew_bind_workspace_size": [_MODEL, *_COUNTS, c_uint32, POINTER(sinew_options), _SIZE],
    "sinew_bind": [_MODEL, _MESH, _SKELETON, POINTER(sinew_options), *_BLOCK, POINTER(sinew_bind_outputs)],
    "sinew_rig_workspace_size": [_MODEL, *_COUNTS, POINTER(sinew_rig_options), _SIZE],
    "sinew_rig": [_MODEL, _MESH, POINTER(sinew_rig_options), *_BLOCK, POINTER(sinew_rig_outputs)],
    "sinew_rig_details_workspace_size": [_MODEL, *_COUNTS, c_uint32, POINTER(sinew_rig_options), _SIZE],
    "sinew_rig_details": [_MODEL, _MESH, c_uint32, POINTER(sinew_rig_options), *_BLOCK, POINTER(sinew_rig_outputs)],
    "sinew_map_workspace_size": [c_uint32, c_uint32, _SIZE],
    "sinew_map": [_SKELETON, _SKELETON, POINTER(sinew_map_options), *_BLOCK,
                  POINTER(sinew_map_outputs)],
    "sinew_retarget_create_workspace_size": [c_uint32, c_uint32, _SIZE],
    "sinew_retarget_create": [_SKELETON, _SKELETON, c_void_p, c_void_p,
                              POINTER(sinew_retarget_options), *_BLOCK, POINTER(c_void_p)],
    "sinew_retarget_height": [c_void_p, c_void_p, c_void_p, POINTER(c_float)],
    "sinew_retarget_ground": [c_void_p, c_void_p, c_size_t, POINTER(c_float)],
    "sinew_retarget_frame": [c_void_p, c_void_p, c_void_p, c_float, c_void_p, c_void_p],
    "sinew_retarget_contacts_workspace_size": [c_void_p, POINTER(sinew_motion_body), c_uint32, _SIZE],
    "sinew_retarget_contacts": [c_void_p, POINTER(sinew_motion_body), POINTER(sinew_motion_body), POINTER(sinew_motion_clip),
                                POINTER(sinew_contact_options), *_BLOCK],
    "sinew_transfer_workspace_size": [_MODEL, POINTER(sinew_bound_character), _MESH, _SKELETON,
                                      POINTER(sinew_transfer_options), _SIZE],
    "sinew_transfer": [_MODEL, POINTER(sinew_bound_character), _MESH, _SKELETON, POINTER(sinew_transfer_options), *_BLOCK,
                       POINTER(sinew_transfer_outputs)],
    "sinew_skin_linear": _SKINNED,
    "sinew_skin_dual_quaternion": _SKINNED,
    "sinew_deform_create_workspace_size": [_MESH, c_uint32, c_uint32, POINTER(sinew_deform_options), _SIZE],
    "sinew_deform_create": [_MESH, _SKELETON, POINTER(sinew_skin), POINTER(sinew_deform_options), *_BLOCK,
                            POINTER(sinew_deformer)],
    "sinew_deform_pose": [POINTER(sinew_deformer), c_void_p, *_BLOCK, POINTER(sinew_deform_outputs)],
}

_library: Optional[ctypes.CDLL] = None


def data_folder() -> Path:
    """Where the package has its library and its models."""
    return Path(__file__).resolve().parent / "data"


def _library_path() -> Path:
    named = os.environ.get("SINEW_LIBRARY")
    if named:
        if not Path(named).is_file():
            raise Error(f"SINEW_LIBRARY={named}: no such file; expected the shared library of the engine")
        return Path(named)
    names = {"win32": ["libsinew.dll", "sinew.dll"], "darwin": ["libsinew.dylib"]}.get(sys.platform, ["libsinew.so"])
    for name in names:
        if (data_folder() / name).is_file():
            return data_folder() / name
    raise Error(f"{data_folder() / names[0]}: the engine's library is missing; install the wheel that samples/python/build.sh "
                "makes, or name a library in SINEW_LIBRARY")


def library() -> ctypes.CDLL:
    """The engine's shared library, loaded once. Raises Error where it is missing, for another machine or of another version."""
    global _library
    if _library is not None:
        return _library
    path = _library_path()
    try:
        loaded = ctypes.CDLL(str(path))
    except OSError as error:
        raise Error(f"{path}: cannot load the engine's library, {error}; it must be built for this machine") from None
    try:
        loaded.sinew_version.restype = loaded.sinew_status_text.restype = c_char_p
        loaded.sinew_status_text.argtypes = [c_int]
        version = loaded.sinew_version().decode()
        if not version.startswith(_VERSION):
            raise Error(f"{path}: expected version {_VERSION}x of the engine, found {version}; install library and package of "
                        "one version")
        for name, arguments in _STATUS_FUNCTIONS.items():
            function = getattr(loaded, name)
            function.restype, function.argtypes = c_int, arguments
    except AttributeError as error:
        raise Error(f"{path}: is no library of sinew {_VERSION}x, {error}") from None
    _library = loaded
    return loaded


def check(status: int, what: str) -> None:
    """Raises Error with `what` and the status' text, or Cancelled; nothing for SINEW_OK."""
    if status != 0:
        text = library().sinew_status_text(status).decode()
        raise (Cancelled if status == _CANCELLED else Error)(f"{what}: {text}", status)


def init(struct: type) -> Any:
    """A struct that begins with struct_size, as its ..._init() of C makes it: all else is 0."""
    return struct(struct_size=ctypes.sizeof(struct))


def address(array: Optional[np.ndarray]) -> Optional[int]:
    """Where an array's elements lie, for a c_void_p; None stays null. The caller keeps the array."""
    return None if array is None else array.ctypes.data


class Block:
    """Uninitialised bytes at an address divisible by 64."""

    def __init__(self, size_bytes: int) -> None:
        try:
            self._memory = np.empty(size_bytes + WORKSPACE_ALIGNMENT, np.uint8)
        except (MemoryError, ValueError):
            raise Error(f"no memory for a workspace of {size_bytes // 1000000} MB in one piece") from None
        self.size_bytes = size_bytes
        self.address = -(-self._memory.ctypes.data // WORKSPACE_ALIGNMENT) * WORKSPACE_ALIGNMENT


def block(size_query: str, what: str, *arguments: Any) -> Block:
    """A block as large as the query says: size_query(*arguments, &size)."""
    size = c_size_t(0)
    check(getattr(library(), size_query)(*arguments, ctypes.byref(size)), what)
    return Block(size.value)


class Progress:
    """A Python function as sinew_progress. What it raises, Ctrl-C above all, ends the call and is raised by finish()."""

    def __init__(self, function: Optional[Callable[[float], Any]]) -> None:
        self._function = function
        self._raised: Optional[BaseException] = None
        self.callback = PROGRESS(self._step)

    def _step(self, _user: Any, done_permille: int) -> int:
        try:
            return 1 if self._function is not None and self._function(done_permille / 1000) else 0
        except BaseException as error:  # nothing may pass through the library
            self._raised = error
            return 1

    def finish(self, status: int, what: str) -> None:
        """check(), but what the function raised goes first."""
        if self._raised is not None:
            raise self._raised
        check(status, what)


class Threads:
    """Threads of a pool as sinew_parallel_for, for the time of a `with` block."""

    def __init__(self, count: int) -> None:
        if not 1 <= count <= MAX_THREADS:
            raise ValueError(f"threads: expected 1 to {MAX_THREADS}, found {count}")
        self.count = count
        self.callback = PARALLEL_FOR()
        self._pool: Optional[concurrent.futures.ThreadPoolExecutor] = None

    def __enter__(self) -> "Threads":
        if self.count > 1:
            self._pool = concurrent.futures.ThreadPoolExecutor(self.count - 1)
            self.callback = PARALLEL_FOR(self._run)
        return self

    def __exit__(self, *_: Any) -> None:
        if self._pool is not None:
            self._pool.shutdown()

    def _run(self, _user: Any, count: int, body: Any, body_data: Any) -> None:
        others = [self._pool.submit(body, body_data, i) for i in range(1, count)]
        body(body_data, 0)
        for other in others:
            other.result()
