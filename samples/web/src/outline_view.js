// SPDX-License-Identifier: MIT
// A drawing in the picture, in place of its mesh, with its outline on top and points to drag.
import { BufferAttribute, BufferGeometry, DoubleSide, Group, Mesh, MeshBasicMaterial, Points, PointsMaterial, SRGBColorSpace, Texture } from "three";

/** @typedef {import("./outline.js").Draggable} Draggable */
/** @typedef {{ scale: number, left: number, bottom: number }} Lies where the picture lies in the model's plane, see web_picture() of web.cpp */

const lineColour = 0x1f8fff;
const chosenColour = 0xff8c00;
const lineWidth = 0.0035; // of the longest side
const pointPixels = 9;
const mostPixels = 2048; // of the texture's longest side

const flat = (/** @type {number} */ colour, more = {}) => new MeshBasicMaterial({ color: colour, side: DoubleSide, depthTest: false, depthWrite: false, toneMapped: false, transparent: true, ...more });

export class OutlineView {
  #group = new Group();
  #lines = new Mesh(new BufferGeometry(), flat(lineColour));
  #rims = new Points(new BufferGeometry(), new PointsMaterial({ color: lineColour, size: pointPixels + 4, sizeAttenuation: false, depthTest: false, transparent: true }));
  #points = new Points(this.#rims.geometry, new PointsMaterial({ color: 0xffffff, size: pointPixels, sizeAttenuation: false, depthTest: false, transparent: true }));
  #chosen = new Points(new BufferGeometry(), new PointsMaterial({ color: chosenColour, size: pointPixels + 4, sizeAttenuation: false, depthTest: false, transparent: true }));
  #paper = new Mesh(new BufferGeometry(), flat(0xffffff));
  /** @type {Draggable[]} */
  #outline = [];
  /** @type {Lies} */
  #lies = { scale: 1, left: 0, bottom: 0 };
  /** @type {Blob | null} */
  #file = null;
  /** @type {Blob | null} */
  #drawn = null; // the file that the texture is of
  #redraw;

  /**
   * @param {import("three").Object3D} parent
   * @param {() => void} redraw
   */
  constructor(parent, redraw) {
    this.#redraw = redraw;
    this.#group.visible = false;
    [this.#paper, this.#lines, this.#rims, this.#points, this.#chosen].forEach((one, i) => {
      one.renderOrder = i;
      one.frustumCulled = false;
      this.#group.add(one);
    });
    parent.add(this.#group);
  }

  get shown() {
    return this.#group.visible;
  }
  // The file that is shown.
  get file() {
    return this.shown ? this.#file : null;
  }

  /**
   * @param {{ outline: Draggable[], lies: Lies, width: number, height: number, file: Blob | undefined } | null} drawing width, height: of the file's picture
   */
  show(drawing) {
    this.#group.visible = drawing !== null;
    if (!drawing) return;
    this.#lies = drawing.lies;
    this.#file = drawing.file ?? null;
    this.#setPaper(drawing);
    this.setOutline(drawing.outline);
  }

  /** @param {Draggable[]} outline */
  setOutline(outline) {
    this.#outline = outline;
    const half = lineWidth / 2;
    /** @type {number[]} */
    const corners = [];
    for (const { line } of outline)
      line.forEach((place, i) => {
        const [a, b] = [this.#toModel(place), this.#toModel(line[(i + 1) % line.length])];
        const [x, y] = [b[0] - a[0], b[1] - a[1]];
        const length = Math.hypot(x, y) || 1;
        const [nx, ny, ex, ey] = [(-y / length) * half, (x / length) * half, (x / length) * half * 0.6, (y / length) * half * 0.6];
        const [p, q, r, s] = [[a[0] + nx - ex, a[1] + ny - ey], [a[0] - nx - ex, a[1] - ny - ey], [b[0] + nx + ex, b[1] + ny + ey], [b[0] - nx + ex, b[1] - ny + ey]];
        for (const [cx, cy] of [p, q, r, r, q, s]) corners.push(cx, cy, 0);
      });
    this.#lines.geometry.setAttribute("position", new BufferAttribute(Float32Array.from(corners), 3));
    this.#rims.geometry.setAttribute("position", new BufferAttribute(Float32Array.from(this.handles.flatMap(({ place }) => place)), 3));
  }

  /**
   * How places of the model's plane move when the same picture lies there: every pixel stays under the pointer.
   * @param {Lies} next
   * @returns {(place: import("three").Vector3) => void}
   */
  movesTo(next) {
    const { scale, left, bottom } = this.#lies;
    return (place) => place.set((place.x / scale + left - next.left) * next.scale, (place.y / scale - bottom + next.bottom) * next.scale, (place.z / scale) * next.scale);
  }

  // Points that can be dragged: which of which line, and where in the model.
  get handles() {
    return this.#outline.flatMap(({ line, points }, of) => points.map((at, point) => ({ of, point, place: this.#toModel(line[at]) })));
  }

  // Which of the handles is chosen, -1 for none.
  /** @param {number} index */
  choose(index) {
    this.#chosen.visible = index >= 0;
    if (index >= 0) this.#chosen.geometry.setAttribute("position", new BufferAttribute(Float32Array.from(this.handles[index].place), 3));
  }

  // The pixel that a place of the model's plane shows.
  /** @param {number[]} place */
  toPixel([x, y]) {
    const { scale, left, bottom } = this.#lies;
    return [x / scale + left, bottom - y / scale];
  }

  /** @param {number[]} pixel */
  #toModel([x, y]) {
    const { scale, left, bottom } = this.#lies;
    return [(x - left) * scale, (bottom - y) * scale, 0];
  }

  /** @param {{ width: number, height: number, file: Blob | undefined }} of */
  #setPaper({ width, height, file }) {
    const { geometry } = this.#paper;
    const corners = [[0, 0], [width, 0], [width, height], [0, height]];
    geometry.setAttribute("position", new BufferAttribute(Float32Array.from(corners.flatMap((corner) => this.#toModel(corner))), 3));
    geometry.setAttribute("uv", new BufferAttribute(Float32Array.of(0, 0, 1, 0, 1, 1, 0, 1), 2)); // rows go down
    geometry.setIndex([0, 3, 1, 1, 3, 2]);
    if (file && file !== this.#drawn) this.#draw(file, width, height);
  }

  /**
   * @param {Blob} file
   * @param {number} width
   * @param {number} height
   */
  async #draw(file, width, height) {
    this.#drawn = file;
    const share = Math.min(1, mostPixels / Math.max(width, height));
    const size = { resizeWidth: Math.max(1, Math.round(width * share)), resizeHeight: Math.max(1, Math.round(height * share)) };
    const bitmap = await createImageBitmap(file, { ...size, resizeQuality: "medium" }).catch(() => null); // the outline is there without it
    if (!bitmap || this.#drawn !== file) return;
    const { material } = this.#paper;
    material.map?.dispose();
    material.map = Object.assign(new Texture(bitmap), { flipY: false, colorSpace: SRGBColorSpace, needsUpdate: true });
    material.needsUpdate = true;
    this.#redraw();
  }
}
