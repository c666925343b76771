// SPDX-License-Identifier: MIT
// The axes in the corner of the picture, three's ViewHelper: a click on one looks along it.
import { isStill } from "./elements.js";
import { ViewHelper } from "three/addons/helpers/ViewHelper.js";

const leastWidth = 560; // of the picture: a phone has the buttons alone
const corner = { left: null, bottom: null, right: 4, top: 4 };

export class ViewCube {
  #helper;
  /** @type {HTMLElement} */
  #canvas;
  /** @type {any} */
  #orbit;
  /** @type {() => void} */
  #redraw;
  #last = 0;

  // redraw: draws the picture soon.
  /** @param {{ camera: import("three").Camera, canvas: HTMLElement, orbit: any, host: HTMLElement, redraw: () => void }} of */
  constructor({ camera, canvas, orbit, host, redraw }) {
    this.#helper = new ViewHelper(camera, canvas);
    Object.assign(this.#helper.location, corner);
    this.#helper.setLabels("X", "Y", "Z");
    [this.#canvas, this.#orbit, this.#redraw] = [canvas, orbit, redraw];
    // Before the canvas hears of it: the axes are in front of the character.
    host.addEventListener("pointerdown", (event) => this.#press(event), true);
  }

  get shown() {
    return this.#canvas.clientWidth >= leastWidth;
  }

  // upAxis 1: the picture turns the model, z is up in it.
  /** @param {number} upAxis */
  set up(upAxis) {
    this.#helper.setLabels("X", ...(upAxis === 1 ? ["Z", "−Y"] : ["Y", "Z"]));
  }

  // After the picture.
  /** @param {import("three").WebGLRenderer} renderer */
  render(renderer) {
    if (!this.shown) return;
    const clears = renderer.autoClear;
    renderer.autoClear = false;
    this.#helper.render(renderer);
    renderer.autoClear = clears;
  }

  /** @param {PointerEvent} event */
  #press(event) {
    if (!this.shown || event.button !== 0 || event.target !== this.#canvas) return;
    this.#helper.center.copy(this.#orbit.target);
    if (!this.#helper.handleClick(event)) return;
    event.stopPropagation();
    this.#last = performance.now();
    this.#turn(isStill() ? Infinity : 0);
  }

  /** @param {number} seconds */
  #turn(seconds) {
    this.#helper.update(Number.isFinite(seconds) ? seconds : 10);
    this.#redraw();
    if (!this.#helper.animating) return this.#orbit.update();
    requestAnimationFrame((now) => {
      const passed = Math.max(0, now - this.#last) / 1000;
      this.#last = now;
      this.#turn(passed);
    });
  }
}
