// The working tree's page in front of a running `mckibben serve`: files of a folder, and everything below /api/ from the program.
// For tests and for looking at a page without a build: PAGE=web/page MCKIBBEN=… bash web/test.sh serve, or node tests/look.mjs
import { createServer, request as ask } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const TYPES = /** @type {Record<string, string>} */ ({
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".css": "text/css; charset=utf-8",
  ".json": "application/json",
  ".svg": "image/svg+xml",
  ".png": "image/png",
  ".webmanifest": "application/manifest+json",
  ".txt": "text/plain; charset=utf-8",
  ".toml": "text/plain; charset=utf-8",
  ".csv": "text/plain; charset=utf-8",
});
const ROOT = fileURLToPath(new URL("../..", import.meta.url));
/** As the server sends them (crates/mckibben-server/src/request_guard.rs), read from there. */
async function headers() {
  const door = await readFile(join(ROOT, "crates/mckibben-server/src/request_guard.rs"), "utf8");
  const list = /const HEADERS[^=]*= \[([\s\S]*?)\n\];/.exec(door)?.[1] ?? "";
  const pairs = list.replace(/\\\n\s*/g, "").matchAll(/"([a-z-]+)",\s*"([^"]*)"/g);
  return Object.fromEntries([...pairs].map(([, name, value]) => [name, value]));
}

/** A file of the page, as crates/mckibben-server/src/page.rs finds it. @param {string} folder @param {string} path */
async function file(folder, path) {
  if (path === "js/kind.js")
    return 'export { Engine } from "./engine/http.js";\nexport const DOCUMENTATION = "";\n';
  if (path.startsWith("examples/")) return readFile(join(ROOT, path));
  return readFile(join(folder, path));
}

/**
 * @param {{ url: string, end: () => void, kill?: () => void }} behind the running program @param {string} page a folder, from the repository's root
 */
export async function workingTree(behind, page) {
  const folder = resolve(ROOT, page),
    back = new URL(behind.url),
    common = await headers();
  const server = createServer(async (request, answer) => {
    const url = new URL(request.url ?? "/", "http://x");
    if (url.pathname.startsWith("/api/")) {
      const { host, origin, ...rest } = request.headers;
      const sent = { ...rest, host: back.host, ...(origin && { origin: back.origin }) };
      const to = {
        host: back.hostname,
        port: back.port,
        path: request.url,
        method: request.method,
        headers: sent,
      };
      const on = ask(to, (got) => {
        answer.writeHead(got.statusCode ?? 502, got.headers);
        got.pipe(answer);
      });
      on.on("error", () => answer.destroy());
      answer.on("close", () => on.destroy());
      request.pipe(on);
      return;
    }
    const path = normalize(decodeURIComponent(url.pathname)).slice(1) || "index.html";
    try {
      const bytes = gzipSync(await file(folder, path), { level: 1 });
      const kind = TYPES[extname(path)] ?? "application/octet-stream";
      answer
        .writeHead(200, {
          ...common,
          "content-type": kind,
          "content-encoding": "gzip",
          "cache-control": "no-cache",
        })
        .end(bytes);
    } catch {
      answer.writeHead(404, common).end();
    }
  });
  await new Promise((done) =>
    server.listen(Number(process.env.PORT ?? 0), "127.0.0.1", () => done(undefined)),
  );
  const { port } = /** @type {import("node:net").AddressInfo} */ (server.address());
  const close = () => {
    server.close();
    server.closeAllConnections();
  };
  return {
    url: `http://127.0.0.1:${port}/`,
    end() {
      close();
      behind.end();
    },
    kill() {
      close();
      (behind.kill ?? behind.end)();
    },
  };
}
