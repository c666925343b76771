// SPDX-License-Identifier: MIT
// Questions about parts, their answers, and styles.
import { asNumbers, bind, how } from "./binding.js";
import { colour } from "./colours.js";
import { number } from "./facts.js";
import { clearError, run, save } from "./jobs.js";
import { partName } from "./questions.js";
import { sendPose } from "./showing.js";
import { $, at, engine } from "./state.js";

const lookMilliseconds = 90; // the pointer stays that long on what is shown

export function lookAt(wanted) {
  if (wanted === at.look) return;
  at.look = wanted;
  clearTimeout(at.lookTimer);
  at.lookTimer = setTimeout(() => {
    at.lookTimer = 0;
    run(showLook);
  }, lookMilliseconds);
}

// What a bind brings ends what was looked at.
export function lookNowhere() {
  at.look = at.shownLook = null;
  at.previewing = false;
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

export function lookText() {
  if (!at.shownLook) return null;
  const { question, answer } = at.shownLook;
  const alike = question.parts > 1 ? ` in ${question.parts} parts alike` : "";
  if (answer === undefined) return `Orange: ${partName(question)}, ${number.format(question.vertices)} vertices${alike}`;
  return `${at.previewing ? "Preview" : "Answered"}: ${partName(question)} ${answer}${alike}`;
}

export function listQuestions(focus) {
  const { answers } = at.character.source;
  const list = at.character.result?.questions ?? [];
  at.questions.show({ questions: list, answers, joints: at.character.joints, focus });
  $("questions-count").textContent = at.character.result ? `${list.length} open${answers.length ? `, ${answers.length} answered` : ""}` : "";
  $("style").hidden = !at.style;
  const byStyle = answers.filter((answer) => answer.byStyle).length;
  $("save-style").disabled = !at.character.result || answers.length === byStyle;
  const label = $("style").firstElementChild;
  label.textContent = label.title = at.style ? `${at.style.name}: ${byStyle} answers` : "";
}

export function take(answer) {
  run(() => (clearError(), bind([...at.character.source.answers, answer], answer.question.part)));
}

export function takeBack(answer) {
  run(() => (clearError(), bind(at.character.source.answers.filter((other) => other !== answer), answer.question.part)));
}

export async function useStyle(file) {
  await engine.call("style", { name: file });
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
