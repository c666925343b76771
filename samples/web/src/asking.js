// SPDX-License-Identifier: MIT
// Questions about parts, their answers, and styles.
import { bind } from "./binding.js";
import { colour } from "./colours.js";
import { act } from "./acting.js";
import { run, save } from "./jobs.js";
import { partName } from "./questions.js";
import { sendPose } from "./showing.js";
import { at, engine } from "./state.js";
import { asNumbers, how } from "./wishes.js";

const lookMilliseconds = 90; // the pointer stays that long on what is shown

/** @param {any} wanted */
export function lookAt(wanted) {
  if (wanted === at.look) return;
  at.look = wanted;
  clearTimeout(at.lookTimer);
  at.lookTimer = setTimeout(() => {
    at.lookTimer = 0;
    run(showLook);
  }, lookMilliseconds);
}

async function showLook() {
  if (at.look === at.shownLook || !at.character?.result) return;
  const wanted = at.look;
  const isPreview = wanted?.answer !== undefined && !at.character.source.answers.includes(wanted);
  const wasPreview = at.previewing;
  if (isPreview) {
    await engine.call("preview", { ...how(), answers: asNumbers([...at.character.source.answers, wanted]) });
  } else if (wasPreview) {
    await engine.call("endPreview");
  }
  at.previewing = isPreview;
  at.shownLook = wanted;
  await colour();
  if (isPreview || wasPreview) await sendPose();
}

/** @param {import("./types.js").Answer} answer */
export function take(answer) {
  act(`answer ${partName(answer.question)}`, () => bind([...at.character.source.answers, answer], answer.question.part));
}

/** @param {import("./types.js").Answer} answer */
export function takeBack(answer) {
  act(`take back ${partName(answer.question)}`, () => bind(at.character.source.answers.filter((other) => other !== answer), answer.question.part));
}

/** @param {string} file "" for none @param {number} [folder] that it lies in */
export async function useStyle(file, folder) {
  await engine.call("style", { name: file, folder });
  at.style = file === "" ? null : { name: file };
}

// The style's answers for the character, before its own.
export async function useStyleAnswers() {
  const { source } = at.character;
  if ((source.style ?? null) === at.style) return;
  const own = source.answers.filter(({ byStyle }) => !byStyle);
  const { answers, buffers } = at.style ? await engine.call("styleAnswers", how()) : { answers: [] };
  for (const answer of answers) {
    answer.byStyle = true;
    answer.question.members = { of: buffers.vertexQuestions, number: answer.number };
  }
  source.answers = [...answers, ...own];
  source.style = at.style;
}

export async function forgetStyle() {
  await useStyle("");
  await useStyleAnswers();
  await bind();
}

export async function saveStyle() {
  const own = at.character.source.answers.filter(({ byStyle }) => !byStyle);
  const name = `${at.character.name}.style`;
  const { buffers } = await engine.call("saveStyle", { ...how(), answers: asNumbers(own), name });
  save(buffers.bytes, "application/json", name);
}
