// SPDX-License-Identifier: MIT
// Models as the page fetches them, NAME.sinew.packed: planes.js, then gzip. Servers pack scripts, but few pack files of a kind that they do not know.
//   pack_models.mjs OUTPUT_DIR MODEL...
import { readFileSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { gzipSync } from "node:zlib";
import { toPlanes } from "../src/planes.js";

const [out, ...models] = process.argv.slice(2);
for (const model of models) writeFileSync(join(out, `${basename(model)}.packed`), gzipSync(toPlanes(readFileSync(model)), { level: 9 }));
