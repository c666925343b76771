// SPDX-License-Identifier: MIT
// A character that was rigged and set in motion when the page was built (samples/moving.mjs), drawn by WebGL alone: it is there before three.js and the engine are.
// A file: the length of a JSON text {vertices, triangles, parents, frames, seconds, low, size, reach}, the text, then [J x 3] floats, where joints rest; planes of x, y, z of
// positions (16 bits of the box at `low` of `size`) and of the corners of triangles; [frames x J x 7] 16 bits, a quaternion and a translation in units of `reach`, which move a
// joint from its rest; planes of normals, colors, four joints and their four weights, a byte each.
import { fetchPacked } from "./packed.js";

/** @typedef {{ vertices: number, triangles: number, parents: number[], frames: number, seconds: number, low: number[], size: number[], reach: number }} Head */

const skinnedShader = (/** @type {number} */ joints) => `#version 300 es
uniform vec4 palette[${3 * joints}];
uniform mat4 camera;
uniform vec3 low, size;
uniform float swept;
in vec3 position, normal, color;
in vec4 joints, weights;
out vec3 shown, facing;
void main() {
  vec4 rest = vec4(low + position * size, 1.0), rows[3] = vec4[3](vec4(0), vec4(0), vec4(0));
  for (int s = 0; s < 4; ++s) for (int r = 0; r < 3; ++r) rows[r] += weights[s] * palette[3 * int(joints[s]) + r];
  facing = vec3(dot(rows[0].xyz, normal), dot(rows[1].xyz, normal), dot(rows[2].xyz, normal));
  shown = mix(vec3(0.56), color, smoothstep(position.y - 0.04, position.y + 0.04, swept * 1.08 - 0.04));
  gl_Position = camera * vec4(dot(rows[0], rest), dot(rows[1], rest), dot(rows[2], rest), 1.0);
}`;
const litShader = `#version 300 es
precision mediump float;
in vec3 shown, facing;
out vec4 pixel;
void main() {
  vec3 n = normalize(facing);
  pixel = vec4(shown * (0.74 + 0.16 * n.y + 0.42 * max(0.0, dot(n, normalize(vec3(0.5, 0.7, 0.8))))), 1.0);
}`;
const flatShaders = [`#version 300 es
uniform mat4 camera;
in vec3 position;
in vec4 color;
out vec4 shown;
void main() { shown = color; gl_Position = camera * vec4(position, 1.0); }`, `#version 300 es
precision mediump float;
in vec4 shown;
out vec4 pixel;
void main() { pixel = vec4(shown.rgb * shown.a, shown.a); }`];

const fieldOfView = 0.52; // radians
const slant = 0.4; // radians that it turns to the left at first, and looks about
const attributes = ["position", "normal", "color", "joints", "weights"];

/** @param {WebGL2RenderingContext} gl @param {string[]} sources */
function programOf(gl, sources) {
  const program = gl.createProgram();
  sources.forEach((source, i) => {
    const shader = /** @type {WebGLShader} */ (gl.createShader(i === 0 ? gl.VERTEX_SHADER : gl.FRAGMENT_SHADER));
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  });
  attributes.forEach((name, place) => gl.bindAttribLocation(program, place, name));
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program) ?? "no program");
  return program;
}

/** @param {Uint8Array} bytes */
function parse(bytes) {
  let at = 4 + new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true);
  /** @type {Head} */
  const head = JSON.parse(new TextDecoder().decode(bytes.subarray(4, at)));
  const { vertices: V, triangles: T, parents: { length: J }, frames } = head;
  /** @param {any} type @param {number} count */
  const take = (type, count) => {
    const values = new type(bytes.slice(at, at + count * type.BYTES_PER_ELEMENT).buffer);
    at += count * type.BYTES_PER_ELEMENT;
    return values;
  };
  /** @param {any} type @param {number} count @param {number} width */
  const planes = (type, count, width) => {
    const list = take(type, count * width);
    return type.from({ length: count * width }, (/** @type {unknown} */ _, /** @type {number} */ i) => list[(i % width) * count + Math.floor(i / width)]);
  };
  return {
    head, rest: /** @type {Float32Array} */ (take(Float32Array, 3 * J)), position: planes(Uint16Array, V, 3), triangles: planes(Uint16Array, T, 3), poses: /** @type {Int16Array} */ (take(Int16Array, 7 * J * frames)),
    normal: planes(Int8Array, V, 3), color: planes(Uint8Array, V, 3), joints: planes(Uint8Array, V, 4), weights: planes(Uint8Array, V, 4),
  };
}

export class MovingPicture {
  #canvas;
  #of;
  /** @type {WebGL2RenderingContext} */
  #gl;
  #skinned;
  #flat;
  #mesh;
  #lines;
  #palette;
  #depths; // of joints in the tree
  #deepest;

  /** @param {string} name of a file beside the page @param {HTMLCanvasElement} canvas */
  static async of(name, canvas) {
    return new MovingPicture(parse(await fetchPacked(`samples/${name}`)), canvas);
  }

  /** @param {ReturnType<typeof parse>} of @param {HTMLCanvasElement} canvas */
  constructor(of, canvas) {
    const gl = canvas.getContext("webgl2", { antialias: true, premultipliedAlpha: true });
    if (!gl) throw new Error("no WebGL 2");
    const { parents } = of.head;
    this.#canvas = canvas;
    this.#of = of;
    this.#gl = gl;
    this.#palette = new Float32Array(12 * parents.length);
    this.#depths = parents.map((_, j) => {
      let depth = 0;
      for (let above = parents[j]; above >= 0; above = parents[above]) ++depth;
      return depth;
    });
    this.#deepest = Math.max(1, ...this.#depths);
    this.#skinned = programOf(gl, [skinnedShader(parents.length), litShader]);
    this.#flat = programOf(gl, flatShaders);
    this.#mesh = this.#buffers();
    this.#lines = gl.createVertexArray();
    gl.bindVertexArray(this.#lines);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    [[0, 3, 0], [2, 4, 12]].forEach(([place, width, offset]) => (gl.enableVertexAttribArray(place), gl.vertexAttribPointer(place, width, gl.FLOAT, false, 28, offset)));
  }

  get seconds() {
    return this.#of.head.seconds;
  }

  #buffers() {
    const gl = this.#gl, { position, normal, color, joints, weights, triangles } = this.#of;
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    /** @type {[ArrayBufferView, number, number, boolean][]} */
    const all = [[position, 3, gl.UNSIGNED_SHORT, true], [normal, 3, gl.BYTE, true], [color, 3, gl.UNSIGNED_BYTE, true], [joints, 4, gl.UNSIGNED_BYTE, false], [weights, 4, gl.UNSIGNED_BYTE, true]];
    all.forEach(([values, width, type, normalized], place) => {
      gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, width, type, normalized, 0, 0);
    });
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, triangles, gl.STATIC_DRAW);
    return array;
  }

  // moved: how much of the clip's pose it has, a share of 1; the rest is the rest pose.
  /** @param {number} seconds @param {number} moved */
  #pose(seconds, moved) {
    const { head: { frames, seconds: length, parents, reach }, poses } = this.#of, J = parents.length;
    const at = (((seconds / length) % 1) + 1) % 1 * (frames - 1), frame = Math.floor(at), share = at - frame;
    for (let j = 0; j < J; ++j) {
      const [a, b] = [frame, Math.min(frame + 1, frames - 1)].map((f) => poses.subarray(7 * (f * J + j), 7 * (f * J + j) + 7));
      const toward = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] < 0 ? -1 : 1;
      const pose = [0, 1, 2, 3, 4, 5, 6].map((i) => (a[i] * (1 - share) + (i < 4 ? toward : 1) * b[i] * share) / 32767);
      const side = pose[3] < 0 ? -moved : moved;
      const [x0, y0, z0, w0] = [pose[0] * side, pose[1] * side, pose[2] * side, pose[3] * side + 1 - moved], size = Math.hypot(x0, y0, z0, w0) || 1;
      const [x, y, z, w] = [x0 / size, y0 / size, z0 / size, w0 / size], [tx, ty, tz] = [4, 5, 6].map((i) => pose[i] * reach * moved);
      this.#palette.set([1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), tx, 2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x), ty, 2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y), tz], 12 * j);
    }
  }

  // The camera's matrix: slanted, the whole character in view.
  /** @param {number} turn radians */
  #camera(turn) {
    const { head: { low, size } } = this.#of, aspect = this.#canvas.width / this.#canvas.height;
    const middle = low.map((x, i) => x + size[i] / 2), radius = Math.max(size[1] / 2, Math.hypot(size[0], size[2]) / 2 / Math.min(1, aspect)) * 1.12;
    const distance = radius / Math.tan(fieldOfView / 2) + Math.min(size[0], size[2]) / 2, [near, far] = [distance / 20, distance * 4], pitch = 0.14;
    const [sin, cos, up, flat] = [Math.sin(turn), Math.cos(turn), Math.sin(pitch), Math.cos(pitch)];
    const f = 1 / Math.tan(fieldOfView / 2), rows = [[cos, 0, -sin], [-up * sin, flat, -up * cos], [flat * sin, up, flat * cos]];
    const view = rows.map((row, i) => [...row, -row.reduce((sum, x, axis) => sum + x * middle[axis], 0) - (i === 2 ? distance : 0)]);
    const projected = [view[0].map((x) => (x * f) / aspect), view[1].map((x) => x * f), view[2].map((x, i) => (x * (far + near)) / (near - far) + (i === 3 ? (2 * far * near) / (near - far) : 0)), view[2].map((x) => -x)];
    return Float32Array.from({ length: 16 }, (_, i) => projected[i % 4][Math.floor(i / 4)]);
  }

  /** @param {number} joint */
  #placeOf(joint) {
    const { rest } = this.#of, [x, y, z] = rest.subarray(3 * joint, 3 * joint + 3), m = this.#palette.subarray(12 * joint, 12 * joint + 12);
    return [0, 4, 8].map((row) => m[row] * x + m[row + 1] * y + m[row + 2] * z + m[row + 3]);
  }

  // Triangles of a shadow on the floor, then of bones as far as they have grown: seven floats a corner.
  /** @param {number} grown @param {number} strength of the bones */
  #flats(grown, strength) {
    const { head: { low, size, parents } } = this.#of, wide = 0.34 * Math.max(size[0], size[2]), middle = [low[0] + size[0] / 2, low[1], low[2] + size[2] / 2];
    /** @type {number[]} */
    const list = [];
    for (let i = 0; i < 32; ++i) {
      const edge = (/** @type {number} */ n) => [middle[0] + wide * Math.cos((n * Math.PI) / 16), middle[1], middle[2] + wide * Math.sin((n * Math.PI) / 16), 0, 0, 0, 0];
      list.push(...middle, 0, 0, 0, 0.3, ...edge(i), ...edge(i + 1));
    }
    const shadow = list.length / 7, places = parents.map((_, j) => this.#placeOf(j)), thick = 0.011 * Math.hypot(...size);
    parents.forEach((parent, j) => {
      const share = Math.min(1, Math.max(0, grown * (this.#deepest + 1) - this.#depths[j]));
      if (parent < 0 || share === 0) return;
      const from = places[parent], along = places[j].map((x, i) => (x - from[i]) * share), length = Math.hypot(...along) || 1e-9;
      const side = Math.abs(along[1]) < 0.9 * length ? [0, 1, 0] : [1, 0, 0], cross = (/** @type {number[]} */ a, /** @type {number[]} */ b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
      const u = cross(along, side), v = cross(along, u), width = Math.min(thick, 0.12 * length);
      const ring = [[u, 1], [v, 1], [u, -1], [v, -1]].map(([direction, sign]) => from.map((x, i) => x + 0.18 * along[i] + (/** @type {number} */ (sign) * width * /** @type {number[]} */ (direction)[i]) / Math.hypot(.../** @type {number[]} */ (direction))));
      ring.forEach((corner, i) => [from, from.map((x, axis) => x + along[axis])].forEach((tip, end) => {
        const shade = (end ? 0.86 : 0.7) + 0.08 * (i % 2);
        for (const point of [tip, corner, ring[(i + 1) % 4]]) list.push(...point, shade, shade, shade * 1.04, 0.85 * strength);
      }));
    });
    return { values: Float32Array.from(list), shadow };
  }

  // seconds: of the clip; moved: how much of its pose there is; grown: of the skeleton; swept: of the colors; bones: how strongly they show. All of these are shares of 1. turn: radians.
  draw({ seconds = 0, moved = 1, grown = 1, swept = 1, bones = 1, turn = 0 } = {}) {
    const gl = this.#gl, ratio = Math.min(devicePixelRatio, 2), { head: { low, size, triangles } } = this.#of;
    const [width, height] = [Math.round(this.#canvas.clientWidth * ratio), Math.round(this.#canvas.clientHeight * ratio)];
    if (this.#canvas.width !== width || this.#canvas.height !== height) Object.assign(this.#canvas, { width, height });
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.#pose(seconds, moved);
    const camera = this.#camera(slant + turn), { values, shadow } = this.#flats(grown, bones);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.useProgram(this.#flat);
    gl.uniformMatrix4fv(gl.getUniformLocation(this.#flat, "camera"), false, camera);
    gl.bindVertexArray(this.#lines);
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.DYNAMIC_DRAW);
    gl.drawArrays(gl.TRIANGLES, 0, shadow);
    gl.useProgram(this.#skinned);
    const at = (/** @type {string} */ name) => gl.getUniformLocation(this.#skinned, name);
    gl.uniformMatrix4fv(at("camera"), false, camera);
    gl.uniform4fv(at("palette"), this.#palette);
    gl.uniform3fv(at("low"), low);
    gl.uniform3fv(at("size"), size);
    gl.uniform1f(at("swept"), swept);
    gl.enable(gl.DEPTH_TEST);
    gl.bindVertexArray(this.#mesh);
    gl.drawElements(gl.TRIANGLES, 3 * triangles, gl.UNSIGNED_SHORT, 0);
    gl.disable(gl.DEPTH_TEST);
    gl.useProgram(this.#flat);
    gl.bindVertexArray(this.#lines);
    if (bones > 0) gl.drawArrays(gl.TRIANGLES, shadow, values.length / 7 - shadow);
  }

  dispose() {
    this.#gl.getExtension("WEBGL_lose_context")?.loseContext();
  }
}
