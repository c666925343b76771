# SPDX-License-Identifier: MIT
"""What the scene has, as arrays of the world: meshes, skeletons, weights of groups."""
from dataclasses import dataclass, field

import numpy as np

from .sinew import Skeleton
from .work import Problem


@dataclass
class MeshPart:
    """One object's mesh in the joined arrays: rows first .. first + count."""

    object: object
    first: int
    count: int


@dataclass
class JoinedMesh:
    positions: np.ndarray  # [n, 3] float32, world
    faces: list  # polygons by size, as arrays [f, k]; the engine takes several
    parts: list = field(default_factory=list)
    own: int = 0  # vertices that objects have; those behind them are copies that mirror modifiers show


def rest_positions(item):
    """[n, 3] float64 in the object's space: of the basis where there are shape keys."""
    mesh = item.data
    out = np.empty(3 * len(mesh.vertices), np.float32)
    if mesh.shape_keys is not None:
        mesh.shape_keys.reference_key.data.foreach_get("co", out)
    else:
        mesh.vertices.foreach_get("co", out)
    return out.reshape(-1, 3).astype(np.float64)


def _polygons(mesh):
    """Faces by their size: {k: [f, k]}, in the mesh's order within a size."""
    sizes, starts = np.empty(len(mesh.polygons), np.int32), np.empty(len(mesh.polygons), np.int32)
    corners = np.empty(len(mesh.loops), np.int32)
    mesh.polygons.foreach_get("loop_total", sizes)
    mesh.polygons.foreach_get("loop_start", starts)
    mesh.loops.foreach_get("vertex_index", corners)
    return {int(k): corners[starts[sizes == k][:, None] + np.arange(k)].astype(np.int64) for k in np.unique(sizes) if k > 2}


def world_of(item):
    return np.array(item.matrix_world, np.float64)


def moved(points, matrix):
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def _mirrors(item):
    """4x4 matrices in the object's space of what its mirror modifiers show beside the mesh."""
    copies = [np.eye(4)]
    for modifier in item.modifiers:
        if modifier.type != "MIRROR" or not modifier.show_viewport:
            continue
        frame = np.eye(4)
        if modifier.mirror_object is not None:
            frame = np.linalg.inv(world_of(item)) @ world_of(modifier.mirror_object)
        for axis in range(3):
            if modifier.use_axis[axis]:
                flip = np.eye(4)
                flip[axis, axis] = -1
                flip = frame @ flip @ np.linalg.inv(frame)
                copies += [flip @ c for c in copies]
    return copies[1:]


def join(items):
    """Meshes of objects as one, with what mirror modifiers show. Raises Problem."""
    joined = JoinedMesh(np.zeros((0, 3), np.float32), [])
    points, faces, mirrored = [], {}, []
    for item in items:
        own = rest_positions(item)
        if not len(own):
            raise Problem(f"{item.name} has no vertices")
        matrix = world_of(item)
        joined.parts.append(MeshPart(item, joined.own, len(own)))
        points.append(moved(own, matrix))
        polygons = _polygons(item.data)
        for k, block in polygons.items():
            faces.setdefault(k, []).append(block + joined.own)
        for copy in _mirrors(item):
            mirrored.append((moved(own, matrix @ copy), polygons, np.linalg.det(copy[:3, :3]) < 0))
        joined.own += len(own)
    first = joined.own
    for place, polygons, turned in mirrored:
        points.append(place)
        for k, block in polygons.items():
            faces.setdefault(k, []).append((block[:, ::-1] if turned else block) + first)
        first += len(place)
    joined.positions = np.concatenate(points).astype(np.float32)
    joined.faces = [np.concatenate(blocks) for _, blocks in sorted(faces.items())]
    return joined


def skeleton_of(armature):
    """Heads of the bones at rest, in the world; parents before children are not promised."""
    bones = armature.data.bones
    if not len(bones):
        raise Problem(f"{armature.name} has no bones")
    heads = np.array([bone.head_local for bone in bones], np.float64)
    numbers = {bone.name: i for i, bone in enumerate(bones)}
    parents = [numbers[bone.parent.name] if bone.parent else -1 for bone in bones]
    return Skeleton(moved(heads, world_of(armature)), parents, [bone.name for bone in bones])


def is_selected(armature, bone):
    """Whether a bone is selected in pose mode; since Blender 5 its pose bone knows."""
    pose = armature.pose.bones[bone.name]
    return pose.select if hasattr(pose, "select") else bone.select


def armature_of(item):
    """The armature that deforms an object, or None."""
    for modifier in item.modifiers:
        if modifier.type == "ARMATURE" and modifier.object is not None:
            return modifier.object
    return item.parent if item.parent is not None and item.parent.type == "ARMATURE" else None


def chosen(context):
    """Selected meshes in the order of their names, and the armature: the active one, a selected one, or the one that deforms
    the meshes. Raises Problem."""
    meshes = sorted({o for o in context.selected_objects if o.type == "MESH"} |
                    ({context.object} if context.object is not None and context.object.type == "MESH" else set()), key=lambda o: o.name)
    if not meshes:
        raise Problem("select at least one mesh")
    armatures = [o for o in context.selected_objects if o.type == "ARMATURE"]
    if context.object in armatures:
        return meshes, context.object
    found = armatures or list({a for a in (armature_of(m) for m in meshes) if a is not None})
    if len(found) != 1:
        raise Problem("select the armature as well" if not found else "select one armature, there are several")
    return meshes, found[0]


def weights_of(item, names):
    """[n, len(names)] float32: weights of an object's groups with these names."""
    out = np.zeros((len(item.data.vertices), len(names)), np.float32)
    columns = {group.index: names.index(group.name) for group in item.vertex_groups if group.name in names}
    if columns:
        for v, vertex in enumerate(item.data.vertices):
            for element in vertex.groups:
                if element.group in columns:
                    out[v, columns[element.group]] = element.weight
    return out


def selected_vertices(item):
    """[n] bool, those that an operator may change: of edit mode, or of a mask in weight paint; None: all."""
    mesh = item.data
    if item.mode == "EDIT":
        item.update_from_editmode()
    elif not (item.mode == "WEIGHT_PAINT" and (mesh.use_paint_mask or mesh.use_paint_mask_vertex)):
        return None
    out = np.zeros(len(mesh.vertices), bool)
    if item.mode == "WEIGHT_PAINT" and mesh.use_paint_mask:
        for polygon in mesh.polygons:
            if polygon.select:
                out[list(polygon.vertices)] = True
    else:
        mesh.vertices.foreach_get("select", out)
    return out
