// SPDX-License-Identifier: MIT
// One thing after another, errors in a line, files out.
import { $, engine } from "./state.js";

export let queue = Promise.resolve();
// Runs a job after those before it. What it throws is shown, and the page goes on.
export function run(job) {
  const done = queue.then(job);
  queue = done.catch((error) => showError(error.message));
  return queue;
}

export function showError(line) {
  $("error").firstElementChild.textContent = line;
  $("error").hidden = false;
}

export function clearError() {
  $("error").hidden = true;
}

export async function whileBinding(job) {
  engine.onProgress(0);
  $("progress").hidden = false;
  try {
    return await job();
  } finally {
    $("progress").hidden = true;
  }
}

export function save(content, type, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}
