// SPDX-License-Identifier: MIT
// FBX and COLLADA on the page are what the command makes of them, byte for byte: meshes that share a skeleton, clusters that move nothing, units,
// axes, pictures beside the file, blend shapes, animations, files that cannot be read. In a headless Chromium.
//   scenes_test.mjs DIST_DIR SOURCE_DIR WORK_DIR SINEW_COMMAND
import assert from "node:assert/strict";
import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { made, startPage } from "./page.mjs";
import { strangeDae, strangeFbx } from "./scene_files.mjs";

const { source, work, server, browser, page, command, remarks, settled, shoot, errorLine, joints, give, downloaded, go, step } = await startPage("scenes_");
rmSync(work, { recursive: true, force: true }); // pictures of the last time would be found
mkdirSync(work);
const picture = Buffer.from("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8/5+hHgAHggJ/PchI7wAAAABJRU5ErkJggg==", "base64");
const line = (run) => {
  try {
    run();
  } catch (error) {
    return String(error.stderr).trim().replace(/^sinew: (error: )?/, "");
  }
  return "";
};
const asked = [];
page.on("request", (request) => asked.push(request.url().split("/").pop()));

// The page's GLB of a file is the command's, with what lies beside it.
async function same(name, content, ...beside) {
  for (const [one, bytes] of [[name, content], ...beside]) writeFileSync(join(work, one), bytes);
  command("bind", name, "-o", "command.glb");
  await go("mesh"); // where motions are worked on it would move the character that is open
  await give(...[[name, content], ...beside].map(([one, bytes]) => made(one, bytes)));
  assert.equal(await errorLine(), "", name);
  if (await page.locator("#close-motion").isVisible()) await page.click("#close-motion"); // its own clips are in the file anyway
  await settled();
  const { bytes } = await downloaded("#download");
  const expected = readFileSync(join(work, "command.glb"));
  assert.ok(bytes.equals(expected), `${name}: ${bytes.length} bytes, the command's ${expected.length}`);
  for (const [one] of beside) rmSync(join(work, one));
  return JSON.parse(bytes.subarray(20, 20 + bytes.readUInt32LE(12)));
}

try {
  await step("what reads them is fetched when the first one is there", async () => {
    await page.goto(`${server.address}?sample=biped__robot`);
    await settled();
    assert.deepEqual(asked.filter((name) => name.includes("scenes")), []);
  });

  await step("two meshes of one skeleton, one without weights, a blend shape, an animation, a picture that is not there", async () => {
    const gltf = await same("strange.fbx", strangeFbx());
    assert.ok(asked.includes("sinew-scenes.wasm.zlib"));
    assert.deepEqual((await joints()).map(({ name }) => name).filter((name) => name !== "rig"), ["hip", "knee", "tip"], "shared joints stay one");
    assert.deepEqual(gltf.meshes.map(({ name }) => name), ["body", "coat", "lamp"]);
    assert.equal(gltf.meshes[0].primitives[0].targets.length, 1, "the blend shape");
    assert.equal(gltf.animations?.length, 1, "the animation");
    assert.equal(gltf.images, undefined);
    assert.match(await remarks(), /strange\.fbx: picture 'skin\.png' was not found, so the output lacks it/);
    await shoot("strange");
  });

  await step("the picture is used where it was dropped beside", async () => {
    const gltf = await same("dressed.fbx", strangeFbx(), ["skin.png", picture]);
    assert.equal(gltf.images.length, 1);
    assert.equal(await remarks(), "");
  });

  await step("and not by the next character", async () => {
    assert.equal((await same("again.fbx", strangeFbx())).images, undefined);
    assert.match(await remarks(), /again\.fbx: picture 'skin\.png' was not found, so the output lacks it/);
  });

  await step("metres, Y up: 1.83 of them stay 1.83", async () => {
    await same("metres.fbx", strangeFbx({ unit: 100, up: "y", size: 1.83 }));
    const points = await page.evaluate(() => sinewPage.view.shown("positions"));
    assert.ok(Math.abs(Math.max(...points.filter((_, i) => i % 3 === 1)) - 1.83) < 1e-4);
  });

  await step("inches", () => same("inches.fbx", strangeFbx({ unit: 2.54, size: 72 })));

  await step("COLLADA", () => same("strange.dae", strangeDae(), ["skin.png", picture]));

  await step("the motion of an FBX for another character", async () => {
    await page.selectOption("#sample", "biped__robed");
    await settled();
    writeFileSync(join(work, "motion.fbx"), strangeFbx());
    await page.setInputFiles("#motion-files", [made("motion.fbx", strangeFbx())]);
    await settled();
    const expected = line(() => command("animate", join(source, "samples/data/biped__robed.obj"), "--motion", "motion.fbx", "--force", "-o", "moved.glb")); // the page plays what the command refuses
    const found = await errorLine();
    assert.equal(found === "", expected === "", `${found} / ${expected}`); // three joints may be too few for a map: then the page says so too
    await page.keyboard.press("Escape");
  });

  await step("files that cannot be read say what the command says", async () => {
    const before = (await joints()).map(({ name }) => name);
    for (const [name, content] of [["broken.fbx", "no fbx"], ["empty.fbx", ""], ["broken.dae", "<COLLADA>"], ["cut.fbx", strangeFbx().slice(0, 3000)]]) {
      writeFileSync(join(work, name), content);
      const expected = line(() => command("bind", name, "-o", "broken.glb"));
      await give(made(name, content));
      assert.notEqual(expected, "", name);
      assert.equal(await errorLine(), expected, name);
      await page.keyboard.press("Escape");
    }
    assert.deepEqual((await joints()).map(({ name }) => name), before, "the page is as it was");
  });
  await step("geometry that Draco or meshoptimizer has compressed is unpacked, and what they cannot read is said", async () => {
    // The same but for how whole numbers are written.
    const parsed = (glb) => [JSON.parse(glb.subarray(20, 20 + glb.readUInt32LE(12))), glb.subarray(28 + glb.readUInt32LE(12))];
    for (const name of ["draco.glb", "meshopt.glb"]) {
      writeFileSync(join(work, name), readFileSync(join(source, "tests/fuzz/corpus/glb", name)));
      command("bind", name, "-o", "command.glb");
      await give(made(name, readFileSync(join(work, name))));
      assert.equal(await errorLine(), "", name);
      assert.deepEqual(parsed((await downloaded("#download")).bytes), parsed(readFileSync(join(work, "command.glb"))), name);
    }
    const damaged = readFileSync(join(source, "tests/fuzz/corpus/glb/draco.glb"));
    damaged.fill(0, damaged.indexOf("DRACO") + 5, damaged.indexOf("DRACO") + 40);
    await give(made("damaged.glb", damaged));
    assert.match(await errorLine(), /^damaged\.glb: its geometry is compressed by Draco and could not be unpacked \(.+\)\. Export it without compression$/);
    await page.keyboard.press("Escape");
  });
} finally {
  await browser.close();
  server.close();
}
