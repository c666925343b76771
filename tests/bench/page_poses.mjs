// SPDX-License-Identifier: MIT
// How many poses a second the page draws of a character with about 125,000 vertices that walks, and how fast a bare mesh of 17,000 gets weights and
// keeps them while a joint is dragged. In a headless Chromium; which graphics card draws is in the first line.
//   page_poses.mjs DIST_DIR SOURCE_DIR WORK_DIR [poses|renderer]     poses: linear skinning alone; renderer: what draws, and nothing is measured
// SINEW_CHROMIUM names another browser, SINEW_CHROMIUM_ARGS has arguments in place of those for software rendering, as "--use-angle=vulkan --enable-gpu".
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { made, startPage } from "../../samples/web/test/page.mjs";

const seconds = 5; // that each figure is counted for
const wanted = process.argv[5] ?? "all";
const { server, browser, troubles, page, data, file, give, go, pick, joints, settled, errorLine } = await startPage("poses_");

// text: an OBJ of v and f lines; every face becomes as many quads as it has corners, so many times over. Edges' middles are shared.
function subdivided(text, times) {
  const rows = text.split("\n").map((line) => line.split(/\s+/));
  const points = rows.filter(([kind]) => kind === "v").map((row) => row.slice(1, 4).map(Number));
  let faces = rows.filter(([kind]) => kind === "f").map((row) => row.slice(1).filter(Boolean).map((corner) => parseInt(corner, 10) - 1));
  const middle = (of) => points.push([0, 1, 2].map((i) => of.reduce((sum, v) => sum + points[v][i], 0) / of.length)) - 1;
  for (let i = 0; i < times; ++i) {
    const middles = new Map();
    const between = (a, b) => {
      const key = `${Math.min(a, b)} ${Math.max(a, b)}`;
      if (!middles.has(key)) middles.set(key, middle([a, b]));
      return middles.get(key);
    };
    faces = faces.flatMap((face) => {
      const center = middle(face);
      return face.map((v, c) => [v, between(v, face[(c + 1) % face.length]), center, between(face.at(c - 1), v)]);
    });
  }
  return [...points.map((p) => `v ${p.map((x) => x.toFixed(6)).join(" ")}`), ...faces.map((face) => `f ${face.map((v) => v + 1).join(" ")}`), ""].join("\n");
}

const meshOf = (sample, times, name) => made(name, subdivided(readFileSync(join(data, `${sample}.obj`), "utf8"), times));
const say = (what, figure) => console.log(`${`${what}:`.padEnd(44)} ${figure}`);
const sayVertices = async () => `${(await page.evaluate(() => sinewPage.character.vertices)).toLocaleString("en")} vertices`;

// {frames, poses}: pictures a second, and of them those with another pose than the one before. The last one is waited for.
const drawn = () =>
  page.evaluate(async (length) => {
    const gl = document.querySelector("#stage canvas").getContext("webgl2");
    const start = performance.now();
    let [frames, poses, last] = [0, 0, ""];
    while (performance.now() - start < 1e3 * length) {
      await new Promise(requestAnimationFrame);
      const now = sinewPage.view.shownJoints().join();
      ++frames;
      poses += Number(now !== last);
      last = now;
    }
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    const passed = (performance.now() - start) / 1e3;
    return { frames: frames / passed, poses: poses / passed };
  }, seconds);

async function playing(what) {
  await page.click("#play");
  await page.evaluate(() => new Promise((resolve) => setTimeout(resolve, 500)));
  const { frames, poses } = await drawn();
  say(what, `${poses.toFixed(1)} poses a second (${frames.toFixed(1)} pictures)`);
  await page.click("#play");
  await settled();
}

async function measurePoses() {
  const start = performance.now();
  await give(meshOf("biped__robed", 3, "dense.obj"), made("dense.rig.txt", file("biped__robed.rig.txt").buffer));
  assert.equal(await errorLine(), "");
  say(`${await sayVertices()} with a skeleton`, `shown with weights after ${((performance.now() - start) / 1e3).toFixed(1)} s`);
  await go("motion");
  await page.click("#clip-grid [data-clip=walk]");
  await settled();
  assert.equal(await errorLine(), "");
  await page.keyboard.press("4");
  await settled();
  await page.waitForFunction(() => sinewPage.view.look);
  await playing("Material, linear");
  await page.keyboard.press("1");
  await settled();
  await page.waitForFunction(() => !sinewPage.view.look);
  await playing("Weights, linear");
  if (wanted === "poses") return;
  await page.evaluate(() => document.querySelector("#skinning input[value='2']").click());
  await settled(); // what it is made with
  await playing("Weights, volume");
}

async function measureEdits() {
  const mesh = meshOf("biped__robot", 2, "bare.obj");
  for (const when of ["the first time", "again"]) {
    const start = performance.now();
    await page.setInputFiles("#files", mesh);
    await page.evaluate(() => sinewPage.settled());
    await page.waitForFunction(() => sinewPage.character?.name === "bare" && sinewPage.character.result);
    say(`${await sayVertices()}, bare, dropped ${when}`, `weights after ${((performance.now() - start) / 1e3).toFixed(2)} s`);
  }
  await settled();
  await go("skeleton");
  await pick((await joints()).find(({ name }) => /ForeArm/.test(name)).name);
  const from = await page.evaluate(() => sinewPage.view.jointOnScreen(sinewPage.view.selected));
  await page.evaluate(() => {
    const { view } = sinewPage;
    const show = view.setColors.bind(view);
    window.updates = 0;
    view.setColors = (colors) => (++window.updates, show(colors));
  });
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  const start = performance.now();
  for (let i = 0; performance.now() - start < 1e3 * seconds; ++i) {
    await page.mouse.move(from.x + 12 * Math.sin(i / 20), from.y + 12 * Math.cos(i / 20));
    await new Promise((resolve) => setTimeout(resolve, 15));
  }
  const updates = await page.evaluate(() => window.updates);
  say("a joint of it is dragged", `${(updates / ((performance.now() - start) / 1e3)).toFixed(1)} updates of weights a second`);
  await page.mouse.up();
  await settled();
}

try {
  await page.goto(server.address);
  await settled();
  assert.equal(await errorLine(), "");
  const renderer = await page.evaluate(async () => {
    const gl = document.querySelector("#stage canvas").getContext("webgl2");
    for (let i = 0; gl.isContextLost() && i < 50; ++i) await new Promise((resolve) => setTimeout(resolve, 100)); // flags that do not work lose it, and the next way to draw brings it back
    const names = gl.getExtension("WEBGL_debug_renderer_info");
    return gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  });
  say("drawn by", renderer);
  if (wanted !== "renderer") await measurePoses();
  if (wanted === "all") await measureEdits();
  for (const line of troubles) console.log(`the browser says: ${line}`);
} finally {
  await browser.close();
  server.close();
}
