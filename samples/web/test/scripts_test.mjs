// SPDX-License-Identifier: MIT
// The scripts of the page and of the npm package by eslint and by TypeScript's checker, strict, with the packages of package-lock.json.
//   scripts_test.mjs
import { spawnSync } from "node:child_process";
import { existsSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const web = join(dirname(fileURLToPath(import.meta.url)), "..");
// Whose parameters have no types yet: all else of `strict` is asked of them, too.
const withoutTypes = [
  ...["clip_list", "editing", "joint_list", "loading", "look", "main", "map_panel", "markers", "methods", "motions"].map((name) => `src/${name}.js`),
  ...["pointer", "pose_panel", "questions", "skeleton", "view"].map((name) => `src/${name}.js`),
  ...["character", "engine", "scenes", "three", "worker"].map((name) => `../npm/src/${name}.js`),
];

// What a program of node_modules prints, line by line.
function lines(folder, program, ...args) {
  const { stdout, stderr, status } = spawnSync(process.execPath, [join(web, "node_modules", program), ...args], { cwd: folder, encoding: "utf8", maxBuffer: 1 << 26 });
  return { said: `${stdout}${stderr}`.split("\n").filter((line) => line.trim() !== ""), failed: status !== 0 };
}

if (!["typescript", "eslint", "globals", "@types/three"].every((name) => existsSync(join(web, "node_modules", name)))) {
  spawnSync("npm", ["ci", "--silent", "--no-audit", "--no-fund", "--prefix", web], { stdio: "inherit" });
}
const faults = [];
const linted = lines(join(web, ".."), "eslint/bin/eslint.js", "--config", "web/eslint.config.js");
if (linted.failed) faults.push(...linted.said);
const checked = lines(web, "typescript/bin/tsc", "-p", "tsconfig.json");
if (checked.failed) faults.push(...checked.said);
const strict = lines(web, "typescript/bin/tsc", "-p", "tsconfig.json", "--noImplicitAny", "true").said.filter((line) => line.includes("error TS"));
const fileOf = (line) => line.split("(")[0];
faults.push(...strict.filter((line) => !withoutTypes.includes(fileOf(line))));
faults.push(...withoutTypes.filter((file) => !strict.some((line) => fileOf(line) === file)).map((file) => `${file}: all of it has types: take it off the list of scripts_test.mjs`));
for (const line of faults) console.error(line);
console.log(`scripts: ${faults.length === 0 ? "ok" : "see above"}; ${withoutTypes.length} files with ${strict.length} parameters without types`);
process.exit(faults.length === 0 ? 0 : 1);
