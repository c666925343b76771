# SPDX-License-Identifier: MIT
"""sinew in Blender: skin weights, skeletons, motion and corrected bends. See README.md of samples/blender."""

bl_info = {
    "name": "sinew",
    "author": "The sinew authors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "3D View > Sidebar > sinew; Object > Parent; Weights",
    "description": "Skin weights, skeletons and motion for characters",
    "category": "Rigging",
}

from . import bind, check, controls, correct, look, panel, retarget, rig, transfer  # noqa: E402

_MODULES = (bind, rig, transfer, retarget, look, correct, controls, check, panel)


def register():
    for module in _MODULES:
        module.register()


def unregister():
    for module in reversed(_MODULES):
        module.unregister()
