// SPDX-License-Identifier: MIT
// Findings of sinew check as a list; a click brings the place into view.
import { run, whileBusy } from "./jobs.js";
import { choose } from "./showing.js";
import { $, at, engine } from "./state.js";

/** @type {object | null} */
let checked = null; // the result that the list is of

async function check() {
  const { result } = at.character ?? {};
  if (!result || checked === result) return;
  const { findings } = await whileBusy("Checking the rig", () => engine.call("check"));
  checked = result;
  $("check-said").textContent = findings.length === 0 ? "no problems" : `${findings.length} found`;
  $("findings").replaceChildren(...findings.map(item));
}

/** @param {{ severity: string, what: string, cure: string, joint: number }} finding */
function item({ severity, what, cure, joint }) {
  const li = document.createElement("li");
  const button = Object.assign(document.createElement("button"), { type: "button", title: cure });
  button.append(Object.assign(document.createElement("b"), { textContent: severity }), what);
  button.onclick = () => {
    if (joint < 0) return at.view.frame();
    choose(joint);
    at.view.lookAtJoints([joint]);
  };
  li.append(button);
  return li;
}

export function listenForChecks() {
  $("checking").ontoggle = () => $("checking").open && run(check);
}
