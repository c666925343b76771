// SPDX-License-Identifier: MIT
// Files by extension. Generated from formats/src/files/file_kinds.cpp by scripts/file_kinds.py; a test compares.

export const fileKinds = [
  { extension: ".obj", name: "OBJ", reader: "obj", uses: ["readsMesh", "writesCharacter", "writesMesh", "offered", "writesWithMesh"] },
  { extension: ".rig.txt", name: "rig.txt", reader: "rig", uses: ["readsSkeleton", "writesCharacter", "offered", "writesSkin"] },
  { extension: ".txt", name: "rig.txt", reader: "rig", uses: ["readsSkeleton"] },
  { extension: ".gltf", name: "glTF", reader: "gltf", uses: ["readsMesh", "readsSkeleton", "readsMotion", "readsWhole", "writesCharacter", "writesMotion", "offered", "writesSkin", "writesWithMesh", "writesSprings"] },
  { extension: ".glb", name: "GLB", reader: "gltf", uses: ["readsMesh", "readsSkeleton", "readsMotion", "readsWhole", "writesCharacter", "writesMotion", "offered", "writesSkin", "writesWithMesh", "writesSprings"] },
  { extension: ".vrm", name: "VRM", reader: "gltf", uses: ["readsMesh", "readsSkeleton", "readsMotion", "readsWhole", "writesCharacter", "writesMotion", "offered", "writesSkin", "writesWithMesh", "writesSprings"] },
  { extension: ".fbx", name: "FBX", reader: "scene", uses: ["readsMesh", "readsSkeleton", "readsMotion", "readsWhole", "writesCharacter", "writesMotion", "offered", "writesSkin", "writesWithMesh"] },
  { extension: ".usda", name: "USD", reader: "none", uses: ["writesCharacter", "writesMotion", "writesSkin", "writesWithMesh"] },
  { extension: ".usdz", name: "USD", reader: "none", uses: ["writesCharacter", "writesMotion", "writesSkin", "writesWithMesh"] },
  { extension: ".dae", name: "COLLADA", reader: "scene", uses: ["readsMesh", "readsSkeleton", "readsMotion", "readsWhole", "offered"] },
  { extension: ".b3d", name: "Blitz3D", reader: "scene", uses: ["readsMesh", "readsSkeleton", "readsMotion", "readsWhole"] },
  { extension: ".x", name: "DirectX", reader: "scene", uses: ["readsMesh", "readsSkeleton", "readsMotion", "readsWhole"] },
  { extension: ".mesh.xml", name: "OGRE", reader: "scene", uses: ["readsMesh", "readsSkeleton", "readsMotion", "readsWhole"] },
  { extension: ".mesh", name: "OGRE", reader: "scene", uses: ["readsMesh", "readsSkeleton", "readsMotion", "readsWhole"] },
  { extension: ".md5mesh", name: "MD5", reader: "scene", uses: ["readsMesh", "readsSkeleton", "readsMotion", "readsWhole"] },
  { extension: ".ms3d", name: "MilkShape", reader: "scene", uses: ["readsMesh", "readsSkeleton", "readsMotion", "readsWhole"] },
  { extension: ".smd", name: "Valve SMD", reader: "scene", uses: ["readsMesh", "readsSkeleton", "readsMotion", "readsWhole"] },
  { extension: ".iqm", name: "IQM", reader: "iqm", uses: ["readsMesh", "readsSkeleton", "readsMotion", "readsWhole", "offered"] },
  { extension: ".bvh", name: "BVH", reader: "bvh", uses: ["readsSkeleton", "readsMotion", "writesMotion", "offered"] },
  { extension: ".vrma", name: "VRM animation", reader: "gltf", uses: ["readsSkeleton", "readsMotion", "writesMotion", "offered"] },
  { extension: ".npz", name: "NumPy", reader: "numpy", uses: ["readsSkeleton", "readsMotion", "offered"] },
  { extension: ".npy", name: "NumPy", reader: "numpy", uses: ["readsSkeleton", "readsMotion", "offered"] },
  { extension: ".vmd", name: "VMD", reader: "vmd", uses: ["readsSkeleton", "readsMotion", "offered"] },
  { extension: ".amc", name: "Acclaim", reader: "amc", uses: ["readsSkeleton", "readsMotion", "offered"] },
  { extension: ".png", name: "PNG", reader: "picture", uses: ["offered", "readsPicture"] },
  { extension: ".jpg", name: "JPEG", reader: "picture", uses: ["offered", "readsPicture"] },
  { extension: ".jpeg", name: "JPEG", reader: "picture", uses: ["offered", "readsPicture"] },
];

/**
 * The row of a file's extension, without regard to case.
 * @param {string} file
 */
export const fileKind = (file) => fileKinds.find(({ extension }) => file.toLowerCase().endsWith(extension));

/**
 * Extensions of the files that have all these uses: readsMesh, readsSkeleton, readsMotion, readsWhole, ..., offered.
 * @param {...string} uses
 */
export const extensionsOf = (...uses) =>
  fileKinds.filter((kind) => uses.every((use) => kind.uses.includes(use))).map(({ extension }) => extension);
