// SPDX-License-Identifier: MIT
// Unpacks what `xz --format=lzma` packed. Servers pack few kinds of files, and by gzip at most; the page's modules are a quarter smaller so.
// As in the LZMA specification of the LZMA SDK (Igor Pavlov, public domain), whose names these are.

const bitsOfProbability = 11;
const half = 1 << (bitsOfProbability - 1);
const damaged = () => new Error("a packed file of the page is damaged or incomplete; reload the page");

class RangeDecoder {
  #bytes;
  #at;
  #range = 0xffffffff;
  #code = 0;

  /** @param {Uint8Array} bytes @param {number} at the first byte, which is 0 */
  constructor(bytes, at) {
    this.#bytes = bytes;
    for (let i = 1; i < 5; ++i) this.#code = ((this.#code << 8) | bytes[at + i]) >>> 0;
    this.#at = at + 5;
  }
  // Whether more was read than there is.
  get over() {
    return this.#at > this.#bytes.length;
  }

  #next() {
    this.#range = (this.#range << 8) >>> 0;
    this.#code = ((this.#code << 8) | this.#bytes[this.#at++]) >>> 0;
  }
  /** @param {Uint16Array} probabilities @param {number} i */
  bit(probabilities, i) {
    const p = probabilities[i];
    const bound = (this.#range >>> bitsOfProbability) * p;
    const is = this.#code >= bound ? 1 : 0;
    if (is) {
      this.#range -= bound;
      this.#code -= bound;
      probabilities[i] = p - (p >> 5);
    } else {
      this.#range = bound;
      probabilities[i] = p + (((1 << bitsOfProbability) - p) >> 5);
    }
    if (this.#range < 0x1000000) this.#next();
    return is;
  }
  /** Bits of equal probability. @param {number} count */
  direct(count) {
    let value = 0;
    for (let i = 0; i < count; ++i) {
      this.#range >>>= 1;
      const is = this.#code >= this.#range ? 1 : 0;
      if (is) this.#code -= this.#range;
      value = 2 * value + is;
      if (this.#range < 0x1000000) this.#next();
    }
    return value;
  }
  /** A number, highest bit first. @param {Uint16Array} probabilities @param {number} from @param {number} bits */
  tree(probabilities, from, bits) {
    let m = 1;
    for (let i = 0; i < bits; ++i) m = (m << 1) | this.bit(probabilities, from + m);
    return m - (1 << bits);
  }
  /** Lowest bit first. @param {Uint16Array} probabilities @param {number} from @param {number} bits */
  reverse(probabilities, from, bits) {
    let m = 1, value = 0;
    for (let i = 0; i < bits; ++i) {
      const is = this.bit(probabilities, from + m);
      m = (m << 1) | is;
      value |= is << i;
    }
    return value;
  }
}

const even = (/** @type {number} */ count) => new Uint16Array(count).fill(half);

class LengthDecoder {
  #choice = even(2);
  #low = even(16 << 3);
  #middle = even(16 << 3);
  #high = even(256);

  /** @param {RangeDecoder} range @param {number} place */
  read(range, place) {
    if (!range.bit(this.#choice, 0)) return range.tree(this.#low, place << 3, 3);
    if (!range.bit(this.#choice, 1)) return 8 + range.tree(this.#middle, place << 3, 3);
    return 16 + range.tree(this.#high, 0, 8);
  }
}

class DistanceDecoder {
  #slot = even(4 << 6);
  #middle = even(1 + 128 - 14);
  #align = even(16);

  /** @param {RangeDecoder} range @param {number} length */
  read(range, length) {
    const slot = range.tree(this.#slot, Math.min(length, 3) << 6, 6);
    if (slot < 4) return slot;
    const bits = (slot >> 1) - 1;
    const from = (2 + (slot & 1)) * 2 ** bits;
    if (slot < 14) return from + range.reverse(this.#middle, from - slot, bits);
    return from + range.direct(bits - 4) * 16 + range.reverse(this.#align, 0, 4);
  }
}

// What is unpacked so far; it grows.
class Output {
  bytes;
  length = 0;

  /** @param {number} size a guess */
  constructor(size) {
    this.bytes = new Uint8Array(size);
  }
  /** Room for that many more. @param {number} count */
  need(count) {
    if (this.length + count <= this.bytes.length) return;
    const more = new Uint8Array(2 * this.bytes.length + count);
    more.set(this.bytes);
    this.bytes = more;
  }
  /** @param {number} distance 1: the last byte @param {number} count */
  repeat(distance, count) {
    if (distance > this.length) throw damaged();
    this.need(count);
    for (let i = 0; i < count; ++i, ++this.length) this.bytes[this.length] = this.bytes[this.length - distance];
  }
}

class LiteralDecoder {
  #context;
  #mask;
  #probabilities;

  /** @param {number} context bits of the byte before @param {number} place bits of where it is */
  constructor(context, place) {
    this.#context = context;
    this.#mask = (1 << place) - 1;
    this.#probabilities = even(0x300 << (context + place));
  }
  /** @param {RangeDecoder} range @param {Output} out @param {number} distance of a byte that it is not, 0: nothing is known of it */
  read(range, out, distance) {
    const { bytes, length } = out;
    const before = length > 0 ? bytes[length - 1] : 0;
    const from = 0x300 * (((length & this.#mask) << this.#context) + (before >> (8 - this.#context)));
    let symbol = 1;
    if (distance > 0) {
      let other = bytes[length - distance];
      while (symbol < 0x100) {
        const expected = (other >> 7) & 1;
        other <<= 1;
        const is = range.bit(this.#probabilities, from + ((1 + expected) << 8) + symbol);
        symbol = (symbol << 1) | is;
        if (is !== expected) break;
      }
    }
    while (symbol < 0x100) symbol = (symbol << 1) | range.bit(this.#probabilities, from + symbol);
    out.need(1);
    out.bytes[out.length++] = symbol & 0xff;
  }
}

/**
 * The bytes that were packed. Throws Error for what is no such file or only a part of one.
 * @param {Uint8Array} packed
 */
export function unpackLzma(packed) {
  const properties = packed[0];
  if (packed.length < 18 || properties >= 9 * 5 * 5 || packed[13] !== 0) throw damaged();
  const range = new RangeDecoder(packed, 13);
  const out = new Output(4 * packed.length);
  const placeMask = (1 << Math.floor(properties / 45)) - 1;
  const literals = new LiteralDecoder(properties % 9, Math.floor(properties / 9) % 5);
  const lengths = new LengthDecoder(), repeatedLengths = new LengthDecoder(), distances = new DistanceDecoder();
  const isMatch = even(12 << 4), isRepeat = even(12), isRepeat0 = even(12), isRepeat1 = even(12), isRepeat2 = even(12), isLong = even(12 << 4);
  let [last, second, third, fourth] = [0, 0, 0, 0]; // distances, from 0 on
  let state = 0;
  for (;;) {
    if (range.over) throw damaged();
    const place = out.length & placeMask;
    if (!range.bit(isMatch, (state << 4) + place)) {
      literals.read(range, out, state < 7 ? 0 : last + 1);
      state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
      continue;
    }
    let length = 0;
    if (!range.bit(isRepeat, state)) {
      length = lengths.read(range, place);
      [fourth, third, second, last] = [third, second, last, distances.read(range, length)];
      if (last === 0xffffffff) return out.bytes.slice(0, out.length); // the mark of the end
      state = state < 7 ? 7 : 10;
    } else {
      if (!range.bit(isRepeat0, state)) {
        if (!range.bit(isLong, (state << 4) + place)) {
          out.repeat(last + 1, 1);
          state = state < 7 ? 9 : 11;
          continue;
        }
      } else if (!range.bit(isRepeat1, state)) [second, last] = [last, second];
      else if (!range.bit(isRepeat2, state)) [third, second, last] = [second, last, third];
      else [fourth, third, second, last] = [third, second, last, fourth];
      length = repeatedLengths.read(range, place);
      state = state < 7 ? 8 : 11;
    }
    out.repeat(last + 1, length + 2);
  }
}
