# SPDX-License-Identifier: MIT
"""Deformer: a bound mesh in poses."""
from __future__ import annotations

import ctypes
from typing import Any, Literal, Optional, Union

import numpy as np

from . import binding, declarations
from .arrays import Mesh, chosen, real
from .binding import Array
from .binder import skeleton_view
from .character import Skeleton, Skin, skin_of

DeformMethod = Union[declarations.DeformMethod, Literal["linear", "dual-quaternion"]]
DEFORM_METHODS = (*declarations.DEFORM_METHOD, "linear", "dual-quaternion")
_PLAIN = {"linear": "sinew_skin_linear", "dual-quaternion": "sinew_skin_dual_quaternion"}


class Deformer:
    """Poses a bound mesh any number of times, from any number of threads.

    positions, faces, skeleton, skin   as bind() takes and gives them; copied
    method     "volume": bends keep their volume; "xpbd", "delta-mush": published methods; "linear", "dual-quaternion"
    cells      lattice cells along the longest side, 8 to 64; 0: 32
    rounds     1 to 200, more rounds are slower and keep more volume; 0: 20, delta-mush 5
    softness   1 to 65535; 0: 1280
    contact    keeps the two sides of a bend apart
    body_contact  keeps other parts apart too: an arm and the torso, a thigh and the belly, two thighs. "volume" and "xpbd"
    Raises ValueError and Error as bind() does.
    """

    def __init__(self, positions: Any, faces: Any, skeleton: Skeleton, skin: Skin, *, method: DeformMethod = "volume", cells: int = 0,
                 rounds: int = 0, softness: int = 0, contact: bool = True, body_contact: bool = False) -> None:
        mesh = Mesh(positions, faces)
        chosen(method, DEFORM_METHODS, "method")
        rows = skin_of(skin, len(mesh.positions), len(skeleton), "skin")
        rows = rows.rounded(rows.joints.shape[1])
        self.vertex_count, self.joint_count = len(mesh.positions), len(skeleton)
        self._plain = _PLAIN.get(method)
        if self._plain:
            self._rest = (mesh.positions.copy(), rows)
            return
        options = binding.init(binding.sinew_deform_options)
        options.method, options.cell_count, options.round_count = DEFORM_METHODS.index(method), cells, rounds
        options.softness, options.without = softness, 0 if contact else declarations.WITHOUT_CONTACTS
        options.body_contact = int(body_contact)
        view = binding.sinew_skin(binding.address(rows.joints), binding.address(rows.weights), rows.joints.shape[1])
        joints = skeleton_view(skeleton, None)
        self._memory = binding.block("sinew_deform_create_workspace_size", "deformer", mesh.pointer(), self.joint_count,
                                     rows.joints.shape[1], ctypes.byref(options))
        self._deformer = binding.sinew_deformer()
        status = binding.library().sinew_deform_create(mesh.pointer(), ctypes.byref(joints), ctypes.byref(view),
                                                       ctypes.byref(options), self._memory.address, self._memory.size_bytes,
                                                       ctypes.byref(self._deformer))
        binding.check(status, "deformer")

    def pose(self, matrices: Any, out: Optional[Array] = None) -> Array:
        """Positions in a pose.

        matrices  [j, 3, 4] or [j, 4, 4], pose times inverse bind per joint, see Skeleton.matrices(); rows first
        out       [n, 3] float32, C-contiguous and writable, to write to; None: a new array
        Returns [n, 3] float32. Raises ValueError and Error.
        """
        if np.shape(matrices)[1:] == (4, 4):
            matrices = np.asarray(matrices)[:, :3]
        palette = real(matrices, (self.joint_count, 3, 4), "matrices")
        if out is None:
            out = np.empty((self.vertex_count, 3), np.float32)
        elif not isinstance(out, np.ndarray) or out.shape != (self.vertex_count, 3) or out.dtype != np.float32 or not out.flags.carray:
            raise ValueError(f"out: expected float32 of shape ({self.vertex_count}, 3), C-contiguous, in memory that may be written to")
        library = binding.library()
        if self._plain:
            rest, skin = self._rest
            rows = binding.sinew_skin(binding.address(skin.joints), binding.address(skin.weights), skin.joints.shape[1])
            binding.check(getattr(library, self._plain)(
                binding.address(rest), self.vertex_count, ctypes.byref(rows), binding.address(palette), self.joint_count,
                binding.address(out)), "pose")
            return out
        block = binding.Block(self._deformer.pose_bytes)
        outputs = binding.init(binding.sinew_deform_outputs)
        outputs.positions = binding.address(out)
        binding.check(library.sinew_deform_pose(ctypes.byref(self._deformer), binding.address(palette), block.address,
                                                block.size_bytes, ctypes.byref(outputs)), "pose")
        return out
