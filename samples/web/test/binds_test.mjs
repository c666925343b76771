// SPDX-License-Identifier: MIT
// The page binds strange files as the command does, byte for byte, and tells what the command tells: meshes that hang on joints, props, tips,
// controls, skeletons in other units, meshes on their backs, joints that one word forbids and another names. In a headless Chromium.
//   binds_test.mjs DIST_DIR SOURCE_DIR WORK_DIR SINEW_COMMAND
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { strangeFiles } from "../../npm/test/strange_files.mjs";
import { fileOf, made, startPage } from "./page.mjs";

const { work, data, server, browser, page, command: run, remarks, settled, shoot, errorLine, hash, pick, give, downloaded, step } = await startPage("binds_");
const command = (...args) => JSON.parse(run(...args, "-o", "command.glb", "--json"));
const failed = (...args) => {
  try {
    command(...args);
  } catch (error) {
    return String(error.stderr).trim().replace(/^sinew: (error: )?/, "");
  }
  return "";
};
const wanted = () => readFileSync(join(work, "command.glb"));
const facts = () => page.locator("#facts").innerText();

try {
  await page.goto(`${server.address}?sample=biped__robot`);
  await settled();

  await step("files as strangers make them", async () => {
    const files = Object.entries(strangeFiles()).filter(([name]) => name.endsWith(".glb"));
    assert.ok(files.length >= 3);
    for (const [name, bytes] of files) {
      writeFileSync(join(work, name), bytes);
      const { hash: expected } = command("bind", name);
      await give(made(name, bytes));
      assert.equal(await errorLine(), "", name);
      assert.equal(await hash(), expected, name);
      assert.ok((await downloaded("#download")).bytes.equals(wanted()), `${name}: the page's GLB differs from the command's`);
    }
  });

  await step("a mesh on its back gets the skeleton that finds it there", async () => {
    const lying = readFileSync(join(data, "biped__robed.obj"), "utf8").replace(/^(vn?) (\S+) (\S+) (\S+)/gm, (_, kind, x, y, z) => `${kind} ${x} ${-Number(z)} ${y}`);
    writeFileSync(join(work, "lying.obj"), lying);
    assert.equal(command("rig", "lying.obj").up, "z");
    await give(made("lying.obj", lying));
    assert.equal(await errorLine(), "");
    assert.ok((await downloaded("#download")).bytes.equals(wanted()), "the page's GLB differs from the command's");
    await shoot("lying"); // on its feet
    command("rig", "lying.obj", "--up", "y");
    await page.locator("#up").evaluate((up) => ((up.value = "0"), up.onchange()));
    await settled();
    assert.ok((await downloaded("#download")).bytes.equals(wanted()), "and the one that the user says");
    await page.locator("#up").evaluate((up) => ((up.value = "2"), up.onchange()));
    await settled();
  });

  await step("a skeleton in other units is told", async () => {
    const rig = readFileSync(join(data, "biped__robot.rig.txt"), "utf8").replace(/^joints (\S+) (\S+) (\S+) (\S+)/gm, (_, name, ...at) => `joints ${name} ${at.slice(0, 3).map((x) => 100 * x).join(" ")}`);
    const mesh = readFileSync(join(data, "biped__robot.obj"));
    writeFileSync(join(work, "robot.rig.txt"), rig);
    writeFileSync(join(work, "robot.obj"), mesh);
    const { notes, hash: expected } = command("bind", "robot.obj", "--skeleton", "robot.rig.txt");
    const told = notes.find((note) => note.startsWith("warning: the skeleton"));
    assert.match(told, /correct it with --fit$/);
    await give(made("robot.obj", mesh), made("robot.rig.txt", rig));
    assert.equal(await hash(), expected);
    assert.ok((await remarks()).includes(told.replace(/^warning: t|; correct it.*/g, "")), await remarks());
  });

  await step("parts that have grown together are told", async () => {
    const name = "biped__robed";
    const { seams } = command("bind", join(data, `${name}.obj`), "--skeleton", join(data, `${name}.rig.txt`));
    await give(fileOf(join(data, `${name}.obj`)), fileOf(join(data, `${name}.rig.txt`)));
    assert.equal(/fused parts at /.test(await facts()), seams.length > 0, await facts());
  });

  await step("no answer gives weight to a joint that is switched off", async () => {
    const name = "biped__robot";
    const args = [join(data, `${name}.obj`), "--skeleton", join(data, `${name}.rig.txt`)];
    const { questions } = command("bind", ...args, "--questions", "8");
    await give(fileOf(join(data, `${name}.obj`)), fileOf(join(data, `${name}.rig.txt`)));
    await pick("hand.L");
    await page.click("#switch");
    await settled();
    writeFileSync(join(work, "never.txt"), "hand.L\n");
    const { hash: without } = command("bind", ...args, "--never", "never.txt");
    assert.equal(await hash(), without);
    const question = page.locator("#questions .question").first();
    const part = await page.locator("#questions li").first().getAttribute("data-part");
    assert.ok(questions.some((one) => String(one.part) === part));
    await question.click();
    await page.locator("#questions .any select").selectOption({ label: "hand.L" });
    await page.click("#questions .take");
    await settled();
    const line = failed("bind", ...args, "--never", "never.txt", "--answer", `${part}=rigid:hand.L`);
    assert.match(line, /^answer rigid:hand\.L: /);
    assert.equal(await errorLine(), line);
    assert.equal(await hash(), without, "what was there stays");
  });
} finally {
  await browser.close();
  server.close();
}
console.log("binds: all steps ok");
