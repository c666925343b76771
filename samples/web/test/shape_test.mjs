// SPDX-License-Identifier: MIT
// The mesh as a whole, markers and the T pose, in a headless Chromium: what is turned, marked and posed is in the saved file as the command makes it,
// is taken back, and comes back from a project.
//   shape_test.mjs DIST_DIR SOURCE_DIR WORK_DIR SINEW_COMMAND
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileOf, made, startPage } from "./page.mjs";

const { dist, data, server, browser, page, at, command, file, undoName, settled, shoot, errorLine, hash, joints, positions, give, downloaded, go, choose, step } = await startPage("shape_");
const places = async () => (await joints()).map(({ name, position }) => [name, ...position]);
const key = async (name) => (await page.keyboard.press(name), await settled());
const marked = () => page.evaluate(() => sinewPage.character.source.markers);
const saved = async () => (await downloaded("#download")).bytes;
const same = async (...args) => {
  command(...args, "-o", "command.glb");
  assert.equal(await errorLine(), "");
  assert.ok((await saved()).equals(readFileSync(at("command.glb"))), `the page's GLB differs from that of sinew ${args.join(" ")}`);
};
const said = () => page.textContent("#dial-said");
const onPage = (point) => page.evaluate((p) => sinewPage.view.onScreen(p), point);
const press = async ({ x, y }, to = null) => {
  await page.mouse.move(x, y);
  await page.mouse.down();
  if (to) await page.mouse.move(to.x, to.y, { steps: 4 });
  await page.mouse.up();
  await settled();
};
// What is on the picture's canvas and under nothing else.
const views = async (name) => {
  for (const [width, height, size] of [[1366, 768, ""], [390, 844, "_phone"]]) {
    await page.setViewportSize({ width, height });
    await page.waitForTimeout(150);
    await shoot(`${name}${size}`);
  }
  await page.setViewportSize({ width: 1366, height: 768 });
};

try {
  await page.setViewportSize({ width: 1366, height: 768 });
  await page.goto(server.address);
  await settled();
  writeFileSync(at("robot.obj"), readFileSync(join(data, "biped__robot.obj")));
  // The same lying on its back, with z up and centimetres.
  const lying = readFileSync(at("robot.obj"), "utf8").replace(/^v (\S+) (\S+) (\S+).*$/gm, (_, x, y, z) => `v ${100 * x} ${100 * z} ${-100 * y}`).replace(/^vn (\S+) (\S+) (\S+)/gm, (_, x, y, z) => `vn ${x} ${z} ${-y}`);
  writeFileSync(at("lying.obj"), lying);
  // The same grown together with its reflection from front to back.
  const robot = readFileSync(at("robot.obj"), "utf8").split("\n").map((line) => line.split(/\s+/));
  const vertices = robot.filter(([word]) => word === "v").map(([, ...xyz]) => xyz.map(Number));
  const faces = robot.filter(([word]) => word === "f").map(([, ...corners]) => corners.filter(Boolean).map((corner) => parseInt(corner, 10)));
  const alike = [
    ...vertices.map(([x, y, z]) => `v ${x} ${y} ${z}`), ...vertices.map(([x, y, z]) => `v ${x} ${y} ${-z}`),
    ...faces.map((face) => `f ${face.join(" ")}`), ...faces.map((face) => `f ${face.map((v) => v + vertices.length).reverse().join(" ")}`), "",
  ].join("\n");

  await step("the first sample is a person in clothes, rigged as the command does it", async () => {
    await page.click("#start .thumbs button >> nth=0");
    await settled();
    assert.equal(await page.evaluate(() => sinewPage.character.name), "biped__clothed");
    assert.ok((await joints()).some(({ name }) => name === "LeftForeArm"));
    await same("rig", join(dist, "samples/biped__clothed.glb"));
    await go("mesh");
    await views("sample");
  });

  await step("a mesh that lies is turned, stands on the floor and is as tall as it is told", async () => {
    await give(made("lying.obj", lying));
    await go("mesh");
    assert.match(await said(), /^Up is Z \(\d+ % sure\)\. The front is \S\S \(\d+ % sure\)\..* If it does not stand, tip it over\.$/);
    await page.selectOption("#up", "0");
    await settled();
    await page.click("#tip-near");
    await settled();
    assert.equal(await undoName(), "tip over");
    assert.match(await said(), /^Up is Y \(as you set it\)\./);
    await same("rig", "lying.obj", "--up", "y", "--turn", "x");
    await page.fill("#height", "1.8");
    await key("Tab");
    assert.equal(await undoName(), "height");
    await page.check("#floor");
    await settled();
    await same("rig", "lying.obj", "--up", "y", "--turn", "x", "--height", "1.8", "--floor");
    const low = (await positions()).reduce(([least, most], x, i) => (i % 3 === 1 ? [Math.min(least, x), Math.max(most, x)] : [least, most]), [Infinity, -Infinity]);
    assert.ok(Math.abs(low[0]) < 1e-6 && Math.abs(low[1] - 1.8) < 1e-5, `${low}`);
    await views("mesh");
    const [was, project] = [await places(), await downloaded("#save-project")];
    await go("mesh");
    for (const _ of ["floor", "height", "tip over", "up axis"]) await key("Control+z");
    assert.equal(await page.isChecked("#floor"), false);
    await same("rig", "lying.obj");
    await give(made(project.name, project.bytes));
    assert.deepEqual(await places(), was);
    await same("rig", "lying.obj", "--up", "y", "--turn", "x", "--height", "1.8", "--floor");
  });

  await step("the arrow of the dial is the front, and the mesh turns until it faces the viewer", async () => {
    await give(made("robot.obj", readFileSync(at("robot.obj"))));
    await go("mesh");
    const { x, y, width, height } = await page.locator("#dial-ring").boundingBox();
    await page.mouse.move(x + width / 2, y + height * 0.9);
    await page.mouse.down();
    await page.mouse.move(x + width * 0.8, y + height * 0.6, { steps: 4 });
    await page.mouse.move(x + width * 0.95, y + height / 2);
    await page.mouse.up();
    await settled();
    assert.equal(await page.inputValue("#front"), "3");
    assert.equal(await said(), "Up is Y (sure). The front is +X (as you set it).");
    await same("rig", "robot.obj", "--front", "+x");
    await page.click("#face-viewer");
    await settled();
    assert.equal(await said(), "Up is Y (as you set it). The front is +Z (as you set it).");
    await same("rig", "robot.obj", "--up", "y", "--turn", "-y", "--front", "+z");
    await views("faces");
    await key("Control+z");
    assert.equal(await page.inputValue("#front"), "3");
    await key("Control+z");
    assert.equal(await page.inputValue("#front"), "0");
    await same("rig", "robot.obj");
  });

  await step("a front that is uncertain is asked for, and its back is the other side", async () => {
    await give(made("column.obj", alike));
    assert.equal(await page.textContent("#offer-said"), "This mesh is hard to recognize. What is it?");
    await page.click("#offer button:has-text('Person')");
    await settled();
    assert.match(await page.textContent("#offer-said"), /^Is this its front\? I am only \d+ % sure/);
    assert.equal(await page.getAttribute("#rail [data-step=mesh]", "aria-label"), "Mesh");
    const found = await page.evaluate(() => sinewPage.character.front);
    await page.click("#offer button:has-text('No, its back')");
    await settled();
    const now = await page.evaluate(() => sinewPage.character.front);
    assert.ok(found[0] * now[0] + found[2] * now[2] < -0.7, `${found} ${now}`);
    assert.equal(await page.getAttribute("#rail [data-step=mesh]", "aria-label"), "Mesh, done");
    await go("mesh");
    assert.match(await said(), /as you set it\)\.$/);
    await shoot("front");
  });

  await step("a GLB with materials goes along as a whole", async () => {
    await give(file("biped__caped.gltf"));
    await go("mesh");
    const before = await places();
    assert.match(await said(), /^Up is Y. The front is \+Z, by its bones\.$/);
    for (const id of ["front", "face-viewer"]) assert.ok(await page.isDisabled(`#${id}`), id);
    await page.click("#tip-left");
    await settled();
    await page.fill("#height", "0.5");
    await key("Tab");
    await go("weights");
    const turned = await positions();
    writeFileSync(at("turned.glb"), await saved());
    await give(fileOf(at("turned.glb")));
    assert.equal(await errorLine(), "");
    const again = await positions();
    assert.equal(again.length, turned.length);
    assert.ok(again.every((x, i) => Math.abs(x - turned[i]) < 1e-6));
    assert.equal(before.length, (await joints()).length);
    await shoot("placed_again");
  });

  await step("parts of the body that the user marks are where the new skeleton has them", async () => {
    await give(made("robot.obj", readFileSync(at("robot.obj"))));
    await go("skeleton");
    await page.locator("#marking summary").click();
    const first = await joints();
    const [hand, elbow] = ["LeftHand", "LeftForeArm"].map((name) => first.find((one) => one.name === name).position);
    await page.selectOption("#marker-part", "LeftHand");
    await page.click("#marker-place");
    await page.click("#view-front");
    await settled();
    const wanted = hand.map((x, i) => x - 0.3 * (x - elbow[i]));
    await press(await onPage(wanted));
    const [one] = await marked();
    assert.equal(one.joint, "LeftHand");
    assert.ok(Math.hypot(...one.place.map((x, i) => x - wanted[i])) < 0.06, `${one.place} is not ${wanted}`);
    assert.equal(await undoName(), "mark Left wrist");
    assert.equal(await page.inputValue("#marker-part"), "LeftForeArm", "the next part");
    await press(await onPage(elbow.map((x, i) => x + (i === 1 ? 0.02 : 0))));
    assert.equal((await marked()).length, 2);
    await page.click("#marker-place"); // no more
    // A drag of the first.
    const from = await onPage(one.place);
    await press(from, { x: from.x - 6, y: from.y + 8 });
    const [dragged] = await marked();
    assert.notDeepEqual(dragged.place, one.place);
    await views("markers");
    await page.click("#marker-rig");
    await settled();
    assert.equal(await undoName(), "rig again");
    const rigged = await joints();
    assert.deepEqual(rigged.find(({ name }) => name === "LeftHand").position, dragged.place.map(Math.fround));
    const at_ = (await marked()).flatMap(({ joint, place }) => ["--at", `${joint}=${place.join(",")}`]);
    await same("rig", "robot.obj", ...at_);
    await views("marked");
    const [was, project] = [await hash(), await downloaded("#save-project")];
    await go("skeleton");
    for (const _ of ["rig", "drag", "elbow", "wrist"]) await key("Control+z");
    assert.deepEqual([await marked(), await places()], [[], first.map(({ name, position }) => [name, ...position])]);
    await give(made(project.name, project.bytes));
    assert.deepEqual([await hash(), (await marked()).length], [was, 2]);
  });

  await step("markers by keys alone and by touch", async () => {
    await give(made("robot.obj", readFileSync(at("robot.obj"))));
    await go("skeleton");
    assert.deepEqual(await marked(), []);
    await page.focus("#marker-part");
    await page.locator("#marker-part").selectOption("Head");
    await page.focus("#marker-here");
    await key("Enter");
    const head = (await joints()).find(({ name }) => name === "Head").position;
    assert.deepEqual((await marked())[0].place, head);
    await page.focus("#marker-y");
    await key("ArrowUp");
    await key("Enter");
    const [{ place }] = await marked();
    assert.ok(place[1] > head[1]);
    await page.focus("#marker-rig");
    await key("Enter");
    assert.ok(Math.abs((await joints()).find(({ name }) => name === "Head").position[1] - place[1]) < 1e-6);
    // A finger 20 pixels beside the marker drags it.
    await page.evaluate((p) => {
      const { x, y } = sinewPage.view.onScreen(p);
      const canvas = document.querySelector("#stage > canvas");
      const send = (kind, dx, dy, buttons) => canvas.dispatchEvent(new PointerEvent(kind, { clientX: x + 18 + dx, clientY: y + dy, pointerId: 7, pointerType: "touch", button: 0, buttons, bubbles: true, isPrimary: true }));
      canvas.setPointerCapture = canvas.releasePointerCapture = () => {}; // no pointer of that number is there
      send("pointerdown", 0, 0, 1);
      send("pointermove", 0, -12, 1);
      send("pointerup", 0, -12, 0);
    }, place);
    await settled();
    assert.ok((await marked())[0].place[1] > place[1]);
    for (const box of await page.locator("#marking button, #marking select").all()) assert.ok(((await box.boundingBox())?.height ?? 24) >= 24);
    await page.locator("#markers .remove").click();
    await settled();
    assert.deepEqual([await marked(), await undoName()], [[], "unmark Head"]);
  });

  await step("the T pose is shown, saved and taken back", async () => {
    await give(made("robot.obj", readFileSync(at("robot.obj"))));
    const standing = [await positions(), await places()];
    await page.click("#t-pose");
    await settled();
    assert.equal(await undoName(), "T pose");
    const posed = await positions();
    assert.notDeepEqual(posed, standing[0]);
    await same("rig", "robot.obj", "--to-pose", "t");
    await go("skeleton");
    assert.equal(await page.isDisabled("#rename"), true, "joints are edited as the mesh stands");
    await views("t_pose");
    const project = await downloaded("#save-project");
    await go("motion");
    await page.click("#clip-grid [data-clip=walk]");
    await settled();
    assert.equal(await errorLine(), "");
    await page.locator("#time").evaluate((input) => ((input.value = "0.4"), input.dispatchEvent(new Event("input", { bubbles: true }))));
    await settled();
    await views("t_pose_walks");
    await page.click("#close-motion");
    await settled();
    await go("skeleton");
    await page.click("#t-pose");
    await settled();
    assert.deepEqual([await positions(), await places()], standing);
    await same("rig", "robot.obj");
    // Files for avatars stand in it whatever is shown.
    await choose("vrm");
    await page.fill("#author", "somebody");
    const vrm = (await downloaded("#onward")).bytes;
    command("rig", "robot.obj", "--for", "vrm", "--author", "somebody", "-o", "command.vrm");
    assert.ok(vrm.equals(readFileSync(at("command.vrm"))), "the page's VRM differs from that of sinew rig --for vrm");
    await settled();
    assert.deepEqual([await positions(), await places()], standing, "the character stands as before");
    await give(file("snake__long.obj"));
    await page.click("#t-pose");
    await settled();
    assert.match(await errorLine(), /rest pose is unknown/);
    assert.equal(await page.getAttribute("#t-pose", "aria-pressed"), "false");
    assert.notEqual(await hash(), "");
    await key("Escape");
    await give(made(project.name, project.bytes));
    assert.deepEqual(await positions(), posed);
  });
  console.log("shape: all steps ok");
} finally {
  await browser.close();
  server.close();
}
