// SPDX-License-Identifier: MIT
// The page without a network: what it was made of last is kept, and given where the network gives nothing. build.sh lists the files.
const kept = "sinew";
const worker = /** @type {any} */ (self);

worker.addEventListener("install", (/** @type {any} */ event) => {
  worker.skipWaiting();
  event.waitUntil(
    (async () => {
      const files = await (await fetch("files.json")).json();
      const cache = await caches.open(kept);
      await cache.addAll(["./", ...files]);
    })(),
  );
});

worker.addEventListener("activate", (/** @type {any} */ event) => event.waitUntil(worker.clients.claim()));

// The network first, so that a new page is never half an old one.
worker.addEventListener("fetch", (/** @type {any} */ event) => {
  const { request } = event;
  if (request.method !== "GET" || !request.url.startsWith(location.origin)) return;
  event.respondWith(
    (async () => {
      const cache = await caches.open(kept);
      try {
        const response = await fetch(request);
        if (response.ok) await cache.put(request, response.clone());
        return response;
      } catch (error) {
        const old = await cache.match(request, { ignoreSearch: true });
        if (old) return old;
        throw error;
      }
    })(),
  );
});
