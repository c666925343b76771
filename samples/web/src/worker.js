// SPDX-License-Identifier: MIT
// Runs the module beside the page, so that binding never stops the picture. Messages in: {id, call, ...}; out: {id,
// reply, buffers} or {progress}.
import { uncompressed } from "./compressed.js";
import { compile, hasExceptions, hasSimd } from "@sinew/skin/loader";
import { isScene, readScenesBy } from "@sinew/skin/scenes";
import { fetchPacked } from "./packed.js";
import { Parts } from "./parts.js";

/** @type {Record<string, number>} */
const kinds = { triangles: 0, vertexOf: 1, positions: 2, normals: 3, colours: 4, jointPositions: 5, strongest: 6, vertexQuestions: 7, palette: 8 };
/** @type {Record<string, any>} */
const arrays = { triangles: Uint32Array, vertexOf: Uint32Array, colours: Uint8Array, strongest: Uint16Array, vertexQuestions: Uint32Array };
const outOfMemory = -31; // SINEW_ERROR_MEMORY
const opened = ["triangles", "vertexOf", "positions", "normals"];
const posed = ["positions", "normals", "jointPositions", "palette"];

/** @type {any} */
let module;
let moduleBytes = 0;
/** @type {Parts} */
let parts; // of the module
/** @type {import("./handles.js").Handles} */
let handles; // once the last of these is there

// What reads FBX and COLLADA, once there is such a file.
/** @type {Promise<any> | null} */
let scenes = null;
/** @param {string} name */
function needScenes(name) {
  if (!isScene(name)) return null;
  scenes ??= Promise.all([import("sinew-scenes"), fetchPacked("sinew-scenes.wasm").then(compile)]).then(([glue, compiled]) => readScenesBy(module, glue.default, compiled));
  scenes.catch(() => (scenes = null)); // the next file asks again
  return scenes;
}

// What reads compressed glTF, once there is such a file.
/** @type {{ draco: Promise<any> | null, meshopt: Promise<any> | null }} */
const decoders = { draco: null, meshopt: null };
/** @param {{ draco: boolean, meshopt: boolean }} needs */
async function decodersFor(needs) {
  if (needs.draco) decoders.draco ??= Promise.all([import("sinew-draco"), fetchPacked("sinew-draco.wasm")]).then(([glue, wasmBinary]) => glue.default({ wasmBinary }));
  if (needs.meshopt) decoders.meshopt ??= import("three/addons/libs/meshopt_decoder.module.js").then(({ MeshoptDecoder }) => MeshoptDecoder.ready.then(() => MeshoptDecoder));
  return { draco: needs.draco && (await decoders.draco), meshopt: needs.meshopt && (await decoders.meshopt) };
}
/** @param {string} name @param {Uint8Array} bytes */
async function plainGltf(name, bytes) {
  let needs = { draco: false, meshopt: false };
  try {
    return await uncompressed(name, bytes, (wanted) => decodersFor((needs = wanted)), (beside) => module.FS.readFile(plain(beside)));
  } catch (error) {
    Object.assign(decoders, { draco: null, meshopt: null }); // the next file asks again
    throw new Error(`${name}: its geometry is compressed by ${needs.draco ? "Draco" : "meshoptimizer"} and could not be unpacked (${error?.message || error}). Export it without compression`, { cause: error });
  }
}

/** @param {{ forceScalar: boolean }} how */
async function start({ forceScalar }) {
  if (!hasExceptions()) throw new Error("This browser is too old: use Chrome 95, Firefox 100, Safari 15.2 or newer (2022)");
  const kind = !forceScalar && hasSimd() ? "simd" : "scalar";
  const glue = kind === "simd" ? import("sinew-simd") : import("sinew-scalar"); // fetched beside the module
  const bytes = await fetchPacked(`sinew-${kind}.wasm`);
  moduleBytes = bytes.byteLength;
  const compiled = await compile(bytes);
  parts = new Parts([`sinew-${kind}-rig.wasm`, `sinew-${kind}-rest.wasm`]);
  module = await (await glue).default({
    /** @type {(imports: any, done: any) => object} */
    instantiateWasm(imports, done) {
      WebAssembly.instantiate(compiled, parts.withPlaceholders(imports)).then((instance) => {
        parts.primary = instance.exports;
        done(instance, compiled);
      });
      return {};
    },
    onProgress: (/** @type {number} */ share) => postMessage({ progress: share }),
    print: () => {},
    printErr: () => {},
  });
  module.FS.mkdir("/drop");
  module.FS.chdir("/drop");
  return { kernel: text(module._web_kernel()), version: text(module._web_version()), moduleBytes };
}

/** @type {(at: number) => string} */
const text = (at) => module.UTF8ToString(at);

/** @param {string} value */
function textAt(value) {
  const bytes = module.lengthBytesUTF8(value) + 1;
  const at = module._malloc(bytes);
  module.stringToUTF8(value, at, bytes);
  return at;
}

// The reply of web_NAME; arguments that are no numbers are texts, or JSON as texts.
/** @param {string} name @param {any[]} options */
function ask(name, ...options) {
  /** @type {number[]} */
  const texts = [];
  const given = options.map((one) => {
    if (typeof one === "number" || typeof one === "boolean") return one;
    return texts[texts.push(textAt(typeof one === "string" ? one : JSON.stringify(one))) - 1];
  });
  try {
    const reply = JSON.parse(text(module[`_web_${name}`](...given)));
    if (reply.error) throw new Error(reply.error);
    return reply;
  } finally {
    for (const at of texts) module._free(at);
  }
}

// Copies: the module's memory moves when it grows.
/** @param {string[]} names */
function take(names) {
  /** @type {Record<string, any>} */
  const buffers = {};
  const size = module._malloc(4);
  for (const name of names) {
    const at = module._web_buffer(kinds[name], size);
    const bytes = new Uint32Array(module.HEAPU8.buffer, size, 1)[0];
    const copy = module.HEAPU8.slice(at, at + bytes).buffer;
    buffers[name] = new (arrays[name] ?? Float32Array)(copy);
  }
  module._free(size);
  return buffers;
}

/**
 * @template Result
 * @param {Float32Array} values
 * @param {(at: number) => Result} use
 */
function withFloats(values, use) {
  const at = module._malloc(values.byteLength);
  try {
    module.HEAPF32.set(values, at / 4);
    return use(at);
  } finally {
    module._free(at);
  }
}

// A name out of a dropped folder may hold anything; only its last part becomes a file.
/** @type {(name: string) => string} */
const plain = (name) => name.split(/[/\\]/).pop() ?? name;

/** @type {Record<string, (options: any) => any>} */
const calls = {
  start,
  async write({ files }) {
    for (const { name, bytes } of files) module.FS.writeFile(plain(name), new Uint8Array(bytes));
    for (const { name, bytes } of files) { // what they refer to is there
      const made = await plainGltf(name, new Uint8Array(bytes));
      if (made) module.FS.writeFile(plain(name), made);
    }
  },
  // Folders of documents and numbers of characters that are open no more.
  remove({ folders, numbers }) {
    for (const number of numbers) module._web_forget(number);
    for (const folder of folders) {
      const path = `/drop/${folder}`;
      if (!module.FS.analyzePath(path).exists) continue;
      for (const name of module.FS.readdir(path)) if (module.FS.isFile(module.FS.lstat(`${path}/${name}`).mode)) module.FS.unlink(`${path}/${name}`);
      if (module.FS.cwd() !== path) module.FS.rmdir(path);
    }
  },
  model: ({ name }) => ask("model", plain(name)),
  // place: {turns, height, floor, up, anew} as web_load() has it
  async load({ mesh, skeleton, number, place = {} }) {
    await needScenes(mesh);
    return { ...ask("load", plain(mesh), skeleton && plain(skeleton), number, place), buffers: take(opened) };
  },
  // A drawing by other wishes: {class, ...} as web_picture() has them.
  picture: ({ mesh, wishes, number }) => ({ ...ask("picture", plain(mesh), wishes, number), buffers: take(opened) }),
  // answers: [[vertex, kind, joint], ...]
  // wish: as BindOptions of options.js has it. Replies whether the last part of the module had none in it, too.
  bind({ wish, answers }) {
    const reply = ask("bind", wish, answers);
    return { ...reply, alone: !parts.wasLastAsked, buffers: take(["strongest", "vertexQuestions"]) };
  },
  rig: ({ wishes }) => ask("rig", wishes),
  // edits: [{kind, joint, other, place}, ...]
  edit: ({ edits, mirror, continues }) => ask("edit", edits, mirror, continues),
  // The character as it is now, under a number that restore knows until drop.
  keep: ({ number }) => module._web_keep(number),
  drop: ({ numbers }) => numbers.forEach((/** @type {number} */ number) => module._web_drop(number)),
  restore: ({ number }) => ask("restore", number),
  // Locked and painted rows, for a project and from one.
  rows: () => ask("rows"),
  putRows: ({ rows }) => ask("put_rows", rows),
  // {mesh, joints, clips} of a file
  async contents({ name }) {
    await needScenes(name);
    return handles.contents(plain(name));
  },
  check: () => handles.check(),
  // An edit with weights and colours at once, while a joint is dragged.
  move({ edits, mirror, continues, wish, answers, mode, joint }) {
    const rig = calls.edit({ edits, mirror, continues });
    const { seconds } = ask("rebind", wish, answers);
    return { rig, seconds, ...calls.colour({ mode, joint }) };
  },
  preview: ({ wish, answers }) => ask("preview", wish, answers),
  endPreview: () => ask("end_preview"),
  style: ({ name }) => ask("style", name && plain(name)),
  styleAnswers: ({ wish }) => ({ ...ask("style_answers", wish), buffers: take(["vertexQuestions"]) }),
  saveStyle({ wish, answers, name }) {
    const file = plain(name);
    ask("save_style", wish, answers, file);
    const bytes = module.FS.readFile(file);
    module.FS.unlink(file);
    return { buffers: { bytes } };
  },
  colour: ({ mode, joint }) => ({ ...ask("colour", mode, joint), buffers: take(["colours"]) }),
  // joints: [joint, ...] whose vertices keep their weights from now on
  lock: ({ joints }) => ask("lock", joints),
  // A stroke of the brush, with colours at once.
  paint: ({ stroke, mode, joint }) => ({ ...ask("paint", stroke), ...calls.colour({ mode, joint }) }),
  forgetPaint: () => module._web_forget_paint(),
  // skinning: 0 linear, 1 dual quaternions, 2 volume, 3 volume with contact. Replies with {bends: [{joint, degrees, kept}]}.
  pose: ({ turns, skinning }) => withFloats(turns, (at) => ({ ...ask("pose", at, skinning), buffers: take(posed) })),
  // names: of files with motions, or builtin:NAME; [] for none any more
  async motion({ names, wish }) {
    for (const name of names) await needScenes(name);
    const files = names.map((/** @type {string} */ name) => (name.startsWith("builtin:") ? name : plain(name)));
    return files.length > 0 ? handles.openMotions(files, wish) : handles.closeMotions();
  },
  // {notes, seconds, poses: [{palette, jointPositions}]} of a clip that ships
  clipFrames: ({ name, wish, frames }) =>
    handles.preview(name, wish, (at, seconds) =>
      Array.from({ length: frames }, (_, f) => {
        ask("frame_joints", at, 0, (seconds * (f + 0.5)) / frames);
        return take(["jointPositions", "palette"]);
      }),
    ),
  motionMethod: ({ method }) => handles.useMethod(method),
  // wish: {take, drop, values} as sinew springs has them. Replies with {chains}.
  springs: ({ wish }) => handles.findSprings(wish),
  // Positions of the mesh are left out. swings: the clip has its springs.
  frameJoints({ clip, seconds, swings }) {
    const { spots, ...playing } = handles.playing(clip, seconds, swings);
    return { ...ask("frame_joints", playing.at, playing.clip, seconds), spots, buffers: take(["jointPositions", "palette"]) };
  },
  frame({ clip, seconds, skinning, swings }) {
    const { spots, ...playing } = handles.playing(clip, seconds, swings);
    return { ...ask("frame", playing.at, playing.clip, seconds, skinning), spots, buffers: take(posed) };
  },
  // While the character is dragged, in the pose of its turns or, with `clip`, in that of a clip. drag: {move, degrees, passed, begins} as web_dragged() has it.
  dragged({ clip, seconds, turns, skinning, drag }) {
    const springs = handles.dragging(drag.begins), moving = clip === undefined ? 0 : handles.playing(clip, seconds, false).at;
    return withFloats(turns, (at) => ({ ...ask("dragged", springs.at, moving, clip ?? 0, seconds, at, { ...drag, begins: springs.begins }, skinning), spots: [], buffers: take(posed) }));
  },
  // kind: glb, fbx or vrm; wish: {clips, springs, bakes, profile, author, title, licence}
  file({ name, kind, wish }) {
    const { height, notes, bytes } = handles.file(`${plain(name)}.bound.${kind}`, wish);
    return { height, notes, buffers: { bytes } };
  },
  // {pose} that files of a profile stand in
  profile: ({ name }) => ask("profile", name),
  rigText: ({ name }) => ({ buffers: { bytes: handles.rigText(`${plain(name)}.rig.txt`) } }),
};

// How many of the later parts of the module a call waits for: none to open and bind a character, the first to make it a skeleton, else all.
/** @type {Map<string, number>} */
const needs = new Map([...["start", "write", "remove", "model", "load", "bind", "keep", "drop"].map((call) => /** @type {const} */ ([call, 0])), ["rig", 1]]);

// Calls with a `folder` are of the files of that document; one that opens a character stays there, if it succeeds, and others are of it then.
const opens = new Set(["load", "picture"]);
/** @param {string} call @param {{ folder?: number }} options */
async function answerIn(call, { folder, ...options }) {
  if (folder === undefined) return calls[call](options);
  const before = module.FS.cwd(), path = `/drop/${folder}`;
  if (!module.FS.analyzePath(path).exists) module.FS.mkdir(path);
  module.FS.chdir(path);
  let stays = false;
  try {
    const reply = await calls[call](options);
    stays = opens.has(call);
    return reply;
  } finally {
    if (!stays) module.FS.chdir(before);
  }
}

/** @param {any} message {id, call, ...} */
async function answer({ id, call, ...options }) {
  try {
    if (needs.get(call) !== 0) await parts.loaded(needs.get(call));
    if (!needs.has(call)) handles ??= new (await import("./handles.js")).Handles(module);
    const reply = (await answerIn(call, options)) ?? {};
    const transfer = Object.values(reply.buffers ?? {}).map((b) => b.buffer);
    postMessage({ id, reply }, { transfer });
    // What is next; where that fails the next call says it.
    if (call === "load" && reply.joints?.length === 0) parts.loaded(1).catch(() => {});
    if (call === "bind") parts.loaded().catch(() => {});
  } catch (error) {
    let line = String(error?.message ?? error);
    if (error instanceof RangeError || error?.status === outOfMemory) line = "Out of memory: the file is too large for this browser; use the sinew command";
    postMessage({ id, error: line, crashed: error instanceof WebAssembly.RuntimeError });
  }
}

// One call after another, also where one waits for a reader to be fetched.
let calling = Promise.resolve();
onmessage = ({ data }) => (calling = calling.then(() => answer(data)));
