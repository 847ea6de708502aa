// What the tests share: a browser, a file server for the static page under a sub-path, and the page's words.
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";
import { spawn } from "node:child_process";
import { chromium } from "playwright-core";
import { PAGES } from "../page/js/pages.js";
import { workingTree } from "./working-tree.mjs";

const TYPES = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".wasm": "application/wasm",
  ".svg": "image/svg+xml",
};

/** The static page, as any file server would hand it out, below /tools/muscles/. @param {string} folder */
export async function statically(folder) {
  const server = createServer(async (request, answer) => {
    const path = normalize(decodeURIComponent(new URL(request.url ?? "/", "http://x").pathname));
    if (!path.startsWith("/tools/muscles/")) return answer.writeHead(404).end();
    const file = path.slice("/tools/muscles/".length) || "index.html";
    try {
      const bytes = await readFile(join(folder, file));
      answer
        .writeHead(200, { "content-type": TYPES[extname(file)] ?? "application/octet-stream" })
        .end(bytes);
    } catch {
      answer.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(undefined)));
  const { port } = /** @type {any} */ (server.address());
  return { url: `http://127.0.0.1:${port}/tools/muscles/`, end: () => server.close() };
}

/** `mckibben serve`; with PAGE=FOLDER in the environment, that folder's page in front of it. @param {string} program */
export async function served(program) {
  const child = spawn(program, ["serve", "--port", "0"], { stdio: ["ignore", "pipe", "inherit"] });
  const url = await new Promise((resolve, reject) => {
    child.stdout.on("data", (data) => {
      const found = /http:\/\/\S+/.exec(String(data));
      if (found) resolve(found[0].replace(/\/?$/, "/"));
    });
    child.on("exit", (code) => reject(new Error(`serve ended with ${code}`)));
  });
  child.removeAllListeners("exit");
  const behind = {
    url: String(url),
    end: () => child.kill("SIGTERM"),
    kill: () => child.kill("SIGKILL"),
  };
  return process.env.PAGE ? workingTree(behind, process.env.PAGE) : behind;
}

export const launch = () =>
  chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: (process.env.CHROMIUM_FLAGS ?? "--no-sandbox --enable-unsafe-swiftshader").split(" "),
  });

/** A busy machine: SLOW=2 holds every answer of the engine back by 0 to 2 s, and slows the page's own work eight times. */
const SLOW = Number(process.env.SLOW ?? 0);
/** @param {import("playwright-core").Page} page */
async function slowed(page) {
  await page.route(/\/api\//, async (route) => {
    await new Promise((resolve) => setTimeout(resolve, 1000 * SLOW * Math.random() ** 2));
    await route.continue().catch(() => {});
  });
  const session = await page.context().newCDPSession(page);
  await session.send("Emulation.setCPUThrottlingRate", { rate: 8 });
}

/** The check, again until it holds; what it says after ten seconds otherwise. @param {() => Promise<unknown>} check */
export async function soon(check, timeout = 10_000 * (1 + SLOW)) {
  for (const end = Date.now() + timeout; ;) {
    try {
      return await check();
    } catch (error) {
      if (Date.now() > end) throw error;
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
  }
}

/** A page that fails the test on any error of its own; answers that say what is wrong with a request (422) are none. @param {import("playwright-core").Browser} browser @param {import("playwright-core").BrowserContextOptions} [options] */
export async function tab(browser, options = {}) {
  const context = await browser.newContext({
    viewport: { width: 1440, height: 900 },
    acceptDownloads: true,
    serviceWorkers: "block",
    ...options,
  });
  const page = await context.newPage();
  if (SLOW) await slowed(page);
  /** @type {string[]} */
  const errors = [];
  page.on("console", (message) => {
    if (message.type() === "error" && !/status of 422/.test(message.text()))
      errors.push(message.text());
  });
  page.on("pageerror", (error) => errors.push(error.message));
  return { page, errors, context };
}

/** An engine whose every question ends in a trap, with a panic's words where its answer would stand. @param {string} words */
export function trapping(words) {
  const [text, encoder] = [new TextEncoder().encode(words), new TextEncoder()];
  const list = (/** @type {(number | number[] | Uint8Array)[][]} */ items) => [
    items.length,
    ...items.flatMap((item) => item.flatMap((x) => (typeof x === "number" ? [x] : [...x]))),
  ];
  const section = (/** @type {number} */ id, /** @type {number[]} */ bytes) => [
    id,
    bytes.length,
    ...bytes,
  ];
  const named = (
    /** @type {string} */ name,
    /** @type {number} */ kind,
    /** @type {number} */ index,
  ) => [name.length, encoder.encode(name), kind, index];
  const body = (/** @type {number[]} */ code) => [code.length + 2, 0, code, 0x0b];
  return Buffer.from([
    0,
    0x61,
    0x73,
    0x6d,
    1,
    0,
    0,
    0,
    // Types: number to number, nothing to number, nothing to nothing.
    ...section(
      1,
      list([
        [0x60, 1, 0x7f, 1, 0x7f],
        [0x60, 0, 1, 0x7f],
        [0x60, 0, 0],
      ]),
    ),
    ...section(3, list([[0], [0], [1], [1], [2]])),
    ...section(5, list([[0, 1]])),
    ...section(
      7,
      list([
        named("memory", 2, 0),
        named("reserve", 0, 0),
        named("ask", 0, 1),
        named("answer", 0, 2),
        named("answer_length", 0, 3),
        named("start", 0, 4),
      ]),
    ),
    // reserve: 2048; ask: unreachable; answer: 0; answer_length: that of the words.
    ...section(
      10,
      list([
        body([0x41, 0x80, 0x10]),
        body([0x00]),
        body([0x41, 0]),
        body([0x41, text.length]),
        body([]),
      ]),
    ),
    ...section(11, list([[0, 0x41, 0, 0x0b, text.length, text]])),
  ]);
}

/** Until the muscle page has a state. @param {import("playwright-core").Page} page */
export const alive = (page, timeout = 20_000) =>
  page.waitForFunction(
    () => /the model|Slack/.test(document.querySelector(".stage .say")?.textContent ?? ""),
    undefined,
    { timeout },
  );
/** @param {import("playwright-core").Page} page */
export const pull = (page) => page.locator(".stage .say b").innerText();

/** The model's pull as the page writes it. @param {any} said */
export const modelPull = ({ force_n: n }) =>
  `${n < 1000 ? Number(n.toPrecision(4)) : n.toFixed(0)} N`;
/** What a muscle that is built pulls, in the digits of the command line. @param {any} said */
export function asBuilt({ uncertainty_words: { built } }) {
  const [, ...three] = /^(\S+)\sN \((\S+)\sN to (\S+)\sN, 95 %\)/.exec(built) ?? [];
  return `${three[0]} N (${three[1]} to ${three[2]} N)`;
}
/** Both as they stand on the stage, as built first. @param {any} said */
export const asShown = (said) => {
  const moves = /** @type {Record<string, string>} */ ({
    contraction: " while it shortens",
    elongation: " while it lengthens",
  });
  const way = moves[said.predicted_direction ?? "contraction"] ?? "";
  return `${asBuilt(said)}as built${way}; the model (${said.model}): ${modelPull(said)}`;
};

/** What a page holds, when nothing comes any more. @param {import("playwright-core").Page} page */
export async function meter(page) {
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable");
  const now = async () => {
    await session.send("HeapProfiler.collectGarbage");
    const { metrics } = await session.send("Performance.getMetrics");
    const of = (/** @type {string} */ key) =>
      metrics.find(({ name }) => name === key)?.value ?? NaN;
    return {
      nodes: of("Nodes"),
      listeners: of("JSEventListeners"),
      heap: of("JSHeapUsedSize") / 1e6,
    };
  };
  return async () => {
    // A locator: a handle, as waitForSelector gives it, would keep the drawing.
    await page.locator("svg.curves").first().waitFor();
    // Curves and numbers arrive one after the other.
    for (let before = await now(), same = 0; ;) {
      await page.waitForTimeout(300);
      const next = await now();
      same = next.nodes === before.nodes ? same + 1 : 0;
      before = next;
      if (same === 5) return next;
    }
  };
}

/** To a view by its name: its place, and from there the view. @param {import("playwright-core").Page} page @param {string} where */
export async function go(page, where, timeout = 20_000) {
  const name = where.toLowerCase(),
    { place } = PAGES.find((one) => one.name === name) ?? PAGES[0];
  await page.locator(`#pages a[data-place=${place}]`).click();
  const shown = page.locator("main[data-shown]");
  await page.waitForFunction(
    (of) => document.querySelector(`#pages a[data-place=${of}]`)?.getAttribute("aria-current"),
    place,
  );
  const view = page.locator(`#views a[data-name=${name}]`);
  if (await view.count()) await view.click();
  await shown.and(page.locator(`main[data-shown=${name}]`)).waitFor({ timeout });
}
/** What stands behind the sign ⋯ of a chart: its table, or a file of it. @param {import("playwright-core").Page | import("playwright-core").Locator} of the page for its first chart, or a region @param {string} what */
export async function ofChart(of, what) {
  const menu = of.locator(":not(.muscle-bar) > .menu").first(),
    one = menu.getByRole("button", { name: what, exact: true });
  if (!(await one.isVisible())) await menu.locator("summary").click();
  await one.click();
}
/** A window of the bar: `Parts`, `Build & export`, `Help`. @param {import("playwright-core").Page} page @param {string} name */
export async function opened(page, name) {
  const button = page.getByRole("button", { name, exact: true });
  if (!(await button.isVisible())) await page.locator(".muscle-bar .menu summary").click();
  await button.click();
  const box = page.locator("dialog[open]");
  await box.waitFor();
  return box;
}
/** Files through the window Open. @param {import("playwright-core").Page} page @param {any} files */
export async function openFiles(page, files) {
  await page.getByRole("button", { name: "Open", exact: true }).click();
  await page.locator("dialog input[type=file]").setInputFiles(files);
}
