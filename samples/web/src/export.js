// SPDX-License-Identifier: MIT
// Files out: the character as GLB, FBX, VRM or text, and the project.
import { bind } from "./binding.js";
import { run, save, whileBusy } from "./jobs.js";
import { $, at, engine } from "./state.js";

const wishOf = (profile = "") => ({
  clips: $("with-clips").checked, springs: at.springs.written, bakes: at.springs.on && profile === "" && $("bake-springs").checked, profile, author: $("author").value.trim(), title: "", licence: $("licence").value,
});
/** @type {(kind: string, profile?: string) => Promise<Uint8Array<ArrayBuffer>>} */
const written = async (kind, profile) => (await engine.call("file", { name: at.character.name, kind, wish: wishOf(profile) })).buffers.bytes;
/** @type {(extension: string) => string} */
const fileName = (extension) => `${at.character.name}.${at.character.predicted ? "rigged" : "bound"}.${extension}`;

// In the rest pose that files of a profile have, where the user chose none; the character stands as before afterwards.
/** @param {string} profile */
async function writtenFor(profile) {
  const { pose } = await engine.call("profile", { name: profile });
  if (pose === "" || at.options.toPose !== "") return written(profile, profile);
  at.options.toPose = pose;
  try {
    await bind();
    return await written(profile, profile);
  } finally {
    at.options.toPose = "";
    await bind();
  }
}

/** @type {Record<string, () => Promise<void>>} */
const writers = {
  glb: async () => save(await written("glb"), "model/gltf-binary", fileName("glb")),
  fbx: async () => save(await written("fbx"), "application/octet-stream", fileName("fbx")),
  vrm: async () => save(await writtenFor("vrm"), "model/gltf-binary", fileName("vrm")),
  rig: async () => save((await engine.call("rigText", { name: at.character.name })).buffers.bytes, "text/plain", `${at.character.name}.rig.txt`),
};

/** @type {(kind: string) => Promise<any>} */
export const exportAs = (kind) =>
  run(async () => {
    if (!at.character?.result) return;
    $("error").hidden = true;
    await whileBusy(`Writing ${kind.toUpperCase()}`, writers[kind]);
    at.changed = false;
    at.exported = true;
    at.onExported();
  });
