// SPDX-License-Identifier: MIT
// How the page's characters move, in a headless Chromium: skinning with the volume that bends keep, methods of retargeting with their contacts
// while a motion plays, the map as a table, fingers and faces of new skeletons. Positions, maps and files are the command's.
//   moves_test.mjs DIST_DIR SOURCE_DIR WORK_DIR SINEW_COMMAND
import assert from "node:assert/strict";
import { copyFileSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { apartGlbs, fileOf, made, startPage } from "./page.mjs";

const { data, server, browser, page, at, command, settled, shoot, errorLine, legend, positions, joints, pick, give, slide, downloaded, step } = await startPage("moves_");
const asked = [];
page.on("request", (request) => asked.push(request.url()));
const choose = async (label) => {
  await page.locator(label[0], { hasText: label[1] }).click();
  await settled();
};
const skinning = (name) => choose(["#skinning label", name]);
const method = (name) => choose(["#motion-method label", name]);
const bends = async () => (await page.reveal("#bends"), page.locator("#bends li").evaluateAll((rows) => rows.map((row) => row.innerText.split("\n").map((text) => text.trim()).filter(Boolean))));
const keptOf = async (name) => Number((await bends()).find(([joint]) => joint === name)[1].replace(" %", ""));
// The figure that `sinew animate MESH` makes of a bare mesh, with the motions that the test plays.
const figure = at("figure.obj");
const pause = async () => (await page.locator("#play").innerText()) === "Pause" && page.click("#play");
const to = async (share) => {
  await pause();
  await page.locator("#time").evaluate((input, wanted) => {
    input.value = String(Number(input.max) * wanted);
    input.dispatchEvent(new Event("input", { bubbles: true }));
  }, share);
  await settled();
};
const mapRow = (name) => page.locator("#map-rows tr", { has: page.locator(`button:text-is("${name}")`) });
const mapShown = async () => (await page.reveal("#map-rows"), page.locator("#map-rows tr").evaluateAll((rows) => Object.fromEntries(rows.map((row) => [row.querySelector("button").textContent, row.querySelector("select").selectedOptions[0].textContent.replace(/^none.*/, "-")]))));

try {
  await step("a bend keeps its volume by the way it is skinned", async () => {
    await page.goto(`${server.address}?sample=biped__robed`);
    await settled();
    assert.match(await page.locator("#bends").innerText(), /^Rotate a bone/);
    await pick("forearm.L");
    const rest = await positions();
    await slide("#turn-y", 110);
    const kept = { Linear: await keptOf("forearm.L") };
    const shown = { Linear: await positions() };
    await shoot("linear");
    for (const name of ["Dual quat.", "Volume"]) {
      await skinning(name);
      kept[name] = await keptOf("forearm.L");
      shown[name] = await positions();
      await shoot(name.split(" ")[0].toLowerCase());
    }
    assert.ok(kept.Linear < 90, `linear skinning keeps ${kept.Linear} %`);
    const off = (name) => Math.abs(kept[name] - 100);
    assert.ok(off("Volume") < off("Linear") && off("Volume") <= 12, JSON.stringify(kept));
    assert.notDeepEqual(shown.Volume, shown.Linear);
    assert.notDeepEqual(shown.Volume, shown["Dual quat."]);
    console.log("  kept", JSON.stringify(kept));
    // The picture is the command's, to the digits of an OBJ.
    copyFileSync(join(data, "biped__robed.obj"), at("robed.obj"));
    command("bind", at("robed.obj"), "--skeleton", join(data, "biped__robed.rig.txt"), "-o", at("robed.rig.txt"));
    command("pose", at("robed.obj"), "--joint", "forearm.L=0,110,0", "--deform", "volume", "-o", at("posed.obj"));
    const wanted = readFileSync(at("posed.obj"), "utf8").split("\n").filter((line) => line.startsWith("v ")).map((line) => line.split(" ").slice(1, 4).map(Number));
    const vertexOf = await page.evaluate(() => Array.from(sinewPage.character.buffers.vertexOf));
    const apart = Math.max(...vertexOf.flatMap((v, i) => wanted[v].map((x, axis) => Math.abs(x - shown.Volume[3 * i + axis]))));
    assert.ok(apart < 2e-3, `${apart} from sinew pose --deform volume`);
    // By keys, and back.
    await page.focus("#joints");
    await page.keyboard.press("d");
    await settled();
    assert.equal(await page.locator("#skinning input:checked + span").innerText(), "Contact");
    await page.keyboard.press("d");
    await settled();
    assert.deepEqual(await positions(), shown.Linear);
    await page.keyboard.press("r");
    await settled();
    assert.deepEqual(await positions(), rest);
    assert.match(await page.locator("#bends").innerText(), /^Rotate a bone/);
  });

  await step("several bends, the worst first; a click chooses its joint", async () => {
    await page.check("#mirror-pose");
    for (const [joint, axis, degrees] of [["shin.L", "x", 120], ["forearm.L", "y", 90], ["head", "y", 40]]) {
      await pick(joint);
      await slide(`#turn-${axis}`, degrees);
    }
    await page.uncheck("#mirror-pose");
    const list = await bends();
    assert.equal(list.length, 5);
    const off = list.map(([, percent]) => Math.abs(parseInt(percent) - 100));
    assert.deepEqual(off, [...off].sort((a, b) => b - a));
    await shoot("bends");
    await page.locator("#bends button").last().click();
    await settled();
    assert.equal(await page.locator("#joint-name").innerText(), list.at(-1)[0]);
    await skinning("Volume");
    await page.keyboard.press("4");
    await settled();
    assert.equal(await legend(), "As other programs show it, with linear skinning");
    await shoot("material");
    await page.keyboard.press("1");
    await page.click("#reset");
    await skinning("Linear");
  });

  await step("methods of retargeting while the motion plays", async () => {
    copyFileSync(join(data, "biped__robed.obj"), figure);
    command("animate", join(data, "biped__robot.obj"), "--motion", "builtin:squat", "-o", at("squat.bvh"));
    await give(made("figure.obj", readFileSync(figure)));
    await give(fileOf(at("squat.bvh")));
    assert.equal(await errorLine(), "");
    assert.equal(await page.locator("#motion-method input:checked").inputValue(), "0");
    await page.click("#play");
    await page.waitForTimeout(300);
    const before = Number(await page.inputValue("#time"));
    await method("Copy");
    assert.equal(await page.locator("#play").innerText(), "Pause", "it plays on");
    assert.ok(Number(await page.inputValue("#time")) !== before);
    await to(0.42);
    const copied = await positions();
    const copiedText = await page.locator("#motion-report").innerText();
    await shoot("copied");
    command("animate", figure, "--motion", at("squat.bvh"), "--method", "copy", "-o", at("copied.glb"));
    assert.ok((await downloaded("#download")).bytes.equals(readFileSync(at("copied.glb"))), "the page's GLB differs from the command's");
    const spots = () => page.evaluate(() => sinewPage.view.shown("spots"));
    assert.ok((await spots()).length >= 2, "both feet stand");
    await page.focus("#joints");
    for (const next of ["2", "3", "0"]) {
      await page.keyboard.press("c");
      await settled();
      assert.equal(await page.locator("#motion-method input:checked").inputValue(), next);
    }
    const mended = await positions();
    assert.notDeepEqual(mended, copied);
    await page.check("#in-place");
    await settled();
    command("animate", figure, "--motion", at("squat.bvh"), "--in-place", "-o", at("stays.glb"));
    assert.ok((await downloaded("#download")).bytes.equals(readFileSync(at("stays.glb"))), "the page's GLB in place differs from the command's");
    await page.click("#undo");
    await settled();
    assert.equal(await page.isChecked("#in-place"), false);
    assert.deepEqual(await positions(), mended);
    await slide("#arm-spread", 30);
    assert.equal(await page.locator("#arm-spread + output").innerText(), "30°");
    assert.notDeepEqual(await positions(), mended);
    command("animate", figure, "--motion", at("squat.bvh"), "--arm-spread", "30", "-o", at("spread.glb"));
    assert.ok((await downloaded("#download")).bytes.equals(readFileSync(at("spread.glb"))), "the page's GLB with spread arms differs from the command's");
    await page.locator("#arm-spread").dispatchEvent("dblclick");
    await settled();
    assert.equal(await page.inputValue("#arm-spread"), "0");
    assert.deepEqual(await positions(), mended);
    await page.click("#undo");
    await settled();
    assert.equal(await page.inputValue("#arm-spread"), "30");
    await page.click("#undo");
    await settled();
    assert.deepEqual(await positions(), mended);
    const text = await page.locator("#motion-report").innerText();
    assert.match(text, /Arms inside the body \d+ % of frames.*standing feet slide [\d.]+ % of the height per frame/);
    console.log(`  ${copiedText}\n  ${text}`);
    await shoot("contacts");
    await page.uncheck("#show-spots");
    await settled();
    assert.deepEqual(await spots(), []);
    await page.check("#show-spots");
    command("animate", figure, "--motion", at("squat.bvh"), "-o", at("squat.glb"));
    assert.ok((await downloaded("#download")).bytes.equals(readFileSync(at("squat.glb"))), "the page's GLB differs from the command's");
  });

  await step("a clip as a stream: each frame of those before it alone", async () => {
    await to(0.42);
    const whole = await positions();
    await method("Stream");
    assert.equal(await errorLine(), "");
    assert.notDeepEqual(await positions(), whole);
    await shoot("stream");
    command("animate", figure, "--motion", at("squat.bvh"), "--method", "stream", "-o", at("stream.glb"));
    assert.ok((await downloaded("#download")).bytes.equals(readFileSync(at("stream.glb"))), "the page's GLB differs from the command's");
    console.log(`  ${await page.locator("#motion-report").innerText()}`);
    await method("Contacts");
  });

  await step("what a motion brings is reached by the keyboard, and fits a phone", async () => {
    const reached = new Set();
    await page.focus("#open-motion");
    for (let i = 0; i < 30; ++i) {
      await page.keyboard.press("Tab");
      reached.add(await page.evaluate(() => document.activeElement.id || document.activeElement.name || document.activeElement.textContent));
    }
    const wanted = ["play", "time", "retarget", "show-spots", "speed", "close-motion"];
    assert.deepEqual(wanted.filter((id) => !reached.has(id)), [], "the tabulator reaches all of them");
    assert.ok([...reached].some((text) => text.startsWith("Bone map ")), "and the map");
    await page.setViewportSize({ width: 390, height: 844 });
    await page.waitForTimeout(200);
    await page.evaluate(() => document.getElementById("map").scrollIntoView());
    const outside = () => page.evaluate(() => [...document.querySelectorAll("header *, #tools *, #panel *, #timeline *, #rail *")].filter((one) => one.offsetParent && one.getBoundingClientRect().right > innerWidth + 1).map((one) => one.id || one.className || one.tagName));
    assert.deepEqual(await outside(), []);
    assert.equal(await page.evaluate(() => document.scrollingElement.scrollTop), 0, "the panel scrolls, not the page");
    await shoot("phone");
    await page.setViewportSize({ width: 1280, height: 800 });
  });

  await step("the camera goes along with a motion, and back", async () => {
    // The hips go forward by five times the body's height, nothing else moves.
    const lines = readFileSync(at("squat.bvh"), "utf8").split("\n");
    const motion = lines.indexOf("MOTION");
    const still = lines[motion + 3].split(" ");
    const far = [...still];
    far[2] = String(Number(far[2]) + 8);
    await give(made("far.bvh", [...lines.slice(0, motion + 1), "Frames: 2", "Frame Time: 1", still.join(" "), far.join(" ")].join("\n")));
    assert.equal(await errorLine(), "");
    const head = (await joints()).findIndex(({ name }) => name === "Head");
    const onScreen = () => page.evaluate((j) => sinewPage.view.jointOnScreen(j), head);
    const [first, place] = [await onScreen(), (await page.evaluate(() => sinewPage.view.shown("joints")))[3 * head + 2]];
    await to(1);
    const last = await onScreen();
    assert.ok((await page.evaluate(() => sinewPage.view.shown("joints")))[3 * head + 2] > place + 5, "it has gone");
    assert.ok(Math.hypot(last.x - first.x, last.y - first.y) < 3, `and is where it was in the picture: ${JSON.stringify([first, last])}`);
    await page.click("#close-motion");
    await settled();
    const back = await onScreen();
    assert.ok(back.x > 300 && back.x < 700 && back.y > 100 && back.y < 500, JSON.stringify(back));
    await shoot("back");
  });

  const nothingMoves = async () => {
    if (await page.isVisible("#close-motion")) await page.click("#close-motion");
    await settled();
  };
  await step("reference points, for a motion without a body and for one with the character's own mesh", async () => {
    await give(fileOf(at("squat.bvh")));
    await method("Ref. points");
    assert.equal(await errorLine(), "");
    command("animate", figure, "--motion", at("squat.bvh"), "--method", "reference-points", "-o", at("capsules.glb"));
    assert.ok((await downloaded("#download")).bytes.equals(readFileSync(at("capsules.glb"))), "the page's GLB differs from the command's");
    await nothingMoves();
    await page.setInputFiles("#motion-files", [{ name: "squat.glb", mimeType: "model/gltf-binary", buffer: readFileSync(at("squat.glb")) }]);
    await page.waitForFunction(() => document.getElementById("motion-files").files.length === 0);
    await settled();
    assert.equal(await errorLine(), "");
    await method("Ref. points");
    assert.equal(await errorLine(), "");
    await to(0.42);
    await shoot("reference_points");
    command("animate", figure, "--motion", at("squat.glb"), "--method", "reference-points", "-o", at("points.glb"));
    // The clip is read back from a GLB: between its keys C's sine and arc cosine turn joints, which differ from library to library.
    const apart = apartGlbs((await downloaded("#download")).bytes, readFileSync(at("points.glb")));
    assert.ok(apart < 1e-5, `the page's GLB is ${apart} off the command's`);
  });

  await step("the map is shown, and followed as it is edited", async () => {
    await nothingMoves();
    await give(fileOf(at("squat.bvh")));
    await page.locator("#map > summary").click();
    await page.locator("#map-rows tr").first().waitFor();
    const list = await joints();
    assert.equal(await page.locator("#map-rows tr").count(), list.length);
    command("rig", figure, "-o", at("figure_rigged.glb"));
    const toldMap = (...more) => Object.fromEntries(JSON.parse(command("map", at("figure_rigged.glb"), "--from", at("squat.bvh"), "--up", "auto", "-o", at("map.json"), "--json", ...more)).joints.map(({ target, source }) => [target, source ?? "-"]));
    assert.deepEqual(await mapShown(), toldMap());
    await to(0.42);
    const found = await positions();
    await page.locator("#map").scrollIntoViewIfNeeded();
    await shoot("map");
    await mapRow("LeftArm").locator("select").focus();
    await mapRow("LeftArm").locator("select").selectOption({ label: "upper_arm.R" });
    await settled();
    assert.equal(await errorLine(), "");
    assert.deepEqual(await mapShown(), toldMap("--set", "LeftArm=upper_arm.R"));
    assert.notDeepEqual(await positions(), found, "it moves by the new map at once");
    assert.match(await page.locator("#map-count").innerText(), /1 by you$/);
    await shoot("map_edited");
    // The same source for another joint takes the first word back.
    await mapRow("Head").locator("select").focus();
    await mapRow("Head").locator("select").selectOption({ label: "none" });
    await settled();
    assert.deepEqual(await mapShown(), toldMap("--set", "LeftArm=upper_arm.R", "--set", "Head=-"));
    await mapRow("LeftArm").locator("select").focus();
    await mapRow("LeftArm").locator("select").selectOption({ label: "Automatic" });
    await settled();
    assert.deepEqual(await mapShown(), toldMap("--set", "Head=-"));
    await page.click("#map-forget");
    await settled();
    assert.deepEqual(await mapShown(), toldMap());
    assert.deepEqual(await positions(), found);
    await mapRow("LeftArm").locator("button").click();
    await settled();
    await page.keyboard.press("1");
    assert.equal(await legend(), "Weight of LeftArm");
    await page.keyboard.press("Escape");
    await page.click("#close-motion");
    await settled();
  });

  await step("a new skeleton with fingers, face and props", async () => {
    await give(made("bare.obj", readFileSync(figure)));
    const body = (await joints()).map(({ name }) => name);
    assert.ok(!asked.some((url) => url.includes("sinew_hands.sinew")), "the model of hands is fetched before anyone needs it");
    copyFileSync(figure, at("bare.obj"));
    for (const [value, detail] of [["1", "hands"], ["2", "full"]]) {
      await page.selectOption("#detail", value);
      await settled();
      assert.equal(await errorLine(), "");
      command("rig", at("bare.obj"), "--detail", detail, "-o", at("detail.glb"));
      assert.ok((await downloaded("#download")).bytes.equals(readFileSync(at("detail.glb"))), `${detail}: the page's GLB differs from the command's`);
      assert.match(await page.locator("#edit-notes").innerText(), /^No hand with separate fingers\./);
    }
    const full = (await joints()).map(({ name }) => name);
    assert.deepEqual(["LeftEye", "RightEye", "Jaw", "LeftHandProp"].filter((name) => !full.includes(name)), []);
    assert.ok(asked.some((url) => url.includes("sinew_hands.sinew")));
    await page.locator("#detail").scrollIntoViewIfNeeded();
    await pick("Jaw");
    await shoot("face");
    await page.keyboard.press("Control+z");
    await page.keyboard.press("Control+z");
    await settled();
    assert.deepEqual((await joints()).map(({ name }) => name), body);
    await page.selectOption("#detail", "0");
    await settled();
  });

  console.log("moves: all steps ok");
} finally {
  await browser.close();
  server.close();
}
