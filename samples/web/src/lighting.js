// SPDX-License-Identifier: MIT
// The picture's light, and the floor below the character, light or dark as the system is.
import { DirectionalLight, GridHelper, HemisphereLight, NeutralToneMapping, NoToneMapping } from "three";

const roomIntensity = 0.55; // of the light that materials get from the room around them

export class Lighting {
  #sky = new HemisphereLight(0xffffff, 0x8b93a3);
  #lamp = new DirectionalLight(0xffffff);
  #of;

  /** @param {{ scene: import("three").Scene, camera: import("three").Camera, renderer: import("three").WebGLRenderer }} of */
  constructor(of) {
    this.#of = of;
    of.scene.add(this.#sky);
    of.camera.add(this.#lamp);
    this.#lamp.position.set(0.6, 0.9, 0.7);
    this.show(null);
  }

  // Materials are lit by the room, and bright ones keep their colours; what shows weights is lit evenly.
  /** @param {import("./look.js").Look | null} look */
  show(look) {
    const { scene, renderer } = this.#of;
    scene.environment = look?.room(renderer, roomIntensity) ?? null;
    scene.environmentIntensity = roomIntensity;
    renderer.toneMapping = look ? NeutralToneMapping : NoToneMapping;
    this.#sky.intensity = look ? 0 : 1.9;
    this.#lamp.intensity = look ? 0.7 : 1.7;
  }
}

const isLight = matchMedia("(prefers-color-scheme: light)");

export class Floor {
  /** @type {GridHelper | null} */
  grid = null;
  #scene;

  /** @param {import("three").Scene} scene @param {() => void} onChange of the system's colours */
  constructor(scene, onChange) {
    this.#scene = scene;
    isLight.addEventListener("change", onChange);
  }

  /** @param {import("./framing.js").Framing} framing @param {number} height */
  show({ radius, centre }, height) {
    this.grid?.dispose();
    this.grid?.removeFromParent();
    this.grid = new GridHelper(radius * 4, 20, ...(isLight.matches ? [0xaab2bd, 0xc9cfd8] : [0x4a515d, 0x2c3139]));
    this.grid.position.set(centre.x, height, centre.z);
    this.#scene.add(this.grid);
  }
}
