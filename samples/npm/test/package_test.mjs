// SPDX-License-Identifier: MIT
// The tarball in fresh projects: node, TypeScript, esbuild, webpack and Vite with three.js in a headless Chromium, none of them told about
// modules of node's. Weights are the command's.
//   package_test.mjs BUILT_FOLDER REPOSITORY WORK_FOLDER COMMAND
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync, symlinkSync, writeFileSync } from "node:fs";
import { basename, dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { bindHash, readObj, readRig } from "./characters.mjs";
import { strangeFiles } from "./strange_files.mjs";

const [built, root, work, command] = process.argv.slice(2).map((path) => resolve(path));
const here = dirname(fileURLToPath(import.meta.url)), tools = resolve(here, "../node_modules");
const data = join(root, "samples/data");
const samples = ["quadruped__tailed", "biped__robed", "biped__robot", "bird__winged", "many-legged__plated", "snake__long"];
const tarball = join(built, readdirSync(built).find((name) => name.endsWith(".tgz")));
let count = 0;
const equal = (found, expected, what) => (++count, assert.deepEqual(found, expected, what));
const check = (holds, what) => (++count, assert.ok(holds, what));
const run = (program, args, cwd = work) => execFileSync(program, args, { cwd, encoding: "utf8", maxBuffer: 1 << 26 });
const sinew = (...args) => run(command, args);

for (const [folder, last] of [["npm", "webpack"], ["web", "playwright-core"]]) // the page's test has the browser
  if (!existsSync(join(root, "samples", folder, "node_modules", last))) run("npm", ["ci", "--silent", "--no-audit", "--no-fund"], join(root, "samples", folder));
rmSync(work, { recursive: true, force: true });
mkdirSync(join(work, "shots"), { recursive: true });
symlinkSync(tools, join(work, "node_modules")); // the projects' tools; the package itself comes from the tarball alone

function project(name, from = name) {
  const folder = join(work, name);
  cpSync(join(here, "projects", from), folder, { recursive: true });
  cpSync(join(here, "characters.mjs"), join(folder, "characters.mjs"));
  run("npm", ["install", "--offline", "--no-audit", "--no-fund", "--ignore-scripts", "--silent", tarball], folder);
  check(existsSync(join(folder, "node_modules/@sinew/skin/package.json")), `${name} has the package`);
  return folder;
}

// What the command gives for a sample.
function bound(name, ...options) {
  const rig = join(work, `${name}.rig.txt`);
  const args = ["bind", join(data, `${name}.obj`), "--skeleton", join(data, `${name}.rig.txt`), "--no-seams", "--json", ...options];
  const { hash } = JSON.parse(sinew(...args, "-o", rig));
  return { hash, rows: readRig(readFileSync(rig, "utf8")).influences };
}

function node() {
  const out = JSON.parse(run("node", ["main.mjs", data, ...samples], project("node")));
  equal(out.kernels, ["simd128", "ref"], "SIMD is used, and left out where asked");
  for (const name of samples) {
    const plain = bound(name).hash;
    equal(out.hashes[name].plain, plain, `${name}: the command's weights`);
    equal(out.hashes[name].scalar, plain, `${name}: the same without SIMD`);
    equal(out.hashes[name].heat, bound(name, "--method", "heat").hash, `${name}: heat`);
    equal(out.hashes[name].symmetric, bound(name, "--symmetric").hash, `${name}: symmetric`);
    equal(out.hashes[name].all, bound(name, "--joints", "all").hash, `${name}: all joints`);
    equal(out.hashes[name].rigid, bound(name, "--rigid-parts", "always", "--softness", "1.5").hash, `${name}: rigid parts, softer`);
    const bare = join(work, "bare.obj"), rigged = join(work, "bare.rig.txt");
    cpSync(join(data, `${name}.obj`), bare);
    for (const [i, detail] of ["body", "full"].entries()) {
      sinew("rig", bare, "--detail", detail, "-o", rigged);
      const { skeleton } = readRig(readFileSync(rigged, "utf8")), own = out.rigs[name][i];
      equal(own.names, skeleton.names, `${name}, ${detail}: the command's predicted skeleton`);
      equal(own.parents, Array.from(skeleton.parents), `${name}, ${detail}: its hierarchy`);
      check(own.positions.every((x, j) => Math.abs(x - skeleton.positions[j]) <= 1e-6), `${name}, ${detail}: its places`);
      equal(own.sure, own.names.length, `${name}, ${detail}: every joint says how sure it is`);
    }
  }
  check(samples.some((name) => out.rigs[name][1].names.includes("Jaw")), "a face is found");
  const plain = out.hashes[samples[0]].plain;
  equal(out.small, [plain, plain, plain], "the module that binds alone gives the same weights, without SIMD and as a file too");
  equal(out.smallHas, ["bind", "chooseJoints", "constructor", "openModel"], "and has nothing else");
  equal(out.byUrl, [plain, plain, plain], "the module as a file gives the same weights");
  const bytes = (name) => statSync(join(work, "node/node_modules/@sinew/skin/wasm", name)).size;
  check(bytes("bind-simd.wasm") < 0.75 * bytes("simd.wasm"), `the module that binds alone is small: ${bytes("bind-simd.wasm")} of ${bytes("simd.wasm")}`);
  // Byte for byte, not by the hash alone.
  const weights = bound(samples[0]).rows;
  const rows = { joints: new Uint16Array(4 * weights.size), weights: new Uint16Array(4 * weights.size) };
  for (const [v, row] of weights) row.forEach(([joint, weight], i) => ((rows.joints[4 * v + i] = joint), (rows.weights[4 * v + i] = weight)));
  equal(bindHash(rows), out.hashes[samples[0]].plain, "the hash is of the rows that the command wrote");
  check(out.floatSums < 1e-6, "rows of floats sum to 1");
  check(out.questions.length > 0 && out.questions.every(([, alternatives]) => alternatives > 0), "questions have alternatives");
  equal(out.locked, { row: [3, 0, 0, 0, 65535, 0, 0, 0], others: false }, "a locked vertex keeps its row, and no other changes");
  equal(out.hints, { row: [3, 0, 0, 0, 65535, 0, 0, 0], others: true }, "a hint keeps its row and steers others");
  const map = join(work, "map.txt");
  sinew("map", join(data, `${samples[1]}.rig.txt`), "--from", join(data, `${samples[0]}.rig.txt`), "-o", map);
  const target = readRig(readFileSync(join(data, `${samples[1]}.rig.txt`), "utf8")).skeleton;
  const source = readRig(readFileSync(join(data, `${samples[0]}.rig.txt`), "utf8")).skeleton;
  const lines = readFileSync(map, "utf8").split("\n").filter((line) => line && !line.startsWith("#")).map((line) => line.split(/\s+/));
  const expected = target.names.map((name) => source.names.indexOf(lines.find(([to]) => to === name)?.[1]));
  equal(out.map.sources, expected, "the command's map");
  equal(out.frames, 2, "both frames are retargeted");
  const { error: refused, ...stream } = out.stream;
  equal(stream, { plain: true, held: true, forgets: true }, "a stream gives a clip's frames, holds what stands, and forgets it when told");
  check(/^SinewError: retarget/.test(refused), `a wrong rate is refused: ${refused}`);
  const limbs = (classes) => classes.map((c) => ([5, 6, 9, 10].includes(c) ? c : 0));
  check(out.limbs.named.some((c) => c !== 17), "names say classes");
  equal(limbs(out.limbs.nameless), limbs(out.limbs.named), "limbs without names are found as the command finds them");
  equal(out.rest.deformer, 0, "the rest pose comes back exactly");
  check(out.rest.linear < 1e-6, "and by linear blending");
  equal(out.bend, { corrected: true, differs: true }, "a bend is corrected");
  check(out.dualQuaternion > 0.01, "dual quaternions move it");
  check(out.transferred < 0.01, `a character's weights for its own mesh are its weights: ${out.transferred}`);
  equal(out.simplified, 8, "eight joints stay");
  const vertices = readObj(readFileSync(join(data, `${samples[0]}.obj`), "utf8")).positions.length / 3;
  equal(out.babylon, [4 * vertices, 4 * vertices, 4], "Babylon's buffers");
  equal(out.playcanvas, [`Uint8Array ${4 * vertices}`, `Float32Array ${4 * vertices}`], "PlayCanvas' buffers");
  const errors = {
    lengths: "SinewError 0: mesh.positions: expected three numbers each",
    index: "SinewError 0: mesh.indices: expected indices below",
    parent: "SinewError 0: skeleton.parents: expected -1 or a joint below 1, found 5 at 0",
    cycle: "SinewError 0: skeleton.parents: expected a tree, found a cycle above joint 0",
    option: 'SinewError 0: bind: options.method: expected "model", "heat", "distance", found "magic"',
    finite: "SinewError -4: bind: ",
    never: "SinewError -7: bind: ",
    model: "SinewError -9: openModel: not a sinew model file",
    task: "SinewError 0: bind: expected a model of weights, found one of skeletons",
    cancelled: "SinewError -8: bind: ",
    told: "none",
    goesOn: "none",
    answer: "none",
  };
  for (const [name, line] of Object.entries(errors)) check(out.errors[name].startsWith(line), `${name}: ${out.errors[name]}`);
  equal(out.again, out.hashes[samples[0]].plain, "the engine works on after errors");
  check(out.grown < 64, `thirty binds grow the process by ${out.grown} MB`);
  equal(out.worker.hash, out.hashes[samples[0]].plain, "a worker of node's gives the same weights");
  check(out.worker.told > 3, "and tells how far it is");
  equal(out.worker.rest, 0, "a deformer lives in the worker");
  check(out.worker.error.startsWith("SinewError mesh.positions"), out.worker.error);
  equal(out.worker.closed, "the worker was closed", "closed is closed");
  console.log(`npm: node: ${count} checks`);
}

// Whole files: the command's bytes by its defaults.
function files() {
  const folder = join(work, "node"), given = join(work, "given"), mine = join(work, "mine"), theirs = join(work, "theirs");
  for (const one of [given, mine, theirs]) mkdirSync(one, { recursive: true });
  for (const [name, bytes] of Object.entries(strangeFiles())) writeFileSync(join(given, name), bytes);
  const at = (...names) => names.map((name) => (existsSync(join(given, name)) ? join(given, name) : join(data, name)));
  const jobs = [
    ...samples.map((name) => ({ job: "bind", files: at(`${name}.obj`, `${name}.rig.txt`), save: `${name}.glb` })),
    { job: "bind", files: at("biped__caped.gltf"), save: "caped.glb" },
    { job: "bind", files: at("biped__caped.gltf"), options: { method: "heat", influences: 8, symmetric: true }, args: ["--method", "heat", "--influences", "8", "--symmetric"], save: "heat.glb" },
    { job: "rig", files: at("biped__robed.obj"), save: "rigged.glb" },
    { job: "rig", files: at("biped__robot.obj"), options: { detail: "full" }, args: ["--detail", "full"], save: "full.glb" },
    { job: "retarget", files: at("biped__caped.gltf"), motion: at("strange.fbx"), save: "moved.glb" },
    ...["hanging.glb", "named.glb", "weighted.glb", "strange.fbx", "meters.fbx", "strange.dae"].map((name) => ({ job: "bind", files: at(name), save: `${name}.glb` })),
    { job: "bind", files: at("strange.fbx", "skin.png"), save: "dressed.glb" },
    { job: "rig", files: at("drawing__child.png"), picture: { units: "pixels" }, args: ["--units", "pixels"], save: "child.glb" },
    { job: "retarget", files: at("drawing__cat.png"), picture: { bodyClass: "quadruped" }, args: ["--class", "quadruped"], save: "cat.glb" },
    { job: "bind", files: at("broken.fbx"), save: "broken.glb" },
    { job: "bind", files: at("bare.obj"), save: "bare.glb" },
  ];
  writeFileSync(join(work, "jobs.json"), JSON.stringify(jobs));
  const lines = JSON.parse(run("node", ["files.mjs", join(work, "jobs.json"), mine], folder));
  equal(lines.pop(), {
    joints: 22, rotations: 88, aside: 1, turned: false,
    errors: ["keypoints: expected 22 keypoints as humanml3d22 has, found 21", "keypoints: unknown layout 'h36m', expected one of smpl24, humanml3d22, lafan22, smplh52, smplx55, coco17, h36m17, h36m32, kinect25, openpose25, mediapipe33",
      "openKeypoints: expected frames of as many keypoints each, three numbers a keypoint"],
  }, "keypoints alone are a person, and then frames of one");
  jobs.forEach(({ job, files: [first, ...beside], motion, args = [], save }, i) => {
    const skeleton = beside.find((path) => path.endsWith(".rig.txt"));
    const place = join(work, "place"); // only what the job has lies beside the file
    rmSync(place, { recursive: true, force: true });
    mkdirSync(place);
    for (const path of [first, ...beside]) cpSync(path, join(place, basename(path)));
    const call = [{ retarget: "animate" }[job] ?? job, join(place, basename(first)), ...(skeleton && job === "bind" ? ["--skeleton", join(place, basename(skeleton))] : []), ...(motion ? ["--motion", motion[0]] : []), ...args, "-o", join(theirs, save)];
    let said = "";
    try {
      execFileSync(command, call, { cwd: work, stdio: "pipe" });
    } catch (error) {
      said = String(error.stderr).trim();
    }
    if (said !== "") return void check(lines[i] !== "", `${save}: the command says ${said}, the package nothing`);
    equal(lines[i], "", `${save}: ${lines[i]}`);
    check(readFileSync(join(mine, save)).equals(readFileSync(join(theirs, save))), `${job} ${basename(first)}: the command's bytes`);
  });
  console.log(`npm: whole files: ${jobs.length}, the command's bytes`);
}

// Where it stands, its controls, what is wrong with it: the command's.
function delivery() {
  const mine = join(work, "delivered"), theirs = (name) => join(work, "delivered", `theirs.${name}`);
  mkdirSync(mine, { recursive: true });
  const told = JSON.parse(run("node", ["delivery.mjs", data, mine], join(work, "node")));
  const of = (...args) => ["bind", join(data, "biped__robed.obj"), "--skeleton", join(data, "biped__robed.rig.txt"), "--turn", "y", "--height", "2", "--floor", ...args];
  sinew(...of("--controls", theirs("controls.json"), "-o", theirs("glb")));
  sinew(...of("--for", "mixamo", "--to-pose", "none", "-o", join(work, "mixamo.glb")));
  const same = (name, other) => check(readFileSync(join(mine, name)).equals(readFileSync(other)), `${name}: the command's bytes`);
  same("hero.glb", theirs("glb"));
  same("hero.controls.json", theirs("controls.json"));
  // Axes of joints are sines of the machine's own library.
  const rounded = (path) => {
    const glb = readFileSync(path), end = 20 + glb.readUInt32LE(12);
    return [JSON.parse(glb.subarray(20, end), (_, one) => (typeof one === "number" ? Number(one.toFixed(9)) + 0 : one)), glb.subarray(end + 8).toString("base64")];
  };
  equal(rounded(join(mine, "mixamo.glb")), rounded(join(work, "mixamo.glb")), "the command's profile");
  const { findings, score } = JSON.parse(sinew("check", join(data, "biped__caped.gltf"), "--score", "--json"));
  equal(told.checked.findings.map(({ rule, severity, what }) => [rule, severity, what]), findings.map(({ rule, severity, what }) => [rule, severity, what]), "the command's findings");
  check(Math.abs(told.checked.score - score) < 0.051 && told.unscored === null, `the command's score ${score}: ${told.checked.score}`);
  check(findings.length > 0 && told.strict > findings.length && told.found.position.length === 3 && told.found.cure !== "", "bounds of the caller's own, and where to look");
  const lines = { turn: "expected x, y, z", profile: "unknown profile", rule: "unknown rule", option: "SinewError 0: check: options.count: expected poses" };
  for (const [name, line] of Object.entries(lines)) check(told.errors[name].includes(line), `${name}: ${told.errors[name]}`);
  console.log("npm: placed, checked, with controls: the command's");
}

function types() {
  const folder = project("types");
  const tsc = join(tools, "typescript/bin/tsc");
  run("node", [tsc, "-p", folder], folder);
  run("node", [tsc, "-p", folder, "--module", "esnext", "--moduleResolution", "bundler"], folder);
  // What is marked as an error must be one, else the types allow anything.
  const source = readFileSync(join(folder, "main.ts"), "utf8");
  writeFileSync(join(folder, "main.ts"), source.replace('method: "magic"', 'method: "heat"'));
  let line = "";
  try {
    run("node", [tsc, "-p", folder], folder);
  } catch (error) {
    line = error.stdout;
  }
  check(line.includes("Unused '@ts-expect-error'"), "the types are looked at");
  console.log("npm: TypeScript, strict: nodenext and bundler");
}

function withSamples(folder) {
  for (const ending of ["obj", "rig.txt"]) cpSync(join(data, `biped__robed.${ending}`), join(folder, `biped__robed.${ending}`));
}

async function page(name, folder) {
  const server = await serve(folder);
  const browser = await launch();
  try {
    const tab = await browser.context.newPage();
    const problems = [];
    tab.on("pageerror", (error) => problems.push(error.message));
    tab.on("console", (message) => message.type() === "error" && problems.push(message.text()));
    await tab.goto(server.address);
    await tab.waitForFunction(() => window.result, null, { timeout: 180000 });
    const result = await tab.evaluate(() => window.result);
    equal(result.error, undefined, `${name}: ${result.error}`);
    equal(problems.filter((line) => !line.includes("favicon") && !line.includes("404")), [], `${name}: no errors`);
    await tab.screenshot({ path: join(work, "shots", `${name}.png`) });
    equal([result.kernel, result.remote], ["simd128", "simd128"], `${name}: SIMD`);
    equal(result.hash, bound("biped__robed").hash, `${name}: bindGeometry() in a worker gives the command's weights`);
    check(result.told > 3 && result.read, `${name}: progress, and bones read back`);
    check(result.restMoves < 1e-5, `${name}: a bound mesh rests where it was, ${result.restMoves}`);
    check(result.rigged > 10 && result.tracks > 5, `${name}: a predicted skeleton, a retargeted clip`);
    check(result.moved > 0.3 && result.moved < 1.2 && result.hips < 0.05, `${name}: the other body waves where it stands, ${result.moved} ${result.hips}`);
    check(result.bySkeleton, `${name}: bindMesh() takes a Skeleton`);
    for (const [call, line] of Object.entries(result.posed)) check(line.startsWith(`${call}: the skeleton is posed (`), `${name}: ${call}: ${line}`);
    equal(result.byUrl, result.hash, `${name}: the module as a file of the bundler's, and the one that binds alone`);
    check(result.corrected && result.fromLinear > 0 && result.fromLinear < 0.5, `${name}: the volume is kept, ${result.fromLinear}`);
    console.log(`npm: ${name} in Chromium: ${JSON.stringify(result)}`);
  } finally {
    await browser.close();
    server.close();
  }
}

async function vite() {
  const folder = project("vite", "page");
  mkdirSync(join(folder, "public"));
  withSamples(join(folder, "public"));
  run("node", [join(tools, "vite/bin/vite.js"), "build", "--base", "./", "--logLevel", "error"], folder);
  await page("vite", join(folder, "dist"));
}

async function esbuild() {
  const folder = project("esbuild", "page"), dist = join(folder, "dist");
  run(join(tools, ".bin/esbuild"), ["main.js", "skin-worker.js", "--bundle", "--splitting", "--format=esm", "--target=es2022", `--outdir=${dist}`,
    "--log-level=warning"], folder);
  cpSync(join(folder, "node_modules/@sinew/skin/wasm"), join(dist, "wasm"), { recursive: true }); // esbuild leaves new URL() as it stands
  cpSync(join(folder, "index.html"), join(dist, "index.html"));
  withSamples(dist);
  await page("esbuild", dist);
}

async function webpack() {
  const folder = project("webpack", "page"), dist = join(folder, "dist");
  writeFileSync(join(folder, "build.mjs"), `import webpack from "webpack";
    webpack({ mode: "production", target: "web", context: ${JSON.stringify(folder)}, entry: "./main.js", experiments: { outputModule: true },
      output: { path: ${JSON.stringify(dist)}, filename: "main.js", module: true }, performance: { hints: false } },
      (error, stats) => {
        if (error || stats.hasErrors() || stats.hasWarnings()) throw error ?? new Error(stats.toString({ all: false, errors: true, warnings: true }));
      });\n`);
  run("node", ["build.mjs"], folder);
  cpSync(join(folder, "index.html"), join(dist, "index.html"));
  withSamples(dist);
  await page("webpack", dist);
}

const { launch, serve } = await import("../../web/test/browser.mjs"); // the page's, whose playwright is there by now
node();
files();
delivery();
types();
await esbuild();
await webpack();
await vite();
console.log(`npm: ${count} checks passed; screenshots in ${join(work, "shots")}`);
