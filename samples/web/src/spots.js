// SPDX-License-Identifier: MIT
// Contacts in the picture: where feet stand, hands touch, and arms lie in the body.
import { Color, Group, Mesh, MeshBasicMaterial, SphereGeometry } from "three";

const inside = 3; // SINEW_SPOT_INSIDE
const stands = 1; // SINEW_SPOT_STANDS
// Shares of the height that are still held: of a foot a frame, of a hand.
const stillSlide = 0.001, stillOff = 0.01;
/** @typedef {{ kind: number, error: number, place: number[] }} Spot */
/** @type {Record<string, Color>} */
const colours = { held: new Color(0x3ddc84), slips: new Color(0xff9f2e), inside: new Color(0xff4d4d) };

// What a spot is called in the legend: the engine's sinew_contact_spot.
/** @param {Spot} spot */
export function spotGrade({ kind, error }) {
  if (kind === inside) return "inside";
  return error <= (kind === stands ? stillSlide : stillOff) ? "held" : "slips";
}

export class ContactSpots {
  /** @type {Mesh<SphereGeometry, MeshBasicMaterial>[]} */
  #balls = [];
  #group = new Group();
  #geometry = new SphereGeometry(1, 16, 10);

  /** @param {import("three").Object3D} parent */
  constructor(parent) {
    parent.add(this.#group);
  }

  /** @param {boolean} visible */
  set visible(visible) {
    this.#group.visible = visible;
  }

  // spots: of the module's frame, in the model's axes; radius: of the character.
  /** @param {Spot[]} spots @param {number} radius */
  show(spots, radius) {
    while (this.#balls.length < spots.length) this.#add();
    this.#balls.forEach((ball, i) => {
      const spot = spots[i];
      ball.visible = Boolean(spot);
      if (!spot) return;
      ball.position.fromArray(spot.place);
      ball.scale.setScalar(0.02 * radius);
      ball.material.color.copy(colours[spotGrade(spot)]);
    });
  }

  // For tests: [grade] of those that are shown.
  get shown() {
    return this.#balls.filter(({ visible }) => visible).map(({ material }) => Object.keys(colours).find((name) => colours[name].equals(material.color)));
  }

  #add() {
    // Over the mesh: a foot hides what it stands on.
    const ball = new Mesh(this.#geometry, new MeshBasicMaterial({ transparent: true, opacity: 0.85, depthTest: false, depthWrite: false }));
    ball.renderOrder = 3;
    this.#balls.push(ball);
    this.#group.add(ball);
  }
}
