// What tests of the page begin with: where things are, the command line, and both engines in turn, in a browser or without one.
// DIST: the folder of web/build.sh; MCKIBBEN: the program; ENGINES: serve, static or all; SHOTS: where pictures go.
import { execFileSync } from "node:child_process";
import { mkdirSync } from "node:fs";
import { after, before, describe } from "node:test";
import { launch, served, statically, tab } from "./browser.mjs";

export const root = new URL("../..", import.meta.url).pathname;
export const program = process.env.MCKIBBEN ?? `${root}target/release/mckibben`;
export const dist = process.env.DIST ?? `${root}web/dist`;
export const shots = process.env.SHOTS ?? `${root}target/workbench`;

/** The command line's answer as JSON. @param {string[]} line */
export const ask = (...line) =>
  JSON.parse(
    execFileSync(program, [...line, "--format", "json"], {
      encoding: "utf8",
      cwd: root,
      stdio: ["ignore", "pipe", "ignore"],
    }),
  );

/** Those that were asked for, of what has the engines' names. @template T @param {{ static: T, serve: T }} all @returns {[string, T][]} */
export const engines = (all) =>
  Object.entries(all).filter(([name]) => ["all", name].includes(process.env.ENGINES ?? "all"));

/**
 * Tests of the page in a browser, once for each engine.
 * @typedef {{
 *   name: string,
 *   url: () => string,
 *   open: (hash: string, options?: import("playwright-core").BrowserContextOptions) => ReturnType<typeof tab>,
 *   blank: () => ReturnType<typeof tab>,
 * }} Site its engine's name, its address, a page of it, and a tab without one
 * @param {(site: Site) => void} tests
 */
export function inBrowser(tests) {
  mkdirSync(shots, { recursive: true });
  /** @type {import("playwright-core").Browser} */ let browser;
  before(async () => {
    browser = await launch();
  });
  after(() => browser.close());
  for (const [name, start] of engines({
    static: () => statically(dist),
    serve: () => served(program),
  })) {
    describe(name, { concurrency: false }, () => {
      /** @type {{ url: string, end: () => void }} */ let site;
      before(async () => {
        site = await start();
      });
      after(() => site.end());
      const blank = () => tab(browser);
      const open = async (/** @type {string} */ hash, /** @type {any} */ options) => {
        const opened = await tab(browser, options);
        await opened.page.goto(site.url + hash);
        return opened;
      };
      tests({ name, url: () => site.url, open, blank });
    });
  }
}
