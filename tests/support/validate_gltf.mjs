// SPDX-License-Identifier: MIT
// Runs the Khronos glTF validator on files: node validate_gltf.mjs FOLDER_WITH_NODE_MODULES FILE... Prints every error and
// warning; exit status 1 when a file has an error, 2 when the validator is not there.
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';

const [folder, ...files] = process.argv.slice(2);
let validator;
try {
  validator = createRequire(join(resolve(folder), 'package.json'))('gltf-validator');
} catch (error) {
  console.error(`gltf-validator is not installed in ${folder}: ${error.message}`);
  process.exit(2);
}

let failed = false;
for (const file of files) {
  const bytes = new Uint8Array(await readFile(file));
  const report = await validator.validateBytes(bytes, {
    uri: file,
    maxIssues: 1000,
    externalResourceFunction: async (uri) => new Uint8Array(await readFile(join(dirname(file), decodeURIComponent(uri)))),
  });
  const { numErrors, numWarnings, numInfos, messages } = report.issues;
  console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos`);
  for (const message of messages.filter((m) => m.severity <= (process.env.SINEW_VALIDATOR_INFOS ? 2 : 1)).slice(0, 20)) {
    console.log(`  ${['error', 'warning', 'info'][message.severity]} ${message.code} at ${message.pointer}: ${message.message}`);
  }
  failed ||= numErrors > 0;
}
process.exit(failed ? 1 : 0);
