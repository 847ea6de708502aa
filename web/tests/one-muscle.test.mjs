// What a user met in the browser, each with the answer of the command line: one muscle on every page, fields for all that is needed, and
// nothing that waits for ever.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import {
  alive,
  asBuilt,
  asShown,
  go,
  modelPull,
  ofChart,
  openFiles,
  opened,
  pull,
  served,
  soon,
} from "./browser.mjs";
import { SLEEVES } from "./random.mjs";
import { ask, inBrowser, program, root, shots } from "./sites.mjs";

const folder = mkdtempSync(join(tmpdir(), "page-"));
/**
 * The winner of a design where it is opened, on the branch of its job: the model's pull, and that as built, which meets
 * the requirement. @param {any} found
 */
const designed = ({ candidates: [best], model, uncertainty_words }) => {
  const [{ force_n, predicted_direction }] = best.points;
  return asShown({ force_n, model, predicted_direction, uncertainty_words });
};
const bar = (/** @type {number} */ mpa, digits = 3) =>
  `${Number((10 * mpa).toPrecision(digits))} bar`;

/** A muscle that is not the prototype in anything. */
const MINE = `[tube]
outer_diameter = "24 mm"
wall_thickness = "1.5 mm"
length = "200 mm"

[tube.material]
law = "neo-hookean"
mu = "0.4 MPa"

[braid]
angle = "24 deg"
stiffness = "inextensible"

[terminals]
slip = "1 mm/kN"
grip = "3 mm"
`;
const mine = join(folder, "mine.toml");
writeFileSync(mine, MINE);

/** What the bar says in short of a warning, by its kind. */
const OF_MUSCLE = {
  burst: "may burst",
  burst_not_checked: "burst pressure unknown",
  above_allowed: "above the allowed pressure",
  not_measured: "outside of the measured muscles",
};

inBrowser(({ name, url, open, blank }) => {
  /** @typedef {import("playwright-core").Page} Page */
  /** Until a text stands in an element. @param {Page} page @param {string} of @param {string} text */
  const reads = async (page, of, text, timeout = 20_000) => {
    await page
      .waitForFunction(
        ([of, text]) => document.querySelector(of)?.textContent?.includes(text),
        [of, text],
        { timeout },
      )
      .catch(async () =>
        assert.fail(
          `"${text}" does not stand in ${of}: ${await page.locator(of).first().textContent()}`,
        ),
      );
  };
  const PULL = ".stage .say";
  const field = (/** @type {Page} */ page, /** @type {string} */ label) =>
    page.getByRole("textbox", { name: label, exact: true });
  const type = async (
    /** @type {Page} */ page,
    /** @type {string} */ label,
    /** @type {string} */ text,
  ) => {
    await field(page, label).fill(text);
    await field(page, label).press("Enter");
  };
  const saved = async (/** @type {Page} */ page, /** @type {string} */ button) => {
    const [download] = await Promise.all([
      page.waitForEvent("download"),
      button === "CSV"
        ? ofChart(page, button)
        : page.getByRole("button", { name: button, exact: true }).click(),
    ]);
    return readFileSync(/** @type {string} */ (await download.path()), "utf8");
  };

  test("a muscle file is the muscle of every page, with what is changed over it, saved, reloaded and linked", async () => {
    const { page, errors, context } = await open("#muscle");
    await alive(page);
    await openFiles(page, mine);
    await reads(page, PULL, asShown(ask("force", mine, "-p", "2.5bar", "-e", "15%")));
    await soon(async () => assert.equal(await field(page, "Outer diameter D0").inputValue(), "24"));
    await type(page, "Length L0", "9in");
    await type(page, "Contraction ε", "10 %");
    const said = asShown(ask("force", mine, "-L", "9in", "-p", "2.5bar", "-e", "10%"));
    await reads(page, PULL, said);
    await page.screenshot({ path: `${shots}/file-open-${name}.png` });
    // What is saved is the same muscle, on the command line too.
    const copy = join(folder, `saved-${name}.toml`);
    writeFileSync(copy, await saved(page, "Save"));
    assert.equal(asShown(ask("force", copy, "-p", "2.5bar", "-e", "10%")), said);
    await page.reload();
    await reads(page, PULL, said);
    await soon(async () => assert.equal(await field(page, "Length L0").inputValue(), "228.6"));
    await soon(async () => assert.equal(await field(page, "Outer diameter D0").inputValue(), "24"));
    await soon(async () => assert.equal(await field(page, "Braid angle θ0").inputValue(), "24"));
    // Joint: the torques of its curves, and of the pressures that finite elements find.
    writeFileSync(
      join(folder, "joint.toml"),
      `[joint]\nradius = "25 mm"\nrange = "-60..60 deg"\n[muscle_1]\nfile = "saved-${name}.toml"\ncontraction_at_neutral = "12%"\n[muscle_2]\nfile = "saved-${name}.toml"\ncontraction_at_neutral = "12%"\n`,
    );
    const asked = [
      "joint",
      join(folder, "joint.toml"),
      "--angle",
      "20deg",
      "--stiffness",
      "8",
      "--max-pressure",
      "5bar",
    ];
    const pressures = (/** @type {any} */ { points: [q] }) =>
      `Pressure 1${bar(q.pressure_1_mpa)}Pressure 2${bar(q.pressure_2_mpa)}`;
    await go(page, "Joint");
    await reads(
      page,
      ".numbers",
      pressures(ask(...asked, "--model", "universal", "--extrapolate")),
    );
    await page.reload();
    await reads(page, ".numbers", "Final: finite elements", 90_000);
    await reads(page, ".numbers", pressures(ask(...asked)));
    // Motion.
    await go(page, "Motion");
    await page.waitForSelector("table", { timeout: 60_000 });
    await page.getByText("Advanced", { exact: true }).click();
    await page.getByRole("combobox", { name: "Model" }).selectOption("universal");
    await page.getByRole("button", { name: "Run" }).click();
    const run = ask(
      "motion",
      "--muscle",
      copy,
      "-p",
      "3bar",
      "--load",
      "mass:10kg",
      "--valve",
      "0.5 L/(s bar)",
      "--damping",
      "200 N s/m",
      "--model",
      "universal",
    );
    await reads(
      page,
      ".controls table",
      `Air from the supply${Number(run.air_normal_litres.toPrecision(3))} normal L`,
    );
    // Beside another length of it this muscle is held.
    await go(page, "Muscle");
    await reads(page, PULL, said);
    await page.getByRole("button", { name: "Hold to compare" }).click();
    await type(page, "Length L0", "150 mm");
    const [a, b] = [
        ask("force", copy, "-p", "2.5bar", "-e", "10%"),
        ask("force", copy, "-L", "150", "-p", "2.5bar", "-e", "10%"),
      ],
      both = `Pull of the model${modelPull(b)}${modelPull(a)}As built${asBuilt(b)}${asBuilt(a)}`;
    await reads(page, "[aria-label='beside it in numbers']", both);
    await page.waitForFunction(() => /held=.*L0?=|L=150/.test(location.hash));
    const link = page.url();
    assert.deepEqual(errors, []);
    await context.close();
    const sent = await open(new URL(link).hash);
    await reads(sent.page, "[aria-label='beside it in numbers']", both);
    await sent.context.close();
  });

  test("the facts of a dozen muscles that every output has stand on the page", async () => {
    const truth = `${root}crates/mckibben-app/tests/layer/truth/`;
    const [head, ...rows] = readFileSync(`${truth}facts.tsv`, "utf8")
      .split("\n")
      .filter(Boolean)
      .map((line) => line.split("\t"));
    const { page, errors, context } = await open("#muscle");
    await alive(page);
    for (const row of rows) {
      const fact = (/** @type {string} */ key) => row[head.indexOf(key)];
      const [muscle, mpa, e] = ["muscle", "pressure_mpa", "contraction"].map(fact);
      // What the library has is a file of the repository too.
      const file = muscle.startsWith("lib:")
        ? `${root}crates/mckibben-fit/data/measured/${muscle.slice(4)}/identified.toml`
        : `${truth}${muscle}`;
      const said = ask("force", file, "-p", `${mpa}MPa`, "-e", e);
      for (const key of ["predicted_n", "predicted_low_n", "predicted_high_n"])
        assert.ok(
          Math.abs(said[key] - Number(fact(key))) < 1e-5 * Math.max(1, Math.abs(said[key])),
          muscle,
        );
      await openFiles(page, file);
      await type(page, "Pressure p", `${mpa} MPa`);
      await type(page, "Contraction ε", `${Number((100 * Number(e)).toPrecision(6))} %`);
      await reads(page, PULL, said.slack ? "Slack" : asShown(said).replaceAll("-", "−"));
      const limit = (/** @type {string} */ key) =>
        fact(key) === "-" ? "unknown" : bar(Number(fact(key)));
      await reads(page, ".numbers", `Least burst pressure${limit("burst_pressure_mpa")}`);
      await reads(page, ".numbers", `Allowed pressure${limit("allowed_pressure_mpa")}`);
      const kinds = fact("warnings").split(",");
      await soon(async () => {
        const line = page.locator(".flags summary"),
          words = (await line.isVisible()) ? await line.innerText() : "";
        for (const [kind, text] of Object.entries(OF_MUSCLE))
          assert.equal(
            words.includes(text),
            kinds.includes(kind),
            `${muscle}: ${text} in ${words}`,
          );
      });
    }
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("every measure of the program has a field, and those that few muscles state belong to the muscle of every page", async () => {
    const { page, errors, context } = await open("#muscle");
    await alive(page);
    const box = page.locator("details", { hasText: "More properties" }),
      is = (/** @type {string} */ name, /** @type {string} */ value) =>
        page.waitForFunction(
          ([name, value]) =>
            [...document.querySelectorAll(".quantity")].some(
              (q) =>
                q.querySelector("label")?.textContent === name &&
                q.querySelector("input")?.value === value,
            ),
          [name, value],
          { timeout: 20_000 },
        );
    await soon(async () => assert.equal(await box.getAttribute("open"), null));
    await page.getByText("More properties", { exact: true }).click();
    await page.screenshot({ path: `${shots}/more-${name}.png`, fullPage: true });
    const { measures } = await page.evaluate(async () =>
        (await import(new URL("js/ask.js", document.baseURI).href)).engine().ask("measures", {}),
      ),
      labels = () => page.locator(".quantity label").allTextContents();
    const of = (/** @type {string} */ key) => {
      const { label, symbol } = measures.find((/** @type {any} */ m) => m.key === key);
      return `${label.charAt(0).toUpperCase()}${label.slice(1)}${symbol ? ` ${symbol}` : ""}`;
    };
    await soon(async () => {
      const shown = await labels();
      for (const { key } of measures)
        assert.equal(shown.filter((label) => label === of(key)).length, 1, key);
    });
    /** @type {[string, string, string][]} */
    const typed = [
      ["tube.density", "0.95 g/cm3", "950"],
      ["tube.prestretch", "1.1", "1.1"],
      ["braid.strands", "96", "96"],
      ["braid.strand_modulus", "8.5 GPa", "8500"],
      ["braid.strand_area", "0.05 mm2", "0.05"],
      ["braid.strand_strength", "0.04 kN", "40"],
      ["braid.thickness", "400 um", "0.4"],
      ["braid.crimp", "0.5", "0.5 %"],
      ["terminals.insertion", "15 mm", "15"],
      ["friction.coefficient", "40", "40"],
    ];
    for (const [key, text] of typed)
      await type(page, of(key), key === "braid.crimp" ? `${text} %` : text);
    // What lacks its other half is said at that.
    await page.waitForFunction(
      (name) =>
        [...document.querySelectorAll(".quantity")].some(
          (q) =>
            q.querySelector("label")?.textContent === name &&
            q.querySelector("[aria-invalid=true]"),
        ),
      of("friction.exponent"),
    );
    await type(page, of("friction.exponent"), "0.8");
    const file = (/** @type {string} */ prestretch) => {
      const path = join(folder, `more-${name}.toml`);
      writeFileSync(
        path,
        `[tube]\ndensity = "0.95 g/cm3"\n${prestretch}[braid]\nstrands = 96\nstrand_modulus = "8.5 GPa"\nstrand_area = "0.05 mm2"\nstrand_strength = "40 N"\nthickness = "0.4 mm"\ncrimp = "0.5 %"\n[terminals]\ninsertion = "15 mm"\n[friction]\ncoefficient = 40\nexponent = 0.8\n`,
      );
      return asShown(ask("force", path, "-p", "2.5bar", "-e", "15%"));
    };
    const said = file("prestretch = 1.1\n");
    await reads(page, PULL, said);
    const copy = join(folder, `more-saved-${name}.toml`);
    writeFileSync(copy, await saved(page, "Save"));
    assert.equal(asShown(ask("force", copy, "-p", "2.5bar", "-e", "15%")), said);
    const link = new URL(page.url()).hash;
    assert.match(link, /strands=96/);
    // Reloaded, and sent to somebody: it is open by itself, with all values.
    await page.reload();
    await reads(page, PULL, said);
    await soon(async () => assert.equal(await box.getAttribute("open"), ""));
    for (const [key, , shown] of typed) await is(of(key), shown);
    await go(page, "Data");
    await go(page, "Muscle");
    await reads(page, PULL, said);
    // An emptied field has the usual value again.
    await type(page, of("tube.prestretch"), "");
    await reads(page, PULL, file(""));
    await soon(async () => assert.doesNotMatch(page.url(), /prestretch/));
    await is(of("tube.prestretch"), "");
    await type(page, of("braid.strands"), "37");
    await page.waitForSelector(".problem");
    await soon(async () =>
      assert.equal(await field(page, of("braid.strands")).getAttribute("aria-invalid"), "true"),
    );
    await soon(async () =>
      assert.match(
        await page.locator(".problem").innerText(),
        /number of strands is 37; it must be an even whole number/i,
      ),
    );
    assert.deepEqual(errors, []);
    await context.close();
    // The measures of a file.
    const again = await open("#muscle");
    await alive(again.page);
    await openFiles(again.page, copy);
    await reads(again.page, PULL, said);
    await soon(async () =>
      assert.equal(
        await again.page.locator("details", { hasText: "More properties" }).getAttribute("open"),
        "",
      ),
    );
    for (const [key, , shown] of typed)
      await soon(async () =>
        assert.equal(await field(again.page, of(key)).inputValue(), shown, key),
      );
    await again.context.close();
  });

  test("every named sleeve has fields for what its source does not state, and answers as on the command line", async () => {
    const { page, context } = await open("#muscle?p=2bar&e=5%25");
    await alive(page);
    for (const [sleeve, low, high, lacks] of SLEEVES) {
      const D = Math.round((low + 0.45 * (high - low)) * 100) / 100,
        s = Math.round(10 * D) / 100,
        L = Math.ceil(7 * D);
      await page.goto(`${url()}#muscle?D=${D}&s=${s}&L=${L}&p=2bar&e=5%25`);
      await page.waitForFunction(
        (L) =>
          /** @type {HTMLInputElement} */ (
            document.querySelectorAll(".quantity input[type=text]")[5]
          )?.value === String(L),
        L,
      );
      await page.getByRole("combobox", { name: "Braid" }).selectOption(sleeve);
      const fields = {
        sd: ["Diameter of a strand", "0.2 mm", "--strand-diameter"],
        sE: ["Young's modulus of a strand E", "3 GPa", "--strand-modulus"],
      };
      const flags = [];
      for (const key of lacks) {
        const [label, text, flag] = fields[key];
        // An estimate answers until it is measured.
        await page.waitForFunction(
          (label) =>
            [...document.querySelectorAll(".quantity")].some((q) => q.textContent?.includes(label)),
          label,
        );
        if (sleeve === "nfl-19" && key === "sd")
          await page.screenshot({ path: `${shots}/sleeve-${name}.png` });
        await type(page, label, text);
        flags.push(flag, text);
      }
      const said = ask(
        "force",
        "-D",
        `${D}`,
        "-s",
        `${s}`,
        "-L",
        `${L}`,
        "--braid",
        sleeve,
        ...flags,
        "-p",
        "2bar",
        "-e",
        "5%",
      );
      await reads(page, PULL, said.slack ? "Slack" : asShown(said));
      await soon(async () =>
        assert.ok(await page.getByRole("slider", { name: "Braid angle" }).isDisabled()),
      );
    }
    // Strands that keep their length need neither.
    await page.getByRole("combobox", { name: "Strands" }).selectOption("inextensible");
    await page.waitForFunction(
      () => /k=inextensible/.test(location.hash) && !/sd=|sE=/.test(location.hash),
    );
    await alive(page);
    await context.close();
  });

  test("sleeves in a design have the same fields", async () => {
    const { page, context } = await open("#design?F=300N&e=10%25&pmax=4bar&s=1.5mm&D=10..18mm");
    await page.waitForSelector("table", { timeout: 60_000 });
    await page.getByLabel("Sleeves as sold").fill("flexo-overexpanded-0.38in");
    await type(page, "Diameter of a strand", "0.25 mm");
    const found = ask(
        "design",
        "-F",
        "300N",
        "-e",
        "10%",
        "-p",
        "4bar",
        "-s",
        "1.5mm",
        "-D",
        "10..18mm",
        "--braid",
        "flexo-overexpanded-0.38in",
        "--strand-diameter",
        "0.25mm",
      ),
      [best] = found.candidates;
    assert.ok(best, "it fits");
    await reads(page, ".question .decision", best.sleeve);
    await reads(page, "table[data-first], .below table", best.tube ?? best.sleeve);
    await page.getByRole("button", { name: "Open this muscle" }).click();
    await alive(page);
    await reads(page, PULL, designed(found));
    await context.close();
  });

  test("Hold: load has a field, and the contraction of the command line", async () => {
    const { page, context } = await open("#muscle?p=2.5bar&e=10%25");
    await alive(page);
    await page.getByRole("combobox", { name: "Hold" }).selectOption("F");
    await type(page, "Load F", "300 N");
    const said = ask("contraction", "-F", "300N", "-p", "2.5bar");
    await reads(page, ".stage .say", `and ${Number((100 * said.contraction).toPrecision(3))} %`);
    await soon(async () => assert.match(page.url(), /F=300/));
    // P′ is that of the contraction that was found.
    await reads(page, ".numbers", `Threshold pressure${bar(said.start_pressure_mpa)}`);
    // Its ± of some per cent leaves one decimal.
    const [median, low, high] = [said.predicted, said.predicted_low, said.predicted_high].map((v) =>
      (100 * v).toFixed(1),
    );
    await reads(page, ".numbers", `Contraction as built${median} % (${low} to ${high} %)`);
    await page.screenshot({ path: `${shots}/load-held-${name}.png` });
    await page.reload();
    await reads(page, ".stage .say", `and ${Number((100 * said.contraction).toPrecision(3))} %`);
    await soon(async () => assert.equal(await field(page, "Load F").inputValue(), "300"));
    await page.getByRole("combobox", { name: "Hold" }).selectOption("e");
    await soon(async () => assert.ok(await field(page, "Contraction ε").isVisible()));
    await context.close();
  });

  test("the way that the muscle moves is chosen once: the muscle, its sweep and the saved file have that branch", async () => {
    const { page, errors, context } = await open("#muscle");
    await alive(page);
    const branch = ["--branch", "elongation"];
    await page.getByRole("combobox", { name: "Friction" }).selectOption("elongation");
    const said = ask("force", "-p", "2.5bar", "-e", "15%", ...branch);
    await reads(page, PULL, asShown(said));
    await page.reload();
    await reads(page, PULL, asShown(said));
    const copy = join(folder, `branch-${name}.toml`);
    writeFileSync(copy, await saved(page, "Save"));
    assert.equal(asShown(ask("force", copy, "-p", "2.5bar", "-e", "15%")), asShown(said));
    await page.getByRole("tab", { name: "Sweep" }).click();
    let row = /** @type {string[] | undefined} */ (undefined);
    await soon(async () => {
      row = (await saved(page, "CSV"))
        .split("\n")
        .map((line) => line.split(","))
        .find(([curve, x]) => /over pressure as built/.test(curve) && Number(x) === 3);
      assert.ok(row);
    });
    const at = ask("force", "-p", "3bar", "-e", "15%", ...branch);
    assert.ok(Math.abs(Number(row?.[2]) / at.predicted_n - 1) < 1e-6, `${row}`);
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("Enter starts a design, and its winner opens as the muscle that was designed", async () => {
    const { page, context } = await open("#muscle?k=inextensible&p=2.5bar&e=15%25");
    await alive(page);
    await go(page, "Design");
    await type(page, "It must pull", "320 N");
    const found = ask("design", "-F", "320N", "-e", "15%", "-p", "2.5bar"),
      [best] = found.candidates;
    await reads(page, ".question .decision", best.tube);
    await page.locator(".below tr.pick").first().click({ timeout: 60_000 });
    await alive(page);
    await reads(page, PULL, designed(found));
    await soon(async () => assert.doesNotMatch(page.url(), /k=/));
    await context.close();
  });

  test("isobaric curves end at the free contraction", async () => {
    const { page, context } = await open("#muscle");
    await alive(page);
    await page.waitForSelector(".plot svg.curves", { timeout: 30_000 });
    const lines = (await saved(page, "CSV"))
      .trim()
      .split("\n")
      .map((line) => line.split(","));
    for (const p of ["0.5 bar", "1 bar", "2.5 bar"]) {
      const free = ask("contraction", "-F", "0", "-p", p).contraction;
      const last = lines.filter(([curve, , y]) => curve === p && y !== "").at(-1);
      assert.equal(
        Number(Number(last?.[1]).toPrecision(3)),
        Number((100 * free).toPrecision(3)),
        p,
      );
      assert.equal(Number(last?.[2]), 0);
    }
    await context.close();
  });

  test("0.15 is 15 %, and of 15 without a unit is said what was understood", async () => {
    const { page, context } = await open("#muscle?p=2.5bar&e=5%25");
    await alive(page);
    for (const [text, note] of [
      ["0.12", "0.12 without a unit was read as 12 %."],
      ["12", "12 without a unit was read as 12 %."],
      ["12 %", ""],
      ["12", "12 without a unit was read as 12 %."],
    ]) {
      await type(page, "Contraction ε", "5 %");
      await type(page, "Contraction ε", text);
      await reads(page, PULL, asShown(ask("force", "-p", "2.5bar", "-e", "12%")));
      await soon(async () => assert.equal(await field(page, "Contraction ε").inputValue(), "12 %"));
      await page.waitForFunction(
        (note) =>
          document.querySelector(".state .note:not([hidden])")?.textContent === note ||
          (!note && !document.querySelector(".state .note:not([hidden])")),
        note,
      );
    }
    await soon(async () => assert.match(page.url(), /e=12%25/));
    // What stands in the field is not read again as something else.
    await type(page, "Contraction ε", "0.5 %");
    await field(page, "Contraction ε").press("Enter");
    await soon(async () => assert.match(page.url(), /e=0.5%25/));
    await page.goto(url() + "#design?F=700N&e=15");
    await page.getByText("15 without a unit was read as 15 %.").waitFor();
    await context.close();
  });

  test("a value that is typed again while another is being read counts", async () => {
    const { page, context } = await open("#muscle?p=2.5bar&e=12%25");
    await alive(page);
    const said = asShown(ask("force", "-p", "2.5bar", "-e", "12%"));
    await reads(page, PULL, said);
    await page.route(/api\/quantities/, async (route) => {
      await new Promise((resolve) => setTimeout(resolve, 400));
      await route.continue();
    });
    await type(page, "Contraction ε", "5 %");
    await type(page, "Contraction ε", "12 %");
    await page.waitForTimeout(1500);
    await reads(page, PULL, said);
    assert.equal(await field(page, "Contraction ε").inputValue(), "12 %");
    // The earlier one is read while the text of before stands in the field again, and is not entered yet.
    await type(page, "Contraction ε", "5 %");
    await field(page, "Contraction ε").fill("12 %");
    await reads(page, PULL, asShown(ask("force", "-p", "2.5bar", "-e", "5%")));
    await field(page, "Contraction ε").press("Enter");
    await reads(page, PULL, said);
    await context.close();
  });

  test("the scale bar is as long as it says at every zoom", async () => {
    const { page, context } = await open("#muscle");
    await alive(page);
    /** Pixels of a millimetre by the bar. */
    const pixels = () =>
      page.evaluate(() => {
        const box = /** @type {any} */ (document.querySelector(".stage .bar"));
        return (
          box.querySelector("span").getBoundingClientRect().width / parseFloat(box.textContent)
        );
      });
    const before = await pixels();
    await page.locator(".stage canvas").focus();
    for (let i = 0; i < 4; i++) await page.keyboard.press("+");
    const after = await pixels();
    assert.ok(Math.abs(after / before / 1.2 ** 4 - 1) < 0.02, `${after / before}`);
    await context.close();
  });

  test("beside an error the last answer is dimmed, and the error speaks the page's words", async () => {
    const { page, context } = await open("#muscle");
    await alive(page);
    await type(page, "Wall s", "40");
    await page.waitForSelector(".problem");
    await soon(async () =>
      assert.ok(
        (await page.locator(".stage.stale").count()) &&
          (await page.locator(".numbers.stale").count()) &&
          (await page.locator(".chart.stale").count()),
      ),
    );
    const words = () => page.locator(".problem").innerText();
    await soon(async () => assert.match(await words(), /wall is 40 mm, but the radius is 15 mm/i));
    await soon(async () =>
      assert.equal(await field(page, "Wall s").getAttribute("aria-invalid"), "true"),
    );
    assert.doesNotMatch(await words(), /tube\.|_mm|MPa/);
    await page.screenshot({ path: `${shots}/error-${name}.png` });
    await type(page, "Wall s", "3");
    await page.waitForFunction(
      () => !document.querySelector(".problem") && !document.querySelector(".stale"),
    );
    await type(page, "Pressure p", "900");
    await page.waitForSelector(".problem", { timeout: 30_000 });
    await soon(async () => assert.doesNotMatch(await page.locator(".problem").innerText(), /MPa/));
    await context.close();
  });

  test("the chart of measured points ends with them", async () => {
    const { page, context } = await open("#data");
    await page.waitForSelector(".drop");
    await page.locator("input[type=file]").setInputFiles(`${root}examples/bench.csv`);
    await page.getByText("points.").first().waitFor({ timeout: 30_000 });
    // The numbers below the chart, from left to right.
    const end = await page.waitForFunction(
      () =>
        [...document.querySelectorAll("svg.curves text[text-anchor=middle]")]
          .map((t) => Number(t.textContent))
          .filter((v) => v > 0)
          .at(-1),
      undefined,
      { timeout: 30_000 },
    );
    assert.ok(Number(await end.jsonValue()) < 50, `ε ${await end.jsonValue()}`);
    await context.close();
  });

  test("a question that takes long is given up for a newer one", async () => {
    const { page, context } = await open("#muscle");
    await alive(page);
    const took = await page.evaluate(async () => {
      const { Slot } = await import(new URL("js/ask.js", document.baseURI).href);
      const slot = new Slot(),
        began = performance.now();
      /** @type {string[]} */ const said = [];
      // About half a minute of finite elements.
      slot.ask(
        "curve",
        {
          test: "isometric",
          model: { mesh: "4x60" },
          contractions: Array.from({ length: 40 }, (_, i) => i / 200),
          pressures_mpa: Array.from({ length: 40 }, (_, i) => 0.01 * i),
        },
        () => said.push("old"),
        () => said.push("wrong"),
      );
      await new Promise((resolve) => {
        setTimeout(() => slot.ask("units", {}, resolve), 100);
      });
      return [performance.now() - began, ...said];
    });
    assert.equal(took.length, 1, String(took));
    assert.ok(Number(took[0]) < 5000, `${took[0]} ms`);
    await context.close();
  });

  test("the largest speed of a step is that of the motion, whatever its duration", async () => {
    const speeds = [];
    for (const until of ["1 s", "30 s"]) {
      const { page, context } = await open(`#motion?model=universal&until=${until}`);
      await page.waitForSelector("table", { timeout: 60_000 });
      const run = ask(
        "motion",
        "--muscle",
        "examples/prototype.toml",
        "-p",
        "3bar",
        "--load",
        "mass:10kg",
        "--valve",
        "0.5 L/(s bar)",
        "--damping",
        "200 N s/m",
        "--model",
        "universal",
        "--until",
        until,
      );
      const speed = run.largest_velocity_mm_per_s;
      await reads(page, ".controls table", `Largest speed${Number(speed.toPrecision(3))} mm/s`);
      speeds.push(speed);
      await context.close();
    }
    assert.ok(Math.abs(speeds[1] / speeds[0] - 1) < 0.01, String(speeds));
  });

  if (name === "serve")
    test("a server that goes away in the middle of work is said, and leaves no bar", async () => {
      const own = await served(program);
      const { page, context } = await blank();
      await page.goto(`${own.url}#muscle?s=2`);
      await alive(page);
      const box = await opened(page, "Build & export");
      await box.getByRole("combobox", { name: "Model" }).selectOption("fe3d");
      await box.getByRole("button", { name: "Compute", exact: true }).click();
      await page.getByRole("progressbar").first().waitFor({ timeout: 20_000 });
      own.kill();
      await page
        .getByText("The computation engine stopped: the server cannot be reached")
        .waitFor({ timeout: 20_000 });
      await soon(async () => assert.equal(await page.getByRole("progressbar").count(), 0));
      await context.close();
    });
});
