// SPDX-License-Identifier: MIT
// What the pointer is on in the picture, and what it does there: clicks choose joints, drags move joints where the skeleton is edited, strokes of
// the brush paint. Other drags orbit.
import { Matrix4, Raycaster, Vector2, Vector3 } from "three";
import { draggedTo } from "./limbs.js";
import { firstHit } from "./rays.js";

const pickPixels = 11;
const touchPixels = 24; // a finger hides what it is on
const dragPixels = 3; // less is a click
const grabPixels = 40; // from a bone, the body around it
const degreesAPixel = 0.5;

export class Pointer {
  /** @type {any} */
  #view;
  /** @type {any} */
  #canvas;
  /** @type {any} */
  #camera;
  /** @type {any} */
  #model;
  /** @type {any} */
  #mesh;
  #stroking = false;
  /** @type {any} */
  #drag = null; // {joint, marker, outline or grab, offset, start, from, moved}

  // view: the View; its handlers are called. mesh: () => the shown mesh, or nothing.
  constructor(view, { host, canvas, camera, model, mesh }) {
    this.#view = view;
    this.#canvas = canvas;
    this.#camera = camera;
    this.#model = model;
    this.#mesh = mesh;
    this.#listenForDrags(host);
    this.#listenForClicks();
  }

  get dragging() {
    return this.#drag?.moved ?? false;
  }

  // The joint that is nearest to the pointer, -1 where none is near.
  jointAt({ clientX: x, clientY: y, pointerType }) {
    let best = -1;
    let nearest = pointerType === "touch" ? touchPixels : pickPixels;
    for (let j = 0; this.#view.skeletonShown && j < this.#view.jointCount; ++j) {
      const at = this.#view.jointOnScreen(j);
      const distance = Math.hypot(at.x - x, at.y - y);
      if (!at.behind && distance < nearest) [best, nearest] = [j, distance];
    }
    return best;
  }

  // The joint whose bone is under the pointer or near it, -1 where there is none.
  limbAt({ clientX: x, clientY: y }) {
    let best = -1, nearest = grabPixels;
    for (let j = 0; j < this.#view.jointCount; ++j) {
      const [a, b] = this.#view.boneOnScreen(j);
      const [dx, dy] = [b.x - a.x, b.y - a.y], length = dx * dx + dy * dy;
      const share = length > 0 ? Math.min(1, Math.max(0, ((x - a.x) * dx + (y - a.y) * dy) / length)) : 0;
      const distance = Math.hypot(a.x + share * dx - x, a.y + share * dy - y);
      if (!a.behind && distance < nearest) [best, nearest] = [j, distance];
    }
    return best;
  }

  // The marker that is nearest to the pointer, or the point of an outline: {marker: index, place} or {outline: {of, point}, place}; null where none is near.
  handleAt({ clientX: x, clientY: y, pointerType }) {
    const handles = [...this.#view.markers.map(({ place, index }) => ({ place, marker: index })), ...this.#view.outlineHandles.map(({ place, ...outline }) => ({ place, outline }))];
    let best = null;
    let nearest = pointerType === "touch" ? touchPixels : pickPixels;
    for (const handle of handles) {
      const at = this.#view.onScreen(handle.place);
      const distance = Math.hypot(at.x - x, at.y - y);
      if (!at.behind && distance <= nearest) [best, nearest] = [handle, distance];
    }
    return best;
  }

  // The middle of the limb under the pointer, null beside the mesh.
  #middleAt({ clientX, clientY }) {
    const hit = firstHit(this.#rayThrough(clientX, clientY), this.#mesh());
    return hit ? this.place(this.#mesh().worldToLocal(hit.point.clone()).toArray(), clientX, clientY, { toMiddle: true }) : null;
  }

  // The shown vertex under the pointer, -1 beside the mesh.
  surfaceAt({ clientX, clientY }) {
    const mesh = this.#mesh();
    if (!mesh) return -1;
    const hit = firstHit(this.#rayThrough(clientX, clientY), mesh);
    if (!hit) return -1;
    const positions = mesh.geometry.getAttribute("position");
    const at = mesh.worldToLocal(hit.point.clone()), corner = new Vector3();
    const [near] = ["a", "b", "c"].map((name) => hit.face[name]).sort((a, b) => corner.fromBufferAttribute(positions, a).distanceToSquared(at) - corner.fromBufferAttribute(positions, b).distanceToSquared(at));
    return near;
  }

  #rayThrough(x, y) {
    const box = this.#canvas.getBoundingClientRect();
    const point = new Vector2(((x - box.left) / box.width) * 2 - 1, 1 - ((y - box.top) / box.height) * 2);
    this.#camera.updateMatrixWorld();
    const ray = new Raycaster();
    ray.setFromCamera(point, this.#camera);
    return ray;
  }

  // Where what is at `from` goes when it is dragged to a place of the page. plane: that it stays on, {axis, at}, or null; toMiddle: of the limb there.
  /**
   * @param {number[]} from
   * @param {number} x
   * @param {number} y
   * @param {{ plane?: { axis: number, at: number } | null, toMiddle?: boolean }} how
   */
  place(from, x, y, { plane = null, toMiddle = false }) {
    const { origin, direction } = this.#rayThrough(x, y).ray;
    const toModel = new Matrix4().copy(this.#model.matrixWorld).invert(); // turned at most, so lengths stay
    const { geometry } = this.#mesh();
    return draggedTo({
      origin: origin.applyMatrix4(toModel).toArray(),
      direction: direction.transformDirection(toModel).toArray(),
      forward: this.#camera.getWorldDirection(new Vector3()).transformDirection(toModel).toArray(),
      from,
      plane,
      surface: toMiddle ? { positions: geometry.getAttribute("position").array, triangles: geometry.index.array } : null,
    });
  }

  // Before the canvas hears of it: a drag that begins on a joint is no orbit.
  #listenForDrags(host) {
    host.addEventListener(
      "pointerdown",
      (event) => {
        if (this.#view.onStroke && event.button === 0 && event.target === this.#canvas && this.surfaceAt(event) >= 0) {
          this.#stroking = true;
          this.#view.orbiting = false;
          event.target.setPointerCapture(event.pointerId);
          this.#view.onStroke(this.surfaceAt(event));
          return;
        }
        const handle = event.button === 0 && event.target === this.#canvas && !this.#drag ? this.handleAt(event) : null;
        if (handle) return this.#begin(event, handle.place, handle);
        const limb = this.#view.onGrab && event.button === 0 && event.target === this.#canvas && !this.#drag && !this.#view.onRing ? this.limbAt(event) : -1;
        if (limb >= 0) return this.#begin(event, this.#view.jointPosition(limb), { grab: { place: this.#view.jointPosition(limb), turns: event.shiftKey, x: event.clientX } });
        if (this.#view.drawingShown || !this.#view.editing || !this.#view.draggable || this.#view.onMark || event.button !== 0 || event.target !== this.#canvas || this.#drag) return;
        const joint = this.jointAt(event);
        if (joint < 0) return;
        this.#begin(event, this.#view.jointPosition(joint), { joint });
      },
      true,
    );
    this.#listenForMoves(this.#canvas);
  }

  // what: {joint}, or as handleAt() has it.
  #begin(event, from, what) {
    const at = this.#view.onScreen(from);
    this.#view.orbiting = false;
    this.#view.hold();
    this.#drag = { ...what, offset: [at.x - event.clientX, at.y - event.clientY], start: [event.clientX, event.clientY], from, moved: false };
    event.target.setPointerCapture(event.pointerId);
  }

  #dragTo(x, y, drag, altKey) {
    if (drag.grab) return this.place(drag.from, x, y, {});
    if (drag.outline) return this.place(drag.from, x, y, { plane: { axis: 2, at: 0 } });
    return this.place(drag.from, x, y, { plane: drag.joint === undefined ? null : this.#view.planeOf(drag.joint), toMiddle: this.#view.toMiddle !== altKey });
  }

  // Tells what is dragged where it is now.
  #tell({ joint, marker, outline, grab, from, x }, ended) {
    if (grab) this.#view.onGrab?.(grab.turns ? [0, 0, 0] : from.map((/** @type {number} */ one, /** @type {number} */ i) => one - grab.place[i]), grab.turns ? (x - grab.x) * degreesAPixel : 0, ended);
    else if (outline) this.#view.onDragOutline(outline, this.#view.pixelAt(from), ended);
    else if (marker !== undefined) this.#view.onDragMarker(marker, from, ended);
    else if (ended) this.#view.onDragEnd();
    else this.#view.onDrag(joint, from);
  }

  #cursorFor(event) {
    if (this.handleAt(event)) return "move";
    if (this.#view.drawingShown) return "";
    if (this.#view.onMark) return "crosshair";
    if (this.#view.onGrab && this.limbAt(event) >= 0) return "grab";
    return this.#view.editing && this.#view.draggable && this.jointAt(event) >= 0 ? "move" : "";
  }

  #listenForMoves(canvas) {
    canvas.addEventListener("pointermove", (event) => {
      const drag = this.#drag;
      if (this.#stroking) {
        const at = this.surfaceAt(event);
        if (at >= 0) this.#view.onStroke?.(at);
        return;
      }
      if (!drag) {
        canvas.style.cursor = this.#cursorFor(event);
        return;
      }
      const { clientX: x, clientY: y } = event;
      if (!drag.moved && Math.hypot(x - drag.start[0], y - drag.start[1]) < dragPixels) return;
      drag.moved = true;
      drag.x = x;
      drag.from = this.#dragTo(x + drag.offset[0], y + drag.offset[1], drag, event.altKey);
      this.#tell(drag, false);
    });
    const end = () => {
      if (this.#stroking) {
        this.#stroking = false;
        this.#view.orbiting = true;
        return this.#view.onStrokeEnd();
      }
      if (!this.#drag) return;
      const drag = this.#drag;
      this.#drag = null;
      this.#view.orbiting = true;
      if (drag.moved) this.#tell(drag, true);
    };
    canvas.addEventListener("pointerup", end);
    canvas.addEventListener("pointercancel", end);
  }

  // A click, not the end of a drag, chooses the joint under the pointer, else the strongest joint of the surface there.
  #listenForClicks() {
    const canvas = this.#canvas;
    let down = null;
    canvas.addEventListener("pointerdown", (event) => {
      down = event.button === 0 && !this.#view.onRing && !this.#stroking ? [event.clientX, event.clientY] : null;
    });
    canvas.addEventListener("pointerup", (event) => {
      if (!down || !this.#mesh() || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 4) return;
      if (this.handleAt(event) || this.#view.drawingShown) return; // it was taken, and let go; nothing else is there
      if (this.#view.onMark) {
        const place = this.#middleAt(event);
        if (place) this.#view.onMark(place);
        return;
      }
      const joint = this.jointAt(event);
      const more = event.ctrlKey || event.metaKey || event.shiftKey; // beside the chosen one
      if (joint >= 0) return this.#view.onPickJoint(joint, more);
      const at = this.surfaceAt(event);
      if (at >= 0) this.#view.onPickSurface(at, more);
    });
  }
}
