# SPDX-License-Identifier: MIT
# Files by extension. Generated from formats/src/files/file_kinds.cpp by scripts/file_kinds.py; a test compares.
extends Reference

const MESHES = ["obj", "gltf", "glb", "vrm", "fbx", "dae", "iqm"]
const SKELETONS = "*.rig.txt,*.gltf,*.glb,*.vrm,*.fbx,*.dae,*.iqm,*.bvh,*.vrma,*.npz,*.npy,*.vmd,*.amc"
const MOTIONS = "*.gltf,*.glb,*.vrm,*.fbx,*.dae,*.iqm,*.bvh,*.vrma,*.npz,*.npy,*.vmd,*.amc"
