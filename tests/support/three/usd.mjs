// SPDX-License-Identifier: MIT
// .usda and .usdz of the command, opened by three's USDLoader: the bones, and the same surface as the GLB at rest and in a clip.
//   node usd.mjs SINEW SOURCE WORK
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { USDLoader } from 'three/addons/loaders/USDLoader.js';
import { bytesOf, farthest, openGltf, skinnedMeshes, skinnedPositions } from './characters.mjs';

const [sinew, source, work] = process.argv.slice(2);
mkdirSync(work, { recursive: true });
const run = (...words) => execFileSync(sinew, words, { cwd: work, stdio: ['ignore', 'ignore', 'inherit'] });
const data = join(source, 'samples/data');
run('bind', join(data, 'biped__robed.obj'), '--skeleton', join(data, 'biped__robed.rig.txt'), '-o', 'still.glb');
run('bind', join(data, 'biped__robed.obj'), '--skeleton', join(data, 'biped__robed.rig.txt'), '-o', 'still.usda');
run('animate', 'still.glb', '--motion', 'builtin:walk', '-o', 'walk.glb');
run('animate', 'still.glb', '--motion', 'builtin:walk', '-o', 'walk.usdz');

for (const [usd, glb] of [['still.usda', 'still.glb'], ['walk.usdz', 'walk.glb']]) {
  const theirs = new USDLoader().parse(bytesOf(join(work, usd))), gltf = await openGltf(join(work, glb));
  const bones = skinnedMeshes(theirs)[0].skeleton.bones;
  assert.equal(bones.length, skinnedMeshes(gltf.scene)[0].skeleton.bones.length);
  for (const seconds of gltf.animations.length ? [0, 0.25, 0.6] : [undefined]) {
    const a = skinnedPositions(theirs, theirs.animations[0], seconds), b = skinnedPositions(gltf.scene, gltf.animations[0], seconds);
    const apart = Math.max(farthest(a, b), farthest(b, a));
    console.log(`${usd}: ${bones.length} bones, ${a.length} vertices, ${seconds === undefined ? 'at rest' : `at ${seconds} s`} at most ${apart.toExponential(1)} m apart`);
    assert.ok(apart < 1e-4, `${usd} is ${apart} m from ${glb}`);
  }
}
