// SPDX-License-Identifier: MIT
// What commands print with --json is valid under formats/spec/COMMAND.schema.json.
//   node schemas.mjs SINEW SOURCE WORK
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdirSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import Ajv from 'ajv/dist/2020.js';

const [sinew, source, work] = process.argv.slice(2);
const spec = join(source, 'formats/spec'), data = join(source, 'samples/data'), folder = join(work, 'schemas');
rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });

const ajv = new Ajv({ allErrors: true });
const schemas = new Map(readdirSync(spec).filter((name) => name.endsWith('.schema.json'))
  .map((name) => [name.split('.')[0], ajv.compile(JSON.parse(readFileSync(join(spec, name), 'utf8')))]));
const seen = new Set();

// Every line, or the whole where it is laid out over lines.
function documents(text) {
  try {
    return [JSON.parse(text)];
  } catch {
    return text.trim().split('\n').map((line) => JSON.parse(line));
  }
}

function expectValid(command, ...words) {
  const [name] = command.split(' ');
  const program = ['dataset', 'eval'].includes(name) ? `${sinew}-lab` : sinew;
  const text = execFileSync(program, [...command.split(' '), ...words, '--json'], { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] });
  const validate = schemas.get(name);
  for (const document of documents(text))
    assert.ok(validate(document), `sinew ${command} ${words.join(' ')}: ${ajv.errorsText(validate.errors)}\n${JSON.stringify(document).slice(0, 2000)}`);
  seen.add(name);
}

const robot = join(data, 'biped__robot.obj'), robed = join(data, 'biped__robed.obj'), rig = join(data, 'biped__robed.rig.txt');
expectValid('rig', robot, '-o', 'robot.glb');
expectValid('rig', robot, '--skeleton', rig, '-o', 'fitted.glb');
expectValid('rig', join(data, 'drawing__child.png'), '-o', 'child.glb');
expectValid('bind', robed, '--skeleton', rig, '-o', 'robed.glb', '--png', 'robed.png', '--symmetric', '--questions', '3');
expectValid('animate', 'robed.glb', '--motion', 'builtin:walk', '-o', 'walk.glb', '--measure');
expectValid('animate', join(data, 'drawing__child.png'), '-o', 'wave.glb');
expectValid('map', rig, '--from', 'robot.glb');
expectValid('map', rig, '--from', join(data, 'quadruped__tailed.rig.txt'));
expectValid('transfer', 'robed.glb', robot, '-o', 'other.glb');
expectValid('simplify', 'robed.glb', '--level', 'low', '-o', 'low.glb');
expectValid('springs', 'robed.glb', '-o', 'swings.glb');
expectValid('animate', 'swings.glb', '--motion', 'builtin:run', '--springs', '-o', 'swinging.glb');
expectValid('animate', 'robed.glb', '--motion', 'builtin:walk', '--vat', 'crowd');
expectValid('bake', 'robed.glb', '-o', 'baked.glb', '--poses', '20', '--shapes', '2');
expectValid('check', 'robed.glb', 'robot.glb');
expectValid('lod', 'robed.glb', '--levels', '2');
expectValid('inspect', 'robed.glb');
expectValid('inspect', robot);
expectValid('inspect', rig);
expectValid('inspect', 'bundled');
expectValid('inspect', join(data, 'sinew_default.ckpt'));
mkdirSync(join(folder, 'set'), { recursive: true });
for (const name of ['biped__robed', 'snake__long']) for (const end of ['.obj', '.rig.txt']) copyFileSync(join(data, name + end), join(folder, 'set', name + end));
expectValid('dataset check', 'set');
expectValid('dataset stats', 'set');
expectValid('dataset stats', 'set', '--no-recall');
for (const end of ['.obj', '.rig.txt']) copyFileSync(join(data, 'biped__robed' + end), join(folder, 'set', 'biped__copy' + end));
expectValid('dataset dedup', 'set');
expectValid('eval', 'set', '--method', 'nearest');
expectValid('eval rig', 'set', '--predictions', 'set');
expectValid('eval hands', 'set');
// What --controls writes.
execFileSync(sinew, ['bind', robed, '--skeleton', rig, '-o', 'controlled.glb', '--controls', 'robed.controls.json'], { cwd: folder, stdio: 'ignore' });
const controls = schemas.get('controls');
assert.ok(controls(JSON.parse(readFileSync(join(folder, 'robed.controls.json'), 'utf8'))), `controls: ${ajv.errorsText(controls.errors)}`);
seen.add('controls');
const layout = schemas.get('vat');
assert.ok(layout(JSON.parse(readFileSync(join(folder, 'crowd/robed.vat.json'), 'utf8'))), `vat: ${ajv.errorsText(layout.errors)}`);
seen.add('vat');
assert.deepEqual([...seen].sort(), [...schemas.keys()].sort(), 'a run for every schema');
for (const [name, validate] of schemas) assert.ok(!validate({ [`sinew_${name}`]: 2 }), `${name}: another version is refused`);
console.log('SCHEMAS OK');
