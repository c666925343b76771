// SPDX-License-Identifier: MIT
// The page with a thousand characters in a headless Chromium, and the shader's positions against three.js's skinning of the same clips.
//   crowd_test.mjs SOURCE_DIR SINEW_COMMAND WORK_DIR
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { launch, serve } from "../../web/test/browser.mjs";

const [source, sinew, work] = process.argv.slice(2);
const crowd = join(source, "samples/crowd"), web = join(source, "samples/web"), dist = join(work, "dist");
rmSync(work, { recursive: true, force: true });
mkdirSync(work, { recursive: true });
execFileSync(join(crowd, "build.sh"), [dist, sinew], { stdio: "inherit" });
execFileSync(join(web, "node_modules/.bin/esbuild"), [join(crowd, "test/probe.js"), "--bundle", "--format=esm", `--outdir=${dist}`, "--log-level=warning"], {
  env: { ...process.env, NODE_PATH: join(web, "node_modules") },
});
writeFileSync(join(dist, "probe.html"), '<!doctype html><link rel="icon" href="data:,"><script type="module" src="probe.js"></script>');

// Weights of a GLB have 16 bits: half a step of each of four influences, times how far two joints can take a vertex apart.
const byWeights = ({ min, max }) => ((4 * 0.5) / 65535) * Math.hypot(...max.map((value, i) => value - min[i]));

const server = await serve(dist), browser = await launch();
try {
  const page = await browser.context.newPage(), faults = [];
  page.on("pageerror", (error) => faults.push(String(error)));
  page.on("console", (message) => message.type() === "error" && faults.push(message.text()));

  await page.goto(`${server.address}probe.html`);
  await page.waitForFunction(() => window.probe);
  const characters = {
    clothed: [join(work, "clothed.glb"), "builtin:walk", "builtin:wave"],
    caped: [join(source, "samples/data/biped__caped.gltf"), "builtin:run"],
    robed: [join(source, "samples/data/biped__robed.obj"), "builtin:jump"],
  };
  execFileSync(process.execPath, [join(web, "samples/clothed.mjs"), characters.clothed[0]]);
  for (const [name, [file, ...motions]] of Object.entries(characters)) {
    const folder = join(dist, name), words = motions.flatMap((motion) => ["--motion", motion]);
    const report = JSON.parse(execFileSync(sinew, ["animate", file, ...words, "--vat", folder, "-o", join(folder + ".glb"), "--json"], { encoding: "utf8" }));
    const address = `${name}/${report.vat.layout}`;
    const layout = await page.evaluate(async (url) => (await fetch(url)).json(), address);
    const moments = report.vat.clips.flatMap((clip) => [0, 7, clip.frames - 1, 3.5, clip.frames - 1.5].map((frame) => ({ clip: clip.name, frame })));
    const results = await page.evaluate(([url, skinned, at]) => window.probe(url, skinned, at), [address, `${name}.glb`, moments]);
    for (const [i, { clip, frame }] of moments.entries()) {
      const { error } = report.vat.clips.find((one) => one.name === clip);
      const stated = frame % 1 === 0 ? error.frames.max : error.between.max;
      console.log(`${name} ${clip} at frame ${frame}: ${(1000 * results[i].largest).toFixed(3)} mm off, stated ${(1000 * stated).toFixed(3)}`);
      assert.ok(results[i].largest <= stated + byWeights(layout.bounds), `${name}, ${clip}, frame ${frame}`);
      assert.equal(results[i].vertices, layout.vertices, "every vertex is compared");
    }
  }

  page.setDefaultTimeout(200_000); // a thousand characters without a GPU
  await page.setViewportSize({ width: 960, height: 540 });
  await page.goto(server.address);
  await page.waitForFunction(() => document.querySelector("#text").textContent.includes("FPS"));
  const text = await page.textContent("#text");
  console.log(text);
  assert.match(text, /^1,000 characters of [\d,]+ vertices, 5 clips in [\d.]+ MB, 2 draw calls, [\d.]+ FPS$/); // the crowd and the floor
  const first = await page.screenshot({ path: join(work, "crowd.png") });
  await page.waitForTimeout(300);
  assert.notDeepEqual(await page.screenshot(), first, "it moves");

  assert.deepEqual(faults, []);
  await page.goto(`${server.address}?vat=missing.json`);
  await page.waitForFunction(() => document.querySelector("#text").textContent === "missing.json: the server answers 404");
  console.log("CROWD OK");
} finally {
  await browser.close();
  server.close();
}
