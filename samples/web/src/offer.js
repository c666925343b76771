// SPDX-License-Identifier: MIT
// The bar at the bottom of the picture: what was found or is asked, with a button for each way on. Escape, a command or another character closes it.
import { $, at } from "./state.js";

export function closeOffer() {
  const wasOpen = !$("offer").hidden;
  $("offer").hidden = true;
  if (!wasOpen) return false;
  document.body.classList.remove("revealed");
  at.view.frameAgain();
  return true;
}

// leads: the first answer is the way on.
/** @param {string} words @param {Record<string, () => any>} answers by what their buttons say @param {{ leads?: boolean }} how */
export function offer(words, answers, { leads = false } = {}) {
  $("offer-said").textContent = words;
  $("offer-answers").replaceChildren(
    ...Object.entries(answers).map(([text, act], i) => Object.assign(document.createElement("button"), { type: "button", className: leads && i === 0 ? "primary" : "", textContent: text, onclick: () => (closeOffer(), act()) })),
  );
  $("offer").hidden = false;
  at.view.frameAgain();
}
