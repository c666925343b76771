// SPDX-License-Identifier: MIT
// The module's memory as the calls of engine.js use it: blocks that are freed together, arrays and structs in them.
import { LAYOUTS } from "./layouts.js";

// How a DataView reads and writes the types of LAYOUTS, and their bytes.
/** @type {Record<string, any[]>} */
const MEMBER_TYPES = {
  i8: ["getInt8", "setInt8", 1], u8: ["getUint8", "setUint8", 1], i16: ["getInt16", "setInt16", 2], u16: ["getUint16", "setUint16", 2],
  i32: ["getInt32", "setInt32", 4], u32: ["getUint32", "setUint32", 4], i64: ["getBigInt64", "setBigInt64", 8],
  u64: ["getBigUint64", "setBigUint64", 8], f32: ["getFloat32", "setFloat32", 4], f64: ["getFloat64", "setFloat64", 8],
};

/** What the engine refuses, or an argument of the wrong shape. `status` is the engine's number, 0 for the latter. */
export class SinewError extends Error {
  /** @param {string} message */
  constructor(message, status = 0) {
    super(message);
    this.name = "SinewError";
    this.status = status;
  }
}

/** Blocks of the module's memory that one call needs, or that belong to one object: free() gives them back together. */
export class Blocks {
  #wasm;
  /** @type {number[]} */
  #addresses = [];

  /** @param {any} wasm the exports */
  constructor(wasm) {
    this.#wasm = wasm;
  }

  // Views must be made anew after every allocation and call: the memory moves when it grows.
  /** @param {any} type @param {number} address @param {number} length @returns {any} */
  view(type, address, length) {
    return new type(this.#wasm.memory.buffer, address, length);
  }

  /**
   * Address of `size` bytes, of unknown content, aligned to `alignment`.
   * @param {number} size
   */
  bytes(size, alignment = 8) {
    const address = this.#wasm.malloc(size + alignment) >>> 0;
    if (address === 0)
      throw new SinewError(`no memory for ${Math.ceil(size / 1e6)} MB in one piece; WebAssembly has at most 4 GB`);
    this.#addresses.push(address);
    return Math.ceil(address / alignment) * alignment;
  }

  /**
   * Address of a zeroed array.
   * @param {any} type
   * @param {number} length
   */
  room(type, length) {
    const address = this.bytes(Math.max(length, 1) * type.BYTES_PER_ELEMENT);
    this.view(type, address, length).fill(0);
    return address;
  }

  /**
   * Address of a copy of a typed array; 0 for null.
   * @param {any} array
   */
  copy(array) {
    if (array == null) return 0;
    const address = this.bytes(Math.max(array.byteLength, 1));
    this.view(array.constructor, address, array.length).set(array);
    return address;
  }

  /**
   * Address of texts, each with a 0 behind it, and the addresses of each; zeros inside of a text are left out.
   * @param {string[]} list
   */
  texts(list) {
    const encoded = list.map((text) => new TextEncoder().encode(String(text).replaceAll("\0", "")));
    const address = this.bytes(encoded.reduce((sum, one) => sum + one.length + 1, 0) + 1);
    const each = new Uint32Array(list.length);
    let at = address;
    encoded.forEach((one, i) => {
      each[i] = at;
      const room = this.view(Uint8Array, at, one.length + 1);
      room.set(one);
      room[one.length] = 0;
      at += one.length + 1;
    });
    return { address, each };
  }

  /**
   * Address of a struct of LAYOUTS; members that are not given are 0, struct_size is its size. An array in a struct takes an array.
   * @param {keyof typeof LAYOUTS} name
   * @param {Record<string, any>} members
   */
  struct(name, members = {}) {
    const { size, members: layout } = LAYOUTS[name];
    const address = this.room(Uint8Array, size);
    const view = /** @type {any} */ (new DataView(this.#wasm.memory.buffer, address, size));
    for (const member of layout) {
      const value = member.name === "struct_size" ? size : (members[member.name] ?? 0);
      const [, set, bytes] = MEMBER_TYPES[member.type];
      if (member.count === 0) view[set](member.offset, member.type.endsWith("64") && member.type[0] !== "f" ? BigInt(value) : value, true);
      else if (value !== 0) value.slice(0, member.count).forEach((/** @type {number} */ one, /** @type {number} */ i) => view[set](member.offset + i * bytes, one, true));
    }
    return address;
  }

  /**
   * A struct's members now.
   * @param {keyof typeof LAYOUTS} name
   * @param {number} address
   * @returns {Record<string, any>}
   */
  read(name, address) {
    const { size, members: layout } = LAYOUTS[name];
    const view = /** @type {any} */ (new DataView(this.#wasm.memory.buffer, address, size));
    const one = (/** @type {any} */ member, /** @type {number} */ i) => view[MEMBER_TYPES[member.type][0]](member.offset + i * MEMBER_TYPES[member.type][2], true);
    const all = (/** @type {any} */ member) => (member.count === 0 ? one(member, 0) : Array.from({ length: member.count }, (_, i) => one(member, i)));
    return Object.fromEntries(layout.map((/** @type {any} */ member) => [member.name, all(member)]));
  }

  /**
   * A copy of an array out of the memory.
   * @param {any} type
   * @param {number} address
   * @param {number} length
   * @returns {any}
   */
  take(type, address, length) {
    return this.view(type, address, length).slice();
  }

  /**
   * Text of bytes up to the first 0.
   * @param {number} address
   */
  text(address, limit = 1 << 16) {
    const bytes = this.view(Uint8Array, address, Math.min(limit, this.#wasm.memory.buffer.byteLength - address));
    const end = bytes.indexOf(0);
    return new TextDecoder().decode(bytes.slice(0, end < 0 ? bytes.length : end));
  }

  free() {
    for (const address of this.#addresses) this.#wasm.free(address);
    this.#addresses = [];
  }
}
