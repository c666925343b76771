// SPDX-License-Identifier: MIT
// The page by axe-core, in a headless Chromium: no serious finding in any step, in both themes, on a desk and on a phone. Keys while Help is open.
//   access_test.mjs DIST_DIR SOURCE_DIR WORK_DIR SINEW_COMMAND
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { startPage } from "./page.mjs";

const { server, browser, page, file, settled, shoot, give, go, pick, hash, step } = await startPage("access_");
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
// What axe finds that is serious: [rule: elements].
const findings = async () => {
  if (!(await page.evaluate(() => "axe" in window))) await page.evaluate(axe);
  const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"] }));
  return violations.filter(({ impact }) => ["serious", "critical"].includes(impact)).map(({ id, nodes }) => `${id}: ${nodes.map(({ target, any }) => `${target.join(" ")} (${any[0]?.message ?? ""})`).join("; ")}`);
};

try {
  await page.goto(server.address);
  await settled();
  for (const theme of ["dark", "light"]) {
    for (const [width, height] of [[1366, 768], [390, 844]]) {
      await step(`${theme}, ${width} x ${height}: nothing serious`, async () => {
        await page.emulateMedia({ colorScheme: theme, reducedMotion: "reduce" });
        await page.setViewportSize({ width, height });
        const found = [];
        const look = async (where) => found.push(...(await findings()).map((line) => `${where}: ${line}`));
        await page.evaluate(() => sinewPage.forgetWork());
        await page.goto(server.address);
        await settled();
        await look("start");
        await give(file("biped__robot.obj"));
        await look("what was found");
        await shoot(`${theme}_${width}_found`);
        await give(file("quadruped__tailed.obj"), file("quadruped__tailed.rig.txt"));
        for (const name of ["mesh", "skeleton", "weights", "motion", "export"]) {
          await go(name);
          if (name === "motion") {
            await page.click("#clip-grid [data-clip=trot]");
            await settled();
            await page.check("#springs-on");
            await settled();
          }
          // Folded parts, one after another.
          for (const fold of [null, ...(await page.locator("#panel details:visible").all())]) {
            if (fold) await fold.evaluate((one) => (one.open = true));
            await look(`${name}${fold ? ` ${await fold.evaluate((one) => one.id || one.innerText.split("\n")[0])}` : ""}`);
          }
          await shoot(`${theme}_${width}_${name}`);
        }
        await page.keyboard.press("?");
        await look("help");
        await page.keyboard.press("Escape");
        assert.deepEqual([...new Set(found.map((line) => line.replace(/^[^:]*: /, "")))], []);
      });
    }
  }

  await step("keys are Help's while it is open, and Alt with a number goes to a step", async () => {
    await page.setViewportSize({ width: 1366, height: 768 });
    await go("weights");
    await pick("head");
    const was = await hash();
    await page.keyboard.press("?");
    for (const key of ["x", "l", "Control+z", "Alt+1"]) await page.keyboard.press(key);
    await page.keyboard.press("Escape");
    await settled();
    assert.deepEqual([await hash(), await page.isVisible("#help-page"), await page.evaluate(() => sinewPage.step)], [was, false, "weights"]);
    for (const [number, name] of ["mesh", "skeleton", "weights", "motion", "export"].entries()) {
      await page.keyboard.press(`Alt+${number + 1}`);
      await settled();
      assert.equal(await page.evaluate(() => sinewPage.step), name);
    }
  });
  console.log("access: all steps ok");
} finally {
  await browser.close();
  server.close();
}
