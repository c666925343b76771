// SPDX-License-Identifier: MIT
// Weights of the character that is open, joints on and off, locked vertices, the brush.
import { listQuestions, lookNowhere } from "./asking.js";
import { colour } from "./colours.js";
import { number } from "./facts.js";
import { clearError, run, showError, whileBinding } from "./jobs.js";
import { Latest } from "./latest.js";
import { switched } from "./options.js";
import { listJoints, sendPose, showFacts } from "./showing.js";
import { $, at, engine, modes } from "./state.js";

export const pending = "·".repeat(16); // a hash that is not known yet

export const how = () => ({ wish: at.options.wish(at.character) });
export const asNumbers = (answers) => answers.map(({ question, kind, joint }) => [question.part, kind, joint]);

// answers: those of the character from now on, if they can be had. focus: see Questions.show().
export async function bind(answers = at.character.source.answers, focus) {
  if (at.character.joints.length === 0) return;
  const before = answers === at.character.source.answers ? null : at.character.result;
  lookNowhere();
  at.character.result = null;
  showFacts(at.character.shown && { ...at.character.shown, hash: pending }); // a line of the same length: the picture keeps its size
  const started = performance.now();
  try {
    const result = await whileBinding(() => engine.call("bind", { ...how(), answers: asNumbers(answers) }));
    at.character.result = { ...result, wallSeconds: (performance.now() - started) / 1e3, strongest: result.buffers.strongest };
    at.character.shown = at.character.result;
    result.questions.forEach((question, number) => (question.members = { of: result.buffers.vertexQuestions, number }));
    at.character.source.answers = answers;
  } catch (error) {
    at.character.result = before;
    if (before) await engine.call("endPreview").then(colour);
    throw error;
  } finally {
    showFacts();
    listQuestions(focus);
  }
  listJoints();
  showBrush();
  await colour();
  await at.motions.again();
  await sendPose();
}

// Whether the last bind gave the joint no weight because names, places or the user say so.
export const isOff = (joint) => Boolean(at.character?.result?.off.includes(joint));

export async function switchJoint(joint) {
  const { source } = at.character;
  const { never, always } = source;
  Object.assign(source, switched(source, at.character.joints[joint].name, isOff(joint)));
  try {
    await bind();
  } catch (error) {
    Object.assign(source, { never, always });
    await bind().catch(() => {});
    throw error;
  }
}

export async function lockJoint(joint) {
  const { source, joints } = at.character;
  const { name } = joints[joint];
  if (!source.locked.delete(name)) source.locked.add(name);
  await engine.call("lock", { joints: joints.flatMap((one, j) => (source.locked.has(one.name) ? [j] : [])) });
  await bind();
}

const brushKind = () => document.querySelector("#brush-kind input:checked").value;

export function showBrush() {
  const kind = brushKind();
  const ready = Boolean(at.character?.result) && !at.view.editing;
  at.view.onStroke = ready && (kind === "smooth" || (kind === "add" && at.view.selected >= 0)) ? (vertex) => strokes.want(vertex).catch((error) => showError(error.message)) : null;
  $("brush").hidden = at.view.editing;
  if (kind !== "none") $("brush").open = true; // by its key
  $("brush-settings").hidden = kind === "none";
  for (const id of ["brush-size", "brush-strength"]) $(id).nextElementSibling.textContent = `${$(id).value} %`;
  const painted = at.character?.result?.paintedVertices ?? 0;
  $("painted").textContent = kind === "add" && at.view.selected < 0 ? "choose a joint" : painted ? `${number.format(painted)} vertices` : "";
  $("forget-paint").disabled = painted === 0;
}

// The newest place of the brush; the next bind has what it left as hints.
export const strokes = new Latest(async (vertex) => {
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

export function endStroke() {
  run(async () => {
    while (strokes.busy) await strokes.idle().catch(() => {}); // said already
    clearError();
    await bind();
  });
}

export async function forgetPaint() {
  await engine.call("forgetPaint");
  await bind();
}

export function nextBrush() {
  const kinds = [...document.querySelectorAll("#brush-kind input")];
  kinds[(kinds.findIndex(({ checked }) => checked) + 1) % kinds.length].checked = true;
  showBrush();
}
