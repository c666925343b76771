// SPDX-License-Identifier: MIT
// FBX and COLLADA by the module of wasm/scenes: Assimp, as the command has it. It is started when the first such file is there.
import { fileKind } from "./file_kinds.js";

export const isScene = (name) => fileKind(name)?.reader === "scene" && fileKind(name)?.uses.includes("offered") === true;
// Image types that users drop; the reader warns of those that glTF cannot store.
const isPicture = (name) => /\.(png|jpe?g|webp|tga|bmp|tiff?|gif|psd|dds|ktx2?|exr|hdr)$/i.test(name);

/**
 * Gives `module`, which has the files, its way of reading scenes.
 * @param {object} module of emscripten, with FS
 * @param {(options: object) => Promise<object>} scenes what the script of the other module exports
 * @param {WebAssembly.Module} compiled the other module
 */
export async function readScenesBy(module, scenes, compiled) {
  const reader = await scenes({
    instantiateWasm(imports, done) {
      WebAssembly.instantiate(compiled, imports).then((instance) => done(instance, compiled));
      return {};
    },
    print: () => {},
    printErr: () => {},
  });
  let last = { key: "" };
  // Files lie in both modules under the same names, so that lines about them are the command's.
  const convert = (path) => {
    const at = path.lastIndexOf("/") + 1;
    const folder = module.FS.cwd() + (at > 0 ? `/${path.slice(0, at - 1)}` : "");
    const inside = at > 0 ? path.slice(0, at) : "";
    reader.FS.mkdirTree(`/files/${inside}`);
    reader.FS.chdir("/files");
    const names = module.FS.readdir(folder).filter((name) => name === path.slice(at) || isPicture(name));
    for (const name of names) reader.FS.writeFile(inside + name, module.FS.readFile(inside + name));
    try {
      const said = reader.ccall("scenes_convert", "string", ["string", "string"], [path, "/scene.glb"]);
      const glb = said.startsWith('{"error"') ? null : reader.FS.readFile("/scene.glb");
      return { said, glb };
    } finally {
      for (const name of [...names.map((one) => inside + one), "/scene.glb"]) if (reader.FS.analyzePath(name).exists) reader.FS.unlink(name);
    }
  };
  module.readScene = (path, glb) => {
    const { size, mtime } = module.FS.stat(path);
    const beside = module.FS.readdir(module.FS.cwd()).filter(isPicture).join("/");
    const key = `${path} ${size} ${Number(mtime)} ${beside}`; // a character, its motion and its body are read one after another
    if (last.key !== key) last = { key, ...convert(path) };
    if (last.glb) module.FS.writeFile(glb, last.glb);
    return last.said;
  };
}
