// Keeps the page so that it opens without a network. What is newer comes first: the kept copy answers only where
// nothing else does.
const NAME = "mckibben-page-1";
/** Files of the page; a test compares the list with the folder. */
const FILES = [
  "examples/bench.csv", "examples/bench.toml", "examples/biceps.toml", "examples/drive.toml",
  "examples/elbow-drive.toml", "examples/elbow.toml", "examples/prototype.toml", "examples/shop.toml",
  "examples/thin.toml", "examples/tondu2012.toml", "icon-192.png", "icon.svg", "index.html", "js/address.js",
  "js/ask.js", "js/bar.js", "js/bench/along.js", "js/bench/controls.js", "js/bench/curves.js",
  "js/bench/dimensions.js", "js/bench/family.js", "js/bench/numbers.js", "js/bench/parts.js", "js/bench/points.js",
  "js/bench/round.js", "js/bench/solve.js", "js/bench/stage.js", "js/bench/store.js", "js/bench/tornado.js",
  "js/body.js", "js/border.js", "js/build-view.js", "js/candidates.js", "js/chart.js", "js/columns.js",
  "js/controls.js", "js/deflate.js", "js/design-map.js", "js/design-target.js", "js/design-view.js", "js/dialog.js",
  "js/dom.js", "js/drop.js", "js/engine/http.js", "js/engine/packed.js", "js/engine/problem.js",
  "js/engine/wasm.js", "js/engine/worker.js", "js/figure.js", "js/files-view.js", "js/form.js",
  "js/formula-view.js", "js/gallery.js", "js/gauge.js", "js/help.js", "js/joint-drawing.js", "js/joint-file.js",
  "js/joint-view.js", "js/joint-words.js", "js/kept.js", "js/kind.js", "js/library.js", "js/life.js", "js/lines.js",
  "js/main.js", "js/map.js", "js/measured.js", "js/motion-view.js", "js/muscle.js", "js/name.js", "js/notice.js",
  "js/offline.js", "js/open.js", "js/pages.js", "js/pages/about.js", "js/pages/compare.js", "js/pages/data.js",
  "js/pages/design.js", "js/pages/files.js", "js/pages/formula.js", "js/pages/joint.js", "js/pages/motion.js",
  "js/pages/muscle.js", "js/pages/parts.js", "js/pages/rubber.js", "js/pages/sweep.js", "js/plot.js", "js/print.js",
  "js/project.js", "js/report-viewer.js", "js/report.js", "js/shaders.js", "js/sketch.js", "js/state.js",
  "js/steps.js", "js/theme.js", "js/thin.js", "js/thumbnail.js", "js/trajectory.js", "js/units.js", "js/view3d.js",
  "js/visit.js", "js/welcome.js", "js/words.js", "js/zip.js", "manifest.webmanifest", "style.css",
];
/** The engine of the first view; js/offline.js fetches what is larger. */
const ENGINE = "live.wasm";

self.addEventListener("install", (event) => {
  const keep = async () => {
    const cache = await caches.open(NAME);
    await cache.addAll([...FILES, ENGINE]);
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
  const { request } = event, url = new URL(request.url), scope = new URL(self.registration.scope);
  // The book is not of the page.
  const path = url.pathname.slice(scope.pathname.length);
  if (
    request.method !== "GET" || url.origin !== scope.origin || !url.pathname.startsWith(scope.pathname) ||
    path.startsWith("docs/")
  ) return;
  const answer = async () => {
    const cache = await caches.open(NAME), file = path || "index.html";
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
