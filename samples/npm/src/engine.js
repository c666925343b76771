// SPDX-License-Identifier: MIT
// The engine's calls: arguments to the module's memory, results out of it. One thread, one call at a time.
import { JOINT_NAME_BYTES, MAX_RIG_JOINTS, MODEL_BYTES, QUESTION_BYTES } from "./layouts.js";
import { Blocks, SinewError } from "./memory.js";
import { choice, meshOf, skeletonOf, skinOf, typed } from "./shapes.js";

const FLAG_NEVER = 1;
const FLAG_DEFORMS = 2;
const CLASS_OTHER = 17;
const NO_QUESTION = 0xffffffff;
const UP = ["auto", "x", "y", "z"]; // in the order of sinew_up
const UP_AXES = [2, 3]; // sinew_up of "y" and "z"
const [DETAIL_HANDS, DETAIL_FACE, DETAIL_PROPS] = [1, 2, 4]; // sinew_rig_detail
const ANSWERS = ["as-proposed", "rigid", "soft", "hard", "softer", "host"];
const MAP_REASONS = ["found", "pinned", "no counterpart", "fewer joints", "end", "outside", "taken", "beside limits"];
const TRANSFER_REASONS = ["asked", "style", "mismatch", "plain", "near", "far", "no match", "kept"];

/** A model in the module's memory, checked and packed once. free() gives the memory back. */
export class Model {
  #blocks;
  constructor(wasm, bytes) {
    this.#blocks = new Blocks(wasm);
    const data = bytes instanceof ArrayBuffer ? new Uint8Array(bytes) : new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const blocks = this.#blocks;
    const at = blocks.bytes(data.length);
    blocks.view(Uint8Array, at, data.length).set(data);
    /** Address of the sinew_model. */
    this.address = blocks.bytes(MODEL_BYTES);
    blocks.view(Uint8Array, this.address, MODEL_BYTES).fill(0);
    let status = wasm.sinew_rig_model_open(at, data.length, this.address);
    if (status === -19) status = wasm.sinew_model_open(at, data.length, this.address); // made for another task
    if (status !== 0) {
      const line = blocks.text(wasm.sinew_status_text(status) >>> 0);
      blocks.free();
      throw new SinewError(`openModel: ${line}`, status);
    }
    const words = blocks.view(Uint32Array, this.address, MODEL_BYTES / 4);
    this.parameters = words[9];
    /** "weights", "skeletons" or "hands" */
    this.task = words[13] === 0 ? "weights" : words[6] === 2 ? "hands" : "skeletons";
    const packed = wasm.sinew_model_pack_workspace_size(this.address) >>> 0;
    if (packed > 0) wasm.sinew_model_pack(this.address, blocks.bytes(packed, 64), packed);
  }
  free() {
    this.#blocks.free();
    this.address = 0;
  }
}

/** The engine. Made by load(). */
export class Skin {
  #wasm;
  #report;
  /** The model that bind() and transfer() use where their options name none. @type {Model | null} */
  model = null;

  constructor(wasm, report) {
    this.#wasm = wasm;
    this.#report = report;
    const blocks = new Blocks(wasm);
    this.version = blocks.text(wasm.sinew_version() >>> 0, 32);
    /** "simd128" or "ref" */
    this.kernel = blocks.text(wasm.sinew_kernel_name(wasm.sinew_kernel_select(0)) >>> 0, 32);
  }

  /** Checks a model file and keeps it. */
  openModel(bytes) {
    return new Model(this.#wasm, bytes);
  }

  #check(call, status) {
    if (status === 0) return;
    throw new SinewError(`${call}: ${new Blocks(this.#wasm).text(this.#wasm.sinew_status_text(status) >>> 0)}`, status);
  }

  // Runs a call with memory that is given back whatever happens.
  #with(onProgress, body) {
    const blocks = new Blocks(this.#wasm);
    this.#report.progress = onProgress ?? null;
    try {
      return body(blocks);
    } finally {
      this.#report.progress = null;
      blocks.free();
    }
  }

  // A size that a query writes: query(address of the size) -> status.
  #size(call, blocks, query) {
    const at = blocks.room(Uint32Array, 1);
    this.#check(call, query(at));
    return blocks.view(Uint32Array, at, 1)[0];
  }

  #modelOf(call, options, task) {
    const model = options.model ?? (task === "weights" ? this.model : null);
    if (model == null) throw new SinewError(`${call}: no model is open; give load() or the options the bytes of @sinew/skin/model`);
    if (!(model instanceof Model) || model.address === 0) throw new SinewError(`${call}: options.model: expected what openModel() gave`);
    if (model.task !== task) throw new SinewError(`${call}: expected a model of ${task}, found one of ${model.task}`);
    return model.address;
  }

  #mesh(blocks, mesh) {
    return blocks.struct("mesh", {
      positions: blocks.copy(mesh.positions),
      vertex_count: mesh.vertexCount,
      face_offsets: blocks.copy(mesh.faceOffsets),
      face_vertices: blocks.copy(mesh.faceVertices),
      face_count: mesh.faceCount,
      corner_count: mesh.cornerCount,
    });
  }

  #skeleton(blocks, skeleton, flags, up = 0) {
    return blocks.struct("skeleton", {
      up,
      positions: blocks.copy(skeleton.positions),
      parents: blocks.copy(skeleton.parents),
      flags: blocks.copy(flags),
      joint_count: skeleton.jointCount,
    });
  }

  #names(blocks, names) {
    return names == null ? 0 : blocks.texts(names).address;
  }

  /**
   * Which joints may get weight, by their names and places, as the command's `--joints names` has it.
   * @returns {{flags: Uint8Array, tips: Uint8Array}} [J] flags for the engine; 1 for joints that hand their weight to their parents
   */
  chooseJoints(mesh, skeleton) {
    return this.#choose(meshOf(mesh), skeletonOf(skeleton));
  }

  #choose(m, s) {
    return this.#with(null, (blocks) => {
      const flags = blocks.room(Uint8Array, s.jointCount), tips = blocks.room(Uint8Array, s.jointCount);
      const at = [this.#mesh(blocks, m), this.#skeleton(blocks, s, s.flags), this.#names(blocks, s.names)];
      this.#wasm.skin_choose_joints(...at, flags, tips);
      return { flags: blocks.take(Uint8Array, flags, s.jointCount), tips: blocks.take(Uint8Array, tips, s.jointCount) };
    });
  }

  // Joints that given rows and answers name are neither left out nor tips, but for those that the user forbids.
  #takeBack(s, chosen, named) {
    const onlyDeforming = s.flags?.some((flag) => flag & FLAG_DEFORMS);
    for (const joint of named) {
      if (joint >= s.jointCount || onlyDeforming || (s.flags?.[joint] & FLAG_NEVER) !== 0) continue;
      chosen.flags[joint] &= ~FLAG_NEVER;
      chosen.tips[joint] = 0;
    }
  }

  /**
   * Predicts skin weights.
   * @param {import("./index.js").Mesh} mesh
   * @param {import("./index.js").Skeleton} skeleton
   * @param {import("./index.js").BindOptions} options
   * @returns {import("./index.js").Bound}
   */
  bind(mesh, skeleton, options = {}) {
    const m = meshOf(mesh), s = skeletonOf(skeleton);
    const n = options.influences ?? 4;
    if (!Number.isInteger(n) || n < 1 || n > 12) throw new SinewError(`bind: options.influences: expected 1 to 12, found ${n}`);
    const method = choice(options.method, ["model", "heat", "distance"], "bind: options.method");
    const asFloat = choice(options.format, ["float", "unorm16"], "bind: options.format") === 0;
    const rigid = choice(options.rigidParts, ["auto", "always", "never"], "bind: options.rigidParts");
    const upAxis = choice(options.upAxis, ["y", "z"], "bind: options.upAxis");
    const allJoints = choice(options.joints, ["names", "all"], "bind: options.joints") === 1;
    const softness = options.softness ?? 1;
    if (!(softness >= 0.25 && softness <= 4)) throw new SinewError(`bind: options.softness: expected 0.25 to 4, found ${softness}`);
    const model = method === 0 ? this.#modelOf("bind", options, "weights") : 0;
    const locked = options.locked == null ? null : typed(Uint8Array, options.locked, "bind: options.locked", m.vertexCount);
    const hints = options.hints == null ? null : typed(Uint8Array, options.hints, "bind: options.hints", m.vertexCount);
    const isGiven = (v) => Boolean(locked?.[v] || hints?.[v]);
    let given = null;
    if (locked || hints) {
      given = skinOf(options.given, m.vertexCount, s.jointCount, "bind: options.given");
      if (given.influenceCount !== n)
        throw new SinewError(`bind: options.given: expected ${n} influences a vertex as the bind has them, found ${given.influenceCount}`);
    }
    const answers = (options.answers ?? []).map((answer, i) => ({
      vertex: answer.vertex,
      kind: choice(answer.kind, ANSWERS, `bind: options.answers[${i}].kind`),
      joint: answer.joint ?? 0,
      alone: answer.alone ? 1 : 0,
    }));
    const questions = options.questions ?? 0;
    const chosen = allJoints
      ? { flags: s.flags ?? new Uint8Array(s.jointCount), tips: new Uint8Array(s.jointCount) }
      : this.#choose(m, s);
    if (!allJoints) {
      const named = answers.filter((answer) => answer.kind === 1).map((answer) => answer.joint);
      for (let v = 0; given && v < m.vertexCount; ++v)
        for (let i = v * n; isGiven(v) && i < (v + 1) * n; ++i) if (given.weights[i] > 0) named.push(given.joints[i]);
      this.#takeBack(s, chosen, new Set(named));
    }
    return this.#with(options.onProgress, (blocks) => {
      const joints = blocks.room(Uint16Array, m.vertexCount * n), weights = blocks.room(Uint16Array, m.vertexCount * n);
      for (let v = 0; given && v < m.vertexCount; ++v) {
        if (!isGiven(v)) continue;
        blocks.view(Uint16Array, joints, m.vertexCount * n).set(given.joints.subarray(v * n, (v + 1) * n), v * n);
        blocks.view(Uint16Array, weights, m.vertexCount * n).set(given.weights.subarray(v * n, (v + 1) * n), v * n);
      }
      const answerWords = new Uint32Array(3 * answers.length);
      answers.forEach((answer, i) => answerWords.set([answer.vertex, answer.kind | (answer.joint << 16), answer.alone], 3 * i));
      const at = {
        mesh: this.#mesh(blocks, m),
        skeleton: this.#skeleton(blocks, s, chosen.flags, UP_AXES[upAxis]),
        options: blocks.struct("options", {
          method,
          influence_count: n,
          surface_vertices: options.surfaceVertices,
          symmetric: options.symmetric ? 1 : 0,
          rigid_parts: rigid,
          softness_percent: Math.round(softness * 100),
          locked: blocks.copy(locked),
          hints: blocks.copy(hints),
          progress: options.onProgress ? this.#wasm.skin_progress() : 0,
          answers: answers.length > 0 ? blocks.copy(answerWords) : 0,
          answer_count: answers.length,
          question_count: questions,
        }),
        confidence: blocks.room(Uint8Array, m.vertexCount),
        questions: questions > 0 ? blocks.room(Uint8Array, questions * QUESTION_BYTES) : 0,
        vertexQuestions: questions > 0 ? blocks.room(Uint32Array, m.vertexCount) : 0,
      };
      const outputs = blocks.struct("bindOutputs", {
        joint_indices: joints,
        weights,
        confidence: at.confidence,
        questions: at.questions,
        vertex_questions: at.vertexQuestions,
      });
      const workspaceBytes = this.#size("bind", blocks, (size) =>
        this.#wasm.sinew_bind_workspace_size(model, m.vertexCount, m.faceCount, m.cornerCount, s.jointCount, at.options, size),
      );
      const workspace = blocks.bytes(workspaceBytes, 64);
      const start = performance.now();
      this.#check("bind", this.#wasm.sinew_bind(model, at.mesh, at.skeleton, at.options, workspace, workspaceBytes, outputs));
      const seconds = (performance.now() - start) / 1000;
      if (!options.keepTips && chosen.tips.includes(1))
        this.#wasm.skin_fold_tips(at.mesh, at.skeleton, blocks.copy(chosen.flags), blocks.copy(chosen.tips), n, joints, weights);
      const told = blocks.read("bindOutputs", outputs);
      const exact = blocks.take(Uint16Array, weights, m.vertexCount * n);
      const leftOut = [];
      chosen.flags.forEach((flag, joint) => flag & FLAG_NEVER && leftOut.push(joint));
      const bound = {
        joints: blocks.take(Uint16Array, joints, m.vertexCount * n),
        weights: asFloat ? Float32Array.from(exact, (weight) => Math.fround(weight / 65535)) : exact,
        influenceCount: n,
        vertexCount: m.vertexCount,
        confidence: blocks.take(Uint8Array, at.confidence, m.vertexCount),
        symmetricVertices: told.symmetric_vertices,
        leftOut,
        seconds,
        workspaceBytes,
      };
      if (questions > 0) {
        bound.questions = Array.from({ length: told.questions_written }, (_, q) => this.#question(blocks, at.questions + q * QUESTION_BYTES));
        bound.vertexQuestions = Int32Array.from(blocks.take(Uint32Array, at.vertexQuestions, m.vertexCount), (q) => (q === NO_QUESTION ? -1 : q));
      }
      return bound;
    });
  }

  #question(blocks, at) {
    const words = blocks.take(Uint32Array, at, QUESTION_BYTES / 4);
    const alternatives = [];
    for (let a = 0; a < words[6]; ++a) {
      const [first, change] = [words[8 + 2 * a], words[9 + 2 * a]];
      alternatives.push({ kind: ANSWERS[first & 0xffff], joint: first >>> 16, change: change / 65536 });
    }
    return {
      vertex: words[0],
      partCount: words[1],
      vertexCount: words[2],
      joint: words[3] & 0xffff,
      share: (words[3] >>> 16) / 65535,
      doubt: words[4] / 65536,
      gain: words[5] / 65536,
      alternatives,
    };
  }

  /**
   * Predicts a skeleton for a bare mesh.
   * @param {import("./index.js").Mesh} mesh
   * @param {import("./index.js").RigOptions} options
   * @returns {import("./index.js").Rig}
   */
  rig(mesh, options = {}) {
    const m = meshOf(mesh);
    const method = choice(options.method, ["votes", "shape"], "rig: options.method");
    const model = method === 0 ? this.#modelOf("rig", options, "skeletons") : 0;
    const hands = options.handsModel == null ? 0 : this.#modelOf("rig", { model: options.handsModel }, "hands");
    return this.#with(options.onProgress, (blocks) => {
      const meshAt = this.#mesh(blocks, m);
      const settings = blocks.struct("rigOptions", {
        up: UP_AXES[choice(options.upAxis, ["y", "z"], "rig: options.upAxis")],
        mirror: choice(options.mirror, ["auto", "always", "never"], "rig: options.mirror"),
        spine_count: options.spine,
        no_toes: options.toes === false ? 1 : 0,
        no_ends: options.ends === false ? 1 : 0,
        progress: options.onProgress ? this.#wasm.skin_progress() : 0,
        method,
      });
      const most = MAX_RIG_JOINTS;
      const arrays = {
        positions: blocks.room(Float32Array, 3 * most),
        parents: blocks.room(Int32Array, most),
        flags: blocks.room(Uint8Array, most),
        joint_classes: blocks.room(Uint8Array, most),
        partners: blocks.room(Int32Array, most),
        confidence: blocks.room(Uint16Array, most),
        names: blocks.room(Uint8Array, most * JOINT_NAME_BYTES),
      };
      const outputs = blocks.struct("rigOutputs", arrays);
      const counts = [m.vertexCount, m.faceCount, m.cornerCount];
      const run = (call, network, ...wanted) => {
        const size = this.#size("rig", blocks, (at) => this.#wasm[`${call}_workspace_size`](network, ...counts, ...wanted, settings, at));
        this.#check("rig", this.#wasm[call](network, meshAt, ...wanted, settings, blocks.bytes(size, 64), size, outputs));
      };
      run("sinew_rig", model);
      const details = (hands !== 0 ? DETAIL_HANDS : 0) | (options.face === true ? DETAIL_FACE : 0) | (options.props === true ? DETAIL_PROPS : 0);
      if (details !== 0) run("sinew_rig_details", hands, details);
      const told = blocks.read("rigOutputs", outputs);
      const count = told.joint_count;
      return {
        names: Array.from({ length: count }, (_, j) => blocks.text(arrays.names + j * JOINT_NAME_BYTES, JOINT_NAME_BYTES)),
        positions: blocks.take(Float32Array, arrays.positions, 3 * count),
        parents: blocks.take(Int32Array, arrays.parents, count),
        flags: blocks.take(Uint8Array, arrays.flags, count),
        classes: blocks.take(Uint8Array, arrays.joint_classes, count),
        partners: blocks.take(Int32Array, arrays.partners, count),
        confidence: Float32Array.from(blocks.take(Uint16Array, arrays.confidence, count), (c) => c / 32768),
        mirrored: told.mirrored === 1,
        facing: told.facing,
        plane: told.plane,
        spread: told.spread,
      };
    });
  }

  #mapRig(blocks, s, rig, name) {
    const up = choice(rig.up, UP, `${name}.up`);
    const ends = rig.ends == null ? null : typed(Uint8Array, rig.ends, `${name}.ends`, s.jointCount);
    return blocks.struct("skeleton", {
      joint_count: s.jointCount,
      positions: blocks.copy(s.positions),
      parents: blocks.copy(s.parents),
      names: s.names == null ? 0 : blocks.copy(blocks.texts(s.names).each),
      ends: blocks.copy(ends),
      up,
    });
  }

  /**
   * Which joint of `source` stands for which of `target`.
   * @returns {import("./index.js").JointMap}
   */
  map(target, source, options = {}) {
    const to = skeletonOf(target, "target"), from = skeletonOf(source, "source");
    const pins = options.pins ?? [];
    return this.#with(null, (blocks) => {
      const count = to.jointCount;
      const arrays = {
        sources: blocks.room(Int32Array, count),
        confidence: blocks.room(Uint16Array, count),
        reasons: blocks.room(Uint8Array, count),
      };
      const outputs = blocks.struct("mapOutputs", arrays);
      const settings = blocks.struct("mapOptions", {
        method: choice(options.method, ["auto", "sinew", "branches"], "map: options.method"),
        pin_count: pins.length,
        pins: pins.length > 0 ? blocks.copy(Int32Array.from(pins.flatMap((pin) => [pin.target, pin.source]))) : 0,
      });
      const size = this.#size("map", blocks, (at) => this.#wasm.sinew_map_workspace_size(count, from.jointCount, at));
      const rigs = [this.#mapRig(blocks, to, target, "target"), this.#mapRig(blocks, from, source, "source")];
      this.#check("map", this.#wasm.sinew_map(...rigs, settings, blocks.bytes(size, 64), size, outputs));
      const told = blocks.read("mapOutputs", outputs);
      return {
        sources: blocks.take(Int32Array, arrays.sources, count),
        confidence: Float32Array.from(blocks.take(Uint16Array, arrays.confidence, count), (c) => c / 32768),
        reasons: Array.from(blocks.take(Uint8Array, arrays.reasons, count), (reason) => MAP_REASONS[reason]),
        mapped: told.mapped,
        certainty: told.certainty / 32768,
        method: told.method === 2 ? "branches" : "sinew",
      };
    });
  }

  /**
   * What joints are for, by their names: numbers of sinew_joint_class, 17 where a name does not say.
   * @returns {{classes: Uint8Array, ends: Uint8Array}}
   */
  jointClasses(skeleton) {
    const s = skeletonOf(skeleton);
    if (s.names == null) return { classes: new Uint8Array(s.jointCount).fill(CLASS_OTHER), ends: new Uint8Array(s.jointCount) };
    return this.#with(null, (blocks) => {
      const classes = blocks.room(Uint8Array, s.jointCount), ends = blocks.room(Uint8Array, s.jointCount);
      this.#wasm.skin_joint_classes(this.#skeleton(blocks, s, null), this.#names(blocks, s.names), classes, ends);
      return { classes: blocks.take(Uint8Array, classes, s.jointCount), ends: blocks.take(Uint8Array, ends, s.jointCount) };
    });
  }

  /** A plan that plays motion of `source` on `target`; free() it. @returns {Retarget} */
  retarget(source, target, options = {}) {
    const from = skeletonOf(source, "source"), to = skeletonOf(target, "target");
    const sources = options.map == null ? this.map(target, source).sources : typed(Int32Array, options.map, "retarget: options.map", to.jointCount);
    let classes = options.classes;
    if (classes == null) {
      const own = this.jointClasses(to), theirs = this.jointClasses(from);
      classes = Uint8Array.from(sources, (s, t) => {
        if (!own.ends[t] && own.classes[t] < CLASS_OTHER) return own.classes[t];
        return s >= 0 && !theirs.ends[s] ? theirs.classes[s] : CLASS_OTHER;
      });
    } else {
      classes = typed(Uint8Array, classes, "retarget: options.classes", to.jointCount);
    }
    return this.#with(null, (blocks) => {
      const settings = blocks.struct("retargetOptions", {
        in_place: options.inPlace ? 1 : 0,
        scale: options.scale,
      });
      const rigs = [[from, source, "source"], [to, target, "target"]].map(([s, rig, name]) =>
        blocks.struct("skeleton", {
          up: choice(options[`${name}Up`], UP, `retarget: options.${name}Up`),
          positions: blocks.copy(s.positions),
          parents: blocks.copy(s.parents),
          rotations: rig.rotations == null ? 0 : blocks.copy(typed(Float32Array, rig.rotations, `${name}.rotations`, 4 * s.jointCount)),
          joint_count: s.jointCount,
        }),
      );
      const size = this.#size("retarget", blocks, (at) => this.#wasm.sinew_retarget_create_workspace_size(from.jointCount, to.jointCount, at));
      const kept = new Blocks(this.#wasm);
      const memory = kept.bytes(size, 64);
      const plan = blocks.room(Uint32Array, 1);
      const status = this.#wasm.sinew_retarget_create(...rigs, blocks.copy(sources), blocks.copy(classes), settings, memory, size, plan);
      if (status !== 0) kept.free();
      this.#check("retarget", status);
      return new Retarget(this.#wasm, (...call) => this.#check(...call), kept, blocks.view(Uint32Array, plan, 1)[0], from.jointCount, to.jointCount, sources);
    });
  }

  /** Positions of a pose without correction: linear blending, or dual quaternions. */
  pose(positions, skin, palette, options = {}) {
    const p = typed(Float32Array, positions, "pose: positions");
    const matrices = typed(Float32Array, palette, "pose: palette");
    const { joints, weights, influenceCount } = skinOf(skin, p.length / 3, matrices.length / 12, "pose: skin");
    return this.#with(null, (blocks) => {
      const out = blocks.room(Float32Array, p.length);
      const call = options.dualQuaternion ? this.#wasm.sinew_skin_dual_quaternion : this.#wasm.sinew_skin_linear;
      const rows = blocks.struct("skin", { joint_indices: blocks.copy(joints), weights: blocks.copy(weights), influence_count: influenceCount });
      this.#check("pose", call(blocks.copy(p), p.length / 3, rows, blocks.copy(matrices), matrices.length / 12, out));
      return blocks.take(Float32Array, out, p.length);
    });
  }

  /** What poses a bound mesh so that bends keep their volume; free() it. @returns {Deformer} */
  deformer(mesh, skeleton, skin, options = {}) {
    const m = meshOf(mesh), s = skeletonOf(skeleton);
    const { joints, weights, influenceCount } = skinOf(skin, m.vertexCount, s.jointCount);
    return this.#with(null, (blocks) => {
      const settings = blocks.struct("deformOptions", {
        method: choice(options.method, ["volume", "xpbd", "delta-mush"], "deformer: options.method"),
        cell_count: options.cells,
        round_count: options.rounds,
        softness: options.softness,
        no_twist_spread: options.twistSpread === false ? 1 : 0,
        no_contact: options.contact === false ? 1 : 0,
        body_contact: options.bodyContact === true ? 1 : 0,
        no_smoothing: options.smoothing === false ? 1 : 0,
      });
      const meshAt = this.#mesh(blocks, m);
      const size = this.#size("deformer", blocks, (at) =>
        this.#wasm.sinew_deform_create_workspace_size(meshAt, s.jointCount, influenceCount, settings, at),
      );
      const kept = new Blocks(this.#wasm);
      const memory = kept.bytes(size, 64);
      const deformer = kept.struct("deformer");
      const rows = blocks.struct("skin", { joint_indices: blocks.copy(joints), weights: blocks.copy(weights), influence_count: influenceCount });
      const status = this.#wasm.sinew_deform_create(meshAt, this.#skeleton(blocks, s, null), rows, settings, memory, size, deformer);
      if (status !== 0) kept.free();
      this.#check("deformer", status);
      return new Deformer(this.#wasm, (...call) => this.#check(...call), kept, deformer);
    });
  }

  /**
   * Carries the weights of a bound character to another mesh.
   * @returns {import("./index.js").Transferred}
   */
  transfer(source, mesh, skeleton, options = {}) {
    const fromMesh = meshOf(source.mesh, "source.mesh"), fromSkeleton = skeletonOf(source.skeleton, "source.skeleton");
    const skin = skinOf(source.skin, fromMesh.vertexCount, fromSkeleton.jointCount, "source.skin");
    const m = meshOf(mesh), s = skeletonOf(skeleton);
    const n = options.influences ?? 4;
    const model = options.model == null && this.model == null ? 0 : this.#modelOf("transfer", options, "weights");
    const asFloat = choice(options.format, ["float", "unorm16"], "transfer: options.format") === 0;
    let jointMap = options.jointMap;
    if (jointMap == null) jointMap = options.garment ? Int32Array.from(fromSkeleton.parents, (_, j) => j) : this.map(source.skeleton, skeleton).sources;
    jointMap = typed(Int32Array, jointMap, "transfer: options.jointMap", fromSkeleton.jointCount);
    return this.#with(options.onProgress, (blocks) => {
      const character = blocks.struct("boundCharacter", {
        mesh: this.#mesh(blocks, fromMesh),
        skeleton: this.#skeleton(blocks, fromSkeleton, fromSkeleton.flags, UP_AXES[choice(options.sourceUpAxis, ["y", "z"], "transfer: options.sourceUpAxis")]),
        joint_indices: blocks.copy(skin.joints),
        weights: blocks.copy(skin.weights),
        influence_count: skin.influenceCount,
        joint_map: blocks.copy(jointMap),
      });
      const settings = blocks.struct("transferOptions", {
        method: choice(options.method, ["auto", "nearest", "biharmonic", "rebind"], "transfer: options.method"),
        influence_count: n,
        garment: options.garment ? 1 : 0,
        progress: options.onProgress ? this.#wasm.skin_progress() : 0,
      });
      const up = UP_AXES[choice(options.upAxis, ["y", "z"], "transfer: options.upAxis")];
      const meshAt = this.#mesh(blocks, m), skeletonAt = this.#skeleton(blocks, s, s.flags, up);
      const capacity = 64;
      const arrays = {
        joint_indices: blocks.room(Uint16Array, m.vertexCount * n),
        weights: blocks.room(Uint16Array, m.vertexCount * n),
        confidence: blocks.room(Uint8Array, m.vertexCount),
        parts: blocks.bytes(capacity * 32),
        part_capacity: capacity,
      };
      const outputs = blocks.struct("transferOutputs", arrays);
      const size = this.#size("transfer", blocks, (at) =>
        this.#wasm.sinew_transfer_workspace_size(model, character, meshAt, skeletonAt, settings, at),
      );
      const workspace = blocks.bytes(size, 64);
      this.#check("transfer", this.#wasm.sinew_transfer(model, character, meshAt, skeletonAt, settings, workspace, size, outputs));
      const told = blocks.read("transferOutputs", outputs);
      const exact = blocks.take(Uint16Array, arrays.weights, m.vertexCount * n);
      return {
        joints: blocks.take(Uint16Array, arrays.joint_indices, m.vertexCount * n),
        weights: asFloat ? Float32Array.from(exact, (weight) => Math.fround(weight / 65535)) : exact,
        influenceCount: n,
        vertexCount: m.vertexCount,
        confidence: blocks.take(Uint8Array, arrays.confidence, m.vertexCount),
        carried: told.carried_q16 / 65536,
        parts: Array.from({ length: Math.min(told.part_count, capacity) }, (_, p) => {
          const part = blocks.read("transferPart", arrays.parts + 32 * p);
          return { vertex: part.vertex, vertexCount: part.vertex_count, reason: TRANSFER_REASONS[part.reason], carried: part.carried_q16 / 65536 };
        }),
      };
    });
  }

  /** Which joint becomes part of which on a skeleton of fewer joints: [J], itself where it stays. @returns {Uint32Array} */
  simplify(skeleton, options = {}) {
    const s = skeletonOf(skeleton);
    return this.#with(null, (blocks) => {
      const areas = options.areas == null ? null : typed(Float32Array, options.areas, "simplify: options.areas", s.jointCount);
      const keep = options.keep == null ? null : typed(Uint8Array, options.keep, "simplify: options.keep", s.jointCount);
      const settings = blocks.struct("simplifyOptions", {
        level: choice(options.level, ["high", "low"], "simplify: options.level"),
        joint_count: options.joints,
      });
      const size = this.#size("simplify", blocks, (at) => this.#wasm.sinew_simplify_workspace_size(s.jointCount, at));
      const into = blocks.room(Uint32Array, s.jointCount);
      const arrays = [this.#skeleton(blocks, s, null), blocks.copy(areas), blocks.copy(keep)];
      this.#check("simplify", this.#wasm.sinew_simplify(...arrays, settings, blocks.bytes(size, 64), size, into));
      return blocks.take(Uint32Array, into, s.jointCount);
    });
  }
}

/** Plays poses of one skeleton on another. Poses: local rotations [J x 4] x y z w and translations [J x 3], in the parents' axes. */
export class Retarget {
  #wasm;
  #check;
  #kept;
  #plan;
  #sourceCount;
  #targetCount;
  constructor(wasm, check, kept, plan, sourceCount, targetCount, map) {
    [this.#wasm, this.#check, this.#kept, this.#plan] = [wasm, check, kept, plan];
    [this.#sourceCount, this.#targetCount] = [sourceCount, targetCount];
    /** [target J] joint of the source, -1 = none */
    this.map = map;
  }

  /**
   * All frames of a clip, one behind the other.
   * @param {{rotations: Float32Array, translations: Float32Array}} clip
   * @param {{body?: object, fps?: number, onProgress?: Function}} options body: the target's {positions, indices, skin}: feet keep their contacts
   */
  clip(clip, options = {}) {
    const rotations = typed(Float32Array, clip.rotations, "clip.rotations");
    const frames = rotations.length / (4 * this.#sourceCount);
    if (!Number.isInteger(frames) || frames === 0)
      throw new SinewError(`clip.rotations: expected whole frames of 4 x ${this.#sourceCount} numbers, found ${rotations.length}`);
    const translations = typed(Float32Array, clip.translations, "clip.translations", 3 * this.#sourceCount * frames);
    const blocks = new Blocks(this.#wasm);
    try {
      const [from, to] = [this.#sourceCount, this.#targetCount];
      const inRotations = blocks.copy(rotations), inTranslations = blocks.copy(translations);
      const outRotations = blocks.room(Float32Array, 4 * to * frames), outTranslations = blocks.room(Float32Array, 3 * to * frames);
      const heights = blocks.room(Float32Array, frames), groundAt = blocks.room(Float32Array, 1);
      const source = (f) => [inRotations + 16 * from * f, inTranslations + 12 * from * f];
      for (let f = 0; f < frames; ++f) this.#check("retarget", this.#wasm.sinew_retarget_height(this.#plan, ...source(f), heights + 4 * f));
      this.#check("retarget", this.#wasm.sinew_retarget_ground(this.#plan, heights, frames, groundAt));
      const ground = blocks.view(Float32Array, groundAt, 1)[0];
      for (let f = 0; f < frames; ++f) {
        const target = [outRotations + 16 * to * f, outTranslations + 12 * to * f];
        this.#check("retarget", this.#wasm.sinew_retarget_frame(this.#plan, ...source(f), ground, ...target));
      }
      if (options.body != null) this.#contacts(blocks, options, { inRotations, inTranslations, outRotations, outTranslations, frames, ground });
      return {
        rotations: blocks.take(Float32Array, outRotations, 4 * to * frames),
        translations: blocks.take(Float32Array, outTranslations, 3 * to * frames),
        frameCount: frames,
      };
    } finally {
      blocks.free();
    }
  }

  #contacts(blocks, options, made) {
    const mesh = meshOf(options.body, "options.body");
    if (mesh.faceOffsets != null) throw new SinewError("options.body: expected triangles as `indices`, found polygons");
    const skin = skinOf(options.body.skin, mesh.vertexCount, this.#targetCount, "options.body.skin");
    const body = blocks.struct("motionBody", {
      positions: blocks.copy(mesh.positions),
      triangles: blocks.copy(mesh.faceVertices),
      joint_indices: blocks.copy(skin.joints),
      weights: blocks.copy(skin.weights),
      influence_count: skin.influenceCount,
      vertex_count: mesh.vertexCount,
      triangle_count: mesh.faceCount,
    });
    const clip = blocks.struct("motionClip", {
      source_rotations: made.inRotations,
      source_translations: made.inTranslations,
      rotations: made.outRotations,
      translations: made.outTranslations,
      frame_count: made.frames,
      ground: made.ground,
    });
    const settings = blocks.struct("contactOptions", { fps: options.fps });
    const sizeAt = blocks.room(Uint32Array, 1);
    this.#check("retarget", this.#wasm.sinew_retarget_contacts_workspace_size(this.#plan, body, made.frames, sizeAt));
    const size = blocks.view(Uint32Array, sizeAt, 1)[0];
    this.#check("retarget", this.#wasm.sinew_retarget_contacts(this.#plan, 0, body, clip, settings, blocks.bytes(size, 64), size));
  }

  free() {
    this.#kept.free();
  }
}

/** Poses one bound mesh. */
export class Deformer {
  #wasm;
  #check;
  #kept;
  #address;
  constructor(wasm, check, kept, address) {
    [this.#wasm, this.#check, this.#kept, this.#address] = [wasm, check, kept, address];
    const told = kept.read("deformer", address);
    this.vertexCount = told.vertex_count;
    this.jointCount = told.joint_count;
    this.tetrahedronCount = told.tetrahedron_count;
  }

  /**
   * Positions of a pose.
   * @param {Float32Array} palette [J x 12] row-major 3x4, pose times inverse bind per joint
   * @returns {{positions: Float32Array, corrected: boolean}} corrected: false where the matrices are no rotations of one scale
   */
  pose(palette) {
    const matrices = typed(Float32Array, palette, "pose: palette", 12 * this.jointCount);
    const blocks = new Blocks(this.#wasm);
    try {
      const positions = blocks.room(Float32Array, 3 * this.vertexCount);
      const outputs = blocks.struct("deformOutputs", { positions });
      const size = blocks.read("deformer", this.#address).pose_bytes;
      const palette_at = blocks.copy(matrices);
      this.#check("pose", this.#wasm.sinew_deform_pose(this.#address, palette_at, blocks.bytes(size, 64), size, outputs));
      return { positions: blocks.take(Float32Array, positions, 3 * this.vertexCount), corrected: blocks.read("deformOutputs", outputs).corrected === 1 };
    } finally {
      blocks.free();
    }
  }

  free() {
    this.#kept.free();
  }
}
