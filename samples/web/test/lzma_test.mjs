// SPDX-License-Identifier: MIT
// What xz packed is unpacked to the byte, with every kind of its parameters; what is damaged or cut off is a line, never a wait.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { unpackLzma } from "../src/lzma.js";

const from = (base64) => new Uint8Array(Buffer.from(base64, "base64"));
const text = from("BAAAAAT//////////wAqGtnUcyVbFzRbW4/0gvHly1ba892JabpBKiNBdDKySGVfnRXjCH4//MDKwA==");
const words = from("NgAAAAT//////////wBsP9RdOX0PGyPArGxgi3NBKTFVKyJ7J+llZ042lTshFW8emA7DCQLqTuH4hXVHljNspopqkfegPoexsA/QFIu6ofd3c6Tp5zTzaub5Ar83//9TJAAA");
assert.equal(new TextDecoder().decode(unpackLzma(text)), "The hips and the chest; the hips, the chest, the hips and the hips.");
assert.deepEqual(new Int16Array(unpackLzma(words).buffer), Int16Array.from({ length: 40 }, (_, i) => ((i * i) % 97) - 40 + 1000 * (i % 3)));

for (let length = 0; length < text.length - 5; ++length) assert.throws(() => unpackLzma(text.subarray(0, length)), /damaged/, `${length} bytes`);
for (let at = 0; at < words.length; ++at) {
  const broken = words.slice();
  broken[at] ^= 0x55;
  try {
    unpackLzma(broken);
  } catch (error) {
    assert.match(error.message, /damaged/, `byte ${at}`);
  }
}
assert.throws(() => unpackLzma(new TextEncoder().encode("<!doctype html><title>404</title>")), /damaged/);

// Long matches, far ones, matches of all four last distances, an output that grows: this file, words that hardly repeat, and much of nothing.
let seed = 7;
const noise = Uint8Array.from({ length: 70000 }, () => (seed = (seed * 1103515245 + 12345) % 2147483648) >> (seed % 3 ? 23 : 27));
const all = { file: readFileSync(fileURLToPath(import.meta.url)), noise, twice: Buffer.concat([noise, noise.subarray(0, 9), noise]), nothing: new Uint8Array(300000), empty: new Uint8Array(0) };
let packer = "xz";
try {
  execFileSync("xz", ["--version"]);
} catch {
  packer = "none";
  console.log("lzma: no xz here: only what it packed before");
}
for (const [name, bytes] of packer === "xz" ? Object.entries(all) : [])
  for (const how of ["lc=3,lp=0,pb=2", "lc=4,lp=0,pb=0", "lc=0,lp=1,pb=1", "lc=0,lp=4,pb=4"]) {
    const packed = execFileSync("xz", ["--format=lzma", `--lzma1=preset=9e,${how}`, "-c"], { input: bytes, maxBuffer: 1 << 24 });
    assert.ok(Buffer.from(unpackLzma(packed)).equals(Buffer.from(bytes)), `${name}, ${how}`);
  }
console.log("lzma: ok");
