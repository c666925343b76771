# SPDX-License-Identifier: MIT
"""Converts and checks arguments for the engine. Errors name the argument."""
from __future__ import annotations

import ctypes
from collections.abc import Mapping
from typing import Any, List, Optional, Sequence, Tuple, Union

import numpy as np

from . import binding
from .binding import Array

# Corners of the surface cells of meshio; other types are no surface.
_CELLS = {"triangle": 3, "quad": 4, "polygon": 0}
_IGNORED_CELLS = ("vertex", "line")


def real(value: Any, shape: Tuple[Optional[int], ...], name: str) -> Array:
    """float32 of a shape in which None is any count, C-contiguous; without a copy where it is that already."""
    try:
        array = np.ascontiguousarray(value, np.float32)
    except (TypeError, ValueError):
        raise ValueError(f"{name}: expected numbers of shape {_text(shape)}") from None
    if array.ndim != len(shape) or any(w is not None and w != h for w, h in zip(shape, array.shape)):
        raise ValueError(f"{name}: expected shape {_text(shape)}, found {_text(array.shape)}")
    if not np.isfinite(array).all():
        raise ValueError(f"{name}: element {tuple(int(i) for i in np.argwhere(~np.isfinite(array))[0])} is NaN or infinite")
    return array


def whole(value: Any, shape: Tuple[Optional[int], ...], name: str, dtype: Any, low: int, high: int) -> Array:
    """Integers from `low` to below `high` as `dtype`, C-contiguous."""
    array = np.asarray(value)
    if array.size == 0:
        array = array.astype(dtype)
    if array.dtype.kind not in "iub":
        raise ValueError(f"{name}: expected integers, found {array.dtype}")
    if array.ndim != len(shape) or any(w is not None and w != h for w, h in zip(shape, array.shape)):
        raise ValueError(f"{name}: expected shape {_text(shape)}, found {_text(array.shape)}")
    if array.size and (array.min() < low or array.max() >= high):
        wrong = array.min() if array.min() < low else array.max()
        raise ValueError(f"{name}: expected {low} to {high - 1}, found {wrong}")
    return np.ascontiguousarray(array, dtype)


def mask(value: Any, count: int, name: str) -> Optional[Array]:
    """uint8 [count] from a mask (booleans or uint8, 0: not in it) or from indices (wider integers); None stays
    None."""
    if value is None:
        return None
    array = np.asarray(value)
    if array.dtype in (np.bool_, np.uint8):
        if array.shape != (count,):
            raise ValueError(f"{name}: a mask of {array.dtype}, expected shape ({count},), found {_text(array.shape)}")
        return np.ascontiguousarray(array != 0, np.uint8)
    out = np.zeros(count, np.uint8)
    out[whole(array, (None,), name, np.int64, 0, count)] = 1
    return out


def chosen(value: str, names: Sequence[str], name: str) -> int:
    """Index of a word in a list."""
    if value not in names:
        raise ValueError(f"{name}: expected one of {', '.join(n for n in names if n)}, found {value!r}")
    return list(names).index(value)


class Mesh:
    """A polygon mesh as input for the engine.

    positions  [n, 3] any unit, rest pose
    faces      [f, 3] triangles, [f, 4] quads, [f, k] polygons; or ragged: a list of lists of vertex indices; or several
               such arrays: meshio's `cells` or `cells_dict` as they are (their lines and points are left out); or None
    """

    def __init__(self, positions: Any, faces: Any, name: str = "") -> None:
        self.positions = real(positions, (None, 3), name + "positions")
        offsets, corners = _faces(faces, len(self.positions), name + "faces")
        self.offsets: Optional[Array] = offsets
        self.corners = corners
        self.face_count = len(corners) // 3 if offsets is None else len(offsets) - 1
        self.struct = binding.sinew_mesh(
            positions=binding.address(self.positions), vertex_count=len(self.positions),
            face_offsets=binding.address(self.offsets), face_vertices=binding.address(self.corners),
            face_count=self.face_count, corner_count=len(corners))

    @property
    def counts(self) -> Tuple[int, int, int]:
        """Vertices, faces, corners."""
        return len(self.positions), self.face_count, len(self.corners)

    def triangles(self) -> Array:
        """[t, 3] uint32: polygons as fans."""
        if self.offsets is None:
            return self.corners.reshape(-1, 3)
        sizes = np.diff(self.offsets).astype(np.int64)
        fans = np.maximum(sizes - 2, 0)
        first = np.repeat(self.offsets[:-1].astype(np.int64), fans)
        step = np.arange(fans.sum()) - np.repeat(np.cumsum(fans) - fans, fans)
        return np.stack([self.corners[first], self.corners[first + step + 1], self.corners[first + step + 2]], 1)

    def pointer(self) -> Any:
        return ctypes.byref(self.struct)


def _text(shape: Sequence[Optional[int]]) -> str:
    names = iter("njkl")
    inner = ", ".join(next(names) if s is None else str(s) for s in shape)
    return f"({inner},)" if len(shape) == 1 else f"({inner})"


def _faces(value: Any, vertex_count: int, name: str) -> Tuple[Optional[Array], Array]:
    """CSR offsets (None: all are triangles) and corners, both uint32."""
    blocks = [_one_block(b, vertex_count, n) for b, n in _blocks(value, name)]
    if not blocks:
        return None, np.zeros(0, np.uint32)
    if all(sizes is None for sizes, _ in blocks):
        return None, np.concatenate([c for _, c in blocks]) if len(blocks) > 1 else blocks[0][1]
    sizes = np.concatenate([np.full(len(c) // 3, 3, np.uint32) if s is None else s for s, c in blocks])
    offsets = np.zeros(len(sizes) + 1, np.uint32)
    np.cumsum(sizes, out=offsets[1:])
    return offsets, np.concatenate([c for _, c in blocks])


def _blocks(value: Any, name: str) -> List[Tuple[Any, str]]:
    """Arrays of faces with names for messages."""
    if value is None:
        return []
    if isinstance(value, Mapping):  # meshio's cells_dict
        pairs = [(str(kind), data) for kind, data in value.items()]
    elif isinstance(value, (list, tuple)) and len(value) and all(hasattr(b, "type") and hasattr(b, "data") for b in value):
        pairs = [(str(b.type), b.data) for b in value]  # meshio's cells
    elif isinstance(value, (list, tuple)) and len(value) and all(getattr(b, "ndim", 0) == 2 for b in value):
        return [(b, f"{name}[{i}]") for i, b in enumerate(value)]
    else:
        return [(value, name)]
    for kind, _ in pairs:
        if kind not in _CELLS and kind not in _IGNORED_CELLS:
            raise ValueError(f"{name}: cells of type {kind} are no surface of triangles, quads or polygons")
    return [(data, f"{name}[{kind!r}]") for kind, data in pairs if kind in _CELLS]


def _one_block(value: Any, vertex_count: int, name: str) -> Tuple[Optional[Array], Array]:
    """Face sizes (None: triangles) and corners."""
    array: Union[Array, Any] = value
    ragged = isinstance(value, (list, tuple)) and len({len(f) if hasattr(f, "__len__") else -1 for f in value}) > 1
    if not ragged:
        array = np.asarray(value)
    if ragged or array.dtype == object:
        try:
            rows = [np.asarray(f) for f in value]
            sizes = np.array([len(f) for f in rows], np.uint32)
            corners = np.concatenate(rows) if rows else np.zeros(0, np.uint32)
        except (TypeError, ValueError):
            raise ValueError(f"{name}: expected lists of vertex indices, one per face") from None
        return sizes, whole(corners, (None,), name, np.uint32, 0, vertex_count)
    if array.size == 0:
        return None, np.zeros(0, np.uint32)
    array = whole(array, (None, None), name, np.uint32, 0, vertex_count)
    if array.shape[1] < 3:
        raise ValueError(f"{name}: expected at least 3 corners a face, found shape {_text(array.shape)}")
    return None if array.shape[1] == 3 else np.full(len(array), array.shape[1], np.uint32), array.reshape(-1)
