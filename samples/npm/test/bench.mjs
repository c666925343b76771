// SPDX-License-Identifier: MIT
// Time of a bind in node beside the command's, at about 1,000 and 10,000 vertices, one thread each: medians, spread, hash and ratio
// as CSV. A ratio at once wrong in its hash is marked.
//   bench.mjs BUILT_FOLDER COMMAND [RUNS]
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { bindHash, readObj, readRig } from "./characters.mjs";

const [built, command, runs = "7"] = process.argv.slice(2);
const entry = (name) => import(pathToFileURL(resolve(built, "package/src", name)));
const [{ load }, { loadModel }] = [await entry("index.js"), await entry("model.js")];
const model = await loadModel();
const folder = mkdtempSync(join(tmpdir(), "sinew-npm-bench-"));
const median = (values) => values.sort((a, b) => a - b)[values.length >> 1];
const run = (program, args) => execFileSync(resolve(program), args, { encoding: "utf8", maxBuffer: 1 << 26 });
const sinew = (...args) => run(command, args);

try {
  console.log("vertices,engine,median_ms,least_ms,most_ms,hash,ratio");
  for (const resolution of [28, 75]) {
    const file = join(folder, `body${resolution}.obj`), rig = file.replace(".obj", ".rig.txt");
    run(`${command}-lab`, ["dataset", "synthesize", "--plan", "biped", "--seed", "27", "--resolution", String(resolution), "-o", file]);
    const mesh = readObj(readFileSync(file, "utf8")), { skeleton } = readRig(readFileSync(rig, "utf8"));
    const timed = (name, bind) => {
      const times = [];
      let hash;
      for (let i = 0; i < Number(runs); ++i) {
        const { seconds, hash: one } = bind();
        times.push(seconds * 1000);
        hash = one;
      }
      return { name, ms: median(times), least: times[0], most: times.at(-1), hash };
    };
    const json = () => JSON.parse(sinew("bind", file, "--skeleton", rig, "--joints", "names", "--threads", "1", "--json", "-o", join(folder, "out.glb")));
    const rows = [timed("command", json)];
    for (const scalar of [false, true]) {
      const skin = await load({ model, scalar });
      rows.push(
        timed(`node ${skin.kernel}`, () => {
          const bound = skin.bind(mesh, skeleton, { format: "unorm16" });
          return { seconds: bound.seconds, hash: bindHash(bound) };
        }),
      );
    }
    for (const { name, ms, least, most, hash } of rows) {
      const ratio = hash === rows[0].hash ? (ms / rows[0].ms).toFixed(2) : "WRONG HASH";
      console.log([mesh.positions.length / 3, name, ms.toFixed(1), least.toFixed(1), most.toFixed(1), hash, ratio].join(","));
    }
  }
} finally {
  rmSync(folder, { recursive: true });
}
