// SPDX-License-Identifier: MIT
// The character as other programs show it: the GLB that the page would save, read by three.js, with the file's own materials and textures.
import { Box3, LightProbe, Matrix4, PMREMGenerator, Quaternion, SphericalHarmonics3, Vector3 } from "three";
import { RoomEnvironment } from "three/addons/environments/RoomEnvironment.js";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

// A material that its file says nothing of is white by glTF, on which no shape shows: it is grey as clay here.
const isPlain = ({ color, map, vertexColors, emissive }) => color && !map && !vertexColors && color.r === 1 && color.g === 1 && color.b === 1 && !emissive?.r;

// How a RoomEnvironment lights what is dull, as spherical harmonics, alike for red, green and blue: LightProbeGenerator.fromCubeRenderTarget() of a cube of
// 64 pixels. What mirrors needs the room itself, whose making costs seconds where no graphics card draws.
const roomHarmonics = [3.7119, 1.7183, 1.6268, 0.2877, 0.2338, 1.0789, 1.2682, -0.34, -0.6285];
const mirrors = (/** @type {any} */ { isMeshStandardMaterial, isMeshPhysicalMaterial, metalness, roughness, roughnessMap }) =>
  isMeshStandardMaterial && (isMeshPhysicalMaterial || metalness > 0 || roughness < 0.5 || roughnessMap);

const near = 1e-3; // of the size of the skeleton
const rounds = 100; // of the power iteration

// The similarity transform that brings points nearest to others: Horn, Closed-form solution of absolute orientation using unit quaternions, 1987.
/** @param {Vector3[]} from @param {Vector3[]} to */
function similarity(from, to) {
  const [a, b] = [from, to].map((points) => points.reduce((sum, point) => sum.add(point), new Vector3()).divideScalar(points.length));
  const m = [0, 0, 0, 0, 0, 0, 0, 0, 0];
  let [ofFrom, ofTo] = [0, 0];
  from.forEach((point, i) => {
    const [p, q] = [point.clone().sub(a).toArray(), to[i].clone().sub(b).toArray()];
    for (let k = 0; k < 9; ++k) m[k] += p[Math.floor(k / 3)] * q[k % 3];
    [ofFrom, ofTo] = [ofFrom + p[0] ** 2 + p[1] ** 2 + p[2] ** 2, ofTo + q[0] ** 2 + q[1] ** 2 + q[2] ** 2];
  });
  const [xx, xy, xz, yx, yy, yz, zx, zy, zz] = m;
  const n = [[xx - yy - zz, xy + yx, zx + xz, yz - zy], [xy + yx, yy - xx - zz, yz + zy, zx - xz], [zx + xz, yz + zy, zz - xx - yy, xy - yx], [yz - zy, zx - xz, xy - yx, xx + yy + zz]];
  const shift = Math.hypot(...n.flat()); // makes the largest eigenvalue the one of the largest absolute value
  let rotation = new Quaternion(0.1, 0.2, 0.3, 0.9).normalize();
  for (let i = 0; i < rounds && shift > 0; ++i) {
    const q = rotation.toArray();
    rotation = new Quaternion(...n.map((row, k) => row.reduce((sum, x, l) => sum + x * q[l], shift * q[k]))).normalize();
  }
  const scale = Math.sqrt(ofTo / (ofFrom || 1));
  const made = new Matrix4().compose(new Vector3(), rotation, new Vector3(scale, scale, scale));
  return made.setPosition(b.clone().sub(a.clone().applyMatrix4(made)));
}

// Where bones are when nothing moves. A file's nodes may stand in another pose than its weights were made in, as in a frame of an animation: that one is
// known by the inverse bind matrices, but for a transform of all of them, which brings the bones to the page's joints.
/** @param {import("three").Object3D} root @param {any[]} bones @param {import("./types.js").Joint[]} joints @returns {any[]} matrices in the space of the root */
function restsOf(root, bones, joints) {
  const bound = new Map(); // bone: its matrix in the space of its mesh's weights
  root.traverse((/** @type {any} */ { skeleton }) => skeleton?.bones.forEach((/** @type {any} */ bone, /** @type {number} */ k) => bound.has(bone) || bound.set(bone, skeleton.boneInverses[k].clone().invert())));
  const asNodes = bones.map((bone) => bone?.matrixWorld.clone());
  const known = bones.flatMap((bone, j) => (bound.has(bone) ? [j] : []));
  const places = known.map((j) => new Vector3().fromArray(joints[j].position)), placeOf = (/** @type {any} */ matrix) => new Vector3().setFromMatrixPosition(matrix);
  const size = new Box3().setFromPoints(places).getSize(new Vector3()).length();
  if (known.every((j, i) => placeOf(asNodes[j]).distanceTo(places[i]) <= near * size)) return asNodes;
  const frame = similarity(known.map((j) => placeOf(bound.get(bones[j]))), places);
  return bones.map((bone, j) => (bound.has(bone) ? frame.clone().multiply(bound.get(bone)) : asNodes[j]));
}

export class Look {
  /** @type {import("three").Group} */
  root;
  /** @type {import("three").AnimationClip[]} */
  animations;
  /** @type {object | null} */
  result = null; // of the bind that the file is of
  /** @type {any} */
  #bones; // per joint of the page: its node, or undefined
  /** @type {any} */
  #room = null;
  #mirrors = false;
  /** @type {any} */
  #restOf; // per bone: where it is at rest

  constructor({ scene, animations }) {
    this.root = scene;
    this.animations = animations;
  }

  // glb: bytes; joints: the page's, at rest.
  static async of(glb, joints) {
    const gltf = await new GLTFLoader().parseAsync(glb.buffer.slice(glb.byteOffset, glb.byteOffset + glb.byteLength), "");
    const { json, associations } = gltf.parser;
    const nodes = new Map();
    for (const [object, at] of associations) if (at?.nodes !== undefined && "isObject3D" in object) nodes.set(at.nodes, object);
    const numbers = [...new Set((json.skins ?? []).flatMap((skin) => skin.joints))];
    const named = new Map(numbers.map((index) => [json.nodes[index].name, nodes.get(index)]));
    const look = new Look(gltf);
    look.#bones = joints.map(({ name }, j) => named.get(name) ?? (numbers.length === joints.length ? nodes.get(numbers[j]) : undefined));
    look.root.updateMatrixWorld(true);
    look.#restOf = restsOf(look.root, look.#bones, joints);
    look.root.traverse((/** @type {any} */ object) => {
      object.frustumCulled = false;
      for (const one of [object.material].flat()) {
        if (one?.isMeshBasicMaterial) one.toneMapped = false; // a drawing's colours are what they are
        else if (one && isPlain(one)) {
          one.color.setScalar(0.42);
          if (one.roughness === 1) one.metalness = 0; // which is 1 where a file says nothing
        }
        if (one && mirrors(one)) look.#mirrors = true;
      }
    });
    return look;
  }

  // The room that lights the character and that metals mirror, which are black without one; null where nothing mirrors: there a probe among its parts,
  // `intensity` bright, gives the room's light.
  room(renderer, intensity) {
    if (!this.#mirrors) {
      this.root.add(new LightProbe(new SphericalHarmonics3().set(roomHarmonics.map((of) => new Vector3().setScalar(of))), intensity));
      return null;
    }
    const generator = new PMREMGenerator(renderer);
    this.#room = generator.fromScene(new RoomEnvironment(), 0.04);
    generator.dispose();
    return this.#room.texture;
  }

  // palette: [J x 12] row-major, what moves each joint from its rest, in the character's space.
  pose(palette) {
    const world = new Map(); // of bones, in the character's space
    this.#bones.forEach((bone, j) => {
      if (!bone) return;
      const [a, b, c, d, e, f, g, h, i, k, l, m] = palette.subarray(12 * j, 12 * j + 12);
      world.set(bone, new Matrix4().set(a, b, c, d, e, f, g, h, i, k, l, m, 0, 0, 0, 1).multiply(this.#restOf[j]));
    });
    // What stands between the root and a bone: itself moved, where a joint is above it.
    const worldOf = (object) => {
      if (object === this.root || !object) return new Matrix4();
      if (world.has(object)) return world.get(object);
      object.updateMatrix();
      return worldOf(object.parent).clone().multiply(object.matrix);
    };
    for (const [bone, at] of world) {
      bone.matrixAutoUpdate = false;
      bone.matrix.copy(worldOf(bone.parent).clone().invert().multiply(at));
    }
  }

  dispose() {
    this.#room?.dispose();
    this.root.removeFromParent();
    this.root.traverse((/** @type {any} */ { geometry, material }) => {
      geometry?.dispose();
      for (const one of [material].flat()) {
        for (const value of Object.values(one ?? {})) if (value?.isTexture) value.dispose();
        one?.dispose();
      }
    });
  }
}
