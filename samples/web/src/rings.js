// SPDX-License-Identifier: MIT
// The rings that turn the chosen joint, three's TransformControls, on a skeleton of their own: joints stand where the engine has them. They are fetched
// when the first joint is chosen.
import { MathUtils, Object3D, Vector3 } from "three";

/** @typedef {{ parent: number, position: number[] }} Joint */
/** @typedef {{ camera: import("three").Camera, canvas: HTMLElement, scene: Object3D, model: Object3D, orbit: { enabled: boolean }, redraw: () => void }} Place */

export class Rings {
  /** @type {(joint: number, x: number, y: number, z: number) => void} */
  onTurn = () => {}; // degrees
  /** @type {(joint: number) => void} */
  onTurnEnd = () => {};
  /** @type {Object3D[]} */
  #handles = []; // per joint
  #joint = -1; // that they are on
  /** @type {import("three/addons/controls/TransformControls.js").TransformControls | null} */
  #gizmo = null;
  /** @type {Promise<void> | null} */
  #coming = null;
  #of;
  #model;

  /** @param {Place} of */
  constructor(of) {
    this.#of = of;
    this.#model = of.model;
  }

  async #fetch() {
    const { TransformControls } = await import("three/addons/controls/TransformControls.js");
    const { camera, canvas, scene, orbit, redraw } = this.#of;
    const gizmo = new TransformControls(camera, canvas);
    gizmo.setMode("rotate");
    gizmo.setSpace("local");
    gizmo.setSize(0.75);
    gizmo.showXYZE = false; // a ball that would take the clicks on other joints and the drags that orbit
    gizmo.addEventListener("change", redraw);
    gizmo.addEventListener("dragging-changed", ({ value }) => {
      orbit.enabled = !value;
      if (!value) this.onTurnEnd(this.#joint);
    });
    gizmo.addEventListener("objectChange", () => {
      const { x, y, z } = this.#handles[this.#joint].rotation;
      this.onTurn(this.#joint, x * MathUtils.RAD2DEG, y * MathUtils.RAD2DEG, z * MathUtils.RAD2DEG);
    });
    scene.add(gizmo.getHelper());
    this.#gizmo = gizmo;
    this.show(this.#joint);
    redraw();
  }

  get helper() {
    return this.#gizmo?.getHelper() ?? null;
  }
  // Whether the pointer is on one.
  get underPointer() {
    return this.#gizmo !== null && this.#gizmo.axis !== null;
  }

  // joint: -1 for none.
  /** @param {number} joint */
  show(joint) {
    this.#joint = joint;
    if (joint < 0) this.#gizmo?.detach();
    else if (this.#gizmo) this.#gizmo.attach(this.#handles[joint]);
    else if (!this.#coming) this.#coming = this.#fetch().catch(() => void (this.#coming = null)); // the next joint asks again
  }

  /** @param {Joint[]} joints */
  make(joints) {
    for (const handle of this.#handles) handle.removeFromParent();
    this.#handles = joints.map(() => {
      const handle = new Object3D();
      handle.rotation.order = "ZYX"; // R = Rz Ry Rx, as the engine's poses
      return handle;
    });
    joints.forEach(({ parent }, j) => (parent < 0 ? this.#model : this.#handles[parent]).add(this.#handles[j]));
    this.place(joints);
  }

  // The same joints elsewhere.
  /** @param {Joint[]} joints */
  place(joints) {
    joints.forEach(({ parent, position }, j) => {
      const from = parent < 0 ? [0, 0, 0] : joints[parent].position;
      const [x, y, z] = position.map((p, axis) => p - from[axis]);
      this.#handles[j].position.set(x, y, z);
    });
  }

  // turns: [J x 3] degrees. The joint that is being turned has its own.
  /** @param {ArrayLike<number>} turns */
  turn(turns) {
    this.#handles.forEach((handle, j) => {
      if (this.#gizmo?.dragging && j === this.#joint) return;
      const [x, y, z] = [0, 1, 2].map((axis) => turns[j * 3 + axis] * MathUtils.DEG2RAD);
      handle.rotation.set(x, y, z);
    });
  }

  // How far a joint of theirs is from where the engine has it, at most. positions: [J x 3].
  /** @param {Float32Array} positions */
  largestDistance(positions) {
    this.#model.updateMatrixWorld(true);
    return Math.max(...this.#handles.map((handle, j) => this.#model.worldToLocal(handle.getWorldPosition(new Vector3())).distanceTo(new Vector3().fromArray(positions, j * 3))));
  }
}
