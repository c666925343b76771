// SPDX-License-Identifier: MIT
// One thing after another, what is being done and how to stop it, errors in a line, files out.
import { Stopped } from "./engine.js";
import { $, at, engine } from "./state.js";

const saidAfter = 350; // milliseconds: what is done sooner needs no words

/** @type {Promise<any>} */
export let queue = Promise.resolve();
// Runs a job after those before it. What it throws is shown, and the page goes on.
/** @param {() => any} job */
export function run(job) {
  const done = queue.then(job);
  queue = done.catch((/** @type {Error} */ error) => error instanceof Stopped || showError(error.message));
  return queue;
}

/** @param {string} line */
export function showError(line) {
  $("error").firstElementChild.textContent = line;
  $("error").hidden = false;
}

export function clearError() {
  $("error").hidden = true;
}

let doing = 0;
// A long job: its words stand in the picture, with a share where the engine tells one, and Esc stops it.
/**
 * @template Result
 * @param {string} words
 * @param {() => Promise<Result>} job
 * @param {number} [after] milliseconds
 */
export async function whileBusy(words, job, after = saidAfter) {
  engine.onProgress(0);
  $("busy-said").textContent = words;
  $("progress").classList.remove("told");
  const later = setTimeout(() => ($("busy").hidden = false), after);
  ++doing;
  try {
    return await job();
  } finally {
    clearTimeout(later);
    if (--doing === 0) $("busy").hidden = true;
  }
}

export const isBusy = () => !$("busy").hidden;

// Ends the job that runs and those that wait; the character is as its history last had it.
export function stopJobs() {
  if (!isBusy()) return false;
  engine.stop();
  run(at.afterStop);
  return true;
}

let recovers = false;
// The worker is gone: another one is started, with the character as its history last had it. A character that ends that one too is closed.
/** @param {string} cause */
export function recover(cause) {
  if (recovers) at.lastDone = null;
  recovers = true;
  run(async () => {
    await at.afterStop();
    recovers = false;
    showError(`The engine failed (${cause}). ${at.character ? "Your character is as it was before that." : "Open another file."}`);
  });
}

/** @param {BlobPart} content @param {string} type @param {string} name */
export function save(content, type, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}
