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
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Dict, Iterable, List, Literal, Mapping, Optional, Sequence, Tuple, Union, get_args

import numpy as np

from . import binding, declarations
from .arrays import Mesh, chosen, mask, real, whole
from .binder import UP, UP_AXES, ProgressFunction, UpAxis, answers_of, question_of, skeleton_view
from .character import Character, Clip, Question, Skeleton, Skin, multiply, skin_of, turn
from .rigger import FRONTS, FoundUp

Source = Union[str, os.PathLike, bytes]
ModelFile = Union[None, str, os.PathLike, bytes]
JointsFrom = declarations.JointsFrom
PoseDeform = declarations.PoseDeform
Correction = Literal["none", "volume", "xpbd", "delta-mush"]
MotionUp = declarations.Up
PlacesLayout = Literal["smpl24", "humanml3d22", "coco17", "mediapipe33"]


@dataclass
class Bound:
    """What bind() did. left_out: {joint: why it gets no weight}; hash: of the weights, as `sinew bind --json` has it."""

    hash: str
    left_out: Dict[str, str]
    kept_meshes: int
    folded_tips: int
    symmetric_vertices: int
    answers_by_style: int
    questions: List[Question] = field(default_factory=list)
    vertex_questions: Optional[np.ndarray] = None


@dataclass
class Finding:
    """Something that check() found: how severe ("note", "warning", "error"), one line of what and one of what to do; joint, other: -1 for none;
    vertices that it is about; value was measured, above `bound` it is a finding."""

    rule: str
    severity: declarations.CheckSeverity
    what: str
    cure: str
    joint: int
    other: int
    vertices: np.ndarray
    value: float
    bound: float


@dataclass
class Checked:
    """What check() says: errors first; "checked: 0 findings"; score 0 to 100, where it was asked for."""

    findings: List[Finding]
    line: str
    score: Optional[float] = None


@dataclass
class LevelOfDetail:
    """What lod() made: distances from the whole character at rest and in the worst of the bent poses, shares of its height."""

    triangles: int
    rest_error: float
    posed_error: float
    mean_error: float


@dataclass
class Rigged:
    """What rig() made. ends, confidence, parent_confidence: a value a joint; spread: how far off the votes think they are;
    front, up and how sure they are: as sinew.Rig has them; doubtful: limbs that may be wrong, most doubtful first, with how
    likely they are."""

    mirrored: bool
    matched: int
    spread: float
    scale: float
    ends: np.ndarray
    confidence: np.ndarray
    parent_confidence: np.ndarray
    front: Tuple[float, float, float] = (0.0, 0.0, 1.0)
    up: str = "y"
    front_certainty: float = 0.0
    up_certainty: float = 0.0
    doubtful: Tuple[Tuple[str, float], ...] = ()


@dataclass
class Picture:
    """What was found in a picture. width, height: its pixels; figure: of how many figures; body_class, view and how sure they are
    (0..1): "found" and 0 before rig(); outline: closed lines [k, 2] of the figure in pixels, x right, y down from the top left corner,
    the border first, then those of holes and smaller parts."""

    width: int
    height: int
    figure_count: int
    figure: int
    body_class: str
    view: str
    certainty: float
    outline: List[np.ndarray]


@dataclass
class FileMap:
    """sources: joint of the source for each of the target, -1 for none; text: the map as `sinew map -o` writes it."""

    sources: np.ndarray
    confidence: np.ndarray
    reasons: np.ndarray
    certainty: float
    method: str
    text: str


@dataclass
class Retargeted:
    """clips: numbers of those that were added, see OpenCharacter.clips(); sources: the map that was used."""

    clips: range
    mapped: int
    rigged: bool
    certainty: float
    mapped_by: str
    sources: np.ndarray


@dataclass
class Carried:
    """What transfer() did: shares of the weights that were carried over, and how far off the match was."""

    carried: float
    mismatch: float
    fitted: bool
    mapped_joints: int
    mapped_by: str


def open(source: Source, *, name: str = "", beside: Optional[Mapping[str, bytes]] = None) -> "OpenCharacter":  # noqa: A001
    """Opens a character: a mesh, a skeleton, motion, or all of them, of every format that the command reads.

    source  path of a file, or its bytes
    name    of the file, where bytes are given: its extension says what they are
    beside  {name: bytes} of what lies beside it (a .bin, textures, a .rig.txt), where bytes are given
    Returns an OpenCharacter. Raises Error, which names the file and says what is wrong with it.
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
                 mask_file: Union[None, str, os.PathLike] = None, outline: Optional[Sequence[Any]] = None, cut: bool = False) -> "OpenCharacter":
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
    library, handle = binding.character_library(), ctypes.c_void_p()
    options = binding.init(declarations.sinew_character_picture_options)
    options.body_class = chosen(body_class, declarations.BODY_CLASS, "body_class")
    options.figure, options.flat, options.pixels = figure, int(flat), chosen(units, ("figure", "pixels"), "units")
    options.cut = int(cut)
    options.mask = None if mask_file is None else os.fsencode(mask_file)
    lines = [real(line, (None, 2), "outline") for line in outline or ()]
    offsets = np.concatenate(([0], np.cumsum([len(line) for line in lines]))).astype(np.uint32)
    places = np.concatenate(lines) if lines else None
    options.line_count, options.line_offsets, options.outline = len(lines), offsets.ctypes.data, binding.address(places)
    if isinstance(source, (bytes, bytearray, memoryview)):
        files, _kept = _files_of(source, name, beside)
        _check(library.sinew_character_open_picture_files(files, len(files), ctypes.byref(options), ctypes.byref(handle)), None)
    else:
        _check(library.sinew_character_open_picture(os.fsencode(source), ctypes.byref(options), ctypes.byref(handle)), None)
    return OpenCharacter(handle)


def open_places(layout: PlacesLayout, places: Any) -> "OpenCharacter":
    """Places of a person's joints alone, as cameras and captures tell them, as a motion: its skeleton is learnt from these frames, which are its
    clip. places_frame() turns those that come into what RetargetStream.frame() takes, with this skeleton as the source.

    layout  which joints the places are
    places  [frames, 24 (smpl24), 22 (humanml3d22), 17 (coco17) or 33 (mediapipe33), 3], any unit; a second or two are best
    """
    handle = ctypes.c_void_p()
    rows = real(places, (None, None, 3), "places")
    _check(binding.character_library().sinew_character_open_places(layout.encode(), rows.ctypes.data, rows.shape[1], rows.shape[0], ctypes.byref(handle)), None)
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
    return binding.character_library().sinew_character_extensions(sum(known[u] for u in uses)).decode().split()


class OpenCharacter:
    """A character in the library. Any number may be worked on at the same time, each by one thread at a time.

    bind(), rig(), map(), retarget(), pose(), transfer(), simplify() and bake() are the commands of these names (retarget: animate), with
    their defaults. All of them raise ValueError for arguments, Error for what cannot be done and Cancelled, and what failed changed
    nothing. `progress` is called with the share that is done and returns True to stop; `threads` work, and the bytes are the same for
    any number.
    """

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

    def copy(self) -> "OpenCharacter":
        handle = ctypes.c_void_p()
        _check(binding.character_library().sinew_character_copy(self.pointer, ctypes.byref(handle)), self)
        return OpenCharacter(handle)

    # ---- files

    def save(self, path: Union[str, os.PathLike]) -> None:
        """Writes a file by its extension: .glb, .gltf, .vrm, .fbx, .obj, .rig.txt, .bvh. A glTF keeps all of its input that was not changed.
        A file that was there stays as it was, where this fails."""
        _check(binding.character_library().sinew_character_save(self.pointer, os.fsencode(path)), self)

    def write(self, name: str) -> Dict[str, bytes]:
        """{file name: bytes} of what save(name) would write, the file itself first."""
        files, count = ctypes.POINTER(declarations.sinew_file)(), ctypes.c_uint32()
        _check(binding.character_library().sinew_character_write(self.pointer, name.encode(), ctypes.byref(files), ctypes.byref(count)), self)
        return {files[i].name.decode(): ctypes.string_at(files[i].bytes, files[i].size_bytes) for i in range(count.value)}

    def set_profile(self, profile: Optional[str], *, authors: Sequence[str] = (), licence: str = "", title: str = "", keep_axes: bool = False,
                    controls: bool = False) -> None:
        """What save() and write() write from now on: a program or format that `sinew rig --for` lists, None for files as they were read.
        authors, licence and title are of a VRM; controls: a glTF says in its extras what controls() says. The rest pose stays: that is
        to_pose of bind and rig."""
        options = binding.init(declarations.sinew_character_profile_options)
        names = [author.encode() for author in authors]
        options.profile = profile.encode() if profile else None
        options.licence, options.title = licence.encode() or None, title.encode() or None
        options.authors = (ctypes.c_char_p * len(names))(*names) if names else None
        options.author_count, options.keep_axes, options.controls = len(names), int(keep_axes), int(controls)
        _check(binding.character_library().sinew_character_set_profile(self.pointer, ctypes.byref(options)), self)

    def controls(self) -> Dict[str, Any]:
        """Which joints controls of an animator move (formats/spec/controls.md): `sinew rig --controls`."""
        text = ctypes.c_char_p()
        _check(binding.character_library().sinew_character_controls(self.pointer, ctypes.byref(text)), self)
        return json.loads((text.value or b"").decode())

    def place(self, *, turns: Sequence[str] = (), height: float = 0, floor: bool = False, up: UpAxis = "y") -> None:
        """Turns the character as a whole by quarters ("x", "-x", "y", ...), scales it to a height in metres, puts it on the floor."""
        options = binding.init(declarations.sinew_character_place_options)
        options.turns = (ctypes.c_char_p * len(turns))(*[turn.encode() for turn in turns])
        options.turn_count, options.height, options.floor, options.up = len(turns), height, int(floor), UP_AXES[chosen(up, UP, "up")]
        _check(binding.character_library().sinew_character_place(self.pointer, ctypes.byref(options)), self)

    @property
    def notes(self) -> List[str]:
        """Remarks of the reader and of the jobs."""
        return binding.character_library().sinew_character_notes(self.pointer).decode(errors="replace").splitlines()

    @property
    def picture(self) -> Picture:
        """What was found in the picture that it is of. Raises Error where it is of none."""
        info = binding.init(declarations.sinew_character_picture_info)
        _check(binding.character_library().sinew_character_picture(self.pointer, ctypes.byref(info)), self)
        offsets = _array(info.line_offsets, np.uint32, (info.line_count + 1,))
        places = _array(info.outline, np.float32, (int(offsets[-1]), 2))
        return Picture(info.width, info.height, info.figure_count, info.figure, declarations.BODY_CLASS[info.body_class],
                       declarations.PICTURE_VIEW[info.view], info.certainty, [places[a:b] for a, b in zip(offsets[:-1], offsets[1:])])

    # ---- arrays

    def _view(self) -> Any:
        arrays = binding.init(declarations.sinew_character_arrays)
        _check(binding.character_library().sinew_character_view(self.pointer, ctypes.byref(arrays)), self)
        return arrays

    @property
    def name(self) -> str:
        return self._view().name.decode(errors="replace")

    @property
    def positions(self) -> np.ndarray:
        """[n, 3] float32 in the pose that the weights are meant for; a copy, as all arrays are."""
        view = self._view()
        return _array(view.positions, np.float32, (view.vertex_count, 3))

    @property
    def faces(self) -> Any:
        """[f, 3] uint32 where all are triangles, else a list of arrays [f, k], one for each number of corners."""
        view = self._view()
        offsets = _array(view.face_offsets, np.uint32, (view.face_count + 1,)) if view.face_offsets else np.zeros(1, np.uint32)
        corners = _array(view.face_vertices, np.uint32, (view.corner_count,))
        sizes = np.diff(offsets.astype(np.int64))
        kinds = np.unique(sizes)
        blocks = [corners[offsets[:-1][sizes == k][:, None].astype(np.int64) + np.arange(k)] for k in kinds]
        return np.zeros((0, 3), np.uint32) if not blocks else blocks[0] if len(blocks) == 1 and kinds[0] == 3 else blocks

    @property
    def skeleton(self) -> Optional[Skeleton]:
        view = self._view()
        if not view.joint_count:
            return None
        return Skeleton(_array(view.joint_positions, np.float32, (view.joint_count, 3)), _array(view.parents, np.int32, (view.joint_count,)),
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
        confidence = _array(view.confidence, np.uint8, (view.vertex_count,)) if view.confidence else None
        return Skin(joints, weights, confidence)

    @property
    def meshes(self) -> List[str]:
        """Names of the file's meshes; empty where it has none that are known."""
        view = self._view()
        return [view.mesh_names[m].decode(errors="replace") for m in range(view.mesh_count)]

    def joint_classes(self) -> np.ndarray:
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
        q = _array(one.rotations, np.float64, (frames, count, 4))
        p = _array(one.translations, np.float64, (frames, count, 3))
        parents = _array(one.parents, np.int32, (count,))
        name, fps = (one.name or b"").decode(errors="replace"), 1 / one.frame_time if one.frame_time > 0 else 30.0
        joints = len(skeleton)
        if not (count == joints and (parents == skeleton.parents).all()):  # nodes around the skeleton move as well
            q, p = _local(*_world(q, p, parents), skeleton.parents)
        return Clip(q[:, :joints], p[:, :joints], fps, name)

    def places_frame(self, places: Any) -> Tuple[np.ndarray, np.ndarray]:
        """Local rotations [j, 4] and translations [j, 3] of its joints in the frame of these places [n, 3], of open_places()."""
        row, count = real(places, (None, 3), "places"), self._view().joint_count
        rotations, translations = np.zeros((count, 4), np.float32), np.zeros((count, 3), np.float32)
        _check(binding.character_library().sinew_character_places_frame(self.pointer, row.ctypes.data, len(row), rotations.ctypes.data, translations.ctypes.data), self)
        return rotations, translations

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

    def bind(self, *, method: declarations.Method = "model", joints: JointsFrom = "auto", influences: int = 4, up: UpAxis = "y",
             deform: Optional[Iterable[Union[str, int]]] = None, never: Optional[Iterable[Union[str, int]]] = None,
             rigid_parts: declarations.RigidParts = "auto", softness: float = 1.0, surface_vertices: int = 0, keep_tips: bool = False,
             bind_props: bool = False, fit: bool = False, symmetric: bool = False, keep_confidence: bool = False, locked: Any = None,
             hints: Any = None, like: Optional["OpenCharacter"] = None, style: Union[None, str, os.PathLike] = None, cut: bool = False,
             to_pose: Union[None, str, os.PathLike] = None, questions: int = 0, answers: Sequence[Tuple] = (), model: ModelFile = None, threads: int = 1, progress: ProgressFunction = None) -> Bound:
        """Skin weights for the mesh.

        joints     where it is known from which joints may get weight: "own": those that have some, mesh by mesh; "names"; "all";
                   "auto": own where the file has weights, else names
        deform, never  joints, by name or number, that alone get weight, or none
        keep_tips  joints that only end a chain keep the weight they get
        bind_props meshes without a skin are bound too; else they stay attached to their joint
        fit        a skeleton in other units or beside the mesh is brought into it
        locked     mask [n] of bool or uint8, or indices: vertices that keep the weights they have
        hints      the same, and their weights steer the vertices around them; or an OpenCharacter with weights of some vertices
        like       a bound character whose weights are carried over where they fit
        style      a file of `sinew bind --save-style`
        cut        what has grown together is opened: vertices along it are doubled, the new ones come last
        to_pose    "t", "a" or a file whose skeleton stands so: the rest pose that the character is put into, cut before
        Other arguments are those of sinew.bind().
        """
        options = binding.init(declarations.sinew_character_bind_options)
        options.method, options.joints = chosen(method, declarations.METHOD, "method"), chosen(joints, declarations.JOINTS_FROM, "joints")
        options.influence_count, options.up = influences, UP_AXES[chosen(up, UP, "up")]
        options.rigid_parts = chosen(rigid_parts, declarations.RIGID_PARTS, "rigid_parts")
        options.softness_percent, options.surface_vertices = round(100 * softness), surface_vertices
        options.keep_tips, options.bind_props, options.fit, options.symmetric = int(keep_tips), int(bind_props), int(fit), int(symmetric)
        options.keep_confidence, options.question_count = int(keep_confidence), questions
        view, skeleton = self._view(), self.skeleton
        if skeleton is not None and (deform is not None or never is not None):
            flags = np.zeros(len(skeleton), np.uint8)
            for listed, flag, name in ((deform, declarations.JOINT_DEFORMS, "deform"), (never, declarations.JOINT_NEVER, "never")):
                for joint in listed if listed is not None else ():
                    flags[skeleton.index(joint, name)] |= flag
            options.joint_flags = flags.ctypes.data
        said = answers_of(answers, view.vertex_count, skeleton) if answers else None
        if said is not None:
            options.answers, options.answer_count = said, len(said)
        kept = mask(locked, view.vertex_count, "locked")
        steering = None if isinstance(hints, OpenCharacter) else mask(hints, view.vertex_count, "hints")
        options.locked, options.hinted = binding.address(kept), binding.address(steering)
        options.hints = hints.pointer if isinstance(hints, OpenCharacter) else None
        options.like = None if like is None else like.pointer
        options.style = None if style is None else os.fsencode(style)
        options.cut, options.to_pose = int(cut), None if to_pose is None else os.fsencode(to_pose)
        models = _Models(bind=model)
        result = binding.init(declarations.sinew_character_bind_result)
        self._job("bind", "sinew_character_bind", [], options, result, threads, progress, models)
        names = [] if skeleton is None else list(skeleton.names)
        left_out = _array(result.left_out, np.uint32, (result.left_out_count,))
        return Bound(result.hash.decode(), {names[j]: result.left_out_why[i].decode() for i, j in enumerate(left_out)}, result.kept_meshes,
                     result.folded_tips, result.symmetric_vertices, result.answers_by_style,
                     [question_of(result.questions[i]) for i in range(result.question_count)],
                     _array(result.vertex_questions, np.uint32, (view.vertex_count,)) if result.vertex_questions else None)

    def rig(self, *, method: declarations.CharacterRigMethod = "auto", detail: declarations.CharacterDetail = "body",
            mirror: declarations.Mirror = "auto", up: FoundUp = "auto", front: str = "auto", spine: int = 0, toes: bool = True,
            ends: bool = True, bind: bool = True,
            skeleton: Union[None, str, os.PathLike, "OpenCharacter"] = None, keep_lengths: bool = False,
            edits: Sequence[Tuple[declarations.EditKind, str]] = (), to_pose: Union[None, str, os.PathLike] = None,
            gate: bool = False, cut: bool = False, influences: int = 0, category: declarations.Category = "any", model: ModelFile = None,
            hands_model: ModelFile = None, front_model: ModelFile = None, threads: int = 1,
            progress: ProgressFunction = None) -> Rigged:
        """A skeleton for the mesh, and weights for it. A skeleton that the character has is left out.

        detail    "body": down to the hands; "hands": with fingers; "full": with eyes, a jaw and props
        skeleton  a file, "template:NAME" (see templates()) or an OpenCharacter whose skeleton is put into the mesh
        edits     ("move", "JOINT=X,Y,Z"), ("add", "NAME=PARENT:X,Y,Z"), ("remove", "JOINT"), ("parent", "JOINT=OTHER"),
                  ("rename", "JOINT=NAME"), ("at", "JOINT=X,Y,Z"): as move, and adds what was not found
        to_pose   "t", "a" or a file whose skeleton stands so: the rest pose that the character is put into
        gate      measure the result: what fails is a note that begins with "gate: "
        cut       what has grown together is opened: vertices along it are doubled; to_pose does so, too
        category  what kind of body it is, where the model takes it for another: which limbs are arms, legs, wings
        Other arguments are those of sinew.rig().
        """
        options = binding.init(declarations.sinew_character_rig_options)
        options.method = chosen(method, declarations.CHARACTER_RIG_METHOD, "method")
        options.detail, options.mirror = chosen(detail, declarations.CHARACTER_DETAIL, "detail"), chosen(mirror, declarations.MIRROR, "mirror")
        options.up, options.spine_count = declarations.UP.index(get_args(FoundUp)[chosen(up, get_args(FoundUp), "up")]), spine
        options.front = chosen(front, FRONTS, "front")
        options.no_toes, options.no_ends, options.no_bind = int(not toes), int(not ends), int(not bind)
        options.keep_lengths, options.influence_count, options.gate = int(keep_lengths), influences, int(gate)
        options.cut = int(cut)
        options.category = chosen(category, declarations.CATEGORY, "category")
        if to_pose is not None:
            options.to_pose = os.fsencode(to_pose)
        listed = (declarations.sinew_skeleton_edit * len(edits))()
        for one, (kind, text) in zip(listed, edits):
            one.kind, one.text = chosen(kind, declarations.EDIT_KIND, "edits"), text.encode()
        options.edits, options.edit_count = listed, len(edits)
        if isinstance(skeleton, OpenCharacter):
            options.skeleton_character = skeleton.pointer
        elif skeleton is not None:
            options.skeleton = os.fsencode(skeleton)
        result = binding.init(declarations.sinew_character_rig_result)
        self._job("rig", "sinew_character_rig", [], options, result, threads, progress,
                  _Models(**{"slots" if method == "slots" else "rig": model}, hands=hands_model, front=front_model))
        count = (result.joint_count,)
        return Rigged(bool(result.mirrored), result.matched, result.spread, result.scale,
                      _array(result.ends, np.uint8, count).astype(bool) if result.ends else np.zeros(count, bool),
                      *(_array(a, np.float32, count) if a else np.zeros(count, np.float32) for a in (result.confidence, result.parent_confidence)),
                      front=tuple(result.front), up=declarations.UP[result.up], front_certainty=result.front_confidence,
                      up_certainty=result.up_confidence,
                      doubtful=tuple((one.name.decode(), one.doubt) for one in result.doubtful[:result.doubtful_count]))

    def map(self, source: Union[str, os.PathLike, "OpenCharacter"], *, method: declarations.MapMethod = "auto", names: bool = True,
            ends: bool = True, first: declarations.BranchesFirst = "both", cost: declarations.BranchesCost = "mean",
            target_up: MotionUp = "auto", source_up: MotionUp = "auto", guess_up: bool = False,
            pins: Union[None, str, os.PathLike, Mapping[Union[str, int], Union[str, int, None]]] = None,
            layout: Optional[str] = None, actor: Union[None, str, int] = None) -> FileMap:
        """Which joint of the source (a file, "template:NAME", an OpenCharacter) stands for which of this character. Changes neither.

        pins  {target joint: source joint or None}, by name or number, or a map file whose lines are kept
        first, cost  of method "branches": whose branches choose, and what two branches cost
        target_up, source_up  "auto": along the legs of a body that has two, else y; and as the target's
        layout, actor  of the source, as in retarget()
        """
        options = binding.init(declarations.sinew_character_map_options)
        options.method, options.no_names, options.no_ends = chosen(method, declarations.MAP_METHOD, "method"), int(not names), int(not ends)
        options.target_up, options.source_up = chosen(target_up, declarations.UP, "target_up"), chosen(source_up, declarations.UP, "source_up")
        options.guess_up = int(guess_up)
        options.layout = None if layout is None else layout.encode()
        options.actor = None if actor is None else str(actor).encode()
        options.branches_first = chosen(first, declarations.BRANCHES_FIRST, "first")
        options.branches_cost = chosen(cost, declarations.BRANCHES_COST, "cost")
        if isinstance(pins, Mapping):
            target, of = self.skeleton, source.skeleton if isinstance(source, OpenCharacter) else None
            if target is None:
                raise ValueError("pins: this character has no joints")
            listed = (declarations.sinew_map_pin * len(pins))()
            for one, (to, joint) in zip(listed, pins.items()):
                if isinstance(joint, str) and of is None:
                    raise ValueError("pins: joints of a file's skeleton are given by number; open() the file to give names")
                one.target = target.index(to, "pins")
                one.source = -1 if joint is None else of.index(joint, "pins") if of is not None else int(joint)  # type: ignore[arg-type]
            options.pins, options.pin_count = listed, len(listed)
        elif pins is not None:
            options.pins_file = os.fsencode(pins)
        result = binding.init(declarations.sinew_character_map_result)
        library = binding.character_library()
        if isinstance(source, OpenCharacter):
            status = library.sinew_character_map(self.pointer, source.pointer, ctypes.byref(options), ctypes.byref(result))
        else:
            status = library.sinew_character_map_file(self.pointer, os.fsencode(source), ctypes.byref(options), ctypes.byref(result))
        _check(status, self)
        count = (result.joint_count,)
        return FileMap(_array(result.sources, np.int32, count), _array(result.confidence, np.float32, count),
                       _array(result.reasons, np.uint8, count), result.certainty, declarations.MAP_METHOD[result.method], result.text.decode())

    def retarget(self, motion: Optional["OpenCharacter"] = None, *, method: declarations.AnimateMethod = "auto", in_place: bool = False,
                 natural_range: bool = True, target_up: MotionUp = "auto", motion_up: MotionUp = "auto", correct: Correction = "none",
                 cells: int = 0, rounds: int = 0, body_contact: bool = False, stiffness: float = 0, tet_weights: declarations.TetWeights = "skin",
                 smoothing: bool = True, shapes: int = 0, fps: float = 0, start: float = 0, end: float = 0,
                 clip: Union[None, str, int] = None, map_file: Union[None, str, os.PathLike] = None, joint_map: Any = None,
                 force: bool = False, translations: bool = False, layout: Optional[str] = None, actor: Union[None, str, int] = None,
                 limits: Union[None, str, os.PathLike] = None, depth: bool = False, threads: int = 1,
                 progress: ProgressFunction = None) -> Retargeted:
        """Adds clips of another skeleton. A bare mesh is rigged first.

        motion         None: a clip of its class that ships, for a character of a picture alone
        natural_range  knees and elbows stay in theirs
        correct        every frame is corrected by morph targets, at most `shapes` a clip
        stiffness, tet_weights, smoothing  of the correction "xpbd": of its springs, 0 = 0.2; where its tetrahedra have weights from; of bends
        start, end     seconds of the motion; end 0: to its end
        clip           by name or number; None: all
        map_file, joint_map  a file of `sinew map`, or [j] integers of the motion's joints, -1 for none; else the map is found
        translations   bones stretch as the motion's do
        force          plays a motion that does not fit, such as a person's on a horse; else an error
        layout         which joints places alone are (.npy, .npz): "smpl24", "humanml3d22", "coco17", "mediapipe33"; None: guessed by their count
        actor          of a file of several people, by the root's name or number; None: the first where all are alike
        limits         what joints stay within: a .urdf, a file of limits (formats/spec/limits.md), or "human"; None: nothing but the natural range
        depth          bones of a picture's character leave its plane as the motion's do
        """
        options = binding.init(declarations.sinew_character_animate_options)
        options.method, options.in_place, options.no_range = chosen(method, declarations.ANIMATE_METHOD, "method"), int(in_place), int(not natural_range)
        options.target_up, options.motion_up = chosen(target_up, declarations.UP, "target_up"), chosen(motion_up, declarations.UP, "motion_up")
        options.deform = _correction(correct, "correct")
        options.cells, options.rounds, options.body_contact, options.shapes = cells, rounds, int(body_contact), shapes
        _set_springs(options, stiffness, tet_weights, smoothing)
        options.fps, options.to = fps, end
        setattr(options, "from", start)  # a word of Python
        options.force, options.translations, options.depth = int(force), int(translations), int(depth)
        options.clip = None if clip is None else str(clip).encode()
        options.layout = None if layout is None else layout.encode()
        options.actor = None if actor is None else str(actor).encode()
        options.limits = None if limits is None else os.fsencode(limits)
        options.map = None if map_file is None else os.fsencode(map_file)
        if motion is None and joint_map is not None:
            raise ValueError("joint_map: is of a motion's joints, and there is no motion")
        given = None if motion is None or joint_map is None else whole(joint_map, (self._view().joint_count,), "joint_map", np.int32, -1, motion._view().joint_count)
        options.sources = binding.address(given)
        result = binding.init(declarations.sinew_character_animate_result)
        self._job("retarget", "sinew_character_animate", [None if motion is None else motion.pointer], options, result, threads, progress, _Models())
        count = self._view().joint_count
        return Retargeted(range(result.first_clip, result.first_clip + result.clip_count), result.mapped, bool(result.rigged), result.certainty,
                          (result.mapped_by or b"").decode(), _array(result.sources, np.int32, (count,)) if result.sources else np.zeros(0, np.int32))

    def pose(self, *, angles: Any = None, rotations: Any = None, matrices: Any = None, clip: Union[None, str, int] = None, time: float = 0,
             method: PoseDeform = "linear", cells: int = 0, rounds: int = 0, body_contact: bool = False, stiffness: float = 0,
             tet_weights: declarations.TetWeights = "skin", smoothing: bool = True, threads: int = 1) -> "OpenCharacter":
        """A copy in a pose, to save as .obj or to take positions of. One of four says it:

        angles     [j, 3] joints turned about x, then y, then z, degrees
        rotations  [j, 4] x y z w, local, against the rest pose
        matrices   [j, 3, 4] or [j, 4, 4], rest to posed space
        clip       of the character's own, by name or number, at `time` seconds
        stiffness, tet_weights, smoothing  of method "xpbd", as in retarget()
        """
        options = binding.init(declarations.sinew_character_pose_options)
        options.thread_count, options.deform = threads, chosen(method, declarations.POSE_DEFORM, "method")
        options.cells, options.rounds, options.body_contact, options.time = cells, rounds, int(body_contact), time
        _set_springs(options, stiffness, tet_weights, smoothing)
        count, kept = self._view().joint_count, []
        if matrices is not None and np.shape(matrices)[1:] == (4, 4):
            matrices = np.asarray(matrices)[:, :3]
        for name, value, shape in (("angles", angles, (count, 3)), ("rotations", rotations, (count, 4)), ("matrices", matrices, (count, 3, 4))):
            if value is not None:
                real(value, shape, name)
                kept.append(np.ascontiguousarray(value, np.float64))
                setattr(options, name, kept[-1].ctypes.data)
        options.clip = None if clip is None else str(clip).encode()
        if len(kept) + (clip is not None) != 1:
            raise ValueError("pose: expected one of angles, rotations, matrices and clip")
        handle = ctypes.c_void_p()
        _check(binding.character_library().sinew_character_pose(self.pointer, ctypes.byref(options), ctypes.byref(handle)), self)
        return OpenCharacter(handle)

    def transfer(self, source: "OpenCharacter", *, method: declarations.TransferMethod = "auto", influences: int = 4, up: UpAxis = "y",
                 source_up: UpAxis = "y", garment: bool = False, heat: bool = False, locked: Any = None, pairs: Sequence[Tuple[int, int]] = (),
                 map_file: Union[None, str, os.PathLike] = None, model: ModelFile = None, threads: int = 1,
                 progress: ProgressFunction = None) -> Carried:
        """Weights of a bound character for this mesh, which keeps its skeleton or gets the source's, fitted. Arguments as sinew.transfer()."""
        options = binding.init(declarations.sinew_character_transfer_options)
        options.method, options.influence_count = chosen(method, declarations.TRANSFER_METHOD, "method"), influences
        options.target_up, options.source_up = UP_AXES[chosen(up, UP, "up")], UP_AXES[chosen(source_up, UP, "source_up")]
        options.garment, options.heat, options.pair_count = int(garment), int(heat), len(pairs)
        options.pairs = (declarations.sinew_vertex_pair * len(pairs))(*[declarations.sinew_vertex_pair(int(s), int(t)) for s, t in pairs])
        kept = mask(locked, self._view().vertex_count, "locked")
        options.locked, options.map = binding.address(kept), None if map_file is None else os.fsencode(map_file)
        result = binding.init(declarations.sinew_character_transfer_result)
        self._job("transfer", "sinew_character_transfer", [source.pointer, self.pointer], options, result, threads, progress, _Models(bind=model), own=False)
        return Carried(result.carried, result.mismatch, bool(result.fitted), result.mapped_joints, (result.mapped_by or b"").decode())

    def simplify(self, *, low: bool = False, joint_count: int = 0, keep: Sequence[str] = ()) -> np.ndarray:
        """Leaves joints out: bone ends, helpers, faces, twists; with `low` fingers and small parts too; or all but so many. Weights and motion follow.

        Returns [j before] the joint, of those before, that each is part of now.
        """
        options = binding.init(declarations.sinew_character_simplify_options)
        options.low, options.joint_count, options.keep_count = int(low), joint_count, len(keep)
        options.keep = (ctypes.c_char_p * len(keep))(*[k.encode() for k in keep])
        into = np.zeros(max(self._view().joint_count, 1), np.uint32)
        _check(binding.character_library().sinew_character_simplify(self.pointer, ctypes.byref(options), into.ctypes.data), self)
        return into

    def lod(self, *, levels: int = 3, ratio: float = 0.5, fewer_joints: bool = False) -> List[Tuple["OpenCharacter", LevelOfDetail]]:
        """Copies with fewer and fewer triangles, each with how far it is from this character: `sinew lod`."""
        options = binding.init(declarations.sinew_character_lod_options)
        if not 1 <= levels <= declarations.MAX_LOD_LEVELS:
            raise ValueError(f"levels: expected 1 to {declarations.MAX_LOD_LEVELS}, found {levels}")
        options.level_count, options.ratio, options.fewer_joints = levels, ratio, int(fewer_joints)
        handles, figures = (ctypes.c_void_p * levels)(), (declarations.sinew_character_lod_level * levels)()
        _check(binding.character_library().sinew_character_lod(self.pointer, ctypes.byref(options), handles, figures), self)
        return [(OpenCharacter(ctypes.c_void_p(handle)), LevelOfDetail(f.triangle_count, f.rest_error, f.posed_error, f.mean_error))
                for handle, f in zip(handles, figures)]

    def check(self, *, poses: bool = True, clips: bool = True, score: bool = False, bounds: Optional[Mapping[str, float]] = None) -> Checked:
        """What is wrong with the skeleton, the weights and the animations: `sinew check`. Changes nothing.

        poses, clips  whether the mesh is bent in test poses, whether animations are looked at
        score         also how near the weights are to those of three methods
        bounds        {rule: above which it is a finding}, in place of the library's
        """
        options, result = binding.init(declarations.sinew_character_check_options), binding.init(declarations.sinew_character_check_result)
        options.no_poses, options.no_clips, options.score = int(not poses), int(not clips), int(score)
        said = dict(bounds or {})
        options.bound_count = len(said)
        options.bound_rules = (ctypes.c_char_p * len(said))(*[rule.encode() for rule in said])
        kept = np.array(list(said.values()), np.float64)
        options.bounds = binding.address(kept) if said else None
        _check(binding.character_library().sinew_character_check(self.pointer, ctypes.byref(options), ctypes.byref(result)), self)
        findings = [Finding(f.rule.decode(), declarations.CHECK_SEVERITY[f.severity], f.what.decode(errors="replace"), f.cure.decode(), f.joint, f.other,
                            _array(f.vertices, np.uint32, (f.vertex_count,)), f.value, f.bound) for f in (result.findings[i] for i in range(result.finding_count))]
        return Checked(findings, result.line.decode(), result.score if score else None)

    def bake(self, *, method: Literal["volume", "xpbd", "delta-mush"] = "volume", cells: int = 0, rounds: int = 0, body_contact: bool = False,
             stiffness: float = 0, tet_weights: declarations.TetWeights = "skin", smoothing: bool = True, poses: int = 0,
             shapes: int = 0, seed: int = 0, limit: float = 0, clip: Union[None, str, int] = None,
             progress: ProgressFunction = None) -> Tuple[float, float]:
        """Morph targets that correct bends, with what drives them; they are saved with the character.

        stiffness, tet_weights, smoothing  of method "xpbd", as in retarget()
        Returns the errors of linear blending and of the baked shapes in poses that were not learnt, shares of the size.
        """
        options = binding.init(declarations.sinew_character_bake_options)
        options.deform = _correction(method, "method")
        options.cells, options.rounds, options.body_contact = cells, rounds, int(body_contact)
        _set_springs(options, stiffness, tet_weights, smoothing)
        options.poses, options.shapes, options.seed, options.limit = poses, shapes, seed, limit
        options.clip = None if clip is None else str(clip).encode()
        result = binding.init(declarations.sinew_character_bake_result)
        self._job("bake", "sinew_character_bake", [], options, result, None, progress, None)
        return result.held_out_linear_error, result.held_out_baked_error

    def _job(self, what: str, call: str, between: List[Any], options: Any, result: Any, threads: Optional[int], progress: ProgressFunction,
             models: Optional["_Models"], own: bool = True) -> None:
        """A call with progress, threads and models."""
        if threads is not None:
            if not 1 <= threads <= declarations.MAX_THREADS:
                raise ValueError(f"threads: expected 1 to {declarations.MAX_THREADS}, found {threads}")
            options.thread_count = threads
        if models is not None and models.any:
            options.models = ctypes.pointer(models.struct)
        function = getattr(binding.character_library(), call)
        with binding.Progress(progress) as report:
            options.progress = report.callback
            status = function(*([self.pointer] if own else []), *between, ctypes.byref(options), ctypes.byref(result))
            line = _line(self) if status else ""
        report.finish(status, what, line)


class _Models:
    """Models in place of the bundled ones."""

    def __init__(self, **files: ModelFile) -> None:
        self.struct = binding.init(declarations.sinew_character_models)
        self._kept = []
        for name, file in files.items():
            if file is None:
                continue
            try:
                content = file if isinstance(file, bytes) else Path(file).read_bytes()
            except OSError as error:
                raise binding.Error(f"{os.fspath(file)!s}: cannot read the model, {error.strerror}") from None
            aligned = np.zeros(-(-max(len(content), 1) // 8), np.uint64)
            aligned.view(np.uint8)[:len(content)] = np.frombuffer(content, np.uint8)
            self._kept.append(aligned)
            setattr(self.struct, name, aligned.ctypes.data)
            setattr(self.struct, name + "_size", len(content))
        self.any = bool(self._kept)


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


def _set_springs(options: Any, stiffness: float, tet_weights: declarations.TetWeights, smoothing: bool) -> None:
    """What the published correction alone takes."""
    options.stiffness, options.no_smoothing = stiffness, int(not smoothing)
    options.tet_weights = chosen(tet_weights, declarations.TET_WEIGHTS, "tet_weights")


def templates() -> List[str]:
    """Names of the skeletons that "template:NAME" knows."""
    return binding.character_library().sinew_character_templates().decode().split()


def _line(character: Optional[OpenCharacter]) -> str:
    pointer = None if character is None else character.pointer
    return binding.character_library().sinew_character_error(pointer).decode(errors="replace")


def _check(status: int, character: Optional[OpenCharacter]) -> None:
    if status != 0:
        raise binding.Error(_line(character), status)


def _array(address: Any, dtype: Any, shape: Tuple[int, ...]) -> np.ndarray:
    """A copy of an array of the library."""
    size = int(np.prod(shape)) * np.dtype(dtype).itemsize
    if not size or not address:
        return np.zeros(shape, dtype)
    return np.frombuffer(ctypes.string_at(address, size), dtype).reshape(shape).copy()


def _skeleton_view(skeleton: Skeleton) -> Any:
    """The library's view with names; it borrows the arrays."""
    flags = None if skeleton.ends is None else np.where(skeleton.ends, declarations.JOINT_NEVER, 0).astype(np.uint8)
    view = skeleton_view(skeleton, flags)
    view.kept = flags
    view.names = (ctypes.c_char_p * len(skeleton))(*[str(n).encode() for n in skeleton.names])
    return view


def _correction(word: str, name: str) -> int:
    words = [w if w not in ("linear", "dual-quaternion") else "" for w in declarations.POSE_DEFORM]
    words[0] = "none"
    return chosen(word, words, name)


def _order(parents: np.ndarray) -> List[int]:
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


def _world(q: np.ndarray, p: np.ndarray, parents: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Local poses [t, j, ...] in the world."""
    q, p = q.copy(), p.copy()
    for j in _order(parents):
        if parents[j] >= 0:
            p[:, j] = p[:, parents[j]] + turn(q[:, parents[j]], p[:, j])
            q[:, j] = multiply(q[:, parents[j]], q[:, j])
    return q, p


def _local(q: np.ndarray, p: np.ndarray, parents: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Poses of the world against parents; joints behind those of `parents` are left out."""
    count = len(parents)
    out_q, out_p = q[:, :count].copy(), p[:, :count].copy()
    for j, parent in enumerate(parents):
        if parent >= 0:
            back = q[:, parent] * [-1, -1, -1, 1]
            out_q[:, j] = multiply(back, q[:, j])
            out_p[:, j] = turn(back, p[:, j] - p[:, parent])
    return out_q, out_p
