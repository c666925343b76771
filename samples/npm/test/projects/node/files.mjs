// SPDX-License-Identifier: MIT
// Files through @sinew/skin/character, to be compared with the command's: JOBS is a JSON of [{job, files, motion?, options?, save}]; what is
// saved goes to OUT_FOLDER. Prints one line of JSON: an error or "" for each job.
import { readFileSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { load } from "@sinew/skin/character";

const [jobs, out] = [JSON.parse(readFileSync(process.argv[2], "utf8")), process.argv[3]];
const house = await load();
const open = ([first, ...beside]) =>
  house.open(readFileSync(first), basename(first), Object.fromEntries(beside.map((path) => [basename(path), readFileSync(path)])));
const lines = [];
for (const { job, files, motion, options, save } of jobs) {
  try {
    const character = await open(files);
    if (job === "retarget") {
      const other = await open(motion);
      character.retarget(other, options);
      other.close();
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
