// SPDX-License-Identifier: MIT
// Files that were dropped together: each such document has a folder of its own in the module, so that another one's files of the same names are not its.
import { engine } from "./state.js";

/** @typedef {import("./types.js").Document} Document */

let lastFolder = 0;

/** @type {() => Document} */
export const newDocument = () => ({ folder: ++lastFolder, files: new Map(), beside: [] });

// Files for the module and for the page, which writes them again for a project or another worker.
/** @param {Iterable<File>} list @param {Document} document */
export async function giveFiles(list, { folder, files: known }) {
  const files = await Promise.all([...list].map(async (file) => (known.set(file.name, file), { name: file.name, bytes: await file.arrayBuffer() })));
  await engine.call("write", { files, folder }, files.map(({ bytes }) => bytes));
}

/** @param {Document[]} documents @param {number[]} [numbers] of characters */
export const forgetDocuments = (documents, numbers = []) => engine.call("remove", { folders: [...new Set(documents.map(({ folder }) => folder))], numbers });
