// SPDX-License-Identifier: MIT
// Writes which functions of the page's module open a character, make it a skeleton where it has none (`bare`; else those are opened alone), and bind it. `wasm-split` keeps these in the
// part that it makes first (split.sh).
//   first_bind.mjs skinned|bare GLUE.mjs INSTRUMENTED.wasm SAMPLES_DIR PROFILE
import { readFileSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const withBare = process.argv[2] === "bare";
const [glue, instrumented, samples, profile] = process.argv.slice(3).map((path) => resolve(path));
// What emscripten's glue asks of a worker.
Object.assign(globalThis, { self: globalThis, importScripts: () => {}, location: { href: "file:///" } });
const { default: make } = await import(pathToFileURL(glue));
const bytes = readFileSync(instrumented);
let exported;
const module = await make({
  instantiateWasm(imports, done) {
    const elsewhere = (_, place) => () => {
      throw new Error(`function ${String(place)} is in a part of the module that is not there`);
    };
    WebAssembly.instantiate(bytes, { ...imports, placeholder: new Proxy({}, { get: elsewhere }) }).then(({ instance, module: compiled }) => ((exported = instance.exports), done(instance, compiled)));
    return {};
  },
  onProgress: () => {},
  print: () => {},
  printErr: () => {},
});

function textAt(value) {
  const size = module.lengthBytesUTF8(value) + 1;
  const at = module._malloc(size);
  module.stringToUTF8(value, at, size);
  return at;
}
function call(name, ...args) {
  const given = args.map((one) => (typeof one === "string" ? textAt(one) : one));
  const reply = JSON.parse(module.UTF8ToString(module[`_web_${name}`](...given)));
  args.forEach((one, i) => typeof one === "string" && module._free(given[i]));
  if (reply.error) throw new Error(`${name}: ${reply.error}`);
}
const give = (name) => module.FS.writeFile(name, readFileSync(join(samples, name)));
const buffers = () => [...Array(9).keys()].forEach((kind) => module._web_buffer(kind, size));
const bind = (wish = {}) => call("bind", JSON.stringify({ method: 0, upAxis: 0, symmetric: false, rigidParts: 0, softness: 1, influences: 4, never: [], always: [], toPose: "", ...wish }), "[]");

const size = module._malloc(4);
module._web_kernel();
module._web_version();
for (const name of ["sinew_default.sinew", ...(withBare ? ["sinew_rig.sinew", "sinew_front.sinew"] : [])]) {
  give(name);
  call("model", name);
}
const bare = [["biped__robot.obj", ""], ["quadruped__tailed.obj", ""]];
const characters = [["biped__caped.gltf", ""], ["biped__robed.obj", "biped__robed.rig.txt"], ...bare];
for (const [number, [mesh, skeleton]] of characters.entries()) {
  for (const name of [mesh, skeleton]) if (name) give(name);
  call("load", mesh, skeleton, number, JSON.stringify({ turns: [], height: 0, floor: false, up: 0 })); // all as the page writes it
  const isBare = mesh.endsWith(".obj") && skeleton === "";
  buffers();
  if (isBare && !withBare) continue; // opened alone
  if (isBare) call("rig", JSON.stringify({ up: 2, category: 0, front: 0, mirror: 0, spine: 0, toes: true, ends: true, detail: 0, at: [], alike: true }));
  buffers();
  bind();
  buffers();
  module._web_keep(number);
  module._web_drop(number);
  module._web_forget(100);
}
const length = exported.__write_profile(0, 0);
const at = module._malloc(length);
exported.__write_profile(at, length);
writeFileSync(profile, module.HEAPU8.slice(at, at + length));
