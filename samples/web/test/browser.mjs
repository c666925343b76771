// SPDX-License-Identifier: MIT
// For the page's test: a web server for a folder, and a headless Chromium.
import { createReadStream, existsSync, mkdtempSync, rmSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { delimiter, extname, join, normalize } from "node:path";
import { chromium } from "playwright-core";

const types = {
  ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm",
  ".svg": "image/svg+xml", ".png": "image/png", ".webp": "image/webp", ".json": "application/json", ".webmanifest": "application/manifest+json",
  ".gltf": "model/gltf+json", ".obj": "text/plain", ".txt": "text/plain",
};

export async function serve(folder) {
  const server = createServer((request, response) => {
    const path = join(folder, normalize(new URL(request.url, "http://page").pathname.replace(/\/$/, "/index.html")));
    if (!path.startsWith(folder) || !existsSync(path) || !statSync(path).isFile()) {
      response.writeHead(404).end();
      return;
    }
    response.writeHead(200, { "content-type": types[extname(path)] ?? "application/octet-stream" });
    createReadStream(path).pipe(response);
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}

export function findChromium() {
  if (process.env.SINEW_CHROMIUM) return process.env.SINEW_CHROMIUM;
  for (const name of ["chromium", "google-chrome", "google-chrome-stable", "chromium-browser"]) {
    for (const folder of (process.env.PATH ?? "").split(delimiter)) {
      if (existsSync(join(folder, name))) return join(folder, name);
    }
  }
  throw new Error("no chromium and no google-chrome in PATH: run scripts/setup.sh, or name one in SINEW_CHROMIUM");
}

export async function launch() {
  const profile = mkdtempSync(join(tmpdir(), "sinew-web-"));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath: findChromium(),
    headless: true,
    acceptDownloads: true,
    viewport: { width: 1280, height: 800 },
    args: [
      "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update",
      "--disable-sync", ...(process.env.SINEW_CHROMIUM_ARGS?.split(" ").filter(Boolean) ?? ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"]),
    ],
  });
  return { context, close: async () => (await context.close(), rmSync(profile, { recursive: true, force: true })) };
}
