// SPDX-License-Identifier: MIT
// Small moving pictures of this character for the clips that ship: made one after another while the step Motion is looked at and nothing else is asked of the page. A clip that is
// for another kind of body has none, and comes last.
import { isStill } from "./elements.js";
import { all, at, engine } from "./state.js";
import { isForThisBody } from "./builtin_clips.js";
import { isBusy } from "./jobs.js";

const frames = 12;
/** @type {import("./types.js").BindResult | null} */
let madeOf = null; // the bind that the pictures show
/** @type {Promise<void> | null} */
let making = null;

const quiet = 500; // milliseconds without keys and pointers
let lastInput = 0;
for (const name of ["pointerdown", "pointermove", "keydown", "wheel"]) addEventListener(name, () => (lastInput = performance.now()), { capture: true, passive: true });

// Nothing else is asked of the engine: pictures wait.
async function untilQuiet() {
  while (performance.now() - lastInput < quiet || at.drag.runs || isBusy()) await new Promise((resolve) => setTimeout(resolve, 100));
}

const isWanted = () => at.step === "motion" && Boolean(at.character?.result) && Boolean(at.view.look) && document.visibilityState === "visible";

/** @param {HTMLElement} button */
async function fill(button) {
  const { clip = "" } = button.dataset, { up } = at.character, { result } = at.character;
  const { notes, poses, seconds } = await engine.call("clipFrames", { name: `builtin:${clip}`, wish: { up, own: false, picture: false, method: 1, pins: [] }, frames: isStill() ? 1 : frames }).catch(() => ({ notes: [], poses: [], seconds: 0 }));
  if (at.character?.result !== result || !at.view.look) return;
  const fits = poses.length > 0 && isForThisBody(notes);
  button.classList.toggle("other", !fits);
  button.title = fits ? "" : "Made for another kind of body";
  const picture = /** @type {HTMLElement} */ (button.firstElementChild);
  picture.style.backgroundImage = fits ? `url(${at.view.pictureOfPoses(poses)})` : "";
  picture.style.animationDuration = `${seconds}s`;
}

/** @param {import("./types.js").BindResult} result */
async function fillAll(result) {
  for (const button of all("#clip-grid button")) {
    await untilQuiet();
    if (!isWanted() || at.character.result !== result) return;
    if (button.dataset.madeOf !== result.hash) await fill(button);
    button.dataset.madeOf = result.hash;
  }
  madeOf = result;
}

// Called where the step, the bind or what is shown has changed.
export function fillClipPictures() {
  const result = at.character?.result;
  if (!isWanted() || !result || madeOf === result) return;
  making ??= fillAll(result).catch(() => {}).finally(() => (making = null)); // a job that is stopped: the next look makes them
}
