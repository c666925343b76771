// SPDX-License-Identifier: MIT
// Files out: the character as GLB, FBX, VRM or text, and the project.
import { run, save, whileBusy } from "./jobs.js";
import { $, at, engine } from "./state.js";

const wishOf = (profile = "") => ({
  clips: $("with-clips").checked, profile, author: $("author").value.trim(), title: "", licence: $("licence").value,
});
const written = async (kind, profile) => (await engine.call("file", { name: at.character.name, kind, wish: wishOf(profile) })).buffers.bytes;
const fileName = (extension) => `${at.character.name}.${at.character.predicted ? "rigged" : "bound"}.${extension}`;

// As the file's look is shown, whatever is to be exported.
export const glbOf = async (name) => (await engine.call("file", { name, kind: "glb", wish: { clips: false, profile: "" } })).buffers.bytes;

function fbxOf(glb) {
  return new Promise((resolve, reject) => {
    const worker = new Worker("fbx_worker.js", { type: "module" });
    const end = (use) => (event) => (worker.terminate(), use(event));
    worker.onmessage = end(({ data }) => (data.error ? reject(new Error(`cannot be written as FBX: ${data.error}`)) : resolve(data.bytes)));
    worker.onerror = end((event) => (event.preventDefault(), reject(new Error(`cannot be written as FBX: ${event.message}`))));
    worker.postMessage(glb, [glb.buffer]);
  });
}

const writers = {
  glb: async () => save(await written("glb"), "model/gltf-binary", fileName("glb")),
  fbx: async () => save(await fbxOf(await written("glb")), "application/octet-stream", fileName("fbx")),
  vrm: async () => save(await written("vrm", "vrm"), "model/gltf-binary", fileName("vrm")),
  rig: async () => save((await engine.call("rigText", { name: at.character.name })).buffers.bytes, "text/plain", `${at.character.name}.rig.txt`),
};

export const exportAs = (kind) =>
  run(async () => {
    if (!at.character?.result) return;
    $("error").hidden = true;
    await whileBusy(`Writing ${kind.toUpperCase()}`, writers[kind]);
    at.changed = false;
    at.exported = true;
    at.onExported();
  });
