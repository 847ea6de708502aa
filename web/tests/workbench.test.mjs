// The frame of the workbench: one muscle in a bar, pages that keep what was typed and found, files that open wherever
// they are dropped,
// a newcomer who is led, and a page that prints and works offline.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import axe from "axe-core";
import { nameIn, named } from "../page/js/toml.js";
import { PAGES } from "../page/js/pages.js";
import { thinned } from "../page/js/kept.js";
import { zipSync } from "../page/js/vendor/fflate.js";
import { alive, asBuilt, asShown, go, meter, opened, pull, soon } from "./browser.mjs";
import { ask, inBrowser, root, shots } from "./sites.mjs";

/** @typedef {import("playwright-core").Page} Page */
const example = (/** @type {string} */ name) => readFileSync(`${root}examples/${name}`, "utf8");
/** Until a text stands in an element. @param {Page} page @param {string} of @param {string} text */
const reads = (page, of, text, timeout = 30_000) =>
  page
    .waitForFunction(
      ([of, text]) => document.querySelector(of)?.textContent?.includes(text),
      [of, text],
      { timeout },
    )
    .catch(async () =>
      assert.fail(
        `"${text}" does not stand in ${of}: ${(await page.locator(of).allTextContents())[0]}`,
      ),
    );
const OFFICE = "http://schemas.openxmlformats.org";
const PULL = ".stage .say",
  NAME = "Name of the muscle";
/** Until a page is there. @param {Page} page @param {string} where */
const there = (page, where) =>
  page.locator(`main[data-shown=${where.toLowerCase()}]`).waitFor({ timeout: 20_000 });
const type = async (
  /** @type {Page} */ page,
  /** @type {string} */ label,
  /** @type {string} */ text,
) => {
  const field = page.getByRole("textbox", { name: label, exact: true });
  await field.fill(text);
  await field.press("Enter");
};
/** Files dropped on the middle of the page. @param {Page} page @param {Record<string, string>} dropped */
const drop = (page, dropped) =>
  page.evaluate((all) => {
    const data = new DataTransfer();
    for (const [name, text] of Object.entries(all)) data.items.add(new File([text], name));
    for (const kind of ["dragover", "drop"])
      document
        .querySelector("main")
        ?.dispatchEvent(
          new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }),
        );
  }, dropped);
/** What a click downloads. @param {Page} page @param {import("playwright-core").Locator} button */
async function downloaded(page, button) {
  const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
  return {
    name: download.suggestedFilename(),
    text: readFileSync(/** @type {string} */ (await download.path()), "utf8"),
  };
}

test("the name of a muscle file is found and changed, and nothing else of it", () => {
  const file = '# a remark\n\n[tube]\nname = "no"\n';
  assert.equal(nameIn(file), "");
  assert.equal(nameIn(named(file, 'A "b" \\ c')), 'A "b" \\ c');
  assert.equal(
    named(example("tondu2012.toml"), "x"),
    example("tondu2012.toml").replace('"Tondu 2012, 20 deg"', '"x"'),
  );
  assert.equal(nameIn("name = 'it is'\n[tube]\n"), "it is");
  assert.equal(named('name = "a" # b\n', "$&"), 'name = "$&"\n');
});

test("a table of more than 20,000 rows is thinned to at most so many, with its heading", () => {
  const table = (/** @type {number} */ n) =>
    "# by hand\npressure_bar,contraction,force_n\n" +
    Array.from({ length: n }, (_, i) => `${i},0.1,-3`).join("\n") +
    "\n";
  assert.deepEqual(thinned(table(20_000)), { text: table(20_000), said: "" });
  const { text, said } = thinned(table(50_001));
  assert.equal(
    said,
    "The table has 50,001 rows, more than 20,000: every third one is used, 16,667 points.",
  );
  assert.ok(text.startsWith("# by hand\npressure_bar,contraction,force_n\n0,0.1,-3\n3,0.1,-3\n"));
  assert.equal(text.match(/0\.1/g)?.length, 16_667);
});

test("help leads to a page and a place that the book has", () => {
  for (const { name, help } of PAGES) {
    const [file, anchor] = help.split("#"),
      text = readFileSync(`${root}docs/${file}.md`, "utf8");
    const places = [...text.matchAll(/^#+ (.*)$/gm)].map(([, heading]) =>
      heading
        .toLowerCase()
        .replace(/[^\w\s-]/g, "")
        .trim()
        .replace(/\s/g, "-"),
    );
    assert.ok(
      !anchor || places.includes(anchor),
      `${name}: ${help} is none of ${places.join(" ")}`,
    );
  }
});

inBrowser(({ name, url, open, blank }) => {
  test("the bar has name, picture, undo, redo, save and open of the one muscle, on every page", async () => {
    const { page, errors, context } = await open("#muscle");
    await alive(page);
    const undo = page.getByRole("button", { name: "Undo", exact: true }),
      redo = page.getByRole("button", { name: "Redo", exact: true });
    await soon(async () => assert.ok((await undo.isDisabled()) && (await redo.isDisabled())));
    const picture = () => page.locator(".muscle-bar svg").innerHTML();
    const before = await picture();
    await type(page, "Outer diameter D0", "45");
    await reads(page, ".muscle-bar", "D0 45 mm");
    await soon(async () => assert.notEqual(await picture(), before));
    await type(page, "Length L0", "200");
    await reads(page, ".muscle-bar", "L0 200 mm");
    await undo.click();
    await reads(page, ".muscle-bar", "L0 285 mm");
    await undo.click();
    await reads(page, ".muscle-bar", "D0 30 mm");
    await soon(async () =>
      assert.ok(await undo.isDisabled(), "one entry a gesture: all are taken back"),
    );
    await redo.click();
    await reads(page, ".muscle-bar", "D0 45 mm");
    await redo.click();
    await reads(page, ".muscle-bar", "L0 200 mm");
    await soon(async () => assert.ok(await redo.isDisabled()));
    const field = page.getByRole("textbox", { name: NAME });
    await field.fill('Left "calf"');
    await field.press("Enter");
    await page.waitForFunction(() => /name=Left/.test(location.hash));
    for (const where of ["Design", "Joint", "Motion", "Data", "Rubber"]) {
      await go(page, where);
      await soon(async () => assert.equal(await field.inputValue(), 'Left "calf"', where));
      await reads(page, ".muscle-bar", "D0 45 mm, s 3 mm, L0 200 mm");
    }
    const saved = await downloaded(page, page.getByRole("button", { name: "Save", exact: true }));
    assert.equal(saved.name, "left-calf.toml");
    assert.equal(nameIn(saved.text), 'Left "calf"');
    const path = join(mkdtempSync(join(tmpdir(), "bar-")), saved.name);
    writeFileSync(path, saved.text);
    assert.equal(ask("check", path).outer_diameter_mm, 45);
    // A reload on any page has it again, and what was done is taken back after it too.
    await page.reload();
    await reads(page, ".muscle-bar", "D0 45 mm, s 3 mm, L0 200 mm");
    await undo.click();
    await soon(async () => assert.notEqual(await field.inputValue(), 'Left "calf"'));
    await redo.click();
    await soon(async () => assert.equal(await field.inputValue(), 'Left "calf"'));
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("navigation is links that carry the muscle: they can be opened elsewhere", async () => {
    const { page, context } = await open("#muscle?D=45&L=200");
    await alive(page);
    await type(page, "Wall s", "2.5");
    const links = page.locator("#pages a, #views a");
    for (let i = 0; i < (await links.count()); i++) {
      await links.nth(i).focus();
      const href = String(await links.nth(i).getAttribute("href")),
        other = await context.newPage();
      await other.goto(url() + href);
      await other.reload();
      await reads(other, ".muscle-bar", "D0 45 mm, s 2.5 mm, L0 200 mm").catch((error) =>
        assert.fail(`${href}: ${error.message}`),
      );
      await other.close();
    }
    await context.close();
  });

  test("a long file is compressed in its link, old links open, and a damaged one is said", async () => {
    const file = example("tondu2012.toml"),
      said = asShown(ask("force", "examples/tondu2012.toml", "-p", "3bar", "-e", "10%"));
    const { page, context } = await open(`#muscle?p=3bar&e=10%25&file=${encodeURIComponent(file)}`);
    await reads(page, PULL, said);
    await page.getByRole("slider", { name: "Pressure" }).focus();
    await page.keyboard.press("ArrowRight");
    await page.waitForFunction(() => /p=3\.01bar.*file=z:/.test(location.hash));
    await page.keyboard.press("ArrowLeft");
    await page.waitForFunction(() => /p=3bar.*file=z:/.test(location.hash));
    const { hash } = new URL(page.url());
    assert.ok(hash.length < 0.6 * encodeURIComponent(file).length, `${hash.length} characters`);
    const other = await context.newPage();
    await other.goto(url() + hash);
    await reads(other, PULL, said);
    await soon(async () =>
      assert.equal(
        await other.getByRole("textbox", { name: NAME }).inputValue(),
        "Tondu 2012, 20 deg",
      ),
    );
    await other.goto(`${url()}#data`);
    await other.goto(url() + hash.replace(/file=z:.{20}/, "file=z:AAAA"));
    await reads(other, "#notice", "The link is damaged");
    await context.close();
  });

  test("pages keep input and results while others are shown, and on reload", async () => {
    const { page, errors, context } = await open("#muscle");
    await alive(page);
    await go(page, "Design");
    await type(page, "It must pull", "310 N");
    const [best] = ask("design", "-F", "310N", "-e", "15%", "-p", "2.5bar").candidates;
    await reads(page, ".question .decision", best.tube);
    await go(page, "Motion");
    await page.waitForSelector(".controls table", { timeout: 60_000 });
    await page.getByText("Advanced", { exact: true }).click();
    await page.getByRole("combobox", { name: "Model" }).selectOption("universal");
    await type(page, "Until", "1 s");
    await page.waitForFunction(() => /until=1/.test(location.hash));
    await go(page, "Data");
    await page.locator(".controls input[type=file]").setInputFiles(`${root}examples/bench.csv`);
    await reads(page, ".middle", "bench.csv: 10 points");
    for (const reload of [false, true]) {
      await go(page, "Motion");
      if (reload) await page.reload();
      await page.waitForSelector(".controls table", { timeout: 60_000 });
      await soon(async () =>
        assert.equal(await page.getByRole("textbox", { name: "Until" }).inputValue(), "1 s"),
      );
      await soon(async () =>
        assert.equal(await page.getByLabel("Model", { exact: true }).inputValue(), "universal"),
      );
      await go(page, "Data");
      if (reload) await page.reload();
      await reads(page, ".middle", "bench.csv: 10 points");
      await go(page, "Design");
      if (reload) await page.reload();
      await soon(async () =>
        assert.equal(
          await page.getByRole("textbox", { name: "It must pull", exact: true }).inputValue(),
          "310 N",
        ),
      );
      await reads(page, ".question .decision", best.tube, 60_000);
    }
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("going back from a page never ends in a loop: an entry of the history is a gesture", async () => {
    const { page, context } = await open("#rubber");
    await there(page, "rubber");
    for (const where of ["joint", "motion", "data", "design"]) {
      await page.evaluate((to) => {
        location.hash = to;
      }, `#${where}`);
      await there(page, where);
      await page.waitForLoadState("networkidle");
      const { length } = await page.evaluate(() => ({ length: history.length }));
      await page.goBack();
      await there(page, "rubber");
      assert.ok(length <= 3, `${where}: ${length} entries`);
    }
    // What is written while somebody's link is not read yet does not write over it.
    const hash = await page.evaluate(async () => {
      const { write } = await import(/** @type {string} */ ("./js/address.js"));
      history.replaceState(null, "", "#joint?r=21mm");
      write("#joint?r=20mm");
      return location.hash;
    });
    assert.equal(hash, "#joint?r=21mm");
    await context.close();
  });

  test("24 changes of page and 12 windows leave elements and listeners as they were", async () => {
    const { page, context } = await open("#muscle");
    await alive(page);
    const complete = await meter(page);
    const round = async () => {
      for (const where of ["Design", "Joint", "Motion", "Data", "Rubber", "Muscle"]) {
        await go(page, where);
        await page.waitForLoadState("networkidle");
      }
      for (const window of ["Parts", "Build & export", "Help"]) {
        await opened(page, window);
        await page.keyboard.press("Escape");
      }
      await alive(page);
    };
    // What is loaded once, and what a library keeps of the last page that it drew on.
    await round();
    await round();
    let before = await complete(),
      after = before;
    const grown = () =>
      /** @type {const} */ (["nodes", "listeners"]).filter(
        (key) => after[key] > 1.02 * before[key],
      );
    // A library may keep its last surface or not, as it was left while it drew; what leaks grows every time.
    for (let tries = 0; tries < 3; tries++) {
      before = after;
      for (let i = 0; i < 4; i++) await round();
      // What an answer on its way still holds goes with it; what leaks stays.
      after = await complete();
      for (let i = 0; i < 20 && grown().length; i++) after = await complete();
      if (!grown().length) break;
    }
    assert.deepEqual(
      grown(),
      [],
      `before ${JSON.stringify(before)}, after 24 changes of page ${JSON.stringify(after)}`,
    );
    await context.close();
  });

  test("a file that is dropped anywhere goes where it belongs, with the command line's numbers", async () => {
    const { page, errors, context } = await open("#muscle");
    await alive(page);
    await drop(page, {
      "elbow.toml": example("elbow.toml"),
      "biceps.toml": example("biceps.toml"),
    });
    await there(page, "joint");
    const said = ask(
      "joint",
      "examples/elbow.toml",
      "--angle",
      "20deg",
      "--stiffness",
      "8",
      "--max-pressure",
      "5bar",
    ).points[0];
    await reads(page, ".numbers", "Final: finite elements", 90_000);
    await reads(
      page,
      ".numbers",
      `Pressure 1${Number((10 * said.pressure_1_mpa).toPrecision(3))} bar`,
    );
    await page.reload();
    await reads(page, ".numbers", "Final: finite elements", 90_000);
    await reads(
      page,
      ".numbers",
      `Pressure 1${Number((10 * said.pressure_1_mpa).toPrecision(3))} bar`,
    );
    await drop(page, {
      "drive.toml": example("drive.toml"),
      "prototype.toml": example("prototype.toml"),
    });
    await there(page, "motion");
    const run = ask("motion", "examples/drive.toml");
    await reads(
      page,
      ".controls table",
      `Largest speed${Number(run.largest_velocity_mm_per_s.toPrecision(3))} mm/s`,
      90_000,
    );
    await drop(page, {
      "elbow-drive.toml": example("elbow-drive.toml"),
      "biceps.toml": example("biceps.toml"),
    });
    const turned = ask("motion", "examples/elbow-drive.toml", "--model", "fe");
    const speed = Number(turned.largest_velocity_deg_per_s.toPrecision(3));
    await reads(page, ".controls table", `Largest speed${speed} °/s`, 90_000);
    // Motion has the joint of the page Joint, with what is typed there.
    await go(page, "Joint");
    await page.waitForSelector(".numbers dl");
    await type(page, "Radius of the pulley r", "30 mm");
    await page.waitForFunction(() => /r=30/.test(location.hash));
    const wider = mkdtempSync(join(tmpdir(), "joint-"));
    for (const file of ["elbow.toml", "elbow-drive.toml", "biceps.toml"])
      writeFileSync(join(wider, file), example(file).replace(/^radius = .*/m, 'radius = "30 mm"'));
    const slower = ask("motion", join(wider, "elbow-drive.toml"), "--model", "fe");
    assert.notEqual(slower.largest_velocity_deg_per_s, turned.largest_velocity_deg_per_s);
    await go(page, "Motion");
    await reads(
      page,
      ".controls table",
      `Largest speed${Number(slower.largest_velocity_deg_per_s.toPrecision(3))} °/s`,
      90_000,
    );
    await drop(page, { "festo-dmsp-20.toml": example("festo-dmsp-20.toml") });
    await reads(page, ".muscle-bar", "D0 23 mm");
    await drop(page, { "bench.csv": example("bench.csv") });
    await reads(page, ".middle", "bench.csv: 10 points");
    await drop(page, { "a.toml": '[tube]\nouter_diametre = "3 mm"\n' });
    await reads(page, "#notice", "outer_diametre");
    await reads(page, ".muscle-bar", "D0 23 mm");
    await drop(page, { "photo.png": "PNG" });
    await reads(page, "#notice", "photo.png is no file of this page");
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("a pasted table is a table, a workbook has the text of the command line, and a broken one is named with what to do", async () => {
    const { page, errors, context } = await open("#joint");
    await there(page, "joint");
    const paste = (/** @type {string} */ text, at = "body") =>
      page.evaluate(
        ([cells, where]) => {
          const clipboardData = new DataTransfer();
          clipboardData.setData("text/plain", cells);
          document
            .querySelector(where)
            ?.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true }));
        },
        [text, at],
      );
    // Cells of a workbook come with tabs between them.
    await paste(example("bench.csv").replaceAll(",", "\t"));
    await there(page, "data");
    await reads(page, ".middle", "pasted.csv: 10 points");
    const said = ask(
      "compare",
      "examples/prototype.toml",
      "--data",
      "examples/bench.csv",
      "--models",
      "thick-wall",
      "--extrapolate",
    );
    await reads(
      page,
      "table[aria-label], .middle",
      `${Number(said.models[0].rms_n.toPrecision(3))} N`,
    );
    // What is pasted into a field is its text.
    await go(page, "Muscle");
    await alive(page);
    await paste("1,2\n3,4\n", ".muscle-bar input");
    for (const [name, begin] of [
      ["a.xlsx", "PK\u0003\u0004"],
      ["b.ods", "PK\u0003\u0004"],
      ["c.xlsx", "$>\u0000\u0001 1"],
    ]) {
      await drop(page, { [name]: begin });
      await reads(page, "#notice", `${name} cannot be read: save it as .xlsx, .ods or CSV`);
    }
    await there(page, "muscle");
    // The first sheet with numbers, as the tests of mckibben-io have it of both files.
    await page.evaluate(() => {
      location.hash = "#rubber";
    });
    await there(page, "rubber");
    await page.getByText("Advanced", { exact: true }).click();
    for (const end of ["xlsx", "ods"]) {
      await page
        .locator(".drop input")
        .setInputFiles(`${root}crates/mckibben-io/src/table/workbook/tests/pull.${end}`);
      await type(page, "Constants of the table", "area=8mm2, gauge_length=25mm");
      await page.getByRole("button", { name: "Fit", exact: true }).click();
      await reads(page, ".middle", `pull.${end}: 5 points up to a stretch of 2.6.`, 30_000);
      await reads(page, ".middle", "Standardweg");
    }
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("of a workbook the first tab is read, whatever its number is, as on the command line", async () => {
    const { page, errors, context } = await open("#rubber");
    await there(page, "rubber");
    // A place may begin at the root.
    const sheet = (/** @type {number[][]} */ rows) =>
      `<worksheet xmlns="${OFFICE}/spreadsheetml/2006/main"><sheetData><row>${["stretch", "stress [MPa]"].map((t) => `<c t="inlineStr"><is><t>${t}</t></is></c>`).join("")}</row>` +
      `${rows.map((row) => `<row>${row.map((v) => `<c><v>${v}</v></c>`).join("")}</row>`).join("")}</sheetData></worksheet>`;
    const relations = (/** @type {[id: string, kind: string, to: string][]} */ ...list) =>
      `<Relationships xmlns="${OFFICE}/package/2006/relationships">${list.map(([id, kind, to]) => `<Relationship Id="${id}" Type="${OFFICE}/officeDocument/2006/relationships/${kind}" Target="${to}"/>`).join("")}</Relationships>`;
    const parts = Object.entries({
      "xl/workbook.xml": `<workbook xmlns="${OFFICE}/spreadsheetml/2006/main" xmlns:r="${OFFICE}/officeDocument/2006/relationships"><sheets><sheet name="Second" sheetId="2" r:id="rId2"/><sheet name="First" sheetId="1" r:id="rId1"/></sheets></workbook>`,
      "_rels/.rels": relations(["rId1", "officeDocument", "xl/workbook.xml"]),
      "xl/_rels/workbook.xml.rels": relations(
        ["rId1", "worksheet", "worksheets/sheet1.xml"],
        ["rId2", "worksheet", "/xl/worksheets/sheet2.xml"],
      ),
      "xl/worksheets/sheet1.xml": sheet([
        [1, 0],
        [1.5, 0.3],
        [2, 0.5],
      ]),
      "xl/worksheets/sheet2.xml": sheet([
        [1, 0],
        [1.25, 0.2],
        [1.5, 0.3],
        [1.75, 0.4],
      ]),
    }).map(([name, text]) => [name, new TextEncoder().encode(text)]);
    const path = join(mkdtempSync(join(tmpdir(), "tabs-")), "tabs.xlsx");
    writeFileSync(path, zipSync(Object.fromEntries(parts)));
    await page.locator(".drop input").setInputFiles(path);
    const first = ask("rubber", path);
    assert.equal(first.points, 4);
    await reads(
      page,
      ".middle",
      `${first.points} points up to a stretch of ${first.fitted_to_stretch}.`,
      30_000,
    );
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("points have the colour of their pressure and the sign of their branch, constants have names that are typed too", async () => {
    const { page, errors, context } = await open("#data");
    await page.waitForSelector(".drop");
    await page.evaluate(() => {
      const clipboardData = new DataTransfer();
      const rows = [
        "pressure [bar]\tcontraction [%]\tpull [N]\tbranch",
        "1\t0\t240\tcontraction",
        "1\t8\t80\tcontraction",
        "1\t0\t270\telongation",
        "2\t0\t480\tcontraction",
        "2\t8\t240\tcontraction",
        "2\t0\t510\telongation",
        "2\t8\t270\telongation",
      ];
      clipboardData.setData("text/plain", rows.join("\n") + "\n");
      document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true }));
    });
    await reads(page, ".middle", "pasted.csv: 3 points", 30_000);
    // Three pairs of both branches are compared; all seven points are drawn.
    /** Signs by colour, of a muscle that shortens and that lengthens. */
    const signs = () =>
      page
        .locator(".charts svg.curves")
        .first()
        .locator("svg path")
        .evaluateAll((paths) =>
          ["m-4-3h8", "m-4 3h8"].map((sign) =>
            paths
              .map((path) => path.getAttribute("d")?.split(sign).length ?? 1)
              .filter((count) => count > 1)
              .map((count) => count - 1),
          ),
        );
    await soon(
      async () =>
        assert.deepEqual(await signs(), [
          [2, 2],
          [1, 2],
        ]),
      30_000,
    );
    await reads(page, ".charts", "measured while it lengthens");
    await page.getByText("Advanced", { exact: true }).click();
    await type(page, "Free constants", "Braid angle");
    await page.getByRole("button", { name: "Identify" }).click();
    await reads(page, ".middle", "Braid angle", 60_000);
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("the example of a rubber test has the command line's laws, and its table is there to be changed", async () => {
    const { page, errors, context } = await open("#rubber");
    const said = ask("rubber", "examples/treloar.csv");
    await reads(
      page,
      ".middle",
      `An example, Treloar (1944): treloar.csv: ${said.points} points up to a stretch of ${Number(said.fitted_to_stretch.toPrecision(3))}.`,
      60_000,
    );
    for (const { name: law, shear_modulus_mpa: modulus } of said.laws)
      await reads(page, ".middle table", `${law}`).then(() =>
        reads(page, ".middle table", `${Number(modulus.toPrecision(3))} MPa`),
      );
    await page.locator("summary", { hasText: "Table" }).click();
    const cell = page.getByRole("textbox", { name: "line 2, column 2" });
    assert.equal(await cell.inputValue(), "1.0000");
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("constants of a rubber's table are typed in words, and give the command line's law", async () => {
    const text = "extension [mm],force [N]\n0,0\n10,2\n20,3.4\n30,4.5\n40,5.5\n60,7.6\n";
    const file = `${shots}/specimen.csv`;
    writeFileSync(file, text);
    const said = ask("rubber", file, "--set", "area=8mm2", "--set", "gauge_length=25mm");
    const { page, errors, context } = await open("#rubber");
    await page.locator("summary", { hasText: "Advanced" }).click();
    await page
      .getByRole("textbox", { name: "Constants of the table" })
      .fill("area 8 mm², gauge length 25 mm");
    await page.locator(".drop input[type=file]").setInputFiles(file);
    await reads(page, ".middle", `specimen.csv: ${said.points} points`);
    for (const { shear_modulus_mpa: modulus } of said.laws)
      await reads(page, ".middle table", `${Number(modulus.toPrecision(3))}`);
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("a mistake in a muscle file is said with the keys that there are", async () => {
    const text = '[tube]\nouter_diameter = "30 mm"\nwal = "2 mm"\nlength = "285 mm"\n';
    const { page, context } = await open(`#muscle?file=${encodeURIComponent(text)}`);
    await page
      .getByText(
        /^muscle.toml:3:1: tube.wal: .*did you mean wall_thickness.*known here: outer_diameter/,
      )
      .waitFor();
    await context.close();
  });

  test("a place that was not loaded while the server was away opens once it is back", async () => {
    const { page, context } = await open("#muscle");
    await alive(page);
    const away = (/** @type {import("playwright-core").Route} */ route) => route.abort();
    await page.route(/pages\/rubber\.js/, away);
    await page.evaluate(() => {
      location.hash = "#rubber";
    });
    await page.getByRole("button", { name: "Try again" }).waitFor();
    await page.unroute(/pages\/rubber\.js/, away);
    await page.getByRole("button", { name: "Try again" }).click();
    await there(page, "rubber");
    await context.close();
  });

  test("the window Open shows six muscles with pictures, each of which opens, and the first screen leads to it", async () => {
    const { page, errors, context } = await blank();
    await page.goto(url());
    await page.getByRole("button", { name: "Open a muscle" }).click();
    const cards = page.locator("dialog .gallery").first().locator(".card");
    await soon(async () => assert.equal(await cards.count(), 6));
    await page.waitForFunction(
      () => document.querySelectorAll("dialog .gallery .card svg g").length >= 6,
    );
    const titles = await cards.locator("b").allTextContents();
    await page.keyboard.press("Escape");
    for (const [i, title] of titles.entries()) {
      await page.goto(`${url()}#rubber`);
      await page.goto(`${url()}#muscle`);
      await page.getByRole("button", { name: "Open", exact: true }).click();
      await cards.nth(i).click();
      await page.waitForFunction(() => /file=/.test(location.hash));
      const where = /bench/i.test(title) ? "data" : /elbow/i.test(title) ? "joint" : "muscle";
      await there(page, where);
      await page.waitForSelector(
        /bench/i.test(title)
          ? ".middle table"
          : /elbow/i.test(title)
            ? ".numbers dl"
            : ".stage .say b",
        { timeout: 30_000 },
      );
      await soon(async () => assert.equal(await page.locator(".problem").count(), 0, title));
      if (where === "data")
        await page.getByRole("heading", { name: "Identified" }).waitFor({ timeout: 60_000 });
    }
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("Ask says what a muscle is, asks one question, and answers it in the lines of the command; a click lands on that muscle, with the same pull", async () => {
    const { page, errors, context } = await blank();
    // Until the first answer there is no number beside the question.
    await page.route(/api\/design/, async (route) => {
      await new Promise((resolve) => setTimeout(resolve, 500));
      await route.continue();
    });
    await page.goto(url());
    const head = page.locator(".question h2"),
      lines = page.locator(".question .decision li");
    await page.getByRole("heading", { name: /^A McKibben muscle is/ }).waitFor();
    // A page that brings its engine loads that of the search with the first question.
    await page.getByLabel("It must pull", { exact: true }).focus();
    await page.getByText("Searching …").waitFor();
    assert.doesNotMatch(await page.locator("main").innerText(), /\d ?(N|bar|mm)\b/);
    const began = Date.now();
    await type(page, "It must pull", "150 N");
    const found = ask("design", "-F", "150N", "-e", "15%", "-p", "2.5bar"),
      {
        candidates: [best],
        decision,
      } = found;
    const saying = (/** @type {any} */ c) =>
      `${Number((10 * c.pressure_mpa).toPrecision(3))} bar, ${Number(c.width_mm.toPrecision(3))} mm wide`;
    await head.filter({ hasText: `et ${saying(best)}.` }).waitFor();
    console.log(`answer: ${Date.now() - began} ms with the command line's`);
    // The same lines, but for units and names of fields.
    await soon(async () =>
      assert.deepEqual(
        (await lines.allInnerTexts()).map((line) => line.split(/\s/)[0]),
        decision.map((/** @type {string} */ line) => line.split(" ")[0]),
      ),
    );
    await reads(page, ".question .decision", decision[0].split(",")[0].replace("Take ", ""));
    const pulls = decision.find((/** @type {string} */ line) => line.startsWith("Pulls "));
    await reads(page, ".question .decision", /\(.*95 %\)[^;]*/.exec(pulls)?.[0] ?? "");
    // The muscle hangs beside a coin, to one scale, and lifts what it pulls.
    const picture = page.getByRole("img", { name: /beside a coin/ });
    await picture.getByText("150 N", { exact: true }).waitFor();
    const coin = Number(await picture.locator(".coin").getAttribute("r"));
    assert.ok(Math.abs(2 * coin - 23.25) < 0.01, "in millimetres");
    const first = await picture.innerHTML();
    await soon(async () => assert.notEqual(await picture.innerHTML(), first));
    await page.getByRole("button", { name: "Stop the muscle" }).click();
    await page.screenshot({ path: `${shots}/start-${name}.png` });
    await page.getByRole("button", { name: "Open this muscle" }).click();
    await there(page, "muscle");
    await alive(page);
    await reads(page, ".muscle-bar", `D0 ${Number(best.outer_diameter_mm.toPrecision(4))} mm`);
    // The pull of the answer is the pull of the muscle, of the same branch; what was asked is on its chart.
    assert.match(await pull(page), /^150 N \(/);
    await reads(page, PULL, `${asBuilt(found)}as built while it shortens`);
    await page
      .locator("svg.curves circle title", { hasText: "asked" })
      .waitFor({ state: "attached" });
    await page.locator(".brand a").click();
    await page.getByLabel("It must pull", { exact: true }).focus();
    await head.filter({ hasText: "mm wide" }).waitFor({ timeout: 30_000 });
    assert.deepEqual(errors, []);
    await context.close();
  });

  if (name === "serve")
    test("an answer has its chance in words, never a yes below nine in ten, and another muscle is picked by its chance", async () => {
      const { page, errors, context } = await blank();
      /** @type {any[]} */ const asked = [];
      // An engine of version 4 of the interface.
      let chance = 0.5;
      await page.route(/api\/design/, async (route) => {
        const request = route.request().postDataJSON();
        asked.push({ ...request });
        if (request.certainty) chance = request.certainty;
        delete request.certainty;
        const answer = await fetch(`${url()}api/design`, {
          method: "POST",
          body: JSON.stringify(request),
          headers: { "content-type": "application/json" },
        }).then(
          (found) => found.json(),
          () => undefined,
        );
        // The test is over.
        if (!answer) return;
        const known = { width_mm: 41, pressure_low_mpa: 0.15, pressure_high_mpa: 0.22 };
        answer.candidates?.forEach((/** @type {any} */ c) => Object.assign(c, known, { chance }));
        answer.choices = [0.5, 0.9, 0.99].map((one, i) => ({
          ...answer.choices[0],
          ...known,
          kind: "chance",
          name: ["even chance", "9 in 10", "99 in 100"][i],
          chance: one,
          width_mm: 41 + 5 * i,
        }));
        const json = Buffer.from(JSON.stringify(answer)),
          size = Buffer.alloc(4);
        size.writeUInt32LE(json.length);
        await route.fulfill({ body: Buffer.concat([size, json]) });
      });
      const head = page.locator(".question h2");
      for (const [value, word] of /** @type {[number, string][]} */ ([
        [0.03, "No: set"],
        [0.2, "Unlikely (2 in 10): set"],
        [0.5, "Even: set"],
        [0.799, "Likely (7 in 10): set"],
        [0.899, "Likely (8 in 10): set"],
        [0.9, "Yes (9 in 10): set"],
        [0.994, "Yes (99 in 100): set"],
      ])) {
        chance = value;
        await page.goto(`${url()}#design?F=${300 + Math.round(1000 * value)}`);
        await head.filter({ hasText: word }).waitFor({ timeout: 60_000 });
        assert.equal(/^Yes/.test(await head.innerText()), value >= 0.9);
      }
      // The three alternatives stand in a table and on a curve; one is asked for by its certainty.
      const table = page.getByRole("region", { name: /^One muscle, and what/ });
      await table.getByText("99 in 100").first().waitFor();
      await table.getByText("(1.5 bar to 2.2 bar)").first().waitFor();
      await page.locator("[aria-label=chance] svg.curves").waitFor();
      await table.getByRole("button", { name: "9 in 10", exact: true }).click();
      await head.filter({ hasText: "Yes (9 in 10): set" }).waitFor({ timeout: 60_000 });
      assert.equal(asked.at(-1).certainty, 0.9);
      await page.waitForFunction(() => location.hash.includes("sure=90"));
      assert.deepEqual(errors, []);
      await context.close();
    });

  test("Ask takes a joint and a load too, says what 5 kg weigh, stands still where motion is not wanted, and axe finds nothing; a joint opens with its question", async () => {
    const { page, errors, context } = await open("", { reducedMotion: "reduce" });
    await page.getByLabel("It must pull", { exact: true }).focus();
    await page.locator(".question .decision li").first().waitFor({ timeout: 30_000 });
    const picture = page.getByRole("img", { name: /beside a coin/ });
    const still = await picture.innerHTML();
    await page.waitForTimeout(300);
    assert.equal(await picture.innerHTML(), still);
    await type(page, "It must pull", "5 kg");
    await page.getByText("5 kg weigh 49 N").waitFor();
    await page.getByRole("tab", { name: "Load" }).click();
    const wide = (/** @type {any} */ c) =>
      page
        .locator(".question h2")
        .filter({ hasText: `${Number(c.width_mm.toPrecision(3))} mm wide` })
        .waitFor({ timeout: 30_000 });
    const load = ["--load", "mass:20kg", "--stroke", "40mm", "-p", "2.5bar"];
    await wide(ask("design", ...load).candidates[0]);
    await page.getByRole("tab", { name: "Joint" }).click();
    const [turns] = ask("design", "--joint", "8Nm@45deg", "-p", "2.5bar").candidates;
    await wide(turns);
    await page.getByText(/^Pulley of radius/).waitFor();
    await soon(async () => assert.match(page.url(), /joint=8.*45/));
    await page.evaluate(axe.source);
    for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
      await page.emulateMedia({ colorScheme });
      const { violations } = await page.evaluate(() =>
        /** @type {any} */ (window).axe.run(document),
      );
      assert.deepEqual(
        violations.map((/** @type {any} */ v) => `${v.id}: ${v.nodes[0].target}`),
        [],
      );
    }
    // A muscle of a joint opens as that joint, at the angle and with its share of the torque that were asked, which it holds.
    await page.getByRole("button", { name: "Open this muscle" }).click();
    await there(page, "joint");
    for (const [label, value] of [
      ["Radius of the pulley", String(turns.joint.radius_mm)],
      ["Angle φ", "45"],
      ["Torque that it holds τ", String(8 / turns.count)],
    ])
      await soon(async () =>
        assert.equal(await page.getByRole("textbox", { name: label }).inputValue(), value, label),
      );
    await page
      .locator("[aria-label='joint torque'] circle title", { hasText: "asked" })
      .waitFor({ state: "attached", timeout: 30_000 });
    await page.locator(".numbers dl").waitFor({ timeout: 30_000 });
    assert.equal(await page.locator(".problem").count(), 0);
    if (turns.count > 1) await reads(page, "#notice", `one of ${turns.count} side by side`);
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("a project of before opens with the muscle that was shown, a formula is among the models, and what is gone is said", async () => {
    const { page, errors, context } = await open("#formula?at=2bar");
    await reads(page, "#notice", "The place Formula is gone");
    await alive(page);
    const muscles = ["prototype.toml", "tondu2012.toml"].map((file) => ({
      name: file,
      file: example(file),
      point: {},
    }));
    await drop(page, {
      "all.json": JSON.stringify({
        format: "mckibben-project",
        version: 1,
        shown: "tondu2012.toml",
        muscles,
      }),
    });
    await reads(page, "#notice", "of 2 muscles this is the one that was shown");
    await reads(page, ".muscle-bar", "D0 14 mm");
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("a card keeps the units, sliders run around its muscle, and it opens below the pressure that it may have", async () => {
    const { page, errors, context } = await open("#muscle?u=psi");
    await alive(page);
    const card = async (/** @type {string} */ title) => {
      await page.getByRole("button", { name: "Open", exact: true }).click();
      await page.locator("dialog .card", { hasText: title }).first().click();
    };
    await card("A thin muscle");
    await reads(page, ".muscle-bar", "D0 2 mm");
    await page.waitForFunction(() => /u=psi/.test(location.hash) && /p=1bar/.test(location.hash));
    const slider = page.getByRole("slider", { name: "Outer diameter", exact: true });
    await soon(async () =>
      assert.ok(Math.abs(Number(await slider.inputValue()) - 500) < 100, await slider.inputValue()),
    );
    await slider.focus();
    await page.keyboard.press("ArrowRight");
    await page.waitForFunction(() => /D=2\.1(&|$)/.test(location.hash));
    await soon(async () => assert.equal(await page.locator(".stage .problem").count(), 0));
    await card("Festo DMSP-10");
    await soon(async () =>
      assert.match(await page.getByRole("textbox", { name: NAME }).inputValue(), /^Festo DMSP-10/),
    );
    const rubber = page.getByRole("combobox", { name: "Rubber" });
    await soon(async () =>
      assert.match(await rubber.locator("option:checked").innerText(), /neo-hookean/),
    );
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("a number of a computer is none, and a number alone is in the unit of its field", async () => {
    const { page, context } = await open("#muscle");
    await alive(page);
    await type(page, "Outer diameter D0", "0x10");
    await page.getByText('"0x10" has the unknown unit').waitFor();
    await type(page, "Pressure p", "abc");
    await page.getByText("(a number alone is in bar)").waitFor();
    assert.doesNotMatch(page.url(), /D=16/);
    await context.close();
  });

  test("the theme is that of the system", async () => {
    const { page, context } = await open("#muscle?D=38");
    await alive(page);
    await page.locator("main svg.curves").first().waitFor();
    const ink = () => page.locator("main svg.curves").first().getAttribute("fill");
    const light = await ink();
    await page.emulateMedia({ colorScheme: "dark" });
    await page.waitForFunction(
      (was) => document.querySelector("main svg.curves")?.getAttribute("fill") !== was,
      light,
    );
    await context.close();
  });

  test("every page says in a sentence what it is for, and axe finds nothing in windows, light and dark", async () => {
    const { page, context } = await open("#muscle");
    await alive(page);
    await page.evaluate(axe.source);
    const sentences = new Set();
    for (const where of ["Muscle", "Design", "Joint", "Motion", "Data", "Rubber"]) {
      await go(page, where);
      sentences.add(await page.locator("#claim").innerText());
    }
    assert.equal(sentences.size, 6);
    for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
      await page.emulateMedia({ colorScheme });
      for (const button of ["Help", "Open", "Parts", "Build & export"]) {
        await page.getByRole("button", { name: button, exact: true }).click();
        await page.locator("dialog[open]").waitFor();
        if (button === "Parts") await page.locator("dialog table").waitFor();
        if (button === "Open") {
          await page.waitForFunction(
            () => document.querySelectorAll("dialog .card svg g").length >= 6,
          );
          await page.locator("[title^='lib:dmsp-20-300:']").waitFor();
        }
        const { violations } = await page.evaluate(() =>
          /** @type {any} */ (window).axe.run(document, {
            runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"],
          }),
        );
        assert.deepEqual(
          violations.map((/** @type {any} */ v) => `${v.id}: ${v.nodes[0].html}`),
          [],
          `${button}, ${colorScheme}`,
        );
        await page.screenshot({
          path: `${shots}/window-${button.replaceAll(" ", "")}-${colorScheme}-${name}.png`,
        });
        await page.keyboard.press("Escape");
        await page.locator("dialog").waitFor({ state: "detached" });
      }
    }
    await context.close();
  });

  test("a muscle of the library opens with the command line's pull", async () => {
    const { page, context } = await open("#muscle");
    await alive(page);
    await page.getByRole("button", { name: "Open", exact: true }).click();
    await page.locator("[title^='lib:dmsp-20-300:']").click();
    const said = ask("force", "lib:dmsp-20-300", "-p", "2.5bar", "-e", "15%");
    await reads(
      page,
      ".muscle-bar",
      `D0 ${Number(said.muscle.outer_diameter_mm.toPrecision(4))} mm`,
    );
    await reads(page, PULL, asShown(said));
    await context.close();
  });

  test("a part is found by a filter and put into the muscle, which has the command line's pull", async () => {
    const { page, errors, context } = await open("#parts");
    const { tubes } = ask("parts", "list", "tubes");
    await reads(page, "dialog", `${tubes.length} of ${tubes.length} tubes`);
    await page.getByRole("textbox", { name: "Filter" }).fill("latex 9.525");
    await page.waitForFunction(() => document.querySelectorAll("tbody tr").length < 6);
    await page.getByRole("button", { name: "Use this tube: latex-1/4x3/8in" }).click();
    await reads(page, ".muscle-bar", "D0 9.525 mm");
    await page.getByRole("combobox", { name: "Show" }).selectOption("sleeves");
    await page.getByRole("textbox", { name: "Filter" }).fill("");
    await page.getByText("fits the muscle's diameter").click();
    await soon(async () =>
      assert.ok((await page.locator(".estimated").count()) > 0, "estimates are marked"),
    );
    await page.screenshot({ path: `${shots}/parts-${name}.png` });
    await page.getByRole("button", { name: "Use this sleeve: flexo-overexpanded-0.38in" }).click();
    await reads(page, "dialog", "flexo-overexpanded-0.38in is in the muscle now.");
    await page.keyboard.press("Escape");
    await alive(page);
    const said = ask(
      "force",
      "-D",
      "9.525",
      "-s",
      "1.5875",
      "--rubber",
      "latex",
      "--braid",
      "flexo-overexpanded-0.38in",
      "-p",
      "2.5bar",
      "-e",
      "15%",
    );
    await reads(page, PULL, said.slack ? "Slack" : asShown(said));
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("the table of a design shows ±, mass and price, and is saved as CSV", async () => {
    const { page, context } = await open("#design");
    await page.waitForSelector(".below tr.pick", { timeout: 60_000 });
    const said = ask("design", "-F", "300N", "-e", "15%", "-p", "2.5bar"),
      [best] = said.candidates;
    const table = page.getByRole("region", { name: "Muscles that fit, best first" });
    for (const head of ["± of the pull", "mass", "width in use"])
      await soon(async () =>
        assert.equal(
          await table.getByRole("columnheader", { name: head, exact: true }).count(),
          1,
          head,
        ),
      );
    await table
      .locator("tbody tr")
      .first()
      .filter({ hasText: `${Math.round(best.uncertainty_n)}`.slice(0, 2) })
      .waitFor();
    const { name: file, text } = await downloaded(
      page,
      page.getByRole("button", { name: "CSV of the table" }),
    );
    assert.equal(file, "design.csv");
    const [head, first] = text.split("\n").map((line) => line.split(","));
    for (const [column, value] of /** @type {[string, number]} */ ([
      ["D0 [mm]", best.outer_diameter_mm],
      ["mass [g]", best.mass_g],
      ["± of the pull [N]", best.uncertainty_n],
      ["set [bar]", 10 * best.pressure_mpa],
    ])) {
      assert.ok(
        Math.abs(Number(first[head.indexOf(column)]) / value - 1) < 1e-6,
        `${column}: ${first[head.indexOf(column)]}`,
      );
    }
    // A number alone is in the unit of the page.
    for (const [label, text] of [
      ["It must pull", "300"],
      ["while it shortens by", "10 %"],
      ["at", "4"],
    ])
      await page.getByRole("textbox", { name: label, exact: true }).fill(text);
    await page.getByRole("textbox", { name: "It must pull", exact: true }).press("Enter");
    await page.getByText("4 without a unit was read as 4 bar.").waitFor();
    const [other] = ask("design", "-F", "300N", "-e", "10%", "-p", "4bar").candidates;
    await reads(page, ".decision", other.tube);
    await context.close();
  });

  test("an error, a tooltip and a warning have the units of the page", async () => {
    const { page, context } = await open("#muscle?u=psi,in,lbf&D=30");
    await alive(page);
    await soon(async () =>
      assert.match(
        String(await page.getByRole("textbox", { name: "Pressure p" }).getAttribute("title")),
        /a number alone is in psi/,
      ),
    );
    await type(page, "Wall s", "2");
    const words = () => page.locator(".problem").innerText();
    await soon(async () => assert.match(await words(), /wall is 2 in/i));
    assert.doesNotMatch(await words(), /\bmm\b|MPa/);
    await context.close();
    const design = await open("#design?u=psi");
    await design.page.waitForSelector("form");
    const supply = design.page.getByRole("textbox", { name: "at", exact: true });
    await supply.focus();
    await soon(async () =>
      assert.doesNotMatch(String(await supply.getAttribute("title")), /bare number is MPa/),
    );
    await design.context.close();
  });

  test("all that the command line warns stands on the pages", async () => {
    const { page, context } = await open(
      "#muscle?D=9.525&s=1.5875&L=200&rubber=latex&braid=flexo-overexpanded-0.38in&p=5bar&e=10%25",
    );
    await alive(page);
    const list = [
      "force",
      "-D",
      "9.525",
      "-s",
      "1.5875",
      "-L",
      "200",
      "--rubber",
      "latex",
      "--braid",
      "flexo-overexpanded-0.38in",
      "-p",
      "5bar",
      "-e",
      "10%",
    ];
    const { warnings } = ask(...list),
      plain = (/** @type {string} */ text) =>
        text
          .replace(/[\d.]+ \w+|`[^`]*`|[^a-z ]/gi, "")
          .slice(0, 24)
          .trim()
          .toLowerCase();
    assert.ok(warnings.length > 0);
    // On the muscle in whole, above every other place in short and, opened, in whole.
    for (const where of ["Muscle", "Joint", "Data"]) {
      await go(page, where);
      if (where !== "Muscle") await page.locator(".flags summary").click();
      for (const warning of warnings)
        await page.waitForFunction(
          (text) =>
            [...document.querySelectorAll(".warnings li")].some((li) =>
              li.textContent
                ?.replace(/[\d.]+ \w+|`[^`]*`|[^a-z ]/gi, "")
                .toLowerCase()
                .startsWith(text),
            ),
          plain(warning.message),
          { timeout: 30_000 },
        );
    }
    await context.close();
  });

  test("a field that is selected as a whole is typed over, also where the page writes into it meanwhile", async () => {
    const { page, context } = await open("#muscle");
    await alive(page);
    const row = page
      .locator(".controls .quantity")
      .filter({ has: page.getByRole("textbox", { name: "Pressure" }) })
      .first();
    const field = row.locator("input[type=text]"),
      unit = row.locator("button.bare");
    await field.selectText();
    const [before, written] = [await unit.innerText(), await field.inputValue()];
    // A click by a script leaves the focus; the value stands in another unit then.
    await unit.evaluate((button) => /** @type {HTMLElement} */ (button).click());
    await soon(async () => assert.notEqual(await field.inputValue(), written));
    await page.keyboard.insertText("1 bar");
    await soon(async () => assert.equal(await field.inputValue(), "1 bar"));
    await field.press("Enter");
    await page.waitForFunction(() => /p=1bar|p=0\.1MPa|p=100kPa|p=14\.5/.test(location.hash));
    await soon(async () => assert.notEqual(before, await unit.innerText()));
    await context.close();
  });

  test("all units switch by a click, and a click changes no value", async () => {
    const { page, context } = await open("#muscle?k=467");
    await alive(page);
    const before = await pull(page),
      units = page.locator(".controls .quantity > button.bare:visible");
    for (let i = 0; i < (await units.count()); i++) {
      const unit = units.nth(i),
        first = await unit.innerText();
      const field = unit.locator("xpath=..").locator("input[type=text]");
      do {
        await unit.click();
        await field.focus();
        await field.press("Enter");
      } while ((await unit.innerText()) !== first);
    }
    await soon(async () => assert.ok((await units.count()) >= 6));
    await page.waitForFunction(
      (text) => document.querySelector(".stage .say b")?.textContent === text,
      before,
    );
    await soon(async () =>
      assert.equal(
        await page.getByRole("textbox", { name: "Outer diameter D0" }).inputValue(),
        "30",
      ),
    );
    await soon(async () => assert.doesNotMatch(page.url(), /D=|29\.99/));
    await context.close();
  });

  test("a decimal comma is read, and said; one that may separate thousands is asked about", async () => {
    const { page, context } = await open("#muscle");
    await alive(page);
    await type(page, "Pressure p", "2,3 bar");
    await page.getByText("2,3 bar was read as 2.3 bar.").waitFor();
    await reads(page, PULL, asShown(ask("force", "-p", "2.3bar", "-e", "15%")));
    await type(page, "Length L0", "1.234,5 mm");
    await page.getByText("1.234,5 mm was read as 1234.5 mm.").waitFor();
    await type(page, "Length L0", "1,200");
    await page.waitForSelector("[aria-invalid=true]");
    await page.goto(`${url()}#design?F=300N&e=12,5%25`);
    await page.getByText("12,5% was read as 12.5%.").waitFor();
    await context.close();
  });

  test("a comma in quotes separates no columns, also after a cell was edited", async () => {
    const { page, errors, context } = await open("#data");
    await page.waitForSelector(".drop");
    const text =
      'pressure_bar,contraction,force_n,remark\n1,0.05,120,"first, cold"\n2,0.05,300,"a ""warm"" one"\n';
    await page
      .locator(".controls input[type=file]")
      .setInputFiles({ name: "quoted.csv", mimeType: "text/csv", buffer: Buffer.from(text) });
    await reads(page, ".middle", "quoted.csv: 2 points");
    await page.getByText("Table", { exact: true }).first().click();
    const cell = (/** @type {number} */ line, /** @type {number} */ column) =>
      page.getByRole("textbox", { name: `line ${line}, column ${column}` });
    await soon(async () => assert.equal(await cell(2, 4).inputValue(), "first, cold"));
    assert.equal(await cell(3, 4).inputValue(), 'a "warm" one');
    await cell(2, 3).fill("130");
    await cell(2, 3).press("Enter");
    await page.waitForTimeout(500);
    await reads(page, ".middle", "quoted.csv: 2 points");
    await soon(async () => assert.equal(await cell(2, 4).inputValue(), "first, cold"));
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("data above 20,000 points are thinned, and the page says so", async () => {
    const { page, errors, context } = await open("#data?models=universal");
    await page.waitForSelector(".drop");
    const rows = Array.from(
      { length: 30_000 },
      (_, i) => `${1 + (i % 5) * 0.5},${(i % 200) / 1000},${900 - 4 * (i % 200)}`,
    );
    await page
      .locator(".controls input[type=file]")
      .setInputFiles({
        name: "long.csv",
        mimeType: "text/csv",
        buffer: Buffer.from(`pressure_bar,contraction,force_n\n${rows.join("\n")}\n`),
      });
    await page
      .getByText(
        "The table has 30,000 rows, more than 20,000: every second one is used, 15,000 points.",
      )
      .waitFor({ timeout: 60_000 });
    await reads(page, ".middle", "15000 points");
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("what is wrong is said once, at its field, in the page's words and units", async () => {
    const { page, context } = await open("#motion");
    for (const [where, label, typed, said] of /** @type {[string, string, string, RegExp][]} */ ([
      ["Motion", "Load", "20", /give a mass \(20 kg\), a force/],
      ["Motion", "Supply", "-5", /^−5 bar; it must be above zero$/],
      ["Joint", "Pressure of the supply", "-5", /^−5 bar; it must be above zero$/],
      ["Joint", "Radius of the pulley r", "-5", /Is −5 mm; it must be above zero/],
    ])) {
      await go(page, where);
      await page.waitForSelector(".controls table, .numbers dl", { timeout: 60_000 });
      const field = page.getByLabel(label, { exact: true }).first();
      await field.fill(typed);
      await field.press("Enter");
      await soon(async () =>
        assert.match((await page.locator(".wrong:visible").allInnerTexts()).join(), said, label),
      );
      assert.equal(await page.locator(".problem").count(), 0, label);
    }
    await context.close();
    // Zero is wrong, not missing.
    const first = await open("");
    await first.page.getByRole("tab", { name: "Load" }).click();
    await first.page.getByLabel("It must lift").fill("0");
    await first.page.getByText("Load 0 kg: the mass must be above zero").waitFor();
    await first.page.getByRole("tab", { name: "Joint" }).click();
    await first.page.getByLabel("It must turn with").fill("0 at 45°");
    await first.page
      .getByText(/0 N m at 45° is invalid/)
      .first()
      .waitFor();
    await first.context.close();
  });

  test("beside an error the old answer is dimmed, on every page that computes", async () => {
    const { page, context } = await open("#muscle");
    await alive(page);
    // What is typed next is no matter of the problem before.
    await type(page, "Pressure p", "-1");
    await page.locator(".side .problem:not(.stale)").waitFor();
    await type(page, "Pressure p", "abc");
    await page.locator(".side .problem.stale").waitFor();
    await type(page, "Pressure p", "2");
    for (const [where, waits, label, wrong] of [
      ["Motion", ".controls table", "Valve", "nonsense"],
      ["Joint", ".numbers dl", "Radius of the pulley r", "900"],
    ]) {
      await go(page, where);
      await page.waitForSelector(waits, { timeout: 60_000, state: "attached" });
      const field = page.getByLabel(label, { exact: true }).first();
      await field.fill(wrong);
      await field.press("Enter");
      await page.waitForSelector("main .stale", { timeout: 30_000 });
      await soon(async () =>
        assert.ok((await page.locator(".problem, .wrong:visible").count()) > 0, where),
      );
      await field.fill("");
    }
    await context.close();
  });

  test("the chosen page can be seen in forced colours", async () => {
    const { page, context } = await open("#muscle", { forcedColors: "active" });
    await alive(page);
    const border = (/** @type {string} */ of) =>
      page
        .locator(of)
        .first()
        .evaluate((a) => getComputedStyle(a).borderBottomColor);
    await soon(async () =>
      assert.notEqual(
        await border("nav [aria-current]"),
        await border("nav a:not([aria-current])"),
      ),
    );
    await context.close();
  });

  if (name === "static")
    test("the page is an app that is installed, and opens without a network", async () => {
      const { page, context } = await open("#muscle?D=38", { serviceWorkers: "allow" });
      await alive(page);
      /** @type {string[]} */ const fetched = [];
      context.on("request", (request) =>
        fetched.push(new URL(request.url()).pathname.split("/").pop() ?? ""),
      );
      const session = await context.newCDPSession(page);
      const { errors: faults } = await session.send("Page.getAppManifest");
      assert.deepEqual(faults, []);
      await page.evaluate(async () => {
        await navigator.serviceWorker.ready;
      });
      await page.waitForFunction(
        async () => {
          const cache = await caches.open((await caches.keys())[0] ?? "");
          return (await cache.keys()).length > 40 && (await cache.match("live.wasm"));
        },
        undefined,
        { timeout: 60_000 },
      );
      const { installabilityErrors } = await session.send("Page.getInstallabilityErrors");
      assert.deepEqual(
        installabilityErrors.filter(
          (/** @type {any} */ { errorId }) => !/in-incognito/.test(errorId),
        ),
        [],
      );
      // The first visit does not pay for what it does not use; a button fetches it.
      assert.deepEqual(
        fetched.filter((file) => /whole/.test(file)),
        [],
      );
      await opened(page, "Help");
      await page.getByRole("button", { name: "Make all places available offline" }).click();
      await page.getByText("Every place works.").waitFor();
      assert.ok(fetched.some((file) => /whole/.test(file)));
      await page.keyboard.press("Escape");
      await context.setOffline(true);
      await page.reload();
      await alive(page);
      await go(page, "Design");
      await page.waitForSelector("tr.pick", { timeout: 90_000 });
      await soon(async () => assert.match(page.url(), /D(=|%3D)38/));
      await context.close();
    });

  test("400 px: the frame fits, and the bar is reached by the keyboard", async () => {
    const { page, context } = await blank();
    await page.setViewportSize({ width: 400, height: 800 });
    for (const where of ["", "#muscle"]) {
      await page.goto(url() + where);
      await page.locator(where ? ".stage .say b" : ".question h1").waitFor();
    }
    await soon(async () =>
      assert.ok(
        await page.evaluate(
          () => document.documentElement.scrollWidth <= document.documentElement.clientWidth,
        ),
      ),
    );
    await page.screenshot({ path: `${shots}/welcome-400-${name}.png` });
    await alive(page);
    const first = page.getByRole("textbox", { name: NAME });
    await first.focus();
    // Undo and Redo keep the focus where there is nothing to undo.
    const tab = async (/** @type {string} */ to) => {
      await page.keyboard.press("Tab");
      assert.equal(await page.evaluate(() => document.activeElement?.textContent), to);
    };
    for (const one of ["Undo", "Redo", "⋯"]) await tab(one);
    // What is seldom needed is behind the sign, the buttons of the frame too.
    await page.keyboard.press("Enter");
    for (const one of ["Open", "Save", "Share", "Parts", "Build & export", "Help"]) await tab(one);
    await page.keyboard.press("Enter");
    await page.locator("dialog[open]").waitFor();
    await page.keyboard.press("Escape");
    await page.getByRole("button", { name: "Save", exact: true }).waitFor({ state: "hidden" });
    const frame = await page.locator(".frame").boundingBox();
    assert.ok(frame && frame.height <= 80, `${frame?.height}`);
    await page.getByRole("button", { name: "Undo" }).focus();
    await page.keyboard.press("Enter");
    assert.equal(await page.evaluate(() => document.activeElement?.textContent), "Undo");
    // The whole name is seen, and each button beside it.
    assert.ok(await first.evaluate((one) => one.scrollWidth <= one.clientWidth));
    await context.close();
  });
});
