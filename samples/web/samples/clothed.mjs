// SPDX-License-Identifier: MIT
// Writes the page's first sample: a person in clothes with a texture, without a skeleton. Everything is made here, of rings and ellipsoids; CC0 1.0.
//   clothed.mjs OUT.glb [DETAIL]      detail: of rows and columns, 1 where it is left out
import { writeFileSync } from "node:fs";
import { paint } from "./clothed_texture.mjs";

const detail = Number(process.argv[3] ?? 1);
const fewer = (count) => Math.max(4, Math.round(detail * count));
const positions = [];
const uvs = [];
const triangles = [];

// A grid of (rows + 1) x (columns + 1) points; at(row, column), shares of 1, is {place, uv}. Faces look to where rows and columns turn as x and y do.
function grid(rows, columns, at) {
  const first = positions.length;
  for (let r = 0; r <= rows; ++r)
    for (let c = 0; c <= columns; ++c) {
      const { place, uv } = at(r / rows, c / columns);
      positions.push(place);
      uvs.push(uv);
    }
  for (let r = 0; r < rows; ++r)
    for (let c = 0; c < columns; ++c) {
      const a = first + r * (columns + 1) + c, b = a + 1, d = a + columns + 1, e = d + 1;
      triangles.push([a, d, b], [b, d, e]);
    }
}

const mix = (a, b, t) => a + (b - a) * t;
const within = ([u0, v0, u1, v1], u, v) => [mix(u0, u1, u), mix(v0, v1, v)];
const smooth = (t) => t * t * (3 - 2 * t);
// Values at equal distances, joined smoothly.
function along(values, t) {
  const at = Math.min(values.length - 2, Math.floor(t * (values.length - 1)));
  return values[at].map((x, i) => mix(x, values[at + 1][i], smooth(t * (values.length - 1) - at)));
}

// A closed tube: rings [[x, y, z, wide, deep], ...] from below to above, or from the body outwards. axis: where it goes; wide is across it, deep along z.
function tube(rings, axis, region, { rows: allRows = 4 * rings.length, columns: allColumns = 20 } = {}) {
  const [rows, columns] = [fewer(allRows), fewer(allColumns)];
  const length = Math.hypot(...axis);
  const [ax, ay] = [axis[0] / length, axis[1] / length];
  grid(rows + 2, columns, (row, column) => {
    const t = Math.min(1, Math.max(0, (row * (rows + 2) - 1) / rows));
    const cap = row === 0 || row === 1 ? 0.02 : 1; // its ends are closed
    const [x, y, z, wide, deep] = along(rings, t);
    const angle = 2 * Math.PI * column;
    const across = -Math.sin(angle) * wide * cap;
    return { place: [x + ay * across, y - ax * across, z - Math.cos(angle) * deep * cap], uv: within(region, column, t) };
  });
}

// from: share of it, from below, that is left out, or angle -> share; floor: it is flat there.
function ball([x, y, z], [rx, ry, rz], region, { rows = 14, columns = 24, from = 0, floor = -Infinity } = {}) {
  grid(fewer(rows), fewer(columns), (row, column) => {
    const angle = 2 * Math.PI * column;
    const low = typeof from === "function" ? from(angle) : from;
    const polar = Math.PI * mix(low, 1, row); // from below
    const place = [x - Math.sin(angle) * Math.sin(polar) * rx, Math.max(floor, y - Math.cos(polar) * ry), z - Math.cos(angle) * Math.sin(polar) * rz];
    return { place, uv: within(region, column, mix(low, 1, row)) };
  });
}

const atlas = { knit: [0, 0, 0.5, 0.5], denim: [0.5, 0, 1, 0.5], skin: [0.02, 0.52, 0.23, 0.73], hair: [0.02, 0.77, 0.23, 0.98], face: [0.25, 0.5, 0.75, 1], shoe: [0.77, 0.52, 0.98, 0.73], scarf: [0.77, 0.77, 0.98, 0.98] };

function person() {
  tube([[0, 0.8, 0, 0.1, 0.09], [0, 0.86, 0, 0.165, 0.12], [0, 0.95, 0, 0.17, 0.118], [0, 1.02, 0, 0.155, 0.105]], [0, 1, 0], atlas.denim);
  tube([[0, 0.87, 0, 0.186, 0.136], [0, 0.97, 0, 0.174, 0.124], [0, 1.1, 0.003, 0.158, 0.113], [0, 1.24, 0.006, 0.178, 0.127], [0, 1.36, 0, 0.186, 0.116], [0, 1.43, -0.004, 0.14, 0.09], [0, 1.485, 0, 0.066, 0.064]], [0, 1, 0], atlas.knit, { columns: 32 });
  for (const side of [1, -1]) {
    tube([[side * 0.095, 0.08, -0.012, 0.067, 0.073], [side * 0.094, 0.28, -0.008, 0.068, 0.074], [side * 0.091, 0.47, 0.006, 0.074, 0.08], [side * 0.088, 0.7, 0, 0.088, 0.098], [side * 0.084, 0.9, 0, 0.093, 0.108]], [0, 1, 0], atlas.denim, { rows: 20 });
    ball([side * 0.1, 0.045, 0.035], [0.056, 0.058, 0.128], atlas.shoe, { floor: 0 });
    const arm = [0.39 * side, -0.42, 0];
    const sleeve = [[side * 0.115, 1.375, 0, 0.046, 0.056], [side * 0.168, 1.358, 0, 0.068, 0.074], [side * 0.235, 1.296, 0, 0.065, 0.067], [side * 0.33, 1.19, 0.002, 0.056, 0.058], [side * 0.42, 1.095, 0.012, 0.05, 0.052], [side * 0.495, 1.012, 0.022, 0.046, 0.05]];
    tube(sleeve, arm, atlas.knit, { rows: 18 });
    const hand = [side * 0.545, 0.952, 0.03];
    tube([[side * 0.49, 1.018, 0.022, 0.026, 0.034], [hand[0], hand[1], hand[2], 0.022, 0.046], [side * 0.585, 0.905, 0.036, 0.018, 0.04], [side * 0.612, 0.872, 0.04, 0.01, 0.022]], arm, atlas.skin, { rows: 10, columns: 14 });
    tube([[side * 0.52, 0.985, 0.055, 0.013, 0.014], [side * 0.528, 0.955, 0.082, 0.013, 0.014], [side * 0.54, 0.93, 0.095, 0.007, 0.008]], [side * 0.2, -0.5, 0], atlas.skin, { rows: 6, columns: 8 });
    ball([side * 0.104, 1.655, -0.002], [0.016, 0.032, 0.022], atlas.skin, { rows: 6, columns: 8 });
  }
  tube([[0, 1.44, -0.004, 0.056, 0.056], [0, 1.5, 0, 0.05, 0.051], [0, 1.58, 0.004, 0.052, 0.054]], [0, 1, 0], atlas.skin, { rows: 6 });
  ball([0, 1.66, 0.012], [0.104, 0.137, 0.118], atlas.face, { rows: 20, columns: 32 });
  ball([0, 1.645, 0.13], [0.015, 0.022, 0.018], atlas.skin, { rows: 6, columns: 10 });
  // Hair: lower behind than in front.
  ball([0, 1.672, 0.002], [0.118, 0.146, 0.132], atlas.hair, { rows: 12, columns: 32, from: (angle) => mix(0.4, 0.7, smooth(Math.min(1, Math.max(0, (1 - Math.cos(angle)) / 2 * 1.5 - 0.35)))) });
  scarf();
}

function scarf() {
  grid(fewer(24), fewer(12), (row, column) => {
    const [round, angle] = [2 * Math.PI * row, 2 * Math.PI * column];
    const reach = 0.078 + 0.03 * Math.cos(angle);
    return { place: [Math.sin(round) * reach * 1.05, 1.485 + 0.034 * Math.sin(angle) - 0.018 * Math.cos(round), Math.cos(round) * reach], uv: within(atlas.scarf, row, column) };
  });
  tube([[0.045, 1.2, 0.142, 0.036, 0.008], [0.042, 1.33, 0.137, 0.034, 0.012], [0.035, 1.45, 0.1, 0.026, 0.018]], [0, 1, 0], atlas.scarf, { rows: 8, columns: 12 });
}

// Smooth ones: vertices of a part at one place share theirs.
function normals() {
  const sums = new Map();
  const keyOf = (p) => p.map((x) => Math.round(x * 1e6)).join();
  for (const [a, b, c] of triangles) {
    const [p, q, r] = [positions[a], positions[b], positions[c]];
    const [u, v] = [q, r].map((to) => to.map((x, i) => x - p[i]));
    const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    for (const at of [p, q, r]) {
      const sum = sums.get(keyOf(at)) ?? [0, 0, 0];
      sums.set(keyOf(at), sum.map((x, i) => x + normal[i]));
    }
  }
  return positions.map((p) => {
    const sum = sums.get(keyOf(p)) ?? [0, 1, 0];
    const length = Math.hypot(...sum) || 1;
    return sum.map((x) => x / length);
  });
}

function glb(texture) {
  const kept = triangles.filter(([a, b, c]) => new Set([a, b, c].map((v) => positions[v].join())).size === 3);
  const parts = [Buffer.from(Float32Array.from(positions.flat()).buffer), Buffer.from(Float32Array.from(normals().flat()).buffer), Buffer.from(Float32Array.from(uvs.flat()).buffer), Buffer.from(Uint32Array.from(kept.flat()).buffer), texture];
  const views = [];
  let end = 0;
  for (const part of parts) {
    views.push({ buffer: 0, byteOffset: end, byteLength: part.length });
    end += Math.ceil(part.length / 4) * 4;
  }
  const bounds = (pick) => [0, 1, 2].map((i) => Math.fround(positions.reduce((most, p) => pick(most, p[i]), positions[0][i])));
  const float = (bufferView, type) => ({ bufferView, type, componentType: 5126, count: positions.length });
  const json = {
    asset: { version: "2.0", generator: "sinew samples/web/samples/clothed.mjs", copyright: "CC0 1.0" },
    scene: 0, scenes: [{ nodes: [0] }], nodes: [{ name: "Person", mesh: 0 }],
    meshes: [{ name: "Person", primitives: [{ attributes: { POSITION: 0, NORMAL: 1, TEXCOORD_0: 2 }, indices: 3, material: 0 }] }],
    materials: [{ name: "Person", doubleSided: true, pbrMetallicRoughness: { baseColorTexture: { index: 0 }, metallicFactor: 0, roughnessFactor: 0.85 } }],
    textures: [{ source: 0, sampler: 0 }], samplers: [{ magFilter: 9729, minFilter: 9987 }], images: [{ bufferView: 4, mimeType: "image/png" }],
    accessors: [{ ...float(0, "VEC3"), min: bounds(Math.min), max: bounds(Math.max) }, float(1, "VEC3"), float(2, "VEC2"), { bufferView: 3, type: "SCALAR", componentType: 5125, count: 3 * kept.length }],
    bufferViews: views, buffers: [{ byteLength: end }],
  };
  const pad = (bytes, filler) => Buffer.concat([bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4, filler)]);
  const chunk = (kind, bytes) => {
    const head = Buffer.alloc(8);
    head.writeUInt32LE(bytes.length, 0);
    head.write(kind, 4, "latin1");
    return Buffer.concat([head, bytes]);
  };
  const chunks = [chunk("JSON", pad(Buffer.from(JSON.stringify(json)), " ")), chunk("BIN\0", Buffer.concat(parts.map((part) => pad(part, 0))))];
  const head = Buffer.from("glTF\x02\0\0\0\0\0\0\0", "latin1");
  head.writeUInt32LE(12 + chunks[0].length + chunks[1].length, 8);
  return Buffer.concat([head, ...chunks]);
}

person();
writeFileSync(process.argv[2], glb(paint(512)));
