// SPDX-License-Identifier: MIT
// The list of questions, and which of its parts is looked at.
import { number } from "./facts.js";
import { answerText, partName } from "./questions.js";
import { $, at } from "./state.js";

// What a bind brings ends what was looked at.
export function lookNowhere() {
  at.look = at.shownLook = null;
  at.previewing = false;
}

export function lookText() {
  if (!at.shownLook) return null;
  const { question, answer } = at.shownLook;
  const alike = question.parts > 1 ? ` (${question.parts} similar parts)` : "";
  if (answer === undefined) return `Orange: ${partName(question)}, ${number.format(question.vertices)} vertices${alike}`;
  return `${at.previewing ? "Preview" : "Answered"}: ${partName(question)}: ${answerText(answer)}${alike}`;
}

/** @param {number} [focus] a part, see Questions.show() */
export function listQuestions(focus) {
  const { answers } = at.character.source;
  const list = at.character.result?.questions ?? [];
  at.questions.show({ questions: list, answers, joints: at.character.joints, focus });
  $("questions-count").textContent = at.character.result ? `${list.length} open${answers.length ? `, ${answers.length} answered` : ""}` : "";
  $("next-question").disabled = list.length === 0;
  $("next-question").textContent = list.length === 0 ? "No questions" : "Answer the questions";
  $("style").hidden = !at.style;
  const byStyle = answers.filter((answer) => answer.byStyle).length;
  $("save-style").disabled = !at.character.result || answers.length === byStyle;
  const label = $("style").firstElementChild;
  label.textContent = label.title = at.style ? `${at.style.name}: ${byStyle} answers` : "";
}
