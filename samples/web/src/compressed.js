// SPDX-License-Identifier: MIT
// Compressed geometry of glTF made plain before the module reads it, by the decoders of Draco and meshoptimizer.
import { fileKind } from "../../npm/src/file_kinds.js";

/** @typedef {{ json: any, bin: Uint8Array | null }} Gltf bin: the chunk of a GLB */

const draco = "KHR_draco_mesh_compression", meshopt = "EXT_meshopt_compression";
const [magic, jsonChunk, binChunk] = [0x46546c67, 0x4e4f534a, 0x004e4942];
/** @type {Record<number, { bytes: number, as: string }>} */
const components = { 5120: { bytes: 1, as: "DT_INT8" }, 5121: { bytes: 1, as: "DT_UINT8" }, 5122: { bytes: 2, as: "DT_INT16" }, 5123: { bytes: 2, as: "DT_UINT16" }, 5125: { bytes: 4, as: "DT_UINT32" }, 5126: { bytes: 4, as: "DT_FLOAT32" } };
/** @type {Record<string, number>} */
const widths = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };

/** @param {Uint8Array} bytes @returns {Gltf | null} null: no glTF */
function parsed(bytes) {
  try {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    if (view.getUint32(0, true) !== magic) return { json: JSON.parse(new TextDecoder().decode(bytes)), bin: null };
    const length = view.getUint32(12, true), json = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length)));
    const at = 20 + length;
    return { json, bin: at + 8 <= bytes.length ? bytes.subarray(at + 8, at + 8 + view.getUint32(at, true)) : new Uint8Array() };
  } catch {
    return null; // the module's reader says what is wrong
  }
}

/** @param {any} json @param {Uint8Array} bin @returns {Uint8Array} a GLB */
function packed(json, bin) {
  const chunks = /** @type {[number, Uint8Array, number][]} */ ([[jsonChunk, new TextEncoder().encode(JSON.stringify(json)), 0x20], [binChunk, bin, 0]]).map(([kind, content, filler]) => {
    const bytes = new Uint8Array(8 + 4 * Math.ceil(content.length / 4)).fill(filler, 8);
    const view = new DataView(bytes.buffer);
    view.setUint32(0, bytes.length - 8, true);
    view.setUint32(4, kind, true);
    bytes.set(content, 8);
    return bytes;
  });
  return joined([new Uint8Array(new Uint32Array([magic, 2, 12 + chunks[0].length + chunks[1].length]).buffer), ...chunks]);
}

/** @param {Uint8Array[]} parts */
function joined(parts) {
  const all = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  parts.reduce((at, part) => (all.set(part, at), at + part.length), 0);
  return all;
}

// Elements of a vertex buffer begin at multiples of four bytes.
/** @param {Uint8Array} bytes @param {number} size of an element */
function padded(bytes, size) {
  const stride = 4 * Math.ceil(size / 4);
  if (stride === size) return { bytes, stride: 0 };
  const all = new Uint8Array((bytes.length / size) * stride);
  for (let i = 0; i * size < bytes.length; ++i) all.set(bytes.subarray(i * size, (i + 1) * size), i * stride);
  return { bytes: all, stride };
}

/** @param {Float32Array} positions */
function boundsOf(positions) {
  const min = [Infinity, Infinity, Infinity], max = [-Infinity, -Infinity, -Infinity];
  positions.forEach((x, i) => {
    min[i % 3] = Math.min(min[i % 3], x);
    max[i % 3] = Math.max(max[i % 3], x);
  });
  return { min, max };
}

// One compressed mesh: {points, indices: [3 x faces], attribute(id, componentType, width): bytes}.
/** @param {any} module Draco's @param {Uint8Array} bytes */
function decoded(module, bytes) {
  const decoder = new module.Decoder(), buffer = new module.DecoderBuffer(), mesh = new module.Mesh();
  buffer.Init(new Int8Array(bytes), bytes.length);
  const status = decoder.DecodeBufferToMesh(buffer, mesh);
  if (!status.ok() || mesh.ptr === 0) throw new Error(status.error_msg());
  /** @type {(size: number, fill: (at: number) => void) => Uint8Array} */
  const filled = (size, fill) => {
    const at = module._malloc(size);
    fill(at);
    const copy = module.HEAPU8.slice(at, at + size);
    module._free(at);
    return copy;
  };
  const indexBytes = 12 * mesh.num_faces();
  return {
    points: mesh.num_points(),
    indices: new Uint32Array(filled(indexBytes, (at) => decoder.GetTrianglesUInt32Array(mesh, indexBytes, at)).buffer),
    /** @param {number} id @param {number} componentType @param {number} width */
    attribute(id, componentType, width) {
      const attribute = decoder.GetAttributeByUniqueId(mesh, id), component = components[componentType];
      if (attribute.ptr === 0 || !component || attribute.num_components() !== width) throw new Error(`attribute ${id} is another one`);
      const size = mesh.num_points() * width * component.bytes;
      return filled(size, (at) => decoder.GetAttributeDataArrayForAllPoints(mesh, attribute, module[component.as], size, at));
    },
    free: () => [mesh, buffer, decoder].forEach((one) => module.destroy(one)),
  };
}

/** @param {any} of @param {string} name */
function removeExtension(of, name) {
  delete of.extensions[name];
  if (Object.keys(of.extensions).length === 0) delete of.extensions;
}

// Primitives of Draco: their values become views of their own.
/** @param {any} module @param {any} json @param {Uint8Array[]} views */
function decodeDraco(module, json, views) {
  const filled = new Set();
  /** @type {(number: number, bytes: Uint8Array, view: object, change: object) => number} the accessor of these values */
  const fill = (number, bytes, view, change) => {
    views.push(bytes);
    json.bufferViews.push(view);
    const made = { ...json.accessors[number], ...change, bufferView: views.length - 1 };
    delete made.byteOffset;
    delete made.sparse;
    if (filled.has(number)) return json.accessors.push(made) - 1; // of another mesh
    filled.add(number);
    json.accessors[number] = made;
    return number;
  };
  for (const primitive of json.meshes.flatMap((/** @type {any} */ mesh) => mesh.primitives)) {
    const compressed = primitive.extensions?.[draco];
    if (!compressed) continue;
    removeExtension(primitive, draco);
    delete primitive.mode; // strips become triangles
    const { attributes } = primitive, names = Object.keys(compressed.attributes).filter((one) => one in attributes).sort();
    if (names.every((one) => json.accessors[attributes[one]].bufferView !== undefined && !filled.has(attributes[one]))) continue; // plain values for readers without Draco
    const mesh = decoded(module, views[compressed.bufferView]);
    for (const one of names) {
      const { componentType, type } = json.accessors[attributes[one]];
      const { bytes, stride } = padded(mesh.attribute(compressed.attributes[one], componentType, widths[type]), widths[type] * components[componentType].bytes);
      attributes[one] = fill(attributes[one], bytes, { ...(stride && { byteStride: stride }), target: 34962 }, { count: mesh.points, ...(one === "POSITION" && componentType === 5126 && boundsOf(new Float32Array(bytes.buffer))) });
    }
    const indices = mesh.points < 65535 ? Uint16Array.from(mesh.indices) : mesh.indices;
    primitive.indices ??= json.accessors.push({ type: "SCALAR" }) - 1;
    primitive.indices = fill(primitive.indices, new Uint8Array(indices.buffer), { target: 34963 }, { componentType: indices.BYTES_PER_ELEMENT === 2 ? 5123 : 5125, count: indices.length });
    mesh.free();
  }
}

// Views of meshoptimizer.
/** @param {any} decoder @param {any} json @param {Uint8Array[]} views @param {(number: number) => Uint8Array} bufferOf */
function decodeMeshopt(decoder, json, views, bufferOf) {
  json.bufferViews.forEach((/** @type {any} */ view, /** @type {number} */ number) => {
    const compressed = view.extensions?.[meshopt];
    if (!compressed) return;
    const { buffer, byteOffset = 0, byteLength, count, byteStride, mode, filter } = compressed;
    views[number] = new Uint8Array(count * byteStride);
    decoder.decodeGltfBuffer(views[number], count, byteStride, bufferOf(buffer).slice(byteOffset, byteOffset + byteLength), mode, filter);
    removeExtension(view, meshopt);
  });
}

// One buffer of the views that something refers to.
/** @param {any} json @param {Uint8Array[]} views */
function gathered(json, views) {
  const users = [...(json.accessors ?? []).flatMap((/** @type {any} */ { sparse }, /** @type {number} */ i) => [json.accessors[i], ...(sparse ? [sparse.indices, sparse.values] : [])]), ...(json.images ?? [])].filter(({ bufferView }) => bufferView !== undefined);
  const used = [...new Set(users.map(({ bufferView }) => bufferView))].sort((a, b) => a - b);
  for (const user of users) user.bufferView = used.indexOf(user.bufferView);
  let length = 0;
  json.bufferViews = used.map((number) => {
    const view = { ...json.bufferViews[number], buffer: 0, byteOffset: length, byteLength: views[number].length };
    length += 8 * Math.ceil(view.byteLength / 8);
    return view;
  });
  json.buffers = [{ byteLength: length }];
  return joined(used.flatMap((number) => [views[number], new Uint8Array((8 - (views[number].length % 8)) % 8)]));
}

// The same file without compression, as GLB; null: it is none that is compressed. decodersFor: gives the decoders that a file needs, of {draco, meshopt}. fileNamed: bytes of a file
// beside it. Throws Error for what the decoders do not read.
/** @param {string} name @param {Uint8Array} bytes @param {(needs: { draco: boolean, meshopt: boolean }) => Promise<{ draco: any, meshopt: any }>} decodersFor @param {(name: string) => Uint8Array} fileNamed @returns {Promise<Uint8Array | null>} */
export async function uncompressed(name, bytes, decodersFor, fileNamed) {
  const file = fileKind(name)?.reader === "gltf" ? parsed(bytes) : null, used = file?.json.extensionsUsed ?? [];
  const needs = { draco: Boolean(used.includes?.(draco)), meshopt: Boolean(used.includes?.(meshopt)) };
  if (!file || (!needs.draco && !needs.meshopt)) return null;
  const { json, bin } = file, decoders = await decodersFor(needs);
  /** @type {Map<number, Uint8Array>} */
  const buffers = new Map();
  /** @type {(number: number) => Uint8Array} */
  const bufferOf = (number) => {
    const { uri } = json.buffers[number];
    if (!buffers.has(number)) buffers.set(number, uri === undefined ? bin ?? new Uint8Array() : uri.startsWith("data:") ? Uint8Array.from(atob(uri.slice(uri.indexOf(",") + 1)), (c) => c.charCodeAt(0)) : fileNamed(decodeURIComponent(uri)));
    return /** @type {Uint8Array} */ (buffers.get(number));
  };
  const views = json.bufferViews.map((/** @type {any} */ { buffer, byteOffset = 0, byteLength, extensions }) => (extensions?.[meshopt] ? new Uint8Array() : bufferOf(buffer).slice(byteOffset, byteOffset + byteLength)));
  if (decoders.meshopt) decodeMeshopt(decoders.meshopt, json, views, bufferOf);
  if (decoders.draco) decodeDraco(decoders.draco, json, views);
  for (const list of ["extensionsUsed", "extensionsRequired"]) {
    const left = (json[list] ?? []).filter((/** @type {string} */ one) => one !== draco && one !== meshopt);
    if (left.length > 0) json[list] = left;
    else delete json[list];
  }
  return packed(json, gathered(json, views));
}
