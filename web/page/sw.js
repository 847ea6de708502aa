// Keeps the page so that it opens without a network. What is newer comes first: the kept copy answers only where
// nothing else does.
const NAME = "mckibben-page-1";
/** The engine of the first view; js/offline.js fetches what is larger. */
const ENGINE = "live.wasm";

self.addEventListener("install", (event) => {
  const keep = async () => {
    // What the page is made of, as web/build.sh lists it.
    const [cache, files] = await Promise.all([
      caches.open(NAME),
      fetch("files.json").then((answer) => answer.json()),
    ]);
    await cache.addAll([...files, "files.json", ENGINE]);
    await self.skipWaiting();
  };
  event.waitUntil(keep());
});

self.addEventListener("activate", (event) => {
  const clean = async () => {
    for (const name of await caches.keys())
      if (name.startsWith("mckibben-page") && name !== NAME) await caches.delete(name);
  };
  event.waitUntil(clean());
});

self.addEventListener("fetch", (event) => {
  const { request } = event,
    url = new URL(request.url),
    scope = new URL(self.registration.scope);
  // The book is not of the page.
  const path = url.pathname.slice(scope.pathname.length);
  if (
    request.method !== "GET" ||
    url.origin !== scope.origin ||
    !url.pathname.startsWith(scope.pathname) ||
    path.startsWith("docs/")
  )
    return;
  const answer = async () => {
    const cache = await caches.open(NAME),
      file = path || "index.html";
    try {
      const fresh = await fetch(request);
      if (fresh.ok) await cache.put(file, fresh.clone()).catch(() => {});
      return fresh;
    } catch (error) {
      const kept = await cache.match(file);
      if (kept) return kept;
      throw error;
    }
  };
  event.respondWith(answer());
});
