// SPDX-License-Identifier: MIT
// Clips that ship: builtin:NAME, which finds the kind of body by itself; and which of them are for a body.
/** @typedef {{ name: string }} Joint */

export const shipped = ["walk", "run", "idle", "wave", "jump", "sit", "squat", "reach", "trot", "gallop", "flap", "strut", "flutter", "crawl", "swim", "hover"];

const legs = /leg|thigh|shin|knee|foot|hoof|paw/i, wings = /wing/i;
/** @type {(joints: Joint[]) => boolean} */
export const hasLegs = (joints) => joints.some(({ name }) => legs.test(name));
/** @type {(joints: Joint[]) => boolean} */
export const hasWings = (joints) => joints.some(({ name }) => wings.test(name));

// Those that show how such a body gets about, the likeliest first.
/** @type {(joints: Joint[]) => string[]} */
export function gaitsOf(joints) {
  const first = !hasLegs(joints) ? "swim" : hasWings(joints) ? "strut" : "walk";
  return [...new Set([first, "walk", "crawl", "swim"])];
}

// Whether a clip is for the body that it moves, by what was said when it was retargeted. Fish keep their heads still, and birds their wings.
/** @type {(notes: string[]) => boolean} */
export const isForThisBody = (notes) => !notes.some((note) => /does not fit|the motion is that of|(torso|legs?|arms?) do(es)? not move/.test(note));
