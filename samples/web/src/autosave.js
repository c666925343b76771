// SPDX-License-Identifier: MIT
// Work is kept in the browser's own database a moment after every step, and offered when the page is opened again.
import { at, engine } from "./state.js";
import { filesOf, projectOf } from "./project.js";

const delay = 700; // milliseconds after a step

function database() {
  return new Promise((resolve, reject) => {
    const opening = indexedDB.open("sinew", 1);
    opening.onupgradeneeded = () => opening.result.createObjectStore("work");
    opening.onsuccess = () => resolve(opening.result);
    opening.onerror = () => reject(opening.error);
  });
}

/** @param {IDBTransactionMode} mode @param {(store: IDBObjectStore) => any} use */
async function transact(mode, use) {
  const opened = await database();
  try {
    return await new Promise((resolve, reject) => {
      const doing = opened.transaction("work", mode);
      const asked = use(doing.objectStore("work"));
      doing.oncomplete = () => resolve(asked?.result);
      doing.onerror = doing.onabort = () => reject(doing.error);
    });
  } finally {
    opened.close();
  }
}

// The open character as a project, with its files.
export async function presentProject() {
  const { character } = at;
  const { result, source } = character;
  if (!result || !source.history) throw new Error("nothing is bound yet");
  const state = source.history.now;
  const keeps = result.lockedVertices > 0 || result.paintedVertices > 0;
  const rows = keeps ? await engine.call("rows") : null;
  const project = projectOf(character, state, rows, at.beside);
  return { project, files: filesOf(project).flatMap((name) => at.files.get(name) ?? []) };
}

let timer = 0;
let savedFiles = "";
let saving = Promise.resolve();

export function autosave() {
  clearTimeout(timer);
  timer = setTimeout(() => {
    timer = 0;
    saving = saving.then(saveNow).catch(() => {}); // a full disk, a private window: the page warns before it is left anyway
  }, delay);
}
export const autosaved = async () => {
  while (timer !== 0) await new Promise((resolve) => setTimeout(resolve, 20));
  await saving;
};

async function saveNow() {
  if (!at.character?.result || !at.character.source.history?.undoName) return; // nothing was done yet
  const { project, files } = await presentProject();
  const key = files.map(({ name, size, lastModified }) => `${name} ${size} ${lastModified}`).join("\n");
  const isNew = key !== savedFiles;
  await transact("readwrite", (store) => {
    if (isNew) store.put(files, "files");
    store.put({ text: JSON.stringify(project), time: Date.now() }, "last");
  });
  savedFiles = key;
}

// {name, time, text, files} of what was kept last, or null.
export async function lastWork() {
  try {
    const kept = await transact("readonly", (store) => store.get("last"));
    if (!kept) return null;
    const files = await transact("readonly", (store) => store.get("files"));
    return { name: JSON.parse(kept.text).name, ...kept, files: files ?? [] };
  } catch {
    return null;
  }
}

export async function forgetWork() {
  savedFiles = "";
  await transact("readwrite", (store) => store.clear()).catch(() => {});
}

// The browser asks before a page is left whose work no file has.
export const warnBeforeLeaving = () =>
  addEventListener("beforeunload", (event) => {
    if (at.changed) event.preventDefault();
  });
