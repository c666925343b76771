// SPDX-License-Identifier: MIT
// The module's memory as the calls of engine.js use it: blocks that are freed together, arrays and structs in them.
import { LAYOUTS } from "./layouts.js";

/** What the engine refuses, or an argument of the wrong shape. `status` is the engine's number, 0 for the latter. */
export class SinewError extends Error {
  constructor(message, status = 0) {
    super(message);
    this.name = "SinewError";
    this.status = status;
  }
}

/** Blocks of the module's memory that one call needs, or that belong to one object: free() gives them back together. */
export class Blocks {
  #wasm;
  #addresses = [];

  constructor(wasm) {
    this.#wasm = wasm;
  }

  // Views must be made anew after every allocation and call: the memory moves when it grows.
  view(type, address, length) {
    return new type(this.#wasm.memory.buffer, address, length);
  }

  /** Address of `size` bytes, of unknown content, aligned to `alignment`. */
  bytes(size, alignment = 8) {
    const address = this.#wasm.malloc(size + alignment) >>> 0;
    if (address === 0)
      throw new SinewError(`no memory for ${Math.ceil(size / 1e6)} MB in one piece; WebAssembly has at most 4 GB`);
    this.#addresses.push(address);
    return Math.ceil(address / alignment) * alignment;
  }

  /** Address of a zeroed array. */
  room(type, length) {
    const address = this.bytes(Math.max(length, 1) * type.BYTES_PER_ELEMENT);
    this.view(type, address, length).fill(0);
    return address;
  }

  /** Address of a copy of a typed array; 0 for null. */
  copy(array) {
    if (array == null) return 0;
    const address = this.bytes(Math.max(array.byteLength, 1));
    this.view(array.constructor, address, array.length).set(array);
    return address;
  }

  /** Address of texts, each with a 0 behind it, and the addresses of each; zeros inside of a text are left out. */
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

  /** Address of a struct of LAYOUTS; members that are not given are 0, struct_size is its size. */
  struct(name, members = {}) {
    const layout = LAYOUTS[name];
    const address = this.room(Uint32Array, layout.length);
    const words = this.view(Uint32Array, address, layout.length);
    const floats = this.view(Float32Array, address, layout.length);
    layout.forEach((member, i) => {
      const value = member.name === "struct_size" ? 4 * layout.length : (members[member.name] ?? 0);
      if (member.isFloat) floats[i] = value;
      else words[i] = value;
    });
    return address;
  }

  /** A struct's members now. */
  read(name, address) {
    const layout = LAYOUTS[name];
    const words = this.view(Uint32Array, address, layout.length);
    const floats = this.view(Float32Array, address, layout.length);
    return Object.fromEntries(layout.map((member, i) => [member.name, member.isFloat ? floats[i] : words[i]]));
  }

  /** A copy of an array out of the memory. */
  take(type, address, length) {
    return this.view(type, address, length).slice();
  }

  /** Text of bytes up to the first 0. */
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
