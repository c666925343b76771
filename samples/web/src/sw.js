// SPDX-License-Identifier: MIT
// The page without a network: what it was made of last is kept, and given where the network gives nothing. build.sh lists the files.
const kept = "sinew";

addEventListener("install", (event) => {
  skipWaiting();
  event.waitUntil(
    (async () => {
      const files = await (await fetch("files.json")).json();
      const cache = await caches.open(kept);
      await cache.addAll(["./", ...files]);
    })(),
  );
});

addEventListener("activate", (event) => event.waitUntil(clients.claim()));

// The network first, so that a new page is never half an old one.
addEventListener("fetch", (event) => {
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
