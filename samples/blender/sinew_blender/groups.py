# SPDX-License-Identifier: MIT
"""Weights into vertex groups, by lists of vertices of equal weight: a call for each instead of one for each vertex."""
import numpy as np


def write(item, names, joints, weights, rows):
    """Replaces the weights of some vertices in the groups of some bones; other groups and vertices stay.

    names    of the bones, by joint number; only those in `joints` with weight get a group
    joints   [n, k]; weights [n, k] float, 0 to 1
    rows     [n] bool, the vertices
    """
    chosen = np.flatnonzero(rows)
    existing = {group.name: group for group in item.vertex_groups}
    everything = chosen.tolist()
    for name in set(names):
        if name in existing:
            existing[name].remove(everything)
    flat_joints, flat_weights = joints[chosen].ravel(), weights[chosen].astype(np.float32).ravel()
    vertices = np.repeat(chosen, joints.shape[1])
    used = flat_weights > 0
    flat_joints, flat_weights, vertices = flat_joints[used], flat_weights[used], vertices[used]
    order = np.lexsort((vertices, flat_weights, flat_joints))
    flat_joints, flat_weights, vertices = flat_joints[order], flat_weights[order], vertices[order]
    ends = np.flatnonzero((np.diff(flat_joints.astype(np.int64)) != 0) | (np.diff(flat_weights) != 0)) + 1
    starts = np.concatenate([[0], ends]) if len(vertices) else []
    for first, last in zip(starts, np.append(ends, len(vertices))):
        name = names[flat_joints[first]]
        group = existing.get(name)
        if group is None:
            group = existing[name] = item.vertex_groups.new(name=name)
        group.add(vertices[first:last].tolist(), float(flat_weights[first]), "REPLACE")


class ObjectMode:
    """Groups cannot be written in edit mode: goes to object mode for a `with` block, and back."""

    def __init__(self, context, item):
        self._context, self._item = context, item
        self._mode = item.mode if item is not None else "OBJECT"

    def __enter__(self):
        if self._mode == "EDIT":
            self._switch("OBJECT")
        return self

    def __exit__(self, *_):
        if self._mode == "EDIT":
            self._switch("EDIT")

    def _switch(self, mode):
        import bpy
        with self._context.temp_override(active_object=self._item, object=self._item):
            bpy.ops.object.mode_set(mode=mode)
