// SPDX-License-Identifier: MIT
// Which of the dropped files make a character together: names alone decide, contents are the module's business.
import { extensionsOf, fileKind } from "../../npm/src/file_kinds.js";

const lower = (name) => name.toLowerCase();
const isOffered = (name, use) => fileKind(name)?.uses.includes(use) === true && fileKind(name).uses.includes("offered");
export const isMesh = (name) => isOffered(name, "readsMesh");
export const isWhole = (name) => isOffered(name, "readsWhole");
export const isRig = (name) => fileKind(name)?.reader === "rig";
export const isModel = (name) => lower(name).endsWith(".sinew");
export const isStyle = (name) => lower(name).endsWith(".style");
export const mayMove = (name) => isOffered(name, "readsMotion") && isMesh(name); // what it is for shows in it
export const isMotion = (name) => isOffered(name, "readsMotion") && !isMesh(name);
export const isBeside = (name) => /\.(bin|png|jpe?g|webp|ktx2|mtl|tga|bmp|tiff?|gif|psd|dds)$/.test(lower(name)); // parts of a .gltf, .obj, .fbx or .dae

export const isPicture = (name) => isOffered(name, "readsPicture"); // a drawing, where it is alone; else a part

// What the page's file dialogs offer.
export const allFiles = [...extensionsOf("offered"), ".txt", ".bin", ".tga", ".sinew", ".style", ".zip", ".sinewproject"].join(",");
export const motionFiles = extensionsOf("readsMotion", "offered").join(",");

export function stem(name) {
  return name.replace(/(\.rig\.txt|\.[^.]*)$/i, "");
}

// names: of the files now dropped. waiting: {mesh, rig} names of earlier files that a skeleton, or a mesh, may still follow:
// a lone .obj is a character without skeleton until then.
// moving: those of the names that could hold a mesh and are motions here.
// Returns {characters: [{name, mesh, skeleton}], model, style, motions, waiting, problems: [one line each]}.
export function pairFiles(names, waiting = {}, moving = []) {
  const none = { characters: [], model: "", style: "", motions: [], waiting: {}, problems: [] };
  const problems = [];
  const others = names.filter((n) => !isMesh(n) && !isRig(n) && !isModel(n) && !isStyle(n) && !isMotion(n) && !isBeside(n));
  for (const name of others) {
    problems.push(`${name}: expected ${extensionsOf("offered").join(", ")}, .sinew or .style, found another kind of file`);
  }
  if (names.length > 0 && names.every(isPicture)) return { ...none, characters: names.map((name) => ({ name: stem(name), mesh: name, skeleton: "" })) };
  const models = names.filter(isModel);
  const styles = names.filter(isStyle);
  const motions = names.filter((name) => isMotion(name) || moving.includes(name));
  const meshes = names.filter((name) => isMesh(name) && !moving.includes(name));
  const rigs = names.filter(isRig);
  if (waiting.mesh && rigs.length > 0 && meshes.length === 0) meshes.push(waiting.mesh);
  if (waiting.rig && meshes.length > 0 && rigs.length === 0) rigs.push(waiting.rig);
  const characters = [];
  const next = {};
  const used = new Set();
  for (const mesh of meshes) {
    const rig = rigs.find((r) => lower(stem(r)) === lower(stem(mesh)));
    if (rig) used.add(rig);
    characters.push({ name: stem(mesh), mesh, skeleton: rig ?? "" });
  }
  const free = rigs.filter((r) => !used.has(r));
  const bare = characters.filter(({ skeleton }) => skeleton === "");
  const lonely = bare.filter(({ mesh }) => fileKind(mesh).reader === "obj");
  if (free.length === 1 && lonely.length === 1) {
    lonely[0].skeleton = free[0]; // one of each: they belong together
  } else if (free.length === 1 && characters.length === 1 && bare.length === 1) {
    bare[0].skeleton = free[0]; // a GLB with a skeleton from elsewhere
  } else {
    for (const rig of free) problems.push(`${rig}: is a skeleton without a mesh; drop its ${stem(rig)}.obj as well`);
    if (lonely.length === 1) next.mesh = lonely[0].mesh;
    if (free.length === 1) next.rig = free[0];
  }
  if (names.length > 0 && problems.length === 0 && characters.length === 0 && models.length + styles.length + motions.length === 0) {
    problems.push(`${names[0]}: holds no mesh; drop an .obj or a .glb`);
  }
  return { characters, model: models[0] ?? "", style: styles[0] ?? "", motions, waiting: next, problems };
}
