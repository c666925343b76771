# SPDX-License-Identifier: MIT
"""load() and save(): characters of files as arrays. Other data of a file, such as materials and textures, is kept."""
from __future__ import annotations

import os
from typing import Optional, Union

import numpy as np

from . import opened
from .binding import Array
from .character import Character, Clip, skin_of


def load(path: Union[str, "os.PathLike[str]"], fps: Optional[float] = None) -> Character:
    """Reads a file in any format of the command; see open() for all jobs.

    fps  frames per second of the clips; None: as in the file
    Returns a Character: positions in the bind pose, [f, 3] triangles, skeleton, skin, clips. Raises Error,
    with the file name and the reason.
    """
    one = opened.open(path).character()
    if isinstance(one.faces, list):
        one.faces = np.concatenate([_fans(block) for block in one.faces])
    if fps is not None:
        one.clips = [_resampled(clip, fps) for clip in one.clips]
    one.loaded = (one.skeleton, one.skin, tuple(one.clips) if fps is None else ())
    return one


def save(path: Union[str, "os.PathLike[str]"], character: Character) -> None:
    """Writes mesh, skeleton, weights and clips by the extension: .glb, .gltf, .vrm, .fbx, .obj, .rig.txt. A character of load() keeps all else
    of its file; one of arrays alone has its vertices in the order in which faces use them. Raises ValueError and Error; a file that was
    there stays as it was then.
    """
    if character.skin is not None:
        if character.skeleton is None:
            raise ValueError("character.skeleton: a skin needs one")
        skin_of(character.skin, len(character.positions), len(character.skeleton), "character.skin")
    if character.document is None:
        with opened.create(character) as one:
            one.save(path)
        return
    skeleton, skin, clips = character.loaded
    with character.document.copy() as one:
        if character.skeleton is not None and character.skeleton is not skeleton:
            one.set_skeleton(character.skeleton)
            skin, clips = None, ()
        if character.skin is not None and character.skin is not skin:
            one.set_skin(character.skin)
        for clip in character.clips:
            if not any(clip is known for known in clips):
                one.add_clip(clip, character.skeleton)
        one.save(path)


def _fans(block: Array) -> Array:
    """Polygons [f, k] as triangles."""
    middle = np.arange(1, block.shape[1] - 1)
    return np.asarray(np.stack([np.repeat(block[:, :1], len(middle), 1), block[:, middle], block[:, middle + 1]], 2).reshape(-1, 3))


def _resampled(clip: Clip, fps: float) -> Clip:
    frames = len(clip.rotations)
    at = np.arange(int(np.floor((frames - 1) * fps / clip.fps + 1e-3)) + 1) * clip.fps / fps
    left = np.minimum(at.astype(int), frames - 1)
    right, share = np.minimum(left + 1, frames - 1), (at - left)[:, None, None]
    a, b = clip.rotations[left], clip.rotations[right]
    q = a + share * (np.where((a * b).sum(2, keepdims=True) < 0, -b, b) - a)
    q = q / np.maximum(np.linalg.norm(q, axis=2, keepdims=True), 1e-30)
    return Clip(q, clip.translations[left] + share * (clip.translations[right] - clip.translations[left]), fps, clip.name)
