// SPDX-License-Identifier: MIT
// Models: of the page's own folder, and the user's.
import { fetchPacked } from "./packed.js";
import { at, engine, models } from "./state.js";

// A model of weights, of skeletons or of hands.
/** @param {string} name */
export async function useModel(name) {
  const { task, ...model } = await engine.call("model", { name });
  models[task] = { name, ...model };
}

/** @param {string} name */
export async function fetchModel(name) {
  const model = (await fetchPacked(name)).buffer;
  at.modelFiles = [...at.modelFiles.filter((file) => file.name !== name), new File([model], name)];
  await engine.call("write", { files: [{ name, bytes: model }] }, [model]);
  await useModel(name);
}
