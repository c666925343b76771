// SPDX-License-Identifier: MIT
// Work is kept in the browser's own database a moment after every step, and offered when the page is opened again.
import { at } from "./state.js";
import { filesOf, projectOf } from "./project.js";

const delay = 700; // milliseconds after a step

const mostKept = 8;

// Stores: "kept" has {id, name, time, text, picture} of each character that was worked on, "files" those that it needs.
function database() {
  return new Promise((resolve, reject) => {
    const opening = indexedDB.open("sinew", 2);
    opening.onupgradeneeded = () => {
      const { result: db } = opening;
      db.createObjectStore("kept", { keyPath: "id" });
      db.createObjectStore("files");
      if (db.objectStoreNames.contains("work")) db.deleteObjectStore("work");
    };
    opening.onsuccess = () => resolve(opening.result);
    opening.onerror = () => reject(opening.error);
  });
}

// use: puts and asks; what it gives back are requests, whose results are the reply.
/** @param {IDBTransactionMode} mode @param {(stores: { kept: IDBObjectStore, files: IDBObjectStore }) => (IDBRequest | undefined)[]} use */
async function transact(mode, use) {
  const opened = await database();
  try {
    return await new Promise((resolve, reject) => {
      const doing = opened.transaction(["kept", "files"], mode);
      const asked = use({ kept: doing.objectStore("kept"), files: doing.objectStore("files") });
      doing.oncomplete = () => resolve(asked.map((one) => one?.result));
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
  const { files, beside } = source.document;
  const project = projectOf(character, state, await state.rows, beside);
  return { project, files: filesOf(project).flatMap((name) => files.get(name) ?? []) };
}

/** @type {any} */
let timer = 0;
let saving = Promise.resolve();

export function autosave() {
  clearTimeout(timer);
  timer = setTimeout(saveSoon, delay);
}
function saveSoon() {
  clearTimeout(timer);
  timer = 0;
  saving = saving.then(saveNow).catch(() => {}); // a full disk, a private window: the page warns before it is left anyway
  return saving;
}
// What waits to be kept is kept at once: another character takes the module.
export const saveWork = () => (timer === 0 ? saving : saveSoon());
export const autosaved = async () => {
  while (timer !== 0) await new Promise((resolve) => setTimeout(resolve, 20));
  await saving;
};

// Each document of a window has a number of its own, which no other window writes while this one is open.
/** @param {string} id @returns {Promise<boolean>} whether it is this window's now */
export function claim(id) {
  if (!navigator.locks) return Promise.resolve(true); // a page that is not secure
  return new Promise((resolve) => {
    navigator.locks.request(`sinew ${id}`, { ifAvailable: true }, (lock) => {
      resolve(lock !== null);
      return lock ? new Promise(() => {}) : undefined; // until the window is closed
    });
  });
}
const newId = () => `${Date.now().toString(36)}-${Math.random().toString(36).slice(2)}`;

async function saveNow() {
  if (!at.character?.result || !at.character.source.history?.undoName) return; // nothing was done yet
  const { source, name } = at.character;
  const { project, files } = await presentProject();
  if (!source.id) {
    source.id = newId();
    await claim(source.id);
  }
  const { id } = source;
  const isOf = files.map(({ name: file, size, lastModified }) => `${file} ${size} ${lastModified}`).join("\n");
  const picture = at.view.thumbnail();
  const known = await keptWork(), old = known.filter((one) => one.id !== id).slice(mostKept - 1);
  await transact("readwrite", ({ kept, files: store }) => {
    for (const one of old) for (const of of [kept, store]) of.delete(one.id);
    if (isOf !== source.keptWith || !known.some((one) => one.id === id)) store.put(files, id);
    kept.put({ id, name, time: Date.now(), text: JSON.stringify(project), picture });
    return [];
  });
  source.keptWith = isOf;
}

// {id, name, time, text, picture} of what was worked on, the last first.
/** @returns {Promise<import("./types.js").Kept[]>} */
export async function keptWork() {
  try {
    const [all] = await transact("readonly", ({ kept }) => [kept.getAll()]);
    return all.sort((/** @type {any} */ a, /** @type {any} */ b) => b.time - a.time);
  } catch {
    return [];
  }
}

/** @param {string} id @returns {Promise<File[]>} */
export const keptFiles = async (id) => (await transact("readonly", ({ files }) => [files.get(id)]))[0] ?? [];

/** @param {string} [id] without: all of it */
export async function forgetWork(id) {
  await transact("readwrite", ({ kept, files }) => [kept, files].map((store) => (id ? store.delete(id) : store.clear()))).catch(() => {});
}

// The browser asks before a page is left whose work no file has.
export const warnBeforeLeaving = () =>
  addEventListener("beforeunload", (event) => {
    if (at.open.some(({ changed }) => changed)) event.preventDefault();
  });
