// SPDX-License-Identifier: MIT
// The page as a studio, in a headless Chromium: joints off and on, locked vertices, every option of a bind, the brush, the file's own look and
// weights, views, poses of several joints, motions to try, FBX in and out, the keyboard alone, a phone's width. Weights are the command's.
//   studio_test.mjs DIST_DIR SOURCE_DIR WORK_DIR SINEW_COMMAND
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { made, startPage } from "./page.mjs";

const { work, data, server, browser, page, command: run, settled, shoot, hash, errorLine, legend, colours, joints, positions, open, pick, give, slide, downloaded, step } = await startPage("studio_");
const command = (name, ...more) => {
  const args = name === "biped__caped" ? [join(data, `${name}.gltf`)] : [join(data, `${name}.obj`), "--skeleton", join(data, `${name}.rig.txt`)];
  return JSON.parse(run("bind", ...args, "-o", "command.glb", "--json", ...more));
};
const jointsAt = () => page.evaluate(() => sinewPage.view.shown("joints"));
// The picture's pixels in the middle, to see that it changed.
const picture = async () => (await page.locator("#stage > canvas").screenshot()).toString("base64");

// How far what three.js skins from the file is from the engine's positions.
const apart = () =>
  page.evaluate(() => {
    // Skinned by three.js from the file, against the engine's positions: the two clouds' boxes.
    const box = (list) => [0, 1, 2].flatMap((axis) => {
      const all = list.map((p) => p[axis]);
      return [Math.min(...all), Math.max(...all)];
    });
    const shown = sinewPage.view.shown("positions");
    const engine = Array.from({ length: shown.length / 3 }, (_, i) => shown.slice(3 * i, 3 * i + 3));
    const three = [];
    const { root } = sinewPage.view.look;
    root.updateMatrixWorld(true);
    root.traverse((object) => {
      if (!object.isMesh) return;
      object.skeleton?.update();
      for (let v = 0; v < object.geometry.getAttribute("position").count; ++v) {
        const p = object.position.clone();
        object.getVertexPosition(v, p).applyMatrix4(object.matrixWorld);
        three.push([p.x, p.y, p.z]);
      }
    });
    const [a, b] = [box(engine), box(three)];
    return Math.max(...a.map((x, i) => Math.abs(x - b[i])));
  });

try {
  await step("joints are switched off and on, as --never has it", async () => {
    await page.goto(`${server.address}?sample=biped__robot`);
    await settled();
    const plain = await hash();
    await pick("forearm.L");
    await page.click("#switch");
    await settled();
    writeFileSync(join(work, "never.txt"), "forearm.L\n");
    assert.equal(await hash(), command("biped__robot", "--never", join(work, "never.txt")).hash);
    assert.deepEqual((await page.locator("#joints li.off .name").allTextContents()).includes("forearm.L"), true);
    assert.equal(await page.locator("#switch").innerText(), "Switch on");
    await shoot("off");
    await page.keyboard.press("x");
    await settled();
    assert.equal(await hash(), plain);
    assert.equal(await page.locator("#joints li.off", { hasText: /^forearm\.L/ }).count(), 0);
  });

  await step("every option of a bind is the command's", async () => {
    const plain = await hash();
    for (const [id, value, ...more] of [
      ["#rigid-parts", "1", "--rigid-parts", "always"],
      ["#influences", "2", "--influences", "2"],
      ["#influences", "8", "--influences", "8"],
      ["#method", "1", "--method", "heat"],
    ]) {
      const before = await page.inputValue(id);
      await page.selectOption(id, value);
      await settled();
      assert.equal(await hash(), command("biped__robot", ...more).hash, more.join(" "));
      await page.selectOption(id, before);
      await settled();
    }
    await slide("#softness", 1);
    assert.equal(await hash(), command("biped__robot", "--softness", "2").hash);
    await slide("#softness", 0);
    await page.check("#symmetric");
    await settled();
    assert.equal(await hash(), command("biped__robot", "--symmetric").hash);
    await shoot("options");
    await page.uncheck("#symmetric");
    await settled();
    assert.equal(await hash(), plain);
  });

  await step("what is locked keeps its weights", async () => {
    await open("quadruped__tailed");
    await pick("head");
    await page.keyboard.press("l");
    await settled();
    assert.match(await page.locator("#facts").textContent(), /locked [\d,]+ vertices/);
    const strongest = await page.evaluate(() => Array.from(sinewPage.character.result.strongest));
    const head = (await joints()).findIndex(({ name }) => name === "head");
    const field = async () => {
      const values = await colours();
      return strongest.flatMap((joint, i) => (joint === head ? values.slice(3 * i, 3 * i + 3) : []));
    };
    const before = await field();
    await page.selectOption("#method", "1");
    await settled();
    const apart = (await field()).map((x, i) => Math.abs(x - before[i]));
    assert.ok(before.length > 300 && Math.max(...apart) < 0.02, "the head's field is as it was");
    await shoot("locked");
    await page.selectOption("#method", "0");
    await settled();
    await page.keyboard.press("Escape");
    await pick("head");
    await page.click("#lock");
    await settled();
    assert.doesNotMatch(await page.locator("#facts").textContent(), /locked/);
  });

  await step("a brush changes the weights around it, and is a hint", async () => {
    await open("biped__robed");
    const plain = await hash();
    await pick("head");
    await page.keyboard.press("b");
    assert.equal(await page.locator("#brush-kind input:checked").inputValue(), "add");
    const before = await colours();
    const at = await page.evaluate((j) => sinewPage.view.jointOnScreen(j), (await joints()).findIndex(({ name }) => name === "chest"));
    await page.mouse.move(at.x, at.y);
    await page.mouse.down();
    await page.mouse.move(at.x + 12, at.y, { steps: 4 });
    await page.mouse.up();
    await settled();
    assert.equal(await errorLine(), "");
    assert.match(await page.locator("#painted").innerText(), /[\d,]+ vertices/);
    assert.notEqual(await hash(), plain);
    const after = await colours();
    const changed = after.filter((x, i) => Math.abs(x - before[i]) > 0.02).length / after.length;
    assert.ok(changed > 0.005 && changed < 0.6, `${changed} of the colours changed`);
    await shoot("painted");
    await page.keyboard.press("b");
    assert.equal(await page.locator("#brush-kind input:checked").inputValue(), "smooth");
    const painted = await hash();
    await page.mouse.move(at.x - 5, at.y);
    await page.mouse.down();
    await page.mouse.move(at.x + 20, at.y + 8, { steps: 3 });
    await page.mouse.up();
    await settled();
    assert.notEqual(await hash(), painted, "smoothing changes it");
    await page.keyboard.press("b");
    await page.click("#forget-paint");
    await settled();
    assert.equal(await hash(), plain, "forgotten, the weights are the bind's");
  });

  await step("every state of a painted character comes back as it was", async () => {
    await open("biped__robed");
    await pick("head");
    await page.click("#brush-kind label:has-text('Add')");
    const at = await page.evaluate((j) => sinewPage.view.jointOnScreen(j), (await joints()).findIndex(({ name }) => name === "chest"));
    const hashes = [await hash()];
    const note = async () => (await settled(), hashes.push(await hash()));
    await page.mouse.move(at.x, at.y);
    await page.mouse.down();
    await page.mouse.move(at.x + 12, at.y, { steps: 4 });
    await page.mouse.up();
    await note();
    await page.selectOption("#influences", "2");
    await note();
    await pick("forearm.L");
    await page.keyboard.press("l");
    await note();
    await slide("#softness", 1);
    await note();
    await page.selectOption("#influences", "1");
    await note();
    assert.ok(new Set(hashes).size >= hashes.length - 1, `all steps but the lock change weights: ${hashes}`);
    for (const key of ["Control+z", "Control+y", "Control+z"]) {
      const back = key === "Control+z", seen = [hashes[back ? hashes.length - 1 : 0]];
      for (let i = 1; i < hashes.length; ++i) {
        await page.keyboard.press(key);
        await settled();
        seen.push(await hash());
      }
      assert.deepEqual(back ? seen.reverse() : seen, hashes, key);
    }
    await page.click("#brush-kind label:has-text('No brush')");
  });

  await step("the file's weights and the difference", async () => {
    assert.equal(await page.isVisible("#artist"), true, "a rig.txt with skin lines has weights");
    await page.keyboard.press("Escape");
    await page.locator("#artist label", { hasText: "Difference" }).click();
    await settled();
    const said = await legend();
    const share = Number(said.match(/([\d.]+) %/)[1]) / 100;
    assert.ok(share > 0 && share < 0.5, said);
    await shoot("difference");
    const ours = await colours();
    await page.keyboard.press("5");
    await settled();
    assert.equal(await legend(), "The weights in the file");
    assert.notDeepEqual(await colours(), ours);
    await pick("head");
    assert.equal(await legend(), "Weight of head in the file");
    await shoot("artist");
    await page.keyboard.press("1");
    await settled();
    await open("biped__robed, a bare mesh");
    assert.equal(await page.isVisible("#artist"), false);
  });

  await step("materials: the file as other programs show it, in every pose", async () => {
    await open("biped__caped");
    await page.keyboard.press("4");
    await settled();
    assert.equal(await legend(), "As other programs show it");
    const rest = await picture();
    await shoot("material");
    await pick("upper_arm.L");
    await slide("#turn-z", 60);
    await page.waitForTimeout(200);
    const farthest = await apart();
    assert.ok(farthest < 1e-3, `three.js and the engine are ${farthest} apart`);
    assert.notEqual(await picture(), rest);
    await shoot("material_posed");
    await page.click("#reset");
    await page.keyboard.press("1");
    await settled();
  });

  await step("a file that was saved in the middle of a motion is shown in the pose that its weights were made in", async () => {
    const glb = (await downloaded("#download")).bytes, length = glb.readUInt32LE(12);
    const json = JSON.parse(glb.subarray(20, 20 + length)), binary = glb.subarray(28 + length);
    for (const joint of json.skins[0].joints) json.nodes[joint].rotation = [0, 0.1, Math.sqrt(0.5), 0.7]; // no joint is left as it was bound
    const root = json.nodes[json.skins[0].joints[0]];
    root.translation = root.translation.map((x) => x + 0.3);
    const text = Buffer.from(JSON.stringify(json));
    const head = Buffer.alloc(20), chunk = Buffer.alloc(8), padded = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, " ")]);
    [0x46546c67, 2, 28 + padded.length + binary.length, padded.length, 0x4e4f534a].forEach((word, i) => head.writeUInt32LE(word, 4 * i));
    [binary.length, 0x004e4942].forEach((word, i) => chunk.writeUInt32LE(word, 4 * i));
    await give(made("moved.glb", Buffer.concat([head, padded, chunk, binary])));
    assert.equal(await errorLine(), "");
    await page.keyboard.press("4");
    await settled();
    const farthest = await apart();
    assert.ok(farthest < 1e-3, `three.js and the engine are ${farthest} apart`);
    await page.keyboard.press("1");
    await settled();
  });

  await step("views, wireframe and the size of bones", async () => {
    await page.keyboard.press("Escape");
    const pictures = new Set([await picture()]);
    for (const key of ["7", "8", "9"]) {
      await page.keyboard.press(key);
      await page.waitForTimeout(100);
      pictures.add(await picture());
      await shoot(`view_${key}`);
    }
    await page.keyboard.press("f");
    await page.keyboard.press("w");
    assert.equal(await page.getAttribute("#wireframe", "aria-pressed"), "true");
    await page.waitForTimeout(100);
    pictures.add(await picture());
    await slide("#bone-size", 3);
    await page.waitForTimeout(100);
    pictures.add(await picture());
    await shoot("wire");
    assert.equal(pictures.size, 6, "each is another picture");
    await page.keyboard.press("w");
    await slide("#bone-size", 1);
  });

  await step("several joints at once, and both sides mirrored", async () => {
    await open("biped__robot");
    const rest = await jointsAt();
    const list = await joints();
    const number = (name) => list.findIndex((joint) => joint.name === name);
    await page.check("#mirror-pose");
    await pick("upper_arm.L");
    await slide("#turn-z", 40);
    const posed = await jointsAt();
    const [left, right] = [number("hand.L"), number("hand.R")];
    const plane = (rest[3 * left] + rest[3 * right]) / 2;
    assert.ok(Math.abs(posed[3 * left + 1] - rest[3 * left + 1]) > 0.05, "the left hand moved");
    assert.ok(Math.abs(posed[3 * left] + posed[3 * right] - 2 * plane) < 0.02 && Math.abs(posed[3 * left + 1] - posed[3 * right + 1]) < 0.02, "the right one is its mirror image");
    await shoot("mirrored");
    await page.uncheck("#mirror-pose");
    await page.click("#reset");
    await settled();
    await pick("upper_arm.L");
    await pick("upper_arm.R", ["Control"]);
    assert.match(await page.locator("#joint-name").innerText(), /and 1 more/);
    await slide("#turn-x", 20);
    const turns = await page.locator("#turn-x + output").innerText();
    assert.equal(turns, "20°");
    await shoot("several");
    await page.click("#reset");
    await page.keyboard.press("Escape");
  });

  await step("motions to try", async () => {
    for (const [name, title] of [["walk", "Walk"], ["squat", "Squat"], ["reach", "Reach"]]) {
      await page.reveal("#clip-grid");
      await page.locator("#clip-grid button", { hasText: new RegExp(`^${title}$`) }).click();
      await settled();
      assert.equal(await errorLine(), "");
      assert.equal(await page.locator(`#clip-grid [data-clip="${name}"]`).getAttribute("aria-pressed"), "true");
      assert.match(await page.locator("#motion-about").innerText(), new RegExp(`^${name}: moves \\d+ of \\d+ bones`));
      await page.locator("#time").evaluate((input) => {
        input.value = String(Number(input.max) * 0.45);
        input.dispatchEvent(new Event("input", { bubbles: true }));
      });
      await settled();
      await shoot(`clip_${name}`);
    }
    assert.equal(await page.locator("#clips li").count(), 3, "all of them are there");
    const rest = await page.evaluate(() => sinewPage.character.joints.map(({ position }) => position));
    const now = await jointsAt();
    const hand = (await joints()).findIndex(({ name }) => name === "hand.L");
    assert.ok(now[3 * hand + 1] > rest[hand][1] + 0.2, "the arms are up");
    await page.click("#close-motion");
    await settled();
  });

  await step("FBX out, and in again", async () => {
    await open("biped__caped");
    const { name, bytes } = await downloaded("#download-fbx");
    assert.equal(name, "biped__caped.bound.fbx");
    assert.equal(bytes.subarray(0, 18).toString(), "Kaydara FBX Binary");
    run("bind", join(data, "biped__caped.gltf"), "-o", "caped.fbx");
    assert.ok(bytes.equals(readFileSync(join(work, "caped.fbx"))), "the page's FBX differs from the command's");
    const names = (await joints()).map(({ name }) => name);
    const height = async () => {
      const heights = (await positions()).filter((_, i) => i % 3 === 1);
      return Math.max(...heights) - Math.min(...heights);
    };
    const before = await height();
    await give(made("again.fbx", bytes));
    assert.equal(await errorLine(), "");
    const after = await joints();
    assert.deepEqual(new Set(after.map(({ name }) => name)), new Set(names), "the same joints");
    assert.equal(await page.evaluate(() => sinewPage.character.hasReference), true, "with weights");
    assert.ok(Math.abs((await height()) / before - 1) < 1e-4, `${before} high, read back ${await height()}`);
    await page.keyboard.press("6");
    await settled();
    await shoot("fbx");
    await give(made("broken.fbx", "no fbx"));
    assert.match(await errorLine(), /^broken\.fbx: expected FBX, found a file that Assimp does not read/);
    await page.keyboard.press("Escape");
    assert.deepEqual((await joints()).map(({ name }) => name), after.map(({ name }) => name), "the page is as it was");
  });

  await step("by the keyboard alone", async () => {
    await open("biped__robot");
    const reached = new Set();
    await page.focus("#joints");
    await page.keyboard.press("b"); // its settings
    await pick("head");
    await page.keyboard.press("x"); // a step to undo
    await settled();
    await page.focus("#help");
    for (let i = 0; i < 120; ++i) {
      await page.keyboard.press("Tab");
      reached.add(await page.evaluate(() => document.activeElement.id || document.activeElement.name || document.activeElement.tagName));
    }
    const wanted = ["view-front", "view-top", "wireframe", "bone-size", "skeleton", "mode", "joints", "brush", "brush-size", "undo", "download", "SUMMARY"];
    assert.deepEqual(wanted.filter((id) => !reached.has(id)), [], "the tabulator reaches all of them");
    await page.focus("#joints");
    for (let i = 0; i < 2; ++i) await page.keyboard.press("b");
  });

  await step("on a phone's width", async () => {
    await page.setViewportSize({ width: 390, height: 844 });
    await settled();
    await page.waitForTimeout(200);
    const wide = await page.evaluate(() => ({ page: document.documentElement.scrollWidth, window: innerWidth }));
    assert.ok(wide.page <= wide.window, `nothing sticks out: ${wide.page} of ${wide.window}`);
    const outside = await page.evaluate(() =>
      [...document.querySelectorAll("header > button, #rail button, #tools button, #view-switch label, #panel button, #panel select, #panel input")]
        .filter((one) => one.offsetParent)
        .filter((one) => one.getBoundingClientRect().right > innerWidth + 1 || one.getBoundingClientRect().left < -1)
        .map((one) => one.id || one.textContent),
    );
    assert.deepEqual(outside, []);
    await shoot("phone");
  });
  console.log("studio: all steps ok");
} finally {
  await browser.close();
  server.close();
}
