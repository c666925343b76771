// SPDX-License-Identifier: MIT
// The bundled models, each a module of its own: what is not asked for is not loaded.
import { decodeBase64 } from "./loader.js";

/** The model of skin weights, for Skin.bind(). @returns {Promise<Uint8Array>} */
export const loadModel = async () => decodeBase64((await import("../models/weights.js")).default);
/** The model of skeletons, for Skin.rig(). @returns {Promise<Uint8Array>} */
export const loadRigModel = async () => decodeBase64((await import("../models/skeletons.js")).default);
/** The model of where a mesh faces, for Skin.rig(). @returns {Promise<Uint8Array>} */
export const loadFrontModel = async () => decodeBase64((await import("../models/fronts.js")).default);
/** The model of fingers, for Skin.rig(). @returns {Promise<Uint8Array>} */
export const loadHandsModel = async () => decodeBase64((await import("../models/hands.js")).default);
