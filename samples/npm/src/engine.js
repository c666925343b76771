// SPDX-License-Identifier: MIT
// The engine's calls beside binding: arguments to the module's memory, results out of it. One thread, one call at a time.
import { Binder } from "./binder.js";
import { JOINT_NAME_BYTES, MAX_RIG_JOINTS, WITHOUT_CONTACTS, WITHOUT_ENDS, WITHOUT_RANGE, WITHOUT_SMOOTHING, WITHOUT_TOES, WITHOUT_TWIST_SPREAD, WORDS } from "./layouts.js";
import { Blocks, SinewError } from "./memory.js";
import { choice, meshOf, skeletonOf, skinOf, typed } from "./shapes.js";

const CLASS_OTHER = 17;
const ROLE_END = 4; // sinew_joint_role
const UP_AXES = [2, 3]; // sinew_up of "y" and "z"
const FRONTS = ["auto", "+z", "-z", "+x", "-x", "+y", "-y"]; // in the order of sinew_front
const [DETAIL_HANDS, DETAIL_FACE, DETAIL_PROPS] = [1, 2, 4]; // sinew_rig_detail

/** The engine. Made by load(). */
export class Skin extends Binder {
  #calls;

  /** @param {import("./calls.js").Calls} calls */
  constructor(calls) {
    super(calls);
    this.#calls = calls;
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
    const model = method === 0 ? this.#calls.modelOf("rig", options, "skeletons") : 0;
    const fronts = options.frontModel == null ? 0 : this.#calls.modelOf("rig", { model: options.frontModel }, "fronts");
    const hands = options.handsModel == null ? 0 : this.#calls.modelOf("rig", { model: options.handsModel }, "hands");
    return this.#calls.with(options.onProgress, (blocks) => {
      const meshAt = this.#calls.mesh(blocks, m);
      const settings = blocks.struct("rigOptions", {
        up: [2, 3, 0][choice(options.upAxis, ["y", "z", "auto"], "rig: options.upAxis")],
        front: choice(options.front, FRONTS, "rig: options.front"),
        front_model: fronts,
        mirror: choice(options.mirror, WORDS.mirror, "rig: options.mirror"),
        spine_count: options.spine,
        without: (options.toes === false ? WITHOUT_TOES : 0) | (options.ends === false ? WITHOUT_ENDS : 0),
        progress: options.onProgress ? this.#calls.wasm.skin_progress() : 0,
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
        const size = this.#calls.size("rig", blocks, (at) => this.#calls.wasm[`${call}_workspace_size`](network, ...counts, ...wanted, settings, at));
        this.#calls.check("rig", this.#calls.wasm[call](network, meshAt, ...wanted, settings, blocks.bytes(size, 64), size, outputs));
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
        front: Array.from(told.front),
        up: /** @type {"y" | "z"} */ (WORDS.up[told.up]),
        frontCertainty: told.front_confidence,
        upCertainty: told.up_confidence,
      };
    });
  }

  #mapRig(blocks, s, rig, name) {
    const up = choice(rig.up, WORDS.up, `${name}.up`);
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
    return this.#calls.with(null, (blocks) => {
      const count = to.jointCount;
      const arrays = {
        sources: blocks.room(Int32Array, count),
        confidence: blocks.room(Uint16Array, count),
        reasons: blocks.room(Uint8Array, count),
      };
      const outputs = blocks.struct("mapOutputs", arrays);
      const settings = blocks.struct("mapOptions", {
        method: choice(options.method, WORDS.mapMethod, "map: options.method"),
        branches_first: choice(options.branchesFirst, WORDS.branchesFirst, "map: options.branchesFirst"),
        branches_cost: choice(options.branchesCost, WORDS.branchesCost, "map: options.branchesCost"),
        pin_count: pins.length,
        pins: pins.length > 0 ? blocks.copy(Int32Array.from(pins.flatMap((pin) => [pin.target, pin.source]))) : 0,
      });
      const size = this.#calls.size("map", blocks, (at) => this.#calls.wasm.sinew_map_workspace_size(count, from.jointCount, at));
      const rigs = [this.#mapRig(blocks, to, target, "target"), this.#mapRig(blocks, from, source, "source")];
      this.#calls.check("map", this.#calls.wasm.sinew_map(...rigs, settings, blocks.bytes(size, 64), size, outputs));
      const told = blocks.read("mapOutputs", outputs);
      return {
        sources: blocks.take(Int32Array, arrays.sources, count),
        confidence: Float32Array.from(blocks.take(Uint16Array, arrays.confidence, count), (c) => c / 32768),
        reasons: Array.from(blocks.take(Uint8Array, arrays.reasons, count), (reason) => WORDS.mapReason[reason]),
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
    return this.#calls.with(null, (blocks) => {
      const count = s.jointCount;
      const arrays = { classes: blocks.room(Uint8Array, count), roles: blocks.room(Uint8Array, count) };
      const size = this.#calls.size("jointClasses", blocks, (at) => this.#calls.wasm.sinew_joint_classes_workspace_size(count, at));
      this.#calls.check("jointClasses", this.#calls.wasm.sinew_joint_classes(this.#mapRig(blocks, s, skeleton, "skeleton"), 0, blocks.bytes(size, 64), size, blocks.struct("jointVerdicts", arrays)));
      return {
        classes: blocks.take(Uint8Array, arrays.classes, count).map((c) => Math.min(c, CLASS_OTHER)), // details and fingers are no limbs
        ends: blocks.take(Uint8Array, arrays.roles, count).map((role) => (role === ROLE_END ? 1 : 0)),
      };
    });
  }

  // What joints of a target are for, as the command finds it: by names, by those of their sources, or by a human body.
  #limbClasses(to, target, from, source, sources) {
    return this.#calls.with(null, (blocks) => {
      const classes = blocks.room(Uint8Array, to.jointCount);
      const rigs = [this.#mapRig(blocks, to, target, "target"), this.#mapRig(blocks, from, source, "source")];
      const size = this.#calls.size("retarget", blocks, (at) => this.#calls.wasm.sinew_limb_classes_workspace_size(to.jointCount, from.jointCount, at));
      this.#calls.check("retarget", this.#calls.wasm.sinew_limb_classes(...rigs, blocks.copy(sources), blocks.bytes(size, 64), size, classes));
      return blocks.take(Uint8Array, classes, to.jointCount);
    });
  }

  // Blocks of what a plan of `source` and `target` is made of, beside the answer.
  #pair(blocks, source, target, options) {
    const from = skeletonOf(source, "source"), to = skeletonOf(target, "target");
    const sources = options.map == null ? this.map(target, source).sources : typed(Int32Array, options.map, "retarget: options.map", to.jointCount);
    const classes = options.classes == null ? this.#limbClasses(to, target, from, source, sources) : typed(Uint8Array, options.classes, "retarget: options.classes", to.jointCount);
    const settings = blocks.struct("retargetOptions", {
      in_place: options.inPlace ? 1 : 0,
      scale: options.scale,
      arm_spread: options.armSpread,
    });
    const rigs = [[from, source, "source"], [to, target, "target"]].map(([s, rig, name]) =>
      blocks.struct("skeleton", {
        up: choice(options[`${name}Up`], WORDS.up, `retarget: options.${name}Up`),
        positions: blocks.copy(s.positions),
        parents: blocks.copy(s.parents),
        rotations: rig.rotations == null ? 0 : blocks.copy(typed(Float32Array, rig.rotations, `${name}.rotations`, 4 * s.jointCount)),
        joint_count: s.jointCount,
      }),
    );
    return { from, to, sources, classes, inputs: [...rigs, blocks.copy(sources), blocks.copy(classes), settings] };
  }

  /** A plan that plays motion of `source` on `target`; free() it. @returns {Retarget} */
  retarget(source, target, options = {}) {
    return this.#calls.with(null, (blocks) => {
      const { from, to, sources, classes, inputs } = this.#pair(blocks, source, target, options);
      const size = this.#calls.size("retarget", blocks, (at) => this.#calls.wasm.sinew_retarget_create_workspace_size(from.jointCount, to.jointCount, at));
      const kept = new Blocks(this.#calls.wasm);
      const memory = kept.bytes(size, 64);
      const plan = blocks.room(Uint32Array, 1);
      const status = this.#calls.wasm.sinew_retarget_create(...inputs, memory, size, plan);
      if (status !== 0) kept.free();
      this.#calls.check("retarget", status);
      return new Retarget(this.#calls.wasm, (name, code) => this.#calls.check(name, code), kept, blocks.view(Uint32Array, plan, 1)[0], from.jointCount, to.jointCount, sources, classes);
    });
  }

  /** Streaming retargeting, a frame in and a frame out; free() it. @returns {RetargetStream} */
  retargetStream(source, target, options = {}) {
    const kept = new Blocks(this.#calls.wasm);
    try {
      return this.#calls.with(null, (blocks) => {
        const { from, to, sources, classes, inputs } = this.#pair(blocks, source, target, options);
        const body = options.body == null ? null : bodyOf(options.body, to.jointCount);
        const moving = options.sourceBody == null ? null : bodyOf(options.sourceBody, from.jointCount, "options.sourceBody");
        const [vertices, triangles] = body == null ? [0, 0] : [body.vertex_count, body.mesh.faceCount];
        if (moving != null && moving.vertex_count !== vertices) throw new SinewError(`options.sourceBody: expected ${vertices} vertices as options.body has, found ${moving.vertex_count}`);
        const settings = blocks.struct("retargetStreamOptions", {
          fps: options.fps,
          ground: options.ground,
          has_ground: options.ground == null ? 0 : 1,
          without: (options.contacts === false ? WITHOUT_CONTACTS : 0) | (options.range === false ? WITHOUT_RANGE : 0),
          source: moving == null ? 0 : bodyStruct(kept, moving),
        });
        const size = this.#calls.size("retarget", blocks, (at) => this.#calls.wasm.sinew_retarget_stream_workspace_size(from.jointCount, to.jointCount, vertices, triangles, at));
        const stream = blocks.room(Uint32Array, 1);
        const view = body == null ? 0 : bodyStruct(kept, body);
        this.#calls.check("retarget", this.#calls.wasm.sinew_retarget_stream_create(...inputs, view, settings, kept.bytes(size, 64), size, stream));
        return new RetargetStream(this.#calls.wasm, (name, code) => this.#calls.check(name, code), kept, blocks.view(Uint32Array, stream, 1)[0], from.jointCount, to.jointCount, sources, classes);
      });
    } catch (error) {
      kept.free();
      throw error;
    }
  }

  /** Positions of a pose without correction: linear blending, or dual quaternions. */
  pose(positions, skin, palette, options = {}) {
    const p = typed(Float32Array, positions, "pose: positions");
    const matrices = typed(Float32Array, palette, "pose: palette");
    const { joints, weights, influenceCount } = skinOf(skin, p.length / 3, matrices.length / 12, "pose: skin");
    return this.#calls.with(null, (blocks) => {
      const out = blocks.room(Float32Array, p.length);
      const call = options.dualQuaternion ? this.#calls.wasm.sinew_skin_dual_quaternion : this.#calls.wasm.sinew_skin_linear;
      const rows = blocks.struct("skin", { joint_indices: blocks.copy(joints), weights: blocks.copy(weights), influence_count: influenceCount });
      this.#calls.check("pose", call(blocks.copy(p), p.length / 3, rows, blocks.copy(matrices), matrices.length / 12, out));
      return blocks.take(Float32Array, out, p.length);
    });
  }

  /** A deformer, which poses a bound mesh so that bends keep their volume; free() it. @returns {Deformer} */
  deformer(mesh, skeleton, skin, options = {}) {
    const m = meshOf(mesh), s = skeletonOf(skeleton);
    const { joints, weights, influenceCount } = skinOf(skin, m.vertexCount, s.jointCount);
    return this.#calls.with(null, (blocks) => {
      const settings = blocks.struct("deformOptions", {
        method: choice(options.method, WORDS.deformMethod, "deformer: options.method"),
        cell_count: options.cells,
        round_count: options.rounds,
        softness: options.softness,
        without: (options.twistSpread === false ? WITHOUT_TWIST_SPREAD : 0) | (options.contact === false ? WITHOUT_CONTACTS : 0) | (options.smoothing === false ? WITHOUT_SMOOTHING : 0),
        body_contact: options.bodyContact === true ? 1 : 0,
      });
      const meshAt = this.#calls.mesh(blocks, m);
      const size = this.#calls.size("deformer", blocks, (at) =>
        this.#calls.wasm.sinew_deform_create_workspace_size(meshAt, s.jointCount, influenceCount, settings, at),
      );
      const kept = new Blocks(this.#calls.wasm);
      const memory = kept.bytes(size, 64);
      const deformer = kept.struct("deformer");
      const rows = blocks.struct("skin", { joint_indices: blocks.copy(joints), weights: blocks.copy(weights), influence_count: influenceCount });
      const status = this.#calls.wasm.sinew_deform_create(meshAt, this.#calls.skeleton(blocks, s, null), rows, settings, memory, size, deformer);
      if (status !== 0) kept.free();
      this.#calls.check("deformer", status);
      return new Deformer(this.#calls.wasm, (name, code) => this.#calls.check(name, code), kept, deformer);
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
    const model = options.model == null && this.model == null ? 0 : this.#calls.modelOf("transfer", options, "weights", this.model);
    const asFloat = choice(options.format, ["float", "unorm16"], "transfer: options.format") === 0;
    let jointMap = options.jointMap;
    if (jointMap == null) jointMap = options.garment ? Int32Array.from(fromSkeleton.parents, (_, j) => j) : this.map(source.skeleton, skeleton).sources;
    jointMap = typed(Int32Array, jointMap, "transfer: options.jointMap", fromSkeleton.jointCount);
    return this.#calls.with(options.onProgress, (blocks) => {
      const character = blocks.struct("boundCharacter", {
        mesh: this.#calls.mesh(blocks, fromMesh),
        skeleton: this.#calls.skeleton(blocks, fromSkeleton, fromSkeleton.flags, UP_AXES[choice(options.sourceUpAxis, ["y", "z"], "transfer: options.sourceUpAxis")]),
        joint_indices: blocks.copy(skin.joints),
        weights: blocks.copy(skin.weights),
        influence_count: skin.influenceCount,
        joint_map: blocks.copy(jointMap),
      });
      const settings = blocks.struct("transferOptions", {
        method: choice(options.method, WORDS.transferMethod, "transfer: options.method"),
        influence_count: n,
        garment: options.garment ? 1 : 0,
        progress: options.onProgress ? this.#calls.wasm.skin_progress() : 0,
      });
      const up = UP_AXES[choice(options.upAxis, ["y", "z"], "transfer: options.upAxis")];
      const meshAt = this.#calls.mesh(blocks, m), skeletonAt = this.#calls.skeleton(blocks, s, s.flags, up);
      const capacity = 64;
      const arrays = {
        joint_indices: blocks.room(Uint16Array, m.vertexCount * n),
        weights: blocks.room(Uint16Array, m.vertexCount * n),
        confidence: blocks.room(Uint8Array, m.vertexCount),
        parts: blocks.bytes(capacity * 32),
        part_capacity: capacity,
      };
      const outputs = blocks.struct("transferOutputs", arrays);
      const size = this.#calls.size("transfer", blocks, (at) =>
        this.#calls.wasm.sinew_transfer_workspace_size(model, character, meshAt, skeletonAt, settings, at),
      );
      const workspace = blocks.bytes(size, 64);
      this.#calls.check("transfer", this.#calls.wasm.sinew_transfer(model, character, meshAt, skeletonAt, settings, workspace, size, outputs));
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
          return { vertex: part.vertex, vertexCount: part.vertex_count, reason: WORDS.transferReason[part.reason], carried: part.carried_q16 / 65536 };
        }),
      };
    });
  }

  /** Simplifies a skeleton: [J] the joint that each joint is merged into, itself if it stays. @returns {Uint32Array} */
  simplify(skeleton, options = {}) {
    const s = skeletonOf(skeleton);
    return this.#calls.with(null, (blocks) => {
      const areas = options.areas == null ? null : typed(Float32Array, options.areas, "simplify: options.areas", s.jointCount);
      const keep = options.keep == null ? null : typed(Uint8Array, options.keep, "simplify: options.keep", s.jointCount);
      const settings = blocks.struct("simplifyOptions", {
        level: choice(options.level, WORDS.simplifyLevel, "simplify: options.level"),
        joint_count: options.joints,
      });
      const size = this.#calls.size("simplify", blocks, (at) => this.#calls.wasm.sinew_simplify_workspace_size(s.jointCount, at));
      const into = blocks.room(Uint32Array, s.jointCount);
      const arrays = [this.#calls.skeleton(blocks, s, null), blocks.copy(areas), blocks.copy(keep)];
      this.#calls.check("simplify", this.#calls.wasm.sinew_simplify(...arrays, settings, blocks.bytes(size, 64), size, into));
      return blocks.take(Uint32Array, into, s.jointCount);
    });
  }
}

// A bound mesh as what contacts look at.
function bodyOf(body, jointCount, name = "options.body") {
  const mesh = meshOf(body, name);
  if (mesh.faceOffsets != null) throw new SinewError(`${name}: expected triangles as \`indices\`, found polygons`);
  const skin = skinOf(body.skin, mesh.vertexCount, jointCount, `${name}.skin`);
  return { mesh, skin, vertex_count: mesh.vertexCount };
}

function bodyStruct(blocks, { mesh, skin }) {
  return blocks.struct("motionBody", {
    positions: blocks.copy(mesh.positions),
    triangles: blocks.copy(mesh.faceVertices),
    joint_indices: blocks.copy(skin.joints),
    weights: blocks.copy(skin.weights),
    influence_count: skin.influenceCount,
    vertex_count: mesh.vertexCount,
    triangle_count: mesh.faceCount,
  });
}

/** Plays poses of one skeleton on another. Poses: local rotations [J x 4] x y z w and translations [J x 3], in the parents' axes. */
export class Retarget {
  #wasm;
  #check;
  #kept;
  #plan;
  #sourceCount;
  #targetCount;
  constructor(wasm, check, kept, plan, sourceCount, targetCount, map, classes) {
    [this.#wasm, this.#check, this.#kept, this.#plan] = [wasm, check, kept, plan];
    [this.#sourceCount, this.#targetCount] = [sourceCount, targetCount];
    /** [target J] joint of the source, -1 = none */
    this.map = map;
    /** [target J] sinew_joint_class that was used */
    this.classes = classes;
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
    const body = bodyStruct(blocks, bodyOf(options.body, this.#targetCount));
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

/** Streaming retargeting of motion between skeletons; planted feet stay in place, and hands stay out of the body. */
export class RetargetStream {
  #wasm;
  #check;
  #kept;
  #stream;
  #counts;
  constructor(wasm, check, kept, stream, sourceCount, targetCount, map, classes) {
    [this.#wasm, this.#check, this.#kept, this.#stream] = [wasm, check, kept, stream];
    this.#counts = [sourceCount, targetCount];
    /** [target J] joint of the source, -1 = none */
    this.map = map;
    /** [target J] sinew_joint_class that was used */
    this.classes = classes;
  }

  /** The next frame: local rotations [J x 4] and translations [J x 3] of the source. @returns those of the target */
  frame(rotations, translations) {
    const [from, to] = this.#counts;
    const given = [typed(Float32Array, rotations, "rotations", 4 * from), typed(Float32Array, translations, "translations", 3 * from)];
    const blocks = new Blocks(this.#wasm);
    try {
      const made = [blocks.room(Float32Array, 4 * to), blocks.room(Float32Array, 3 * to)];
      this.#check("retarget", this.#wasm.sinew_retarget_stream_frame(this.#stream, ...given.map((array) => blocks.copy(array)), ...made));
      return { rotations: blocks.take(Float32Array, made[0], 4 * to), translations: blocks.take(Float32Array, made[1], 3 * to) };
    } finally {
      blocks.free();
    }
  }

  /** Resets the stream: the next frame is its first. */
  restart() {
    this.#check("retarget", this.#wasm.sinew_retarget_stream_restart(this.#stream));
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
