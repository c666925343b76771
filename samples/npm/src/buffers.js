// SPDX-License-Identifier: MIT
// Rows of weights as other engines' vertex buffers have them.
import { SinewError } from "./memory.js";

/** @typedef {{ joints: any, weights: any, influenceCount: number }} Rows */
/** @type {(bound: Rows) => number} */
const unit = (bound) => (bound.weights instanceof Uint16Array ? 65535 : 1);

/** @param {Rows} bound @param {number} from @param {number} count @param {any} type of the array @param {(i: number) => number} of */
function slots(bound, from, count, type, of) {
  const { influenceCount } = bound;
  const vertexCount = bound.joints.length / influenceCount;
  const out = new type(vertexCount * count);
  for (let v = 0; v < vertexCount; ++v)
    for (let i = 0; i < count && from + i < influenceCount; ++i) out[v * count + i] = of(v * influenceCount + from + i);
  return out;
}

/**
 * For Babylon.js' VertexData: matricesIndices and matricesWeights of four influences a vertex; the ...Extra pair has the
 * fifth to eighth where there are more.
 * @param {Rows} bound
 */
export function babylonBuffers(bound) {
  if (bound.influenceCount > 8) throw new SinewError(`babylonBuffers: expected at most 8 influences a vertex, found ${bound.influenceCount}`);
  const of = (/** @type {number} */ from) => [
    slots(bound, from, 4, Float32Array, (/** @type {number} */ i) => bound.joints[i]),
    slots(bound, from, 4, Float32Array, (/** @type {number} */ i) => bound.weights[i] / unit(bound)),
  ];
  const [matricesIndices, matricesWeights] = of(0);
  if (bound.influenceCount <= 4) return { matricesIndices, matricesWeights, numBoneInfluencers: 4 };
  const [matricesIndicesExtra, matricesWeightsExtra] = of(4);
  return { matricesIndices, matricesWeights, matricesIndicesExtra, matricesWeightsExtra, numBoneInfluencers: bound.influenceCount };
}

/**
 * For PlayCanvas' Mesh.setVertexStream(): blendIndices for SEMANTIC_BLENDINDICES (4 of TYPE_UINT8, or TYPE_UINT16 where
 * a joint's number is above 255), blendWeights for SEMANTIC_BLENDWEIGHT (4 of TYPE_FLOAT32).
 * @param {Rows} bound
 */
export function playcanvasBuffers(bound) {
  if (bound.influenceCount > 4) throw new SinewError(`playcanvasBuffers: expected at most 4 influences a vertex, found ${bound.influenceCount}`);
  const type = bound.joints.some((/** @type {number} */ joint) => joint > 255) ? Uint16Array : Uint8Array;
  return {
    blendIndices: slots(bound, 0, 4, type, (/** @type {number} */ i) => bound.joints[i]),
    blendWeights: slots(bound, 0, 4, Float32Array, (/** @type {number} */ i) => bound.weights[i] / unit(bound)),
  };
}
