# SPDX-License-Identifier: MIT
"""rig(): a skeleton for a bare mesh."""
from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import Any, Dict, Literal, Tuple, Union, get_args

import numpy as np

from . import binding, declarations
from .arrays import Mesh, chosen
from .binding import Array
from .binder import ProgressFunction
from .character import Skeleton
from .models import Model, model_for

RIG_METHODS, MIRRORS = declarations.RIG_METHOD, declarations.MIRROR
FoundUp = Literal["auto", "y", "z"]
FRONTS = ("auto", "+z", "-z", "+x", "-x", "+y", "-y")  # in the order of sinew_front


@dataclass
class Rig:
    """A predicted skeleton with its confidence.

    confidence, parent_confidence  [j] float32, 0 to 1: of the joint's position, of its parent
    partners       [j] int32, the joint's mirror image, itself on the plane, -1 where nothing is mirrored
    mirrored       whether the skeleton is its own mirror image
    facing         axis nearest to the front: 0 = +z, 1 = +x, 2 = -z, 3 = -x
    plane          where the mirror plane is, across x for 0 and 2, else across z
    front, up      front as a unit vector in the mesh's axes, and the up axis
    front_certainty, up_certainty  0 to 1: uncertain below 0.7
    spread         estimated error of the votes: below 0.03 is good, above 0.09 method="shape" is as good
    """

    skeleton: Skeleton
    confidence: Array
    parent_confidence: Array
    partners: Array
    mirrored: bool
    facing: int
    plane: float
    spread: float
    front: Tuple[float, float, float] = (0.0, 0.0, 1.0)
    up: str = "y"
    front_certainty: float = 0.0
    up_certainty: float = 0.0


def rig(positions: Any, faces: Any, *, method: declarations.RigMethod = "votes", model: Union[None, str, Model] = None, up: FoundUp = "auto",
        front: str = "auto", front_model: Union[None, str, Model] = None,
        mirror: declarations.Mirror = "auto", spine: int = 0, toes: bool = True, ends: bool = True, fingers: bool = False,
        face: bool = False, props: bool = False, hands_model: Union[None, str, Model] = None, progress: ProgressFunction = None) -> Rig:
    """Predicts a skeleton for a mesh. The same bytes on every machine; bind() takes its `skeleton` as it is.

    positions    [n, 3] any unit
    faces        as bind() takes them; None: uses only the vertices
    method       "votes": by the model; "shape": medial axis of the mesh, without a model; "regions": for comparison
    model        file or Model of skeletons; None: the bundled one
    up           axis that points up, "y" or "z"; "auto": found
    front        direction that the mesh faces, "+z", "-z", "+x", "-x", "+y" or "-y"; "auto": found, at any angle
    front_model  file or Model of fronts; None: the bundled one
    mirror       "auto": if the mesh is symmetric; "always", "never"
    spine        1 to 16 joints between pelvis and neck; 0: as predicted
    toes, ends   makes toe joints, and joints that only end bones
    fingers      makes fingers, where the mesh has them; hands_model: None = the bundled one
    face, props  makes eyes and a jaw, and a joint for objects in hands, where the mesh has them. Chains for skirts and
                 capes need weights: OpenCharacter.rig(detail="full") makes them, or OpenCharacter.springs(make=True)
    progress     called with the share that is done; returns True to stop
    Raises ValueError, Error and Cancelled as bind() does.
    """
    mesh = Mesh(positions, faces)
    options = binding.init(binding.sinew_rig_options)
    options.method = chosen(method, RIG_METHODS, "method")
    options.up = declarations.UP.index(get_args(FoundUp)[chosen(up, get_args(FoundUp), "up")])
    options.front = chosen(front, FRONTS, "front")
    if method != "regions":
        options.front_model = ctypes.pointer(model_for(front_model, "fronts").struct)
    options.mirror = chosen(mirror, MIRRORS, "mirror")
    if not 0 <= spine <= 16:
        raise ValueError(f"spine: expected 0 to 16, found {spine}")
    options.spine_count = spine
    options.without = (0 if toes else declarations.WITHOUT_TOES) | (0 if ends else declarations.WITHOUT_ENDS)
    room = binding.MAX_RIG_JOINTS
    arrays: Dict[str, Array] = {"positions": np.zeros((room, 3), np.float32), "parents": np.zeros(room, np.int32), "flags": np.zeros(room, np.uint8),
              "joint_classes": np.zeros(room, np.uint8), "partners": np.zeros(room, np.int32),
              "confidence": np.zeros(room, np.uint16), "parent_confidence": np.zeros(room, np.uint16),
              "names": np.zeros(room, f"S{binding.JOINT_NAME_BYTES}")}
    outputs = binding.init(binding.sinew_rig_outputs)
    for name, array in arrays.items():
        setattr(outputs, name, binding.address(array))

    def run(report: binding.Progress, call: str, pointer: Any, *wanted: int) -> None:
        block = binding.block(call + "_workspace_size", "rig", pointer, *mesh.counts, *wanted, ctypes.byref(options))
        status = getattr(binding.library(), call)(pointer, mesh.pointer(), *wanted, ctypes.byref(options), block.address,
                                                  block.size_bytes, ctypes.byref(outputs))
        report.finish(status, "rig")

    with binding.Progress(progress) as report:
        options.progress = report.callback
        run(report, "sinew_rig", model_for(model, "skeletons").pointer() if method == "votes" else None)
        wanted = (fingers and binding.DETAIL_HANDS) | (face and binding.DETAIL_FACE) | (props and binding.DETAIL_PROPS)
        if wanted:
            run(report, "sinew_rig_details", model_for(hands_model, "hands").pointer() if fingers else None, wanted)
    found = {name: array[:outputs.joint_count] for name, array in arrays.items()}
    skeleton = Skeleton(found["positions"].copy(), found["parents"], [n.decode() for n in found["names"]],
                        classes=found["joint_classes"], ends=found["flags"] & binding.JOINT_NEVER != 0)
    sure = [found[name].astype(np.float32) / np.float32(32768) for name in ("confidence", "parent_confidence")]
    return Rig(skeleton, sure[0], sure[1], found["partners"], bool(outputs.mirrored), outputs.facing, outputs.plane, outputs.spread,
               (outputs.front[0], outputs.front[1], outputs.front[2]), declarations.UP[outputs.up], outputs.front_confidence, outputs.up_confidence)
