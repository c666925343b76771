// SPDX-License-Identifier: MIT
// `sinew serve --mcp` by the protocol's own client: tools, a rig with progress, a picture, a refusal, resources, a cancelled call.
//   node client.mjs SINEW SOURCE WORK
import assert from 'node:assert/strict';
import { copyFileSync, mkdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { Client } from '@modelcontextprotocol/sdk/client/index.js';
import { StdioClientTransport } from '@modelcontextprotocol/sdk/client/stdio.js';

const [sinew, source, work] = process.argv.slice(2);
const folder = join(work, 'served');
rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });
copyFileSync(join(source, 'samples/data/biped__robot.obj'), join(folder, 'mesh.obj'));

const client = new Client({ name: 'sinew-test', version: '1' });
await client.connect(new StdioClientTransport({ command: sinew, args: ['serve', '--mcp', '--folder', folder] }));
assert.equal(client.getServerVersion().name, 'sinew');

const { tools } = await client.listTools();
assert.deepEqual(tools.map((tool) => tool.name), ['rig', 'bind', 'animate', 'springs', 'transfer', 'map', 'check', 'lod', 'simplify', 'bake', 'pose', 'inspect']);

let told = 0;
const rigged = await client.callTool({ name: 'rig', arguments: { mesh: 'mesh.obj', output: 'rigged.glb' } }, undefined, { onprogress: () => ++told });
assert.ok(!rigged.isError, JSON.stringify(rigged));
assert.ok(rigged.structuredContent.joints.length > 5);
assert.ok(told > 0, 'progress is told');

const posed = await client.callTool({ name: 'pose', arguments: { character: 'rigged.glb', output: 'pose.png', random: 3 } });
assert.ok(posed.content.some((part) => part.type === 'image' && part.mimeType === 'image/png'));

const refused = await client.callTool({ name: 'rig', arguments: { mesh: '../mesh.obj', output: 'other.glb' } });
assert.ok(refused.isError && refused.content[0].text.includes('..'));

const { resources } = await client.listResources();
assert.deepEqual(resources.map((one) => one.name), ['mesh.obj', 'pose.png', 'rigged.glb']);
const read = await client.readResource({ uri: resources[2].uri });
assert.equal(Buffer.from(read.contents[0].blob, 'base64').subarray(0, 4).toString(), 'glTF');
await assert.rejects(client.readResource({ uri: 'sinew:///none.glb' }), /no such file/);

const abort = new AbortController();
const cancelled = client.callTool({ name: 'rig', arguments: { mesh: 'mesh.obj', output: 'late.glb' } }, undefined, { signal: abort.signal });
abort.abort('enough');
await assert.rejects(cancelled);
assert.deepEqual(await client.ping(), {});
await client.close();
console.log('MCP OK');
