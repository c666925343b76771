// SPDX-License-Identifier: MIT
// Markers in the picture: where the user says that a part of the body is, and where its mirror image would be.
import { Color, Mesh, MeshBasicMaterial, SphereGeometry } from "three";

const colour = new Color(0x2ec4ff);
const chosenColour = new Color(0xffffff);

/** @typedef {{ place: number[], chosen?: boolean, image?: boolean }} Shown */

export class MarkerBalls {
  /** @type {Mesh<SphereGeometry, MeshBasicMaterial>[]} */
  #balls = [];
  #parent;
  #geometry = new SphereGeometry(1, 16, 10);
  /** @type {Shown[]} */
  #markers = [];

  /** @param {import("three").Object3D} parent */
  constructor(parent) {
    this.#parent = parent;
  }

  // markers: [{place: [x, y, z], chosen, image}] in the model's axes, image: that of another one; radius: of the character.
  /**
   * @param {Shown[]} markers
   * @param {number} radius
   */
  show(markers, radius) {
    this.#markers = markers;
    while (this.#balls.length < markers.length) this.#add();
    this.#balls.forEach((ball, i) => {
      const marker = markers[i];
      ball.visible = Boolean(marker);
      if (!marker) return;
      ball.position.fromArray(marker.place);
      ball.scale.setScalar((marker.chosen ? 0.03 : 0.022) * radius);
      ball.material.color.copy(marker.chosen ? chosenColour : colour);
      ball.material.opacity = marker.image ? 0.35 : 0.9;
    });
  }

  // Those that can be dragged: [{place, index}]
  get handles() {
    return this.#markers.flatMap(({ place, image }, index) => (image ? [] : [{ place, index }]));
  }
  // For tests.
  get shown() {
    return this.#balls.filter(({ visible }) => visible).map(({ position }) => position.toArray());
  }

  #add() {
    const ball = new Mesh(this.#geometry, new MeshBasicMaterial({ transparent: true, depthTest: false, depthWrite: false }));
    ball.renderOrder = 4;
    this.#balls.push(ball);
    this.#parent.add(ball);
  }
}
