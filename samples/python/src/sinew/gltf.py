# SPDX-License-Identifier: MIT
"""load() and save(): characters of glTF 2.0 files. What the package does not know of, materials and textures above all, stays.

Compressed files (Draco, meshopt) are read by the command: `sinew bind in.glb -o out.glb` writes them plain.
"""
from __future__ import annotations

import base64
import copy
import json
import os
import struct
import tempfile
import urllib.parse
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Dict, List, Optional, Tuple, Union

import numpy as np

from .arrays import Mesh
from .binding import Error
from .character import Character, Clip, Skeleton, Skin, skin_of

_MAGIC, _JSON, _BIN = 0x46546C67, 0x4E4F534A, 0x004E4942
_DTYPES = {5120: np.int8, 5121: np.uint8, 5122: np.int16, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
_READ = ("KHR_materials_", "KHR_texture_", "KHR_lights_", "KHR_mesh_quantization", "VRM", "VRMC_", "EXT_texture_")


@dataclass
class _Part:
    node: int
    primitive: int
    first: int
    count: int


class _Document:
    """The JSON and the buffers of a file, and where a character's arrays are in them."""

    def __init__(self, content: Dict[str, Any], buffers: List[bytes], name: str) -> None:
        self.json, self.buffers, self.name = content, buffers, name
        self.parts: List[_Part] = []
        self.skeleton: Optional[Skeleton] = None
        self.joint_nodes: List[int] = []
        self.inverse_binds = np.zeros((0, 4, 4))
        self.clips: List[Clip] = []

    def list(self, key: str) -> List[Any]:
        return self.json.get(key, [])

    def parents(self) -> List[int]:
        out = [-1] * len(self.list("nodes"))
        for i, node in enumerate(self.list("nodes")):
            for child in node.get("children", []):
                out[child] = i
        return out

    def accessor(self, index: int) -> np.ndarray:
        """[count, width], normalised integers as float64."""
        one = self.list("accessors")[index]
        dtype, width, count = _DTYPES[one["componentType"]], _WIDTHS[one["type"]], one["count"]
        out = np.zeros((count, width), dtype)
        if "bufferView" in one:
            out = self._view(one["bufferView"], one.get("byteOffset", 0), count, width, dtype)
        if "sparse" in one:
            sparse = one["sparse"]
            places, values = sparse["indices"], sparse["values"]
            at = self._view(places["bufferView"], places.get("byteOffset", 0), sparse["count"], 1, _DTYPES[places["componentType"]])
            out = out.copy()
            out[at[:, 0]] = self._view(values["bufferView"], values.get("byteOffset", 0), sparse["count"], width, dtype)
        if one.get("normalized") and dtype != np.float32:
            return np.maximum(out / np.iinfo(dtype).max, -1.0)
        return out

    def _view(self, view: int, offset: int, count: int, width: int, dtype: Any) -> np.ndarray:
        one = self.list("bufferViews")[view]
        first = one.get("byteOffset", 0) + offset
        item = np.dtype(dtype).itemsize * width
        stride = one.get("byteStride", item)
        data = self.buffers[one["buffer"]]
        if count and first + stride * (count - 1) + item > len(data):
            raise ValueError("an accessor ends behind its buffer")
        return np.ndarray((count, width), np.dtype(dtype).newbyteorder("<"), data, first, (stride, np.dtype(dtype).itemsize))

    def add(self, array: np.ndarray, kind: str, target: Optional[int] = None, normalized: bool = False, bounds: bool = False) -> int:
        """A new accessor in the first buffer; its number."""
        array = np.ascontiguousarray(array)
        data = self.buffers[0] + b"\0" * (-len(self.buffers[0]) % 4)
        view: Dict[str, Any] = {"buffer": 0, "byteOffset": len(data), "byteLength": array.nbytes}
        if target is not None:
            view["target"] = target
        self.buffers[0] = data + array.tobytes()
        self.json.setdefault("bufferViews", []).append(view)
        one: Dict[str, Any] = {"bufferView": len(self.list("bufferViews")) - 1, "type": kind, "count": array.size // _WIDTHS[kind],
                               "componentType": next(c for c, d in _DTYPES.items() if d == array.dtype.type)}
        if normalized:
            one["normalized"] = True
        if bounds:
            rows = array.reshape(-1, _WIDTHS[kind])
            one["min"], one["max"] = rows.min(0).tolist(), rows.max(0).tolist()
        self.json.setdefault("accessors", []).append(one)
        return len(self.list("accessors")) - 1


def load(path: Union[str, os.PathLike], fps: Optional[float] = None) -> Character:
    """Reads a .glb, .gltf or .vrm: meshes with a skin, or all where none has one; skeleton, weights, animations.

    fps  frames a second of the clips; None: as their keys lie
    Returns a Character in the bind pose; positions of files without skins are in the world. Raises Error, which names the
    file and what is wrong with it.
    """
    name = os.fspath(path)
    try:
        content, buffers = _read(Path(path))
        for extension in content.get("extensionsRequired", []):
            if not extension.startswith(_READ):
                raise Error(f"{name}: needs {extension}; rewrite it with the command, `sinew bind` or `sinew rig`, which reads it")
        return _character(_Document(content, buffers, name), fps)
    except OSError as error:
        raise Error(f"{name}: cannot read, {error.strerror}") from None
    except (KeyError, IndexError, ValueError, TypeError, AttributeError, struct.error) as error:
        raise Error(f"{name}: is no glTF 2.0 file that can be read, {type(error).__name__}: {error}") from None


def save(path: Union[str, os.PathLike], character: Character) -> None:
    """Writes a .glb: mesh, skeleton, weights and clips. A character of load() keeps all else of its file.

    Raises ValueError and Error; a file that was there stays as it was then.
    """
    name = os.fspath(path)
    if not name.lower().endswith((".glb", ".vrm")):
        raise ValueError(f"{name}: expected a file name that ends in .glb")
    if character.skin is not None and character.skeleton is None:
        raise ValueError("character.skeleton: a skin needs one")
    document = character.document
    document = _new_document(character) if document is None else copy.copy(document)
    document.json, document.buffers = copy.deepcopy(document.json), list(document.buffers)
    _one_buffer(document)
    if character.skin is not None:
        _write_skin(document, character)
    document.json["buffers"] = [{"byteLength": len(document.buffers[0])}]
    text = json.dumps(document.json, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    data = document.buffers[0] + b"\0" * (-len(document.buffers[0]) % 4)
    size = 12 + 8 + len(text) + 8 + len(data)
    whole = struct.pack("<5I", _MAGIC, 2, size, len(text), _JSON) + text + struct.pack("<2I", len(data), _BIN) + data
    folder = os.path.dirname(os.path.abspath(name))
    try:
        handle, temporary = tempfile.mkstemp(dir=folder, suffix=".tmp")
        try:
            with os.fdopen(handle, "wb") as file:
                file.write(whole)
            mode = os.umask(0)
            os.umask(mode)
            os.chmod(temporary, 0o666 & ~mode)
            os.replace(temporary, name)
        except BaseException:
            os.unlink(temporary)
            raise
    except OSError as error:
        raise Error(f"{name}: cannot write, {error.strerror}") from None


def _read(path: Path) -> Tuple[Dict[str, Any], List[bytes]]:
    data = path.read_bytes()
    chunk: Optional[bytes] = None
    if data[:4] == b"glTF":
        _, version, size = struct.unpack_from("<3I", data)
        if version != 2 or size > len(data):
            raise ValueError(f"version {version} of {size} bytes, expected version 2 of at most {len(data)}")
        at, text = 12, b""
        while at + 8 <= size:
            length, kind = struct.unpack_from("<2I", data, at)
            if kind == _JSON:
                text = data[at + 8:at + 8 + length]
            elif kind == _BIN and chunk is None:
                chunk = data[at + 8:at + 8 + length]
            at += 8 + length
    else:
        text = data
    content = json.loads(text)
    buffers = []
    for one in content.get("buffers", []):
        uri = one.get("uri")
        if uri is None:
            buffers.append(chunk or b"")
        elif uri.startswith("data:"):
            buffers.append(base64.b64decode(uri.split(",", 1)[1]))
        else:
            buffers.append((path.parent / urllib.parse.unquote(uri)).read_bytes())
    return content, buffers


def _matrix(node: Dict[str, Any]) -> np.ndarray:
    if "matrix" in node:
        return np.array(node["matrix"], np.float64).reshape(4, 4).T
    return _compose(np.array(node.get("rotation", [0, 0, 0, 1]), np.float64), np.array(node.get("translation", [0, 0, 0]), np.float64),
                    np.array(node.get("scale", [1, 1, 1]), np.float64))


def _compose(rotation: np.ndarray, translation: np.ndarray, scale: Any = 1.0) -> np.ndarray:
    """[..., 4, 4] of rotations x y z w, translations, scales."""
    q = rotation / np.maximum(np.linalg.norm(rotation, axis=-1, keepdims=True), 1e-30)
    x, y, z, w = np.moveaxis(q, -1, 0)
    out = np.zeros((*q.shape[:-1], 4, 4))
    out[..., 0, :3] = np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)], -1)
    out[..., 1, :3] = np.stack([2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)], -1)
    out[..., 2, :3] = np.stack([2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)], -1)
    out[..., :3, :3] *= np.asarray(scale)[..., None, :] if np.ndim(scale) else scale
    out[..., :3, 3] = translation
    out[..., 3, 3] = 1
    return out


def _rotation(matrices: np.ndarray) -> np.ndarray:
    """[..., 4] x y z w of [..., 4, 4], scale left out."""
    m = matrices[..., :3, :3]
    m = m / np.maximum(np.linalg.norm(m, axis=-2, keepdims=True), 1e-30)
    trace = m[..., 0, 0] + m[..., 1, 1] + m[..., 2, 2]
    squares = np.stack([1 + 2 * m[..., i, i] - trace for i in range(3)] + [1 + trace], -1)
    best = squares.argmax(-1)
    out = np.empty((*m.shape[:-2], 4))
    pairs = {(0, 1): m[..., 0, 1] + m[..., 1, 0], (0, 2): m[..., 0, 2] + m[..., 2, 0], (1, 2): m[..., 1, 2] + m[..., 2, 1],
             (0, 3): m[..., 2, 1] - m[..., 1, 2], (1, 3): m[..., 0, 2] - m[..., 2, 0], (2, 3): m[..., 1, 0] - m[..., 0, 1]}
    for i in range(4):
        row = np.stack([squares[..., i] if j == i else pairs[min(i, j), max(i, j)] for j in range(4)], -1)
        out[best == i] = row[best == i]
    return out / np.maximum(np.linalg.norm(out, axis=-1, keepdims=True), 1e-30)


def _worlds(document: _Document, locals_: List[np.ndarray]) -> List[np.ndarray]:
    """World matrices of all nodes, each of the shape of its local ones."""
    parents, done = document.parents(), {}

    def world(i: int) -> np.ndarray:
        way = []
        while i >= 0 and i not in done:
            if i in way:
                raise ValueError("nodes form a cycle")
            way.append(i)
            i = parents[i]
        for n in reversed(way):
            done[n] = locals_[n] if parents[n] < 0 else done[parents[n]] @ locals_[n]
        return done[way[0]] if way else done[i]

    return [world(i) for i in range(len(locals_))]


def _triangles(document: _Document, primitive: Dict[str, Any], count: int) -> np.ndarray:
    mode = primitive.get("mode", 4)
    index = document.accessor(primitive["indices"])[:, 0].astype(np.int64) if "indices" in primitive else np.arange(count)
    if mode == 4:
        return index[:len(index) // 3 * 3].reshape(-1, 3)
    step = np.arange(max(len(index) - 2, 0))
    if mode == 6:
        return np.stack([index[np.zeros_like(step)], index[step + 1], index[step + 2]], 1)
    odd = step % 2  # of a strip
    return np.stack([index[step], index[step + 1 + odd], index[step + 2 - odd]], 1)


def _character(document: _Document, fps: Optional[float]) -> Character:
    nodes = document.list("nodes")
    local = [_matrix(n) for n in nodes]
    worlds = _worlds(document, local)
    skinned = [i for i, n in enumerate(nodes) if "mesh" in n and "skin" in n]
    meshed = skinned or [i for i, n in enumerate(nodes) if "mesh" in n]
    joints: List[int] = []
    binds: Dict[int, np.ndarray] = {}
    for skin in [document.list("skins")[nodes[i]["skin"]] for i in skinned] or document.list("skins")[:1]:
        given = document.accessor(skin["inverseBindMatrices"]) if "inverseBindMatrices" in skin else None
        for k, joint in enumerate(skin["joints"]):
            matrix = np.eye(4) if given is None else given[k].reshape(4, 4).T.astype(np.float64)
            if joint not in binds:
                joints.append(joint)
                binds[joint] = matrix
            elif not np.allclose(binds[joint], matrix, rtol=1e-3, atol=1e-4):
                raise Error(f"{document.name}: its skins have different bind poses; bring them to one with `sinew bind`")
    number = {joint: i for i, joint in enumerate(joints)}
    positions, faces, rows, first = [], [], [], 0
    for i in meshed:
        for p, primitive in enumerate(document.list("meshes")[nodes[i]["mesh"]]["primitives"]):
            if primitive.get("mode", 4) < 4 or "POSITION" not in primitive["attributes"]:
                continue
            at = document.accessor(primitive["attributes"]["POSITION"]).astype(np.float64)
            if not skinned:
                at = at @ worlds[i][:3, :3].T + worlds[i][:3, 3]
            document.parts.append(_Part(i, p, first, len(at)))
            positions.append(at)
            faces.append(_triangles(document, primitive, len(at)) + first)
            rows.append(_rows(document, primitive["attributes"], nodes[i], number, len(at)))
            first += len(at)
    if not positions and not joints:
        raise Error(f"{document.name}: has neither triangles nor a skeleton")
    character = Character(np.concatenate(positions).astype(np.float32) if positions else np.zeros((0, 3), np.float32),
                          np.concatenate(faces).astype(np.uint32) if faces else np.zeros((0, 3), np.uint32),
                          name=Path(document.name).stem, document=document)
    if joints:
        document.joint_nodes, document.inverse_binds = joints, np.stack([binds[j] for j in joints])
        character.skeleton = document.skeleton = _skeleton(document, number)
        _read_clips(document, local, worlds, number, fps)
        character.clips = list(document.clips)
    if any(row is not None for row in rows):
        width = max(row[0].shape[1] for row in rows if row is not None)
        joined = [np.zeros((first, width), np.uint16), np.zeros((first, width), np.float32)]
        for part, row in zip(document.parts, rows):
            if row is not None:
                for out, one in zip(joined, row):
                    out[part.first:part.first + part.count, :one.shape[1]] = one
        character.skin = Skin(*joined).rounded(min(width, 12))
    return character


def _rows(document: _Document, attributes: Dict[str, int], node: Dict[str, Any], number: Dict[int, int], count: int) -> Any:
    """Joints and weights of a primitive, or None."""
    if "skin" not in node or "JOINTS_0" not in attributes:
        return None
    listed = np.array([number[j] for j in document.list("skins")[node["skin"]]["joints"]], np.uint16)
    joints, weights = [], []
    for k in range(3):
        if f"JOINTS_{k}" in attributes and f"WEIGHTS_{k}" in attributes:
            joints.append(listed[document.accessor(attributes[f"JOINTS_{k}"]).astype(np.int64)])
            weights.append(document.accessor(attributes[f"WEIGHTS_{k}"]))
    joints, weights = np.concatenate(joints, 1), np.concatenate(weights, 1)
    return np.where(weights > 0, joints, 0), weights


def _skeleton(document: _Document, number: Dict[int, int]) -> Skeleton:
    nodes, parents = document.list("nodes"), document.parents()
    rest = np.linalg.inv(document.inverse_binds)
    above = []
    for joint in document.joint_nodes:
        at = parents[joint]
        while at >= 0 and at not in number:
            at = parents[at]
        above.append(number.get(at, -1))
    names = [nodes[j].get("name", f"joint_{i}") for i, j in enumerate(document.joint_nodes)]
    return Skeleton(rest[:, :3, 3], above, names, rotations=_rotation(rest))


def _sample(document: _Document, sampler: Dict[str, Any], times: np.ndarray, turns: bool) -> np.ndarray:
    keys = document.accessor(sampler["input"])[:, 0].astype(np.float64)
    values = document.accessor(sampler["output"]).astype(np.float64)
    how = sampler.get("interpolation", "LINEAR")
    if how == "CUBICSPLINE":
        values = values.reshape(len(keys), 3, -1)[:, 1]  # its points; between them straight
    right = np.clip(np.searchsorted(keys, times, "right"), 1, max(len(keys) - 1, 1))
    right = np.minimum(right, len(keys) - 1)
    left = np.maximum(right - 1, 0)
    span = np.maximum(keys[right] - keys[left], 1e-12)
    share = np.clip((times - keys[left]) / span, 0, 1)[:, None]
    if how == "STEP":
        share = np.floor(share)
    a, b = values[left], values[right]
    if turns:
        b = np.where((a * b).sum(1, keepdims=True) < 0, -b, b)
    return a + share * (b - a)


def _read_clips(document: _Document, local: List[np.ndarray], worlds: List[np.ndarray], number: Dict[int, int],
                fps: Optional[float]) -> None:
    nodes = document.list("nodes")
    for a, animation in enumerate(document.list("animations")):
        channels = [c for c in animation["channels"] if "node" in c["target"] and c["target"]["path"] in
                    ("rotation", "translation", "scale")]
        keys = [document.accessor(animation["samplers"][c["sampler"]]["input"])[:, 0].astype(np.float64) for c in channels]
        if not keys or not max(len(k) for k in keys):
            continue
        end = max(k[-1] for k in keys if len(k))
        longest = max(keys, key=len)
        rate = fps or (1 / np.median(np.diff(longest)) if len(longest) > 1 else 30.0)
        times = np.arange(int(np.floor(end * rate + 1e-3)) + 1) / rate
        parts: Dict[int, Dict[str, np.ndarray]] = {}
        for c in channels:
            path = c["target"]["path"]
            parts.setdefault(c["target"]["node"], {})[path] = _sample(document, animation["samplers"][c["sampler"]], times,
                                                                      path == "rotation")
        moved = list(local)
        for n, part in parts.items():
            node = nodes[n]
            moved[n] = _compose(part.get("rotation", np.tile(node.get("rotation", [0.0, 0, 0, 1]), (len(times), 1))),
                                part.get("translation", np.tile(node.get("translation", [0.0, 0, 0]), (len(times), 1))),
                                part.get("scale", np.tile(node.get("scale", [1.0, 1, 1]), (len(times), 1))))
        posed = _worlds(document, moved)
        rotations = np.zeros((len(times), len(number), 4))
        translations = np.zeros((len(times), len(number), 3))
        for joint, i in number.items():
            above = document.skeleton.parents[i]
            if above >= 0:
                base = np.linalg.inv(posed[document.joint_nodes[above]])
            else:
                base = np.linalg.inv(_stand(document, worlds, i))
            pose = np.broadcast_to(base @ posed[joint], (len(times), 4, 4))
            rotations[:, i], translations[:, i] = _rotation(pose), pose[:, :3, 3]
        document.clips.append(Clip(rotations, translations, float(rate), animation.get("name", f"animation_{a}")))


def _stand(document: _Document, worlds: List[np.ndarray], joint: int) -> np.ndarray:
    """How the world of the file is turned, moved and scaled against the skeleton's: armatures that stand somewhere."""
    out = worlds[document.joint_nodes[joint]] @ document.inverse_binds[joint]
    return np.eye(4) if np.allclose(out, np.eye(4), atol=1e-5) else out


def _new_document(character: Character) -> _Document:
    mesh = Mesh(character.positions, character.faces, "character.")
    content: Dict[str, Any] = {"asset": {"version": "2.0", "generator": "sinew"}, "scene": 0, "scenes": [{"nodes": [0]}],
                               "nodes": [{"name": character.name, "mesh": 0}]}
    document = _Document(content, [b""], character.name)
    place = document.add(mesh.positions, "VEC3", 34962, bounds=True)
    primitive: Dict[str, Any] = {"attributes": {"POSITION": place}}
    if len(mesh.corners):
        primitive["indices"] = document.add(mesh.triangles().reshape(-1), "SCALAR", 34963)
    else:
        primitive["mode"] = 0
    content["meshes"] = [{"name": character.name, "primitives": [primitive]}]
    document.parts = [_Part(0, 0, 0, len(mesh.positions))]
    return document


def _one_buffer(document: _Document) -> None:
    """All buffers in one, so that a .glb holds them."""
    starts, whole = [], b""
    for data in document.buffers or [b""]:
        whole += b"\0" * (-len(whole) % 8)
        starts.append(len(whole))
        whole += data
    for view in document.list("bufferViews"):
        view["byteOffset"] = view.get("byteOffset", 0) + starts[view["buffer"]]
        view["buffer"] = 0
    folder = Path(document.name).parent
    for image in document.list("images"):
        uri = image.get("uri", "data:")
        if not uri.startswith("data:"):  # a texture beside the file goes into it
            content = (folder / urllib.parse.unquote(uri)).read_bytes()
            kind = "image/png" if content[:4] == b"\x89PNG" else "image/jpeg"
            whole += b"\0" * (-len(whole) % 8)
            document.json.setdefault("bufferViews", []).append({"buffer": 0, "byteOffset": len(whole), "byteLength": len(content)})
            whole += content
            del image["uri"]
            image.update(bufferView=len(document.list("bufferViews")) - 1, mimeType=kind)
    document.buffers = [whole]


def _write_skin(document: _Document, character: Character) -> None:
    skeleton = character.skeleton
    skin = skin_of(character.skin, sum(p.count for p in document.parts), len(skeleton), "character.skin")
    nodes = document.json["nodes"]
    if document.skeleton is not skeleton:
        _new_joints(document, skeleton)
    local = [_matrix(n) for n in nodes]
    worlds = _worlds(document, local)
    was_skinned = bool(document.list("skins"))
    binds = document.inverse_binds.transpose(0, 2, 1).astype(np.float32).reshape(-1, 16)
    document.json["skins"] = [{"joints": document.joint_nodes, "inverseBindMatrices": document.add(binds, "MAT4")}]
    meshes = document.json["meshes"]
    taken = set()
    for node in sorted({p.node for p in document.parts}):
        if nodes[node]["mesh"] in taken:  # two nodes show one mesh, and each has weights of its own
            meshes.append(copy.deepcopy(meshes[nodes[node]["mesh"]]))
            nodes[node]["mesh"] = len(meshes) - 1
        taken.add(nodes[node]["mesh"])
        nodes[node]["skin"] = 0
    integers = skin.weights.dtype != np.float32
    for part in document.parts:
        primitive = meshes[nodes[part.node]["mesh"]]["primitives"][part.primitive]
        attributes = {n: a for n, a in primitive["attributes"].items() if not n.startswith(("JOINTS_", "WEIGHTS_"))}
        world = worlds[part.node]
        if not was_skinned and not np.allclose(world, np.eye(4)):
            _to_world(document, attributes, world)
        rows = slice(part.first, part.first + part.count)
        for k in range(0, skin.joints.shape[1], 4):
            joints, weights = (np.zeros((part.count, 4), a.dtype) for a in (skin.joints, skin.weights))
            width = min(4, skin.joints.shape[1] - k)
            joints[:, :width], weights[:, :width] = skin.joints[rows, k:k + width], skin.weights[rows, k:k + width]
            attributes[f"JOINTS_{k // 4}"] = document.add(joints, "VEC4", 34962)
            attributes[f"WEIGHTS_{k // 4}"] = document.add(weights, "VEC4", 34962, normalized=integers)
        primitive["attributes"] = attributes
    for clip in character.clips:
        if not any(clip is known for known in document.clips):
            _write_clip(document, skeleton, clip, worlds)


def _to_world(document: _Document, attributes: Dict[str, int], world: np.ndarray) -> None:
    """Skinned meshes lie in the world: the node's own place counts no more."""
    at = document.accessor(attributes["POSITION"]).astype(np.float64) @ world[:3, :3].T + world[:3, 3]
    attributes["POSITION"] = document.add(at.astype(np.float32), "VEC3", 34962, bounds=True)
    if "NORMAL" in attributes:
        normals = document.accessor(attributes["NORMAL"]).astype(np.float64) @ np.linalg.inv(world[:3, :3])
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
        attributes["NORMAL"] = document.add(normals.astype(np.float32), "VEC3", 34962)
    attributes.pop("TANGENT", None)


def _new_joints(document: _Document, skeleton: Skeleton) -> None:
    nodes = document.json["nodes"]
    first = len(nodes)
    rotations, translations = skeleton.rest()
    for i, name in enumerate(skeleton.names):
        nodes.append({"name": str(name), "rotation": rotations[i].tolist(), "translation": translations[i].tolist()})
    for i, parent in enumerate(skeleton.parents):
        if parent >= 0:
            nodes[first + parent].setdefault("children", []).append(first + i)
        else:
            document.json["scenes"][document.json.get("scene", 0)].setdefault("nodes", []).append(first + i)
    document.joint_nodes = list(range(first, len(nodes)))
    document.inverse_binds = np.linalg.inv(_compose(skeleton.world_rotations(), skeleton.positions.astype(np.float64)))


def _write_clip(document: _Document, skeleton: Skeleton, clip: Clip, worlds: List[np.ndarray]) -> None:
    if clip.rotations.shape[1] != len(skeleton):
        raise ValueError(f"character.clips: {clip.name} has {clip.rotations.shape[1]} joints, and the skeleton {len(skeleton)}")
    times = document.add((np.arange(len(clip.rotations)) / clip.fps).astype(np.float32), "SCALAR", bounds=True)
    parents = document.parents()
    animation: Dict[str, Any] = {"name": clip.name, "samplers": [], "channels": []}
    for i, node in enumerate(document.joint_nodes):
        document.json["nodes"][node].pop("matrix", None)
        above = skeleton.parents[i]
        base = worlds[document.joint_nodes[above]] if above >= 0 else _stand(document, worlds, i)
        between = np.eye(4) if parents[node] < 0 else worlds[parents[node]]  # nodes that are no joints stand still
        pose = np.linalg.inv(between) @ base @ _compose(clip.rotations[:, i].astype(np.float64), clip.translations[:, i].astype(np.float64))
        for path, values, kind in (("rotation", _rotation(pose), "VEC4"), ("translation", pose[:, :3, 3], "VEC3")):
            animation["samplers"].append({"input": times, "output": document.add(values.astype(np.float32), kind)})
            animation["channels"].append({"sampler": len(animation["samplers"]) - 1, "target": {"node": node, "path": path}})
    document.json.setdefault("animations", []).append(animation)
