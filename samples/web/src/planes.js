// SPDX-License-Identifier: MIT
// Models are 16 bit words, whose low bytes nothing packs and whose high bytes are alike: apart they are a tenth smaller when they are packed.

/**
 * First bytes of all words, then second ones; an odd last byte stays last.
 * @param {Uint8Array} bytes
 */
export function toPlanes(bytes) {
  const half = bytes.length >> 1;
  return Uint8Array.from(bytes, (_, i) => (i < half ? bytes[2 * i] : i < 2 * half ? bytes[2 * (i - half) + 1] : bytes[i]));
}

/** @param {Uint8Array} planes */
export function fromPlanes(planes) {
  const half = planes.length >> 1;
  return Uint8Array.from(planes, (_, i) => (i >= 2 * half ? planes[i] : planes[(i >> 1) + (i & 1 ? half : 0)]));
}
