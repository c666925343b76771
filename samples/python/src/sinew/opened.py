# SPDX-License-Identifier: MIT
"""open(): characters of files, and what the command does with them: the same defaults, the same bytes in what is saved.

    hero = sinew.open("hero.fbx")
    hero.bind()
    hero.retarget(sinew.open("walk.bvh"))
    hero.save("hero.glb")
"""
from __future__ import annotations

import ctypes
import json
import os
from typing import Any, Dict, List, Literal, Mapping, Optional, Sequence, Tuple, Union, cast

import numpy as np

from . import binding, declarations
from .arrays import Mesh, chosen, real
from .binding import Array
from .binder import skeleton_view
from .character import Character, Clip, Skeleton, Skin, multiply, skin_of, turn
from .jobs import Jobs
from .marshalling import array_at, error_line, filled, result_as, run
from .results import LodLevel, PictureInfo

Source = Union[str, "os.PathLike[str]", bytes]
KeypointsLayout = Literal["smpl24", "humanml3d22", "lafan22", "smplh52", "smplx55", "coco17",
                           "h36m17", "h36m32", "kinect25", "openpose25", "mediapipe33"]


def open(source: Source, *, name: str = "", beside: Optional[Mapping[str, bytes]] = None) -> "OpenCharacter":  # noqa: A001
    """Opens a character: a mesh, a skeleton, motion, or all of them, of every format that the command reads.

    source  path of a file, or its bytes
    name    of the file, where bytes are given: its extension says what they are
    beside  {name: bytes} of what lies beside it (a .bin, textures, a .rig.txt), where bytes are given
    Returns an OpenCharacter. Raises Error with the file name and the reason.
    """
    library = binding.character_library()
    handle = ctypes.c_void_p()
    if isinstance(source, (bytes, bytearray, memoryview)):
        files, _kept = _files_of(source, name, beside)
        _check(library.sinew_character_open_files(files, len(files), ctypes.byref(handle)), None)
    else:
        _check(library.sinew_character_open(os.fsencode(source), ctypes.byref(handle)), None)
    return OpenCharacter(handle)


def open_picture(source: Source, *, name: str = "", beside: Optional[Mapping[str, bytes]] = None,
                 body_class: declarations.BodyClass = "found", figure: int = 0, flat: bool = False, units: Literal["figure", "pixels"] = "figure",
                 mask_file: Union[None, str, "os.PathLike[str]"] = None, outline: Optional[Sequence[Any]] = None, cut: bool = False) -> "OpenCharacter":
    """Opens a drawing or a photograph of a character, PNG or JPEG: its figure as a mesh with the picture as texture. rig() gives it a
    skeleton in the picture's plane; retarget() does so where it has none, and plays a clip of its class where no motion is given.

    source, name, beside  as of open()
    body_class  what kind of body it is; "found": as the model says
    figure      of several figures, from left to right, from 1 on; 0: the largest
    flat        a card instead of a body as thick as it is wide
    units       "figure": its longest side is 1; "pixels": places are the picture's, x right, y up from the bottom edge
    mask_file   a picture that is bright where the figure is, by path or its name in `beside`; None: found
    outline     closed lines [k, 2] round the figure, as Picture has them, in place of what is found
    cut         the figure is opened along lines that are drawn into it from its outline, as a guess: a leg before a leg
    """
    chosen(units, ("figure", "pixels"), "units")
    options, _arrays = filled(declarations.sinew_character_picture_options, {**locals(), "units": units == "pixels"})
    library, handle = binding.character_library(), ctypes.c_void_p()
    if isinstance(source, (bytes, bytearray, memoryview)):
        files, _kept = _files_of(source, name, beside)
        _check(library.sinew_character_open_picture_files(files, len(files), ctypes.byref(options), ctypes.byref(handle)), None)
    else:
        _check(library.sinew_character_open_picture(os.fsencode(source), ctypes.byref(options), ctypes.byref(handle)), None)
    return OpenCharacter(handle)


def open_keypoints(layout: KeypointsLayout, keypoints: Any) -> "OpenCharacter":
    """Keypoints of a person's joints alone, as cameras and captures tell them, as a motion: its skeleton is learned from these frames, which are its
    clip. keypoints_frame() turns those that come into what RetargetStream.frame() takes, with this skeleton as the source.

    layout  which joints the keypoints are
    keypoints  [frames, the number in the layout's name, 3], any unit; a second or two are best
    """
    handle = ctypes.c_void_p()
    rows = real(keypoints, (None, None, 3), "keypoints")
    _check(binding.character_library().sinew_character_open_keypoints(layout.encode(), rows.ctypes.data, rows.shape[1], rows.shape[0], ctypes.byref(handle)), None)
    return OpenCharacter(handle)


def create(character: Character) -> "OpenCharacter":
    """An OpenCharacter of arrays, which are copied: mesh, skeleton, skin, clips. Raises ValueError and Error."""
    library = binding.character_library()
    mesh = Mesh(character.positions, character.faces, "character.")
    handle = ctypes.c_void_p()
    with_mesh = None if len(mesh.positions) == 0 else mesh.pointer()
    view = None if character.skeleton is None else ctypes.byref(_skeleton_view(character.skeleton))
    _check(library.sinew_character_create(with_mesh, view, ctypes.byref(handle)), None)
    out = OpenCharacter(handle)
    if character.skin is not None:
        if character.skeleton is None:
            raise ValueError("character.skeleton: a skin needs one")
        out.set_skin(character.skin)
    for clip in character.clips:
        out.add_clip(clip, character.skeleton)
    return out


def extensions(*uses: str) -> List[str]:
    """Extensions of files that have all of these uses: "read-mesh", "read-motion", "write-character", ... For file dialogs."""
    known = {name.lower().replace("_", "-"): bit for name, bit in declarations.FILE_USE.items()}
    for use in uses:
        chosen(use, list(known), "uses")
    return _words(binding.character_library().sinew_character_extensions(sum(known[u] for u in uses)))


class OpenCharacter(Jobs):
    """A character in the library. Any number may be worked on at the same time, each by one thread at a time."""

    def __init__(self, handle: ctypes.c_void_p) -> None:
        self._handle: Optional[ctypes.c_void_p] = handle
        self._close = binding.character_library().sinew_character_close

    def __enter__(self) -> "OpenCharacter":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def __del__(self) -> None:
        if getattr(self, "_handle", None):
            self.close()

    def close(self) -> None:
        """Gives its memory back. The garbage collector does so, too."""
        handle, self._handle = self._handle, None
        if handle:
            self._close(handle)

    @property
    def pointer(self) -> ctypes.c_void_p:
        if not self._handle:
            raise ValueError("this character is closed")
        return self._handle

    def __repr__(self) -> str:
        if not self._handle:
            return "<sinew.OpenCharacter, closed>"
        view, clips = self._view(), ctypes.c_uint32()
        _check(binding.character_library().sinew_character_clip_count(self.pointer, ctypes.byref(clips)), self)
        weights = "weights" if view.influence_count else "no weights"
        return f"<sinew.OpenCharacter {self.name!r}: {view.vertex_count} vertices, {view.joint_count} joints, {weights}, {clips.value} clips>"

    def copy(self) -> "OpenCharacter":
        handle = ctypes.c_void_p()
        _check(binding.character_library().sinew_character_copy(self.pointer, ctypes.byref(handle)), self)
        return OpenCharacter(handle)

    # ---- files

    def save(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes a file by its extension: .glb, .gltf, .vrm, .fbx, .obj, .rig.txt, .bvh. A glTF keeps all of its input that was not changed.
        A file that was there stays as it was, where this fails."""
        _check(binding.character_library().sinew_character_save(self.pointer, os.fsencode(path)), self)

    def write(self, name: str) -> Dict[str, bytes]:
        """{file name: bytes} of what save(name) would write, the file itself first."""
        files, count = ctypes.POINTER(declarations.sinew_file)(), ctypes.c_uint32()
        _check(binding.character_library().sinew_character_write(self.pointer, name.encode(), ctypes.byref(files), ctypes.byref(count)), self)
        return {files[i].name.decode(): ctypes.string_at(files[i].bytes, files[i].size_bytes) for i in range(count.value)}

    def set_profile(self, profile: Optional[str], *, authors: Sequence[str] = (), license: str = "", title: str = "", keep_axes: bool = False,
                    controls: bool = False) -> None:
        """What save() and write() write from now on: a program or format that `sinew rig --for` lists, None for files as they were read.
        authors, license and title are of a VRM; controls: a glTF says in its extras what controls() says. The rest pose stays: that is
        to_pose of bind and rig."""
        run("set_profile", locals())

    def controls(self) -> Dict[str, Any]:
        """Which joints controls of an animator move (formats/spec/controls.md): `sinew rig --controls`."""
        text = ctypes.c_char_p()
        _check(binding.character_library().sinew_character_controls(self.pointer, ctypes.byref(text)), self)
        return cast(Dict[str, Any], json.loads((text.value or b"").decode()))

    @property
    def notes(self) -> List[str]:
        """Notes and warnings of the reader and the jobs."""
        return str(binding.character_library().sinew_character_notes(self.pointer).decode(errors="replace")).splitlines()

    @property
    def picture(self) -> PictureInfo:
        """What was found in the picture that it is of. Raises Error where it is of none."""
        info = binding.init(declarations.sinew_character_picture_info)
        _check(binding.character_library().sinew_character_picture(self.pointer, ctypes.byref(info)), self)
        return cast(PictureInfo, result_as(info, {}))

    # ---- arrays

    def _view(self) -> Any:
        arrays = binding.init(declarations.sinew_character_arrays)
        _check(binding.character_library().sinew_character_view(self.pointer, ctypes.byref(arrays)), self)
        return arrays

    @property
    def name(self) -> str:
        return str(self._view().name.decode(errors="replace"))

    @property
    def positions(self) -> Array:
        """[n, 3] float32 in the pose that the weights are meant for; a copy, as all arrays are."""
        view = self._view()
        return array_at(view.positions, np.float32, (view.vertex_count, 3))

    @property
    def faces(self) -> Any:
        """[f, 3] uint32 where all are triangles, else a list of arrays [f, k], one for each number of corners."""
        view = self._view()
        offsets = array_at(view.face_offsets, np.uint32, (view.face_count + 1,)) if view.face_offsets else np.zeros(1, np.uint32)
        corners = array_at(view.face_vertices, np.uint32, (view.corner_count,))
        sizes = np.diff(offsets.astype(np.int64))
        kinds = np.unique(sizes)
        blocks = [corners[offsets[:-1][sizes == k][:, None].astype(np.int64) + np.arange(k)] for k in kinds]
        return np.zeros((0, 3), np.uint32) if not blocks else blocks[0] if len(blocks) == 1 and kinds[0] == 3 else blocks

    @property
    def skeleton(self) -> Optional[Skeleton]:
        view = self._view()
        if not view.joint_count:
            return None
        return Skeleton(array_at(view.joint_positions, np.float32, (view.joint_count, 3)), array_at(view.parents, np.int32, (view.joint_count,)),
                        [view.joint_names[j].decode(errors="replace") for j in range(view.joint_count)])

    @property
    def skin(self) -> Optional[Skin]:
        """As bind() gives it, 4 joints a vertex or as many as the longest row has, at most 12; None without weights."""
        view = self._view()
        if not view.influence_count:
            return None
        width = min(max(view.influence_count, 4), declarations.MAX_INFLUENCES)
        joints, weights = (np.zeros((view.vertex_count, width), np.uint16) for _ in range(2))
        _check(binding.character_library().sinew_character_skin(self.pointer, width, joints.ctypes.data, weights.ctypes.data), self)
        confidence = array_at(view.confidence, np.uint8, (view.vertex_count,)) if view.confidence else None
        return Skin(joints, weights, confidence)

    @property
    def meshes(self) -> List[str]:
        """Names of the file's meshes; empty where it has none that are known."""
        view = self._view()
        return [view.mesh_names[m].decode(errors="replace") for m in range(view.mesh_count)]

    def joint_classes(self) -> Array:
        """[j] uint8 of CLASSES: what each joint is for."""
        out = np.zeros(self._view().joint_count, np.uint8)
        _check(binding.character_library().sinew_character_joint_classes(self.pointer, out.ctypes.data), self)
        return out

    def clips(self) -> List[Clip]:
        """Motion of the file and what was added, as poses of the skeleton."""
        library, count = binding.character_library(), ctypes.c_uint32()
        _check(library.sinew_character_clip_count(self.pointer, ctypes.byref(count)), self)
        skeleton = self.skeleton
        return [] if skeleton is None else [self._clip(i, skeleton) for i in range(count.value)]

    def _clip(self, index: int, skeleton: Skeleton) -> Clip:
        one = binding.init(declarations.sinew_character_clip)
        _check(binding.character_library().sinew_character_get_clip(self.pointer, index, ctypes.byref(one)), self)
        frames, count = one.frame_count, one.joint_count
        q = array_at(one.rotations, np.float64, (frames, count, 4))
        p = array_at(one.translations, np.float64, (frames, count, 3))
        parents = array_at(one.parents, np.int32, (count,))
        name, fps = (one.name or b"").decode(errors="replace"), 1 / one.frame_time if one.frame_time > 0 else 30.0
        joints = len(skeleton)
        if not (count == joints and (parents == skeleton.parents).all()):  # nodes around the skeleton move as well
            q, p = _local(*_world(q, p, parents), skeleton.parents)
        return Clip(q[:, :joints], p[:, :joints], fps, name)

    def keypoints_frame(self, keypoints: Any) -> Tuple[Array, Array]:
        """Local rotations [j, 4] and translations [j, 3] of its joints in the frame of these keypoints [n, 3], of open_keypoints()."""
        row, count = real(keypoints, (None, 3), "keypoints"), self._view().joint_count
        rotations, translations = np.zeros((count, 4), np.float32), np.zeros((count, 3), np.float32)
        _check(binding.character_library().sinew_character_keypoints_frame(self.pointer, row.ctypes.data, len(row), rotations.ctypes.data, translations.ctypes.data), self)
        return rotations, translations

    def springs_frame(self, seconds: float, rotations: Any, translations: Any) -> Array:
        """Rotations [j, 4] of a motion's next frame with the chains' joints swung behind it, for motion that arrives frame by frame.

        The springs are those of springs(), or those that it would keep. The first frame shows the pose as it is.
        seconds  since the frame before; ignored in the first frame
        rotations  [j, 4] local, x y z w, as RetargetStream.frame() returns them; translations  [j, 3]
        Raises ValueError for other shapes, and Error where nothing swings.
        """
        count = self._view().joint_count
        q, p = real(rotations, (count, 4), "rotations"), real(translations, (count, 3), "translations")
        out = np.zeros((count, 4), np.float32)
        _check(binding.character_library().sinew_character_springs_frame(self.pointer, seconds, q.ctypes.data, p.ctypes.data, out.ctypes.data), self)
        return out

    def springs_restart(self) -> None:
        """Forget all motion: the next springs_frame() is the first."""
        _check(binding.character_library().sinew_character_springs_restart(self.pointer), self)

    def set_skeleton(self, skeleton: Skeleton) -> None:
        """Another skeleton for the mesh; weights go."""
        _check(binding.character_library().sinew_character_set_skeleton(self.pointer, ctypes.byref(_skeleton_view(skeleton))), self)

    def take_skeleton(self, other: "OpenCharacter", *, weights: bool = False) -> None:
        """The skeleton of another character, as `sinew bind --skeleton FILE` takes it; with its weights, where the mesh is the same."""
        _check(binding.character_library().sinew_character_take_skeleton(self.pointer, other.pointer, int(weights)), self)

    def set_skin(self, skin: Any) -> None:
        """Weights: a Skin, (joints, weights), or an array [n, j]."""
        view = self._view()
        rows = skin_of(skin, view.vertex_count, view.joint_count, "skin")
        some = rows.weights > 0
        offsets = np.zeros(view.vertex_count + 1, np.uint32)
        np.cumsum(some.sum(1), out=offsets[1:])
        joints = np.ascontiguousarray(rows.joints[some], np.uint32)
        weights = np.ascontiguousarray(rows.weights[some] / np.float32(rows.unit()), np.float32)
        _check(binding.character_library().sinew_character_set_weights(self.pointer, offsets.ctypes.data, joints.ctypes.data,
                                                                      weights.ctypes.data), self)

    def add_clip(self, clip: Clip, skeleton: Optional[Skeleton] = None) -> None:
        """Motion that is saved with the character. skeleton: whose axes at rest the clip is in; None: the world's, as clips() gives it."""
        own = self.skeleton
        if own is None or clip.rotations.shape[1] != len(own):
            raise ValueError(f"clip.rotations: expected {0 if own is None else len(own)} joints as the character has, found {clip.rotations.shape[1]}")
        q, p = clip.rotations.astype(np.float64), clip.translations.astype(np.float64)
        q = q / np.maximum(np.linalg.norm(q, axis=2, keepdims=True), 1e-30)
        if skeleton is not None and skeleton.rotations is not None:
            world, places = _world(q, p, skeleton.parents)
            back = skeleton.world_rotations() * [-1, -1, -1, 1]
            q, p = _local(multiply(world, np.broadcast_to(back, world.shape)), places, own.parents)
        one = binding.init(declarations.sinew_character_clip)
        q, p = np.ascontiguousarray(q), np.ascontiguousarray(p)
        one.frame_count, one.joint_count, one.frame_time, one.name = len(q), len(own), 1 / clip.fps, clip.name.encode()
        one.rotations, one.translations = q.ctypes.data, p.ctypes.data
        _check(binding.character_library().sinew_character_add_clip(self.pointer, ctypes.byref(one)), self)

    def character(self) -> Character:
        """All of it as arrays; changes of them change nothing here."""
        return Character(self.positions, self.faces, self.skeleton, self.skin, self.clips(), self.name, self)

    # ---- jobs

    def simplify(self, *, low: bool = False, joint_count: int = 0, as_drawn: bool = False, keep: Sequence[str] = ()) -> Array:
        """Leaves joints out: bone ends, helpers, faces, twists; with `low` fingers and small parts too; or all but so many. Weights and motion follow.
        `as_drawn`: by the published conditions alone, which take limbs off.

        Returns [j before] the joint, of those before, that each is part of now.
        """
        options, _kept = filled(declarations.sinew_character_simplify_options, locals())
        into = np.zeros(max(self._view().joint_count, 1), np.uint32)
        _check(binding.character_library().sinew_character_simplify(self.pointer, ctypes.byref(options), into.ctypes.data), self)
        return into

    def lod(self, *, levels: int = 3, ratio: float = 0.5, fewer_joints: bool = False) -> List[Tuple["OpenCharacter", LodLevel]]:
        """Copies with fewer and fewer triangles, each with how far it is from this character: `sinew lod`."""
        if not 1 <= levels <= declarations.MAX_LOD_LEVELS:
            raise ValueError(f"levels: expected 1 to {declarations.MAX_LOD_LEVELS}, found {levels}")
        options, _kept = filled(declarations.sinew_character_lod_options, locals())
        handles, figures = (ctypes.c_void_p * levels)(), (declarations.sinew_character_lod_level * levels)()
        _check(binding.character_library().sinew_character_lod(self.pointer, ctypes.byref(options), handles, figures), self)
        return [(OpenCharacter(ctypes.c_void_p(handle)), result_as(one, {})) for handle, one in zip(handles, figures)]


def _files_of(source: Any, name: str, beside: Optional[Mapping[str, bytes]]) -> Tuple[Any, List[Any]]:
    """The files of a source of bytes, and what they point to."""
    if not name:
        raise ValueError("name: bytes need a file name, whose extension says what they are")
    listed = [(name, bytes(source)), *((n, bytes(b)) for n, b in (beside or {}).items())]
    files = (declarations.sinew_file * len(listed))()
    kept = [ctypes.create_string_buffer(content, max(len(content), 1)) for _, content in listed]
    for file, (one, content), buffer in zip(files, listed, kept):
        file.name, file.bytes, file.size_bytes = one.encode(), ctypes.addressof(buffer), len(content)
    return files, kept


def templates() -> List[str]:
    """Names of the skeletons that "template:NAME" knows."""
    return _words(binding.character_library().sinew_character_templates())


def _words(text: bytes) -> List[str]:
    return text.decode().split()


def _check(status: int, character: Optional[OpenCharacter]) -> None:
    if status != 0:
        raise binding.Error(error_line(character), status)


def _skeleton_view(skeleton: Skeleton) -> Any:
    """The library's view with names; it borrows the arrays."""
    flags = None if skeleton.ends is None else np.where(skeleton.ends, declarations.JOINT_NEVER, 0).astype(np.uint8)
    view = skeleton_view(skeleton, flags)
    view.kept = flags
    view.names = (ctypes.c_char_p * len(skeleton))(*[str(n).encode() for n in skeleton.names])
    return view


def _order(parents: Array) -> List[int]:
    order, left = [], list(range(len(parents)))
    done = {-1}
    while left:
        now = [j for j in left if int(parents[j]) in done]
        if not now:
            raise binding.Error("the clip's joints form a cycle")
        order += now
        done.update(now)
        left = [j for j in left if j not in done]
    return order


def _world(q: Array, p: Array, parents: Array) -> Tuple[Array, Array]:
    """Local poses [t, j, ...] in the world."""
    q, p = q.copy(), p.copy()
    for j in _order(parents):
        if parents[j] >= 0:
            p[:, j] = p[:, parents[j]] + turn(q[:, parents[j]], p[:, j])
            q[:, j] = multiply(q[:, parents[j]], q[:, j])
    return q, p


def _local(q: Array, p: Array, parents: Array) -> Tuple[Array, Array]:
    """Poses of the world against parents; joints behind those of `parents` are left out."""
    count = len(parents)
    out_q, out_p = q[:, :count].copy(), p[:, :count].copy()
    for j, parent in enumerate(parents):
        if parent >= 0:
            back = q[:, parent] * [-1, -1, -1, 1]
            out_q[:, j] = multiply(back, q[:, j])
            out_p[:, j] = turn(back, p[:, j] - p[:, parent])
    return out_q, out_p
