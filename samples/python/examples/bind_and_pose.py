# SPDX-License-Identifier: MIT
# %% [markdown]
# # A character from mesh to pose
# Run it cell by cell (VS Code, Spyder, Jupyter with jupytext), or as a whole: `python3 bind_and_pose.py [CHARACTER.gltf [PICTURES]]`.

# %%
import sys
from pathlib import Path

import matplotlib

if __name__ == "__main__" and "ipykernel" not in sys.modules:
    matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

import sinew

files = [a for a in sys.argv[1:] if not a.startswith("-")] if "ipykernel" not in sys.modules else []
path = Path(files[0]) if files else Path(__file__).resolve().parents[2] / "data" / "biped__caped.gltf"
pictures = Path(files[1]) if len(files) > 1 else Path(".")
character = sinew.load(path)
print(f"{character.name}: {len(character.positions)} vertices, {len(character.faces)} triangles")


# %%
def draw(axes, positions, colors, title, skeleton=None):
    """Triangles with a color per vertex, y up, seen from the front."""
    turned = positions[:, [0, 2, 1]] * [1, -1, 1]
    corners = turned[character.faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    light = 0.55 + 0.45 * np.abs(normals @ [0.4, -0.8, 0.45])
    shown = Poly3DCollection(corners, facecolors=np.clip(colors[character.faces].mean(1) * light[:, None], 0, 1), linewidths=0)
    axes.add_collection3d(shown)
    if skeleton is not None:
        places = skeleton.positions[:, [0, 2, 1]] * [1, -1, 1]
        for joint, parent in enumerate(skeleton.parents):
            if parent >= 0:
                axes.plot(*places[[joint, parent]].T, color="black", linewidth=1.5, marker="o", markersize=2, zorder=10)
    low, high = turned.min(0), turned.max(0)
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]), title=title)
    axes.set_box_aspect(high - low, zoom=1.5)
    axes.view_init(8, -75)
    axes.set_axis_off()


def figure(name, *panels):
    shown, rows = plt.subplots(1, len(panels), figsize=(5 * len(panels), 5.5), subplot_kw={"projection": "3d", "computed_zorder": False})
    for axes, panel in zip(np.atleast_1d(rows), panels):
        draw(axes, *panel)
    shown.tight_layout()
    shown.savefig(pictures / f"{name}.png", dpi=80)
    print("wrote", pictures / f"{name}.png")


# %% [markdown]
# ## A skeleton for the bare mesh
# `rig()` gives one to any mesh. Here it is laid over the file's own.

# %%
rig = sinew.rig(character.positions, character.faces)
print(f"{len(rig.skeleton)} joints, how far off the votes think they are: {rig.spread:.3f}")
gray = np.full((len(character.positions), 3), 0.8)
skeleton = character.skeleton or rig.skeleton
figure("skeletons", (character.positions, gray, "predicted", rig.skeleton), (character.positions, gray, "of the file", skeleton))

# %% [markdown]
# ## Weights
# One color a joint, mixed by weight; and where the binder is least sure.

# %%
skin = sinew.bind(character.positions, character.faces, skeleton)
palette = np.array([matplotlib.colors.hsv_to_rgb((0.618 * j % 1, 0.6, 0.95)) for j in range(len(skeleton))])
weights = skin.dense(len(skeleton))
doubt = 1 - skin.confidence / 255
figure("weights", (character.positions, weights @ palette, "weights"),
       (character.positions, plt.get_cmap("inferno")(doubt / max(doubt.max(), 1e-6))[:, :3], "where to look"))

# %% [markdown]
# ## A pose
# Joints that have children bend; linear blending loses volume where the other keeps it.

# %%
rotations, _ = skeleton.rest()
classes = sinew.joint_classes(skeleton)
for joint in np.flatnonzero(np.isin(classes, [sinew.CLASSES.index(c) for c in ("forearm", "calf")])):
    rotations[joint] = [np.sin(0.7), 0, 0, np.cos(0.7)]
matrices = skeleton.matrices(rotations)
panels = []
for method in ("linear", "volume"):
    deformer = sinew.Deformer(character.positions, character.faces, skeleton, skin, method=method)
    panels.append((deformer.pose(matrices), weights @ palette, method))
figure("pose", *panels)

# %%
character.skeleton, character.skin = skeleton, skin
sinew.save(pictures / f"{character.name}.bound.glb", character)
print("wrote", pictures / f"{character.name}.bound.glb")
