// SPDX-License-Identifier: MIT
// The sample characters beside the page, some with a picture.
/** @typedef {{ name: string, shown?: string, files: string[], clip?: string }} Sample */
/** @type {(name: string, shown?: string, clip?: string) => Sample} */
const pair = (name, shown, clip) => ({ name, shown, files: [`${name}.obj`, `${name}.rig.txt`], clip });
/** @type {(of: string, shown?: string) => Sample} */
const bare = (of, shown) => ({ name: `${of}, a bare mesh`, shown, files: [`${of}.obj`] });

// shown: the caption of its card, which has thumbs/FIRST FILE.webp; clip: what it plays there, a drawing's own where there is none
/** @type {Sample[]} */
export const samples = [
  { name: "biped__clothed", shown: "Person", files: ["biped__clothed.glb"], clip: "builtin:walk" },
  { name: "biped__caped", shown: "Cape", files: ["biped__caped.gltf"], clip: "builtin:run" },
  pair("biped__robot", "Robot", "builtin:wave"),
  pair("quadruped__tailed", "Four legs", "builtin:trot"),
  pair("bird__winged", "Wings", "builtin:flutter"),
  { name: "drawing__child", shown: "A drawing", files: ["drawing__child.png"] },
  pair("many-legged__plated"),
  bare("biped__robed"),
  pair("biped__robed"),
  pair("snake__long"),
];
/** @type {(sample: Sample) => string} */
export const thumbOf = ({ files }) => (files[0].endsWith(".png") ? `samples/${files[0]}` : `thumbs/${files[0].split(".")[0]}.webp`);

/** @type {(sample: Sample) => string} */
export const movingOf = ({ files }) => `${files[0].split(".")[0]}.moving`; // see moving_picture.js

// The files of one. Throws where the server has them not.
/** @type {(sample: Sample) => Promise<File[]>} */
export const sampleFiles = ({ files }) =>
  Promise.all(
    files.map(async (file) => {
      const response = await fetch(`samples/${file}`);
      if (!response.ok) throw new Error(`samples/${file}: ${response.status} ${response.statusText}`);
      return new File([await response.blob()], file);
    }),
  );
