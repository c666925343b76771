// SPDX-License-Identifier: MIT
// What all calls of a module share: its memory, its models, errors.
import { LAYOUTS } from "./layouts.js";
import { Blocks, SinewError } from "./memory.js";

const MODEL_BYTES = LAYOUTS.model.size;

/** A model in the module's memory, checked and packed once. free() gives the memory back. */
export class Model {
  #blocks;
  /** @param {any} wasm @param {ArrayBuffer | ArrayBufferView} bytes */
  constructor(wasm, bytes) {
    this.#blocks = new Blocks(wasm);
    const data = bytes instanceof ArrayBuffer ? new Uint8Array(bytes) : new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const blocks = this.#blocks;
    const at = blocks.bytes(data.length);
    blocks.view(Uint8Array, at, data.length).set(data);
    /** Address of the sinew_model. */
    this.address = blocks.bytes(MODEL_BYTES);
    blocks.view(Uint8Array, this.address, MODEL_BYTES).fill(0);
    let status = wasm.sinew_rig_model_open?.(at, data.length, this.address) ?? -19; // a module that binds alone has it not
    if (status === -19) status = wasm.sinew_model_open(at, data.length, this.address); // made for another task
    if (status !== 0) {
      const line = blocks.text(wasm.sinew_status_text(status) >>> 0);
      blocks.free();
      throw new SinewError(`openModel: ${line}`, status);
    }
    const words = blocks.view(Uint32Array, this.address, MODEL_BYTES / 4);
    this.parameters = words[9];
    /** "weights", "skeletons", "hands" or "fronts" */
    this.task = words[13] === 0 ? "weights" : words[6] === 2 ? "hands" : words[6] === 5 ? "fronts" : "skeletons";
    const size = blocks.bytes(4, 4);
    const packed = wasm.sinew_model_pack_workspace_size(this.address, size) === 0 ? blocks.view(Uint32Array, size, 1)[0] : 0;
    if (packed > 0) wasm.sinew_model_pack(this.address, blocks.bytes(packed, 64), packed);
  }
  free() {
    this.#blocks.free();
    this.address = 0;
  }
}

/** The module and what a call does before and after it. */
export class Calls {
  /** @param {any} wasm @param {any} report */
  constructor(wasm, report) {
    this.wasm = wasm;
    this.report = report;
  }

  /** @param {string} call @param {number} status */
  check(call, status) {
    if (status === 0) return;
    throw new SinewError(`${call}: ${new Blocks(this.wasm).text(this.wasm.sinew_status_text(status) >>> 0)}`, status);
  }

  // Runs a call with memory that is given back whatever happens.
  /**
   * @template Result
   * @param {((share: number) => unknown) | null | undefined} onProgress
   * @param {(blocks: Blocks) => Result} body
   */
  with(onProgress, body) {
    const blocks = new Blocks(this.wasm);
    this.report.progress = onProgress ?? null;
    try {
      return body(blocks);
    } finally {
      this.report.progress = null;
      blocks.free();
    }
  }

  // A size that a query writes: query(address of the size) -> status.
  /** @param {string} call @param {Blocks} blocks @param {(size: number) => number} query */
  size(call, blocks, query) {
    const at = blocks.room(Uint32Array, 1);
    this.check(call, query(at));
    return blocks.view(Uint32Array, at, 1)[0];
  }

  /**
   * @param {string} call
   * @param {{ model?: any }} options what openModel() gave, anyone may say
   * @param {string} task
   * @param {any} own
   */
  modelOf(call, options, task, own = null) {
    const model = options.model ?? own;
    if (model == null) throw new SinewError(`${call}: no model is open; give load() or the options the bytes of @sinew/skin/model`);
    if (!(model instanceof Model) || model.address === 0) throw new SinewError(`${call}: options.model: expected what openModel() gave`);
    if (model.task !== task) throw new SinewError(`${call}: expected a model of ${task}, found one of ${model.task}`);
    return model.address;
  }

  /** @param {Blocks} blocks @param {any} mesh of meshOf() */
  mesh(blocks, mesh) {
    return blocks.struct("mesh", {
      positions: blocks.copy(mesh.positions),
      vertex_count: mesh.vertexCount,
      face_offsets: blocks.copy(mesh.faceOffsets),
      face_vertices: blocks.copy(mesh.faceVertices),
      face_count: mesh.faceCount,
      corner_count: mesh.cornerCount,
    });
  }

  /** @param {Blocks} blocks @param {any} skeleton of skeletonOf() @param {Uint8Array | null} flags [J] @param {number} up */
  skeleton(blocks, skeleton, flags, up = 0) {
    return blocks.struct("skeleton", {
      up,
      positions: blocks.copy(skeleton.positions),
      parents: blocks.copy(skeleton.parents),
      flags: blocks.copy(flags),
      joint_count: skeleton.jointCount,
    });
  }

  /** @param {Blocks} blocks @param {string[] | null} names */
  names(blocks, names) {
    return names == null ? 0 : blocks.texts(names).address;
  }
}
