// SPDX-License-Identifier: MIT
// The character as a whole: quarter turns, height, floor, as `sinew rig --turn --height --floor` has them, and the front. What was asked for is the
// character's source.placement: {turns, height, floor}; joints, markers and weights begin anew from it.
import { bind } from "./binding.js";
import { act } from "./acting.js";
import { restore } from "./commands.js";
import { angleOf, frontAt, frontFound, PlacementDial, quarterOf } from "./dial.js";
import { predict } from "./editing.js";
import { loadPlaced } from "./opened.js";
import { showPlacement } from "./showing.js";
import { historyOf } from "./recording.js";
import { $, at } from "./state.js";

// The turn that tips the top toward that side of the picture, by upAxis.
/** @type {Record<string, string[]>} */
const tips = { near: ["x", "x"], away: ["-x", "-x"], left: ["z", "-y"], right: ["-z", "y"] };
/** @type {(turn: string) => string} */
const opposite = (turn) => (turn.startsWith("-") ? turn.slice(1) : `-${turn}`);

// With one quarter more; two that are each other's opposite are none, four of a kind neither.
/** @param {string[]} turns @param {string} turn */
export function turned(turns, turn) {
  if (turns.at(-1) === opposite(turn)) return turns.slice(0, -1);
  const all = [...turns, turn];
  return all.length >= 4 && all.slice(-4).every((one) => one === turn) ? all.slice(0, -4) : all;
}

// What is up is settled with it: it is what the picture shows. front: sinew_front that holds then, where it is another.
/** @param {string} name @param {(now: import("./types.js").Placement) => Partial<import("./types.js").Placement>} change @param {number} [front] */
function place(name, change, front) {
  const { character } = at;
  if (!character?.placeable) return undefined;
  return act(name, async () => {
    const { source } = character;
    const { now } = historyOf(source);
    const wasPredicted = character.predicted;
    try {
      character.up = character.upAxis;
      $("up").value = String(character.up);
      if (front !== undefined) $("front").value = String(front);
      await loadPlaced({ ...source.placement, ...change(source.placement) });
      source.markers = [];
      source.recipe = { wishes: null, edits: [] };
      if (wasPredicted || at.character.joints.length === 0) await predict();
      await bind();
    } catch (error) {
      await restore(now, { ...now, placement: null }); // anew, whatever of it was done
      throw error;
    }
  });
}

const turns = (/** @type {string[]} */ list) => (/** @type {import("./types.js").Placement} */ now) => ({ turns: list.reduce(turned, now.turns) });

// The front comes toward who looks at the picture.
function faceViewer() {
  const { upAxis } = at.character, axis = upAxis === 1 ? "z" : "y";
  const found = frontFound(at.character, 0);
  const list = found ? [[], [`-${axis}`], [axis, axis], [axis]][quarterOf(angleOf(found.front, upAxis))] : [];
  return place("face the viewer", turns(list), at.character.predicted ? frontAt(0, upAxis) : undefined);
}

/** @param {number} front sinew_front */
export function setFront(front) {
  $("front").value = String(front);
  $("front").dispatchEvent(new Event("change"));
}

export function listenForPlacement() {
  at.dial = new PlacementDial();
  at.dial.onFront = setFront;
  for (const [side, by] of Object.entries(tips)) $(`tip-${side}`).onclick = () => place("tip over", turns([by[at.character.upAxis]]), 0);
  $("face-viewer").onclick = faceViewer;
  $("floor").onchange = () => place("floor", () => ({ floor: $("floor").checked }));
  $("height").onchange = () => {
    const height = $("height").valueAsNumber;
    if (height > 0) place("height", () => ({ height }));
    else showPlacement();
  };
}
