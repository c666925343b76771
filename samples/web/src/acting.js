// SPDX-License-Identifier: MIT
// What the user does is a command with a name: it runs after those before it, and the history has what came of it.
import { clearError, run } from "./jobs.js";
import { closeOffer } from "./offer.js";
import { record } from "./recording.js";
import { poseChanged } from "./showing.js";

// A command that needs the engine. name: of its step, or a function that says it afterwards.
/** @type {(name: string | (() => string), job: () => any) => Promise<any>} */
export const act = (name, job) =>
  run(async () => {
    clearError();
    closeOffer();
    await job();
    record(typeof name === "function" ? name() : name);
  });

// After a change of the pose: shown at once, a step of the history.
/**
 * @param {string} name
 * @param {boolean} goesOn
 */
export function posed(name, goesOn = false) {
  poseChanged();
  record(name, { goesOn });
}
