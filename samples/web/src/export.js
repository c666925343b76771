// SPDX-License-Identifier: MIT
// Files out: the character as GLB, FBX, VRM or text, and the project.
import { bind } from "./binding.js";
import { run, save, whileBusy } from "./jobs.js";
import { remark } from "./opened.js";
import { $, at, engine } from "./state.js";

const wishOf = (profile = "") => ({
  clips: $("with-clips").checked, springs: at.springs.written, bakes: at.springs.on && profile === "" && $("bake-springs").checked, profile, author: $("author").value.trim(), title: "", licence: $("licence").value,
});
/** @param {string} kind @param {string} [profile] @returns {Promise<Uint8Array<ArrayBuffer>>} */
async function written(kind, profile) {
  const { height, buffers } = await engine.call("file", { name: at.character.name, kind, wish: wishOf(profile) });
  if (height !== 0) remark(`It stood ${Math.abs(height).toPrecision(2)} m ${height < 0 ? "below" : "above"} the floor; in the ${kind.toUpperCase()} it stands on it.`);
  return buffers.bytes;
}
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

// A VRM says who made it, and is not made of one whose license forbids it.
function checkLicense() {
  $("author").closest("details").open = true;
  if (!$("license-mine-field").hidden && !$("license-mine").checked) throw new Error("The license of this VRM forbids changing it. Tick that you made it or that its author lets you.");
  if ($("author").value.trim() === "" && $("author").placeholder === "") {
    $("author").focus();
    throw new Error("VRM needs an author. Who made this character?");
  }
}

/** @type {(kind: string) => Promise<any>} */
export const exportAs = (kind) =>
  run(async () => {
    if (!at.character?.result) return;
    $("error").hidden = true;
    if (kind === "vrm") checkLicense();
    await whileBusy(`Writing ${kind.toUpperCase()}`, writers[kind]);
    at.character.source.changed = at.character.source.resumed = false;
    at.character.source.exported = true;
    at.onExported();
  });
