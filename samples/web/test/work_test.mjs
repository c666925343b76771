// SPDX-License-Identifier: MIT
// What a new user does with the page, in a headless Chromium: it starts with few things, every step fits its window, one history takes everything
// back by name, work outlives a reload, dropped motions move the character that is open, keys do all, long jobs are stopped, no network is needed.
//   work_test.mjs DIST_DIR SOURCE_DIR WORK_DIR SINEW_COMMAND
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { brotliCompressSync, constants, gzipSync } from "node:zlib";
import { apartGlbs, fileOf, made, newPage, startPage } from "./page.mjs";
import { strangeFbx } from "./scene_files.mjs";

const { dist, work, data, server, browser, troubles, page, at, command, file, undoName, settled, shoot, errorLine, hash, joints, leave, positions, pick, give, slide, downloaded, go, step } = await startPage("work_");
const asked = []; // addresses until the first character walks
const note = (request) => request.serviceWorker() === null && asked.push(request.url());
browser.context.on("request", note); // those of workers too
const shown = () => page.evaluate(() => [...document.querySelectorAll("button, input, select, summary, a")].filter((one) => one.checkVisibility({ contentVisibilityAuto: true }) && !one.closest("[hidden]")).map((one) => one.id || one.textContent));
const clips = () => page.locator("#clips li").count();
const wideAs = (width, height) => page.setViewportSize({ width, height });
const fits = () =>
  page.evaluate(() => {
    const panel = document.getElementById("panel");
    return { over: panel.scrollHeight - panel.clientHeight, wide: document.documentElement.scrollWidth - innerWidth, high: document.documentElement.scrollHeight - innerHeight };
  });

try {
  await step("the page starts with a card and few things", async () => {
    await wideAs(1366, 768);
    await page.goto(server.address);
    await settled();
    assert.equal(await page.isVisible("#start"), true);
    const controls = await shown();
    console.log(`  ${controls.length} controls`);
    assert.ok(controls.length <= 15, `${controls}`);
    await shoot("start");
    await wideAs(390, 844);
    assert.deepEqual([(await fits()).wide, (await fits()).high], [0, 0]);
    await shoot("start_phone");
    await wideAs(1366, 768);
    await page.keyboard.press("?");
    assert.equal(await page.isVisible("#help-page"), true);
    await page.keyboard.press("Escape");
    assert.equal(await page.isVisible("#help-page"), false);
  });

  await step("a bare mesh to a walking GLB in three clicks", async () => {
    writeFileSync(at("robot.obj"), readFileSync(join(data, "biped__robot.obj")));
    await give(made("robot.obj", readFileSync(at("robot.obj"))));
    assert.equal(await errorLine(), "");
    assert.equal(await page.evaluate(() => sinewPage.step), "skeleton");
    await page.click("#rail [data-step=motion]");
    await page.click("#clip-grid [data-clip=walk]");
    await settled();
    const { bytes } = await downloaded("#download");
    browser.context.off("request", note);
    command("animate", "robot.obj", "--motion", "builtin:walk", "-o", "walk.glb");
    const apart = apartGlbs(bytes, readFileSync(at("walk.glb"))); // of the clip, which code makes
    assert.ok(apart < 1e-5, `the page's GLB is ${apart} off the command's`);
  });

  await step("what the first bind takes over the wire", async () => {
    assert.equal(await page.evaluate(() => sinewPage.firstAlone), true, "the first bind waits for what it does not need");
    const filesOf = (list) => [...new Set(list.map((url) => new URL(url).pathname.slice(1) || "index.html"))].filter((name) => existsSync(join(dist, name)));
    const tell = (what, files) => {
      const sent = (name, pack) => (name.endsWith(".zlib") ? statSync(join(dist, name)).size : pack(readFileSync(join(dist, name))).length); // nothing packs those further
      const packed = files.map((name) => [name, sent(name, (bytes) => gzipSync(bytes, { level: 9 }))]);
      const kilobytes = (list) => Math.round(list.reduce((sum, bytes) => sum + bytes, 0) / 1e3);
      const byBrotli = kilobytes(files.map((name) => sent(name, (bytes) => brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_QUALITY]: 9 } }))));
      const total = kilobytes(packed.map(([, bytes]) => bytes));
      console.log(`  ${what}: ${total} kB packed by gzip, ${byBrotli} by brotli: ${packed.filter(([, bytes]) => bytes > 1e4).map(([name, bytes]) => `${name} ${Math.round(bytes / 1e3)}`).join(", ")}`);
      return total;
    };
    const [first, all] = [filesOf(asked.slice(0, asked.findIndex((url) => url.includes("-rest.wasm")))), filesOf(asked)];
    tell("a bare mesh, bound", first);
    const skinned = tell("a mesh with a skeleton, bound", first.filter((name) => !/_(rig|front)\.sinew|-rig\.wasm/.test(name)));
    assert.ok(skinned <= 750, `${skinned} kB until a mesh with a skeleton is bound, expected 750 at most`);
    tell("a bare mesh, walking", all);
    assert.ok(!all.some((name) => /scenes|hands/.test(name)), "what nobody asked for is not fetched");
    assert.ok(!first.some((name) => /look-|box_tree/.test(name)), `${first}`);
  });

  await step("nothing in the picture lies on something else", async () => {
    for (const [width, height] of [[1366, 768], [1000, 700], [800, 700], [390, 844]]) {
      await wideAs(width, height);
      for (const name of ["mesh", "skeleton", "weights", "motion", "export"]) {
        await go(name);
        const apart = await page.evaluate(() => {
          const boxes = ["view-switch", "brush", "legend", "said", "offer", "tools", "status"].map((id) => [id, document.getElementById(id).getBoundingClientRect()]).filter(([, box]) => box.width * box.height > 0);
          return boxes.flatMap(([one, a], i) => boxes.slice(i + 1).flatMap(([other, b]) => (a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom ? [`${one} on ${other}`] : [])));
        });
        assert.deepEqual(apart, [], `${name} at ${width} x ${height}`);
      }
      await shoot(`motion_${width}`);
    }
    await wideAs(1366, 768);
  });

  await step("buttons do not lie on the character", async () => {
    await page.click("#close-motion");
    await settled();
    for (const [width, height] of [[1366, 768], [800, 700], [390, 844]]) {
      await wideAs(width, height);
      for (const name of ["skeleton", "weights", "export"]) {
        await go(name);
        await page.waitForTimeout(100);
        const covered = await page.evaluate(() => {
          const places = sinewPage.view.shown("positions"), points = [];
          for (let v = 0; v < places.length; v += 3) points.push(sinewPage.view.onScreen(places.slice(v, v + 3)));
          const boxes = ["view-switch", "brush", "offer", "tools", "status"].map((id) => [id, document.getElementById(id).getBoundingClientRect()]).filter(([, box]) => box.width * box.height > 0);
          const stage = document.getElementById("stage").getBoundingClientRect();
          const lies = ({ x, y }, box) => x > box.left && x < box.right && y > box.top && y < box.bottom;
          return [...boxes.filter(([, box]) => points.some((point) => lies(point, box))).map(([id]) => id), ...(points.every((point) => lies(point, stage)) ? [] : ["cut off"])];
        });
        assert.deepEqual(covered, [], `${name} at ${width} x ${height}`);
      }
      await shoot(`covered_${width}`);
    }
    await wideAs(1366, 768);
    await go("motion");
    await page.click("#clip-grid [data-clip=walk]");
    await settled();
  });

  await step("every step fits its window", async () => {
    for (const name of ["mesh", "skeleton", "weights", "motion", "export"]) {
      await go(name);
      const { over, wide, high } = await fits();
      assert.deepEqual([over <= 0, wide, high], [true, 0, 0], `${name}: the panel is ${over} too high`);
      assert.equal(await page.locator("#step-name").textContent(), name[0].toUpperCase() + name.slice(1));
      await shoot(name);
    }
    await wideAs(390, 844);
    for (const name of ["skeleton", "motion"]) {
      await go(name);
      const { wide, high } = await fits();
      assert.deepEqual([wide, high], [0, 0], name);
      const stage = await page.locator("#stage").boundingBox();
      assert.ok(stage.height > 844 / 3, `${name}: the picture has ${stage.height}`);
      await shoot(`${name}_phone`);
    }
    await page.click("#sheet");
    assert.equal(await page.locator("#panel-body").isVisible(), false);
    await page.click("#sheet");
    await wideAs(1366, 768);
    await page.click("#close-motion");
    await settled();
  });

  await step("a tick says that somebody looked; what the page cannot know it asks", async () => {
    const ticks = () => page.locator("#rail .done b").allInnerTexts();
    await give(file("biped__robot.obj"));
    assert.deepEqual(await ticks(), ["Mesh"]);
    await go("weights");
    assert.deepEqual(await ticks(), ["Mesh", "Skeleton", "Weights"]);
    assert.equal(await page.isVisible("#offer"), false);
    // A block has no legs.
    const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => `v ${i & 1 ? 0.5 : -0.5} ${i & 2 ? 0.9 : 0} ${i & 4 ? 0.4 : -0.4}`);
    await give(made("block.obj", [...corners, "f 1 3 4 2", "f 5 6 8 7", "f 1 2 6 5", "f 3 7 8 4", "f 1 5 7 3", "f 2 4 8 6"].join("\n")));
    assert.equal(await page.locator("#offer-said").innerText(), "No legs were found. What is it?");
    assert.deepEqual(await page.locator("#offer button").allInnerTexts(), ["Person", "Four legs", "Bird", "Fish", "Other"]);
    await page.click("#offer button:has-text('Four legs')");
    await settled();
    assert.deepEqual([await page.locator("#kind").inputValue(), await undoName()], ["2", "new skeleton"]);
    assert.match(await page.locator("#offer-said").innerText(), /^Is this its front\?/); // a block's is uncertain
    await page.click("#offer button:has-text('Yes')");
    await settled();
    assert.match(await page.locator("#offer-said").innerText(), /^\d+ bones/);
    for (const _ of ["front", "kind"]) await page.keyboard.press("Control+z");
    await settled();
    // A joint outside the body is to be looked at.
    await give(file("biped__robot.obj"));
    assert.equal(await page.isDisabled("#next-doubt"), true);
    await pick("LeftForeArm");
    await page.fill("#place-z", "1.5");
    await page.keyboard.press("Tab");
    await settled();
    assert.match(await page.locator("#step-said").innerText(), /outside the body/);
    assert.match(await page.locator("#next-doubt").innerText(), /^Check next \(\d/);
    assert.ok(!(await ticks()).includes("Skeleton"));
    await page.keyboard.press("Control+z");
    await settled();
  });

  await step("one history for everything, with names", async () => {
    await give(file("biped__robot.obj"), file("biped__robot.rig.txt"));
    assert.equal(await page.isDisabled("#undo"), true);
    const before = [await hash(), await positions()];
    const names = [];
    const done = async (name) => {
      await settled();
      assert.equal(await undoName(), name);
      names.push(name);
    };
    await pick("forearm.L");
    await page.keyboard.press("x");
    await done("switch forearm.L");
    await page.keyboard.press("l");
    await done("lock forearm.L");
    await slide("#softness", 1);
    await done("softness");
    await page.check("#symmetric");
    await done("symmetric weights");
    await pick("upper_arm.R");
    await slide("#turn-z", 30);
    await done("rotate upper_arm.R");
    await page.click("#next-question");
    await page.locator("#questions .alternative").first().click();
    await settled();
    names.push(await undoName());
    assert.match(names.at(-1), /^answer part/);
    const after = [await hash(), await positions()];
    assert.notEqual(after[0], before[0]);
    for (const name of [...names].reverse()) {
      assert.equal(await undoName(), name);
      await page.keyboard.press("Control+z");
      await settled();
    }
    assert.deepEqual([await hash(), await positions()], before, "all of it is taken back");
    assert.equal(await page.isDisabled("#undo"), true);
    assert.equal(await page.isChecked("#symmetric"), false);
    for (const _ of names) {
      await page.keyboard.press("Control+y");
      await settled();
    }
    assert.deepEqual([await hash(), await positions()], after, "and done again");
  });

  await step("work outlives the page, and goes on from a file", async () => {
    const was = await hash();
    await page.evaluate(() => sinewPage.autosaved());
    let asked = "";
    page.once("dialog", (dialog) => ((asked = dialog.type()), dialog.accept()));
    await page.goto(server.address);
    assert.equal(asked, "beforeunload", "the page asks before it is left");
    await settled();
    assert.match(await page.locator("#start .kept .go").first().innerText(), /^Resume biped__robot\s+today \d\d:\d\d$/);
    await shoot("kept");
    await page.locator("#start .kept .go").first().click();
    await settled();
    assert.equal(await errorLine(), "");
    assert.equal(await hash(), was);
    const project = await downloaded("#save-project");
    assert.equal(project.name, "biped__robot.sinewproject");
    await page.evaluate(() => sinewPage.forgetWork());
    await page.goto(server.address);
    await settled();
    assert.equal(await page.isVisible("#start .kept"), false);
    await give(made(project.name, project.bytes));
    assert.equal(await errorLine(), "");
    assert.equal(await hash(), was);
    assert.equal(await page.isChecked("#symmetric"), true);
    await give(made("broken.sinewproject", project.bytes.subarray(0, 2000)));
    assert.match(await errorLine(), /^broken\.sinewproject: expected a ZIP archive/);
    assert.equal(await hash(), was);
    await page.keyboard.press("Escape");
  });

  // A step of the history, and the hash that came of it.
  const switched = async (name) => {
    await pick(name);
    await page.keyboard.press("x");
    await settled();
    return hash();
  };
  const keptNames = async () => (await page.locator("#start .kept b").allInnerTexts()).map((text) => text.replace(/^Resume /, ""));
  await step("a file that is dropped on unsaved work opens beside it, and both come back", async () => {
    await page.evaluate(() => sinewPage.forgetWork());
    await leave();
    await give(file("biped__robot.obj"), file("biped__robot.rig.txt"));
    const robot = await switched("head");
    await give(file("quadruped__tailed.obj"), file("quadruped__tailed.rig.txt"));
    assert.deepEqual(await page.locator("#characters [role=tab]").allInnerTexts(), ["biped__robot", "quadruped__tailed"]);
    const tailed = await switched("head");
    await page.locator("#characters [role=tab]").first().click();
    await settled();
    assert.equal(await hash(), robot);
    await leave();
    assert.deepEqual((await keptNames()).sort(), ["biped__robot", "quadruped__tailed"]);
    assert.match(await page.locator("#start .kept img").first().getAttribute("src"), /^data:image\/webp;base64,.{200}/);
    await page.locator("#start .kept .go", { hasText: "quadruped" }).click();
    await settled();
    assert.equal(await errorLine(), "");
    assert.equal(await hash(), tailed);
    await go("mesh");
    await page.locator("#panel .kept summary").click();
    await page.locator("#panel .kept .go", { hasText: "robot" }).click();
    await settled();
    assert.equal(await hash(), robot);
    assert.deepEqual(await page.locator("#characters [role=tab]").allInnerTexts(), ["quadruped__tailed", "biped__robot"]);
    await page.locator("#characters .close").first().click();
    await settled();
    assert.equal(await page.isVisible("#characters"), false);
    assert.equal(await hash(), robot);
  });

  await step("files of one name are each character's own", async () => {
    const was = await hash();
    await give(made("biped__robot.obj", readFileSync(join(data, "snake__long.obj"))));
    assert.equal(await page.locator("#characters [role=tab]").count(), 2);
    assert.notEqual(await hash(), was);
    await page.locator("#characters [role=tab]").first().click();
    await settled();
    assert.equal(await hash(), was);
    await page.locator("#characters .close").last().click();
    await settled();
  });

  await step("a second window keeps its own work and leaves the first one's", async () => {
    const second = await newPage(browser, troubles);
    await second.goto(server.address);
    await second.evaluate(() => sinewPage.settled());
    await second.locator("#start .kept .go", { hasText: "robot" }).click();
    await second.evaluate(() => sinewPage.settled());
    await second.click("#joints li:has-text('head')");
    await second.click("#lock");
    await second.evaluate(() => sinewPage.settled());
    await leave(second);
    assert.equal((await second.locator("#start .kept b").allInnerTexts()).filter((text) => text === "Resume biped__robot").length, 2, "the first window's and its own");
    await second.close();
    const was = await hash();
    await leave();
    assert.equal((await keptNames()).filter((name) => name === "biped__robot").length, 2);
    const hashes = [];
    for (const number of [0, 1]) {
      await page.locator("#start .kept .go", { hasText: "robot" }).nth(number).click();
      await settled();
      hashes.push(await hash());
      await leave();
    }
    assert.ok(hashes.includes(was), "the first window's work");
    await page.evaluate(() => sinewPage.forgetWork());
    await page.goto(server.address);
    await settled();
  });

  await step("a skeleton that was edited comes back with its joints", async () => {
    await give(file("snake__long.obj"));
    const [plain, first] = [await hash(), await joints()];
    await pick(first.find(({ end, parent }) => !end && parent >= 0).name);
    await go("skeleton");
    await page.fill("#place-y", String(first.find(({ end, parent }) => !end && parent >= 0).position[1] + 0.02));
    await page.keyboard.press("Tab");
    await settled();
    assert.match(await undoName(), /^move /);
    const [edited, moved] = [await hash(), await joints()];
    assert.notEqual(edited, plain);
    const project = await downloaded("#save-project");
    await go("skeleton");
    await page.keyboard.press("Control+z");
    await settled();
    assert.deepEqual([await hash(), await joints()], [plain, first]);
    await give(made(project.name, project.bytes));
    assert.equal(await hash(), edited);
    assert.deepEqual((await joints()).map(({ name, position }) => ({ name, position })), moved.map(({ name, position }) => ({ name, position })));
  });

  await step("a new file has none of the wishes of the one before; a tab has its own", async () => {
    const wishes = () => page.evaluate(() => Object.fromEntries(["kind", "front", "up", "spine", "mirror", "detail", "softness", "influences", "method", "rigid-parts"].map((id) => [id, document.getElementById(id).value]).concat(["symmetric", "toes", "ends"].map((id) => [id, document.getElementById(id).checked]))));
    const choose = async (id, value) => (await page.selectOption(id, value), await settled());
    await give(file("snake__long.obj"));
    const fresh = await wishes();
    await give(file("biped__robot.obj"), file("bird__winged.obj"));
    await choose("#spine", "3");
    await slide("#softness", 1);
    const [told, was] = [await wishes(), await hash()];
    assert.deepEqual([told.spine, told.softness], ["3", "1"]);
    await page.locator("#characters [role=tab]", { hasText: "bird" }).click();
    await settled();
    assert.deepEqual(await wishes(), fresh, "the other tab");
    await page.locator("#characters [role=tab]", { hasText: "robot" }).last().click();
    await settled();
    assert.deepEqual([await wishes(), await hash()], [told, was], "back at the first tab");
    for (const _ of ["softness", "new skeleton"]) await page.keyboard.press("Control+z");
    await settled();
    assert.deepEqual([(await wishes()).spine, (await wishes()).softness], ["0", "0"], "undo brings the wishes back");
    await give(file("snake__long.obj"));
    assert.deepEqual(await wishes(), fresh, "a new file");
    command("rig", join(data, "snake__long.obj"), "-o", "snake.glb");
    assert.ok((await downloaded("#download")).bytes.equals(readFileSync(at("snake.glb"))), "the page's GLB differs from the command's");
  });

  await step("dropped motions move the character that is open; several are several clips", async () => {
    for (const name of ["squat", "reach"]) command("animate", join(data, "biped__robed.obj"), "--motion", `builtin:${name}`, "-o", `${name}.bvh`);
    await give(made("robot.obj", readFileSync(at("robot.obj"))));
    await give(fileOf(at("squat.bvh")), fileOf(at("reach.bvh")));
    assert.equal(await errorLine(), "");
    assert.equal(await page.evaluate(() => sinewPage.step), "motion");
    assert.equal(await clips(), 2);
    command("animate", "robot.obj", "--motion", "squat.bvh", "--motion", "reach.bvh", "-o", "both.glb");
    assert.ok((await downloaded("#download")).bytes.equals(readFileSync(at("both.glb"))), "the page's GLB differs from the command's");
    // A file with a body: its motion, where motions are worked on. An archive is what is in it.
    command("animate", "robot.obj", "--motion", "reach.bvh", "-o", "moving.glb");
    execFileSync("python3", ["-c", "import zipfile; zipfile.ZipFile('moving.zip', 'w', zipfile.ZIP_DEFLATED).write('moving.glb')"], { cwd: work });
    await give(fileOf(at("moving.zip")));
    assert.equal(await errorLine(), "");
    assert.equal(await clips(), 2, "nothing before the answer");
    assert.deepEqual(await page.locator("#offer button").allInnerTexts(), ["Open it", "Play on robot"]);
    await shoot("offer");
    await page.click("#offer button:has-text('Play on')");
    await settled();
    assert.equal(await clips(), 3);
    assert.deepEqual((await joints()).length > 0 && (await page.evaluate(() => sinewPage.character.name)), "robot");
    await page.locator('#clips li .remove').first().click();
    await settled();
    assert.equal(await clips(), 2);
    await page.keyboard.press("Control+z");
    await settled();
    assert.equal(await clips(), 3);
    await shoot("clips");
  });

  await step("an animated character that is dropped on another one's motions is opened, if that is meant", async () => {
    await give(fileOf(at("moving.glb")));
    await page.click("#offer button:has-text('Open it')");
    await settled();
    assert.equal(await errorLine(), "");
    assert.equal(await page.evaluate(() => sinewPage.character.name), "moving");
    assert.equal(await page.locator("#characters [role=tab]").count(), 2, "the one with three clips is there still");
    await page.locator("#characters [role=tab]").first().click();
    await settled();
    assert.equal(await clips(), 3);
  });

  await step("a pose is no motion: a file with a clip of 0 seconds opens as others do", async () => {
    const glb = readFileSync(at("moving.glb")), length = glb.readUInt32LE(12);
    const json = JSON.parse(glb.subarray(20, 20 + length));
    const times = new Set(json.animations.flatMap(({ samplers }) => samplers.map(({ input }) => input)));
    for (const animation of json.animations) for (const sampler of animation.samplers) for (const of of ["input", "output"]) json.accessors[sampler[of]].count = 1;
    for (const one of times) Object.assign(json.accessors[one], { min: [0], max: [0] });
    const text = Buffer.from(JSON.stringify(json).padEnd(Math.ceil(JSON.stringify(json).length / 4) * 4, " "));
    const out = Buffer.concat([glb.subarray(0, 20), text, glb.subarray(20 + length)]);
    out.writeUInt32LE(out.length, 8);
    out.writeUInt32LE(text.length, 12);
    await go("mesh");
    await give(made("posed.glb", out));
    assert.equal(await errorLine(), "");
    assert.equal(await page.evaluate(() => sinewPage.character.name), "posed");
    assert.deepEqual([await page.evaluate(() => sinewPage.step), await page.isVisible("#timeline")], ["weights", false]);
    await page.locator("#characters [role=tab]", { hasText: "robot" }).first().click();
    await settled();
  });

  await step("an FBX without a mesh is a motion wherever it is dropped", async () => {
    await page.click("#close-motion");
    await go("weights");
    // Bones with a curve and no geometry.
    const bones = strangeFbx().replace(/^ {2}(Geometry|Deformer|Material|Texture): (?:.|\n)*?\n {2}\}\n/gm, "").replace(/^ {2}C: "O[OP]",(1[0-2]|4[01]|5\d|7\d),.*\n/gm, "").replace(/^ {2}C: "OO",\d+,(1[0-2]|5\d|7\d)\n/gm, "");
    writeFileSync(at("bones.fbx"), bones);
    await give(made("bones.fbx", bones));
    assert.equal(await errorLine(), "");
    assert.equal(await page.evaluate(() => sinewPage.character.name), "robot");
    assert.equal(await clips(), 1);
  });

  await step("a mesh that is opened while a motion plays", async () => {
    await go("motion");
    if (await page.isVisible("#close-motion")) await page.click("#close-motion");
    await page.click("#clip-grid [data-clip=walk]");
    await settled();
    if ((await page.locator("#play").innerText()) === "Play") await page.click("#play");
    await page.setInputFiles("#files", [file("snake__long.obj")]);
    await page.waitForFunction(() => sinewPage.character.name === "snake__long");
    await settled();
    assert.equal(await errorLine(), "");
    assert.equal(await page.isVisible("#timeline"), false);
  });

  await step("Space is the button's, the box's, the line's that it is on; else it plays", async () => {
    await give(file("biped__robot.obj"), file("biped__robot.rig.txt"));
    await go("weights");
    await page.focus("#rail [data-step=motion]");
    await page.keyboard.press("Space");
    await settled();
    assert.equal(await page.evaluate(() => sinewPage.step), "motion");
    await page.focus("#clip-grid [data-clip=idle]");
    await page.keyboard.press("Enter");
    await settled();
    assert.equal(await clips(), 1);
    await page.focus("#show-spots");
    await page.keyboard.press("Space");
    assert.equal(await page.isChecked("#show-spots"), false);
    await page.focus("#bending summary");
    const open = await page.locator("#bending").evaluate((one) => one.open);
    await page.keyboard.press("Space");
    assert.equal(await page.locator("#bending").evaluate((one) => one.open), !open);
    const playing = await page.getAttribute("#play", "aria-pressed");
    await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press("Space");
    assert.notEqual(await page.getAttribute("#play", "aria-pressed"), playing);
    await page.keyboard.press("Space");
  });

  await step("a drawing becomes a character and moves", async () => {
    writeFileSync(at("drawing__child.png"), readFileSync(join(data, "drawing__child.png")));
    await give(file("drawing__child.png"));
    assert.equal(await errorLine(), "");
    assert.equal(await page.evaluate(() => sinewPage.step), "motion");
    assert.equal(await clips(), 1);
    command("animate", "drawing__child.png", "-o", "drawing.glb");
    const apart = apartGlbs((await downloaded("#download")).bytes, readFileSync(at("drawing.glb")));
    assert.ok(apart < 1e-5, `the page's GLB is ${apart} off the command's`);
    await page.waitForTimeout(300);
    await shoot("drawing");
  });

  await step("a file of rigid parts is bound, and that is said", async () => {
    const corners = [-0.1, 0.1].flatMap((x) => [0, 0.4].flatMap((y) => [-0.1, 0.1].map((z) => [x, y, z])));
    const faces = [0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1, 2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3];
    const bytes = Buffer.concat([Buffer.from(Float32Array.from(corners.flat()).buffer), Buffer.from(Uint16Array.from(faces).buffer)]);
    const part = (name, more) => ({ name, mesh: 0, translation: [0, 0.4, 0], ...more });
    const gltf = {
      asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: [0] }], nodes: [part("Hips", { children: [1] }), part("Spine", { children: [2] }), part("Head")],
      meshes: [{ name: "box", primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }], skins: [{ joints: [0, 1, 2] }],
      accessors: [{ bufferView: 0, componentType: 5126, count: 8, type: "VEC3", min: corners[0], max: corners[7] }, { bufferView: 1, componentType: 5123, count: 36, type: "SCALAR" }],
      bufferViews: [{ buffer: 0, byteLength: 96 }, { buffer: 0, byteOffset: 96, byteLength: 72 }],
      buffers: [{ byteLength: bytes.length, uri: `data:application/octet-stream;base64,${bytes.toString("base64")}` }],
    };
    await give(made("rigid.gltf", JSON.stringify(gltf)));
    assert.equal(await errorLine(), "");
    assert.match(await page.locator("#remarks").innerText(), /Its 3 rigid parts are attached to bones; here they get skin weights/);
    assert.ok((await hash()).length > 8);
  });

  // The picture's middle, which the body fills: [red, green, blue] each.
  const middle = async () => {
    const png = (await page.locator("#stage > canvas").screenshot()).toString("base64");
    return page.evaluate(async (picture) => {
      const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${picture}`)).blob());
      const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
      context.drawImage(image, 0, 0);
      const { data: values } = context.getImageData(image.width * 0.45, image.height * 0.4, image.width * 0.1, image.height * 0.2);
      return Array.from({ length: values.length / 4 }, (_, i) => [...values.slice(4 * i, 4 * i + 3)]);
    }, png);
  };
  const shareOf = (pixels, is) => pixels.filter(is).length / pixels.length;
  await step("materials keep their colours, and clips stay in the picture", async () => {
    await give(file("biped__caped.gltf"));
    await page.keyboard.press("4");
    await settled();
    await page.waitForTimeout(200);
    const white = shareOf(await middle(), (pixel) => Math.min(...pixel) > 250);
    assert.ok(white < 0.02, `${white} of the body is white`);
    const metal = JSON.parse(readFileSync(join(data, "biped__caped.gltf")));
    metal.materials = [{ pbrMetallicRoughness: { baseColorFactor: [0.8, 0.8, 0.8, 1], metallicFactor: 1, roughnessFactor: 0.4 } }];
    for (const mesh of metal.meshes) for (const primitive of mesh.primitives) primitive.material = 0;
    await give(made("metal.gltf", JSON.stringify(metal)));
    await page.keyboard.press("4");
    await settled();
    await page.waitForTimeout(200);
    const black = shareOf(await middle(), (pixel) => Math.max(...pixel) < 30);
    assert.ok(black < 0.02, `${black} of a body of metal, which mirrors a room, is black`);
    await give(file("biped__caped.gltf"));
    await go("motion");
    await page.click("#clip-grid [data-clip=jump]");
    await settled();
    const stage = await page.locator("#stage").boundingBox();
    for (const share of [0, 0.25, 0.5, 0.75, 1]) {
      await page.locator("#time").evaluate((input, wanted) => {
        input.value = String(Number(input.max) * wanted);
        input.dispatchEvent(new Event("input", { bubbles: true }));
      }, share);
      await settled();
      const places = await page.evaluate(() => sinewPage.character.joints.map((_, j) => sinewPage.view.jointOnScreen(j)));
      const outside = places.filter(({ x, y }) => x < stage.x || x > stage.x + stage.width || y < stage.y || y > stage.y + stage.height);
      assert.deepEqual(outside, [], `${share} of the clip`);
    }
  });

  await step("a finger hits a joint within 24 pixels", async () => {
    await give(file("biped__robot.obj"), file("biped__robot.rig.txt"));
    await page.keyboard.press("f");
    const head = await page.evaluate(() => sinewPage.view.jointOnScreen(sinewPage.character.joints.findIndex(({ name }) => name === "hand.L")));
    await page.evaluate(({ x, y }) => {
      const canvas = document.querySelector("#stage > canvas");
      const init = { clientX: x + 20, clientY: y + 5, pointerId: 7, pointerType: "touch", button: 0, buttons: 1, bubbles: true, isPrimary: true };
      canvas.setPointerCapture = canvas.releasePointerCapture = () => {}; // no pointer of that number is there
      canvas.dispatchEvent(new PointerEvent("pointerdown", init));
      canvas.dispatchEvent(new PointerEvent("pointerup", { ...init, buttons: 0 }));
    }, head);
    await settled();
    assert.match(await page.locator("#joint-name").textContent(), /^hand\.L/);
  });

  await step("a long job is stopped, and nothing is lost", async () => {
    await give(file("biped__robot.obj"), file("biped__robot.rig.txt"));
    await pick("head");
    await page.keyboard.press("x");
    await settled();
    const was = await hash();
    // A body that takes seconds.
    const side = 420;
    const lines = [];
    for (let i = 0; i < side; ++i)
      for (let j = 0; j < side; ++j) {
        const [up, round] = [(Math.PI * (i + 0.5)) / side, (2 * Math.PI * j) / side];
        lines.push(`v ${0.3 * Math.sin(up) * Math.cos(round)} ${1 - Math.cos(up)} ${0.3 * Math.sin(up) * Math.sin(round)}`);
      }
    for (let i = 0; i + 1 < side; ++i)
      for (let j = 0; j < side; ++j) lines.push(`f ${i * side + j + 1} ${(i + 1) * side + j + 1} ${(i + 1) * side + ((j + 1) % side) + 1} ${i * side + ((j + 1) % side) + 1}`);
    await page.setInputFiles("#files", [made("large.obj", lines.join("\n"))]);
    await page.waitForFunction(() => !document.getElementById("busy").hidden);
    await page.keyboard.press("Escape");
    await settled();
    assert.equal(await errorLine(), "");
    assert.equal(await page.evaluate(() => sinewPage.character.name), "biped__robot");
    assert.equal(await hash(), was);
    assert.equal(await undoName(), "switch head");
    await page.keyboard.press("Control+z");
    await settled();
    assert.notEqual(await hash(), was);
  });

  await step("without a network it works on", async () => {
    await page.evaluate(() => navigator.serviceWorker.ready);
    await page.waitForFunction(async () => (await (await caches.open("sinew")).keys()).length > 8);
    server.close();
    await browser.context.setOffline(true);
    await page.goto(server.address);
    await settled();
    assert.equal(await errorLine(), "");
    await give(file("snake__long.obj"));
    assert.equal(await errorLine(), "");
    assert.ok((await joints()).length > 0);
    // What nobody asked for before: fingers, a sample, FBX.
    await page.selectOption("#detail", "2");
    await settled();
    assert.equal(await errorLine(), "");
    await page.selectOption("#sample", "bird__winged");
    await settled();
    assert.equal(await errorLine(), "");
    await go("mesh");
    await give(made("strange.fbx", strangeFbx()));
    assert.equal(await errorLine(), "");
    assert.equal(await page.evaluate(() => sinewPage.character.name), "strange");
    troubles.length = 0; // the browser tells of addresses that it did not reach
  });
  console.log("work: all steps ok");
} finally {
  await browser.close();
  server.close();
}
