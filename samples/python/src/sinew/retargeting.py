# SPDX-License-Identifier: MIT
"""retarget(): motion of one skeleton on another; RetargetStream: streaming, frame by frame."""
from __future__ import annotations

import ctypes
from typing import Any, Literal, Optional, Union, get_args

import numpy as np

from . import binding, declarations
from .arrays import Mesh, chosen, whole
from .binding import Array
from .binder import ProgressFunction, skeleton_view
from .character import Character, Clip, Skeleton
from .mapping import JointMap, map as map_joints, view_with_names

RetargetMethod = Literal["auto", "copy", "contacts"]
RETARGET_METHODS = get_args(RetargetMethod)


def joint_classes(skeleton: Skeleton, up: declarations.Up = "y", source: Optional[Skeleton] = None, sources: Any = None) -> Array:
    """[j] uint8 of CLASSES: the skeleton's own, else derived by the library from its names, the names of its joints' sources, or its shape;
    "other" if unknown.

    source, sources  a skeleton and [j] its joints that match these, -1 for none
    """
    if skeleton.classes is not None:
        return skeleton.classes
    view, of = view_with_names(skeleton, True, up, "up"), None if source is None else view_with_names(source, True, "auto", "up")
    given = None if source is None else whole(sources, (len(skeleton),), "sources", np.int32, -1, len(source))
    classes = np.zeros(len(skeleton), np.uint8)
    block = binding.block("sinew_limb_classes_workspace_size", "joint_classes", len(skeleton), 0 if source is None else len(source))
    binding.check(binding.library().sinew_limb_classes(ctypes.byref(view), None if of is None else ctypes.byref(of), binding.address(given),
                                                       block.address, block.size_bytes, binding.address(classes)), "joint_classes")
    return classes


def retarget(clip: Clip, source: Skeleton, target: Skeleton, *, joint_map: Union[None, JointMap, Array] = None,
             method: RetargetMethod = "auto", in_place: bool = False, scale: float = 0.0, source_up: declarations.Up = "auto", target_up: declarations.Up = "auto",
             source_body: Optional[Character] = None, target_body: Optional[Character] = None, arm_spread: float = 0.0,
             progress: ProgressFunction = None) -> Clip:
    """Plays a clip of the source on the target. The same bytes on every machine.

    clip         poses of the source's joints
    joint_map    result of map(), or [target j] indices of the source's joints, -1 for none; None: calls map()
    method       "copy": joints rotate like their sources; "contacts": then planted feet stay in place and hands keep contacts;
                 "auto": contacts with a target_body, else copy
    in_place     the target stays above its rest position
    scale        target length per source length; 0: from the legs
    source_up, target_up  "x", "y", "z", or "auto": away from where the legs point
    target_body  the bound mesh of the target, for contacts of feet; with a source_body of the same vertices also of hands
    arm_spread   degrees, -90 to 90, by which both arms are lifted away from the body, or brought nearer if below 0
    progress     called with the share of the work that is done; returns True to stop
    Returns a Clip of the target's joints. Raises ValueError, Error and Cancelled.
    """
    if clip.rotations.shape[1] != len(source):
        raise ValueError(f"clip.rotations: expected {len(source)} joints as the source has, found {clip.rotations.shape[1]}")
    contacts = chosen(method, RETARGET_METHODS, "method") == 2 or (method == "auto" and target_body is not None)
    if contacts and target_body is None:
        raise ValueError("target_body: method='contacts' needs the bound mesh of the target")
    sources, classes, views, options = _pair(source, target, joint_map, in_place, scale, arm_spread, source_up, target_up)
    library = binding.library()
    memory = binding.block("sinew_retarget_create_workspace_size", "retarget", len(source), len(target))
    plan = ctypes.c_void_p()
    binding.check(library.sinew_retarget_create(ctypes.byref(views[0]), ctypes.byref(views[1]), binding.address(sources),
                                                binding.address(classes), ctypes.byref(options), memory.address,
                                                memory.size_bytes, ctypes.byref(plan)), "retarget")
    frames = len(clip.rotations)
    heights = np.zeros(frames, np.float32)
    value = ctypes.c_float()
    for f in range(frames):
        binding.check(library.sinew_retarget_height(plan, clip.rotations[f].ctypes.data, clip.translations[f].ctypes.data,
                                                    ctypes.byref(value)), "retarget")
        heights[f] = value.value
    binding.check(library.sinew_retarget_ground(plan, heights.ctypes.data, frames, ctypes.byref(value)), "retarget")
    ground = value.value
    out = Clip(np.zeros((frames, len(target), 4), np.float32), np.zeros((frames, len(target), 3), np.float32), clip.fps, clip.name)
    for f in range(frames):
        if progress is not None and progress((0.5 if contacts else 1.0) * f / frames):
            raise binding.Cancelled("retarget: the progress function asked to stop")
        binding.check(library.sinew_retarget_frame(plan, clip.rotations[f].ctypes.data, clip.translations[f].ctypes.data, ground,
                                                   out.rotations[f].ctypes.data, out.translations[f].ctypes.data), "retarget")
    if contacts and target_body is not None:
        half = None if progress is None else (lambda share: progress(0.5 + share / 2))
        _keep_contacts(plan, clip, out, ground, source_body, target_body, half)
    return out


def _pair(source: Skeleton, target: Skeleton, joint_map: Any, in_place: bool, scale: float, arm_spread: float,
          source_up: declarations.Up, target_up: declarations.Up) -> Any:
    """What a plan is made of: sources, classes, views of the two skeletons, options."""
    if joint_map is None:
        joint_map = map_joints(target, source, target_up=target_up, source_up=source_up)
    sources = joint_map.sources if isinstance(joint_map, JointMap) else joint_map
    sources = whole(sources, (len(target),), "joint_map", np.int32, -1, len(source))
    options = binding.init(binding.sinew_retarget_options)
    options.in_place, options.scale, options.arm_spread = int(bool(in_place)), scale, arm_spread
    views = [skeleton_view(source, None, chosen(source_up, declarations.UP, "source_up")),
             skeleton_view(target, None, chosen(target_up, declarations.UP, "target_up"))]
    for one, of in zip(views, (source, target)):
        one.rotations = binding.address(of.rotations)
    return sources, joint_classes(target, target_up, source, sources), views, options


class RetargetStream:
    """Streaming retargeting: a frame of the source in, a frame of the target out, without delay. The same bytes on every machine.

    source .. target_up  as in retarget()
    target_body  the bound mesh of the target, for contacts of its skin with the floor and hands; None: its joints
    source_body  the bound mesh of the source, with the same vertices, for contacts of hands with the body
    fps          frames per second
    ground       height of a standing ankle of the source; None: the source's own at rest
    contacts     False: no contacts with the floor or the body
    keep_range   False: knees and elbows may leave their natural range
    arm_spread   as in retarget()
    """

    def __init__(self, source: Skeleton, target: Skeleton, *, joint_map: Union[None, JointMap, Array] = None, in_place: bool = False,
                 scale: float = 0.0, source_up: declarations.Up = "auto", target_up: declarations.Up = "auto",
                 target_body: Optional[Character] = None, source_body: Optional[Character] = None, fps: float = 30.0, ground: Optional[float] = None, contacts: bool = True,
                 keep_range: bool = True, arm_spread: float = 0.0) -> None:
        sources, classes, views, plan_options = _pair(source, target, joint_map, in_place, scale, arm_spread, source_up, target_up)
        options = binding.init(binding.sinew_retarget_stream_options)
        options.fps, options.has_ground, options.ground = fps, int(ground is not None), ground or 0.0
        options.without = (0 if contacts else declarations.WITHOUT_CONTACTS) | (0 if keep_range else declarations.WITHOUT_RANGE)
        body = None if target_body is None else _body_view(target_body, "target_body")
        moving = None if source_body is None else _body_view(source_body, "source_body")
        if moving is not None:
            _check_source_body(moving, body)
            options.source = ctypes.pointer(moving)
        memory = binding.block("sinew_retarget_stream_workspace_size", "retarget", len(source), len(target),
                               *((0, 0) if body is None else (body.vertex_count, body.triangle_count)))
        self._counts, self._kept, self._stream = (len(source), len(target)), (memory, body, moving), ctypes.c_void_p()
        binding.check(binding.library().sinew_retarget_stream_create(
            ctypes.byref(views[0]), ctypes.byref(views[1]), binding.address(sources), binding.address(classes), ctypes.byref(plan_options),
            None if body is None else ctypes.byref(body), ctypes.byref(options), memory.address, memory.size_bytes,
            ctypes.byref(self._stream)), "retarget")

    def frame(self, rotations: Any, translations: Any) -> Any:
        """The next frame: local rotations [source j, 4] and translations [source j, 3]. Returns those of the target."""
        given = [np.ascontiguousarray(array, np.float32) for array in (rotations, translations)]
        for array, name, width in zip(given, ("rotations", "translations"), (4, 3)):
            if array.shape != (self._counts[0], width):
                raise ValueError(f"{name}: expected [{self._counts[0]}, {width}] numbers, found {list(array.shape)}")
        made = [np.zeros((self._counts[1], width), np.float32) for width in (4, 3)]
        binding.check(binding.library().sinew_retarget_stream_frame(self._stream, *(binding.address(array) for array in given + made)),
                      "retarget")
        return made[0], made[1]

    def restart(self) -> None:
        """Resets the stream: the next frame is its first."""
        binding.check(binding.library().sinew_retarget_stream_restart(self._stream), "retarget")


def _body_view(body: Character, name: str) -> Any:
    if body.skin is None:
        raise ValueError(f"{name}: has no skin; bind it first")
    skin = body.skin.rounded(body.skin.joints.shape[1])
    mesh = Mesh(body.positions, body.faces, name + ".")
    triangles = mesh.triangles()
    rows = binding.sinew_skin(binding.address(skin.joints), binding.address(skin.weights), skin.joints.shape[1])
    view = binding.sinew_motion_body(binding.address(mesh.positions), binding.address(triangles), rows, len(mesh.positions), len(triangles))
    view.kept = (mesh, skin, triangles)  # the view borrows them
    return view


def _check_source_body(source: Any, target: Any) -> None:
    if target is None:
        raise ValueError("source_body: needs a target_body of the same vertices")
    if source.vertex_count != target.vertex_count:
        raise ValueError(f"source_body: expected {target.vertex_count} vertices as target_body has, found {source.vertex_count}")


def _keep_contacts(plan: ctypes.c_void_p, clip: Clip, out: Clip, ground: float, source_body: Optional[Character],
                   target_body: Character, progress: ProgressFunction) -> None:
    library = binding.library()
    target = _body_view(target_body, "target_body")
    source = None if source_body is None else _body_view(source_body, "source_body")
    if source is not None:
        _check_source_body(source, target)
    options = binding.init(binding.sinew_contact_options)
    options.fps = clip.fps
    whole_clip = binding.sinew_motion_clip(binding.address(clip.rotations), binding.address(clip.translations),
                                           binding.address(out.rotations), binding.address(out.translations),
                                           len(clip.rotations), ground)
    block = binding.block("sinew_retarget_contacts_workspace_size", "retarget", plan, ctypes.byref(target), len(clip.rotations))
    with binding.Progress(progress) as report:
        options.progress = report.callback
        status = library.sinew_retarget_contacts(plan, None if source is None else ctypes.byref(source), ctypes.byref(target),
                                                 ctypes.byref(whole_clip), ctypes.byref(options), block.address, block.size_bytes)
    report.finish(status, "retarget")
