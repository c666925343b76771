// SPDX-License-Identifier: MIT
// Nothing is lost, in a headless Chromium: in each step something is done, then the page is reloaded, a second window works on the same, a second file is
// dropped, the network goes away and the worker ends in the middle of the next thing. The file that is saved is the same each time.
//   loss_test.mjs DIST_DIR SOURCE_DIR WORK_DIR SINEW_COMMAND
import assert from "node:assert/strict";
import { newPage, startPage } from "./page.mjs";

const { server, browser, troubles, page, file, undoName, settled, errorLine, joints, leave, give, downloaded, go, pick, choose, step } = await startPage("loss_");
const saved = async () => (await downloaded("#download")).bytes;
const same = async (was, event) => {
  assert.ok((await saved()).equals(was), `${event}: another file`);
};
const key = async (name) => (await page.keyboard.press(name), await settled());
const type = async (id, value) => {
  await page.fill(id, value);
  await page.keyboard.press("Tab");
};
const isAt = (name) => page.evaluate(() => sinewPage.step).then((at) => assert.equal(at, name));

async function reloads(was, name) {
  await leave();
  await page.locator("#start .kept .go").first().click();
  await settled();
  assert.equal(await errorLine(), "");
  await isAt(name);
  await same(was, "reload");
}

async function secondWindow(was) {
  await page.evaluate(() => sinewPage.autosaved());
  const second = await newPage(browser, troubles);
  await second.emulateMedia({ reducedMotion: "reduce" });
  await second.goto(server.address);
  await second.locator("#start .kept .go").first().click();
  await second.evaluate(() => sinewPage.settled());
  await second.fill("#height", "3");
  await second.keyboard.press("Tab");
  await second.evaluate(() => sinewPage.settled());
  await second.evaluate(() => sinewPage.autosaved());
  await second.close({ runBeforeUnload: false });
  await same(was, "second window");
}

// What a file has already makes way for another file; the browser keeps it.
async function secondFile(was) {
  await give(file("snake__long.obj"));
  assert.equal(await page.evaluate(() => sinewPage.character.name), "snake__long");
  await go("mesh");
  await page.locator("#panel .kept summary").click();
  await page.locator("#panel .kept .go", { hasText: "robot" }).first().click();
  await settled();
  await same(was, "second file");
}

// One thing more, which is taken back.
async function worksOn(was, act, before, event) {
  await before?.();
  await act();
  await settled();
  assert.equal(await errorLine(), "");
  assert.ok(!(await saved()).equals(was), `${event}: it works on`);
  await key("Control+z");
  await same(was, `${event}, undone`);
}

async function offline(was, act, before) {
  await browser.context.setOffline(true);
  await worksOn(was, act, before, "offline");
  await browser.context.setOffline(false);
}

// The worker ends by itself with the next call that it gets.
async function failNext() {
  const worker = page.workers().find((one) => one.url().endsWith("worker.js"));
  await worker.evaluate(() => {
    self.onmessage = () => setTimeout(() => {
      throw new Error("out of luck");
    });
  });
}

async function crashes(was, act, before) {
  const done = await undoName();
  await before?.();
  await failNext();
  await act();
  await settled();
  assert.match(await errorLine(), /^The engine failed \(.*out of luck\)\. Your character is as it was before that\.$/);
  troubles.length = 0; // the browser tells of the error, too
  await page.keyboard.press("Escape");
  assert.equal(await undoName(), done);
  await same(was, "crash");
  await worksOn(was, act, before, "crash");
}

// What is done in each step, and one thing more, which is taken back. A box is clicked, not checked: a failing engine may have set it back already.
const works = {
  mesh: { act: () => type("#height", "1.5"), more: () => page.click("#floor") },
  skeleton: {
    act: async () => {
      await pick("LeftForeArm");
      await type("#place-y", "0.9");
      await type("#rename", "elbow");
    },
    before: () => pick("LeftLeg"),
    more: () => type("#place-z", "0.1"),
  },
  weights: {
    act: async () => {
      await pick("Head");
      await key("l");
      await pick("elbow");
      await key("x");
    },
    before: () => pick("LeftFoot"),
    more: () => page.keyboard.press("x"),
  },
  motion: {
    act: async () => {
      await page.click("#clip-grid button >> nth=0");
      await settled();
      await page.check("#in-place");
    },
    more: () => page.click("#in-place"),
  },
  export: {
    act: async () => {
      await choose("unity");
      await page.check("#symmetric");
    },
    before: () => go("mesh"),
    more: () => type("#height", "1.6"),
  },
};

try {
  await page.setViewportSize({ width: 1366, height: 768 });
  await page.goto(server.address);
  await settled();
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.waitForFunction(async () => (await (await caches.open("sinew")).keys()).length > 8);
  await give(file("biped__robot.obj"));
  assert.ok((await joints()).some(({ name }) => name === "LeftForeArm"));
  for (const [name, { act, before, more }] of Object.entries(works))
    await step(`in the step ${name} nothing is lost`, async () => {
      await go(name);
      const first = await saved();
      await act();
      await settled();
      assert.equal(await errorLine(), "");
      await go(name);
      const was = await saved();
      assert.ok(!was.equals(first), "it did nothing");
      await reloads(was, name);
      await secondFile(was);
      await go(name);
      await offline(was, more, before);
      await go(name);
      await crashes(was, more, before);
      await secondWindow(was); // last: what it keeps is the newest of the name
    });
  await step("a crash loses no step before it: each is as it was, with what was painted, locked and the file's own skeleton", async () => {
    await leave();
    await page.evaluate(() => sinewPage.forgetWork());
    await page.goto(server.address);
    await settled();
    await give(file("biped__robot.obj"), file("biped__robot.rig.txt"));
    const [files, names] = [[await saved()], [await undoName()]];
    for (const act of [async () => (await pick("head"), key("l")), () => type("#height", "1.2"), () => page.click("#predict")]) {
      await act();
      await settled();
      files.push(await saved());
      names.push(await undoName());
    }
    await go("mesh");
    await failNext();
    await page.click("#floor");
    await settled();
    assert.match(await errorLine(), /^The engine failed/);
    troubles.length = 0;
    await page.keyboard.press("Escape");
    for (let at = files.length - 1; at >= 0; --at) {
      assert.equal(await undoName(), names[at]);
      assert.ok((await saved()).equals(files[at]), `after the crash, the state of "${names[at]}" is another one`);
      if (at > 0) await key("Control+z");
    }
  });
  console.log("loss: all steps ok");
} finally {
  await browser.close();
  server.close();
}
