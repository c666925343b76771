// SPDX-License-Identifier: MIT
// Whole characters from and to files, as the command has them: its defaults, its bytes. `sinew/character.h` as WebAssembly.
import { WORDS } from "./layouts.js";
import { compile, hasExceptions, hasSimd } from "./loader.js";
import { SinewError } from "./memory.js";
import { fileKind } from "./file_kinds.js";
import { isScene, readScenesBy } from "./scenes.js";
import { choice } from "./shapes.js";


// Options by name to members of the C structs: a number or yes as it is, a word by its place in a list.
const BIND = {
  method: WORDS.method, influences: "influence_count", up: WORDS.up, joints: WORDS.jointsFrom, rigidParts: WORDS.rigidParts,
  softness: "softness_percent", surfaceVertices: "surface_vertices", keepTips: "keep_tips", bindProps: "bind_props", fit: "fit", symmetric: "symmetric", keepConfidence: "keep_confidence", cut: "cut", toPose: "to_pose",
};
const RIG = {
  method: WORDS.characterRigMethod, detail: WORDS.characterDetail, mirror: WORDS.mirror, up: WORDS.up, front: WORDS.front, spine: "spine_count",
  toes: "!no_toes", ends: "!no_ends", bind: "!no_bind", keepLengths: "keep_lengths", influences: "influence_count", category: WORDS.category, template: "skeleton",
  toPose: "to_pose", gate: "gate", cut: "cut",
};
const RETARGET = {
  method: WORDS.animateMethod, inPlace: "in_place", range: "!no_range", force: "force", translations: "translations", targetUp: WORDS.up, motionUp: WORDS.up, deform: WORDS.poseDeform, bodyContact: "body_contact", shapes: "shapes", fps: "fps", from: "from", to: "to",
  clip: "clip", layout: "layout", actor: "actor", limits: "limits", depth: "depth", stiffness: "stiffness", tetWeights: WORDS.tetWeights, smoothing: "!no_smoothing",
};
const TRANSFER = { method: WORDS.transferMethod, influences: "influence_count", targetUp: WORDS.up, sourceUp: WORDS.up, garment: "garment", heat: "heat" };
const PLACE = { turns: "turns", height: "height", floor: "floor", up: WORDS.up };
const PROFILE = { profile: "profile", keepAxes: "keep_axes", controls: "controls", authors: "authors", licence: "licence", title: "title" };
const CHECK = { poses: "!no_poses", clips: "!no_clips", score: "score", bounds: "bounds" };
const PICTURE = { bodyClass: WORDS.bodyClass, figure: "figure", flat: "flat", cut: "cut", units: ["figure", "pixels"], mask: "mask", outline: "outline" };
const MEMBERS = { bodyClass: "body_class", units: "pixels",  rigidParts: "rigid_parts", targetUp: "target_up", sourceUp: "source_up", motionUp: "motion_up", tetWeights: "tet_weights" };

function wishOf(call, known, options) {
  const wish = {};
  for (const [name, value] of Object.entries(options)) {
    const member = known[name];
    if (value === undefined || name === "onProgress") continue;
    if (member === undefined) throw new SinewError(`${call}: options.${name}: expected ${Object.keys(known).join(", ")}, found another option`);
    if (Array.isArray(member)) wish[MEMBERS[name] ?? name] = choice(value, member, `${call}: options.${name}`);
    else if (member[0] === "!") wish[member.slice(1)] = value === false;
    else if (name === "softness") wish[member] = Math.round(value * 100);
    else if (name === "template") wish[member] = `template:${value}`;
    else wish[member] = name === "clip" || name === "actor" ? String(value) : value;
  }
  return JSON.stringify(wish);
}

/** A character in the module's memory; close() gives it back. Made by CharacterModule.open(). */
export class CharacterFile {
  #house;
  #handle;
  #joints = null; // of places, how many
  constructor(house, handle) {
    this.#house = house;
    this.#handle = handle;
  }

  #at(call) {
    if (this.#handle === 0) throw new SinewError(`${call}: the character is closed`);
    return this.#handle;
  }

  #job(call, known, options, run) {
    const at = this.#at(call);
    return this.#house.said(call, options.onProgress, () => this.#house.withText(wishOf(call, known, options), (text) => run(at, text)));
  }

  /** Remarks of the reader and of the jobs, a line each. */
  get notes() {
    return this.#house.said("notes", null, () => this.#house.module._character_notes(this.#at("notes"))).split("\n").filter(Boolean);
  }

  /** `sinew bind` */
  bind(options = {}) {
    return this.#job("bind", BIND, options, (at, text) => this.#house.module._character_bind(at, text));
  }

  /** `sinew rig`: a skeleton, and the mesh bound to it. */
  rig(options = {}) {
    return this.#job("rig", RIG, options, (at, text) => this.#house.module._character_rig(at, text));
  }

  /**
   * `sinew animate`: adds the clips of another character or motion.
   * @param {CharacterFile | null} motion null: a clip of its class that ships, for a picture's character
   */
  retarget(motion, options = {}) {
    if (motion !== null && !(motion instanceof CharacterFile)) throw new SinewError("retarget: expected what open() gave for the motion's file");
    return this.#job("retarget", RETARGET, options, (at, text) => this.#house.module._character_animate(at, motion ? motion.#at("retarget") : 0, text));
  }

  /** What was found in the picture that it is of: class, view and certainty once it is rigged, the outline as lines of x, y. */
  get picture() {
    const { module } = this.#house;
    const { lineOffsets, outline, bodyClass, view, ...told } = this.#house.said("picture", null, () => module._character_picture(this.#at("picture")));
    const lines = lineOffsets.slice(1).map((to, l) => new Float32Array(module.HEAPU8.buffer, outline + 8 * lineOffsets[l], 2 * (to - lineOffsets[l])).slice());
    return { ...told, bodyClass: WORDS.bodyClass[bodyClass], view: WORDS.pictureView[view], outline: lines };
  }

  /** `sinew transfer`: carries the weights of a bound character to this one. @param {CharacterFile} source */
  transfer(source, options = {}) {
    if (!(source instanceof CharacterFile)) throw new SinewError("transfer: expected what open() gave for the bound character's file");
    return this.#job("transfer", TRANSFER, options, (at, text) => this.#house.module._character_transfer(source.#at("transfer"), at, text));
  }

  /** `--turn`, `--height`, `--floor`: turns and scales all of it. */
  place(options) {
    this.#job("place", PLACE, options, (at, text) => this.#house.module._character_place(at, text));
  }

  /** `--for`: what save() writes from now on. The rest pose stays: that is toPose of bind() and rig(). */
  setProfile(options) {
    this.#job("setProfile", PROFILE, options, (at, text) => this.#house.module._character_profile(at, text));
  }

  /** `--controls`: which joints an animator's controls move, of the skeleton as it would be saved; the text of a file. */
  get controls() {
    return this.#house.said("controls", null, () => this.#house.module._character_controls(this.#at("controls")));
  }

  /** `sinew check`: what is wrong with the rig. Changes nothing. */
  check(options = {}) {
    const told = this.#job("check", CHECK, options, (at, text) => this.#house.module._character_check(at, text));
    const findings = told.findings.map((one) => ({ ...one, severity: WORDS.checkSeverity[one.severity], vertices: Uint32Array.from(one.vertices) }));
    return { ...told, findings };
  }

  /** Copies of its arrays: mesh, skeleton and, where it has weights, rows of them as CSR. */
  view() {
    const { module } = this.#house;
    const told = this.#house.said("view", null, () => module._character_view(this.#at("view")));
    const take = (type, at, length) => (at === 0 ? null : new type(module.HEAPU8.buffer, at, length).slice());
    const { vertexCount: V, jointCount: J, faceCount: F, cornerCount: C, name, jointNames, meshes } = told;
    const rowOffsets = take(Uint32Array, told.rowOffsets, V + 1);
    const count = rowOffsets ? rowOffsets[V] : 0;
    return {
      name,
      mesh: { positions: take(Float32Array, told.positions, 3 * V), faceOffsets: take(Uint32Array, told.faceOffsets, F + 1), faceVertices: take(Uint32Array, told.faceVertices, C) },
      skeleton: { names: jointNames, positions: take(Float32Array, told.jointPositions, 3 * J), parents: take(Int32Array, told.parents, J) },
      meshes,
      weights: rowOffsets ? { rowOffsets, joints: take(Uint32Array, told.jointIndices, count), weights: take(Float32Array, told.weights, count) } : null,
      confidence: take(Uint8Array, told.confidence, V),
    };
  }

  /** The bytes of a file by its extension: .glb, .vrm, .bvh, .rig.txt; of .gltf and .obj what lies beside is in files. */
  save(name) {
    return this.files(name)[0].bytes;
  }

  /** All files that the command would write: [{name, bytes}], the named one first. */
  files(name) {
    const { module } = this.#house;
    const list = this.#house.said("save", null, () => this.#house.withText(name, (text) => module._character_write(this.#at("save"), text)));
    return list.map(({ name: one, at, size }) => ({ name: one, bytes: module.HEAPU8.slice(at, at + size) }));
  }

  /**
   * Of openPlaces(): local rotations [J x 4] and translations [J x 3] in the frame of these places.
   * @param {Float32Array} places [n x 3]
   */
  placesFrame(places) {
    const at = this.#at("placesFrame");
    const joints = (this.#joints ??= this.view().skeleton.names.length);
    return this.#house.withPlaces("placesFrame", [places], 7 * joints, (from, count, out) => {
      this.#house.said("placesFrame", null, () => this.#house.module._character_places_frame(at, from, count, out, out + 16 * joints));
      const take = (first, length) => new Float32Array(this.#house.module.HEAPU8.buffer, first, length).slice();
      return { rotations: take(out, 4 * joints), translations: take(out + 16 * joints, 3 * joints) };
    });
  }

  close() {
    if (this.#handle !== 0) this.#house.module._character_close(this.#handle);
    this.#handle = 0;
  }
}

/** The module. Made by load(). */
export class CharacterModule {
  #scenesFrom;
  #scenes = null;

  constructor(module, scenesFrom) {
    /** Of emscripten. */
    this.module = module;
    this.#scenesFrom = scenesFrom;
  }

  /**
   * Opens a file by its extension: OBJ, GLB, glTF, VRM, FBX, COLLADA, BVH, rig.txt; a PNG or JPEG of a character. FBX and COLLADA fetch
   * another module once.
   * @param {ArrayBuffer | ArrayBufferView} bytes
   * @param {string} name "hero.glb"
   * @param {Record<string, ArrayBuffer | ArrayBufferView>} beside what lies beside it: a .bin, pictures, .mtl, NAME.rig.txt
   * @param {import("./character.js").PictureOptions} picture how a PNG or JPEG is opened
   * @returns {Promise<CharacterFile>}
   */
  async open(bytes, name, beside = {}, picture = {}) {
    const { module } = this;
    if (isScene(name)) await (this.#scenes ??= this.#scenesFrom(module));
    const files = [[name, bytes], ...Object.entries(beside)];
    const blocks = [];
    const put = (data) => {
      const at = module._malloc(Math.max(data.length, 1));
      blocks.push(at);
      module.HEAPU8.set(data, at);
      return at;
    };
    try {
      const rows = files.flatMap(([one, data]) => {
        if (typeof one !== "string" || !(data instanceof ArrayBuffer || ArrayBuffer.isView(data))) throw new SinewError(`open: ${one}: expected a name and the file's bytes`);
        const view = data instanceof ArrayBuffer ? new Uint8Array(data) : new Uint8Array(data.buffer, data.byteOffset, data.byteLength);
        return [put(new TextEncoder().encode(`${one}\0`)), put(view), view.length];
      });
      const at = put(new Uint8Array(Uint32Array.from(rows).buffer));
      const { handle } = this.said("open", null, () =>
        fileKind(name)?.reader === "picture"
          ? this.withText(wishOf("open", PICTURE, picture), (text) => module._character_open_picture(at, files.length, text))
          : module._character_open(at, files.length),
      );
      return new CharacterFile(this, handle);
    } finally {
      for (const at of blocks) module._free(at);
    }
  }

  /**
   * Places of a person's joints alone, as cameras and captures tell them, as a motion: its skeleton is learnt from these frames, which are its
   * clip; a second or two are best. placesFrame() turns those that come into what RetargetStream.frame() takes.
   * @param {"smpl24" | "humanml3d22" | "coco17" | "mediapipe33"} layout
   * @param {Float32Array[]} frames [n x 3] each, any unit
   */
  openPlaces(layout, frames) {
    return this.withPlaces("openPlaces", frames, 0, (at, count) => {
      const { handle } = this.said("openPlaces", null, () => this.withText(layout, (text) => this.module._character_open_places(text, at, count, frames.length)));
      return new CharacterFile(this, handle);
    });
  }

  // Frames of as many places each in the module's memory, and room for so many numbers behind them.
  withPlaces(call, frames, room, use) {
    const length = frames[0]?.length ?? 0;
    if (length === 0 || length % 3 !== 0 || frames.some((frame) => frame?.length !== length)) throw new SinewError(`${call}: expected frames of as many places each, three numbers a place`);
    const { module } = this, at = module._malloc(4 * (frames.length * length + room));
    try {
      const numbers = new Float32Array(module.HEAPU8.buffer, at, frames.length * length);
      frames.forEach((frame, f) => numbers.set(frame, f * length));
      return use(at, length / 3, at + 4 * frames.length * length);
    } finally {
      module._free(at);
    }
  }

  withText(value, use) {
    const size = this.module.lengthBytesUTF8(value) + 1, at = this.module._malloc(size);
    try {
      this.module.stringToUTF8(value, at, size);
      return use(at);
    } finally {
      this.module._free(at);
    }
  }

  // What a call replies; its error is thrown.
  said(call, onProgress, run) {
    this.module.onProgress = onProgress ?? null;
    try {
      const reply = JSON.parse(this.module.UTF8ToString(run()));
      if (reply?.error !== undefined) throw new SinewError(reply.error, reply.status);
      return reply;
    } finally {
      this.module.onProgress = null;
    }
  }
}

const started = (glue, compiled) =>
  glue({
    instantiateWasm(imports, done) {
      WebAssembly.instantiate(compiled, imports).then((instance) => done(instance, compiled));
      return {};
    },
    print: () => {},
    printErr: () => {},
  });

/**
 * Starts the module.
 * @param {{wasm?: import("./index.js").WasmSource, scenes?: import("./index.js").WasmSource}} options where wasm/character.wasm and wasm/scenes.wasm are,
 * for bundlers that do not know `new URL(..., import.meta.url)`
 * @returns {Promise<CharacterModule>}
 */
export async function load(options = {}) {
  if (!hasSimd() || !hasExceptions()) throw new SinewError("load: this browser has no SIMD or no exceptions for WebAssembly (before 2022; Safari before 2023)");
  const wasm = options.wasm ?? new URL("../wasm/character.wasm", import.meta.url);
  const scenesWasm = options.scenes ?? new URL("../wasm/scenes.wasm", import.meta.url);
  const [glue, compiled] = await Promise.all([import("../wasm/character.js"), compile(wasm)]);
  return new CharacterModule(await started(glue.default, compiled), async (module) => {
    const [scenes, compiledScenes] = await Promise.all([import("../wasm/scenes.js"), compile(scenesWasm)]);
    return readScenesBy(module, scenes.default, compiledScenes);
  });
}
