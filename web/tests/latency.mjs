// How long from an input event to the painted frame that shows its answer, and how soon the first view stands. Prints; asserts nothing.
// node tests/latency.mjs static|serve
import { alive, launch, served, statically, tab } from "./browser.mjs";
import { dist, program } from "./sites.mjs";

const site = process.argv[2] === "serve" ? await served(program) : await statically(dist);
const browser = await launch();
const quantile = (/** @type {number[]} */ list, /** @type {number} */ q) =>
  list.sort((a, b) => a - b)[Math.min(list.length - 1, Math.floor(q * list.length))];
const firsts = [];
for (let i = 0; i < 5; i++) {
  const { page, context } = await tab(browser);
  const began = Date.now();
  await page.goto(`${site.url}#muscle`, { waitUntil: "commit" });
  await alive(page);
  firsts.push(Date.now() - began);
  await context.close();
}
console.log(
  `first view with a living muscle: median ${quantile(firsts, 0.5)} ms, worst ${Math.max(...firsts)} ms`,
);
/** How long the first screen takes to answer, and to list all that fit. @type {[number[], number[]]} */
const [answers, candidates] = [[], []];
for (let i = 0; i < 5; i++) {
  const { page, context } = await tab(browser);
  await page.goto(site.url);
  await page.getByRole("heading", { name: /^A McKibben muscle is/ }).waitFor();
  const pull = page.getByLabel("It must pull", { exact: true });
  const head = page.locator(".question h2").filter({ hasText: / wide\.$/ });
  // A folder of files asks its large engine once somebody is about to.
  await pull.focus();
  await head.waitFor();
  const before = await head.innerText();
  await page.waitForTimeout(4000);
  const began = Date.now();
  await pull.fill(`${520 + 20 * i} N`);
  await head.filter({ hasNotText: before }).waitFor();
  answers.push(Date.now() - began);
  // What could take its place comes with it; then all that fit.
  await page.locator(".below tr.pick").first().waitFor({ timeout: 60_000 });
  candidates.push(Date.now() - began);
  await context.close();
}
console.log(
  `first screen: answer median ${quantile(answers, 0.5)} ms, worst ${Math.max(...answers)} ms; all that fit median ${quantile(candidates, 0.5)} ms, worst ${Math.max(...candidates)} ms`,
);
const { page } = await tab(browser);
await page.goto(`${site.url}#muscle`);
await alive(page);
await page.getByRole("button", { name: "Open", exact: true }).click();
const cards = page.locator("dialog .gallery").first().locator(".card");
const titles = await cards.locator("b").allTextContents();
await page.keyboard.press("Escape");
await page.waitForTimeout(4000);
/** To and fro on a slider. @param {import("playwright-core").Locator} slider */
async function delays(slider) {
  await slider.scrollIntoViewIfNeeded();
  const box = /** @type {any} */ (await slider.boundingBox()),
    at = Number(await slider.inputValue()) / 1000;
  const middle = Math.min(0.9, Math.max(0.1, at)),
    y = box.y + box.height / 2;
  await page.mouse.move(box.x + middle * box.width, y);
  await page.mouse.down();
  for (let i = 0; i < 60; i++) {
    await page.mouse.move(box.x + (middle + 0.08 * Math.sin(i / 6)) * box.width, y);
    await page.waitForTimeout(16);
  }
  await page.mouse.move(box.x + middle * box.width, y);
  await page.mouse.up();
  await page.waitForTimeout(800);
  return page.evaluate(() => /** @type {any} */ (window).delays.splice(0));
}
/** Measures from now on, and adds a slider that asks for nothing: the frame alone, in the same run. */
const measure = () =>
  page.evaluate(() => {
    const w = /** @type {any} */ (window);
    if (!w.delays) {
      document.addEventListener("input", (event) => w.open.push(event.timeStamp), true);
      // After the page's own: a value that stays asks for nothing.
      document.addEventListener("input", ({ target, timeStamp }) => {
        const text = /** @type {Element} */ (target).ariaValueText;
        if (text !== null && text === w.text)
          w.open = w.open.filter((/** @type {number} */ t) => t !== timeStamp);
        w.text = text;
      });
    }
    Object.assign(w, { delays: [], open: [] });
    const answered = new MutationObserver(() => {
      const mine = w.open.splice(0);
      // The frame is painted after its callbacks; a task queued in one runs once that is done.
      requestAnimationFrame(() => {
        const { port1, port2 } = new MessageChannel();
        port1.onmessage = () =>
          mine.forEach((/** @type {number} */ t) => w.delays.push(performance.now() - t));
        port2.postMessage(0);
      });
    });
    // A problem is an answer too.
    for (const where of [".stage .say", ".bench > .side > div"])
      answered.observe(/** @type {any} */ (document.querySelector(where)), { childList: true });
    document.querySelector("[aria-label=Nothing]")?.remove();
    const slider = Object.assign(document.createElement("input"), {
      type: "range",
      max: 1000,
      value: 500,
      ariaLabel: "Nothing",
    });
    slider.addEventListener("input", () =>
      document.querySelector(".stage .say")?.append(document.createComment("")),
    );
    document.querySelector(".controls")?.prepend(slider);
    for (const box of document.querySelectorAll(".controls details"))
      /** @type {HTMLDetailsElement} */ (box).open = true;
  });
for (const [i, title] of titles.entries()) {
  await page.goto(`${site.url}#rubber`);
  await page.goto(`${site.url}#muscle`);
  await page.getByRole("button", { name: "Open", exact: true }).click();
  await cards.nth(i).click();
  await page.waitForFunction(() => /file=/.test(location.hash));
  // A joint and a bench test: the muscle of their address.
  await page.evaluate(() => {
    location.hash = location.hash.replace(/^#[a-z]+/, "#muscle");
  });
  await alive(page);
  await page.waitForTimeout(4000);
  await measure();
  let empty = NaN;
  for (const name of await page
    .locator(".controls input[type=range]:enabled:visible")
    .evaluateAll((all) => all.map((one) => one.getAttribute("aria-label") ?? ""))) {
    const list = await delays(page.getByRole("slider", { name, exact: true }));
    if (!list.length) {
      console.log(`${title}: ${name}: no answer`);
      continue;
    }
    const [half, most, worst] = [0.5, 0.95, 1].map((q) => quantile(list, q));
    if (name === "Nothing") empty = most;
    console.log(
      `${title}: ${name}: ${list.length} inputs, median ${half.toFixed(1)} ms, 95 % ${most.toFixed(1)} ms (${(most / empty).toFixed(1)} null frames), worst ${worst.toFixed(1)} ms`,
    );
  }
}
/** How long 90 frames take while something is done in each, in milliseconds a frame. @param {(i: number) => Promise<void>} act */
async function frames(act) {
  await page.evaluate(() => {
    const w = /** @type {any} */ (window);
    w.stamps = [];
    const step = (/** @type {number} */ t) => {
      w.stamps.push(t);
      w.going = requestAnimationFrame(step);
    };
    w.going = requestAnimationFrame(step);
  });
  for (let i = 0; i < 90; i++) await act(i);
  const stamps = await page.evaluate(() => {
    const w = /** @type {any} */ (window);
    cancelAnimationFrame(w.going);
    return w.stamps;
  });
  return stamps.slice(1).map((/** @type {number} */ t, /** @type {number} */ i) => t - stamps[i]);
}
const stage = /** @type {any} */ (await page.locator(".stage canvas").boundingBox());
const to = (/** @type {number} */ i) =>
  page.mouse.move(
    stage.x + 0.4 * stage.width + 2 * i,
    stage.y + 0.5 * stage.height + 20 * Math.sin(i / 9),
  );
const still = await frames(to);
await page.mouse.move(stage.x + 0.4 * stage.width, stage.y + 0.5 * stage.height);
await page.mouse.down();
const turning = await frames(to);
await page.mouse.up();
const [idle, busy] = [still, turning].map((list) => quantile(list, 0.5));
console.log(
  `frames at 1440: ${idle.toFixed(1)} ms with nothing to draw, ${busy.toFixed(1)} ms while the muscle turns (${(busy / idle).toFixed(2)} null frames), 95 % ${quantile(turning, 0.95).toFixed(1)} ms`,
);
await browser.close();
site.end();
