// SPDX-License-Identifier: MIT
// The rail of steps with its ticks, and what the panel says of the present one.
import { placementDoubts } from "./dial.js";
import { chosenProgram } from "./programs.js";
import { $, at } from "./state.js";

export const steps = ["mesh", "skeleton", "weights", "motion", "export"];

/** @type {Record<string, () => string>} */
const sentences = {
  mesh: () => {
    const { vertices, faces, size, picture } = at.character;
    if (picture) return `Drag the points to the edge of the figure: the mesh follows. It has ${count(vertices)} vertices.`;
    return `${count(vertices)} vertices, ${count(faces)} faces, ${size < 10 ? size.toFixed(2) : Math.round(size)} m along the longest side.`;
  },
  skeleton: () => {
    const { joints } = at.character, doubts = doubtsOf();
    return joints.length === 0 ? "No bones yet." : `${joints.length} bones${doubts.length ? `, ${doubts.length} to check: ${doubts.map(({ name }) => name).join(", ")}` : ""}.`;
  },
  weights: () => {
    const { result } = at.character;
    if (!result) return "No weights yet.";
    const parts = result.questions.length;
    return `Weights are ready.${parts ? ` ${parts} part${parts > 1 ? "s" : ""} could follow another bone.` : ""}`;
  },
  motion: () => {
    const clips = at.player.motion?.clips.length ?? 0;
    return clips === 0 ? "No clips yet. Choose one, or drop a motion file." : `${clips} clip${clips > 1 ? "s" : ""}, included in exported files.`;
  },
  export: () => "Choose the program that the file is for.",
};
// What of the skeleton is to be looked at: limbs that may be wrong, and suspects.js.
export const doubtsOf = () => [...(at.character?.doubts ?? []), ...(at.character?.suspects ?? []), ...(at.character?.ears ?? [])];

const count = (/** @type {number} */ n) => n.toLocaleString("en");

// Whether a step has what it is for; what the page found by itself counts once somebody has looked at it.
const isLooked = (/** @type {string} */ step) => Boolean(at.character?.source.looked?.has(step));
/** @type {Record<string, () => boolean>} */
const isDone = {
  mesh: () => Boolean(at.character) && placementDoubts(at.character).length === 0,
  skeleton: () => Boolean(at.character?.joints.length) && doubtsOf().length === 0 && isLooked("skeleton"),
  weights: () => Boolean(at.character?.result) && isLooked("weights"),
  motion: () => Boolean(at.player?.motion),
  export: () => Boolean(at.character?.source.exported),
};

// The button that leads on.
function showOnward() {
  const next = steps[steps.indexOf(at.step) + 1], { kind, name } = chosenProgram();
  $("onward").textContent = next ? `Next: ${next[0].toUpperCase()}${next.slice(1)}` : `Download ${kind.toUpperCase()}${name.startsWith("Any") || kind === "vrm" ? "" : ` for ${name}`}`;
  $("onward").disabled = !at.character || (!next && !at.character.result);
}

// What changed by itself: ticks, sentences, what can be done.
export function showSteps() {
  for (const button of $("rail").children) {
    const { step } = button.dataset;
    const done = isDone[step]();
    button.classList.toggle("done", done);
    button.disabled = !at.character;
    if (step === at.step) button.setAttribute("aria-current", "step");
    else button.removeAttribute("aria-current");
    button.lastElementChild.textContent = done ? "✓" : "";
    button.ariaLabel = `${step[0].toUpperCase()}${step.slice(1)}${done ? ", done" : ""}`;
  }
  $("step-name").textContent = `${at.step[0].toUpperCase()}${at.step.slice(1)}`;
  $("step-said").textContent = at.character ? sentences[at.step]() : "";
  showOnward();
  const doubts = doubtsOf();
  $("next-doubt").disabled = doubts.length === 0;
  $("next-doubt").textContent = doubts.length === 0 ? (at.character?.doubtful ? "Check every bone" : "Nothing to check") : `Check next (${doubts.length} left)`;
}
