// Use over minutes: what somebody does again and again leaves elements, listeners and memory as they were.
// MINUTES: so long; without it as many rounds as show a leak of a round.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { alive, go, meter } from "./browser.mjs";
import { inBrowser, root } from "./sites.mjs";

/** @typedef {import("playwright-core").Page} Page */
const MINUTES = Number(process.env.MINUTES ?? 0),
  ROUNDS = 2;
const FILES = ["tondu2012.toml", "shop.toml"].map((name) => ({
  name,
  text: readFileSync(`${root}examples/${name}`, "utf8"),
}));
const VISITED = ["Design", "Joint", "Motion", "Data", "Rubber", "Muscle"];

/** A server that is left in the middle of work may have to end it first. */
const LONG = 120_000;
/** A slider to and fro, and back to where it was. @param {Page} page @param {string} name */
async function drag(page, name) {
  const slider = page.getByRole("slider", { name, exact: true });
  await slider.scrollIntoViewIfNeeded();
  const { x, y, width, height } = /** @type {any} */ (await slider.boundingBox());
  await page.mouse.move(x + 0.4 * width, y + height / 2);
  await page.mouse.down();
  for (let i = 1; i <= 20; i++)
    await page.mouse.move(x + (0.4 + 0.1 * Math.sin(i / 3)) * width, y + height / 2);
  await page.mouse.move(x + 0.4 * width, y + height / 2);
  await page.mouse.up();
}
/** @param {Page} page @param {typeof FILES[number]} file */
const drop = (page, file) =>
  page.evaluate(({ name, text }) => {
    const data = new DataTransfer();
    data.items.add(new File([text], name));
    for (const kind of ["dragover", "drop"])
      document
        .querySelector("#bar")
        ?.dispatchEvent(
          new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }),
        );
  }, file);

inBrowser(({ open }) => {
  test(`${MINUTES ? `${MINUTES} minutes` : `${ROUNDS} rounds`} of use leave elements, listeners and memory as they were`, async () => {
    const { page, errors, context } = await open("#muscle");
    await alive(page, LONG);
    const complete = await meter(page);
    let rounds = 0;
    const round = async () => {
      await drop(page, FILES[rounds++ % FILES.length]);
      await page.waitForFunction(() => /file=/.test(location.hash));
      await alive(page, LONG);
      for (const name of ["Pressure", "Contraction", "Length"]) await drag(page, name);
      for (const where of VISITED) {
        await go(page, where, LONG);
        await page.waitForLoadState("networkidle");
      }
      await page.getByRole("button", { name: "Help" }).click();
      await page.keyboard.press("Escape");
      await alive(page, LONG);
    };
    // What is loaded and kept once: libraries, meshes, the last answers of long work.
    for (let i = 0; i < (MINUTES ? 4 : 2); i++) await round();
    const before = await complete(),
      began = Date.now();
    for (let i = 0; MINUTES ? Date.now() - began < 60_000 * MINUTES : i < ROUNDS; i++)
      await round();
    // As many files were opened: the same one lies open.
    if (rounds % 2) await round();
    const most = {
      nodes: 1.03 * before.nodes,
      listeners: 1.03 * before.listeners,
      heap: 1.15 * before.heap + 1,
    };
    let after = await complete();
    const grown = () =>
      /** @type {(keyof typeof most)[]} */ (Object.keys(most)).filter(
        (key) => after[key] > most[key],
      );
    // What an answer on its way still holds goes with it.
    for (let i = 0; i < 10 && grown().length; i++) after = await complete();
    console.log(`${rounds} rounds: ${JSON.stringify(before)}, then ${JSON.stringify(after)}`);
    assert.deepEqual(
      grown(),
      [],
      `before ${JSON.stringify(before)}, after ${rounds} rounds ${JSON.stringify(after)}`,
    );
    assert.deepEqual(errors, []);
    await context.close();
  });
});
