// SPDX-License-Identifier: MIT
// The page in a real headless Chromium: samples bind to the native hashes with and without SIMD, joints turn, bare meshes get skeletons
// that are edited, GLB and rig.txt are the command's to the last byte, and whatever is wrong with a file is said in one line. Leaves screenshots to look at.
//   page_test.mjs DIST_DIR SOURCE_DIR WORK_DIR SINEW_COMMAND
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { launch, serve } from "./browser.mjs";
import { fileOf, made, newPage, pageTools } from "./page.mjs";

const [dist, source, work, sinew] = process.argv.slice(2).map((path) => resolve(path));
const data = join(source, "samples/data");
mkdirSync(work, { recursive: true });
// What the command binds each sample to; without one, nothing to compare with.
const rigOf = (name) => (existsSync(join(data, `${name}.rig.txt`)) ? ["--skeleton", join(data, `${name}.rig.txt`)] : []);
const native = new Map(
  readdirSync(data).filter((name) => /\.(obj|gltf)$/.test(name)).map((name) => {
    const stem = name.replace(/\.(obj|gltf)$/, "");
    const summary = execFileSync(sinew, ["bind", join(data, name), ...rigOf(stem), "-o", join(work, `${stem}.native.glb`), "--json"], { stdio: "pipe" });
    return [stem, JSON.parse(summary).hash];
  }),
);

// What the command does with a sample and further arguments: its summary.
function command(name, ...more) {
  const mesh = join(data, `${name}.${existsSync(join(data, `${name}.obj`)) ? "obj" : "gltf"}`);
  const out = join(work, `${name}.command.glb`);
  const summary = execFileSync(sinew, ["bind", mesh, ...rigOf(name), "-o", out, "--json", ...more], { stdio: "pipe" });
  return { ...JSON.parse(summary), glb: out };
}
// What the command makes of a bare mesh: its summary, and the bytes of both files.
function rigged(mesh, ...more) {
  const glb = join(work, "command.rigged.glb");
  const rig = join(work, "command.rig.txt");
  const summary = execFileSync(sinew, ["rig", mesh, "-o", glb, "--json", ...more], { stdio: "pipe" });
  execFileSync(sinew, ["rig", mesh, "-o", rig, ...more], { stdio: "pipe" });
  return { ...JSON.parse(summary), glb: readFileSync(glb), rig: readFileSync(rig, "utf8") };
}
// Thirty frames in a second, as BVH: the left upper arm turns about z, the root goes along z.
function wave(rig) {
  const children = (name) => rig.filter((joint) => joint.parent === name);
  const order = [];
  const lines = ["HIERARCHY"];
  const add = (joint, from, keyword) => {
    order.push(joint.name);
    lines.push(`${keyword} ${joint.name}`, "{", `OFFSET ${joint.position.map((x, i) => x - from[i]).join(" ")}`);
    lines.push(keyword === "ROOT" ? "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation" : "CHANNELS 3 Zrotation Xrotation Yrotation");
    const below = children(joint.name);
    for (const child of below.filter(({ end }) => !end)) add(child, joint.position, "JOINT");
    if (below.every(({ end }) => end)) lines.push("End Site", "{", `OFFSET ${below.length ? below[0].position.map((x, i) => x - joint.position[i]).join(" ") : "0 0 0.1"}`, "}");
    lines.push("}");
  };
  const root = rig.find(({ parent }) => parent === "");
  add(root, [0, 0, 0], "ROOT");
  lines.push("MOTION", "Frames: 31", "Frame Time: 0.0333333");
  for (let f = 0; f <= 30; ++f) {
    const place = [root.position[0], root.position[1], root.position[2] + 0.01 * f];
    lines.push([...place, ...order.flatMap((name) => [name === "LeftArm" ? 2 * f : 0, 0, 0])].join(" "));
  }
  return lines.join("\n");
}
const nativeQuestions = new Map([...native.keys()].map((name) => [name, command(name, "--questions", "8").questions]));

const server = await serve(dist);
const browser = await launch();
const troubles = [];
const asked = []; // addresses
let page;

async function openPage(query, size) {
  page = await newPage(browser, troubles);
  await page.emulateMedia({ reducedMotion: "reduce" }); // bare meshes stand: first_test.mjs lets them walk
  if (size) await page.setViewportSize(size);
  page.on("request", (request) => asked.push(request.url()));
  await page.goto(server.address + query);
  await settled();
}
const { settled, shoot, errorLine, hash, legend, colours, positions, joints, pick, give, downloaded, go, step } = pageTools(() => page, { troubles, work });
const fact = (start) => page.locator("#facts > span", { hasText: start }).textContent();
// The page's questions as the command's --json has them.
const pageQuestions = () =>
  page.evaluate(() =>
    sinewPage.character.result.questions.map(({ members, mesh, alternatives, ...question }) => ({
      ...question,
      alternatives: alternatives.map(({ answer, change }) => ({ answer, change })),
    })),
  );
const partName = (q) => `${q.parts > 1 ? "parts" : "part"} near ${q.joint}`;
const answerText = (answer) => (answer.startsWith("rigid:") ? `follow ${answer.slice(6)}` : { soft: "swing", hard: "in pieces", softer: "softer", host: "with the surface below" }[answer]);
const questionText = (q) => `${partName(q)}${q.parts > 1 ? ` · ${q.parts} similar` : ""} · now ${q.share > 0.995 ? "" : `${Math.round(100 * q.share)} % `}with ${q.joint}`;
const question = (part) => page.locator(`#questions li[data-part="${part}"] .question`);
const alternative = (answer) => page.locator("#questions .alternative", { hasText: answerText(answer) });
const focused = () => page.evaluate(() => document.activeElement.getAttribute("aria-label") ?? document.activeElement.textContent);
const mirror = () => page.evaluate(() => ({ axis: sinewPage.character.axis, plane: sinewPage.character.plane }));
const indexes = (list, name) => {
  const at = list.findIndex((joint) => joint.name === name);
  return { at, other: list[at].partner };
};
// Two pictures later: a line below that has grown changes the picture's size first.
const onScreen = (joint) =>
  page.evaluate(async (j) => {
    for (let i = 0; i < 2; ++i) await new Promise(requestAnimationFrame);
    return sinewPage.view.jointOnScreen(j);
  }, joint);
async function drag(joint, x, y) {
  const from = await onScreen(joint);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + x, from.y + y, { steps: 5 });
  await page.mouse.up();
  await settled();
}
// The page's skeleton and files are what the command makes.
async function isTheCommands({ joints: wanted, glb, rig }) {
  const worked = await page.evaluate(() => sinewPage.step);
  const found = await joints();
  assert.deepEqual(
    found.map(({ name, parent, position, end, confidence }) => ({ name, parent: found[parent]?.name ?? "", position: position.map(Math.fround), end, confidence })),
    wanted.map(({ name, parent, position, end, confidence }) => ({ name, parent, position: position.map(Math.fround), end, confidence })),
  );
  assert.ok((await downloaded("#download")).bytes.equals(glb), "the page's GLB differs from the command's");
  assert.equal((await downloaded("#download-rig")).bytes.toString(), rig, "the page's rig.txt differs from the command's");
  await go(worked);
}
const file = (name) => fileOf(join(data, name));

try {
  for (const [query, kernel] of [["?sample=snake__long", "SIMD"], ["?sample=snake__long&scalar", "without SIMD"]]) {
    await step(`every sample has the native hash, ${kernel}`, async () => {
      await openPage(query);
      assert.equal(await errorLine(), "");
      assert.ok((await fact("engine")).endsWith(kernel), await fact("engine"));
      assert.equal(await fact("model"), `model ${(readFileSync(join(data, "sinew_default.sinew")).length / 1e3).toFixed(1)} kB`);
      assert.match(await fact("bound in"), /bound in [\d,.]+ m?s/);
      assert.ok(native.size >= 5);
      for (const [name, want] of native) {
        await page.selectOption("#sample", name);
        await settled();
        assert.equal(await hash(), want, name);
        assert.deepEqual(await pageQuestions(), nativeQuestions.get(name), `${name}: the questions`);
      }
    });
    if (kernel !== "SIMD") await page.close();
  }
  await step("a browser without exceptions for WebAssembly is told so", async () => {
    await browser.context.route("**/worker.js", async (route) => {
      const response = await route.fetch();
      await route.fulfill({ response, body: `WebAssembly.validate = () => false;\n${await response.text()}` });
    });
    await openPage("");
    assert.match(await errorLine(), /^This browser is too old: use Chrome 95, Firefox 100, Safari 15\.2 or newer/);
    await browser.context.unroute("**/worker.js");
    await page.close();
  });
  [page] = browser.context.pages().filter((open) => open.url().includes("?sample=snake__long"));

  await step("a joint shows its field and turns the mesh", async () => {
    await page.selectOption("#sample", "biped__robot");
    await settled();
    await shoot("joints");
    await page.fill("#search", "FOREARM.l");
    assert.deepEqual(await page.locator("#joints li .name").allTextContents(), ["forearm.L"]);
    await page.click("#joints li");
    await settled();
    assert.equal(await page.locator("#legend figcaption").innerText(), "Weight of forearm.L");
    await shoot("field");
    const rest = await positions();
    assert.equal(await page.isDisabled("#reset"), true);
    await page.focus("#turn-z");
    for (let i = 0; i < 40; ++i) await page.keyboard.press("ArrowRight");
    await settled();
    const turned = await positions();
    const moved = turned.filter((x, i) => x !== rest[i]).length / rest.length;
    assert.ok(moved > 0.01 && moved < 0.5, `${moved} of the mesh moved`);
    assert.equal(await page.locator("#turn-z + output").innerText(), "40°");
    await shoot("turned");
    await page.keyboard.press("r");
    await settled();
    assert.deepEqual(await positions(), rest);
    await page.keyboard.press("Control+z");
    await settled();
    assert.deepEqual(await positions(), turned);
    await page.click("#undo"); // the keys' forty steps are one where they follow each other
    await settled();
    assert.notDeepEqual(await positions(), turned);
    if (!(await page.isDisabled("#reset"))) await page.click("#reset");
  });

  await step("the rings' skeleton is the engine's", async () => {
    for (const [joint, axis, keys] of [["upper_arm.L", "y", 25], ["upper_arm.L", "x", 40], ["upper_arm.L", "z", 35], ["forearm.L", "x", 30]]) {
      await page.fill("#search", joint);
      await page.click(`#joints li >> text="${joint}"`);
      await page.focus(`#turn-${axis}`);
      for (let i = 0; i < keys; ++i) await page.keyboard.press("ArrowRight");
    }
    await page.fill("#search", "");
    await settled();
    const apart = await page.evaluate(() => sinewPage.view.largestHandleDistance());
    assert.ok(apart < 1e-4, `${apart} of the character's size apart`);
  });

  await step("a ring dragged by the mouse turns the joint", async () => {
    await page.click("#reset");
    await settled();
    const rest = await positions();
    const { x, y } = await page.evaluate(() => sinewPage.view.jointOnScreen(sinewPage.view.selected));
    // The rings lie around the joint; from the right of it inwards, the first thing that takes the mouse is one.
    let at = null;
    for (let r = 140; r > 20 && !at; r -= 2) {
      await page.mouse.move(x + r, y);
      if (await page.evaluate(() => sinewPage.view.onRing)) at = x + r;
    }
    assert.ok(at !== null, "no ring under the mouse");
    await page.mouse.down();
    await page.mouse.move(at - 10, y - 60, { steps: 6 });
    await page.mouse.up();
    await settled();
    assert.notDeepEqual(await positions(), rest);
    await shoot("ring");
    await page.click("#undo");
    await settled();
    assert.deepEqual(await positions(), rest);
  });

  await step("a click on the picture chooses a joint, a drag orbits", async () => {
    await page.keyboard.press("Escape");
    await settled();
    assert.equal(await page.locator("#joint-name").innerText(), "No bone selected");
    const head = await page.evaluate(() => {
      const joint = sinewPage.character.joints.findIndex(({ name }) => name === "head");
      return sinewPage.view.jointOnScreen(joint);
    });
    await page.mouse.move(head.x, head.y);
    await page.mouse.down();
    await page.mouse.move(head.x + 80, head.y + 10, { steps: 4 });
    await page.mouse.up();
    await settled();
    assert.equal(await page.locator("#joint-name").innerText(), "No bone selected");
    await page.keyboard.press("f");
    await page.mouse.click(head.x, head.y);
    await settled();
    assert.equal(await page.locator("#joint-name").innerText(), "head");
    await page.keyboard.press("s"); // without the skeleton, the surface answers
    await page.keyboard.press("Escape");
    await page.mouse.click(head.x, head.y - 25);
    await settled();
    assert.equal(await page.locator("#joint-name").innerText(), "head");
    await page.keyboard.press("s");
    await page.keyboard.press("3");
    await settled();
    assert.match(await page.locator("#legend figcaption").innerText(), /^Where weights are uncertain/);
    await shoot("doubt");
  });

  await step("the GLB is the command's", async () => {
    for (const [name, files] of [["biped__robot", ["biped__robot.obj", "biped__robot.rig.txt"]], ["biped__caped", ["biped__caped.gltf"]]]) {
      await give(...files.map(file));
      assert.equal(await errorLine(), "");
      const [download] = await Promise.all([page.waitForEvent("download"), page.click("#download")]);
      assert.equal(download.suggestedFilename(), `${name}.bound.glb`);
      const glb = readFileSync(await download.path());
      assert.equal(glb.toString("latin1", 0, 4), "glTF");
      const out = join(work, `${name}.glb`);
      const rig = files[1] ? ["--skeleton", join(data, files[1])] : [];
      execFileSync(sinew, ["bind", join(data, files[0]), ...rig, "-o", out], { stdio: "pipe" });
      assert.ok(glb.equals(readFileSync(out)), `${name}: the page's GLB differs from the command's`);
      // And back in again.
      await give({ name: `${name}.bound.glb`, mimeType: "model/gltf-binary", buffer: glb });
      assert.equal(await errorLine(), "");
      assert.equal(await page.locator("#facts b").first().textContent(), `${name}.bound`);
    }
  });

  await step("a question is shown, its answers previewed, taken and taken back", async () => {
    const name = "biped__robed";
    const [part] = nativeQuestions.get(name).filter(({ parts }) => parts > 1);
    await page.selectOption("#sample", name);
    await settled();
    assert.deepEqual(await page.locator("#questions .question").allTextContents(), nativeQuestions.get(name).map(questionText));
    const plain = await colours();
    await shoot("questions");
    await question(part.part).hover();
    await settled();
    assert.equal(await legend(), `Orange: ${partName(part)}, ${part.vertices} vertices (${part.parts} similar parts)`);
    const orange = await page.evaluate(() => {
      const { vertexOf } = sinewPage.character.buffers;
      const all = sinewPage.view.shown("colours");
      const linear = (c) => ((c / 255 + 0.055) / 1.055) ** 2.4;
      const isOrange = (i) => [240, 120].every((c, axis) => Math.abs(all[3 * i + axis] - linear(c)) < 1e-6);
      return new Set([...vertexOf].filter((_, i) => isOrange(i))).size;
    });
    assert.equal(orange, part.vertices);
    await shoot("question");
    await question(part.part).click();
    const offered = part.alternatives.map(({ answer }) => answer);
    const shares = part.alternatives.map(({ change }) => `${Math.round(50 * change)} %`);
    assert.deepEqual(await page.locator("#questions .alternative").allTextContents(), [...offered.map((a, i) => answerText(a) + shares[i]), "keep as it is"]);
    await alternative(offered[1]).hover();
    await settled();
    assert.equal(await legend(), `Preview: ${partName(part)}: ${answerText(offered[1])} (${part.parts} similar parts)`);
    assert.equal(await hash(), native.get(name), "a preview takes nothing");
    const seen = await colours();
    await shoot("preview");
    // Nothing is written of a preview.
    await alternative(offered[1]).focus();
    await settled();
    const unanswered = join(work, `${name}.native.glb`);
    assert.ok((await downloaded("#download")).bytes.equals(readFileSync(unanswered)), "the GLB has a preview in it");
    await page.mouse.move(300, 300);
    await settled();
    assert.deepEqual(await colours(), plain);

    // By keys alone: down to the second alternative, and take it.
    await question(part.part).focus();
    for (const key of ["ArrowDown", "ArrowDown"]) await page.keyboard.press(key);
    await settled();
    assert.deepEqual(await colours(), seen);
    await page.keyboard.press("Enter");
    await settled();
    const first = `${part.part}=${offered[1]}`;
    const once = command(name, "--questions", "8", "--answer", first);
    assert.equal(await hash(), once.hash);
    assert.notEqual(once.hash, native.get(name));
    assert.deepEqual(await pageQuestions(), once.questions);
    assert.deepEqual(await page.locator("#questions .answered .name").allTextContents(), [`${partName(part)} · ${answerText(offered[1])}`]);
    assert.equal(await focused(), `Take back ${partName(part)}: ${answerText(offered[1])}`);
    assert.deepEqual(await colours(), seen, "taken it looks as its preview");
    await shoot("answered");

    // Another part with a joint that is not among its alternatives.
    const other = once.questions[1];
    const joint = "chest";
    assert.ok(!other.alternatives.some(({ answer }) => answer === `rigid:${joint}`));
    await question(other.part).click();
    await page.locator("#questions .any select").selectOption({ label: joint });
    await settled();
    assert.equal(await legend(), `Preview: ${partName(other)}: follow ${joint}`);
    await page.click("#questions .take");
    await settled();
    const twice = command(name, "--questions", "8", "--answer", first, "--answer", `${other.part}=rigid:${joint}`);
    assert.equal(await hash(), twice.hash);
    assert.ok((await downloaded("#download")).bytes.equals(readFileSync(twice.glb)), "the page's GLB differs from the command's");

    // The answers stay with the character, whatever else it is bound with.
    await page.locator("#up").evaluate((up) => ((up.value = "1"), up.onchange()));
    await settled();
    assert.equal(await page.locator("#questions .answered").count(), 2);
    await page.locator("#up").evaluate((up) => ((up.value = "0"), up.onchange()));
    await settled();
    assert.equal(await hash(), twice.hash);

    // A joint that ends a chain, which gets no weight unless an answer says so.
    await page.selectOption("#sample", "biped__robot");
    await settled();
    const tip = nativeQuestions.get("biped__robot").find(({ joint }) => joint === "head_end");
    await question(tip.part).click();
    if (tip.alternatives.some(({ answer }) => answer === "rigid:head_end")) {
      await alternative("rigid:head_end").click();
    } else {
      await page.locator("#questions .any select").selectOption({ label: "head_end" });
      await page.click("#questions .take");
    }
    await settled();
    assert.equal(await hash(), command("biped__robot", "--answer", `${tip.part}=rigid:head_end`).hash);
    assert.notEqual(await hash(), native.get("biped__robot"));
    await page.selectOption("#sample", name);
    await settled();
    assert.equal(await hash(), native.get(name), "a file that is opened anew has no answers");
    for (const [part, answer] of [[first.split("=")[0], offered[1]], [other.part, joint]]) {
      await question(part).click();
      if (answer === joint) {
        await page.locator("#questions .any select").selectOption({ label: joint });
        await page.click("#questions .take");
      } else {
        await alternative(answer).click();
      }
      await settled();
    }
    assert.equal(await hash(), twice.hash);

    // A style file holds them for the next character.
    const kept = await downloaded("#save-style");
    assert.equal(kept.name, `${name}.style`);
    writeFileSync(join(work, kept.name), kept.bytes);
    const styleFile = join(work, "command.style");
    command(name, "--answer", first, "--answer", `${other.part}=rigid:${joint}`, "--save-style", styleFile);
    // Two C libraries' hypot() may differ in the last digit.
    const rounded = (json) => JSON.parse(json, (_, value) => (typeof value === "number" ? Number(value.toPrecision(12)) : value));
    assert.deepEqual(rounded(kept.bytes), rounded(readFileSync(styleFile)), "the page's style differs from the command's");

    await page.locator("#questions .back").nth(1).click();
    await settled();
    assert.equal(await hash(), once.hash);
    assert.equal(await focused(), questionText(once.questions[1]));
    await page.keyboard.press("Enter");
    assert.equal(await page.locator("#questions .alternatives").count(), 1);
    await page.keyboard.press("Escape");
    assert.equal(await page.locator("#questions .alternatives").count(), 0);
    await page.locator("#questions .back").click();
    await settled();
    assert.equal(await hash(), native.get(name));
    assert.deepEqual(await page.locator("#questions .question").allTextContents(), nativeQuestions.get(name).map(questionText));

    await give({ name: "studio.style", mimeType: "application/json", buffer: kept.bytes });
    const styled = command(name, "--style", styleFile);
    assert.equal(await errorLine(), "");
    assert.equal(await hash(), styled.hash);
    assert.equal(styled.hash, twice.hash);
    assert.equal(await page.locator("#style > span").innerText(), "studio.style: 2 answers");
    await shoot("style");
    for (const next of ["biped__robot", "biped__caped"]) {
      await page.selectOption("#sample", next);
      await settled();
      assert.equal(await hash(), command(next, "--style", styleFile).hash, next);
    }
    await page.click("#style button");
    await settled();
    assert.equal(await hash(), native.get("biped__caped"));
    assert.equal(await page.locator("#questions .answered").count(), 0);
  });

  await step("several files at once, dropped", async () => {
    const names = ["snake__long", "bird__winged", "biped__robed"];
    const files = names.flatMap((name) => [`${name}.rig.txt`, `${name}.obj`]).map((name) => ({ name, text: readFileSync(join(data, name), "utf8") }));
    const transfer = await page.evaluateHandle((list) => {
      const dropped = new DataTransfer();
      for (const { name, text } of list) dropped.items.add(new File([text], name));
      return dropped;
    }, files);
    await page.dispatchEvent("#stage", "dragenter", { dataTransfer: transfer });
    await shoot("dragging");
    await page.dispatchEvent("#stage", "drop", { dataTransfer: transfer });
    await settled();
    assert.equal(await errorLine(), "");
    assert.deepEqual((await page.locator("#characters [role=tab]").allInnerTexts()).slice(-names.length), names); // those before were worked on
    for (const name of names) {
      await page.locator("#characters [role=tab]", { hasText: name }).last().click();
      await settled();
      assert.equal(await hash(), native.get(name));
    }
    await shoot("several");
  });

  await step("a bare mesh gets a skeleton at once, a skeleton of its own later", async () => {
    assert.ok(!asked.some((url) => url.includes("sinew_rig.sinew")), "the model of skeletons is fetched before anyone needs it");
    await give(file("quadruped__tailed.obj"));
    assert.equal(await errorLine(), "");
    assert.ok(asked.some((url) => url.includes("sinew_rig.sinew")));
    await isTheCommands(rigged(join(data, "quadruped__tailed.obj")));
    assert.equal(await page.isVisible("#sure"), true);
    assert.equal(await page.isVisible("#notice"), false);
    assert.equal(await page.isVisible("#edit"), true);
    assert.equal(await page.isVisible("#pose"), false);
    assert.match(await fact("skeleton in"), /skeleton in [\d,.]+ m?s/);
    await shoot("rigged");
    await give(file("quadruped__tailed.rig.txt"));
    assert.equal(await errorLine(), "");
    assert.equal(await hash(), native.get("quadruped__tailed"));
    assert.equal(await page.isVisible("#sure"), false);
    assert.equal(await page.isVisible("#pose"), true);
  });

  await step("a joint is dragged: its partner follows, weights follow, and it is undone", async () => {
    const mesh = join(data, "biped__robot.obj");
    await give(file("biped__robot.obj"));
    const before = rigged(mesh);
    const plainHash = await hash();
    const plain = await joints();
    const name = "LeftForeArm";
    const { at, other } = indexes(plain, name);
    assert.equal(plain[other].name, "RightForeArm");
    await pick(name);
    const coloured = await colours();
    const from = await onScreen(at);
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(from.x + 14, from.y + 11, { steps: 3 });
    await page.waitForFunction((old) => sinewPage.view.shown("colours").some((c, i) => c !== old[i]), coloured, { timeout: 20000 }); // before it is let go
    await page.mouse.move(from.x + 28, from.y + 22, { steps: 12 });
    const shown = await onScreen(at);
    assert.ok(Math.hypot(shown.x - from.x - 28, shown.y - from.y - 22) < 1.5, "the joint is not under the pointer");
    await shoot("dragging-joint");
    await page.mouse.up();
    await settled();
    assert.equal(await page.locator("#edit-name").innerText(), name);
    assert.equal(await legend(), `Weight of ${name}`);
    const moved = await joints();
    const { axis, plane } = await mirror();
    moved.forEach(({ position }, j) => {
      const isMoved = j === at || j === other;
      assert.equal(position.some((x, i) => x !== plain[j].position[i]), isMoved, moved[j].name);
    });
    const image = moved[at].position.map((x, i) => (i === axis ? Math.fround(2 * plane - x) : x));
    assert.deepEqual(moved[other].position, image);
    assert.deepEqual(await page.evaluate(() => sinewPage.view.shown("joints")), moved.flatMap(({ position }) => position), "the picture has other places");
    assert.notEqual(await hash(), plainHash);
    await isTheCommands(rigged(mesh, "--move", `${name}=${moved[at].position}`));

    // The middle of the limb is where it is already, seen from here.
    await page.keyboard.press("m");
    await settled();
    const middle = (await joints())[at].position;
    assert.ok(Math.hypot(...middle.map((x, i) => x - moved[at].position[i])) < 1e-4, `${middle} is not ${moved[at].position}`);
    await page.keyboard.press("Control+z");
    await page.keyboard.press("Control+z");
    await settled();
    assert.equal(await hash(), plainHash);
    assert.deepEqual(await joints(), plain);
    assert.equal(await page.isDisabled("#undo"), true);
    await page.keyboard.press("Control+Shift+z");
    await settled();
    assert.deepEqual(await joints(), moved);
    await page.click("#undo");
    await settled();
    assert.deepEqual(await joints(), plain);
    assert.ok((await downloaded("#download")).bytes.equals(before.glb));

    // Without the middle it stays as far away as it was; one side alone leaves the other one.
    await page.uncheck("#middle");
    await page.uncheck("#alike");
    await drag(at, 12, 6);
    const alone = await joints();
    assert.deepEqual(alone[other].position, plain[other].position);
    assert.notDeepEqual(alone[at].position, plain[at].position);
    await page.check("#middle");
    await page.check("#alike");
    await page.click("#undo");
    await settled();

    // What stands for both sides stays on the plane.
    const spine = plain.findIndex((joint) => joint.name === "Spine");
    await drag(spine, 15, -9);
    const lifted = (await joints())[spine].position;
    assert.equal(lifted[axis], Math.fround(plane));
    assert.notDeepEqual(lifted, plain[spine].position);
    await page.click("#undo");
    await settled();
    // A drag beside the joints turns the picture and edits nothing.
    await page.mouse.move(130, 400);
    await page.mouse.down();
    await page.mouse.move(190, 380, { steps: 4 });
    await page.mouse.up();
    await settled();
    assert.deepEqual(await joints(), plain);
    assert.notDeepEqual(await onScreen(at), from);
    await page.keyboard.press("f");
  });

  await step("joints are added, renamed, hung elsewhere, placed by numbers and removed, by keys", async () => {
    const mesh = join(data, "biped__robot.obj");
    await give(file("biped__robot.obj"));
    const edits = [];
    await pick("LeftHand");
    await page.keyboard.press("a");
    await settled();
    let now = await joints();
    const [added] = now.filter(({ name }) => name === "LeftJoint");
    assert.ok(added && now.some(({ name }) => name === "RightJoint"));
    edits.push("--add", `LeftJoint=LeftHand:${added.position}`);
    assert.equal(await page.evaluate(() => document.activeElement.id), "rename", "the new joint's name is what is typed");
    await page.keyboard.type("LeftThumb");
    await page.keyboard.press("Enter");
    await settled();
    edits.push("--rename", "LeftJoint=LeftThumb");
    assert.equal(await page.locator("#edit-name").innerText(), "LeftThumb");
    assert.equal(await page.inputValue("#rename"), "LeftThumb");
    await page.selectOption("#parent", { label: "LeftForeArm" });
    await settled();
    edits.push("--parent", "LeftThumb=LeftForeArm");
    await page.fill("#place-y", "1.25");
    await page.keyboard.press("Tab");
    await settled();
    now = await joints();
    const thumb = now.find(({ name }) => name === "LeftThumb");
    assert.equal(thumb.position[1], 1.25);
    assert.equal(now[thumb.parent].name, "LeftForeArm");
    edits.push("--move", `LeftThumb=${thumb.position}`);
    await pick("RightFoot");
    await page.keyboard.press("Delete");
    await settled();
    edits.push("--remove", "RightFoot");
    now = await joints();
    assert.ok(!now.some(({ name }) => /Foot/.test(name)), "its partner goes with it");
    await isTheCommands(rigged(mesh, ...edits));
    await shoot("edited");

    // What cannot be is said, and nothing has changed.
    await pick("LeftThumb");
    const before = await hash();
    await page.fill("#rename", "Hips");
    await page.keyboard.press("Enter");
    await settled();
    assert.match(await errorLine(), /; choose another name$/);
    assert.equal(await page.inputValue("#rename"), "LeftThumb");
    await page.fill("#rename", "Left Thumb");
    await page.keyboard.press("Enter");
    await settled();
    assert.match(await errorLine(), /contains a space/);
    const offered = await page.locator("#parent option").allTextContents();
    assert.ok(offered.includes("Hips") && !offered.includes("LeftThumb") && !offered.some((name) => name.endsWith("_end")));
    assert.equal(await hash(), before);
    await page.click("#error button");

    // The edited rig.txt comes back with its mesh, and is edited on.
    const saved = await downloaded("#download-rig");
    assert.equal(saved.name, "biped__robot.rig.txt");
    await give(file("biped__robot.obj"), { name: saved.name, mimeType: "text/plain", buffer: saved.bytes });
    assert.equal(await errorLine(), "");
    assert.deepEqual((await joints()).map(({ name }) => name), now.map(({ name }) => name));
    await page.keyboard.press("e");
    await pick("LeftThumb");
    await page.fill("#place-y", "1.3");
    await page.keyboard.press("Tab");
    await settled();
    assert.equal(await errorLine(), "");
    assert.equal((await joints()).find(({ name }) => name === "RightThumb").position[1], Math.fround(1.3));
  });

  await step("a new skeleton by other wishes, and edits that stay with their character", async () => {
    const mesh = join(data, "biped__robed.obj");
    await give(file("biped__robed.obj"));
    for (const [wish, ...more] of [
      [() => page.selectOption("#spine", "4"), "--spine", "4"],
      [() => page.uncheck("#toes"), "--spine", "4", "--no-toes"],
      [() => page.uncheck("#ends"), "--spine", "4", "--no-toes", "--no-ends"],
      [() => page.selectOption("#mirror", "2"), "--spine", "4", "--no-toes", "--no-ends", "--no-mirror"],
      [() => page.selectOption("#mirror", "1"), "--spine", "4", "--no-toes", "--no-ends", "--mirror"],
    ]) {
      await wish();
      await settled();
      await isTheCommands(rigged(mesh, ...more));
    }
    await page.selectOption("#spine", "0");
    await page.selectOption("#mirror", "0");
    await page.check("#toes");
    await page.check("#ends");
    await settled();
    const { glb } = rigged(mesh);
    assert.ok((await downloaded("#download")).bytes.equals(glb));
    await page.click("#undo");
    await settled();
    assert.ok(!(await downloaded("#download")).bytes.equals(glb));

    // A file's own skeleton gives way to a new one, and comes back.
    await page.selectOption("#sample", "biped__caped");
    await settled();
    assert.equal(await page.isVisible("#edit"), false);
    await page.keyboard.press("e");
    await settled();
    assert.equal(await page.isVisible("#edit-none"), true);
    await page.click("#joints li:nth-child(4)");
    await settled();
    assert.equal(await page.isDisabled("#rename"), true);
    await page.click("#predict");
    await settled();
    assert.equal(await errorLine(), "");
    assert.equal(await page.isVisible("#edit-none"), false);
    await isTheCommands(rigged(join(data, "biped__caped.gltf")));
    await page.keyboard.press("Control+z");
    await settled();
    assert.equal(await hash(), native.get("biped__caped"));

    // Of two characters each keeps what was done to it.
    await give(file("biped__robot.obj"), file("bird__winged.obj"));
    await pick("Head");
    await page.fill("#place-y", "1.6");
    await page.keyboard.press("Tab");
    await settled();
    const edited = await hash();
    await page.locator("#characters [role=tab]", { hasText: "bird__winged" }).last().click();
    await settled();
    assert.notEqual(await hash(), edited);
    await page.locator("#characters [role=tab]", { hasText: "biped__robot" }).last().click();
    await settled();
    assert.equal(await hash(), edited);
    await page.click("#undo");
    await settled();
    assert.notEqual(await hash(), edited);
  });

  await step("an answer stays with its joint, poses are of the edited skeleton", async () => {
    await give(file("biped__robot.obj"));
    await page.keyboard.press("e");
    await settled();
    assert.equal(await page.isVisible("#pose"), true);
    await page.locator("#questions .question").first().click();
    await page.locator("#questions .any select").selectOption({ label: "Head" });
    await page.click("#questions .take");
    await settled();
    const answered = await hash();
    await page.keyboard.press("e");
    await pick("Spine");
    await page.keyboard.press("Delete");
    await settled();
    assert.equal(await errorLine(), "");
    await page.keyboard.press("e");
    assert.match(await page.locator("#questions .answered .name").innerText(), /follow Head$/);
    await page.keyboard.press("e");
    await page.keyboard.press("Control+z");
    await settled();
    assert.equal(await hash(), answered);
    await pick("LeftArm");
    const arm = (await joints()).findIndex(({ name }) => name === "LeftArm");
    await drag(arm, 0, 12);
    await page.keyboard.press("e");
    await page.focus("#turn-z");
    for (let i = 0; i < 30; ++i) await page.keyboard.press("ArrowRight");
    await settled();
    const apart = await page.evaluate(() => sinewPage.view.largestHandleDistance());
    assert.ok(apart < 1e-4, `${apart} of the character's size apart`);
    await shoot("posed-after-edit");
    // Editing is done at rest; the pose is there afterwards.
    const turned = await positions();
    await page.keyboard.press("e");
    await settled();
    assert.notDeepEqual(await positions(), turned);
    await page.keyboard.press("e");
    await settled();
    assert.deepEqual(await positions(), turned);
  });

  await step("what is wrong is said in one line, and the page goes on", async () => {
    const obj = readFileSync(join(data, "snake__long.obj"), "utf8");
    const rig = readFileSync(join(data, "snake__long.rig.txt"), "utf8");
    const cube = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => `v ${i & 1} ${(i >> 1) & 1} ${i >> 2}`).join("\n") +
      "\nf 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    const before = await hash();
    for (const [files, want] of [
      [[made("hero.usdz", "PK")], /^hero\.usdz: this is USD, which sinew writes but does not read: export glTF or FBX$/],
      [[made("notes.docx", "PK")], /^notes\.docx: expected \.obj, \.rig\.txt, .* found another kind of file$/],
      [[made("broken.glb", "glTF but not really, only a few bytes of it")], /^broken\.glb: /],
      [[made("empty.glb", "")], /^empty\.glb: /],
      [[made("a.obj", obj.replace(/\nv .*/, "\nv 0 nan 0")), made("a.rig.txt", rig)], /^a\.obj:\d+: expected a finite number after 'v', found 'nan'$/],
      [[made("a.obj", obj), made("a.rig.txt", rig.replace(/^hier /m, "heir "))], /^a\.rig\.txt:\d+: expected /],
      [[made("a.obj", "v 0 0 0\nv 1 0 0\n"), made("a.rig.txt", rig)], /^a\.obj: has no faces to show/],
      [[made("a.obj", obj), made("a.rig.txt", "\0\0")], /^a\.rig\.txt: expected a rig text file, found binary data/],
      [[made("mine.sinew", "not a model")], /^mine\.sinew: /],
      [[made("mine.style", "{}")], /^mine\.style: expected a style file /],
    ]) {
      await give(...files);
      const line = await errorLine();
      assert.match(line, want);
      assert.ok(!line.includes("\n") && line.length < 300, line);
      assert.equal(await hash(), before, "the character from before is still there");
    }
    await shoot("error");
    await page.click("#error button");
    assert.equal(await errorLine(), "");
    // A cube gets a skeleton too, and a line that says what to think of it.
    await give(made("cube.obj", cube));
    assert.equal(await errorLine(), "");
    assert.ok((await joints()).length > 0);
    assert.equal(await page.isVisible("#notice"), true);
    assert.match(await page.locator("#notice").innerText(), /^This mesh looks like nothing the model was trained on/);
    await shoot("untrusted");
    await give(made("rigs.sinew", readFileSync(join(data, "sinew_rig.sinew")).subarray(0, 900)));
    assert.match(await errorLine(), /^rigs\.sinew: /);
    await give(file("sinew_rig.sinew"));
    assert.equal(await errorLine(), "");
    await give(file("snake__long.obj"), file("snake__long.rig.txt"));
    assert.equal(await hash(), native.get("snake__long"));
  });

  await step("motion", async () => {
    // A motion for the skeleton that the bare mesh gets: the left arm goes up, the hips forward.
    copyFileSync(join(data, "biped__robed.obj"), join(work, "figure.obj"));
    const { joints: rig } = rigged(join(work, "figure.obj"));
    writeFileSync(join(work, "wave.bvh"), wave(rig));
    const glb = join(work, "waving.glb");
    const told = JSON.parse(execFileSync(sinew, ["animate", join(work, "figure.obj"), "--motion", join(work, "wave.bvh"), "-o", glb, "--json"], { stdio: "pipe" }));
    await give(made("wave.bvh", "HIERARCHY\n"));
    assert.match(await errorLine(), /^wave\.bvh/);
    await give(made("figure.obj", readFileSync(join(work, "figure.obj"))));
    const rest = await positions();
    assert.ok(!(await page.locator("#timeline").isVisible()));
    await give(made("wave.bvh", readFileSync(join(work, "wave.bvh"))));
    assert.equal(await errorLine(), "");
    assert.match(await page.locator("#motion-about").innerText(), new RegExp(`${told.clips[0].mapped} of ${told.joints} bones,`));
    assert.ok((await downloaded("#download")).bytes.equals(readFileSync(glb)), "the page's GLB differs from the command's");
    await page.fill("#time", "0.5");
    await settled();
    const middle = await positions();
    assert.notDeepEqual(middle, rest);
    await shoot("motion");
    await page.focus("#joints");
    await page.keyboard.press(".");
    await settled();
    assert.notDeepEqual(await positions(), middle);
    await page.keyboard.press(",");
    await settled();
    assert.deepEqual(await positions(), middle);
    await page.keyboard.press(" ");
    await page.waitForFunction((before) => document.getElementById("time").value !== before, await page.inputValue("#time"));
    assert.equal(await page.locator("#play").innerText(), "Pause");
    await page.click("#play");
    await settled();
    // The skeleton is edited at rest; the motion follows it.
    await page.keyboard.press("e");
    await settled();
    assert.deepEqual(await positions(), rest);
    await page.keyboard.press("e");
    await settled();
    await page.click("#close-motion");
    await settled();
    assert.deepEqual(await positions(), rest);
    assert.equal(await errorLine(), "");
    // A file's own animations play at once, and its GLB gets them no second time.
    await give(made("waving.glb", readFileSync(glb)));
    assert.match(await page.locator("#motion-about").innerText(), /^waving\.glb: /);
    const own = JSON.parse((await downloaded("#download")).bytes.subarray(20).toString().split("\0")[0].replace(/^[^{]*/, "").replace(/[^}]*$/, "").split("BIN")[0]);
    assert.equal(own.animations.length, 1);
    await give(file("snake__long.obj"), file("snake__long.rig.txt"));
    assert.ok(!(await page.locator("#timeline").isVisible()));
  });

  await step("options", async () => {
    await page.selectOption("#method", "1");
    await settled();
    assert.notEqual(await hash(), native.get("snake__long"));
    await page.selectOption("#method", "0");
    await page.selectOption("#up", "1");
    await settled();
    await page.selectOption("#up", "0");
    await settled();
    assert.equal(await hash(), native.get("snake__long"));
    await page.locator("#joints li").nth(8).click();
    await page.focus("#turn-y");
    for (let i = 0; i < 60; ++i) await page.keyboard.press("ArrowRight");
    await settled();
    const linear = await positions();
    await page.locator("#skinning label", { hasText: "Dual quat." }).click();
    await settled();
    assert.notDeepEqual(await positions(), linear);
    assert.equal(await errorLine(), "");
  });

  await step("a small window", async () => {
    await page.setViewportSize({ width: 390, height: 780 });
    await page.waitForTimeout(100);
    const over = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    assert.equal(over, 0, "the page is wider than the window");
    await shoot("small");
    await page.keyboard.press("e");
    await settled();
    await page.locator("#edit").scrollIntoViewIfNeeded();
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth), 0);
    await shoot("small-edit");
    for (const id of ["#download", "#rail", "#view-switch", "#search"]) {
      const box = await page.locator(id).boundingBox();
      assert.ok(box && box.x >= 0 && box.x + box.width <= 390, `${id} reaches out of the window`);
    }
  });
} finally {
  await browser.close();
  server.close();
}
console.log(`page_test: ok; screenshots: ${readdirSync(work).filter((name) => name.endsWith(".png")).join(" ")}`);
