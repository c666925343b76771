// SPDX-License-Identifier: MIT
// Makes the moving pictures of the page's samples by the page's own module: opens a sample, gives it a skeleton where it has none, binds it, and plays a clip that ships.
// src/moving_picture.js describes the file and plays it.
//   moving.mjs GLUE.mjs MODULE.wasm OUT_DIR FOLDER...      folders: where samples and models are, the first that has a file counts
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { CharacterFile, CharacterModule } from "../../npm/src/character.js";
import { movingOf, samples } from "../src/samples.js";

const [glue, wasm, out, ...folders] = process.argv.slice(2).map((path) => resolve(path));
const read = (name) => readFileSync(join(folders.find((folder) => existsSync(join(folder, name))) ?? folders[0], name));
const framesOfClip = 24;
const slots = 4;
Object.assign(globalThis, { self: globalThis, importScripts: () => {}, location: { href: "file:///" } }); // the glue expects a worker
const { default: make } = await import(pathToFileURL(glue));
const module = await make({ instantiateWasm: (imports, done) => (WebAssembly.instantiate(readFileSync(wasm), imports).then(({ instance, module: compiled }) => done(instance, compiled)), {}), onProgress() {}, print() {}, printErr() {} });
const house = new CharacterModule(module, () => Promise.reject(new Error("no sample is a scene")));

function ask(name, ...options) {
  const texts = [];
  const given = options.map((one) => {
    if (typeof one === "number") return one;
    const text = typeof one === "string" ? one : JSON.stringify(one), size = module.lengthBytesUTF8(text) + 1, at = module._malloc(size);
    module.stringToUTF8(text, at, size);
    return texts[texts.push(at) - 1];
  });
  const reply = JSON.parse(module.UTF8ToString(module[`_web_${name}`](...given)));
  for (const at of texts) module._free(at);
  if (reply.error) throw new Error(`${name}: ${reply.error}`);
  return reply;
}
const kinds = { triangles: [0, Uint32Array], vertexOf: [1, Uint32Array], positions: [2, Float32Array], normals: [3, Float32Array], colours: [4, Uint8Array], joints: [5, Float32Array], palette: [8, Float32Array] };
function take(name) {
  const [kind, type] = kinds[name], size = module._malloc(4), at = module._web_buffer(kind, size);
  const [bytes] = new Uint32Array(module.HEAPU8.buffer, size, 1);
  module._free(size);
  return new type(module.HEAPU8.slice(at, at + bytes).buffer);
}
const handle = (call) =>
  house.withBlocks(null, (blocks) => {
    const room = blocks.room(Uint32Array, 1);
    house.check(call(blocks, room), 0);
    const [at] = blocks.view(Uint32Array, room, 1);
    return { at, character: new CharacterFile(house, at) };
  });

// The sample as the module shows it, bound.
function open({ files: [mesh, skeleton = ""] }, number) {
  for (const name of [mesh, skeleton]) if (name) module.FS.writeFile(name, read(name));
  const loaded = mesh.endsWith(".png") ? ask("picture", mesh, { class: "" }, number) : ask("load", mesh, skeleton, number, {});
  let { joints, upAxis = 0, picture } = loaded;
  if (joints.length === 0) ({ joints, upAxis = 0, picture = picture } = ask("rig", { up: 2, category: 0, front: 0, mirror: 0, spine: 0, toes: true, ends: true, detail: 0, at: [], alike: true }));
  ask("bind", { method: 0, upAxis, symmetric: false, rigidParts: 0, softness: 0, influences: slots, never: [], always: [], toPose: "" }, []);
  ask("colour", 0, 0);
  return { joints, clip: picture?.clip };
}

// [{joints, weights}] of 255 parts, four of each vertex.
function influencesOf(weights, vertex) {
  const rows = [];
  for (let i = weights.rowOffsets[vertex]; i < weights.rowOffsets[vertex + 1]; ++i) rows.push([weights.joints[i], weights.weights[i]]);
  const strongest = rows.sort((a, b) => b[1] - a[1]).slice(0, slots), sum = strongest.reduce((total, [, weight]) => total + weight, 0) || 1;
  const parts = strongest.map(([, weight]) => Math.round((255 * weight) / sum));
  parts[0] += 255 - parts.reduce((a, b) => a + b, 0);
  return [...Array(slots).keys()].map((s) => [strongest[s]?.[0] ?? 0, parts[s] ?? 0]);
}

// A rotation as a quaternion, of the rows of a palette's matrix.
function quaternionOf([a, b, c, , d, e, f, , g, h, i]) {
  const parts = [Math.sqrt(Math.max(0, 1 + a - e - i)), Math.sqrt(Math.max(0, 1 - a + e - i)), Math.sqrt(Math.max(0, 1 - a - e + i)), Math.sqrt(Math.max(0, 1 + a + e + i))].map((x) => x / 2);
  const largest = parts.indexOf(Math.max(...parts)), [x, y, z, w] = parts;
  const q = [[x, (b + d) / (4 * x), (c + g) / (4 * x), (h - f) / (4 * x)], [(b + d) / (4 * y), y, (f + h) / (4 * y), (c - g) / (4 * y)], [(c + g) / (4 * z), (f + h) / (4 * z), z, (d - b) / (4 * z)], [(h - f) / (4 * w), (c - g) / (4 * w), (d - b) / (4 * w), w]];
  return q[largest];
}

// Frames of the clip, [J x 7] numbers each: a quaternion and a translation, which move a joint from its rest; the character stays above its place on the floor.
function framesOf(clip, isPicture, count) {
  const shown = handle((_, room) => module._web_character(0, 0, room));
  const motion = handle((blocks, room) => module._sinew_character_open(blocks.texts([clip]).address, room));
  shown.character.retarget(motion.character, { method: isPicture ? "auto" : "contacts", targetUp: "y", pins: [], report: true, force: true });
  const [{ seconds }] = JSON.parse(module.UTF8ToString(module._web_clips(shown.at)));
  const frames = [];
  let start = null;
  for (let f = 0; f < framesOfClip; ++f) {
    ask("frame_joints", shown.at, 0, (seconds * f) / (framesOfClip - 1));
    const palette = take("palette"), places = take("joints");
    const middle = [0, 2].map((axis) => places.filter((_, i) => i % 3 === axis).reduce((a, b) => a + b, 0) / count);
    start ??= middle;
    frames.push([...Array(count).keys()].map((j) => {
      const rows = palette.subarray(12 * j, 12 * j + 12);
      return [...quaternionOf(rows), rows[3] - middle[0] + start[0], rows[7], rows[11] - middle[1] + start[1]];
    }));
  }
  for (const { character } of [shown, motion]) character.close();
  return { frames, seconds };
}

function moving(sample, number) {
  const { joints, clip } = open(sample, number);
  const positions = take("positions"), normals = take("normals"), vertexOf = take("vertexOf"), triangles = take("triangles"), colours = take("colours");
  const copy = handle((_, room) => module._web_character(0, 0, room)), { weights } = copy.character.view();
  copy.character.close();
  const { frames, seconds } = framesOf(sample.clip ?? clip, Boolean(clip), joints.length);
  const axes = [0, 1, 2].map((axis) => positions.filter((_, i) => i % 3 === axis));
  const low = axes.map((of) => of.reduce((a, b) => Math.min(a, b))), size = axes.map((of, axis) => of.reduce((a, b) => Math.max(a, b)) - low[axis] || 1e-6);
  const reach = Math.max(...frames.flat().map((pose) => Math.max(...pose.slice(4).map(Math.abs))), 1e-6);
  const influences = Array.from(vertexOf, (vertex) => influencesOf(weights, vertex));
  const head = { vertices: vertexOf.length, triangles: triangles.length / 3, parents: joints.map(({ parent }) => parent), frames: frames.length, seconds, low, size, reach };
  const planes = (list, width, type, scaled) => type.from({ length: list.length }, (_, i) => { // all x, then all y, ...: it packs better
    const [plane, at] = [Math.floor(i / (list.length / width)), i % (list.length / width)];
    return scaled(list[at * width + plane], plane);
  });
  const text = new TextEncoder().encode(JSON.stringify(head)), padded = new Uint8Array(Math.ceil(text.length / 4) * 4).fill(32);
  padded.set(text);
  const parts = [
    Uint32Array.of(padded.length), padded, Float32Array.from(joints.flatMap(({ position }) => position)),
    planes(positions, 3, Uint16Array, (x, axis) => Math.round((65535 * (x - low[axis])) / size[axis])), planes(triangles, 3, Uint16Array, (x) => x),
    Int16Array.from(frames.flat(2), (x, i) => Math.round(32767 * (i % 7 < 4 ? x : x / reach))),
    planes(normals, 3, Int8Array, (x) => Math.round(127 * x)), planes(colours, 3, Uint8Array, (x) => x),
    planes(influences.flatMap((rows) => rows.map(([joint]) => joint)), slots, Uint8Array, (x) => x), planes(influences.flatMap((rows) => rows.map(([, weight]) => weight)), slots, Uint8Array, (x) => x),
  ];
  const bytes = Buffer.concat(parts.map(({ buffer, byteOffset, byteLength }) => Buffer.from(buffer, byteOffset, byteLength)));
  writeFileSync(join(out, movingOf(sample)), bytes);
  return bytes.length;
}

for (const name of ["default", "rig", "front"]) {
  module.FS.writeFile(name, read(`sinew_${name}.sinew`));
  ask("model", name);
}
const wanted = samples.filter(({ shown }) => shown);
for (const [number, sample] of wanted.entries()) console.log(`${movingOf(sample)}: ${moving(sample, number + 1)} bytes`);
