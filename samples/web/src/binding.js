// SPDX-License-Identifier: MIT
// Weights of the character that is open, joints on and off, locked vertices, what the brush left.
import { listQuestions, lookNowhere } from "./asked.js";
import { showBrush, strokes } from "./brush.js";
import { colour } from "./colours.js";
import { clearError, run, whileBusy } from "./jobs.js";
import { switched } from "./options.js";
import { record, rigChanged } from "./recording.js";
import { listJoints, sendPose, showFacts } from "./showing.js";
import { at, engine } from "./state.js";
import { earsThatMoveHeads } from "./suspects.js";
import { asNumbers, how, isOff, pending } from "./wishes.js";

// answers: those of the character from now on, if they can be had. focus: see Questions.show().
/** @param {import("./types.js").Answer[]} answers @param {number} [focus] */
export async function bind(answers = at.character.source.answers, focus) {
  if (at.character.joints.length === 0) return;
  const before = answers === at.character.source.answers ? null : at.character.result;
  lookNowhere();
  at.character.result = null;
  showFacts(at.character.shown && { ...at.character.shown, hash: pending }); // a line of the same length: the picture keeps its size
  const started = performance.now();
  try {
    const result = await whileBusy("Computing skin weights", () => engine.call("bind", { ...how(), answers: asNumbers(answers) }));
    if (at.firstAlone === null) at.onFirstBound();
    at.firstAlone ??= result.alone;
    at.character.result = at.character.shown = { ...result, wallSeconds: (performance.now() - started) / 1e3, strongest: result.buffers.strongest };
    result.questions.forEach((/** @type {import("./types.js").Question} */ question, /** @type {number} */ number) => (question.members = { of: result.buffers.vertexQuestions, number }));
    at.character.source.answers = answers;
    at.character.ears = at.character.predicted ? earsThatMoveHeads(at.character.joints, result.buffers.strongest, at.character.buffers.positions) : [];
    if (result.lockedVertices > 0 || result.paintedVertices > 0) rigChanged(); // their rows went through this bind
    usePlaces(result.places);
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

// By other options; those before come back where it cannot be bound by them.
export async function bindOtherwise() {
  const before = at.character.source.history?.now.options;
  try {
    await bind();
  } catch (error) {
    if (!before) throw error;
    at.options.values = before;
    await bind();
    throw error;
  }
}

// Joints of another rest pose are elsewhere, and are not edited there.
/** @param {number[][]} places */
function usePlaces(places) {
  const { character } = at;
  const posed = at.options.toPose !== "";
  const moved = character.joints.some(({ position }, j) => position.some((x, i) => x !== places[j][i]));
  if (!moved && posed === Boolean(character.posed)) return;
  character.posed = posed;
  character.joints = character.joints.map((joint, j) => ({ ...joint, position: places[j] }));
  at.view.moveSkeleton(character.joints);
  at.view.draggable = Boolean(character.editable) && !posed;
  at.editor.show(character, at.view.selected);
}

/** @param {number} joint */
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

/** @param {number} joint */
export async function lockJoint(joint) {
  const { source, joints } = at.character;
  const { name } = joints[joint];
  const locked = new Set(source.locked);
  if (!locked.delete(name)) locked.add(name);
  source.locked = locked;
  await engine.call("lock", { joints: joints.flatMap((one, j) => (source.locked.has(one.name) ? [j] : [])) });
  rigChanged();
  await bind();
}

export function endStroke() {
  run(async () => {
    while (strokes.busy) await strokes.idle().catch(() => {}); // said already
    clearError();
    rigChanged();
    await bind();
    record("paint");
  });
}

export async function forgetPaint() {
  await engine.call("forgetPaint");
  rigChanged();
  await bind();
}
