// SPDX-License-Identifier: MIT
// The list of what was worked on and the browser keeps, with its time and picture: on the first page and in the step Mesh.
import { claim, forgetWork, keptFiles, keptWork } from "./autosave.js";
import { run } from "./jobs.js";
import { openProject } from "./loading.js";
import { all, at } from "./state.js";

/** @type {(time: number) => string} */
function timeText(time) {
  const then = new Date(time), clock = then.toLocaleTimeString("en", { hour: "2-digit", minute: "2-digit", hour12: false });
  return then.toDateString() === new Date().toDateString() ? `today ${clock}` : `${then.toLocaleDateString("en", { day: "numeric", month: "short" })} ${clock}`;
}

/** @param {import("./types.js").Kept} kept */
async function goOn({ id, name, text }) {
  const files = await keptFiles(id);
  await openProject(name, text, files, (await claim(id)) ? id : ""); // another window has it open and goes on keeping it
}

/** @param {import("./types.js").Kept} kept */
function row(kept) {
  const { name, time, picture, id } = kept;
  const li = document.createElement("li");
  const go = Object.assign(document.createElement("button"), { type: "button", className: "go", title: `Resume ${name}`, onclick: () => run(() => goOn(kept)) });
  const words = document.createElement("span");
  words.append(Object.assign(document.createElement("b"), { textContent: `Resume ${name}` }), Object.assign(document.createElement("small"), { textContent: timeText(time) }));
  go.append(Object.assign(document.createElement("img"), { src: picture, alt: "" }), words);
  const forget = Object.assign(document.createElement("button"), { type: "button", className: "forget", textContent: "×", ariaLabel: `Forget ${name}`, title: `Forget ${name}`, onclick: () => run(() => forgetWork(id).then(showKept)) });
  li.append(go, forget);
  return li;
}

// What is open in this window is not in the list.
export async function showKept() {
  const kept = (await keptWork()).filter(({ id }) => !at.open.some((source) => source.id === id));
  for (const part of all("[data-kept]")) {
    part.hidden = kept.length === 0;
    part.querySelector("ul").replaceChildren(...kept.map(row));
  }
}
