// SPDX-License-Identifier: MIT
// Drawings on the page, in a headless Chromium: their outline with points to drag, which figure, a mask, flat, a picture of the phone's camera. What is
// saved is the command's, a change is a step of the history, and comes back from a project.
//   drawing_test.mjs DIST_DIR SOURCE_DIR WORK_DIR SINEW_COMMAND
import assert from "node:assert/strict";
import { copyFileSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { apartGlbs, fileOf, made, startPage } from "./page.mjs";

const { data, server, browser, page, at, command, undoName, settled, shoot, errorLine, positions, joints, give, downloaded, go, step } = await startPage("drawing_");
const handles = () => page.evaluate(() => sinewPage.view.outlineHandles.map(({ place, ...of }) => ({ ...of, ...sinewPage.view.onScreen(place) })));
const wishes = () => page.evaluate(() => sinewPage.character.source.pictureWishes ?? null);
const drag = async ({ x, y }, [right, down]) => {
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + right, y + down, { steps: 4 });
  await page.mouse.up();
  await settled();
};
const key = async (name) => (await page.keyboard.press(name), await settled());
// The page's GLB is that of `sinew animate` of the drawing with these options.
async function same(name, ...options) {
  command("animate", name, ...options, "-o", "command.glb");
  assert.equal(await errorLine(), "");
  const apart = apartGlbs((await downloaded("#download")).bytes, readFileSync(at("command.glb"))); // of the clip, which code makes
  assert.ok(apart < 1e-5, `${options}: the page's GLB is ${apart} off the command's`);
}
// A PNG that the browser draws by `draw`, a function of a context and the child's picture.
async function drawn(name, width, height, draw) {
  const child = readFileSync(at("child.png")).toString("base64");
  const address = await page.evaluate(
    async ([source, w, h, code]) => {
      const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${source}`)).blob());
      const canvas = Object.assign(document.createElement("canvas"), { width: w, height: h });
      const context = canvas.getContext("2d");
      new Function("context", "image", code)(context, image);
      return canvas.toDataURL();
    },
    [child, width, height, draw],
  );
  writeFileSync(at(name), Buffer.from(address.split(",")[1], "base64"));
  return fileOf(at(name));
}

try {
  await page.setViewportSize({ width: 1366, height: 768 });
  await page.goto(server.address);
  await settled();
  copyFileSync(join(data, "drawing__child.png"), at("child.png"));
  await give(fileOf(at("child.png")));
  const rest = await positions();

  await step("the step Mesh shows the drawing with its outline", async () => {
    assert.equal((await handles()).length, 0, "only there");
    await go("mesh");
    const points = await handles();
    assert.ok(points.length > 30 && points.length < 120, `${points.length} points`);
    const stage = await page.locator("#stage").boundingBox();
    assert.deepEqual(points.filter(({ x, y }) => x < stage.x || x > stage.x + stage.width || y < stage.y || y > stage.y + stage.height), []);
    for (const id of ["flat", "outline-found", "open-mask"]) assert.equal(await page.isVisible(`#${id}`), true, id);
    for (const id of ["height", "timeline", "figure"]) assert.equal(await page.isVisible(`#${id}`), false, id);
    assert.equal(await page.evaluate(() => document.getElementById("panel").scrollHeight - document.getElementById("panel").clientHeight), 0);
    await page.waitForTimeout(300); // the paper
    await shoot("outline");
  });

  await step("a point that is dragged makes the figure anew", async () => {
    const top = (await handles()).reduce((a, b) => (b.y < a.y ? b : a));
    const others = (await handles()).filter(({ x, y }) => Math.hypot(x - top.x, y - top.y) > 150);
    await drag(top, [0, -40]);
    assert.equal(await errorLine(), "");
    assert.equal(await undoName(), "outline");
    assert.notDeepEqual(await positions(), rest);
    assert.ok((await joints()).length > 10);
    const now = await handles();
    const far = others.filter(({ x, y }) => Math.min(...now.map((one) => Math.hypot(one.x - x, one.y - y))) > 12);
    assert.deepEqual(far, [], "the drawing stays where it was in the picture");
    await shoot("dragged");
    await key("Control+z");
    assert.deepEqual([await positions(), await wishes()], [rest, null]);
    await same("child.png");
    await key("Control+y");
    assert.notDeepEqual(await positions(), rest);
    await page.click("#outline-found");
    await settled();
    assert.deepEqual(await positions(), rest);
    assert.equal(await page.isDisabled("#outline-found"), true);
  });

  await step("a point is moved by the keyboard alone", async () => {
    await page.focus("#point");
    await page.keyboard.press("Control+a");
    await page.keyboard.type("1");
    await page.keyboard.press("Tab");
    const x = Number(await page.inputValue("#point-x"));
    await page.keyboard.press("ArrowUp");
    await page.keyboard.press("Tab");
    await settled();
    assert.equal(await undoName(), "outline");
    assert.notDeepEqual(await positions(), rest);
    const moved = Number(await page.inputValue("#point-x")) - x;
    assert.ok(moved > 0 && moved < 12, `the point that was moved is still the chosen one: ${moved}`);
    await shoot("point");
    await page.locator("#stage > canvas").hover();
    await page.evaluate(() => document.activeElement.blur());
    await key("Control+z");
    assert.deepEqual(await positions(), rest);
  });

  await step("flat, a mask and a kind are the command's", async () => {
    await page.check("#flat");
    await settled();
    assert.equal(await undoName(), "flat");
    await same("child.png", "--flat");
    await page.uncheck("#flat");
    await settled();
    const { width, height } = await page.evaluate(() => sinewPage.character.picture);
    const mask = await drawn("mask.png", width, height, `context.fillRect(0, 0, ${width}, ${height}); context.fillStyle = "#fff"; context.fillRect(${width} * 0.3, ${height} * 0.03, ${width} * 0.4, ${height} * 0.94);`);
    await page.setInputFiles("#mask-file", [mask]);
    await settled();
    await settled();
    assert.equal(await undoName(), "mask");
    await same("child.png", "--mask", "mask.png");
    await shoot("mask");
    await page.setInputFiles("#mask-file", [made("mask.obj", "v 0 0 0")]);
    await settled();
    assert.match(await errorLine(), /mask\.obj: expected a PNG or JPEG that is bright where the figure is/);
    await page.click("#outline-found");
    await settled();
    await page.selectOption("#kind", "2");
    await settled();
    assert.equal(await undoName(), "kind");
    await same("child.png", "--class", "quadruped");
    await key("Control+z");
    await same("child.png");
    assert.equal(await page.inputValue("#kind"), "0");
  });

  await step("what was dragged comes back from a project", async () => {
    const side = (await handles()).reduce((a, b) => (b.x > a.x ? b : a));
    await drag(side, [-30, 0]);
    const was = await positions();
    const project = await downloaded("#save-project");
    await go("mesh");
    await key("Control+z");
    assert.notDeepEqual(await positions(), was);
    await give(made(project.name, project.bytes));
    assert.equal(await errorLine(), "");
    assert.deepEqual(await positions(), was);
  });

  await step("one of two figures", async () => {
    const two = await drawn("two.png", 900, 600, "context.fillStyle = '#fff'; context.fillRect(0, 0, 900, 600); context.drawImage(image, 20, 20, 380, 560); context.drawImage(image, 500, 150, 290, 430);");
    await give(two);
    await go("mesh");
    assert.equal(await page.locator("#figure option").count(), 2);
    await page.selectOption("#figure", "2");
    await settled();
    assert.equal(await undoName(), "figure 2");
    await same("two.png", "--figure", "2");
    await shoot("figures");
  });

  await step("arms that are drawn along the trunk are opened", async () => {
    const person = await drawn("person.png", 450, 550, `
      context.fillStyle = "#fff"; context.fillRect(0, 0, 450, 550);
      context.fillStyle = "#5a8cd2"; context.strokeStyle = "#1e191e"; context.lineWidth = 4;
      context.beginPath(); context.arc(225, 110, 50, 0, 7); context.fill(); context.stroke();
      context.beginPath(); context.rect(150, 160, 150, 345); context.fill(); context.stroke();
      for (const [x, top] of [[180, 210], [270, 210]]) { context.beginPath(); context.moveTo(x, top); context.lineTo(x, 505); context.stroke(); }`);
    await give(person);
    await go("mesh");
    const lines = () => page.evaluate(() => sinewPage.character.picture.outline.reduce((sum, line) => sum + line.length, 0));
    const whole = await lines();
    await page.check("#cut");
    await settled();
    assert.equal(await undoName(), "cut along inner lines");
    assert.ok((await lines()) > whole + 4, "slits are outline, too");
    await same("person.png", "--cut");
    await shoot("cut");
    await key("Control+z");
    assert.equal(await lines(), whole);
    assert.equal(await page.isChecked("#cut"), false);
  });

  await step("on a phone a finger drags, and the camera brings drawings", async () => {
    await page.setViewportSize({ width: 390, height: 844 });
    await give(fileOf(at("child.png")));
    await go("mesh");
    await page.waitForTimeout(300);
    await shoot("phone");
    const before = await positions();
    const foot = (await handles()).reduce((a, b) => (b.y > a.y ? b : a));
    await page.evaluate(({ x, y }) => {
      const canvas = document.querySelector("#stage > canvas");
      canvas.setPointerCapture = canvas.releasePointerCapture = () => {}; // no pointer of that number is there
      const send = (type, down, buttons) => canvas.dispatchEvent(new PointerEvent(type, { clientX: x + 14, clientY: y + down, pointerId: 7, pointerType: "touch", button: 0, buttons, bubbles: true, isPrimary: true }));
      send("pointerdown", 0, 1);
      for (const down of [4, 8, 12]) send("pointermove", down, 1);
      send("pointerup", 12, 0);
    }, foot);
    await settled();
    assert.equal(await undoName(), "outline");
    assert.notDeepEqual(await positions(), before);
    assert.deepEqual(await page.evaluate(() => [document.getElementById("camera").accept, document.getElementById("camera").getAttribute("capture")]), ["image/*", "environment"]);
    await page.setInputFiles("#camera", [fileOf(at("two.png"))]);
    await page.waitForFunction(() => sinewPage.character.name === "two");
    await settled();
    assert.equal(await errorLine(), "");
  });
  console.log("drawing: all steps ok");
} finally {
  await browser.close();
  server.close();
}
