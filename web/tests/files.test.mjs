// The muscle as files, one measure over a range, and a rubber from its test: with the numbers of the command line.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { zipSync } from "../page/js/vendor/fflate.js";
import { alive, ofChart, openFiles, opened, pull, soon } from "./browser.mjs";
import { overHttp } from "./engines.mjs";
import { ask, inBrowser, program, root } from "./sites.mjs";

/** @typedef {import("playwright-core").Page} Page */
const card = (/** @type {Page} */ page, /** @type {string} */ name) =>
  page.getByRole("region", { name, exact: true });
/** What a click downloads. @param {Page} page @param {{ click: (options?: { timeout: number }) => Promise<unknown> }} button */
async function downloaded(page, button) {
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    button.click({ timeout: 120_000 }),
  ]);
  return {
    name: download.suggestedFilename(),
    bytes: readFileSync(/** @type {string} */ (await download.path())),
  };
}
/** Entries of an archive as Python's zipfile reads them, which checks their sums. @param {Buffer} bytes */
function entries(bytes) {
  const file = join(mkdtempSync(join(tmpdir(), "zip-")), "all.zip");
  writeFileSync(file, bytes);
  const script =
    "import sys, zipfile, json; z = zipfile.ZipFile(sys.argv[1]); assert z.testzip() is None; " +
    "print(json.dumps({n: z.read(n).decode('latin1') for n in z.namelist()}))";
  const said = execFileSync("python3", ["-c", script, file], { encoding: "utf8", maxBuffer: 1e8 });
  return /** @type {Record<string, string>} */ (JSON.parse(said));
}
/** Rows of a chart's CSV. @param {Page} page */
async function saved(page) {
  const { bytes } = await downloaded(page, { click: () => ofChart(page, "CSV") });
  return bytes
    .toString()
    .trim()
    .split("\n")
    .map((line) => line.split(","));
}

test("an archive has its files as they were, for a reader that is not ours", async () => {
  const texts = { "a.txt": "one\n", "folder/b.bin": "\u0000\u00ff\n", empty: "" };
  const files = Object.entries(texts).map(([name, text]) => [
    name,
    new Uint8Array(Buffer.from(text, "latin1")),
  ]);
  assert.deepEqual(entries(Buffer.from(zipSync(Object.fromEntries(files), { level: 0 }))), texts);
});

inBrowser(({ name, url, open, blank }) => {
  test("a build sheet and an export have the units of the page and the name of the muscle", async () => {
    const { page, errors, context } = await open("#files?name=Left%20arm");
    await page.getByRole("button", { name: "Make the build sheet" }).click();
    const file = (/** @type {string} */ called) =>
      page.getByRole("button", { name: called, exact: true });
    await file("README.md").waitFor({ timeout: 120_000 });
    const sheet = (await downloaded(page, file("README.md"))).bytes.toString();
    assert.match(sheet, /it is blocked at .* at 2\.5 bar/);
    assert.ok(!sheet.includes("0.25 MPa"));
    const toml = (await downloaded(page, file("muscle.toml"))).bytes.toString();
    assert.match(toml, /^name = "Left arm"$/m);
    const out = card(page, "Controllers and simulators");
    await out.getByRole("combobox", { name: "Target" }).selectOption("c");
    await out.getByRole("button", { name: "Export", exact: true }).click();
    await file("muscle_left_arm.h").waitFor({ timeout: 120_000 });
    // A name that only its file states is one too, and it is shown at what it was designed for.
    const other = await open("#muscle");
    await alive(other.page);
    const job =
      "pressure = '1.5 bar'\npoints = [{ force = '90 N', contraction = 0.12 }] # required of it";
    await openFiles(other.page, {
      name: "any.toml",
      mimeType: "text/plain",
      buffer: Buffer.from(`${toml}\n[job]\n${job}\n`),
    });
    await soon(async () => assert.match(other.page.url(), /p=1\.5bar&e=12%.*file=/));
    await opened(other.page, "Build & export");
    const again = card(other.page, "Controllers and simulators");
    await again.getByRole("combobox", { name: "Target" }).selectOption("c");
    await again.getByRole("button", { name: "Export", exact: true }).click();
    await again
      .getByRole("button", { name: "muscle_left_arm.h", exact: true })
      .waitFor({ timeout: 120_000 });
    assert.deepEqual([...errors, ...other.errors], []);
    await Promise.all([context.close(), other.context.close()]);
  });

  if (name === "serve")
    test("the curves of a comparison are the engine's points, and a gap is no point", async () => {
      const { page, context } = await open("#data");
      const file = `${root}examples/bench.csv`;
      await page.locator(".controls input[type=file]").setInputFiles(file);
      await page.locator(".chart h3").first().waitFor({ timeout: 120_000 });
      const chart = page.locator(".chart").filter({ has: page.locator("h3") });
      const { bytes } = await downloaded(page, { click: () => ofChart(chart.first(), "CSV") });
      const rows = bytes
        .toString()
        .trim()
        .split("\n")
        .slice(1)
        .map((row) => row.split(",").slice(-2));
      const { figure } = await overHttp(url())("compare", {
        muscle: {},
        data: [{ name: "bench.csv", text: readFileSync(file, "utf8") }],
        models: ["fe", "thick-wall", "ideal"],
        extrapolate: true,
        figure: "bar",
      });
      // Behind them the measured points, by pressure and branch.
      const points = figure.panels[0].series.flatMap((/** @type {any} */ s) =>
        s.style === "points" ? [] : s.points,
      );
      assert.equal(rows.length, points.length + 10);
      const gaps = points.filter((/** @type {any} */ p) => p.includes(null));
      assert.ok(gaps.length > 0);
      points.forEach((/** @type {any} */ [x, y], /** @type {number} */ i) => {
        const at = `row ${i}: ${rows[i]}`;
        if (y === null) assert.equal(rows[i][1], "", at);
        else assert.ok(Math.abs(Number(rows[i][1]) - y) < 1e-6, at);
        if (x === null) assert.equal(rows[i][0], "", at);
        else assert.ok(Math.abs(Number(rows[i][0]) - 100 * x) < 1e-6, at);
      });
      await context.close();
    });

  test("an export has the command line's error, and its files one by one and as an archive", async () => {
    const { page, errors, context } = await open("#files?D=38&p=2.2bar");
    const out = card(page, "Controllers and simulators");
    await out.getByRole("combobox", { name: "Target" }).selectOption("python");
    await out.getByText("Needs NumPy").waitFor();
    await out.getByRole("combobox", { name: "Target" }).selectOption("c");
    await out.getByRole("button", { name: "Export", exact: true }).click();
    const folder = mkdtempSync(join(tmpdir(), "c-"));
    const said = ask("export", "-D", "38", "-p", "2.2bar", "--as", "c", "-o", folder);
    const worst = `${Number((100 * said.force_worst_ratio).toPrecision(2))} % at worst`;
    await out.getByText(worst).waitFor({ timeout: 120_000 });
    const header = await downloaded(
      page,
      out.getByRole("button", { name: "muscle.h", exact: true }),
    );
    const archive = entries(
      (await downloaded(page, out.getByRole("button", { name: /^All files/ }))).bytes,
    );
    assert.equal(archive["muscle.h"], header.bytes.toString("latin1"));
    assert.deepEqual(Object.keys(archive).sort(), readdirSync(folder).sort());
    await soon(async () => assert.match(page.url(), /D=38/));
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("the report has its title block, the muscle's pull, and a view that turns, in one file", async () => {
    const { page, errors, context } = await open("#files?D=38&p=2.2bar&e=10%25&name=Calf");
    const report = card(page, "Report");
    for (const [label, text] of [
      ["Project", "Leg"],
      ["Number", "M-17"],
      ["Revision", "1,5"],
      ["Date", "2026-11-23"],
    ])
      await report.getByRole("textbox", { name: label, exact: true }).fill(text);
    await report.getByRole("button", { name: "Make the report" }).click();
    const { name: file, bytes } = await downloaded(
      page,
      report.getByRole("button", { name: "calf-report.html" }),
    );
    assert.equal(file, "calf-report.html");
    const html = bytes.toString(),
      { force_n: force } = ask("force", "-D", "38", "-p", "2.2bar", "-e", "10%");
    for (const text of ["Calf", "Leg", "M-17", "1,5", "2026-11-23", "bar"])
      assert.ok(html.includes(text), text);
    assert.ok(html.includes(String(Math.round(force))), `${force} N stands in the report`);
    // Scripts are the model that turns, and the shape that it draws.
    const still = html.replace(/<script[\s\S]*?<\/script>/g, "").length;
    assert.ok(still < 300_000, `${still} bytes without the model`);
    // The file stands alone.
    const { page: alone, errors: wrong, context: other } = await blank();
    await alone.setContent(html);
    await alone.waitForSelector(".body canvas");
    assert.deepEqual(wrong, []);
    await other.close();
    // What was typed is there again.
    await page.keyboard.press("Escape");
    await opened(page, "Build & export");
    assert.equal(await report.getByRole("textbox", { name: "Project" }).inputValue(), "Leg");
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("the deformed muscle is saved for ParaView, as the command line writes it", async () => {
    const { page, errors, context } = await open("#files?D=38&p=2.2bar&e=10%25");
    const box = card(page, "Finite elements");
    await box.getByRole("button", { name: "Compute", exact: true }).click();
    const archive = entries(
      (await downloaded(page, box.getByRole("button", { name: /^All files/ }))).bytes,
    );
    const folder = mkdtempSync(join(tmpdir(), "vtu-"));
    execFileSync(program, ["simulate", "-D", "38", "-p", "2.2bar", "-e", "10%", "--vtu", folder], {
      stdio: "ignore",
    });
    assert.deepEqual(Object.keys(archive).sort(), readdirSync(folder).sort());
    const numbers = (/** @type {string} */ text) =>
      (text.match(/-?\d+\.\d+(e-?\d+)?/g) ?? []).map(Number);
    for (const file of readdirSync(folder)) {
      const [ours, theirs] = [
        numbers(archive[file]),
        numbers(readFileSync(join(folder, file), "latin1")),
      ];
      assert.equal(ours.length, theirs.length);
      const far = ours.findIndex(
        (v, i) => Math.abs(v - theirs[i]) > 1e-4 * (1 + Math.abs(theirs[i])),
      );
      assert.equal(far, -1, `${file}: ${ours[far]} for ${theirs[far]}`);
    }
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("a button that is pressed before the link is read computes the muscle of the link", async () => {
    const { page, context } = await blank();
    await page.route(/api\/(quantities|check)/, async (route) => {
      await new Promise((resolve) => setTimeout(resolve, 700));
      await route.continue();
    });
    await page.goto(`${url()}#files?D=38&p=2.2bar&e=10%25`);
    const box = card(page, "Finite elements");
    await box.getByRole("button", { name: "Compute", exact: true }).click();
    const state = await downloaded(
      page,
      box.getByRole("button", { name: "muscle.pvd", exact: true }),
    );
    assert.match(state.bytes.toString(), /D0 38 mm/);
    await context.close();
  });

  test("the deck of fe3d is the command line's", async () => {
    const { page, errors, context } = await open("#files?D=38&s=1&L=100&p=2.2bar&e=5%25");
    const box = card(page, "Finite elements");
    await box.getByRole("combobox", { name: "Model" }).selectOption("fe3d");
    await box.getByRole("button", { name: "Compute", exact: true }).click();
    const save = box.getByRole("button", { name: "muscle.inp", exact: true });
    await save.waitFor({ timeout: 120_000 });
    const { bytes } = await downloaded(page, save),
      deck = join(mkdtempSync(join(tmpdir(), "deck-")), "muscle.inp");
    execFileSync(
      program,
      [
        "simulate",
        "-D",
        "38",
        "-s",
        "1",
        "-L",
        "100",
        "--model",
        "fe3d",
        "-p",
        "2.2bar",
        "-e",
        "5%",
        "--export-inp",
        deck,
      ],
      { stdio: "ignore" },
    );
    // WebAssembly has its own sines, which differ in the last bits.
    const [ours, theirs] = [bytes.toString(), readFileSync(deck, "utf8")].map((text) =>
      text.split(/[\s,=]+/),
    );
    const far = ours.findIndex(
      (word, i) =>
        word !== theirs[i] &&
        !(Math.abs(Number(word) - Number(theirs[i])) < 1e-12 * (1 + Math.abs(Number(theirs[i])))),
    );
    assert.equal(far, -1, `${ours[far]} for ${theirs[far]}`);
    assert.equal(ours.length, theirs.length);
    if (name === "serve") assert.equal(bytes.toString(), readFileSync(deck, "utf8"));
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("a sweep over a measure has the command line's pull and that as built, and keeps its question in the link", async () => {
    // A link of before.
    const { page, errors, context } = await open("#sweep?D=38&p=2.2bar&e=10%25");
    await alive(page);
    assert.equal(
      await page.getByRole("tab", { name: "Sweep" }).getAttribute("aria-selected"),
      "true",
    );
    await page.getByRole("combobox", { name: "Over" }).selectOption("s");
    for (const [label, text] of [
      ["From", "1 mm"],
      ["To", "3 mm"],
    ]) {
      await page.getByRole("textbox", { name: label, exact: true }).fill(text);
      await page.getByRole("textbox", { name: label, exact: true }).press("Enter");
    }
    await page.waitForFunction(() => /to=3/.test(location.hash));
    const { force_n: force, predicted_n: built } = ask(
      "force",
      "-D",
      "38",
      "-s",
      "2.5",
      "-p",
      "2.2bar",
      "-e",
      "10%",
    );
    const there = async () => {
      await page.locator(".chart").getByText("wall s [mm]").waitFor();
      await soon(async () => {
        const rows = await saved(page),
          at = rows.filter(([, x]) => Number(x) === 2.5);
        assert.equal(rows.length, 43);
        assert.deepEqual(
          at.map(([name]) => name),
          ["pull over wall", "pull over wall as built"],
        );
        [force, built].forEach((said, i) =>
          assert.ok(Math.abs(Number(at[i][2]) / said - 1) < 1e-6, `${at[i]} for ${said}`),
        );
      });
    };
    await there();
    await page.reload();
    await there();
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("a rubber test that is dropped gives the command line's law, which goes into the muscle", async () => {
    const { page, errors, context } = await open("#muscle?D=38");
    await alive(page);
    const before = await pull(page);
    await page.evaluate(
      (text) => {
        const data = new DataTransfer();
        data.items.add(new File([text], "tension.csv"));
        for (const kind of ["dragover", "drop"])
          document
            .querySelector("#bar")
            ?.dispatchEvent(
              new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }),
            );
      },
      readFileSync(`${root}data/treloar/tension.csv`, "utf8"),
    );
    const said = ask("rubber", `${root}data/treloar/tension.csv`);
    await page
      .getByRole("heading", { name: `Recommended: ${said.recommended}` })
      .waitFor({ timeout: 120_000 });
    const row = page.getByRole("row", { name: said.recommended }).first();
    for (const { name: constant, value } of said.parameters)
      await row
        .filter({ hasText: `${constant} ${Number(value.toPrecision(4))}`.replace("-", "−") })
        .waitFor();
    await page.getByRole("button", { name: "Put the rubber into the muscle" }).click();
    await page.locator("main[data-shown=muscle]").waitFor();
    await page.waitForFunction((old) => {
      const text = document.querySelector(".stage .say b")?.textContent ?? "";
      return /\d/.test(text) && text !== old;
    }, before);
    await soon(async () => assert.match(page.url(), /file=/));
    assert.deepEqual(errors, []);
    await context.close();
  });
});
