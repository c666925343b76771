// SPDX-License-Identifier: MIT
// Files through @sinew/skin/character, to be compared with the command's: JOBS is a JSON of [{job, files, picture?, motion?, options?, save}]; what is
// saved goes to OUT_FOLDER. Prints one line of JSON: an error or "" for each job.
import { readFileSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { load } from "@sinew/skin/character";

const [jobs, out] = [JSON.parse(readFileSync(process.argv[2], "utf8")), process.argv[3]];
const house = await load();
const open = ([first, ...beside], picture) =>
  house.open(readFileSync(first), basename(first), Object.fromEntries(beside.map((path) => [basename(path), readFileSync(path)])), picture);
const lines = [];
for (const { job, files, picture, motion, options, save } of jobs) {
  try {
    const character = await open(files, picture);
    if (job === "retarget") {
      const other = motion ? await open(motion) : null;
      character.retarget(other, options);
      other?.close();
      if (picture && character.picture.bodyClass !== picture.bodyClass) throw new Error(`${basename(files[0])}: ${character.picture.bodyClass}`);
    } else {
      character[job](options);
    }
    for (const { name, bytes } of character.files(save)) writeFileSync(join(out, basename(name)), bytes);
    character.close();
    lines.push("");
  } catch (error) {
    lines.push(`${error.name} ${error.status}: ${error.message}`);
  }
}
// A person that stands, as keypoints alone, then one that has moved aside.
const keypoints = Float32Array.from([0, 0.95, 0, 0.1, 0.9, 0, -0.1, 0.9, 0, 0, 1.05, 0, 0.1, 0.5, 0, -0.1, 0.5, 0, 0, 1.2, 0, 0.1, 0.1, 0, -0.1, 0.1, 0, 0, 1.3, 0, 0.1, 0.02, 0.1, -0.1, 0.02, 0.1, 0, 1.5, 0, 0.06, 1.4, 0,
  -0.06, 1.4, 0, 0, 1.6, 0, 0.2, 1.4, 0, -0.2, 1.4, 0, 0.5, 1.4, 0, -0.5, 1.4, 0, 0.75, 1.4, 0, -0.75, 1.4, 0]);
const person = house.openKeypoints("humanml3d22", [keypoints]);
const still = person.keypointsFrame(keypoints).rotations;
const { rotations, translations } = person.keypointsFrame(keypoints.map((x, i) => (i % 3 === 0 ? x + 1 : x)));
const errors = [() => person.keypointsFrame(keypoints.slice(3)), () => house.openKeypoints("h36m", [keypoints]), () => house.openKeypoints("humanml3d22", [])].map((call) => {
  try {
    call();
    return "";
  } catch ({ message }) {
    return message;
  }
});
lines.push({ joints: person.view().skeleton.names.length, rotations: rotations.length, aside: Math.round(1e4 * translations[0]) / 1e4, turned: rotations.some((x, i) => Math.abs(x - still[i]) > 1e-5), errors });
person.close();
console.log(JSON.stringify(lines));
