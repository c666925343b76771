// SPDX-License-Identifier: MIT
// Skin weights: the calls that a module with nothing else has too.
import { Model } from "./calls.js";
import { LAYOUTS, WORDS } from "./layouts.js";
import { Blocks, SinewError } from "./memory.js";
import { choice, meshOf, skeletonOf, skinOf, typed } from "./shapes.js";

const FLAG_NEVER = 1;
const FLAG_DEFORMS = 2;
const UP_AXES = [2, 3]; // sinew_up of "y" and "z"
const NO_QUESTION = 0xffffffff;
const QUESTION_BYTES = LAYOUTS.question.size;
const ANSWERS = WORDS.answerKind;

/** Binds meshes. Made by load() of ./bind, and part of what load() of ./index gives. */
export class Binder {
  #calls;
  /** The model that bind() and transfer() use where their options name none. @type {Model | null} */
  model = null;

  /** @param {import("./calls.js").Calls} calls */
  constructor(calls) {
    this.#calls = calls;
    const blocks = new Blocks(calls.wasm);
    this.version = blocks.text(calls.wasm.sinew_version() >>> 0, 32);
    /** "simd128" or "ref" */
    this.kernel = blocks.text(calls.wasm.sinew_kernel_name(calls.wasm.sinew_kernel_select(0)) >>> 0, 32);
  }

  /**
   * Checks a model file and keeps it.
   * @param {ArrayBuffer | ArrayBufferView} bytes
   */
  openModel(bytes) {
    return new Model(this.#calls.wasm, bytes);
  }

  /**
   * Which joints may get weight, by their names and places, as the command's `--joints names` has it.
   * @param {import("./index.js").Mesh} mesh
   * @param {import("./index.js").Skeleton} skeleton
   * @returns {{flags: Uint8Array, tips: Uint8Array}} [J] flags for the engine; 1 for joints that hand their weight to their parents
   */
  chooseJoints(mesh, skeleton) {
    return this.#choose(meshOf(mesh), skeletonOf(skeleton));
  }

  /** @param {any} m of meshOf() @param {any} s of skeletonOf() */
  #choose(m, s) {
    return this.#calls.with(null, (blocks) => {
      const flags = blocks.room(Uint8Array, s.jointCount), tips = blocks.room(Uint8Array, s.jointCount);
      const at = [this.#calls.mesh(blocks, m), this.#calls.skeleton(blocks, s, s.flags), this.#calls.names(blocks, s.names)];
      this.#calls.wasm.skin_choose_joints(...at, flags, tips);
      return { flags: blocks.take(Uint8Array, flags, s.jointCount), tips: blocks.take(Uint8Array, tips, s.jointCount) };
    });
  }

  // Joints that given rows and answers name are neither left out nor tips, but for those that the user forbids.
  /** @param {any} s @param {{ flags: Uint8Array, tips: Uint8Array }} chosen @param {Iterable<number>} named */
  #takeBack(s, chosen, named) {
    const onlyDeforming = s.flags?.some((/** @type {number} */ flag) => flag & FLAG_DEFORMS);
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
    const method = choice(options.method, WORDS.method, "bind: options.method");
    const asFloat = choice(options.format, ["float", "unorm16"], "bind: options.format") === 0;
    const rigid = choice(options.rigidParts, WORDS.rigidParts, "bind: options.rigidParts");
    const upAxis = choice(options.upAxis, ["y", "z"], "bind: options.upAxis");
    const allJoints = choice(options.joints, ["names", "all"], "bind: options.joints") === 1;
    const softness = options.softness ?? 1;
    if (!(softness >= 0.25 && softness <= 4)) throw new SinewError(`bind: options.softness: expected 0.25 to 4, found ${softness}`);
    const model = method === 0 ? this.#calls.modelOf("bind", options, "weights", this.model) : 0;
    const locked = options.locked == null ? null : typed(Uint8Array, options.locked, "bind: options.locked", m.vertexCount);
    const hints = options.hints == null ? null : typed(Uint8Array, options.hints, "bind: options.hints", m.vertexCount);
    const isGiven = (/** @type {number} */ v) => Boolean(locked?.[v] || hints?.[v]);
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
    return this.#calls.with(options.onProgress, (blocks) => {
      const joints = blocks.room(Uint16Array, m.vertexCount * n), weights = blocks.room(Uint16Array, m.vertexCount * n);
      for (let v = 0; given && v < m.vertexCount; ++v) {
        if (!isGiven(v)) continue;
        blocks.view(Uint16Array, joints, m.vertexCount * n).set(given.joints.subarray(v * n, (v + 1) * n), v * n);
        blocks.view(Uint16Array, weights, m.vertexCount * n).set(given.weights.subarray(v * n, (v + 1) * n), v * n);
      }
      const answerWords = new Uint32Array(3 * answers.length);
      answers.forEach((answer, i) => answerWords.set([answer.vertex, answer.kind | (answer.joint << 16), answer.alone], 3 * i));
      const at = {
        mesh: this.#calls.mesh(blocks, m),
        skeleton: this.#calls.skeleton(blocks, s, chosen.flags, UP_AXES[upAxis]),
        options: blocks.struct("bindOptions", {
          method,
          influence_count: n,
          surface_vertices: options.surfaceVertices,
          symmetric: options.symmetric ? 1 : 0,
          rigid_parts: rigid,
          softness_percent: Math.round(softness * 100),
          locked: blocks.copy(locked),
          hints: blocks.copy(hints),
          progress: options.onProgress ? this.#calls.wasm.skin_progress() : 0,
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
      const workspaceBytes = this.#calls.size("bind", blocks, (size) =>
        this.#calls.wasm.sinew_bind_workspace_size(model, m.vertexCount, m.faceCount, m.cornerCount, s.jointCount, at.options, size),
      );
      const workspace = blocks.bytes(workspaceBytes, 64);
      const start = performance.now();
      this.#calls.check("bind", this.#calls.wasm.sinew_bind(model, at.mesh, at.skeleton, at.options, workspace, workspaceBytes, outputs));
      const seconds = (performance.now() - start) / 1000;
      if (!options.keepTips && chosen.tips.includes(1))
        this.#calls.wasm.skin_fold_tips(at.mesh, at.skeleton, blocks.copy(chosen.flags), blocks.copy(chosen.tips), n, joints, weights);
      const told = blocks.read("bindOutputs", outputs);
      const exact = blocks.take(Uint16Array, weights, m.vertexCount * n);
      /** @type {number[]} */
      const leftOut = [];
      chosen.flags.forEach((/** @type {number} */ flag, /** @type {number} */ joint) => flag & FLAG_NEVER && leftOut.push(joint));
      /** @type {any} */
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

  /** @param {import("./memory.js").Blocks} blocks @param {number} at */
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
}
