// SPDX-License-Identifier: MIT
// ZIP archives in and out: dropped ones are read, projects are written, without compression. PKWARE's APPNOTE 6.3.

const local = 0x04034b50, central = 0x02014b50, end = 0x06054b50;

const table = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let k = 0; k < 8; ++k) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n;
});
/** @param {Uint8Array} bytes */
export function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = table[(crc ^ byte) & 255] ^ (crc >>> 8);
  return (crc ^ 0xffffffff) >>> 0;
}

/** @param {Uint8Array<ArrayBuffer>} bytes */
async function inflate(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// [{name, bytes}] of the files in an archive, folders left out. Throws Error for what is none, or is encrypted or packed in a rare way.
/** @param {string} name @param {Uint8Array<ArrayBuffer>} bytes */
export async function unzip(name, bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = bytes.length - 22;
  while (at >= 0 && view.getUint32(at, true) !== end) --at;
  if (at < 0) throw new Error(`${name}: expected a ZIP archive, found none or a part of one`);
  const files = [];
  let entry = view.getUint32(at + 16, true);
  for (let left = view.getUint16(at + 10, true); left > 0; --left) {
    if (entry + 46 > bytes.length || view.getUint32(entry, true) !== central) throw new Error(`${name}: its list of files is damaged`);
    const [flags, method] = [view.getUint16(entry + 8, true), view.getUint16(entry + 10, true)];
    const [packed, size] = [view.getUint32(entry + 20, true), view.getUint32(entry + 24, true)];
    const [nameSize, extra, comment] = [28, 30, 32].map((offset) => view.getUint16(entry + offset, true));
    const file = new TextDecoder().decode(bytes.subarray(entry + 46, entry + 46 + nameSize));
    const from = view.getUint32(entry + 42, true);
    entry += 46 + nameSize + extra + comment;
    if (file.endsWith("/") || file.startsWith("__MACOSX/")) continue;
    if (flags & 1 || ![0, 8].includes(method)) throw new Error(`${name}: ${file} is ${flags & 1 ? "encrypted" : "packed in a way that is not read"}; unpack it first`);
    if (from + 30 > bytes.length || view.getUint32(from, true) !== local) throw new Error(`${name}: ${file} is damaged`);
    const start = from + 30 + view.getUint16(from + 26, true) + view.getUint16(from + 28, true);
    const content = bytes.subarray(start, start + packed);
    const whole = method === 0 ? content.slice() : await inflate(content);
    if (whole.length !== size) throw new Error(`${name}: ${file} is damaged`);
    files.push({ name: file.split("/").pop() ?? file, bytes: whole });
  }
  return files;
}

// An archive of [{name, bytes}].
/** @param {{ name: string, bytes: Uint8Array<ArrayBuffer> }[]} files */
export function zip(files) {
  const parts = [], list = [];
  let offset = 0, listed = 0;
  for (const { name, bytes } of files) {
    const text = new TextEncoder().encode(name);
    const head = new DataView(new ArrayBuffer(46));
    // What both heads have: version 2.0, names in UTF-8, stored, 1 January 1980, checksum, sizes.
    const common = (/** @type {number} */ at) => {
      [20, 0x800, 0, 0, 33].forEach((value, i) => head.setUint16(at + 2 * i, value, true));
      [crc32(bytes), bytes.length, bytes.length].forEach((value, i) => head.setUint32(at + 10 + 4 * i, value, true));
      head.setUint16(at + 22, text.length, true);
    };
    head.setUint32(0, local, true);
    common(4);
    parts.push(new Uint8Array(head.buffer.slice(0, 30)), text, bytes);
    new Uint8Array(head.buffer).fill(0);
    head.setUint32(0, central, true);
    head.setUint16(4, 20, true);
    common(6);
    head.setUint32(42, offset, true);
    list.push(new Uint8Array(head.buffer.slice(0)), text);
    offset += 30 + text.length + bytes.length;
    listed += 46 + text.length;
  }
  const tail = new DataView(new ArrayBuffer(22));
  tail.setUint32(0, end, true);
  for (const at of [8, 10]) tail.setUint16(at, files.length, true);
  tail.setUint32(12, listed, true);
  tail.setUint32(16, offset, true);
  return new Blob([...parts, ...list, tail.buffer], { type: "application/zip" });
}
