// SPDX-License-Identifier: MIT
// Whole characters from and to files, as the command has them: its defaults, its bytes. `sinew/character.h` as WebAssembly.
import { OPTIONS } from "./jobs.js";
import { LAYOUTS } from "./layouts.js";
import { compile, hasExceptions, hasSimd } from "./loader.js";
import { blocksOf, optionsAt, resultAt } from "./marshalling.js";
import { SinewError } from "./memory.js";
import { fileKind } from "./file_kinds.js";
import { isScene, readScenesBy } from "./scenes.js";

/** A character in the module's memory; close() gives it back. Made by CharacterModule.open(). */
export class CharacterFile {
  #house;
  #handle;
  /** @type {number | null} */
  #joints = null; // of keypoints, how many
  constructor(house, handle) {
    this.#house = house;
    this.#handle = handle;
  }

  #at(call) {
    if (this.#handle === 0) throw new SinewError(`${call}: the character is closed`);
    return this.#handle;
  }

  /**
   * `call` of C with options and, where it has one, a result.
   * @param {string} call for errors
   * @param {string} name of C's call and of its options
   * @param {Record<string, any>} options
   * @param {{result?: string, before?: any[], after?: any[]}} around what C's call takes before and after this character
   */
  #job(call, name, options, { result = "", before = [], after = [] } = {}) {
    const house = this.#house, at = this.#at(call), counts = () => house.arrays(at);
    return house.withBlocks(options.onProgress, (blocks) => {
      const handle = (/** @type {any} */ one, /** @type {string} */ what) => (one instanceof CharacterFile ? one.#at(call) : house.refuse(`${what}: expected what open() gave`));
      const sizes = () => ({ V: counts().vertex_count, J: counts().joint_count });
      const given = optionsAt(call, OPTIONS[name], options, { blocks, sizes, handle, progress: house.progress });
      const out = result ? [blocks.struct(result)] : [];
      house.check(house.module[`_sinew_character_${name === "profile" ? "set_profile" : name}`](...before, at, ...after, given, ...out), at);
      return result ? resultAt(house.module, result, out[0], sizes()) : undefined;
    });
  }

  /** Notes and warnings of the reader and the jobs, one line each. */
  get notes() {
    const { module } = this.#house;
    return module.UTF8ToString(module._sinew_character_notes(this.#at("notes"))).split("\n").filter(Boolean);
  }

  /** `sinew bind` */
  bind(options = {}) {
    return this.#job("bind", "bind", options, { result: "characterBindResult" });
  }

  /** `sinew rig`: makes a skeleton and binds the mesh to it. */
  rig(options = {}) {
    return this.#job("rig", "rig", options, { result: "characterRigResult" });
  }

  /**
   * `sinew animate`: adds the clips of another character or motion.
   * @param {CharacterFile | null} motion null: a clip of its class that ships, for a picture's character
   */
  retarget(motion, options = {}) {
    if (motion !== null && !(motion instanceof CharacterFile)) throw new SinewError("retarget: expected what open() gave for the motion's file");
    return this.#job("retarget", "animate", options, { result: "characterAnimateResult", after: [motion ? motion.#at("retarget") : 0] });
  }

  /** Result of reading its picture: class, view and certainty once it is rigged, the outline as lines of x, y. */
  get picture() {
    const house = this.#house, at = this.#at("picture");
    return house.withBlocks(null, (blocks) => {
      const info = blocks.struct("characterPictureInfo");
      house.check(house.module._sinew_character_picture(at, info), at);
      return resultAt(house.module, "characterPictureInfo", info);
    });
  }

  /** `sinew transfer`: transfers the weights of a bound character to this one. @param {CharacterFile} source */
  transfer(source, options = {}) {
    if (!(source instanceof CharacterFile)) throw new SinewError("transfer: expected what open() gave for the bound character's file");
    return this.#job("transfer", "transfer", options, { result: "characterTransferResult", before: [source.#at("transfer")] });
  }

  /** `--turn`, `--height`, `--floor`: rotates and scales the whole character. */
  transform(options) {
    this.#job("transform", "transform", options);
  }

  /** `--for`: the form that save() writes. The rest pose stays: see toPose of bind() and rig(). */
  setProfile(options) {
    this.#job("setProfile", "profile", options);
  }

  /** `--controls`: the joints of an animator's controls, in the skeleton as it would be saved; the text of a file. */
  get controls() {
    const house = this.#house, at = this.#at("controls");
    return house.withBlocks(null, (blocks) => {
      const text = blocks.room(Uint32Array, 1);
      house.check(house.module._sinew_character_controls(at, text), at);
      return house.module.UTF8ToString(blocks.view(Uint32Array, text, 1)[0]);
    });
  }

  /** `sinew check`: finds faults of the rig. Changes nothing. */
  check(options = {}) {
    return this.#job("check", "check", options, { result: "characterCheckResult" });
  }

  /** `sinew springs`: finds hair, tails, ears and skirts that swing. They are saved with the character and simulated by retarget({ springs: true }). */
  springs(options = {}) {
    return this.#job("springs", "springs", options, { result: "characterSpringsResult" });
  }

  /** Copies of its arrays: mesh, skeleton and, where it has weights, rows of them as CSR. */
  view() {
    const { module } = this.#house, a = this.#house.arrays(this.#at("view"));
    const { vertex_count: V, joint_count: J, mesh_count: M, face_count: F, corner_count: C } = a;
    const take = (type, at, length) => (at === 0 ? null : new type(module.HEAPU8.buffer, at, length).slice());
    const texts = (at, count) => Array.from(take(Uint32Array, at, count) ?? [], (one) => module.UTF8ToString(one));
    const rowOffsets = take(Uint32Array, a.row_offsets, V + 1), count = rowOffsets ? rowOffsets[V] : 0;
    const joints = take(Int32Array, a.mesh_joints, M), skinned = take(Uint8Array, a.mesh_skinned, M);
    return {
      name: module.UTF8ToString(a.name),
      mesh: { positions: take(Float32Array, a.positions, 3 * V), faceOffsets: take(Uint32Array, a.face_offsets, F + 1), faceVertices: take(Uint32Array, a.face_vertices, C) },
      skeleton: { names: texts(a.joint_names, J), positions: take(Float32Array, a.joint_positions, 3 * J), parents: take(Int32Array, a.parents, J) },
      meshes: texts(a.mesh_names, M).map((name, m) => ({ name, joint: joints[m], skinned: skinned[m] !== 0 })),
      weights: rowOffsets ? { rowOffsets, joints: take(Uint32Array, a.joint_indices, count), weights: take(Float32Array, a.weights, count) } : null,
      confidence: take(Uint8Array, a.confidence, V),
    };
  }

  /** The bytes of a file by its extension: .glb, .vrm, .bvh, .rig.txt; of .gltf and .obj what lies beside is in files. */
  save(name) {
    return this.files(name)[0].bytes;
  }

  /** All files that the command would write: [{name, bytes}], the named one first. */
  files(name) {
    const house = this.#house, { module } = house, from = this.#at("save");
    return house.withBlocks(null, (blocks) => {
      const out = blocks.room(Uint32Array, 2);
      house.check(module._sinew_character_write(from, blocks.texts([name]).address, out, out + 4), from);
      const [first, count] = blocks.view(Uint32Array, out, 2);
      return Array.from({ length: count }, (_, i) => blocks.read("file", first + i * LAYOUTS.file.size)).map((file) => ({
        name: module.UTF8ToString(file.name),
        bytes: blocks.take(Uint8Array, file.bytes, file.size_bytes),
      }));
    });
  }

  /**
   * Of openKeypoints(): local rotations [J x 4] and translations [J x 3] in the frame of these keypoints.
   * @param {Float32Array} keypoints [n x 3]
   */
  keypointsFrame(keypoints) {
    const at = this.#at("keypointsFrame");
    const joints = (this.#joints ??= this.view().skeleton.names.length);
    return this.#house.withKeypoints("keypointsFrame", [keypoints], (blocks, from, count) => {
      const [rotations, translations] = [4, 3].map((width) => blocks.room(Float32Array, width * joints));
      this.#house.check(this.#house.module._sinew_character_keypoints_frame(at, from, count, rotations, translations), at);
      return { rotations: blocks.take(Float32Array, rotations, 4 * joints), translations: blocks.take(Float32Array, translations, 3 * joints) };
    });
  }

  close() {
    if (this.#handle !== 0) this.#house.module._sinew_character_close(this.#handle);
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
    /** sinew_progress that calls module.onProgress. */
    this.progress = module._character_progress();
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
    return this.withBlocks(null, (blocks) => {
      const rows = files.map(([one, data]) => {
        if (typeof one !== "string" || !(data instanceof ArrayBuffer || ArrayBuffer.isView(data))) throw new SinewError(`open: ${one}: expected a name and the file's bytes`);
        const view = data instanceof ArrayBuffer ? new Uint8Array(data) : new Uint8Array(data.buffer, data.byteOffset, data.byteLength);
        return [blocks.texts([one]).address, blocks.copy(view), view.length];
      });
      const at = blocks.copy(Uint32Array.from(rows.flat()));
      if (fileKind(name)?.reader !== "picture") return this.opened((out) => module._sinew_character_open_files(at, files.length, out), blocks);
      const options = optionsAt("open", OPTIONS.picture, picture, { blocks, sizes: () => ({}), handle: () => 0, progress: 0 });
      return this.opened((out) => module._sinew_character_open_picture_files(at, files.length, options, out), blocks);
    });
  }

  /**
   * Keypoints of a person's joints alone, as cameras and captures tell them, as a motion: its skeleton is learned from these frames, which are its
   * clip; a second or two are best. keypointsFrame() turns those that come into what RetargetStream.frame() takes.
   * @param {"smpl24" | "humanml3d22" | "lafan22" | "smplh52" | "smplx55" | "coco17" | "h36m17" | "h36m32" | "kinect25" | "openpose25" | "mediapipe33"} layout
   * @param {Float32Array[]} frames [n x 3] each, any unit
   */
  openKeypoints(layout, frames) {
    return this.withKeypoints("openKeypoints", frames, (blocks, at, count) =>
      this.opened((out) => this.module._sinew_character_open_keypoints(blocks.texts([layout]).address, at, count, frames.length, out), blocks));
  }

  // Frames of as many keypoints each in the module's memory.
  withKeypoints(call, frames, use) {
    const length = frames[0]?.length ?? 0;
    if (length === 0 || length % 3 !== 0 || frames.some((frame) => frame?.length !== length)) throw new SinewError(`${call}: expected frames of as many keypoints each, three numbers a keypoint`);
    const numbers = new Float32Array(frames.length * length);
    frames.forEach((frame, f) => numbers.set(frame, f * length));
    return this.withBlocks(null, (blocks) => use(blocks, blocks.copy(numbers), length / 3));
  }

  // The character that a call gives.
  opened(run, blocks) {
    const out = blocks.room(Uint32Array, 1);
    this.check(run(out), 0);
    return new CharacterFile(this, blocks.view(Uint32Array, out, 1)[0]);
  }

  // sinew_character_arrays.
  arrays(at) {
    return this.withBlocks(null, (blocks) => {
      const arrays = blocks.struct("characterArrays");
      this.check(this.module._sinew_character_view(at, arrays), at);
      return blocks.read("characterArrays", arrays);
    });
  }

  // Memory for one call.
  withBlocks(onProgress, use) {
    const blocks = blocksOf(this.module), before = this.module.onProgress;
    this.module.onProgress = onProgress ?? before;
    try {
      return use(blocks);
    } finally {
      this.module.onProgress = before;
      blocks.free();
    }
  }

  // A call's error is thrown.
  check(status, character) {
    if (status === 0) return;
    const line = this.module.UTF8ToString(this.module._sinew_character_error(character));
    this.refuse(line || this.module.UTF8ToString(this.module._sinew_status_text(status)), status);
  }

  refuse(line, status = 0) {
    throw new SinewError(line, status);
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
