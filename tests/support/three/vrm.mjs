// SPDX-License-Identifier: MIT
// Files of `--for vrm` and `--for vrm0`, opened by @pixiv/three-vrm: humanoid bones, the first-person camera's head, and a .vrma that plays.
//   node vrm.mjs SINEW SOURCE WORK
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { VRMHumanBoneList, VRMLoaderPlugin, VRMRequiredHumanBoneName } from '@pixiv/three-vrm';
import { VRMAnimationLoaderPlugin, createVRMAnimationClip } from '@pixiv/three-vrm-animation';
import { AnimationMixer, Vector3 } from 'three';
import { openGltf } from './characters.mjs';

const [sinew, source, work] = process.argv.slice(2);
mkdirSync(work, { recursive: true });
const run = (...words) => execFileSync(sinew, words, { cwd: work, stdio: ['ignore', 'ignore', 'inherit'] });
const data = join(source, 'samples/data');
const bind = (profile, file) =>
  run('bind', join(data, 'biped__robed.obj'), '--skeleton', join(data, 'biped__robed.rig.txt'), '--for', profile, '--author', 'Ann', '-o', file);
const openVrm = async (file) => (await openGltf(join(work, file), (parser) => new VRMLoaderPlugin(parser))).userData.vrm;

/** A .vrma whose left upper arm turns by 90 degrees about z in a second: its skeleton and its humanoid map. */
const writeAnimation = (file) => {
  const floats = new Float32Array([0, 1, 0, 0, 0, 1, 0, 0, -Math.SQRT1_2, Math.SQRT1_2]);
  const names = ['hips', 'spine', 'leftUpperArm'];
  const json = {
    asset: { version: '2.0' },
    extensionsUsed: ['VRMC_vrm_animation'],
    extensions: { VRMC_vrm_animation: { specVersion: '1.0', humanoid: { humanBones: Object.fromEntries(names.map((name, node) => [name, { node }])) } } },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: names.map((name, i) => ({ name, translation: [0, i === 0 ? 1 : 0.2, 0], ...(i < 2 ? { children: [i + 1] } : {}) })),
    buffers: [{ byteLength: floats.byteLength }],
    bufferViews: [{ buffer: 0, byteLength: 8 }, { buffer: 0, byteOffset: 8, byteLength: 32 }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 2, type: 'SCALAR', min: [0], max: [1] },
      { bufferView: 1, componentType: 5126, count: 2, type: 'VEC4' },
    ],
    animations: [{ name: 'raise', channels: [{ sampler: 0, target: { node: 2, path: 'rotation' } }], samplers: [{ input: 0, output: 1 }] }],
  };
  const text = Buffer.from(JSON.stringify(json)), padded = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, ' ')]);
  const words = (...numbers) => Buffer.from(Uint32Array.from(numbers).buffer);
  const chunks = [words(padded.length, 0x4e4f534a), padded, words(floats.byteLength, 0x004e4942), Buffer.from(floats.buffer)];
  writeFileSync(join(work, file), Buffer.concat([words(0x46546c67, 2, 12 + Buffer.concat(chunks).length), ...chunks]));
};

writeAnimation('raise.vrma');
const animations = (await openGltf(join(work, 'raise.vrma'), (parser) => new VRMAnimationLoaderPlugin(parser))).userData.vrmAnimations;
for (const [profile, file, version] of [['vrm', 'one.vrm', '1'], ['vrm0', 'zero.vrm', '0']]) {
  bind(profile, file);
  const vrm = await openVrm(file);
  assert.equal(vrm.meta.metaVersion, version);
  assert.deepEqual(version === '1' ? vrm.meta.authors : [vrm.meta.author], ['Ann']);
  for (const name of Object.values(VRMRequiredHumanBoneName)) assert.ok(vrm.humanoid.getRawBoneNode(name), `${file} has no ${name}`);
  const bones = VRMHumanBoneList.filter((name) => vrm.humanoid.getRawBoneNode(name));

  const clip = createVRMAnimationClip(animations[0], vrm), mixer = new AnimationMixer(vrm.scene);
  const elbow = vrm.humanoid.getRawBoneNode('leftLowerArm'), before = new Vector3(), after = new Vector3();
  vrm.scene.updateMatrixWorld(true);
  elbow.getWorldPosition(before);
  mixer.clipAction(clip).play();
  mixer.setTime(1 - 1e-6);
  vrm.update(0);
  vrm.scene.updateMatrixWorld(true);
  elbow.getWorldPosition(after);
  const shoulder = vrm.humanoid.getRawBoneNode('leftUpperArm').getWorldPosition(new Vector3());
  console.log(`${file}: ${bones.length} humanoid bones; the elbow goes from ${before.toArray().map((x) => x.toFixed(3))} to ${after.toArray().map((x) => x.toFixed(3))}`);
  const arm = before.distanceTo(shoulder);
  // -90 degrees about z takes an arm that points along +x (VRM 1.0's left) down.
  assert.ok(Math.abs(Math.abs(after.x - shoulder.x)) < 0.05 * arm && shoulder.y - after.y > 0.95 * arm, `${file}: the arm does not hang`);
}

// Clips alone, of a character that stands in another pose, played on a VRM: its limbs point where the character's do.
run('bind', join(data, 'biped__robed.obj'), '--skeleton', join(data, 'biped__robed.rig.txt'), '-o', 'hero.glb');
for (const output of ['walk.glb', 'walk.vrma']) run('animate', 'hero.glb', '--motion', 'builtin:walk', '--fps', '30', '-o', output);
const hero = await openGltf(join(work, 'walk.glb')), walker = await openVrm('one.vrm');
const [walk] = (await openGltf(join(work, 'walk.vrma'), (parser) => new VRMAnimationLoaderPlugin(parser))).userData.vrmAnimations;
const heroMixer = new AnimationMixer(hero.scene), walkMixer = new AnimationMixer(walker.scene);
heroMixer.clipAction(hero.animations[0]).play();
walkMixer.clipAction(createVRMAnimationClip(walk, walker)).play();
const direction = (from, to) => to.getWorldPosition(new Vector3()).sub(from.getWorldPosition(new Vector3())).normalize();
let worst = 0;
for (let frame = 0; frame < 30; frame += 3) {
  for (const mixer of [heroMixer, walkMixer]) mixer.setTime(frame / 30 + 1e-6);
  walker.update(0);
  for (const scene of [hero.scene, walker.scene]) scene.updateMatrixWorld(true);
  for (const side of ['left', 'right'])
    for (const [bone, next, joint, below] of [['UpperArm', 'LowerArm', 'upper_arm', 'forearm'], ['LowerArm', 'Hand', 'forearm', 'hand'],
      ['UpperLeg', 'LowerLeg', 'thigh', 'shin'], ['LowerLeg', 'Foot', 'shin', 'foot']]) {
      const end = side === 'left' ? '.L' : '.R', own = (name) => hero.scene.getObjectByName(`${name}${end}`.replace('.', ''));
      const there = direction(walker.humanoid.getRawBoneNode(side + bone), walker.humanoid.getRawBoneNode(side + next));
      worst = Math.max(worst, direction(own(joint), own(below)).angleTo(there));
    }
}
console.log(`walk.vrma: limbs of the VRM point where the character's do within ${((worst * 180) / Math.PI).toFixed(2)} degrees`);
assert.ok(worst < 0.05, 'walk.vrma plays otherwise than the character');
