// SPDX-License-Identifier: MIT
// Undo and redo: the open character as it was in a state of its history.
import { autosave } from "./autosave.js";
import { bind } from "./binding.js";
import { restoreRig } from "./editing.js";
import { clearError, run } from "./jobs.js";
import { loadDrawn, loadPlaced } from "./opened.js";
import { showMarkers } from "./markers.js";
import { keepRig, showHistory } from "./recording.js";
import { sendPose, showPose } from "./showing.js";
import { $, at, engine } from "./state.js";

/** @param {boolean} forward */
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
      source.changed = Boolean(source.history?.undoName);
      showHistory();
      autosave();
    }
  });
}

// The open character as it was in that state. before: what it is now; null where the module has it from its file alone.
/**
 * @param {import("./types.js").State} state
 * @param {any} before a state with what may differ
 */
export async function restore(state, before) {
  const { source } = at.character;
  const isLost = state.epoch !== engine.epoch, { recipe } = state; // the module that knew it is gone
  const rows = isLost ? await state.rows : null;
  const sameRig = before !== null && state.placement === before.placement && state.pictureWishes === before.pictureWishes && state.kept === before.kept && state.epoch === before.epoch;
  at.options.values = state.options;
  $("up").value = String(state.up);
  const isOfFile = Boolean(isLost && !recipe.wishes && before?.recipe.wishes); // its skeleton is the file's
  if (before && (isOfFile || JSON.stringify(state.placement) !== JSON.stringify(before.placement))) await loadPlaced(state.placement, isOfFile);
  if (before && state.pictureWishes !== before.pictureWishes) await loadDrawn(state.pictureWishes);
  const { never, always, answers, style, motion, springs, markers } = state;
  const locked = isLost && !rows ? new Set() : state.locked;
  if (!sameRig) await restoreRig(state);
  Object.assign(source, { never, always, locked, answers, style, motion, springs, markers, kept: state.epoch === engine.epoch ? state.kept : 0 });
  if (state.pose.length === at.pose.turns.length) at.pose.turns.set(state.pose);
  const onlyPosed = sameRig && /** @type {const} */ (["never", "always", "locked", "answers", "motion", "up"]).every((key) => state[key] === before[key]) && JSON.stringify(state.options) === JSON.stringify(before.options);
  if (onlyPosed) {
    await at.springs.again();
    showPose();
    await sendPose();
  } else {
    await bind();
    if (rows) {
      await engine.call("putRows", { rows });
      await bind();
    }
    showPose();
  }
  showMarkers();
  keepRig();
  source.history?.replace({ ...state, locked, rows: source.rows, kept: source.kept, epoch: engine.epoch });
}
