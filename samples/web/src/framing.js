// SPDX-License-Identifier: MIT
// Where the camera stands: it brings a box into view, and goes along with a motion over the floor.
import { Box3, MathUtils, Vector3 } from "three";

export const slanted = [0.42, 0.22, 1]; // from where a character is looked at first, in the picture's axes

export class Framing {
  radius = 1; // of what was framed last
  centre = new Vector3();
  untouched = true; // the camera stands where it was put
  #camera;
  #orbit;
  /** @type {Vector3 | null} */
  #middle = null; // of the joints in a motion's last frame
  #box = new Box3(); // what was framed last, and from where
  #from = slanted;
  #room;

  /** @param {{ camera: import("three").PerspectiveCamera, orbit: import("three/addons/controls/OrbitControls.js").OrbitControls, room: () => { top: number, bottom: number } }} of room: shares of the picture's
   *   height that something lies on */
  constructor({ camera, orbit, room }) {
    this.#room = room;
    this.#camera = camera;
    this.#orbit = orbit;
  }

  /**
   * Brings a box of the picture into view.
   * @param {Box3} box
   * @param {number[]} from the direction that the camera is in
   */
  frame(box, from = slanted) {
    const [camera, orbit] = [this.#camera, this.#orbit];
    this.#box.copy(box);
    this.#from = from;
    box.getCenter(this.centre);
    this.radius = Math.max(box.getSize(new Vector3()).length() / 2, 1e-6);
    const direction = new Vector3().fromArray(from).normalize();
    const { top, bottom } = this.#room(), free = 1 - top - bottom;
    const half = (camera.fov * MathUtils.DEG2RAD) / 2;
    const fit = this.radius / Math.sin(half) / Math.min(free, camera.aspect);
    camera.near = this.radius / 200;
    camera.far = this.radius * 200;
    camera.updateProjectionMatrix();
    orbit.target.copy(this.centre);
    camera.position.copy(this.centre).addScaledVector(direction, fit * 0.97);
    camera.lookAt(this.centre);
    const lift = new Vector3(0, 1, 0).applyQuaternion(camera.quaternion).multiplyScalar(fit * 0.97 * Math.tan(half) * (top - bottom)); // its middle is that of the free part
    camera.position.add(lift);
    orbit.target.add(lift);
    orbit.minDistance = this.radius / 20;
    orbit.maxDistance = this.radius * 30;
    orbit.update();
    this.untouched = true;
  }

  // The same once more, in a picture of another shape.
  again() {
    this.frame(this.#box.clone(), this.#from);
  }

  /**
   * The camera stands elsewhere as a whole.
   * @param {(place: Vector3) => void} move
   */
  move(move) {
    move(this.#camera.position);
    move(this.#orbit.target);
    this.#orbit.update();
  }

  // The next frame of a motion is seen from here, as this middle of its joints is; null: none moves.
  /** @param {Vector3 | null} middle */
  startAt(middle) {
    this.#middle = middle;
  }

  /**
   * The camera moves by what the joints' middle has moved over the floor; once more when a motion has ended, back to the pose.
   * @param {Vector3} middle
   * @param {boolean} moves
   */
  goAlong(middle, moves) {
    if (this.#middle) {
      const way = new Vector3().subVectors(middle, this.#middle).setY(0);
      this.#camera.position.add(way);
      this.#orbit.target.add(way);
      this.#box.translate(way);
      this.#orbit.update();
    }
    this.#middle = moves ? middle : null;
  }
}

/**
 * @param {ArrayLike<number>} positions [J x 3]
 * @returns {Vector3}
 */
export function middleOfJoints(positions) {
  const middle = new Vector3(), at = new Vector3();
  const count = Math.max(1, positions.length / 3);
  for (let j = 0; j < positions.length; j += 3) middle.addScaledVector(at.set(positions[j], positions[j + 1], positions[j + 2]), 1 / count);
  return middle;
}

/**
 * What a clip takes up, in the model's axes: the mesh reaches beyond its joints, at rest and in motion.
 * @param {{ is: number[][], around: number[][], rest: number[][] }} room of the module, what the joints take up; the camera goes along with them over the floor
 * @param {number} up the axis, 1 or 2
 * @param {Float32Array} joints [J x 3] at rest
 * @param {Box3} mesh at rest
 */
export function boxOfClip({ is, around, rest }, up, joints, mesh) {
  const middle = middleOfJoints(joints);
  const box = new Box3();
  for (const i of [0, 1, 2]) {
    const [least, most] = i === up ? is[i] : around[i].map((x) => x + middle.getComponent(i));
    box.min.setComponent(i, least - Math.max(0, rest[i][0] - mesh.min.getComponent(i)));
    box.max.setComponent(i, most + Math.max(0, mesh.max.getComponent(i) - rest[i][1]));
  }
  return { box, middle };
}
