// SPDX-License-Identifier: MIT
// Arguments as the engine reads them: typed arrays of the right lengths, or an error that names the argument.
import { SinewError } from "./memory.js";

/** @type {(value: any) => string} */
const found = (value) => (value == null ? String(value) : `${value.constructor?.name ?? typeof value} of ${value.length ?? "no"} elements`);

/**
 * `value` as a typed array, copied only where its type differs. `length`: how many elements it must have, or a text for "any".
 * @param {any} type of the array
 * @param {any} value
 * @param {string} name
 * @param {number} [length]
 * @returns {any}
 */
export function typed(type, value, name, length) {
  if (value == null || typeof value === "string" || typeof value.length !== "number")
    throw new SinewError(`${name}: expected ${type.name} or an array of numbers, found ${value === null ? "null" : typeof value}`);
  if (length !== undefined && value.length !== length) throw new SinewError(`${name}: expected ${length} elements, found ${value.length}`);
  return value.constructor === type ? value : type.from(value);
}

/** @param {any} value @param {string} name @param {number} limit */
function indices(value, name, limit) {
  const array = typed(Uint32Array, value, name);
  for (let i = 0; i < array.length; ++i)
    if (array[i] >= limit) throw new SinewError(`${name}: expected indices below ${limit}, found ${value[i]} at ${i}`);
  return array;
}

/** @param {any} value @param {string} name */
function triples(value, name) {
  const array = typed(Float32Array, value, name);
  if (array.length === 0 || array.length % 3 !== 0)
    throw new SinewError(`${name}: expected three numbers each, at least one triple, found ${found(value)}`);
  return array;
}

/**
 * {positions, indices | faceOffsets and faceVertices} checked, with counts.
 * @param {any} mesh
 */
export function meshOf(mesh, name = "mesh") {
  if (mesh == null) throw new SinewError(`${name}: expected {positions, indices}, found ${mesh}`);
  const positions = triples(mesh.positions, `${name}.positions`);
  const vertexCount = positions.length / 3;
  if (mesh.faceOffsets != null || mesh.faceVertices != null) {
    const faceVertices = indices(mesh.faceVertices, `${name}.faceVertices`, vertexCount);
    const faceOffsets = typed(Uint32Array, mesh.faceOffsets, `${name}.faceOffsets`);
    if (faceOffsets.length === 0 || faceOffsets[faceOffsets.length - 1] !== faceVertices.length)
      throw new SinewError(`${name}.faceOffsets: expected offsets from 0 to ${faceVertices.length}, one more than faces`);
    return { positions, vertexCount, faceOffsets, faceVertices, faceCount: faceOffsets.length - 1, cornerCount: faceVertices.length };
  }
  const faceVertices = indices(mesh.indices ?? new Uint32Array(0), `${name}.indices`, vertexCount);
  if (faceVertices.length % 3 !== 0) throw new SinewError(`${name}.indices: expected three a triangle, found ${faceVertices.length}`);
  return { positions, vertexCount, faceOffsets: null, faceVertices, faceCount: faceVertices.length / 3, cornerCount: faceVertices.length };
}

/**
 * {positions, parents, names?, flags?} checked, with jointCount.
 * @param {any} skeleton
 */
export function skeletonOf(skeleton, name = "skeleton") {
  if (skeleton == null) throw new SinewError(`${name}: expected {positions, parents}, found ${skeleton}`);
  const positions = triples(skeleton.positions, `${name}.positions`);
  const jointCount = positions.length / 3;
  const parents = typed(Int32Array, skeleton.parents, `${name}.parents`, jointCount);
  parents.forEach((/** @type {number} */ parent, /** @type {number} */ joint) => {
    if (parent < -1 || parent >= jointCount)
      throw new SinewError(`${name}.parents: expected -1 or a joint below ${jointCount}, found ${parent} at ${joint}`);
    let up = parent;
    for (let steps = 0; up >= 0 && up < jointCount; up = parents[up])
      if (++steps > jointCount) throw new SinewError(`${name}.parents: expected a tree, found a cycle above joint ${joint}`);
  });
  const flags = skeleton.flags == null ? null : typed(Uint8Array, skeleton.flags, `${name}.flags`, jointCount);
  if (skeleton.names != null && skeleton.names.length !== jointCount)
    throw new SinewError(`${name}.names: expected ${jointCount} names, found ${skeleton.names.length}`);
  return { positions, parents, flags, names: skeleton.names == null ? null : Array.from(skeleton.names), jointCount };
}

/**
 * {joints, weights, influenceCount} checked; weights as unorm16 with full rows, as the engine's poses want them.
 * @param {any} skin
 * @param {number} vertexCount
 * @param {number} jointCount
 */
export function skinOf(skin, vertexCount, jointCount, name = "skin") {
  if (skin == null) throw new SinewError(`${name}: expected {joints, weights, influenceCount}, found ${skin}`);
  const influenceCount = skin.influenceCount ?? 4;
  const joints = typed(Uint16Array, skin.joints, `${name}.joints`, vertexCount * influenceCount);
  const given = typed(skin.weights instanceof Uint16Array ? Uint16Array : Float32Array, skin.weights, `${name}.weights`, joints.length);
  for (let i = 0; i < joints.length; ++i)
    if (joints[i] >= jointCount) throw new SinewError(`${name}.joints: expected joints below ${jointCount}, found ${joints[i]} at ${i}`);
  if (given instanceof Uint16Array) return { joints, weights: given, influenceCount };
  const weights = new Uint16Array(given.length);
  for (let v = 0; v < vertexCount; ++v) {
    const first = v * influenceCount;
    let sum = 0;
    for (let i = first; i < first + influenceCount; ++i) sum += given[i];
    if (!(sum > 0)) continue;
    let left = 65535;
    for (let i = first; i < first + influenceCount; ++i) left -= weights[i] = Math.round((given[i] / sum) * 65535);
    weights[first] += left;
  }
  return { joints, weights, influenceCount };
}

/**
 * The number of a choice by name.
 * @param {any} value
 * @param {string[]} names
 * @param {string} name
 */
export function choice(value, names, name) {
  if (value === undefined) return 0;
  const at = names.indexOf(value);
  if (at < 0) throw new SinewError(`${name}: expected ${names.map((one) => `"${one}"`).join(", ")}, found ${JSON.stringify(value)}`);
  return at;
}
