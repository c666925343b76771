// SPDX-License-Identifier: MIT
// A Firefox for a test, driven over its own Marionette protocol: length:[type, id, name, parameters] each way. It draws into an Xvfb, since it has no WebGL without a display.
import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { connect } from "node:net";
import { tmpdir } from "node:os";
import { delimiter, join } from "node:path";

const inPath = (...names) => names.flatMap((name) => (process.env.PATH ?? "").split(delimiter).map((folder) => join(folder, name))).find((path) => existsSync(path)) ?? "";
export const findFirefox = () => process.env.SINEW_FIREFOX || inPath("firefox-esr", "firefox");
export const findXvfb = () => inPath("Xvfb");

const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

// The port that it listens at, which it writes into its profile.
async function portOf(profile) {
  for (let tries = 0; tries < 600; ++tries) {
    const file = join(profile, "MarionetteActivePort");
    if (existsSync(file)) return Number(readFileSync(file, "utf8"));
    await pause(100);
  }
  throw new Error("firefox: no port of Marionette after a minute");
}

// A display of its own: its number.
async function startDisplay() {
  const child = spawn(findXvfb(), ["-displayfd", "3", "-screen", "0", "1280x900x24", "-nolisten", "tcp"], { stdio: ["ignore", "ignore", "ignore", "pipe"] });
  const number = await new Promise((resolve, reject) => (child.stdio[3].once("data", (bytes) => resolve(String(bytes).trim())), child.once("error", reject), child.once("exit", () => reject(new Error("Xvfb: ended at once")))));
  return { child, display: `:${number}` };
}

export async function launchFirefox(program) {
  const { child: screen, display } = await startDisplay();
  const profile = mkdtempSync(join(tmpdir(), "sinew-firefox-"));
  const wishes = { "marionette.port": 0, "webgl.force-enabled": true, "browser.shell.checkDefaultBrowser": false, "datareporting.policy.dataSubmissionEnabled": false, "app.update.enabled": false };
  writeFileSync(join(profile, "user.js"), Object.entries(wishes).map(([name, value]) => `user_pref(${JSON.stringify(name)}, ${JSON.stringify(value)});`).join("\n"));
  const child = spawn(program, ["--marionette", "--remote-allow-system-access", "--no-remote", "--profile", profile], { stdio: "ignore", env: { ...process.env, HOME: profile, DISPLAY: display, LIBGL_ALWAYS_SOFTWARE: "1" } });
  const socket = connect(await portOf(profile), "127.0.0.1");
  const waiting = new Map();
  let text = Buffer.alloc(0), last = 0;
  socket.on("data", (bytes) => {
    text = Buffer.concat([text, bytes]);
    while (true) {
      const colon = text.indexOf(":"), length = Number(text.subarray(0, Math.max(0, colon)));
      if (colon < 0 || text.length < colon + 1 + length) return;
      const message = JSON.parse(text.subarray(colon + 1, colon + 1 + length));
      text = text.subarray(colon + 1 + length);
      if (!Array.isArray(message)) continue; // what it is
      const [, id, error, reply] = message;
      if (error) waiting.get(id)?.reject(new Error(`${error.error}: ${error.message}`));
      else waiting.get(id)?.resolve(reply?.value ?? reply);
    }
  });
  const ask = (name, parameters = {}) =>
    new Promise((resolve, reject) => {
      const line = JSON.stringify([0, ++last, name, parameters]);
      waiting.set(last, { resolve, reject });
      socket.write(`${Buffer.byteLength(line)}:${line}`);
    });
  await ask("WebDriver:NewSession", { capabilities: { alwaysMatch: { acceptInsecureCerts: true, timeouts: { script: 120000, pageLoad: 120000 } } } });
  return {
    open: (address) => ask("WebDriver:Navigate", { url: address }),
    // A function of the page: what it returns, or resolves to.
    run: (use, ...args) => ask("WebDriver:ExecuteScript", { script: `return (${use}).apply(null, arguments);`, args }),
    // What an input of files is given: paths.
    async choose(selector, path) {
      const element = await ask("WebDriver:FindElement", { using: "css selector", value: selector });
      await ask("WebDriver:ElementSendKeys", { id: Object.values(element)[0], text: path });
    },
    async click(selector) {
      const element = await ask("WebDriver:FindElement", { using: "css selector", value: selector });
      await ask("WebDriver:ElementClick", { id: Object.values(element)[0] });
    },
    screenshot: async (path) => writeFileSync(path, Buffer.from(await ask("WebDriver:TakeScreenshot", { full: false }), "base64")),
    async close() {
      await Promise.race([ask("Marionette:Quit", { flags: ["eForceQuit"] }).catch(() => {}), pause(5000)]);
      socket.destroy();
      child.kill();
      screen.kill();
      await pause(300);
      rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
    },
  };
}
