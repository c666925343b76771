// SPDX-License-Identifier: MIT
// What the user does is a command with a name: it runs after those before it, and the history has what came of it. Undo goes back to states.
import { bind } from "./binding.js";
import { restoreRig } from "./editing.js";
import { History } from "./history.js";
import { clearError, run } from "./jobs.js";
import { autosave } from "./autosave.js";
import { poseChanged, sendPose, showPose } from "./showing.js";
import { $, at, engine } from "./state.js";

let lastKept = 0;

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
  };
}

// The module's part of the present state gets a number of its own where it has changed.
export function rigChanged() {
  if (at.character) at.character.source.kept = 0;
}
function keepRig() {
  const { source } = at.character;
  if (source.kept) return;
  source.kept = ++lastKept;
  engine.call("keep", { number: source.kept }).catch(() => {}); // in the order of the calls
}

// What was done is a step of the history from now on. goesOn: see History.add().
export function record(name, { goesOn = false } = {}) {
  if (!at.character?.result) return;
  const { source } = at.character;
  keepRig();
  const state = capture();
  if (!source.history) source.history = new History(state);
  else if (name === "" || isSame(state, source.history.now)) source.history.replace(state);
  else {
    source.history.add(name, state, { goesOn });
    at.changed = true;
  }
  showHistory();
  autosave();
}

const isSame = (a, b) =>
  Object.keys(a).every((key) => key === "kept" || a[key] === b[key] || (key === "options" && JSON.stringify(a[key]) === JSON.stringify(b[key])) || (key === "pose" && a.pose.length === b.pose.length && a.pose.every((x, i) => x === b.pose[i]))) &&
  a.kept === b.kept;

// A command that needs the engine. name: of its step, or a function that says it afterwards.
export const act = (name, job) =>
  run(async () => {
    clearError();
    await job();
    record(typeof name === "function" ? name() : name);
  });

export function undo(forward) {
  if (at.view.dragging || at.character === null) return undefined;
  return run(async () => {
    clearError();
    const { source } = at.character;
    const before = source.history?.now;
    const state = forward ? source.history?.redo() : source.history?.undo();
    if (!state) return;
    try {
      await restore(state, before);
    } finally {
      showHistory();
      autosave();
    }
  });
}

// The open character as it was in that state. before: what it is now; null where the module has it from its file alone.
export async function restore(state, before) {
  const { source } = at.character;
  const sameRig = before !== null && state.kept === before.kept && state.epoch === before.epoch;
  at.options.values = state.options;
  $("up").value = String(state.up);
  const { never, always, locked, answers, style, motion } = state;
  if (!sameRig) await restoreRig(state);
  Object.assign(source, { never, always, locked, answers, style, motion, kept: state.epoch === engine.epoch ? state.kept : 0 });
  if (state.pose.length === at.pose.turns.length) at.pose.turns.set(state.pose);
  const onlyPosed = sameRig && ["never", "always", "locked", "answers", "motion", "up"].every((key) => state[key] === before[key]) && JSON.stringify(state.options) === JSON.stringify(before.options);
  if (onlyPosed) {
    showPose();
    await sendPose();
  } else {
    await bind();
    showPose();
  }
  keepRig();
  source.history?.replace({ ...state, kept: source.kept, epoch: engine.epoch });
}

export function showHistory() {
  const history = at.character?.source.history;
  const { undoName = "", redoName = "" } = history ?? {};
  for (const [id, name, word, keys] of [["undo", undoName, "Undo", "Ctrl+Z"], ["redo", redoName, "Redo", "Ctrl+Y"]]) {
    $(id).disabled = name === "";
    $(id).title = name === "" ? `Nothing to ${word.toLowerCase()} (${keys})` : `${word}: ${name} (${keys})`;
    $(id).ariaLabel = name === "" ? word : `${word}: ${name}`;
  }
}

// After a change of the pose: shown at once, a step of the history.
export function posed(name, goesOn = false) {
  poseChanged();
  record(name, { goesOn });
}
