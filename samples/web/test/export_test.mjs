// SPDX-License-Identifier: MIT
// What the page's files are for other programs, in a headless Chromium: sizes that are read back, licenses that stay, avatars that stand on the floor, parts
// that are where the file's own skin does not put them.
//   export_test.mjs DIST_DIR SOURCE_DIR WORK_DIR SINEW_COMMAND
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileOf, made, startPage } from "./page.mjs";

const { data, server, browser, page, at, command, file, settled, shoot, errorLine, remarks, give, downloaded, go, choose, step } = await startPage("export_");
const jsonOf = (glb) => JSON.parse(glb.subarray(20, 20 + glb.readUInt32LE(12)));
const height = async () => Number(await page.locator("#height").inputValue());
// The lowest and the highest vertex of a GLB, by its accessors.
const reachOf = (glb) => {
  const json = jsonOf(glb);
  const all = json.meshes.flatMap(({ primitives }) => primitives.map(({ attributes }) => json.accessors[attributes.POSITION]));
  return [Math.min(...all.map(({ min }) => min[1])), Math.max(...all.map(({ max }) => max[1]))];
};

try {
  await page.goto(server.address);
  await settled();

  await step("an FBX is as large as the character", async () => {
    await give(file("biped__robed.obj"), file("biped__robed.rig.txt"));
    const tall = await height();
    const { bytes } = await downloaded("#download-fbx");
    await go("mesh");
    await give(made("back.fbx", bytes));
    assert.equal(await errorLine(), "");
    assert.ok(Math.abs((await height()) / tall - 1) < 1e-3, `${await height()} m of ${tall} m`);
    // Programs that go by the numbers alone find centimeters, which is the file's unit.
    writeFileSync(at("back.fbx"), bytes);
    command("bind", "back.fbx", "-o", "back.glb");
    const [low, high] = reachOf(readFileSync(at("back.glb")));
    assert.ok(Math.abs((high - low) / (100 * tall) - 1) < 1e-3, `${high - low} cm of ${tall} m by the command`);
  });

  await step("a VRM keeps its author, and what its license forbids is not done", async () => {
    writeFileSync(at("robot.obj"), readFileSync(join(data, "biped__robot.obj")));
    command("rig", "robot.obj", "--for", "vrm", "--author", "Ada", "--licence", "modification=prohibited,commercialUsage=corporation", "-o", "ada.vrm");
    await give(fileOf(at("ada.vrm")));
    assert.equal(await errorLine(), "");
    await choose("vrm");
    assert.equal(await page.locator("#license-said").innerText(), "By Ada; that stays in the file. Its license forbids changing it.");
    await page.click("#onward");
    await settled();
    assert.match(await errorLine(), /license of this VRM forbids changing it/);
    await shoot("license");
    await page.check("#license-mine");
    const { meta } = jsonOf((await downloaded("#onward")).bytes).extensions.VRMC_vrm;
    assert.deepEqual([meta.authors, meta.modification, meta.commercialUsage], [["Ada"], "prohibited", "corporation"]);
  });

  await step("a VRM without an author asks who made it", async () => {
    await give(file("biped__robot.obj"));
    await choose("vrm");
    await page.click("#onward");
    await settled();
    assert.equal(await errorLine(), "VRM needs an author. Who made this character?");
    assert.equal(await page.evaluate(() => document.activeElement.id), "author");
    await page.keyboard.type("Grace");
    assert.deepEqual(jsonOf((await downloaded("#onward")).bytes).extensions.VRMC_vrm.meta.authors, ["Grace"]);
  });

  await step("a VRM stands on the floor, and that is said", async () => {
    const sunk = readFileSync(join(data, "biped__robot.obj"), "utf8").replace(/^v (\S+) (\S+) /gm, (_, x, y) => `v ${x} ${Number(y) - 0.9} `);
    await give(made("sunk.obj", sunk));
    await page.click("#clip-grid [data-clip=walk]");
    await settled();
    await choose("vrm");
    await page.fill("#author", "Grace");
    const { bytes } = await downloaded("#onward");
    const [low] = reachOf(bytes);
    assert.ok(Math.abs(low) < 0.01, `its feet are at ${low}`);
    assert.match(await remarks(), /stood 0\.\d+ m below the floor; in the VRM it stands on it/);
    const hips = jsonOf(bytes).nodes.find(({ name }) => /hips/i.test(name));
    assert.ok(hips.translation[1] > 0.3, "its hips went along");
  });

  await step("parts that are not where the file's own skin puts them are told before they are saved", async () => {
    const gltf = JSON.parse(readFileSync(join(data, "biped__caped.gltf")));
    await give(made("right.gltf", JSON.stringify(gltf)));
    assert.equal(await page.evaluate(() => document.getElementById("misplaced").hidden), true);
    // The upper fifth of the body once more, by the same skin, at the feet.
    const [{ attributes, indices, ...more }] = gltf.meshes[0].primitives;
    const read = (accessor, width, get) => {
      const { bufferView, byteOffset = 0, count } = gltf.accessors[accessor], view = gltf.bufferViews[bufferView];
      const whole = Buffer.from(gltf.buffers[view.buffer].uri.split(",")[1], "base64"), start = (view.byteOffset ?? 0) + byteOffset;
      return Array.from({ length: count }, (_, i) => get(whole, start + i * (view.byteStride ?? width)));
    };
    const add = (bytes, accessor) => {
      gltf.buffers.push({ byteLength: bytes.length, uri: `data:application/octet-stream;base64,${bytes.toString("base64")}` });
      gltf.bufferViews.push({ buffer: gltf.buffers.length - 1, byteLength: bytes.length });
      return gltf.accessors.push({ ...accessor, bufferView: gltf.bufferViews.length - 1, byteOffset: 0 }) - 1;
    };
    const position = gltf.accessors[attributes.POSITION], { min, max } = position;
    const places = read(attributes.POSITION, 12, (bytes, i) => [0, 4, 8].map((x) => bytes.readFloatLE(i + x)));
    const isWide = gltf.accessors[indices].componentType === 5125;
    const corners = read(indices, isWide ? 4 : 2, (bytes, i) => (isWide ? bytes.readUInt32LE(i) : bytes.readUInt16LE(i)));
    const upper = corners.filter((_, i) => [0, 1, 2].every((c) => places[corners[i - (i % 3) + c]][1] > max[1] - 0.2 * (max[1] - min[1])));
    const fall = 0.8 * (max[1] - min[1]);
    const fallen = add(Buffer.from(Float32Array.from(places.flatMap(([x, y, z]) => [x, y - fall, z])).buffer), { ...position, min: [min[0], min[1] - fall, min[2]], max: [max[0], max[1] - fall, max[2]] });
    const some = add(Buffer.from(Uint32Array.from(upper).buffer), { componentType: 5125, count: upper.length, type: "SCALAR" });
    gltf.meshes.push({ name: "hair", primitives: [{ ...more, indices: some, attributes: { ...attributes, POSITION: fallen } }] });
    gltf.nodes.push({ ...gltf.nodes.find(({ mesh }) => mesh === 0), name: "hair", mesh: 1 });
    gltf.scenes[0].nodes.push(gltf.nodes.length - 1);
    await give(made("wrong.gltf", JSON.stringify(gltf)));
    assert.match(await remarks(), /far from the joints that this file's own skin gives/);
    await go("export");
    assert.match(await page.locator("#misplaced").innerText(), /: hair lies far from/);
    await shoot("misplaced");
  });
  console.log("export: all steps ok");
} finally {
  await browser.close();
  server.close();
}
