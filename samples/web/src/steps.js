// SPDX-License-Identifier: MIT
// The five steps of a character: one is worked on at a time, the panel has what it needs and nothing else.
import { autosave } from "./autosave.js";
import { fillClipPictures } from "./clip_pictures.js";
import { colour } from "./colours.js";
import { showDrawing } from "./drawn.js";
import { setEditing, showSkeleton } from "./editing.js";
import { run } from "./jobs.js";
import { closeOffer } from "./offer.js";
import { showSteps } from "./rail.js";
import { sendPose } from "./showing.js";
import { $, all, at, modes } from "./state.js";

// The panel of a step, and what the picture shows for it.
/** @param {string} step @param {{ view?: boolean }} how */
export function setStep(step, { view = true } = {}) {
  at.step = step;
  document.body.dataset.step = step;
  for (const part of all("[data-steps]")) part.classList.toggle("elsewhere", !part.dataset.steps.split(" ").includes(step));
  $("panel").scrollTop = 0;
  showSteps();
  if (!at.character) return;
  if (view) {
    at.modeChosen = false;
    at.mode = step === "weights" || step === "skeleton" ? (at.view.selected >= 0 ? modes.field : modes.joints) : modes.material;
  }
  setEditing(step === "skeleton");
  at.view.frameAgain();
  showDrawing();
  showSkeleton();
  at.onStep();
  fillClipPictures();
  if (step === "motion" && at.character.result) run(() => at.springs.again());
  else at.drag.show();
}

// As the user does it.
/** @param {string} step */
export function goTo(step) {
  if (!at.character) return;
  closeOffer();
  if (step === at.step) return;
  const { source } = at.character;
  source.looked = new Set([...(source.looked ?? []), at.step, step]);
  source.step = step; // a tab that is opened again shows it
  autosave();
  setStep(step);
  run(colour);
  run(sendPose);
}

// The step that a file begins with.
/** @type {(character: { predicted?: boolean, joints: object[] }, moves: boolean) => string} */
export const firstStep = ({ predicted, joints }, moves) => (moves ? "motion" : predicted || joints.length === 0 ? "skeleton" : "weights");
