// SPDX-License-Identifier: MIT
// What swings on the page's characters, in a headless Chromium: chains with switches and sliders, in clips and while the character is dragged; files are the
// command's, and a file's own springs are used.
//   springs_test.mjs DIST_DIR SOURCE_DIR WORK_DIR SINEW_COMMAND
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileOf, made, startPage } from "./page.mjs";

const { data, server, browser, page, at, command, file, undoName, settled, shoot, errorLine, give, slide, downloaded, go, step } = await startPage("springs_");
const chains = () => page.locator("#spring-chains li").evaluateAll((rows) => rows.map((row) => ({ name: row.querySelector(".name").textContent, about: row.querySelector(".share").textContent, on: row.querySelector("input").checked, disabled: row.querySelector("input").disabled })));
const shownJoints = () => page.evaluate(() => sinewPage.view.shown("joints"));
const jsonOf = (glb) => JSON.parse(glb.subarray(20, 20 + glb.readUInt32LE(12)));
// The rotations of all channels of a GLB's clips, by joints.
function rotationsOf(glb) {
  const json = jsonOf(glb), start = 28 + glb.readUInt32LE(12);
  const floats = ({ bufferView, byteOffset = 0, count }) => Array.from({ length: 4 * count }, (_, i) => glb.readFloatLE(start + (json.bufferViews[bufferView].byteOffset ?? 0) + byteOffset + 4 * i));
  return Object.fromEntries(json.animations.flatMap(({ name, channels, samplers }) => channels.filter(({ target }) => target.path === "rotation").map(({ target, sampler }) => [`${name} ${json.nodes[target.node].name}`, floats(json.accessors[samplers[sampler].output])])));
}
// Two C libraries differ in the last digits.
function sameClips(one, other, what) {
  const [a, b] = [rotationsOf(one), rotationsOf(other)];
  assert.deepEqual(Object.keys(a).sort(), Object.keys(b).sort(), what);
  if (process.env.SHOW) console.log(Object.entries(a).map(([name, floats]) => `${name} ${apart(floats, b[name]).toExponential(1)}`).join(", "));
  for (const [name, floats] of Object.entries(a)) assert.ok(floats.length === b[name].length && apart(floats, b[name]) < 1e-4, `${what}: ${name} is ${apart(floats, b[name])} off`);
}
const apart = (one, other) => Math.max(...one.map((x, i) => Math.abs(x - other[i])));
const to = async (share) => {
  await page.locator("#time").evaluate((input, wanted) => {
    input.value = String(Number(input.max) * wanted);
    input.dispatchEvent(new Event("input", { bubbles: true }));
  }, share);
  await settled();
};

try {
  await step("a character without hair or tail says so", async () => {
    await page.goto(server.address);
    await settled();
    await give(file("biped__robot.obj"), file("biped__robot.rig.txt"));
    await go("motion");
    assert.equal(await page.locator("#springs-said").textContent(), "nothing swings");
    assert.equal(await page.isVisible("#springs-some"), false);
  });

  let still, swinging;
  await step("chains are found and are off until somebody wants them", async () => {
    await give(file("quadruped__tailed.obj"), file("quadruped__tailed.rig.txt"));
    await page.click("#clip-grid [data-clip=trot]");
    await settled();
    assert.equal(await errorLine(), "");
    const found = await chains();
    console.log(`  ${JSON.stringify(found)}`);
    assert.ok(found.length > 0 && found.some(({ about }) => /tail, \d+ % sure/.test(about)), JSON.stringify(found));
    assert.equal(await page.isChecked("#springs-on"), false);
    assert.equal(await page.locator("#springs-said").textContent(), "off");
    await to(0.4);
    still = await shownJoints();
  });

  await step("they swing behind a clip, as in the file that is saved", async () => {
    await page.check("#springs-on");
    await settled();
    assert.equal(await undoName(), "springs on");
    await to(0.4);
    swinging = await shownJoints();
    assert.ok(apart(still, swinging) > 1e-3, "nothing swings");
    await page.locator("#springs summary").scrollIntoViewIfNeeded();
    await shoot("panel");
    const { bytes } = await downloaded("#download");
    writeFileSync(at("page.glb"), bytes);
    assert.deepEqual(jsonOf(bytes).extensions.VRMC_springBone.springs.map(({ name }) => name), ["ear.L", "ear.R", "tail_1"]);
    // The same by the command. Files have no limits of angle, so that what is read again swings a little farther.
    command("bind", join(data, "quadruped__tailed.obj"), "--skeleton", join(data, "quadruped__tailed.rig.txt"), "-o", "bound.glb");
    command("springs", "bound.glb", "-o", "springs.glb");
    command("animate", "bound.glb", "--motion", "builtin:trot", "--springs", "-o", "swings.glb");
    sameClips(bytes, readFileSync(at("swings.glb")), "the page's clip and the command's");
    // Without it in the clips they are as they were.
    await page.uncheck("#bake-springs");
    const plain = (await downloaded("#download")).bytes;
    command("animate", "bound.glb", "--motion", "builtin:trot", "-o", "plain.glb");
    sameClips(plain, readFileSync(at("plain.glb")), "without springs");
    assert.equal(jsonOf(plain).extensions.VRMC_springBone.springs.length, 3);
    await page.check("#bake-springs");
    await go("motion");
  });

  await step("numbers are factors of what was found, one step of the history each", async () => {
    await slide("#spring-stiffness", 0.3);
    assert.equal(await undoName(), "stiffness of springs");
    await to(0.4);
    const loose = await shownJoints();
    assert.ok(apart(loose, swinging) > 1e-3, "a looser tail swings in another way");
    await page.keyboard.press("Control+z");
    await settled();
    await to(0.4);
    assert.deepEqual(await shownJoints(), swinging, "undo is exact");
    assert.equal(await page.locator("#spring-stiffness").inputValue(), "1");
  });

  await step("a chain is switched off by its name", async () => {
    const [first] = (await chains()).filter(({ on }) => on);
    await page.reveal("#spring-chains");
    await page.locator("#spring-chains input:checked").first().uncheck();
    await settled();
    assert.equal(await undoName(), `${first.name} does not swing`);
    await to(0.4);
    if ((await chains()).every(({ on }) => !on)) assert.ok(apart(await shownJoints(), still) < 1e-6);
    await page.keyboard.press("Control+z");
    await settled();
    await to(0.4);
    assert.deepEqual(await shownJoints(), swinging);
  });

  await step("the pointer drags the character: it swings behind, and comes back", async () => {
    const names = await page.evaluate(() => sinewPage.character.joints.map(({ name }) => name));
    const body = names.findIndex((name) => /spine|chest|pelvis|hips/i.test(name));
    const place = await page.evaluate((joint) => sinewPage.view.jointOnScreen(joint), body);
    const before = await shownJoints();
    await page.mouse.move(place.x, place.y);
    await page.mouse.down();
    await page.mouse.move(place.x + 60, place.y, { steps: 3 });
    await page.waitForTimeout(120);
    const during = await shownJoints();
    const moved = (joints, j) => Math.hypot(...[0, 1, 2].map((i) => joints[3 * j + i] - before[3 * j + i]));
    assert.ok(moved(during, body) > 0.02, `the body moved by ${moved(during, body)}`);
    await shoot("dragged");
    await page.mouse.up();
    await page.waitForFunction(() => !sinewPage.drags);
    await settled();
    const after = await shownJoints();
    assert.ok(moved(after, body) < 1e-3, "it is back");
    // By a key, without a pointer.
    await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press("g");
    await page.waitForFunction(({ was, at }) => Math.hypot(...[0, 1, 2].map((i) => sinewPage.view.shown("joints")[3 * at + i] - was[3 * at + i])) > 1e-3, { was: before, at: body }, { timeout: 3000 }); // G shakes it
    await page.waitForFunction(() => !sinewPage.drags);
  });

  await step("a drag beside the character looks around, and nothing of it is a step", async () => {
    const name = await undoName();
    const stage = await page.locator("#stage").boundingBox();
    const where = () => page.evaluate(() => sinewPage.view.jointOnScreen(0));
    const before = await where();
    await page.mouse.move(stage.x + 30, stage.y + 120);
    await page.mouse.down();
    await page.mouse.move(stage.x + 130, stage.y + 120, { steps: 3 });
    await page.mouse.up();
    await page.waitForTimeout(100);
    assert.notDeepEqual(await where(), before);
    assert.equal(await undoName(), name);
  });
  await step("springs stay with the work, and a file's own are used without a word", async () => {
    await slide("#spring-drag", 2);
    await to(0.4);
    const was = await shownJoints();
    const project = await downloaded("#save-project");
    await give(made(project.name, project.bytes));
    assert.equal(await page.locator("#spring-drag").inputValue(), "2");
    await to(0.4);
    assert.deepEqual(await shownJoints(), was);
    await go("mesh");
    await give(fileOf(at("springs.glb")));
    await page.click("#clip-grid [data-clip=trot]");
    await settled();
    assert.deepEqual((await chains()).map(({ name, about, on }) => [name, about, on]), [["ear.L", "ear, from the file", true], ["ear.R", "ear, from the file", true], ["tail_1", "tail, from the file", true]]);
    assert.equal(await page.isChecked("#springs-on"), true);
    await to(0.4);
    assert.ok(apart(await shownJoints(), swinging) < 0.02, "they swing as they did where they were found");
    const { bytes } = await downloaded("#download");
    command("animate", "springs.glb", "--motion", "builtin:trot", "--springs", "-o", "own.glb");
    sameClips(bytes, readFileSync(at("own.glb")), "with the file's own");
    // Switched off they are not in the file either.
    await page.uncheck("#springs-on");
    await settled();
    assert.equal(jsonOf((await downloaded("#download")).bytes).extensions?.VRMC_springBone?.springs?.length ?? 0, 0);
  });
  console.log("springs: all steps ok");
} finally {
  await browser.close();
  server.close();
}
