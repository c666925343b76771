// SPDX-License-Identifier: MIT
// A bare mesh becomes a character that walks, before the user's eyes and without a click: its skeleton grows as it is found, its colors rise as it is bound, and it walks. One bar
// says then what was found and leads on. Where the system asks for stillness nothing moves, and only the bar comes.
import { useStyleAnswers } from "./asking.js";
import { bind } from "./binding.js";
import { gaitsOf, hasLegs, hasWings, isForThisBody } from "./builtin_clips.js";
import { colour } from "./colours.js";
import { angleOf, frontAt, isSeenOnEdge, placementDoubts, quarterOf } from "./dial.js";
import { askKind, predict } from "./editing.js";
import { isStill } from "./elements.js";
import { run, whileBusy } from "./jobs.js";
import { offer } from "./offer.js";
import { setFront } from "./placing.js";
import { doubtsOf } from "./rail.js";
import { record } from "./recording.js";
import { counted } from "./sentences.js";
import { nextDoubt } from "./showing.js";
import { $, at, engine, modes } from "./state.js";
import { goTo, setStep } from "./steps.js";

const growing = 800, sweeping = 700; // milliseconds

// The open character with a skeleton and weights.
export async function beginBound() {
  if (at.character.joints.length === 0) await predict();
  await useStyleAnswers();
  await bind();
}

// show: called with shares of 1. A job that is stopped ends it.
/** @param {number} milliseconds @param {(share: number) => void} show @returns {Promise<void>} */
function over(milliseconds, show) {
  const { epoch } = engine, started = performance.now();
  return new Promise((resolve) => {
    const next = () => {
      const share = epoch === engine.epoch ? Math.min(1, (performance.now() - started) / milliseconds) : 1;
      show(share);
      if (share < 1) requestAnimationFrame(next);
      else resolve();
    };
    next();
  });
}

// The first of the clips that ship and that is for this kind of body.
async function walk() {
  for (const clip of gaitsOf(at.character.joints)) {
    await at.motions.open([`builtin:${clip}`]).catch(() => {}); // the next one may fit
    if (at.player.motion && isForThisBody(at.player.fileOfClip.notes)) return;
  }
  await at.motions.close();
}

export async function reveal() {
  if (isStill()) return beginBound();
  document.body.classList.add("revealed");
  try {
    await whileBusy("Finding the bones", async () => {
      at.mode = modes.joints;
      at.view.setRevealed(0, 0);
      import("./look.js"); // shown at the end
      await predict();
      const grown = over(growing, (share) => at.view.setRevealed(share, 0));
      await useStyleAnswers();
      await bind();
      await grown;
      const swept = over(sweeping, (share) => at.view.setRevealed(1, share));
      if ($("offer").hidden) await walk(); // else it is not known what walks
      await swept;
    }, 0);
  } catch (error) {
    document.body.classList.remove("revealed");
    throw error;
  } finally {
    at.view.setRevealed(1, 1);
  }
}

// Once the user has said what the body is.
export const walkOn = () =>
  run(async () => {
    if (!isStill() && !at.player.motion) await walk();
    if (at.player.motion) setStep("motion");
    record("walk");
    await showFound();
  });

// What was found, and the ways on.
export async function showFound() {
  at.mode = modes.material;
  await colour();
  if (at.player.motion) at.player.start();
  if (!$("offer").hidden) return document.body.classList.remove("revealed"); // a question comes first
  if (placementDoubts(at.character).includes("front") && !isSeenOnEdge(at.character)) return askFront();
  showBones();
}

// Left and right may be exchanged: whoever looks at it knows.
function askFront() {
  const { upAxis, front, frontSure } = at.character;
  const quarter = quarterOf(angleOf(front, upAxis));
  const facing = (/** @type {number} */ other) => () => {
    setFront(frontAt((quarter + other) % 4, upAxis));
    at.onKind();
  };
  at.view.frame([0, 0.15, 1]);
  offer(`Is this its front? I am only ${Math.round(100 * frontSure)} % sure, and left and right depend on it.`, {
    Yes: facing(0), "No, its back": facing(2), "No, a side": () => goTo("mesh"),
  });
}

function showBones() {
  const { joints, doubtful, source } = at.character, doubts = doubtsOf();
  const isBird = hasWings(joints) && hasLegs(joints) && !source.recipe.wishes?.category; // taken for one
  const found = `${isBird ? "Taken for a bird. " : ""}${counted(joints.length, "bone")}`;
  const animate = { "Choose animations": () => goTo("motion") };
  const others = { Export: () => goTo("export"), ...(isBird && { "Not a bird": () => askKind("") }) };
  if (doubts.length > 0) offer(`${found}, ${counted(doubts.length, "limb")} to check: ${doubts.map(({ name }) => name).join(", ")}.`, { "Check them": () => (goTo("skeleton"), nextDoubt()), ...animate, ...others }, { leads: true });
  else offer(`${found}, ${doubtful ? "but this mesh is hard to recognize. Check them." : "all sure."}`, { ...animate, "Fix bones": () => goTo("skeleton"), ...others }, { leads: true });
}
