// SPDX-License-Identifier: MIT
// The file that a character's look is read from.
import { engine } from "./state.js";

// As the file's look is shown, whatever is to be exported.
/** @type {(name: string) => Promise<Uint8Array<ArrayBuffer>>} */
export const glbOf = async (name) => (await engine.call("file", { name, kind: "glb", wish: { clips: false, profile: "" } })).buffers.bytes;
