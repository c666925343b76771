// SPDX-License-Identifier: MIT
// Models: of the page's own folder, and the user's.
import { fetchPacked } from "./packed.js";
import { at, engine, models } from "./state.js";

// A model of weights, of skeletons or of hands.
/** @param {string} name @param {number} [folder] that it lies in */
export async function useModel(name, folder) {
  const { task, ...model } = await engine.call("model", { name, folder });
  models[task] = { name, ...model };
}

// Words of 16 bits, whose low bytes come first in the file.
/** @param {Uint8Array} planes */
const wordsOf = (planes) => Uint16Array.from({ length: planes.length >> 1 }, (_, i) => planes[i] | (planes[(planes.length >> 1) + i] << 8));

/** @param {string} name */
export async function fetchModel(name) {
  const model = wordsOf(await fetchPacked(name)).buffer;
  at.modelFiles = [...at.modelFiles.filter((file) => file.name !== name), new File([model], name)];
  await engine.call("write", { files: [{ name, bytes: model }] }, [model]);
  await useModel(name);
}
