// SPDX-License-Identifier: MIT
// A question of the page in the picture, with a button for each answer; Escape or another character closes it.
import { $ } from "./state.js";

export function closeOffer() {
  const wasOpen = !$("offer").hidden;
  $("offer").hidden = true;
  return wasOpen;
}

/** @param {string} words @param {Record<string, () => any>} answers by what their buttons say */
export function offer(words, answers) {
  $("offer-said").textContent = words;
  $("offer-answers").replaceChildren(
    ...Object.entries(answers).map(([text, act]) => Object.assign(document.createElement("button"), { type: "button", textContent: text, onclick: () => (closeOffer(), act()) })),
  );
  $("offer").hidden = false;
}
