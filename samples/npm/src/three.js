// SPDX-License-Identifier: MIT
// For three.js: geometries and bones in, skinIndex and skinWeight, bones, clips and positions out. `binder` is what load() or
// connect() of ./worker gave.
import {
  AnimationClip,
  AnimationMixer,
  Bone,
  Float32BufferAttribute,
  Matrix4,
  Quaternion,
  QuaternionKeyframeTrack,
  Skeleton,
  SkinnedMesh,
  Uint16BufferAttribute,
  Vector3,
  VectorKeyframeTrack,
} from "three";

const identity = new Matrix4();

/** A geometry as the engine reads it, in the world where `matrixWorld` puts it. */
export function meshOfGeometry(geometry, matrixWorld = identity) {
  const place = geometry.getAttribute("position");
  if (!place) throw new Error("the geometry has no positions");
  const positions = new Float32Array(place.count * 3);
  const point = new Vector3();
  for (let v = 0; v < place.count; ++v) point.fromBufferAttribute(place, v).applyMatrix4(matrixWorld).toArray(positions, 3 * v);
  const corners = geometry.index?.count ?? place.count;
  const indices = new Uint32Array(corners - (corners % 3));
  for (let c = 0; c < indices.length; ++c) indices[c] = geometry.index ? geometry.index.getX(c) : c;
  return { positions, indices };
}

// Bones of a list or a Skeleton.
const listOf = (bones) => (Array.isArray(bones) ? bones : bones.bones);

// The bones of a list, or of a Skeleton that stands as it was bound, wherever it was carried since. A posed one is refused by name: what
// is made from it would take the pose for the rest.
function restingBones(call, bones) {
  if (Array.isArray(bones)) return bones;
  const carried = new Matrix4(), moved = new Matrix4();
  bones.bones.forEach((bone, j) => {
    bone.updateWorldMatrix(true, false);
    moved.multiplyMatrices(bone.matrixWorld, bones.boneInverses[j]);
    if (j === 0) return void carried.copy(moved);
    const size = Math.max(...carried.elements.map(Math.abs), 1);
    if (carried.elements.some((x, i) => Math.abs(x - moved.elements[i]) > 1e-3 * size))
      throw new Error(`${call}: the skeleton is posed (${bone.name || `bone ${j}`}); call its pose() first, or give bones that stand at rest`);
  });
  return bones.bones;
}

/**
 * Bones as the engine reads them, where they are now; with a Skeleton where its inverses say that they are at rest.
 * @param {Bone[] | Skeleton} bones
 */
export function skeletonOfBones(bones) {
  const list = listOf(bones);
  const at = new Map(list.map((bone, j) => [bone, j]));
  const positions = new Float32Array(list.length * 3), parents = new Int32Array(list.length), rotations = new Float32Array(list.length * 4);
  const matrix = new Matrix4(), place = new Vector3(), turn = new Quaternion(), scale = new Vector3();
  list.forEach((bone, j) => {
    if (list !== bones) {
      matrix.copy(/** @type {Skeleton} */ (bones).boneInverses[j]).invert();
    } else {
      bone.updateWorldMatrix(true, false);
      matrix.copy(bone.matrixWorld);
    }
    matrix.decompose(place, turn, scale);
    place.toArray(positions, 3 * j);
    turn.toArray(rotations, 4 * j);
    let up = bone.parent;
    while (up && !at.has(up)) up = up.parent;
    parents[j] = up ? at.get(up) : -1;
  });
  return { names: list.map((bone) => bone.name), positions, parents, rotations };
}

/**
 * Predicts skin weights of a geometry and gives it skinIndex and skinWeight. `bones` stand where they are at rest.
 * @param {object} binder what load() or connect() gave
 * @param {import("three").BufferGeometry} geometry
 * @param {Bone[] | Skeleton} bones
 * @param {object} options as bind() has them; `matrixWorld`: of the mesh, where it is not the identity
 */
export async function bindGeometry(binder, geometry, bones, options = {}) {
  const { matrixWorld, ...rest } = options;
  if ((rest.influences ?? 4) > 4) throw new Error(`bindGeometry: expected at most 4 influences, which is what three.js skins with, found ${rest.influences}`);
  const bound = await binder.bind(meshOfGeometry(geometry, matrixWorld), skeletonOfBones(bones), { ...rest, format: "float" });
  setSkin(geometry, bound);
  return bound;
}

/** skinIndex and skinWeight of what bind() or transfer() gave. */
export function setSkin(geometry, bound) {
  const { joints, weights, influenceCount: n } = bound;
  const count = joints.length / n;
  const indices = new Uint16Array(4 * count), values = new Float32Array(4 * count);
  const unit = weights instanceof Uint16Array ? 65535 : 1;
  for (let v = 0; v < count; ++v)
    for (let i = 0; i < Math.min(n, 4); ++i) {
      indices[4 * v + i] = joints[n * v + i];
      values[4 * v + i] = weights[n * v + i] / unit;
    }
  geometry.setAttribute("skinIndex", new Uint16BufferAttribute(indices, 4));
  geometry.setAttribute("skinWeight", new Float32BufferAttribute(values, 4));
}

/**
 * A SkinnedMesh in the place of `mesh`, bound to `bones` as they stand now. The caller puts mesh and root bone into a scene.
 * @param {Bone[] | Skeleton} skeleton a Skeleton that is not posed
 */
export async function bindMesh(binder, mesh, skeleton, options = {}) {
  const bones = restingBones("bindMesh", skeleton);
  mesh.updateWorldMatrix(true, false);
  const bound = await bindGeometry(binder, mesh.geometry, bones, { ...options, matrixWorld: mesh.matrixWorld });
  const skinned = new SkinnedMesh(mesh.geometry, mesh.material);
  skinned.name = mesh.name;
  mesh.matrixWorld.decompose(skinned.position, skinned.quaternion, skinned.scale);
  skinned.updateMatrixWorld(true);
  for (const bone of bones) bone.updateWorldMatrix(true, false);
  skinned.bind(new Skeleton(bones), skinned.matrixWorld);
  return { mesh: skinned, bound };
}

/** Bones of what rig() gave: a list in its order, the first is the root. */
export function makeBones(rig) {
  const bones = rig.names.map((name) => Object.assign(new Bone(), { name }));
  bones.forEach((bone, j) => {
    const parent = rig.parents[j];
    bone.position.fromArray(rig.positions, 3 * j);
    if (parent < 0) return;
    bone.position.sub(new Vector3().fromArray(rig.positions, 3 * parent));
    bones[parent].add(bone);
  });
  bones[rig.parents.indexOf(-1)]?.updateWorldMatrix(false, true);
  return bones;
}

/** Palette of a skinned mesh as it stands: [J x 12] row-major, pose times inverse bind, in the world; for Deformer.pose(). */
export function paletteOf(skeleton) {
  if (Array.isArray(skeleton)) throw new Error("paletteOf: expected a Skeleton, which knows its rest, found a list of bones");
  const palette = new Float32Array(12 * skeleton.bones.length);
  const matrix = new Matrix4();
  skeleton.bones.forEach((bone, j) => {
    bone.updateWorldMatrix(true, false);
    const e = matrix.multiplyMatrices(bone.matrixWorld, skeleton.boneInverses[j]).elements;
    for (let row = 0; row < 3; ++row) for (let column = 0; column < 4; ++column) palette[12 * j + 4 * row + column] = e[4 * column + row];
  });
  return palette;
}

// Local rotations and translations of bones as they stand, relative to their parents in the list, the world for others.
function localPose(bones, parents, rotations, translations) {
  const turns = [], places = [];
  const place = new Vector3(), turn = new Quaternion(), scale = new Vector3();
  bones.forEach((bone) => {
    bone.updateWorldMatrix(true, false);
    bone.matrixWorld.decompose(place, turn, scale);
    turns.push(turn.clone());
    places.push(place.clone());
  });
  bones.forEach((_, j) => {
    const parent = parents[j];
    if (parent >= 0) {
      const back = turns[parent].clone().invert();
      turn.copy(back).multiply(turns[j]).toArray(rotations, 4 * j);
      place.copy(places[j]).sub(places[parent]).applyQuaternion(back).toArray(translations, 3 * j);
    } else {
      turns[j].toArray(rotations, 4 * j);
      places[j].toArray(translations, 3 * j);
    }
  });
}

// Characters that stand beside each other: each is seen as if its root were over the origin. Y is up, as three.js has
// it.
function standAtOrigin(rig) {
  const first = Math.max(rig.parents.indexOf(-1), 0);
  const origin = [rig.positions[3 * first], rig.positions[3 * first + 2]];
  for (let i = 0; i < rig.positions.length; i += 3) {
    rig.positions[i] -= origin[0];
    rig.positions[i + 2] -= origin[1];
  }
  return Object.assign(rig, { origin });
}

function moveRoots(parents, translations, x, z) {
  for (let at = 0; at < translations.length; at += 3) {
    if (parents[(at / 3) % parents.length] >= 0) continue;
    translations[at] += x;
    translations[at + 2] += z;
  }
}

// Roots are in the world; their tracks are in the axes of what holds them.
function rootsToParents(bones, parents, { rotations, translations, frameCount }) {
  const place = new Vector3(), turn = new Quaternion(), back = new Matrix4(), turnBack = new Quaternion();
  bones.forEach((bone, j) => {
    if (parents[j] >= 0 || !bone.parent) return;
    bone.parent.updateWorldMatrix(true, false);
    back.copy(bone.parent.matrixWorld).invert();
    bone.parent.getWorldQuaternion(turnBack).invert();
    for (let f = 0; f < frameCount; ++f) {
      const at = f * bones.length + j;
      place.fromArray(translations, 3 * at).applyMatrix4(back).toArray(translations, 3 * at);
      turn.fromArray(rotations, 4 * at).premultiply(turnBack).toArray(rotations, 4 * at);
    }
  });
}

/**
 * A clip of `source` for the bones of `target`. Both stand at rest when it is called; a posed Skeleton is refused. The source stands at rest again afterwards.
 * @param {object} skin what load() gave; not of a worker
 * @param {AnimationClip} clip of the source's bones
 * @param {Bone[] | Skeleton} source
 * @param {Bone[] | Skeleton} target bones without nodes that are scaled or turned between them
 * @param {{fps?: number, map?: Int32Array, body?: object, inPlace?: boolean, armSpread?: number}} options as retarget() and clip() have them; fps: 30
 */
export function retargetClip(skin, clip, source, target, options = {}) {
  const fps = options.fps ?? 30;
  const sourceBones = restingBones("retargetClip", source), targetBones = restingBones("retargetClip", target);
  const from = standAtOrigin(skeletonOfBones(sourceBones)), to = standAtOrigin(skeletonOfBones(targetBones));
  let root = sourceBones[from.parents.indexOf(-1)];
  while (root.parent && !root.parent.isScene) root = root.parent;
  const plan = skin.retarget(from, to, options);
  try {
    const frames = Math.max(1, Math.round(clip.duration * fps) + 1);
    const rotations = new Float32Array(4 * sourceBones.length * frames), translations = new Float32Array(3 * sourceBones.length * frames);
    const mixer = new AnimationMixer(root);
    mixer.clipAction(clip).play();
    for (let f = 0; f < frames; ++f) {
      mixer.setTime(Math.min(f / fps, clip.duration - 1e-6));
      localPose(
        sourceBones,
        from.parents,
        rotations.subarray(4 * sourceBones.length * f, 4 * sourceBones.length * (f + 1)),
        translations.subarray(3 * sourceBones.length * f, 3 * sourceBones.length * (f + 1)),
      );
    }
    mixer.stopAllAction();
    mixer.uncacheRoot(root);
    moveRoots(from.parents, translations, -from.origin[0], -from.origin[1]);
    const made = plan.clip({ rotations, translations }, { body: options.body, fps });
    moveRoots(to.parents, made.translations, to.origin[0], to.origin[1]);
    rootsToParents(targetBones, to.parents, made);
    const times = Float32Array.from({ length: frames }, (_, f) => f / fps);
    const tracks = [];
    const count = targetBones.length;
    const column = (values, width, j) => {
      const out = new Float32Array(width * frames);
      for (let f = 0; f < frames; ++f) out.set(values.subarray(width * (count * f + j), width * (count * f + j + 1)), width * f);
      return out;
    };
    targetBones.forEach((bone, j) => {
      if (plan.map[j] < 0 && to.parents[j] >= 0) return;
      tracks.push(new QuaternionKeyframeTrack(`${bone.name}.quaternion`, times, column(made.rotations, 4, j)));
      // Roots and what moves in its parent; bones keep their length.
      const places = column(made.translations, 3, j);
      const still = bone.position.toArray();
      const moves = places.some((x, i) => Math.abs(x - still[i % 3]) > 1e-4);
      if (to.parents[j] < 0 || moves) tracks.push(new VectorKeyframeTrack(`${bone.name}.position`, times, places));
    });
    return new AnimationClip(clip.name, (frames - 1) / fps, tracks);
  } finally {
    plan.free();
  }
}
