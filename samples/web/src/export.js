// SPDX-License-Identifier: MIT
// Files out: the character for a program, with what the file will leave out told before; skeletons as text, and the project.
import { bind } from "./binding.js";
import { $ } from "./elements.js";
import { run, save, whileBusy } from "./jobs.js";
import { remark } from "./opened.js";
import { chosenProgram, factsOf, lossesOf, programs } from "./programs.js";
import { sentenceOf } from "./sentences.js";
import { at, engine } from "./state.js";

/** @typedef {import("./programs.js").Program} Program */

const wishOf = (profile = "") => ({
  clips: $("with-clips").checked, springs: at.springs.written, bakes: at.springs.on && profile !== "vrm" && $("bake-springs").checked, profile, author: $("author").value.trim(), title: "", licence: $("licence").value,
});
/** @param {string} kind @param {string} [profile] @returns {Promise<{ bytes: Uint8Array<ArrayBuffer>, notes: string[], height: number }>} */
async function written(kind, profile) {
  const { height, notes, buffers } = await engine.call("file", { name: at.character.name, kind, wish: wishOf(profile) });
  return { bytes: buffers.bytes, notes, height };
}

// In the rest pose that files of a profile have, where the user chose none and the character can be put into it; it stands as before afterwards.
/** @param {string} kind @param {string} profile */
async function writtenFor(kind, profile) {
  const { pose } = profile ? await engine.call("profile", { name: profile }) : { pose: "" };
  if (pose === "" || at.options.toPose !== "") return written(kind, profile);
  at.options.toPose = pose;
  try {
    await bind().catch((error) => {
      if (kind === "vrm") throw error;
      at.options.toPose = "";
      remark(`It is written in the pose that it is in: ${error.message.replace(/;.*/, "")}.`);
      return bind();
    });
    return await written(kind, profile);
  } finally {
    if (at.options.toPose !== "") {
      at.options.toPose = "";
      await bind();
    }
  }
}

/** @param {Program} program */
async function saveFor({ id, kind, profile }) {
  const { bytes, height } = await writtenFor(kind, profile);
  if (height !== 0) remark(`It stood ${Math.abs(height).toPrecision(2)} m ${height < 0 ? "below" : "above"} the floor; in the ${kind.toUpperCase()} it stands on it.`);
  save(bytes, kind === "fbx" ? "application/octet-stream" : "model/gltf-binary", [at.character.name, ...(id === "any" ? [at.character.predicted ? "rigged" : "bound"] : id === kind ? [] : [id]), kind].join("."));
}

// A VRM says who made it, and is not made of one whose license forbids it.
function checkLicense() {
  if (!$("license-mine-field").hidden && !$("license-mine").checked) throw new Error("The license of this VRM forbids changing it. Tick that you made it or that its author lets you.");
  if ($("author").value.trim() === "" && $("author").placeholder === "") {
    $("author").focus();
    throw new Error("VRM needs an author. Who made this character?");
  }
}

// The job, where there is something to export; the character is as saved as it can be then.
/** @param {string} words @param {() => Promise<any>} job */
const exporting = (words, job) =>
  run(async () => {
    if (!at.character?.result) return;
    $("error").hidden = true;
    await whileBusy(words, job);
    at.character.source.changed = at.character.source.resumed = false;
    at.character.source.exported = true;
    at.onExported();
  });

/** @param {Program} program */
export const exportFor = (program) =>
  exporting(`Writing the file for ${program.name}`, () => {
    if (program.kind === "vrm") checkLicense();
    return saveFor(program);
  });
const plainFbx = { ...programs[0], kind: "fbx" };
const rigText = async () => save((await engine.call("rigText", { name: at.character.name })).buffers.bytes, "text/plain", `${at.character.name}.rig.txt`);

/** @param {string} tag @param {string} text */
const cell = (tag, text) => Object.assign(document.createElement(tag), { textContent: text });

// What the panel says of the chosen program, and of what its file leaves out: the file is written once for that, and thrown away.
export function showProgram() {
  const program = chosenProgram();
  const clips = (at.player.motion?.clips ?? []).map((/** @type {{ name: string }} */ { name }) => name || "clip");
  $("program-facts").replaceChildren(...factsOf(program, at.options.toPose === "t", $("with-clips").checked ? clips : []).flatMap(([what, how]) => [cell("dt", what), cell("dd", how)]));
  $("vrm-fields").hidden = program.kind !== "vrm";
  at.onProgram();
  if (at.step !== "export" || !at.character?.result) return;
  run(async () => {
    if (program !== chosenProgram() || !at.character?.result) return;
    const known = lossesOf(program, { springs: at.springs.on, baked: $("bake-springs").checked, clips: at.player.motion?.own ? 0 : clips.length, withClips: $("with-clips").checked, skinning: at.bends.skinning, turned: at.pose.turns.some((turn) => turn !== 0) });
    const { notes } = await whileBusy("Looking at what the file can hold", () => written(program.kind, program.profile)).catch((error) => ({ notes: [`This file cannot be written: ${error.message}`] }));
    const lines = [...known, ...notes.map(sentenceOf)].filter(Boolean);
    $("losses").replaceChildren(...(lines.length === 0 ? ["Nothing is lost."] : lines).map((line) => cell("li", line)));
  });
}

export function listenForExport() {
  $("programs").append(
    ...programs.map(({ id, name }) => {
      const label = document.createElement("label");
      label.append(Object.assign(document.createElement("input"), { type: "radio", name: "program", value: id, checked: id === "any" }), cell("span", name));
      return label;
    }),
  );
  $("programs").onchange = $("with-clips").onchange = $("bake-springs").onchange = showProgram;
  $("download").onclick = () => exportFor(programs[0]);
  $("download-fbx").onclick = () => exporting("Writing the FBX", () => saveFor(plainFbx));
  $("download-rig").onclick = () => exporting("Writing the skeleton as text", rigText);
}
