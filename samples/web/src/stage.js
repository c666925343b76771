// SPDX-License-Identifier: MIT
// The canvas: three's renderer and scene, the camera that orbits. Draws only when something changed.
import { MOUSE, PerspectiveCamera, Scene, TOUCH, WebGLRenderer } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

export class Stage {
  scene = new Scene();
  camera = new PerspectiveCamera(35, 1, 0.01, 100);
  renderer = new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: false });
  canvas = this.renderer.domElement;
  orbit = new OrbitControls(this.camera, this.canvas);
  /** @type {() => any} */
  onResize = () => {}; // before the picture of another size is drawn
  #host;
  #drawOver;
  #stale = false;

  /**
   * @param {HTMLElement} host
   * @param {() => any} drawOver draws what is in front of each picture
   */
  constructor(host, drawOver) {
    this.#host = host;
    this.#drawOver = drawOver;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.canvas.setAttribute("aria-label", "The character. Drag to orbit, click to select a bone.");
    host.prepend(this.canvas);
    this.scene.add(this.camera);
    this.orbit.enableDamping = false;
    this.orbit.addEventListener("change", () => this.redraw());
    new ResizeObserver(() => this.resize()).observe(host);
  }

  /**
   * Looked at from its front alone: a drag moves, and turns nothing.
   * @param {boolean} flat
   */
  set flat(flat) {
    this.orbit.enableRotate = !flat;
    Object.assign(this.orbit.mouseButtons, { LEFT: flat ? MOUSE.PAN : MOUSE.ROTATE });
    Object.assign(this.orbit.touches, { ONE: flat ? TOUCH.PAN : TOUCH.ROTATE });
  }

  redraw() {
    if (this.#stale) return;
    this.#stale = true;
    requestAnimationFrame(() => {
      this.#stale = false;
      this.#draw();
    });
  }

  #draw() {
    this.renderer.render(this.scene, this.camera);
    this.#drawOver();
  }

  // The shares of its height, at the top and at the bottom, that buttons lie on.
  get covered() {
    const { height, top } = this.#host.getBoundingClientRect(), style = getComputedStyle(this.#host);
    const pixels = (/** @type {string} */ name) => parseFloat(style.getPropertyValue(name)) || 0;
    return top >= 0 && height > 0 ? { top: Math.min(0.3, pixels("--covered-top") / height), bottom: Math.min(0.3, pixels("--covered-bottom") / height) } : { top: 0, bottom: 0 };
  }

  // The middle of the picture, small: its address.
  thumbnail() {
    const [width, height] = [144, 108], { width: across, height: down } = this.canvas;
    const scale = 1.4 * Math.max(width / across, height / down); // what is framed has a margin
    const small = Object.assign(document.createElement("canvas"), { width, height });
    this.renderer.render(this.scene, this.camera); // what was drawn before is gone
    small.getContext("2d")?.drawImage(this.canvas, (width - across * scale) / 2, (height - down * scale) / 2, across * scale, down * scale);
    this.#drawOver();
    return small.toDataURL("image/webp", 0.8);
  }

  /**
   * Where a point of the scene is on the page.
   * @param {import("three").Vector3} point
   */
  onScreen(point) {
    this.camera.updateMatrixWorld(); // the picture may be a frame behind
    const at = point.project(this.camera);
    const box = this.canvas.getBoundingClientRect();
    return { x: box.left + ((at.x + 1) / 2) * box.width, y: box.top + ((1 - at.y) / 2) * box.height, behind: at.z > 1 };
  }

  resize() {
    const width = Math.max(1, this.#host.clientWidth);
    const height = Math.max(1, this.#host.clientHeight);
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.onResize();
    this.#draw(); // at once: a canvas that was sized anew is empty
  }
}
