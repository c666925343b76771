# SPDX-License-Identifier: MIT
"""sinew: skin weights, skeletons, joint maps, motion and poses of characters, by the engine's own library.

    skeleton = sinew.Skeleton(joint_positions, parents, names)
    skin = sinew.bind(positions, faces, skeleton)          # skin.joints [n, 4], skin.weights [n, 4]

Numpy arrays go in and out. Every function's help() has shapes and units.
"""
from .binder import ANSWERS, bind
from .binding import Cancelled, Error
from .character import CLASSES, Alternative, Character, Clip, Question, Skeleton, Skin, multiply
from .deforming import Deformer
from .files import load, save
from .mapping import REASONS, JointMap, map
from .models import Model
from .opened import OpenCharacter, create, extensions, open, open_picture, open_keypoints, templates  # noqa: A004
from .retargeting import RetargetStream, joint_classes, retarget
from .rigger import Rig, rig
from .style import answers_by_style
from .transferring import Transferred, TransferredPart, transfer

__version__ = "0.1.0"
__all__ = ["ANSWERS", "CLASSES", "REASONS", "Alternative", "Cancelled", "Character", "Clip", "Deformer", "Error", "JointMap",
           "Model", "OpenCharacter", "Question", "RetargetStream", "Rig", "Skeleton", "Skin", "Transferred", "TransferredPart", "answers_by_style", "bind", "create", "extensions", "joint_classes", "load",
           "map", "multiply", "open", "open_picture", "open_keypoints", "retarget", "rig", "save", "templates", "transfer"]
