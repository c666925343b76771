// SPDX-License-Identifier: MIT
// Springs of `sinew springs`, baked by `sinew animate --springs`, beside the same file in @pixiv/three-vrm-springbone, which plays them live. That
// one measures a bone's length to where its child was before the bone above it turned, so that lengths vary in fast motion; the
// specification's are constant. It is compared as it is and with constant lengths.
//   node springs.mjs SINEW SOURCE WORK
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { VRMSpringBoneLoaderPlugin } from '@pixiv/three-vrm';
import { AnimationMixer, Vector3 } from 'three';
import { openGltf } from './characters.mjs';

const [sinew, source, work] = process.argv.slice(2);
mkdirSync(work, { recursive: true });
const run = (...words) => execFileSync(sinew, words, { cwd: work, stdio: ['ignore', 'ignore', 'inherit'] });
const fps = 60, frames = 300, warmUp = 4;

const play = (gltf) => {
  const mixer = new AnimationMixer(gltf.scene), clip = gltf.animations[0];
  mixer.clipAction(clip).play();
  return { ...gltf, mixer, count: Math.round(clip.duration * fps) };
};
const pose = (one, frame) => {
  one.mixer.setTime(Math.min(frame / fps, one.animations[0].duration - 1e-9));
  one.scene.updateMatrixWorld(true);
};
const positionOf = (node) => node.getWorldPosition(new Vector3());
const keepLength = (joint) => {
  joint._calcWorldSpaceBoneLength = () => {
    const end = joint.child.position.clone().applyMatrix4(joint.bone.matrixWorld);
    joint._worldSpaceBoneLength = end.distanceTo(new Vector3().setFromMatrixPosition(joint.bone.matrixWorld));
  };
};

/** Largest distance of a joint as a share of the chains' length, and how far joints swing in degrees, in the frames of a loop's later rounds. */
const compare = async (file, constant) => {
  const baked = play(await openGltf(file));
  const live = play(await openGltf(file, (parser) => new VRMSpringBoneLoaderPlugin(parser)));
  const manager = live.userData.vrmSpringBoneManager, joints = [...manager.joints];
  if (constant) joints.forEach(keepLength);
  const rests = new Map(joints.map(({ bone }) => [bone, bone.quaternion.clone()]));
  const [ours, theirs] = await Promise.all([baked, live].map((gltf) => gltf.parser.getDependencies('node')));
  const root = ours.find((node) => node.isBone && !node.parent?.isBone);
  pose(baked, 0);
  const first = positionOf(root);
  pose(baked, baked.count);
  const travel = positionOf(root).sub(first);
  pose(live, 0);
  manager.reset();
  let largest = 0, swing = 0, compared = 0;
  for (let round = 0; compared < frames; ++round)
    for (let frame = 1; frame <= baked.count && compared < frames; ++frame) {
      live.scene.position.copy(travel).multiplyScalar(round);
      pose(live, frame);
      manager.update(1 / fps);
      if (round < warmUp) continue;
      ++compared;
      pose(baked, frame);
      for (const { bone, child } of joints) {
        largest = Math.max(largest, positionOf(ours[theirs.indexOf(child)]).distanceTo(positionOf(child).sub(live.scene.position)));
        swing = Math.max(swing, bone.quaternion.angleTo(rests.get(bone)));
      }
    }
  const length = joints.reduce((sum, joint) => sum + joint.initialLocalChildPosition.length(), 0);
  return { largest: largest / length, swing: (swing * 180) / Math.PI, joints: joints.length, colliders: manager.colliders.length };
};

// Clips are of people: nothing in them moves a tail, so that its goal is its rest pose here and there.
for (const [character, motion, options] of [
  ['biped__robed.obj', 'jump', []],
  ['biped__robed.obj', 'run', []],
  ['biped__robed.obj', 'run', ['--value', '*:stiffness=0.6', '--value', '*:gravity=0.5', '--value', '*:drag=0.2']],
  ['biped__caped.gltf', 'jump', ['--value', '*:radius=0.03']],
]) {
  const name = `${character.split('.')[0]}_${motion}_${options.length}`, file = join(work, `${name}.glb`);
  run('springs', join(source, 'samples/data', character), ...options, '-o', `${name}.springs.glb`);
  run('animate', `${name}.springs.glb`, '--motion', `builtin:${motion}`, '--springs', '--fps', `${fps}`, '-o', file);
  const exact = await compare(file, true), shipped = await compare(file, false);
  const percent = (share) => `${(100 * share).toFixed(4)} %`;
  console.log(`${name}: ${exact.joints} joints, ${exact.colliders} colliders, swing up to ${exact.swing.toFixed(1)} degrees; largest difference in ` +
    `${frames} frames ${percent(exact.largest)} of the chains with constant lengths, ${percent(shipped.largest)} as it is`);
  assert.ok(exact.joints >= 3 && exact.colliders >= 10 && exact.swing > 5, `${name}: too little to compare`);
  assert.ok(exact.largest <= 0.001, `${name}: differs from the specification's lengths`);
  assert.ok(shipped.largest <= 0.05, `${name}: differs`);
}
