// SPDX-License-Identifier: MIT
// The samples' two text formats, as far as a test needs them, and the hash that the command prints.

/** Vertices and polygons of an OBJ. */
export function readObj(text) {
  const positions = [], faceOffsets = [0], faceVertices = [];
  for (const line of text.split("\n")) {
    const words = line.trim().split(/\s+/);
    if (words[0] === "v") positions.push(...words.slice(1, 4).map(Number));
    if (words[0] !== "f") continue;
    for (const word of words.slice(1)) faceVertices.push(Number(word.split("/")[0]) - 1);
    faceOffsets.push(faceVertices.length);
  }
  return { positions: Float32Array.from(positions), faceOffsets: Uint32Array.from(faceOffsets), faceVertices: Uint32Array.from(faceVertices) };
}

/** Skeleton, and weights where there are some, of a rig.txt. */
export function readRig(text) {
  const names = [], positions = [], pairs = [], rows = new Map();
  for (const line of text.split("\n")) {
    const words = line.trim().split(/\s+/);
    if (words[0] === "joints") {
      names.push(words[1]);
      positions.push(...words.slice(2, 5).map(Number));
    }
    if (words[0] === "hier") pairs.push([words[1], words[2]]);
    if (words[0] === "skin") rows.set(Number(words[1]), words.slice(2));
  }
  const number = new Map(names.map((name, j) => [name, j]));
  const parents = new Int32Array(names.length).fill(-1);
  for (const [parent, child] of pairs) parents[number.get(child)] = number.get(parent);
  const influences = new Map();
  for (const [vertex, words] of rows) {
    const row = [];
    for (let i = 0; i < words.length; i += 2) row.push([number.get(words[i]), Math.round(Number(words[i + 1]) * 65535)]);
    influences.set(vertex, row);
  }
  return { skeleton: { names, positions: Float32Array.from(positions), parents }, influences };
}

/** Triangles of polygons, as fans. */
export function triangles({ faceOffsets, faceVertices }) {
  const out = [];
  for (let f = 0; f + 1 < faceOffsets.length; ++f)
    for (let c = faceOffsets[f] + 2; c < faceOffsets[f + 1]; ++c) out.push(faceVertices[faceOffsets[f]], faceVertices[c - 1], faceVertices[c]);
  return Uint32Array.from(out);
}

/** FNV-1a of joints, then weights of sum 65535: what `sinew bind --json` has as "hash". */
export function bindHash({ joints, weights }) {
  let hash = 1469598103934665603n;
  for (const values of [joints, weights])
    for (const value of values)
      for (const byte of [value & 255, value >> 8]) hash = ((hash ^ BigInt(byte)) * 1099511628211n) & 0xffffffffffffffffn;
  return hash.toString(16).padStart(16, "0");
}
