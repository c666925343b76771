// SPDX-License-Identifier: MIT
// A page with three.js: a bare mesh gets a skeleton, weights and a pose, one with a skeleton its weights beside the page.
import * as THREE from "three";
import { load } from "@sinew/skin";
import { load as loadBind } from "@sinew/skin/bind";
import { bindWasm, wasm } from "@sinew/skin/url";
import { loadModel, loadRigModel } from "@sinew/skin/model";
import { bindGeometry, bindMesh, makeBones, meshOfGeometry, paletteOf, retargetClip, skeletonOfBones } from "@sinew/skin/three";
import { connect } from "@sinew/skin/worker";
import { bindHash, readObj, readRig, triangles } from "./characters.mjs";

const scene = new THREE.Scene();
const camera = new THREE.PerspectiveCamera(35, innerWidth / innerHeight, 0.1, 100);
const renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
renderer.setSize(innerWidth, innerHeight);
document.body.append(renderer.domElement);
scene.add(new THREE.HemisphereLight(0xffffff, 0x445566, 3));

const text = async (name) => (await fetch(name)).text();
const unorm = (array) => Uint16Array.from(array, (w) => Math.round(w * 65535));

function geometryOf(mesh) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(mesh.positions.slice(), 3));
  geometry.setIndex(new THREE.BufferAttribute(triangles(mesh), 1));
  geometry.computeVertexNormals();
  return geometry;
}

function meshOf(geometry, color, x) {
  const mesh = new THREE.Mesh(geometry, new THREE.MeshStandardMaterial({ color, roughness: 0.8 }));
  mesh.position.x = x;
  return mesh;
}

async function run() {
  const model = await loadModel();
  const skin = await load({ model });
  const remote = await connect(new Worker(new URL("./skin-worker.js", import.meta.url), { type: "module" }), { model });
  const result = { kernel: skin.kernel, remote: remote.kernel };

  // A skeleton of its own, bound in the worker.
  const source = readObj(await text("biped__robed.obj"));
  const { skeleton } = readRig(await text("biped__robed.rig.txt"));
  const bones = makeBones(skeleton);
  const geometry = geometryOf(source);
  let told = 0;
  await bindGeometry(remote, geometry, bones, { onProgress: () => void ++told });
  const index = geometry.getAttribute("skinIndex").array, weight = geometry.getAttribute("skinWeight").array;
  result.hash = bindHash({ joints: index, weights: unorm(weight) });
  result.told = told;
  const both = [];
  for (const binder of [await load({ model, wasm }), await loadBind({ model, wasm: bindWasm })]) {
    const one = geometryOf(source);
    await bindGeometry(binder, one, bones);
    both.push(bindHash({ joints: one.getAttribute("skinIndex").array, weights: unorm(one.getAttribute("skinWeight").array) }));
  }
  result.byUrl = both[0] === both[1] ? both[0] : both.join(" ");
  result.read = skeletonOfBones(bones).parents.every((parent, j) => parent === skeleton.parents[j]);

  // The same beside the origin, turned and scaled: the mesh's place counts, and a resting SkinnedMesh is where the mesh was.
  const placed = meshOf(geometryOf(source), 0x7fb4d8, -0.9);
  const placedBones = makeBones(skeleton);
  const holder = new THREE.Group();
  holder.position.x = -0.9;
  holder.add(placedBones[0]);
  scene.add(holder);
  const { mesh: skinned } = await bindMesh(skin, placed, placedBones);
  scene.add(skinned);
  scene.updateMatrixWorld(true);
  const rest = new THREE.Vector3(), was = new THREE.Vector3();
  result.restMoves = 0;
  for (let v = 0; v < 200; ++v) {
    skinned.getVertexPosition(v, rest);
    was.fromBufferAttribute(skinned.geometry.getAttribute("position"), v);
    result.restMoves = Math.max(result.restMoves, rest.distanceTo(was));
  }

  // A Skeleton is as good as its bones, carried or not, while it is not posed.
  const again = meshOf(geometryOf(source), 0xffffff, -0.9);
  const { bound } = await bindMesh(skin, again, skinned.skeleton);
  result.bySkeleton = bound.joints.every((joint, i) => joint === skinned.geometry.getAttribute("skinIndex").array[i]);

  // A bare mesh: skeleton, weights.
  const bare = meshOf(geometryOf(source), 0xd8a47f, 0.9);
  bare.updateMatrixWorld();
  const rig = skin.rig(meshOfGeometry(bare.geometry, bare.matrixWorld), { model: skin.openModel(await loadRigModel()) });
  const made = makeBones(rig);
  scene.add(made[0]);
  const { mesh: rigged } = await bindMesh(skin, bare, made, { joints: "names" });
  scene.add(rigged);
  result.rigged = rig.names.length;

  // A wave of the one on the other.
  const find = (list, pattern) => list.find((bone) => pattern.test(bone.name)) ?? list[1];
  const arm = find(placedBones, /upper_arm\.L|arm_upper\.L|LeftArm/i);
  result.arm = arm.name;
  const turn = new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(0, 0, 1), 1);
  const clip = new THREE.AnimationClip("wave", 1, [
    new THREE.QuaternionKeyframeTrack(`${THREE.PropertyBinding.sanitizeNodeName(arm.name)}.quaternion`, [0, 1], [0, 0, 0, 1, ...turn.toArray()]),
  ]);
  for (const bone of placedBones) bone.name = THREE.PropertyBinding.sanitizeNodeName(bone.name);
  const played = retargetClip(skin, clip, skinned.skeleton, rigged.skeleton, { fps: 10 });
  result.tracks = played.tracks.length;
  const restTip = made.map((bone) => bone.getWorldPosition(new THREE.Vector3()));
  const mixer = new THREE.AnimationMixer(made[0]);
  mixer.clipAction(played).play();
  mixer.setTime(0.999);
  scene.updateMatrixWorld(true);
  result.moved = Math.max(...made.map((bone, j) => bone.getWorldPosition(new THREE.Vector3()).distanceTo(restTip[j])));
  result.hips = made[0].getWorldPosition(new THREE.Vector3()).distanceTo(restTip[0]);
  arm.quaternion.copy(turn);
  scene.updateMatrixWorld(true);
  result.posed = {};
  for (const [call, refused] of [
    ["bindMesh", () => bindMesh(skin, again, skinned.skeleton)],
    ["retargetClip", async () => retargetClip(skin, clip, skinned.skeleton, rigged.skeleton)],
  ])
    result.posed[call] = await refused().then(() => "taken", (error) => error.message);

  // The same pose with its volume kept: positions in the world.
  const deformer = skin.deformer(meshOfGeometry(skinned.geometry, skinned.matrixWorld), skeletonOfBones(skinned.skeleton), {
    joints: skinned.geometry.getAttribute("skinIndex").array,
    weights: skinned.geometry.getAttribute("skinWeight").array,
  });
  const kept = deformer.pose(paletteOf(skinned.skeleton));
  result.corrected = kept.corrected;
  let far = 0;
  for (let v = 0; v < source.positions.length / 3; ++v) {
    skinned.getVertexPosition(v, rest).applyMatrix4(skinned.matrixWorld);
    far = Math.max(far, rest.distanceTo(was.fromArray(kept.positions, 3 * v)));
  }
  result.fromLinear = far;

  const box = new THREE.Box3().setFromObject(scene);
  const center = box.getCenter(new THREE.Vector3()), size = box.getSize(new THREE.Vector3());
  camera.position.set(center.x, center.y, center.z + Math.max(size.x, size.y) * 1.9);
  camera.lookAt(center);
  scene.add(new THREE.SkeletonHelper(holder), new THREE.SkeletonHelper(made[0]));
  renderer.render(scene, camera);
  await remote.close();
  return result;
}

run().then(
  (result) => (window.result = result),
  (error) => (window.result = { error: `${error.stack ?? error}` }),
);
