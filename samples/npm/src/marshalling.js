// SPDX-License-Identifier: MIT
// Plain objects as structs of sinew/character.h, and structs as plain objects, by the tables of jobs.js.
import { RESULTS } from "./jobs.js";
import { LAYOUTS } from "./layouts.js";
import { Blocks, SinewError } from "./memory.js";
import { choice, typed } from "./shapes.js";

/** Memory of a module of emscripten. @param {any} module */
export const blocksOf = (module) =>
  new Blocks({
    malloc: (/** @type {number} */ size) => module._malloc(size),
    free: (/** @type {number} */ at) => module._free(at),
    memory: { get buffer() { return module.HEAPU8.buffer; } }, // prettier-ignore
  });

/** @type {(type: string) => (value: any, name: string) => any} */
const need = (type) => (value, name) => {
  if (typeof value !== type) throw new SinewError(`${name}: expected a ${type}, found ${value === null ? "null" : typeof value}`);
  return value;
};
const [number, flag] = [need("number"), need("boolean")];
/** @type {(value: any, name: string) => string} */
const text = (value, name) => (typeof value === "number" ? String(value) : need("string")(value, name));
/** @type {(value: any, name: string) => any[]} */
const list = (value, name) => (Array.isArray(value) ? value : need("list")(value, name));

// Each gives the members that a value sets: (value, its name, the row's member and what follows it, {blocks, sizes}).
/** @type {Record<string, (value: any, name: string, row: any[], memory: any) => Record<string, any>>} */
const SETTERS = {
  number: (value, name, [member]) => ({ [member]: number(value, name) }),
  flag: (value, name, [member]) => ({ [member]: Number(flag(value, name)) }),
  without: (value, name, [member, bit], { values }) => ({ [member]: (values[member] ?? 0) | (flag(value, name) ? 0 : bit) }),
  percent: (value, name, [member]) => ({ [member]: Math.round(100 * number(value, name)) }),
  word: (value, name, [member, words]) => ({ [member]: choice(value, words, name) }),
  text: (value, name, [member], { blocks }) => ({ [member]: blocks.texts([text(value, name)]).address }),
  template: (value, name, row, memory) => SETTERS.text(`template:${text(value, name)}`, name, row, memory),
  texts: (value, name, [member, count], { blocks }) => {
    const { each } = blocks.texts(list(value, name).map((one) => text(one, name)));
    return { [member]: blocks.copy(each), [count]: each.length };
  },
  mapping: (value, name, [member, names, count], { blocks }) => ({
    ...SETTERS.texts(Object.keys(value), name, [names, count], { blocks }),
    [member]: blocks.copy(Float64Array.from(Object.values(value), (one) => number(one, name))),
  }),
  lines: (value, name, [member, offsets, count], { blocks }) => {
    const points = list(value, name).flat(2), ends = value.map((/** @type {any[]} */ line) => line.length);
    if (value.flat().some((/** @type {any[]} */ point) => point.length !== 2)) throw new SinewError(`${name}: expected lines of [x, y]`);
    const starts = Uint32Array.from({ length: ends.length + 1 }, (_, i) => ends.slice(0, i).reduce((/** @type {number} */ sum, /** @type {number} */ one) => sum + one, 0));
    return { [member]: blocks.copy(Float32Array.from(points)), [offsets]: blocks.copy(starts), [count]: ends.length };
  },
  array: (value, name, [member, type, counts], { blocks, sizes }) => ({ [member]: blocks.copy(typed(type, value, name, counts.reduce((/** @type {number} */ all, /** @type {string} */ one) => all * (sizes()[one] ?? Number(one)), 1))) }),
  structs: (value, name, [member, of, [count]], { blocks }) => {
    const { size } = /** @type {any} */ (LAYOUTS)[of], rows = list(value, name), at = blocks.bytes(Math.max(size * rows.length, 1));
    rows.forEach((row, i) => blocks.view(Uint8Array, at + i * size, size).set(blocks.take(Uint8Array, blocks.struct(of, row), size)));
    return { [member]: at, [count]: rows.length };
  },
  character: (value, name, [member], { handle }) => ({ [member]: handle(value, name) }),
};

/**
 * Address of a struct of options in `memory.blocks`.
 * @param {string} call for errors
 * @param {{struct: any, inner?: Record<string, any>, members: Record<string, any[]>}} table of jobs.js: a member `deform.cells` is in
 *   the struct inner.deform, which the member deform points to
 * @param {Record<string, any>} options
 * @param {{blocks: Blocks, sizes: () => Record<string, number>, handle: (character: any, name: string) => number, progress: number}} memory
 */
export function optionsAt(call, { struct, inner = {}, members }, options, memory) {
  /** @type {Record<string, any>} */
  const values = { progress: memory.progress };
  for (const [name, value] of Object.entries(options)) {
    if (value === undefined || name === "onProgress") continue;
    if (members[name] === undefined) throw new SinewError(`${call}: options.${name}: expected ${Object.keys(members).join(", ")}, found another option`);
    const [kind, ...row] = members[name];
    Object.assign(values, SETTERS[kind](value, `${call}: options.${name}`, row, { ...memory, values }));
  }
  for (const [pointer, pointee] of Object.entries(inner)) {
    const own = Object.entries(values).filter(([member]) => member.startsWith(`${pointer}.`)).map(([member, value]) => [member.slice(pointer.length + 1), value]);
    if (own.length > 0) values[pointer] = memory.blocks.struct(pointee, Object.fromEntries(own));
  }
  return memory.blocks.struct(struct, values);
}

/**
 * A struct of results as a plain object; arrays are copied.
 * @param {any} module of emscripten
 * @param {string} struct
 * @param {number} address
 * @param {Record<string, number>} sizes the character's joints (J) and vertices (V)
 */
export function resultAt(module, struct, address, sizes = {}) {
  const blocks = blocksOf(module);
  /** @type {Record<string, any>} */
  const raw = blocks.read(/** @type {any} */ (struct), address);
  /** @type {(counts: string[]) => number} */
  const count = (counts) => counts.reduce((all, one) => all * (raw[one] ?? sizes[one] ?? Number(one)), 1);
  /** @type {(type: any, at: number, length: number) => any} */
  const array = (type, at, length) => (at === 0 ? new type(0) : blocks.take(type, at, length));
  /** @type {Record<string, (value: any, ...extra: any[]) => any>} */
  const readers = {
    number: (value) => value,
    numbers: (value) => value,
    numberOrNull: (value) => (value < 0 ? null : value),
    fraction: (value) => value / 65536,
    flag: (value) => value !== 0,
    text: (value) => (value === 0 ? "" : module.UTF8ToString(value)),
    word: (value, words) => words[value],
    array: (value, type, counts) => array(type, value, count(counts)),
    structs: (value, of, counts) => Array.from({ length: value === 0 ? 0 : count(counts) }, (_, i) => resultAt(module, of, value + i * /** @type {any} */ (LAYOUTS)[of].size, sizes)),
    lines: (value, offsets, lines) => {
      const ends = array(Uint32Array, raw[offsets], raw[lines] + 1);
      return Array.from({ length: raw[lines] }, (_, l) => array(Float32Array, value + 8 * ends[l], 2 * (ends[l + 1] - ends[l])));
    },
  };
  return Object.fromEntries(Object.entries(RESULTS[struct].members).map(([name, [kind, member, ...extra]]) => [name, readers[kind](raw[member], ...extra)]));
}
