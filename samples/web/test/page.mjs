// SPDX-License-Identifier: MIT
// What the tests of the page share: folders and the command, a page whose troubles are noted, and what is asked of it and done with it.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { launch, serve } from "./browser.mjs";

// A page of the browser that asks no other host. troubles: [line] of its console and such questions from now on.
export async function newPage(browser, troubles) {
  const page = await browser.context.newPage();
  page.setDefaultTimeout(120000);
  const goto = page.goto.bind(page);
  page.goto = async (...where) => {
    await goto(...where);
    await page.waitForFunction(() => "sinewPage" in window); // the page comes after the first picture
  };
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && !/GPU stall|GL Driver/.test(message.text()) && troubles.push(message.text()));
  page.on("pageerror", (error) => troubles.push(error.message));
  revealing(page);
  page.on("request", (request) => /^(http:\/\/127\.0\.0\.1|blob:|data:)/.test(request.url()) || troubles.push(`asks ${request.url()}`));
  return page;
}

// Steps and folded parts hide what is not worked on: what a test acts on is brought up first, as a user would.
function revealing(page) {
  const idOf = (selector) => /#([\w-]+)/.exec(selector)?.[1];
  const reveal = async (selector) => {
    const id = idOf(String(selector));
    if (id && (await page.evaluate((name) => window.sinewPage?.reveal(name), id).then(() => true, () => false))) await page.evaluate(() => window.sinewPage?.settled());
  };
  page.reveal = reveal;
  for (const name of ["click", "fill", "selectOption", "check", "uncheck", "focus"]) {
    const act = page[name].bind(page);
    page[name] = async (selector, ...rest) => (await reveal(selector), act(selector, ...rest));
  }
  const locate = page.locator.bind(page);
  const wrapped = (locator, selector) => {
    for (const name of ["click", "hover", "focus", "selectOption", "fill", "check", "uncheck", "scrollIntoViewIfNeeded", "waitFor", "innerText"]) {
      const act = locator[name].bind(locator);
      locator[name] = async (...rest) => (await reveal(selector), act(...rest));
    }
    for (const name of ["first", "last", "nth", "locator", "filter"]) {
      const make = locator[name].bind(locator);
      locator[name] = (...rest) => wrapped(make(...rest), selector);
    }
    return locator;
  };
  page.locator = (selector, options) => wrapped(locate(selector, options), String(selector));
}

// current: () => the page that is looked at. Screenshots go to WORK/prefixNAME.png.
export function pageTools(current, { troubles, work, prefix = "" }) {
  const on = (selector) => current().locator(selector);
  const tools = {
    settled: () => current().evaluate(() => sinewPage.settled()),
    shoot: (name) => current().screenshot({ path: join(work, `${prefix}${name}.png`) }),
    errorLine: async () => ((await on("#error").isVisible()) ? on("#error span").innerText() : ""),
    hash: () => on("#facts code").textContent(),
    undoName: async () => (await current().getAttribute("#undo", "title")).replace(/^Undo: | \(Ctrl\+Z\)$/g, ""),
    remarks: async () => ((await on("#remarks").isVisible()) ? on("#remarks").innerText() : ""),
    legend: () => on("#legend figcaption").innerText(),
    colours: () => current().evaluate(() => sinewPage.view.shown("colours")),
    positions: () => current().evaluate(() => sinewPage.view.shown("positions")),
    joints: () => current().evaluate(() => sinewPage.character.joints),
    // As the user goes from one step to another.
    async go(step) {
      await current().click(`#rail [data-step=${step}]`);
      await tools.settled();
    },
    async open(sample) {
      await current().selectOption("#sample", sample);
      await tools.settled();
      assert.equal(await tools.errorLine(), "");
    },
    // Chosen in the list of joints; keys are the page's afterwards.
    async pick(name, modifiers = []) {
      await current().fill("#search", name);
      await on(`#joints li >> text="${name}"`).click({ modifiers });
      await current().fill("#search", "");
      await current().focus("#joints");
      await tools.settled();
    },
    // To the start page, once the work is kept, past the browser's question.
    async leave(which = current()) {
      await which.evaluate(() => sinewPage.autosaved());
      const accept = (dialog) => dialog.accept();
      which.on("dialog", accept);
      await which.goto(new URL("/", which.url()).href);
      which.off("dialog", accept);
      await which.evaluate(() => sinewPage.settled());
    },
    // As a drop of files: {name, mimeType, buffer}.
    async give(...files) {
      await current().setInputFiles("#files", files);
      await current().waitForFunction(() => document.getElementById("files").files.length === 0);
      await tools.settled();
    },
    async slide(id, value) {
      await on(id).evaluate((input, wanted) => {
        input.value = String(wanted);
        input.dispatchEvent(new Event("input", { bubbles: true }));
        input.dispatchEvent(new Event("change", { bubbles: true }));
      }, value);
      await tools.settled();
    },
    async downloaded(id) {
      const [download] = await Promise.all([current().waitForEvent("download"), current().click(id)]);
      return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
    },
    // The program that a file is to be for, in the step Export.
    async choose(program) {
      await current().check(`#programs [value=${program}]`);
      await tools.settled();
    },
    async step(name, test) {
      const start = Date.now();
      try {
        await test();
      } catch (error) {
        await tools.shoot("failed").catch(() => {});
        error.message = `${name}: ${error.message}`;
        throw error;
      }
      assert.deepEqual(troubles, [], `${name}: the browser's console`);
      console.log(`${name}: ok, ${Date.now() - start} ms`);
    },
  };
  return tools;
}

// What a test begins with: DIST_DIR SOURCE_DIR WORK_DIR SINEW_COMMAND of its own arguments, a server, a browser with a page. Screenshots are prefixNAME.png.
export async function startPage(prefix) {
  const [dist, source, work, sinew] = process.argv.slice(2).map((path) => resolve(path));
  const data = join(source, "samples/data");
  mkdirSync(work, { recursive: true });
  const server = await serve(dist);
  const browser = await launch();
  const troubles = [];
  const page = await newPage(browser, troubles);
  await page.emulateMedia({ reducedMotion: "reduce" });
  return {
    dist, source, work, data, server, browser, troubles, page,
    ...pageTools(() => page, { troubles, work, prefix }),
    at: (name) => join(work, name),
    // What the command prints, run in the folder of the test.
    command: (...args) => execFileSync(sinew, args, { cwd: work, stdio: "pipe" }).toString(),
    // A sample's file, as give() takes it.
    file: (name) => fileOf(join(data, name)),
  };
}

export const made = (name, content) => ({ name, mimeType: "application/octet-stream", buffer: Buffer.from(content) });
export const fileOf = (path) => made(path.split("/").pop(), readFileSync(path));

// How far apart the numbers of two GLBs are that are alike otherwise: two C libraries' sin() differ in the last digits. Infinity where more differs.
export function apartGlbs(one, other) {
  const parts = [one, other].map((glb) => {
    const json = glb.subarray(20, 20 + glb.readUInt32LE(12));
    const bin = glb.subarray(28 + json.length);
    return { json, floats: new Float32Array(new Uint8Array(bin).buffer, 0, bin.length >> 2), words: new Int32Array(new Uint8Array(bin).buffer, 0, bin.length >> 2) };
  });
  const [a, b] = parts;
  if (!a.json.equals(b.json) || a.words.length !== b.words.length) return Infinity;
  return a.words.reduce((most, word, i) => (word === b.words[i] ? most : Math.max(most, Math.abs(a.floats[i] - b.floats[i]) || Infinity)), 0);
}
