// SPDX-License-Identifier: MIT
// The texture of clothed.mjs as PNG: knit, denim, skin, hair, a face, leather, a scarf. Shares are of its regions, u to the right, v downwards.
import { crc32, deflateSync } from "node:zlib";

const mix = (a, b, t) => a.map((x, i) => x + (b[i] - x) * t);
const step = (from, to, x) => Math.min(1, Math.max(0, (x - from) / (to - from)));
// The same everywhere: integers alone.
function noise(x, y) {
  let h = (x * 374761393 + y * 668265263) | 0;
  h = Math.imul(h ^ (h >>> 13), 1274126177);
  return ((h ^ (h >>> 16)) >>> 0) / 4294967296;
}
const skin = [236, 188, 158];

function knit(u, v, x, y) {
  const rib = 0.9 + 0.1 * Math.abs(((y + (x % 6 < 3 ? 1 : 0)) % 4) / 3);
  const band = v > 0.62 && v < 0.8;
  const inner = v > 0.66 && v < 0.76;
  const edge = v < 0.05 || v > 0.96;
  const colour = edge ? [24, 74, 84] : inner ? [244, 232, 208] : band ? [226, 128, 64] : [42, 118, 128];
  return colour.map((c) => c * rib * (0.97 + 0.06 * noise(x, y)));
}
function denim(u, v, x, y) {
  const seam = Math.abs(u - 0.25) < 0.008 || Math.abs(u - 0.75) < 0.008;
  const twill = 0.93 + 0.07 * ((x + y) % 3 === 0) + 0.08 * (noise(x, y) - 0.5);
  const worn = Math.exp(-((u - 0.5) ** 2) / 0.02 - (v - 0.5) ** 2 / 0.06);
  return (seam ? [196, 150, 84] : mix([44, 66, 108], [92, 120, 164], 0.7 * worn)).map((c) => c * twill);
}
const hair = (u, v, x, y) => mix([58, 34, 22], [104, 66, 38], 0.55 * noise(x, 3) + 0.3 * noise(x, y >> 3)).map((c) => c);
const shoe = (u, v, x, y) => (v < 0.3 ? [240, 236, 228] : [122, 70, 42]).map((c) => c * (0.95 + 0.1 * noise(x, y)));
const scarf = (u, v, x, y) => ((Math.floor(u * 12) % 3 === 0 ? [246, 222, 180] : [186, 44, 52])).map((c) => c * (0.9 + 0.15 * noise(x >> 1, y)));

// The front is in the middle; v = 0 is the crown's end of the texture's rows, which the head turns round: below is v = 0.
function face(u, v, x, y) {
  let colour = skin.map((c) => c * (0.985 + 0.03 * noise(x, y)));
  const put = (other, share) => (colour = mix(colour, other, Math.min(1, Math.max(0, share))));
  for (const side of [-1, 1]) {
    const d = u - (0.5 + side * 0.066);
    const eye = (d / 0.03) ** 2 + ((v - 0.525) / 0.021) ** 2;
    put([222, 130, 112], 0.35 * Math.exp(-((d - side * 0.015) ** 2) / 0.0009 - (v - 0.43) ** 2 / 0.0012));
    put([250, 250, 248], step(1.15, 0.9, eye));
    const iris = (d / 0.0165) ** 2 + ((v - 0.525) / 0.0195) ** 2;
    put([74, 104, 62], step(1.1, 0.9, iris) * (eye < 1.1));
    put([22, 18, 16], step(1.1, 0.8, 3.2 * iris) * (eye < 1.1));
    put([255, 255, 255], step(1, 0.6, ((d - 0.005) / 0.0045) ** 2 + ((v - 0.532) / 0.0045) ** 2));
    put([52, 30, 20], step(0.5, 0.2, Math.abs(eye - 1.05)) * step(0.528, 0.536, v));
    const brow = v - (0.572 - 3 * d * d * 6);
    put([62, 38, 24], step(0.008, 0.004, Math.abs(brow)) * step(0.04, 0.032, Math.abs(d)));
  }
  const mouth = v - (0.375 + 2.2 * (u - 0.5) ** 2 * 3);
  put([178, 78, 74], step(0.009, 0.004, Math.abs(mouth)) * step(0.055, 0.045, Math.abs(u - 0.5)));
  return colour;
}
const plain = (u, v, x, y) => skin.map((c) => c * (0.985 + 0.03 * noise(x, y)));

// [u0, v0, u1, v1] of the texture
const regions = [[0, 0, 0.5, 0.5, knit], [0.5, 0, 1, 0.5, denim], [0, 0.5, 0.25, 0.75, plain], [0, 0.75, 0.25, 1, hair], [0.25, 0.5, 0.75, 1, face], [0.75, 0.5, 1, 0.75, shoe], [0.75, 0.75, 1, 1, scarf]];

// PNG of size x size pixels.
export function paint(size) {
  const rows = Buffer.alloc(size * (1 + 3 * size));
  for (let y = 0; y < size; ++y)
    for (let x = 0; x < size; ++x) {
      const [s, t] = [(x + 0.5) / size, (y + 0.5) / size];
      const [u0, v0, u1, v1, colour] = regions.find(([a, b, c, d]) => s >= a && s < c && t >= b && t < d);
      colour((s - u0) / (u1 - u0), (t - v0) / (v1 - v0), x, y).forEach((c, i) => (rows[y * (1 + 3 * size) + 1 + 3 * x + i] = Math.min(255, Math.max(0, Math.round(c)))));
    }
  const chunk = (kind, bytes) => {
    const body = Buffer.concat([Buffer.from(kind, "latin1"), bytes]);
    const out = Buffer.alloc(body.length + 8);
    out.writeUInt32BE(bytes.length, 0);
    body.copy(out, 4);
    out.writeUInt32BE(crc32(body) >>> 0, body.length + 4);
    return out;
  };
  const head = Buffer.alloc(13);
  head.writeUInt32BE(size, 0);
  head.writeUInt32BE(size, 4);
  head.set([8, 2, 0, 0, 0], 8);
  return Buffer.concat([Buffer.from("\x89PNG\r\n\x1a\n", "latin1"), chunk("IHDR", head), chunk("IDAT", deflateSync(rows, { level: 9 })), chunk("IEND", Buffer.alloc(0))]);
}
