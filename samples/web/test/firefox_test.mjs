// SPDX-License-Identifier: MIT
// The main flow in Debian's Firefox: a bare file walks without a click, clips, steps, and a file that is the command's.
//   firefox_test.mjs DIST_DIR SOURCE_DIR WORK_DIR SINEW_COMMAND
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { copyFileSync, mkdirSync, readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { serve } from "./browser.mjs";
import { findFirefox, findXvfb, launchFirefox } from "./firefox.mjs";

const [dist, source, work, sinew] = process.argv.slice(2).map((path) => resolve(path));
const program = findFirefox();
if (program === "" || findXvfb() === "") {
  console.log("firefox: SKIPPED, no firefox-esr and Xvfb in PATH (apt-get install firefox-esr xvfb)");
  process.exit(77);
}
mkdirSync(work, { recursive: true });
const server = await serve(dist);
const browser = await launchFirefox(program);
const settled = () => browser.run(async () => (await sinewPage.settled(), true));
const until = async (what, test) => {
  for (const end = Date.now() + 120000; !(await browser.run(test)); ) {
    if (Date.now() > end) throw new Error(`${what}: not within two minutes`);
    await new Promise((done) => setTimeout(done, 100));
  }
};
try {
  copyFileSync(join(source, "samples/data/biped__robot.obj"), join(work, "robot.obj"));
  await browser.open(server.address);
  await until("the page", () => "sinewPage" in window);
  await until("a first picture that moves", () => performance.getEntriesByName("first picture that moves").length > 0);
  await settled();
  await browser.screenshot(join(work, "firefox_start.png"));
  await browser.choose("#files", join(work, "robot.obj"));
  await until("a walk", () => document.getElementById("play").ariaPressed === "true" && !document.getElementById("offer").hidden);
  assert.match(await browser.run(() => document.getElementById("offer-said").innerText), /^\d+ bones/);
  await browser.screenshot(join(work, "firefox_walks.png"));
  await browser.click("#offer-answers button:last-child");
  await settled();
  assert.equal(await browser.run(() => sinewPage.step), "export");
  for (const step of ["mesh", "skeleton", "weights", "motion", "export"]) {
    await browser.click(`#rail [data-step=${step}]`);
    await settled();
    assert.deepEqual(await browser.run(() => [sinewPage.step, document.getElementById("error").hidden]), [step, true]);
  }
  await browser.screenshot(join(work, "firefox_export.png"));
  // What is downloaded, by its hash; without the clip, whose frames differ in the last digits between C libraries.
  await browser.click("#with-clips");
  await browser.run(() => {
    window.saved = new Promise((done) => {
      const make = URL.createObjectURL;
      URL.createObjectURL = (blob) => (blob.arrayBuffer().then((bytes) => crypto.subtle.digest("SHA-256", bytes)).then((hash) => done([...new Uint8Array(hash)].map((byte) => byte.toString(16).padStart(2, "0")).join(""))), make.call(URL, blob));
    });
    return true;
  });
  await settled();
  await browser.click("#onward");
  execFileSync(sinew, ["rig", "robot.obj", "-o", "robot.glb"], { cwd: work, stdio: "pipe" });
  assert.equal(await browser.run(() => window.saved), createHash("sha256").update(readFileSync(join(work, "robot.glb"))).digest("hex"), "the page's GLB differs from the command's");
  console.log(`firefox: ok, ${await browser.run(() => navigator.userAgent)}`);
} finally {
  await browser.close();
  server.close();
}
