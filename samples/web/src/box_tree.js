// SPDX-License-Identifier: MIT
// What rays.js takes of three-mesh-bvh: a file of its own, so that the rest of it is left out.
export { acceleratedRaycast, MeshBVH } from "three-mesh-bvh";
