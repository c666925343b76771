// SPDX-License-Identifier: MIT
// Models: of the page's own folder, and the user's.
import { fromPlanes } from "./planes.js";
import { at, engine, models } from "./state.js";

// A model of weights, of skeletons or of hands.
/** @param {string} name */
export async function useModel(name) {
  const { task, ...model } = await engine.call("model", { name });
  models[task] = { name, ...model };
}

/** @param {string} name */
export async function fetchModel(name) {
  const unpacks = typeof DecompressionStream !== "undefined"; // older browsers take the model as it is
  const address = unpacks ? `${name}.packed` : name;
  const response = await fetch(address);
  if (!response.ok || !response.body) throw new Error(`${address}: ${response.status} ${response.statusText}; build the page with samples/web/build.sh`);
  const whole = unpacks ? new Response(response.body.pipeThrough(new DecompressionStream("gzip"))) : response;
  const bytes = new Uint8Array(await whole.arrayBuffer());
  const model = (unpacks ? fromPlanes(bytes) : bytes).buffer;
  at.modelFiles = [...at.modelFiles.filter((file) => file.name !== name), new File([model], name)];
  await engine.call("write", { files: [{ name, bytes: model }] }, [model]);
  await useModel(name);
}
