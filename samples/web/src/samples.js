// SPDX-License-Identifier: MIT
// The sample characters beside the page.
const pair = (name) => ({ name, files: [`${name}.obj`, `${name}.rig.txt`] });

export const samples = [
  pair("biped__robed"),
  { name: "biped__robed, a bare mesh", files: ["biped__robed.obj"] },
  pair("biped__robot"),
  { name: "biped__caped", files: ["biped__caped.gltf"] },
  pair("bird__winged"),
  pair("many-legged__plated"),
  pair("quadruped__tailed"),
  pair("snake__long"),
];

// The files of one. Throws where the server has them not.
export const sampleFiles = ({ files }) =>
  Promise.all(
    files.map(async (file) => {
      const response = await fetch(`samples/${file}`);
      if (!response.ok) throw new Error(`samples/${file}: ${response.status} ${response.statusText}`);
      return new File([await response.blob()], file);
    }),
  );
