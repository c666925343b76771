// SPDX-License-Identifier: MIT
// What was done to the open character becomes a step of its history: states are made here, commands.js goes back to them.
import { autosave } from "./autosave.js";
import { History } from "./history.js";
import { $, at, engine } from "./state.js";

let lastKept = 0;
const kept = new Set(); // numbers that the module knows

// The open character as undo brings it back. Sets and lists in it are never changed, others take their place.
function capture() {
  const { source, up } = at.character;
  return {
    kept: source.kept, epoch: engine.epoch, recipe: source.recipe, up,
    pose: at.pose.turns.slice(),
    options: at.options.values,
    never: source.never, always: source.always, locked: source.locked,
    answers: source.answers, style: source.style ?? null,
    motion: source.motion ?? null,
    springs: source.springs ?? null,
    markers: source.markers,
    placement: source.placement,
    rows: source.rows ?? null,
    pictureWishes: source.pictureWishes,
  };
}

// The module's part of the present state gets a number of its own where it has changed.
export function rigChanged() {
  if (at.character) at.character.source.kept = 0;
}
export function keepRig() {
  const { source } = at.character;
  if (source.kept) return;
  source.kept = ++lastKept;
  kept.add(source.kept);
  engine.call("keep", { number: source.kept }).catch(() => {}); // in the order of the calls
  const { lockedVertices = 0, paintedVertices = 0 } = at.character.result ?? {};
  source.rows = lockedVertices > 0 || paintedVertices > 0 ? engine.call("rows").catch(() => null) : null;
}

/** @param {import("./types.js").Source} source */
export function historyOf({ history }) {
  if (!history) throw new Error("nothing was bound yet");
  return history;
}

// What was done is a step of the history from now on. goesOn: see History.add().
/** @param {string} name @param {{ goesOn?: boolean }} how */
export function record(name, { goesOn = false } = {}) {
  if (!at.character?.result) return;
  const { source } = at.character;
  keepRig();
  const state = capture();
  if (!source.history) source.history = new History(state);
  else if (name === "" || isSame(state, source.history.now)) source.history.replace(state);
  else {
    source.history.add(name, state, { goesOn });
    source.changed = true;
  }
  forgetKept();
  showHistory();
  autosave();
}

// What no history goes back to any more.
function forgetKept() {
  const alive = new Set(at.open.flatMap((source) => [source.kept, ...(source.history?.states.map((state) => state.kept) ?? [])]));
  const gone = [...kept].filter((number) => !alive.has(number));
  for (const number of gone) kept.delete(number);
  if (gone.length > 0) engine.call("drop", { numbers: gone }).catch(() => {});
}

/** @type {(a: any, b: any) => boolean} */
const isSame = (a, b) =>
  Object.keys(a).every((key) => key === "kept" || a[key] === b[key] || (key === "options" && JSON.stringify(a[key]) === JSON.stringify(b[key])) || (key === "pose" && a.pose.length === b.pose.length && a.pose.every((/** @type {number} */ x, /** @type {number} */ i) => x === b.pose[i]))) &&
  a.kept === b.kept;

export function showHistory() {
  const history = at.character?.source.history;
  const { undoName = "", redoName = "" } = history ?? {};
  for (const [id, name, word, keys] of [["undo", undoName, "Undo", "Ctrl+Z"], ["redo", redoName, "Redo", "Ctrl+Y"]]) {
    $(id).disabled = name === "";
    $(id).title = name === "" ? `Nothing to ${word.toLowerCase()} (${keys})` : `${word}: ${name} (${keys})`;
    $(id).ariaLabel = name === "" ? word : `${word}: ${name}`;
  }
}
