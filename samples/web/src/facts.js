// SPDX-License-Identifier: MIT
// The line at the bottom: the character, its bind, models, engine and the result's hash.

export const number = new Intl.NumberFormat("en");
/** @type {(n: number) => string} */
const bytes = (n) => (n < 1e6 ? `${(n / 1e3).toFixed(1)} kB` : `${(n / 1e6).toFixed(2)} MB`);
/** @type {(s: number) => string} */
const milliseconds = (s) => (s < 10 ? `${number.format(Math.round(s * 1e3))} ms` : `${s.toFixed(1)} s`);

/** @param {string} label @param {string} value */
function part(label, value, title = "", tag = "b") {
  const one = document.createElement("span");
  one.title = title;
  one.append(label, Object.assign(document.createElement(tag), { textContent: value }));
  return one;
}

/** @param {any} character @param {any} result */
function* ofCharacter(character, result) {
  yield part("", character.name);
  yield part("", `${number.format(character.vertices)} vertices, ${number.format(character.faces)} faces, ${number.format(character.joints.length)} bones`);
  if (result) {
    yield part("bound in ", milliseconds(result.seconds), `${milliseconds(result.wallSeconds)} with the way to the worker and back; ${bytes(result.usedBytes)} of memory`);
    yield part("look first at ", `${number.format(result.lookFirst)} vertices`, `The least sure tenth, ${Math.round(100 * result.lookFirstSure)} % sure on average; Doubt shows them`);
    if (result.leftOut.length) yield part("no weight for ", `${result.leftOut.length} bones`, result.leftOut.join("\n"));
    if (result.lockedVertices) yield part("locked ", `${number.format(result.lockedVertices)} vertices`, "They keep their weights; L on their joint frees them");
    if (result.grownTogether) yield part("grown together ", "parts", result.grownTogether);
    if (result.keptMeshes) yield part("kept ", `${result.keptMeshes} attached meshes`, "They follow the joints that they hang on");
  } else {
    yield part("", character.joints.length === 0 ? "without a skeleton…" : "binding…");
  }
  if (!character.predicted) return;
  const doubt = `The votes say of themselves that they are ${(100 * character.spread).toFixed(1)} % of the longest side off, in the mean`;
  yield part("skeleton in ", milliseconds(character.seconds), doubt);
}

// models: those that were used, {name, bytes, parameters, layers}.
/** @param {{ name: string, bytes: number, parameters: number, layers: number }[]} models */
function ofModels(models) {
  const about = (/** @type {{ name: string, parameters: number, layers: number }} */ { name, parameters, layers }) => `${name}: ${number.format(parameters)} int16 parameters in ${layers} layers`;
  return part(models.length > 1 ? "models " : "model ", models.map((model) => bytes(model.bytes)).join(", "), models.map(about).join("\n"));
}

// engine: {kernel, version, moduleBytes}; models: by their task; result: what the line says of the bind, null while there is none.
/** @param {{ character: any, result: any, engine: any, models: any }} of */
export function factsOf({ character, result, engine, models }) {
  const parts = character ? [...ofCharacter(character, result)] : [];
  const used = [models.weights, ...(character?.predicted ? [models.skeletons, models.hands] : [])].filter(Boolean);
  if (used.length > 0) parts.push(ofModels(used));
  if (engine.kernel) parts.push(part("engine ", `${bytes(engine.moduleBytes)}, ${engine.kernel === "ref" ? "without SIMD" : "SIMD"}`, `sinew ${engine.version} as WebAssembly, with readers and writers; kernels ${engine.kernel}`));
  if (result) parts.push(part("result ", result.hash, "Hash of all joints and weights: the same on every machine, compiler and browser", "code"));
  return parts;
}
