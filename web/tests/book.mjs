// The book in Chromium: every page at 400 and 1440 pixels. Nothing is loaded from elsewhere, nothing is broader than the window, every
// link leads somewhere, axe finds nothing, light and dark, and the search finds a word.
// node tests/book.mjs FOLDER [SHOTS]
import { strict as assert } from "node:assert";
import { existsSync, mkdirSync } from "node:fs";
import axe from "axe-core";
import { launch, statically, tab } from "./browser.mjs";

const [folder, shots] = process.argv.slice(2),
  site = await statically(folder),
  browser = await launch();
/** @type {Map<string, Set<string>>} names of places on each page */ const places = new Map();
/** @type {[string, string, string][]} */ const links = [];
/** @type {string[]} */ const wrong = [];
if (shots) mkdirSync(shots, { recursive: true });
const { page, errors, context } = await tab(browser, { viewport: { width: 1440, height: 900 } });
page.setDefaultTimeout(120_000);
await context.route(
  (url) => !url.href.startsWith(site.url),
  (route) => {
    wrong.push(`loads ${route.request().url()}`);
    return route.abort();
  },
);
const todo = ["index.html"];
for (let address; (address = todo.shift());) {
  if (places.has(address)) continue;
  await page.goto(site.url + address);
  const found = await page.evaluate(() => ({
    ids: [...document.querySelectorAll("[id]")].map((e) => e.id),
    links: [
      .../** @type {NodeListOf<HTMLAnchorElement>} */ (document.querySelectorAll("a[href]")),
    ].map((a) => a.href),
    broken: [...document.images].filter((i) => i.complete && !i.naturalWidth).map((i) => i.src),
  }));
  places.set(address, new Set(found.ids));
  found.broken.forEach((image) => wrong.push(`${address}: no picture ${image}`));
  for (const link of found.links.filter((l) => l.startsWith(site.url))) {
    const [to, anchor = ""] = link.slice(site.url.length).split("#");
    links.push([address, to || "index.html", decodeURIComponent(anchor)]);
    if (to.endsWith(".html") && existsSync(`${folder}/${to}`)) todo.push(to);
  }
  for (const [width, theme] of /** @type {[number, string][]} */ ([
    [1440, "light"],
    [400, "light"],
    [400, "navy"],
  ])) {
    await page.setViewportSize({ width, height: 900 });
    if (theme === "navy" || width > 1000) {
      await page.evaluate((name) => localStorage.setItem("mdbook-theme", name), theme);
      await page.reload();
    }
    const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    if (over > 0) wrong.push(`${address}: ${over} pixels broader than ${width}`);
    if (shots)
      await page.screenshot({
        path: `${shots}/${address.replaceAll("/", "-")}-${width}-${theme}.png`,
      });
    // In the dark only colours differ, and a narrow page has the same elements.
    if (width < 1000 && theme === "light") continue;
    await page.evaluate(axe.source);
    const rules = theme === "navy" ? { runOnly: ["color-contrast"] } : {};
    const { violations } = await page.evaluate(
      (asked) =>
        /** @type {any} */ (window).axe.run(document, { resultTypes: ["violations"], ...asked }),
      rules,
    );
    for (const v of violations)
      wrong.push(`${address} ${width} ${theme}: ${v.id}: ${v.nodes[0].target} (${v.nodes.length})`);
  }
  await page.setViewportSize({ width: 1440, height: 900 });
  if (process.env.VERBOSE)
    console.log(address, wrong.filter((line) => line.startsWith(address)).join("\n  "));
}
for (const [from, to, anchor] of links) {
  if (!existsSync(`${folder}/${to}`)) {
    if (!to.startsWith("../")) wrong.push(`${from}: no page ${to}`);
  } else if (anchor && places.has(to) && !places.get(to)?.has(anchor))
    wrong.push(`${from}: no place ${to}#${anchor}`);
}
await page.goto(`${site.url}index.html?search=seating`);
await page
  .waitForSelector("#mdbook-searchresults li, #searchresults li", { timeout: 5000 })
  .catch(() => wrong.push("the search finds nothing"));
await browser.close();
site.end();
assert.deepEqual([...new Set([...wrong, ...errors])], [], `${places.size} pages`);
console.log(
  `the book: ${places.size} pages, ${links.length} links, at 400 and 1440 pixels, light and dark: nothing is wrong`,
);
