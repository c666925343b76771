// SPDX-License-Identifier: MIT
// The brush: what it is, and its strokes. Binds that follow them are binding.js's.
import { number } from "./facts.js";
import { showError } from "./jobs.js";
import { Latest } from "./latest.js";
import { $, all, at, engine, modes } from "./state.js";

const brushKind = () => all("#brush-kind input:checked")[0].value;

export function showBrush() {
  const kind = brushKind();
  const ready = Boolean(at.character?.result) && !at.view.editing;
  at.view.onStroke = ready && (kind === "smooth" || (kind === "add" && at.view.selected >= 0)) ? (/** @type {number} */ vertex) => strokes.want(vertex).catch((error) => showError(error.message)) : null;
  for (const id of ["brush-size", "brush-strength"]) $(id).nextElementSibling.textContent = `${$(id).value} %`;
  const painted = at.character?.result?.paintedVertices ?? 0;
  $("brush-settings").hidden = kind === "none" && painted === 0;
  $("painted").textContent = kind === "add" && at.view.selected < 0 ? "select a bone" : painted ? `${number.format(painted)} vertices` : "";
  $("forget-paint").disabled = painted === 0;
}

// The newest place of the brush; the next bind has what it left as hints.
export const strokes = new Latest(async (/** @type {number} */ vertex) => {
  if (!at.character?.result) return;
  const stroke = {
    vertex,
    radius: (Number($("brush-size").value) / 100) * at.character.size,
    joint: brushKind() === "add" ? at.view.selected : -1,
    strength: Number($("brush-strength").value) / 100,
  };
  const shown = at.mode === modes.material ? modes.joints : at.mode;
  const { buffers } = await engine.call("paint", { stroke, mode: shown, joint: Math.max(0, at.view.selected) });
  at.view.setColours(buffers.colours);
});

export function nextBrush() {
  const kinds = all("#brush-kind input");
  kinds[(kinds.findIndex(({ checked }) => checked) + 1) % kinds.length].checked = true;
  showBrush();
}
