// The workbench in a real browser, on both engines.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import axe from "axe-core";
import { alive, asBuilt, asShown, ofChart, openFiles, pull, soon, trapping } from "./browser.mjs";
import { ask, inBrowser, root, shots } from "./sites.mjs";

/** Something that says that a page has done its first work; old addresses open their windows. */
const DONE = {
  muscle: ".numbers dl",
  design: "table",
  joint: ".numbers dl",
  motion: "table",
  data: ".drop",
  rubber: ".drop",
  parts: "dialog table",
  files: "dialog .card-of-files",
  about: "dialog h2",
};
const PAGES = /** @type {(keyof typeof DONE)[]} */ (Object.keys(DONE));

/** Rules of axe; in the dark only colours differ. */
const RULES = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"];

inBrowser(({ name, url, open, blank }) => {
  test("every page opens, does its first work and says nothing wrong, light and dark, and axe finds nothing", async () => {
    for (const page_name of PAGES) {
      const { page, errors, context } = await open(`#${page_name}`, { colorScheme: "light" });
      await page.waitForSelector(DONE[page_name], { timeout: 60_000 });
      await page.waitForTimeout(1200);
      await page.evaluate(axe.source);
      for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
        await page.emulateMedia({ colorScheme });
        // Charts are drawn again in the other colours.
        if (colorScheme === "dark") await page.waitForTimeout(500);
        // What is closed too.
        const closed = await page.locator("details:not([open])").elementHandles();
        for (const box of closed)
          await box.evaluate((of) => {
            /** @type {HTMLDetailsElement} */ (of).open = true;
          });
        const rules = colorScheme === "light" ? RULES : ["color-contrast"];
        const { violations } = await page.evaluate(
          (runOnly) => /** @type {any} */ (window).axe.run(document, { runOnly }),
          rules,
        );
        assert.deepEqual(
          violations.map(
            (/** @type {any} */ v) => `${v.id}: ${v.nodes[0].html} ${v.nodes[0].failureSummary}`,
          ),
          [],
          `${page_name}, ${colorScheme}`,
        );
        for (const box of closed)
          await box.evaluate((of) => {
            /** @type {HTMLDetailsElement} */ (of).open = false;
          });
        if (name === "static")
          await page.screenshot({
            path: `${shots}/${page_name}-${colorScheme}.png`,
            fullPage: true,
          });
      }
      assert.deepEqual(errors, [], page_name);
      await context.close();
    }
  });

  test("the digits of the page are those of the command line", async () => {
    const { page, context } = await open("#muscle?D=38&s=1&L=285&angle=28&p=2.3bar&e=12%25");
    await alive(page);
    const said = ask("force", "-D", "38", "-s", "1", "-p", "2.3bar", "-e", "12%");
    await soon(async () =>
      assert.equal(
        await page.locator(".stage .say").textContent(),
        `${asShown(said)}at 2.3 bar and 12 %`,
      ),
    );
    await soon(async () =>
      assert.equal(await page.locator(".numbers dd .bare").innerText(), asBuilt(said)),
    );
    await page.waitForFunction(() =>
      /Threshold pressure\s*[\d.]/.test(document.querySelector(".numbers")?.textContent ?? ""),
    );
    const numbers = await page.locator(".numbers").innerText();
    assert.ok(
      numbers.includes(`${Number((10 * said.start_pressure_mpa).toPrecision(3))} bar`),
      numbers,
    );
    await context.close();
  });

  test("sliders by mouse and keyboard, fields with units and nonsense, undo", async () => {
    const { page, errors, context } = await open("#muscle");
    await alive(page);
    const first = await pull(page);
    const slider = page.getByRole("slider", { name: "Pressure" });
    // What comes above it may move it while it is being taken hold of.
    await soon(async () => {
      const box = /** @type {any} */ (await slider.boundingBox());
      await page.mouse.move(box.x + box.width * 0.42, box.y + box.height / 2);
      await page.mouse.down();
      await page.mouse.move(box.x + box.width * 0.7, box.y + box.height / 2, { steps: 8 });
      await page.mouse.up();
      await page.waitForTimeout(500);
      assert.notEqual(await pull(page), first);
    });
    await page.waitForFunction(() => /p=/.test(location.hash));
    await slider.focus();
    const before = await page.getByRole("textbox", { name: "Pressure" }).inputValue();
    await page.keyboard.press("ArrowRight");
    await soon(async () =>
      assert.notEqual(await page.getByRole("textbox", { name: "Pressure" }).inputValue(), before),
    );
    const field = page.getByRole("textbox", { name: "Outer diameter" });
    await field.fill("1.2in");
    await field.press("Enter");
    await page.waitForFunction(() => location.hash.includes("D=30.48"));
    for (const wrong of ["3 bar", "abc", "1e999", "NaN"]) {
      await field.fill(wrong);
      await field.press("Enter");
      await page.waitForFunction(
        (id) => document.getElementById(id)?.getAttribute("aria-invalid") === "true",
        await field.getAttribute("id"),
      );
    }
    // A step is a muscle that rested.
    for (const value of ["4000", "30"]) {
      await field.fill(value);
      await field.press("Enter");
      await page.waitForTimeout(400);
    }
    await page.waitForFunction(
      (id) => !document.getElementById(id)?.hasAttribute("aria-invalid"),
      await field.getAttribute("id"),
    );
    const undo = page.getByRole("button", { name: "Undo", exact: true });
    await undo.click();
    await soon(async () => assert.equal(await field.inputValue(), "4000"));
    await page.keyboard.press("Control+z");
    await soon(async () => assert.equal(await field.inputValue(), "30.48"));
    await soon(async () =>
      assert.equal(
        await page.getByRole("button", { name: "Redo", exact: true }).getAttribute("title"),
        "Redo: Outer diameter 4000 mm (Ctrl+Y)",
      ),
    );
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("a shared link shows the same, and what is not understood is named and kept", async () => {
    const link =
      "#muscle?D=38&s=1&p=36psi&e=10%25&cut=1&show=stress_hoop_mpa&test=isometric&u=psi&colour=red&L=long";
    const { page, context } = await open(link);
    await alive(page);
    await soon(async () =>
      assert.equal(await page.getByRole("textbox", { name: "Pressure" }).inputValue(), "36"),
    );
    await soon(async () =>
      assert.equal(
        await page.getByRole("button", { name: "Cut open" }).getAttribute("aria-pressed"),
        "true",
      ),
    );
    await soon(async () =>
      assert.equal(
        await page.getByRole("tab", { name: "Isometric" }).getAttribute("aria-selected"),
        "true",
      ),
    );
    const numbers = page.locator(".numbers");
    await numbers.getByText("Not understood in the address: colour").waitFor();
    await numbers.getByText('"long" does not start with a number').waitFor();
    await page.getByRole("slider", { name: "Contraction" }).focus();
    await page.keyboard.press("ArrowRight");
    await page.waitForFunction(() => location.hash.includes("colour=red"));
    await context.close();
  });

  test("units change everywhere by a click", async () => {
    const { page, context } = await open("#muscle");
    await alive(page);
    const unit = page.locator(".quantity", { hasText: "Pressure" }).getByRole("button");
    for (const expected of ["kPa", "MPa", "psi", "bar"]) {
      await unit.click();
      await soon(async () => assert.equal(await unit.innerText(), expected));
    }
    await context.close();
  });

  test("slack is a state with a sentence; a muscle that cannot be is said at its field", async () => {
    const { page, context } = await open("#muscle?p=1bar&e=30%25");
    await alive(page);
    await soon(async () => assert.equal(await pull(page), "Slack"));
    const wall = page.getByRole("textbox", { name: "Wall" });
    await wall.fill("40");
    await wall.press("Enter");
    await page.waitForSelector(".problem");
    await wall.fill("2");
    await wall.press("Enter");
    await page.waitForFunction(() => !document.querySelector(".problem"));
    await context.close();
  });

  test("muscle files, good and broken", async () => {
    const { page, context } = await open("#muscle");
    await alive(page);
    const file = (/** @type {string} */ name, /** @type {Buffer} */ buffer) =>
      openFiles(page, { name, mimeType: "text/plain", buffer });
    await file("mine.toml", readFileSync(`${root}examples/festo-dmsp-20.toml`));
    await page.waitForFunction(() => location.hash.includes("file="));
    await alive(page);
    for (const [name, text, said] of [
      ["broken.toml", '[tube]\nouter_diametre = "3 mm"\n', /broken\.toml.*outer_diamet/],
      ["empty.toml", "\n", /empty\.toml is empty/],
    ]) {
      await file(/** @type {string} */ (name), Buffer.from(/** @type {string} */ (text)));
      await soon(async () =>
        assert.match(await page.locator("#notice").innerText(), /** @type {RegExp} */ (said)),
      );
    }
    const [download] = await Promise.all([
      page.waitForEvent("download"),
      page.getByRole("button", { name: "Save", exact: true }).click(),
    ]);
    assert.match(download.suggestedFilename(), /\.toml$/);
    await page.reload();
    await alive(page);
    await context.close();
  });

  test("a muscle is built: its files as downloads", async () => {
    const { page, context } = await open("#files");
    await page.getByRole("button", { name: "Make the build sheet" }).click();
    for (const [file, begin] of /** @type {[string, RegExp][]} */ ([
      ["README.md", /^# McKibben muscle/],
      ["bom.csv", /^part,size,/],
      ["muscle.toml", /^# McKibben muscle/],
    ])) {
      const button = page.getByRole("button", { name: file, exact: true });
      await button.waitFor({ timeout: 60_000 });
      const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
      assert.equal(download.suggestedFilename(), file);
      assert.match(
        readFileSync(/** @type {string} */ (await download.path())).toString("latin1"),
        begin,
      );
    }
    await context.close();
  });

  test("curves as table, CSV, SVG and PNG", async () => {
    const { page, context } = await open("#muscle");
    await alive(page);
    await page.waitForSelector(".plot svg.curves", { timeout: 30_000 });
    for (const [button, end] of [
      ["CSV", ".csv"],
      ["SVG", ".svg"],
      ["PNG", ".png"],
    ]) {
      const [download] = await Promise.all([page.waitForEvent("download"), ofChart(page, button)]);
      assert.ok(download.suggestedFilename().endsWith(end));
      const bytes = readFileSync(/** @type {string} */ (await download.path()));
      if (end === ".csv")
        assert.match(bytes.toString(), /^curve,contraction ε \[%\],pull F \[N\]\n0.5 bar,0,/);
      if (end === ".png") assert.equal(bytes.subarray(1, 4).toString(), "PNG");
    }
    await ofChart(page, "Table");
    await soon(async () => assert.ok((await page.locator(".chart table tr").count()) > 20));
    await context.close();
  });

  test("a muscle of the table of a design opens", async () => {
    const { page, errors, context } = await open("#design");
    await page.locator(".below tr.pick").nth(1).click({ timeout: 60_000 });
    await alive(page);
    const [, second] = ask("design", "-F", "300N", "-e", "15%", "-p", "2.5bar").candidates;
    await page
      .locator(".muscle-bar")
      .filter({ hasText: `D0 ${Number(second.outer_diameter_mm.toPrecision(4))} mm` })
      .waitFor();
    await page.goBack();
    await page.waitForSelector(".below tr.pick");
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("a design for a liquid shows the command line's volume in the place of the air, and what is beyond its limit", async () => {
    const wanted = [
      "--force",
      "50N",
      "--contraction",
      "15%",
      "--max-pressure",
      "2.5bar",
      "--length",
      "200",
      "--liquid",
      "water",
    ];
    const { page, errors, context } = await open(
      "#design?F=50N&e=15%25&pmax=2.5bar&L=200mm&liquid=water&most=40mL",
    );
    const muscles = page.getByRole("region", { name: "Muscles that fit, best first" });
    await muscles.getByText("liquid per stroke").waitFor({ timeout: 60_000 });
    const [best] = ask("design", ...wanted, "--max-liquid", "40mL").candidates;
    await muscles
      .getByText(`${Number((1e-3 * best.liquid_volume_mm3).toPrecision(3))} cm³`)
      .first()
      .waitFor();
    assert.equal(await muscles.getByText("air per stroke").count(), 0);
    await page.goto(url() + "#design?F=50N&e=15%25&pmax=2.5bar&L=200mm&liquid=water&most=10mL");
    await page
      .getByText(/mL of liquid/)
      .first()
      .waitFor({ timeout: 60_000 });
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("a specification of several pulls has the command line's winner", async () => {
    const { page, errors, context } = await open("#design?at=700N@15%25,1200N@5%25");
    const said = ask("design", "--at", "700N@15%,1200N@5%", "--max-pressure", "2.5bar");
    await page
      .locator(".below tr.pick")
      .first()
      .filter({ hasText: `${Number(said.candidates[0].outer_diameter_mm.toPrecision(4))} mm` })
      .waitFor({ timeout: 60_000 });
    await page.goto(url() + "#design?joint=8Nm@45deg&pmax=2.5bar&D=30mm&s=1mm");
    await page.getByText(/^Pulley of radius/).waitFor({ timeout: 60_000 });
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("nothing fits is a sentence with what would", async () => {
    const { page, context } = await open("#design?F=900N&e=30%25&pmax=2bar&D=10..40mm");
    await page.getByText("Nothing fits.").waitFor({ timeout: 60_000 });
    await soon(async () => assert.ok((await page.locator(".question li").count()) > 0));
    await context.close();
  });

  test("tables of data, good and broken; constants identified", async () => {
    const { page, errors, context } = await open("#data");
    await page.waitForSelector(".drop");
    await page
      .locator("input[type=file]")
      .setInputFiles({
        name: "broken.csv",
        mimeType: "text/csv",
        buffer: Buffer.from("pressure_bar,contraction,force_n\n1,0.1,abc\n"),
      });
    await page.waitForSelector(".problem");
    await soon(async () => assert.match(await page.locator(".problem").innerText(), /line 2|row/i));
    await page.locator("input[type=file]").setInputFiles(`${root}examples/bench.csv`);
    await page.getByText("points.").first().waitFor({ timeout: 30_000 });
    await page.getByRole("button", { name: "Identify" }).click();
    await page.getByRole("heading", { name: "Identified" }).waitFor({ timeout: 60_000 });
    const [download] = await Promise.all([
      page.waitForEvent("download"),
      page.getByRole("button", { name: "Download the muscle" }).click(),
    ]);
    assert.match(
      readFileSync(/** @type {string} */ (await download.path())).toString(),
      /# Identified from/,
    );
    await page
      .locator("input[type=file]")
      .setInputFiles({
        name: "unnamed.csv",
        mimeType: "text/csv",
        buffer: Buffer.from("P1,eps,F [N]\n1,0.1,200\n2,0.1,400\n"),
      });
    await page.waitForSelector(".problem");
    await soon(async () =>
      assert.match(
        await page.locator(".problem").innerText(),
        /name it pressure_mpa, pressure_kpa, pressure_bar or Pressure \[psi\]$/,
      ),
    );
    // Its table is open, with what the headings lack to be typed.
    const cell = (/** @type {number} */ line, /** @type {number} */ column) =>
      page.getByRole("textbox", { name: `line ${line}, column ${column}` });
    await cell(1, 1).fill("P1 [bar]");
    await cell(1, 1).press("Tab");
    await page.waitForTimeout(100);
    assert.equal(await cell(1, 2).inputValue(), "eps");
    await page.getByText("unnamed.csv: 2 points.").waitFor({ timeout: 30_000 });
    // A line more, and cells of a spreadsheet that fill the table from one cell on.
    await cell(4, 1).fill("3");
    await cell(4, 2).fill("0.1");
    await cell(4, 3).fill("600");
    await cell(4, 3).press("Enter");
    await page.getByText("unnamed.csv: 3 points.").waitFor({ timeout: 30_000 });
    await cell(5, 1).evaluate((one) => {
      const clipboardData = new DataTransfer();
      clipboardData.setData("text/plain", "4\t0.1\t800\n5\t0.1\t1000\n");
      one.dispatchEvent(
        new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }),
      );
    });
    await page.getByText("unnamed.csv: 5 points.").waitFor({ timeout: 30_000 });
    assert.equal(await cell(6, 3).inputValue(), "1000");
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("a joint by dragging its arm", async () => {
    const { page, context } = await open("#joint");
    await page.waitForSelector(".numbers dl", { timeout: 30_000 });
    const box = /** @type {any} */ (await page.locator(".stage").boundingBox());
    await page.mouse.move(box.x + 0.75 * box.width, box.y + 0.4 * box.height);
    await page.mouse.down();
    await page.mouse.move(box.x + 0.7 * box.width, box.y + 0.8 * box.height, { steps: 5 });
    await page.mouse.up();
    await page.waitForFunction(() =>
      /Equilibrium angle\s*−\d/.test(document.querySelector(".numbers")?.textContent ?? ""),
    );
    await page.locator("summary").filter({ hasText: "Different second muscle" }).click();
    const thin = `[tube]\nouter_diameter = "24 mm"\nwall_thickness = "2 mm"\nlength = "285 mm"\nrubber = "paper"\n[braid]\nangle = "28 deg"\nstiffness = 150\n`;
    await page
      .getByLabel("Open muscle 2 (TOML)")
      .setInputFiles({
        name: "thin.toml",
        mimeType: "application/toml",
        buffer: Buffer.from(thin),
      });
    await page.getByText("Muscle 2 is that of its file.").waitFor();
    await soon(async () => assert.match(page.url(), /file2=/));
    await page.getByRole("button", { name: "Use the same muscle twice" }).click();
    await page.getByText("Both muscles are the one above.").waitFor();
    await context.close();
  });

  test("a move of the arm is played on Motion, and ends where finite elements hold the arm", async () => {
    const { page, errors, context } = await open("#joint?phi=20deg&K=8&mass=0.8kg");
    await page.waitForSelector(".numbers dl", { timeout: 30_000 });
    await page.getByText("Move the arm").click();
    await page.getByRole("textbox", { name: "Move to", exact: true }).fill("-10");
    await page.getByRole("textbox", { name: "Move to", exact: true }).press("Enter");
    await page.getByRole("button", { name: "Play in Motion" }).click();
    await page.locator("main[data-shown=motion]").waitFor({ timeout: 60_000 });
    const way = page.locator("[aria-label='motion contraction']");
    await way.locator("svg.curves").waitFor({ timeout: 120_000 });
    await soon(async () => {
      const [download] = await Promise.all([page.waitForEvent("download"), ofChart(way, "CSV")]);
      const rows = readFileSync(/** @type {string} */ (await download.path()), "utf8")
        .trim()
        .split("\n")
        .map((line) => line.split(","));
      assert.match(rows[0][2], /angle|φ/);
      const [first, last] = [Number(rows[1][2]), Number(rows.at(-1)?.[2])];
      assert.ok(Math.abs(first - 20) < 1 && Math.abs(last + 10) < 1, `${first}° to ${last}°`);
    });
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("narrow and very wide, larger text, less motion", async () => {
    for (const [width, height] of [
      [400, 800],
      [1024, 768],
      [3840, 2160],
    ]) {
      const { page, context } = await open("#muscle", {
        viewport: { width, height },
        reducedMotion: "reduce",
      });
      await alive(page);
      await page.waitForTimeout(1500);
      const over = await page.evaluate(
        () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
      );
      assert.ok(over <= 0, `${width} px: ${over} px too wide`);
      await page.screenshot({ path: `${shots}/muscle-${width}-${name}.png` });
      await page.addStyleTag({ content: ":root{font-size:200%}" });
      const wide = await page.evaluate(
        () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
      );
      assert.ok(wide <= 0, `${width} px at 200 %: ${wide} px too wide`);
      await context.close();
    }
  });

  if (name === "static")
    test("a worker that dies is replaced, and one that cannot start says so", async () => {
      const { page, context } = await open("#muscle");
      await alive(page);
      for (const worker of page.workers())
        await worker.evaluate(() => {
          setTimeout(() => {
            throw new Error("gone");
          });
        });
      await page.waitForTimeout(300);
      const field = page.getByRole("textbox", { name: "Pressure" });
      const before = await pull(page);
      await field.fill("1");
      await field.press("Enter");
      await page.waitForFunction(
        (text) => document.querySelector(".stage .say b")?.textContent !== text,
        before,
      );
      await context.close();
      const blocked = await blank();
      await blocked.page.route("**/live.wasm", (route) => route.abort());
      await blocked.page.goto(url() + "#muscle?D=25");
      await blocked.page.getByText("The computation engine stopped").waitFor();
      await blocked.page.unroute("**/live.wasm");
      await blocked.page.getByRole("button", { name: "Try again" }).click();
      await alive(blocked.page);
      await soon(async () => assert.match(blocked.page.url(), /D=25/));
      await blocked.context.close();
    });

  if (name === "static")
    test("an engine that panics says its last words, and another one is started", async () => {
      const { page, context } = await blank();
      await page.route("**/live.wasm", (route) =>
        route.fulfill({ contentType: "application/wasm", body: trapping("panicked at row 7") }),
      );
      await page.goto(url() + "#muscle?D=25");
      await page.getByText("panicked at row 7").first().waitFor();
      await page.unroute("**/live.wasm");
      await page.reload();
      await alive(page);
      await soon(async () => assert.match(page.url(), /D=25/));
      await context.close();
    });

  test("without WebGL a section", async () => {
    const { page, context } = await blank();
    await page.addInitScript(() => {
      const usual = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = function (
        /** @type {any} */ kind,
        /** @type {any[]} */ ...rest
      ) {
        return kind === "webgl2" ? null : /** @type {any} */ (usual).call(this, kind, ...rest);
      };
    });
    await page.goto(`${url()}#muscle`);
    await alive(page);
    await page.waitForSelector("svg.section clipPath", { state: "attached" });
    await context.close();
  });
});
