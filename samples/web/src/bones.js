// SPDX-License-Identifier: MIT
// The skeleton on top of the picture: a bone from every joint's parent to it, and a ball where the joint is.
import { Color, Group, InstancedMesh, Matrix4, MeshBasicMaterial, OctahedronGeometry, Quaternion, SphereGeometry, Vector3 } from "three";

const bonesColour = new Color(0xdfe5ec);
export const chosenColour = new Color(0x4c9aff);
const doubtColour = new Color(0xff4433);

// How many joints are above each.
/** @param {{ parent: number }[]} joints */
function depthsOf(joints) {
  return joints.map((_, j) => {
    let depth = 0;
    for (let above = joints[j].parent; above >= 0 && depth <= joints.length; above = joints[above].parent) ++depth;
    return depth;
  });
}

export class Bones {
  #group = new Group();
  /** @type {InstancedMesh[]} */
  #parts = []; // bones and balls, once there are joints
  /** @type {{ parent: number }[]} */
  #joints = [];
  #positions = new Float32Array();
  #sizeOf;
  #thickness = 1;
  #grown = 1;
  #chosen = -1;
  #also = new Set();
  /** @type {any} */
  #colours = null;
  #doubts = new Set();

  // sizeOf: () => that of the character, which thicknesses follow
  /** @param {import("three").Object3D} model @param {() => number} sizeOf */
  constructor(model, sizeOf) {
    model.add(this.#group);
    this.#sizeOf = sizeOf;
  }

  get shown() {
    return this.#group.visible;
  }
  set shown(shown) {
    this.#group.visible = shown;
  }

  // How much of the skeleton there is, a share of 1: it grows from its roots.
  /** @param {number} share */
  set grown(share) {
    this.#grown = share;
    this.place();
  }

  get thickness() {
    return this.#thickness;
  }
  set thickness(thickness) {
    this.#thickness = thickness;
    this.place();
  }

  // joints: [{parent}]; positions: [J x 3]
  /** @param {{ parent: number }[]} joints @param {Float32Array<ArrayBuffer>} positions */
  make(joints, positions) {
    this.#joints = joints;
    this.#positions = positions;
    this.#colours = null;
    for (const part of this.#parts) {
      part.removeFromParent();
      part.dispose();
    }
    const material = () => new MeshBasicMaterial({ transparent: true, opacity: 0.9, depthTest: false, depthWrite: false });
    const bone = new OctahedronGeometry(1, 0);
    const corners = bone.getAttribute("position");
    for (let i = 0; i < corners.count; ++i) {
      // From 0 to 1 along Y, widest near the start.
      const y = corners.getY(i);
      corners.setY(i, y > 0.5 ? 1 : y < -0.5 ? 0 : 0.18);
    }
    const bones = new InstancedMesh(bone, material(), Math.max(1, this.#joints.length));
    bones.material.opacity = 0.5;
    const balls = new InstancedMesh(new SphereGeometry(1, 12, 8), material(), Math.max(1, this.#joints.length));
    bones.renderOrder = 1;
    balls.renderOrder = 2;
    this.#parts = [bones, balls];
    for (const mesh of this.#parts) {
      mesh.count = this.#joints.length;
      mesh.frustumCulled = false;
      this.#group.add(mesh);
    }
    this.paint();
  }

  // positions: [J x 3]
  place(positions = this.#positions) {
    this.#positions = positions;
    if (this.#parts.length === 0) return;
    const [bones, balls] = this.#parts;
    const at = new Vector3();
    const from = new Vector3();
    const along = new Vector3();
    const turn = new Quaternion();
    const up = new Vector3(0, 1, 0);
    const whole = this.#sizeOf();
    const matrix = new Matrix4();
    const size = new Vector3();
    const depths = depthsOf(this.#joints), deepest = Math.max(0, ...depths);
    this.#joints.forEach(({ parent }, j) => {
      at.fromArray(positions, j * 3);
      const grown = Math.min(1, Math.max(0, this.#grown * (deepest + 1) - depths[j]));
      let length = whole * 0.1;
      if (parent >= 0) {
        from.fromArray(positions, parent * 3);
        along.subVectors(at, from);
        at.copy(from).addScaledVector(along, grown);
        length = Math.max(1e-9, grown * along.length());
        turn.setFromUnitVectors(up, along.normalize());
        const width = Math.min(length * 0.09, whole * 0.014) * this.#thickness;
        bones.setMatrixAt(j, matrix.compose(from, turn, size.set(width, length, width)));
      } else {
        bones.setMatrixAt(j, matrix.makeScale(0, 0, 0));
      }
      const ball = Math.min(Math.max(length * 0.1, whole * 0.004), whole * 0.011) * this.#thickness * (j === this.#chosen ? 1.5 : 1) * (grown > 0 ? 1 : 0);
      balls.setMatrixAt(j, matrix.compose(at, turn.identity(), size.setScalar(ball)));
    });
    bones.instanceMatrix.needsUpdate = true;
    balls.instanceMatrix.needsUpdate = true;
  }

  // chosen: a joint or -1; also: Set of joints beside it; colours: of joints, or null; doubts: Set of those that may be wrong.
  paint({ chosen = this.#chosen, also = this.#also, colours = this.#colours, doubts = this.#doubts } = {}) {
    [this.#chosen, this.#also, this.#colours, this.#doubts] = [chosen, also, colours, doubts];
    if (this.#parts.length === 0) return;
    const [bones, balls] = this.#parts;
    this.#joints.forEach(({ parent }, j) => {
      balls.setColorAt(j, j === chosen || also.has(j) ? chosenColour : doubts.has(j) ? doubtColour : (colours?.[j] ?? bonesColour));
      bones.setColorAt(j, parent === chosen && parent >= 0 ? chosenColour : doubts.has(j) ? doubtColour : bonesColour);
    });
    for (const mesh of [bones, balls]) if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
    this.place();
  }
}
