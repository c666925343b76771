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
console.log(JSON.stringify(lines));
