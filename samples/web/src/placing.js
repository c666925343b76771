// SPDX-License-Identifier: MIT
// The character as a whole: quarter turns, height, floor, as `sinew rig --turn --height --floor` has them. What was asked for is the character's
// source.placement: {turns, height, floor}; joints, markers and weights begin anew from it.
import { bind } from "./binding.js";
import { act } from "./acting.js";
import { restore } from "./commands.js";
import { predict } from "./editing.js";
import { loadPlaced } from "./opened.js";
import { showPlacement } from "./showing.js";
import { historyOf } from "./recording.js";
import { $, at } from "./state.js";

const axes = ["x", "y", "z"];
/** @type {(turn: string) => string} */
const opposite = (turn) => (turn.startsWith("-") ? turn.slice(1) : `-${turn}`);

// With one quarter more; two that are each other's opposite are none, four of a kind neither.
/** @param {string[]} turns @param {string} turn */
export function turned(turns, turn) {
  if (turns.at(-1) === opposite(turn)) return turns.slice(0, -1);
  const all = [...turns, turn];
  return all.length >= 4 && all.slice(-4).every((one) => one === turn) ? all.slice(0, -4) : all;
}

/** @param {string} name @param {(now: import("./types.js").Placement) => Partial<import("./types.js").Placement>} change */
function place(name, change) {
  const { character } = at;
  if (!character?.placeable) return undefined;
  return act(name, async () => {
    const { source } = character;
    const { now } = historyOf(source);
    const wasPredicted = character.predicted;
    try {
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

export function listenForPlacement() {
  for (const axis of axes) $(`turn-by-${axis}`).onclick = (/** @type {MouseEvent} */ event) => place(`rotate around ${axis.toUpperCase()}`, ({ turns }) => ({ turns: turned(turns, event.shiftKey ? `-${axis}` : axis) }));
  $("floor").onchange = () => place("floor", () => ({ floor: $("floor").checked }));
  $("height").onchange = () => {
    const height = $("height").valueAsNumber;
    if (height > 0) place("height", () => ({ height }));
    else showPlacement();
  };
}
