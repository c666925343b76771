// SPDX-License-Identifier: MIT
// Which of the dropped files make a character together: names alone decide, contents are the module's business.
import { extensionsOf, fileKind } from "../../npm/src/file_kinds.js";

/** @type {(name: string) => string} */
const lower = (name) => name.toLowerCase();
/** @type {(name: string, use: string) => boolean} */
const isOffered = (name, use) => {
  const uses = fileKind(name)?.uses ?? [];
  return uses.includes(use) && uses.includes("offered");
};
/** @type {(name: string) => boolean} */
export const isMesh = (name) => isOffered(name, "readsMesh");
/** @type {(name: string) => boolean} */
export const isWhole = (name) => isOffered(name, "readsWhole");
/** @type {(name: string) => boolean} */
export const isRig = (name) => fileKind(name)?.reader === "rig";
/** @type {(name: string) => boolean} */
export const isModel = (name) => lower(name).endsWith(".sinew");
/** @type {(name: string) => boolean} */
export const isStyle = (name) => lower(name).endsWith(".style");
/** @type {(name: string) => boolean} */
export const mayMove = (name) => isOffered(name, "readsMotion") && isMesh(name); // what it is for shows in it
/** @type {(name: string) => boolean} */
export const isMotion = (name) => isOffered(name, "readsMotion") && !isMesh(name);
/** @type {(name: string) => boolean} */
export const isBeside = (name) => /\.(bin|png|jpe?g|webp|ktx2|mtl|tga|bmp|tiff?|gif|psd|dds)$/.test(lower(name)); // parts of a .gltf, .obj, .fbx or .dae

/** @type {(name: string) => boolean} */
export const isPicture = (name) => isOffered(name, "readsPicture"); // a drawing, where it is alone; else a part

// What the page's file dialogs offer.
export const allFiles = [...extensionsOf("offered"), ".txt", ".bin", ".tga", ".sinew", ".style", ".zip", ".sinewproject"].join(",");
export const motionFiles = extensionsOf("readsMotion", "offered").join(",");
export const pictureFiles = extensionsOf("readsPicture", "offered").join(",");

/** @param {string} name */
export function stem(name) {
  return name.replace(/(\.rig\.txt|\.[^.]*)$/i, "");
}

/** @typedef {{ mesh?: string, rig?: string }} Waiting */

// names: of the files now dropped. waiting: {mesh, rig} names of earlier files that a skeleton, or a mesh, may still follow:
// a lone .obj is a character without skeleton until then.
// moving: those of the names that could hold a mesh and are motions here.
// Returns {characters: [{name, mesh, skeleton}], model, style, motions, waiting, problems: [one line each]}.
/**
 * @param {string[]} names
 * @param {Waiting} waiting
 * @param {string[]} moving
 */
export function pairFiles(names, waiting = {}, moving = []) {
  /** @type {{ characters: { name: string, mesh: string, skeleton: string }[], model: string, style: string, motions: string[], waiting: Waiting, problems: string[] }} */
  const none = { characters: [], model: "", style: "", motions: [], waiting: {}, problems: [] };
  const problems = [];
  const others = names.filter((n) => !isMesh(n) && !isRig(n) && !isModel(n) && !isStyle(n) && !isMotion(n) && !isBeside(n));
  for (const name of others) {
    const kind = fileKind(name);
    if (kind?.reader === "none") {
      problems.push(`${name}: this is ${kind.name}, which sinew writes but does not read: export glTF or FBX`);
      continue;
    }
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
  /** @type {Waiting} */
  const next = {};
  const used = new Set();
  for (const mesh of meshes) {
    const rig = rigs.find((r) => lower(stem(r)) === lower(stem(mesh)));
    if (rig) used.add(rig);
    characters.push({ name: stem(mesh), mesh, skeleton: rig ?? "" });
  }
  const free = rigs.filter((r) => !used.has(r));
  const bare = characters.filter(({ skeleton }) => skeleton === "");
  const lonely = bare.filter(({ mesh }) => fileKind(mesh)?.reader === "obj");
  if (free.length === 1 && lonely.length === 1) {
    lonely[0].skeleton = free[0]; // one of each: they belong together
  } else if (free.length === 1 && characters.length === 1 && bare.length === 1) {
    bare[0].skeleton = free[0]; // a GLB with a skeleton from elsewhere
  } else {
    for (const rig of free) problems.push(`${rig} is a skeleton without a mesh: drop ${stem(rig)}.obj as well`);
    if (lonely.length === 1) next.mesh = lonely[0].mesh;
    if (free.length === 1) next.rig = free[0];
  }
  if (names.length > 0 && problems.length === 0 && characters.length === 0 && models.length + styles.length + motions.length === 0) {
    problems.push(`${names[0]} contains no mesh: drop an .obj or a .glb`);
  }
  return { characters, model: models[0] ?? "", style: styles[0] ?? "", motions, waiting: next, problems };
}
