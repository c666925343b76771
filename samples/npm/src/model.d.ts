// SPDX-License-Identifier: MIT
/** The model of skin weights, 94 kB, for load() and bind(). */
export function loadModel(): Promise<Uint8Array>;
/** The model of skeletons, 264 kB, for rig(). */
export function loadRigModel(): Promise<Uint8Array>;
/** The model of where a mesh faces, 80 kB, for rig(). */
export function loadFrontModel(): Promise<Uint8Array>;
/** The model of fingers, 128 kB, for rig(). */
export function loadHandsModel(): Promise<Uint8Array>;
