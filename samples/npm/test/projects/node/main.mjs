// SPDX-License-Identifier: MIT
// A project of node's: every call of the package on a sample; prints one line of JSON.
import { readFileSync } from "node:fs";
import { Worker } from "node:worker_threads";
import { babylonBuffers, load, playcanvasBuffers } from "@sinew/skin";
import { load as loadBind } from "@sinew/skin/bind";
import { bindWasm, wasm } from "@sinew/skin/url";
import { loadFrontModel, loadHandsModel, loadModel, loadRigModel } from "@sinew/skin/model";
import { connect } from "@sinew/skin/worker";
import { bindHash, readObj, readRig } from "./characters.mjs";

const [folder, ...names] = process.argv.slice(2);
const read = (name) => ({
  mesh: readObj(readFileSync(`${folder}/${name}.obj`, "utf8")),
  skeleton: readRig(readFileSync(`${folder}/${name}.rig.txt`, "utf8")).skeleton,
});
const out = { hashes: {}, rigs: {}, errors: {} };
const model = await loadModel();
const skin = await load({ model });
const scalar = await load({ model, scalar: true });
out.kernels = [skin.kernel, scalar.kernel];

for (const name of names) {
  const { mesh, skeleton } = read(name);
  const hash = (options, engine = skin) => bindHash(engine.bind(mesh, skeleton, { format: "unorm16", ...options }));
  out.hashes[name] = {
    plain: hash({}),
    scalar: hash({}, scalar),
    heat: hash({ method: "heat" }),
    symmetric: hash({ symmetric: true }),
    all: hash({ joints: "all" }),
    rigid: hash({ rigidParts: "always", softness: 1.5 }),
  };
}

// The small module, and both as files.
const { mesh: first, skeleton: firstSkeleton } = read(names[0]);
const hashBy = async (load, options) => bindHash((await load({ model, ...options })).bind(first, firstSkeleton, { format: "unorm16" }));
out.small = [await hashBy(loadBind), await hashBy(loadBind, { scalar: true }), await hashBy(loadBind, { wasm: bindWasm })];
out.byUrl = [await hashBy(load, { wasm }), await hashBy(load, { wasm, scalar: true }), await hashBy(load, { wasm: wasm.simd })];
out.smallHas = Object.getOwnPropertyNames(Object.getPrototypeOf(await loadBind())).sort();

const rigModel = skin.openModel(await loadRigModel()), handsModel = skin.openModel(await loadHandsModel());
const frontModel = skin.openModel(await loadFrontModel()), found = { frontModel, upAxis: "auto" };
for (const name of names) {
  const { mesh } = read(name);
  const rig = skin.rig(mesh, { model: rigModel, ...found });
  const full = skin.rig(mesh, { model: rigModel, handsModel, face: true, props: true, ...found });
  out.rigs[name] = [rig, full].map((one) => ({
    names: one.names, positions: Array.from(one.positions), parents: Array.from(one.parents), sure: one.confidence.length,
  }));
}

const { mesh, skeleton } = read(names[0]);
const bound = skin.bind(mesh, skeleton, { questions: 8 });
out.floatSums = Math.max(...Array.from({ length: bound.vertexCount }, (_, v) => Math.abs(bound.weights.subarray(4 * v, 4 * v + 4).reduce((a, b) => a + b) - 1)));
out.questions = bound.questions.map(({ vertex, alternatives }) => [vertex, alternatives.length]);

// A locked vertex keeps its row to the bit; what it is told of steers a hint's surroundings.
const rows = skin.bind(mesh, skeleton, { format: "unorm16" });
const marks = new Uint8Array(bound.vertexCount);
marks[7] = 1;
const given = { joints: rows.joints.slice(), weights: rows.weights.slice() };
given.joints.set([3, 0, 0, 0], 28);
given.weights.set([65535, 0, 0, 0], 28);
for (const kind of ["locked", "hints"]) {
  const kept = skin.bind(mesh, skeleton, { format: "unorm16", [kind]: marks, given });
  out[kind] = { row: [...kept.joints.subarray(28, 32), ...kept.weights.subarray(28, 32)], others: kept.weights.some((w, i) => w !== rows.weights[i] && i >> 2 !== 7) };
}

// Another character's map, motion, garment, poses.
const other = read(names[1]);
const map = skin.map(other.skeleton, skeleton);
out.map = { sources: Array.from(map.sources), mapped: map.mapped };
out.classes = Array.from(skin.jointClasses(other.skeleton).classes);
const plan = skin.retarget(skeleton, other.skeleton, { map: map.sources });
const local = (s) => Float32Array.from(s.positions, (x, i) => x - (s.parents[Math.floor(i / 3)] < 0 ? 0 : s.positions[3 * s.parents[Math.floor(i / 3)] + (i % 3)]));
const still = new Float32Array(4 * skeleton.names.length).map((_, i) => (i % 4 === 3 ? 1 : 0));
const clip = plan.clip({ rotations: Float32Array.from([...still, ...still]), translations: Float32Array.from([...local(skeleton), ...local(skeleton)]) });
out.frames = clip.frameCount;
out.restTurns = Math.max(...clip.rotations.map((x, i) => (i % 4 === 3 ? 0 : Math.abs(x))));
plan.free();
// Classes of limbs without a word in a name: a human body says them, as the command does.
const nameless = (s, letter) => ({ ...s, names: s.names.map((_, j) => `${letter}${j}`) });
const human = read("biped__robot"), humanMap = skin.map(human.skeleton, other.skeleton).sources;
// Motion as it comes: at rest, a frame that has drifted, whose feet stay where they stood, and one that leans.
const person = other.skeleton, numbers = (list) => list.flatMap((one) => Array.from(one));
const upright = new Float32Array(4 * person.names.length).map((_, i) => (i % 4 === 3 ? 1 : 0)), leans = upright.slice();
leans.set([Math.sin(0.2), 0, 0, Math.cos(0.2)], 4);
const drifted = local(person);
drifted[0] += 0.002;
const comes = [{ rotations: upright, translations: local(person) }, { rotations: upright, translations: drifted }, { rotations: leans, translations: drifted }];
const streamed = (options, before = () => {}) => {
  const stream = skin.retargetStream(person, human.skeleton, { map: humanMap, ...options });
  const made = comes.map(({ rotations, translations }) => (before(stream), stream.frame(rotations, translations)));
  stream.free();
  return numbers(made.flatMap(({ rotations, translations }) => [rotations, translations]));
};
const copyist = skin.retarget(person, human.skeleton, { map: humanMap });
const whole = copyist.clip({ rotations: numbers(comes.map(({ rotations }) => rotations)), translations: numbers(comes.map(({ translations }) => translations)) });
copyist.free();
const frameOf = (array, f) => array.subarray((f * array.length) / 3, ((f + 1) * array.length) / 3);
const copied = numbers([0, 1, 2].flatMap((f) => [frameOf(whole.rotations, f), frameOf(whole.translations, f)]));
const same = (one, two) => one.length === two.length && one.every((x, i) => x === two[i]);
out.stream = {
  plain: same(streamed({ contacts: false, range: false }), copied),
  held: !same(streamed({ range: false }), copied),
  forgets: !same(streamed({ range: false }, (stream) => stream.restart()), streamed({ range: false })),
  error: (() => { try { skin.retargetStream(person, human.skeleton, { fps: -1 }); } catch ({ name, message }) { return `${name}: ${message}`; } })(),
};
const classesOf = (to, from) => {
  const plan = skin.retarget(from, to, { map: humanMap });
  const classes = Array.from(plan.classes);
  plan.free();
  return classes;
};
out.limbs = { named: classesOf(human.skeleton, other.skeleton), nameless: classesOf(nameless(human.skeleton, "a"), nameless(other.skeleton, "b")) };
const identity = Float32Array.from({ length: 12 * skeleton.names.length }, (_, i) => (i % 12 === 0 || i % 12 === 5 || i % 12 === 10 ? 1 : 0));
const deformer = skin.deformer(mesh, skeleton, rows);
const farthest = (positions) => Math.max(...positions.map((x, i) => Math.abs(x - mesh.positions[i])));
out.rest = { deformer: farthest(deformer.pose(identity).positions), linear: farthest(skin.pose(mesh.positions, rows, identity)) };
const turned = identity.slice();
const bent = names.length && skeleton.names.indexOf("leg_lower_front.L");
turned.set([1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0], 12 * Math.max(bent, 1));
out.bend = { corrected: deformer.pose(turned).corrected, differs: farthest(deformer.pose(turned).positions) > 0 };
out.dualQuaternion = farthest(skin.pose(mesh.positions, rows, turned, { dualQuaternion: true }));
deformer.free();
const transferred = skin.transfer({ mesh, skeleton, skin: rows }, mesh, skeleton, { format: "unorm16", method: "nearest" });
out.transferred = transferred.weights.filter((w, i) => Math.abs(w - rows.weights[i]) > 655).length / transferred.weights.length;
out.simplified = new Set(skin.simplify(skeleton, { joints: 8 })).size;
out.babylon = Object.values(babylonBuffers(bound)).map((one) => one.length ?? one);
out.playcanvas = Object.values(playcanvasBuffers(bound)).map((one) => `${one.constructor.name} ${one.length}`);

const error = (name, call) => {
  try {
    call();
    out.errors[name] = "none";
  } catch (e) {
    out.errors[name] = `${e.name} ${e.status}: ${e.message}`;
  }
};
error("lengths", () => skin.bind({ positions: [0, 1], indices: [] }, skeleton));
error("index", () => skin.bind({ positions: mesh.positions, indices: [0, 1, 999999] }, skeleton));
error("parent", () => skin.bind(mesh, { positions: [0, 0, 0], parents: [5] }));
error("cycle", () => skin.bind(mesh, { positions: [0, 0, 0, 1, 1, 1], parents: [1, 0] }));
error("option", () => skin.bind(mesh, skeleton, { method: "magic" }));
error("finite", () => skin.bind({ positions: mesh.positions.map(() => NaN), indices: [0, 1, 2] }, skeleton));
error("never", () => skin.bind(mesh, { ...skeleton, flags: new Uint8Array(skeleton.names.length).fill(1) }, { joints: "all" }));
error("model", () => skin.openModel(new Uint8Array(100)));
error("task", () => skin.bind(mesh, skeleton, { model: rigModel }));
error("cancelled", () => skin.bind(mesh, skeleton, { onProgress: () => true }));
error("told", () => skin.bind(mesh, skeleton, { onProgress: (share) => share }));
error("goesOn", () => skin.bind(mesh, skeleton, { onProgress: () => false }));
error("answer", () => skin.bind(mesh, skeleton, { answers: [{ vertex: bound.questions[0].vertex, kind: "proposed" }] }));
out.again = bindHash(skin.bind(mesh, skeleton, { format: "unorm16" })); // after all of these

// Memory is given back: a hundred binds need no more than one.
const pages = () => skin.bind(mesh, skeleton, { format: "unorm16" }).workspaceBytes;
pages();
const before = process.memoryUsage().rss;
for (let i = 0; i < 30; ++i) pages();
out.grown = (process.memoryUsage().rss - before) / 1e6;

const remote = await connect(new Worker(new URL("./skin-worker.mjs", import.meta.url)), { model });
let told = 0;
out.worker = { hash: bindHash(await remote.bind(mesh, skeleton, { format: "unorm16", onProgress: () => void ++told })) };
out.worker.told = told;
const far = await remote.deformer(mesh, skeleton, rows);
out.worker.rest = farthest((await far.pose(identity)).positions);
await far.free();
out.worker.error = await remote.bind({ positions: [0, 1] }, skeleton).then(() => "none", (e) => `${e.name} ${e.message}`);
await remote.close();
out.worker.closed = await remote.bind(mesh, skeleton).then(() => "none", (e) => e.message);

console.log(JSON.stringify(out));
