// Charts, the ± and its parts, and what is computed on demand on the page Muscle.
import { test } from "node:test";
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { gzipSync } from "node:zlib";
import { alive, asBuilt, go, ofChart, pull, soon } from "./browser.mjs";
import { ask, inBrowser, root, shots } from "./sites.mjs";

/** @typedef {import("playwright-core").Page} Page */
const drawn = (/** @type {Page} */ page) =>
  page.waitForSelector(".plot svg.curves", { timeout: 30_000 });
/** A chart as CSV, in rows. @param {Page} page */
async function saved(page) {
  const [download] = await Promise.all([page.waitForEvent("download"), ofChart(page, "CSV")]);
  return readFileSync(/** @type {string} */ (await download.path()))
    .toString()
    .trim()
    .split("\n")
    .map((line) => line.split(","));
}
/** The numbers along the lower axis. @param {Page} page */
const lower = (page) =>
  page.locator(".plot svg.curves > text[text-anchor=middle]").allTextContents();

inBrowser(({ name, open, blank, url }) => {
  test("the first load is at most 200 kB compressed before its engine, and 650 kB with it", async () => {
    const { page, context } = await blank();
    /** @type {Map<string, number>} */
    const loaded = new Map();
    /** @type {Promise<void>[]} */
    const bodies = [];
    page.on("response", (answer) => {
      const { pathname } = new URL(answer.url());
      if (answer.request().method() === "GET" && !pathname.includes("/api/"))
        bodies.push(
          answer.body().then(
            (body) => {
              loaded.set(pathname, gzipSync(body).length);
            },
            () => {},
          ),
        );
    });
    await page.goto(`${url()}#muscle`);
    await alive(page);
    await drawn(page);
    await Promise.all(bodies);
    const sum = [...loaded.values()].reduce((a, b) => a + b, 0);
    const engine = [...loaded].reduce(
      (all, [path, size]) => all + (path.endsWith(".wasm") ? size : 0),
      0,
    );
    assert.ok(
      loaded.size > 10 && sum - engine <= 200_000 && sum <= 650_000,
      `${sum} bytes in ${loaded.size} files, ${engine} of the engine`,
    );
    console.log(
      `first load, ${name}: ${Math.round(sum / 1000)} kB compressed in ${loaded.size} files`,
    );
    await context.close();
  });

  test("the curve at one's own pressure lies among the isobars, with the command line's pull and, dashed in its interval, that as built", async () => {
    const { page, errors, context } = await open("#muscle?p=2.2bar&e=10%25");
    await alive(page);
    await page.getByText("2.2 bar", { exact: true }).waitFor();
    const said = ask("force", "-p", "2.2bar", "-e", "0"),
      all = await saved(page);
    for (const [name, force] of /** @type {[string, number][]} */ ([
      ["2.2 bar", said.force_n],
      ["2.2 bar as built", said.predicted_n],
    ])) {
      const [row] = all.filter(([curve]) => curve === name);
      assert.ok(Math.abs(Number(row[2]) / force - 1) < 1e-6, `${row} for ${force}`);
    }
    await page.locator(".plot svg").getByText("as built").waitFor();
    await soon(async () =>
      assert.equal(await page.locator(".plot svg.curves svg path[fill-opacity]").count(), 1),
    );
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("a crosshair reads a curve off; a drag on an axis, the wheel and keys zoom, a double-click shows all", async () => {
    const { page, context } = await open("#muscle");
    await alive(page);
    await drawn(page);
    await page.getByText("2.5 bar", { exact: true }).waitFor();
    const plot = page.locator(".plot").first();
    await page.locator(".chart").scrollIntoViewIfNeeded();
    await page.waitForFunction(
      () => !(/** @type {HTMLElement} */ (document.querySelector(".ring")).hidden),
    );
    let ring = { x: 0, y: 0 };
    // Curves of the facts that come later have other axes.
    await soon(async () => {
      ring = /** @type {{ x: number, y: number }} */ (await page.locator(".ring").boundingBox());
      await page.mouse.move(ring.x + 8, ring.y + 8);
      await page.waitForTimeout(300);
      assert.match(
        await page.locator(".tip").innerText(),
        /^2.5 bar: 1[45](\.\d+)? %, 3[23]\d.* N$/,
      );
    });
    // Below it lies the curve as built, with the interval of the command line.
    for (let by = 20; by < 150; by += 4) {
      await page.mouse.move(ring.x + 8, ring.y + by);
      if (/as built/.test(await page.locator(".tip").innerText())) break;
    }
    const [, at, pulls] =
      /^2.5 bar as built: (1[45][.\d]*) %, (.*)$/.exec(await page.locator(".tip").innerText()) ??
      [];
    assert.equal(pulls, asBuilt(ask("force", "-p", "2.5bar", "-e", `${at}%`)));
    await page.mouse.move(ring.x + 8, ring.y + 8);
    const all = await lower(page);
    let box = { x: 0, y: 0, width: 0, height: 0 };
    // What comes above it may move it while it is being taken hold of.
    await soon(async () => {
      await plot.evaluate((plot) => plot.scrollIntoView({ block: "center" }));
      box = /** @type {typeof box} */ (await plot.boundingBox());
      await page.mouse.move(box.x + 0.4 * box.width, box.y + box.height - 20);
      await page.mouse.down();
      await page.mouse.move(box.x + 0.6 * box.width, box.y + box.height - 20, { steps: 3 });
      await page.mouse.up();
      await page.waitForTimeout(300);
      assert.notDeepEqual(await lower(page), all);
    });
    await soon(async () =>
      assert.equal(await page.getByRole("textbox", { name: "Contraction" }).inputValue(), "15 %"),
    );
    await page.getByRole("button", { name: "Show all" }).click();
    await soon(async () => assert.deepEqual(await lower(page), all));
    await plot.focus();
    for (let i = 0; i < 3; i++) await page.keyboard.press("+");
    await soon(async () => assert.notDeepEqual(await lower(page), all));
    await page.keyboard.press("0");
    await soon(async () => assert.deepEqual(await lower(page), all));
    await page.keyboard.press("ArrowRight");
    await soon(async () =>
      assert.match(await page.locator(".tip").innerText(), /^0.5 bar: 0 %, 189.* N$/),
    );
    await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.5 * box.height);
    await page.keyboard.down("Control");
    await page.mouse.wheel(0, -300);
    await page.keyboard.up("Control");
    await page.waitForSelector(".all:not([hidden])");
    await page.mouse.dblclick(box.x + 20, box.y + 0.5 * box.height);
    await soon(async () => assert.deepEqual(await lower(page), all));
    await context.close();
  });

  test("a click on the pull as built opens the parts of its ±, which add as squares, and what to measure", async () => {
    const { page, context } = await open("#muscle");
    await alive(page);
    const built = page.locator(".numbers dd .bare").first();
    await built.click();
    const parts = page.getByRole("region", { name: "Parts of the ±" });
    const {
      uncertainty_n: total,
      uncertainty_parts_n: said,
      uncertainty_words: words,
    } = ask("force", "-p", "2.5bar", "-e", "15%");
    await soon(async () => {
      const text = (await parts.innerText()).replaceAll("\u00a0", " ");
      for (const sentence of [words.built, words.bench])
        assert.ok(text.includes(sentence.replaceAll("\u00a0", " ").replaceAll("`", "")), text);
    });
    await soon(async () => {
      const shown = (await parts.locator("dd:not(.wide)").allInnerTexts()).map((text) =>
        Number(text.replace(/[^\d.]/g, "")),
      );
      assert.equal(shown.length, Object.values(said).filter((v) => v !== null).length);
      assert.ok(Math.abs(Math.hypot(...shown) / total - 1) < 0.02, `${shown} for ${total}`);
    });
    // They have the names of the command line, in its order.
    const named = [...words.text.split(": ")[1].matchAll(/([a-z() -]+) [\d.]+/g)];
    assert.deepEqual(
      (await parts.locator("dt").allInnerTexts()).slice(0, named.length),
      named.map(([, name]) => name.trim()),
    );
    await built.click();
    await soon(async () => assert.equal(await parts.isVisible(), false));
    await context.close();
  });

  test("what one more millimetre does is the difference of two answers of the command line", async () => {
    const { page, context } = await open("#muscle");
    await alive(page);
    await page.getByText("What a small change does").click();
    const bar = page.locator(".tornado > div", { hasText: "Outer diameter" });
    await bar.waitFor({ timeout: 30_000 });
    const at = (/** @type {string} */ D) =>
      ask("force", "-p", "2.5bar", "-e", "15%", "-D", D).force_n;
    const [less, same, more] = ["29mm", "30mm", "31mm"].map(at);
    const signed = (/** @type {number} */ v) =>
      `${v < 0 ? "−" : "+"}${Number(Math.abs(v).toPrecision(2))} N`;
    await soon(async () =>
      assert.ok(
        (await bar.innerText()).includes(`${signed(less - same)}, ${signed(more - same)}`),
        await bar.innerText(),
      ),
    );
    await context.close();
  });

  test("a diameter, a wall, an angle, a pressure and a contraction are solved for a wanted pull", async () => {
    const { page, errors, context } = await open("#muscle");
    await alive(page);
    await page.getByText("Solve for a wanted pull").click();
    await page.getByRole("textbox", { name: "Wanted pull" }).fill("450 N");
    for (const what of ["Outer diameter", "Pressure", "Contraction", "Braid angle"]) {
      await page.goto(url() + "#muscle?u=");
      await page.waitForFunction(() =>
        /326\.3/.test(document.querySelector(".stage .say")?.textContent ?? ""),
      );
      await page.getByRole("combobox", { name: "Solve for" }).selectOption({ label: what });
      await page.getByRole("button", { name: "Solve", exact: true }).click();
      await page.waitForFunction(
        () => /: (450|449\.9)/.test(document.querySelector(".stage .say")?.textContent ?? ""),
        undefined,
        { timeout: 20_000 },
      );
    }
    await page.goto(url() + "#muscle?u=");
    await page.waitForFunction(() =>
      /326\.3/.test(document.querySelector(".stage .say")?.textContent ?? ""),
    );
    await page.getByRole("combobox", { name: "Solve for" }).selectOption({ label: "Wall" });
    await page.getByRole("textbox", { name: "Wanted pull" }).fill("380 N");
    await page.getByRole("button", { name: "Solve", exact: true }).click();
    await page.waitForFunction(
      () => /: (380|379\.9)/.test(document.querySelector(".stage .say")?.textContent ?? ""),
      undefined,
      { timeout: 20_000 },
    );
    await page.getByRole("textbox", { name: "Wanted pull" }).fill("90000 N");
    await page.getByRole("combobox", { name: "Solve for" }).selectOption({ label: "Wall" });
    await page.getByRole("button", { name: "Solve", exact: true }).click();
    await page.getByText(/No wall between .* gives this pull/).waitFor({ timeout: 20_000 });
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("measured points lie on the isobars; a constant moves their residuals, a fit makes them small", async () => {
    const file = encodeURIComponent(readFileSync(`${root}examples/bench.toml`, "utf8"));
    const { page, errors, context } = await open(`#data?file=${file}`);
    await page.waitForSelector(".drop");
    await page.locator("input[type=file]").setInputFiles(`${root}examples/bench.csv`);
    await page.getByText("10 points").first().waitFor({ timeout: 30_000 });
    await go(page, "Muscle");
    await alive(page);
    await page.getByText(/Residuals: [\d.]+ N rms/).waitFor({ timeout: 30_000 });
    const rms = async () =>
      Number(/Residuals: ([\d.]+) N/.exec(await page.locator(".points").innerText())?.[1]);
    const before = await rms();
    const points = async () =>
      (await saved(page)).filter(([curve]) => curve.startsWith("measured at"));
    // They come by themselves, before or after their residuals.
    const rings = () =>
      page.evaluate(() =>
        [...document.querySelectorAll(".plot svg.curves svg path")].reduce(
          (sum, path) => sum + (path.getAttribute("d")?.split("m-3.2").length ?? 1) - 1,
          0,
        ),
      );
    await soon(async () => assert.equal(await rings(), 10));
    await soon(async () => assert.equal((await points()).length, 10));
    await page.screenshot({ path: `${shots}/points-${name}.png` });
    const wall = page.getByRole("textbox", { name: "Wall" });
    await wall.fill("2.5");
    await wall.press("Enter");
    await page.waitForFunction(
      (was) =>
        Number(
          /Residuals: ([\d.]+) N/.exec(document.querySelector(".points")?.textContent ?? "")?.[1],
        ) !== was,
      before,
    );
    const moved = await rms();
    await page.getByRole("button", { name: "Fit the rubber" }).click();
    await page.waitForFunction(
      (was) =>
        Number(
          /Residuals: ([\d.]+) N/.exec(document.querySelector(".points")?.textContent ?? "")?.[1],
        ) <
        0.9 * was,
      moved,
      { timeout: 30_000 },
    );
    await page.getByRole("button", { name: "Remove the points" }).click();
    await soon(async () =>
      assert.equal(await page.locator(".points .row.small").isVisible(), false),
    );
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("colours keep their scale while the state changes: 0.5 and 5 bar do not look alike", async () => {
    const { page, context } = await open("#muscle?p=0.5bar&e=5%25");
    await alive(page);
    const legend = () => page.locator(".stage .legend b").allInnerTexts();
    await page.waitForFunction(() =>
      /1\.01/.test(document.querySelector(".stage .legend")?.textContent ?? ""),
    );
    const before = await legend();
    const field = page.getByRole("textbox", { name: "Pressure" });
    const was = await pull(page);
    await field.fill("5");
    await field.press("Enter");
    await page.waitForFunction(
      (was) => document.querySelector(".stage .say b")?.textContent !== was,
      was,
    );
    await soon(async () => assert.deepEqual(await legend(), before));
    await context.close();
  });

  test("the loop of a muscle whose friction is known has both of the command line's branches", async () => {
    const file = encodeURIComponent(readFileSync(`${root}examples/tondu2012.toml`, "utf8"));
    const { page, context } = await open(`#muscle?file=${file}&p=3bar&e=10%25`);
    await alive(page);
    await page.waitForFunction(
      () => document.querySelectorAll("svg.curves path[stroke-dasharray]").length > 0,
      undefined,
      { timeout: 30_000 },
    );
    const said = (/** @type {string} */ direction) =>
      ask("force", "examples/tondu2012.toml", "-p", "3bar", "-e", "0", "--branch", direction)
        .force_n;
    const both = [said("contraction"), said("elongation")];
    await soon(async () => {
      const rows = await saved(page);
      ["shortens", "lengthens"].forEach((branch, i) => {
        const first = rows.find(([curve]) => curve === `3 bar while it ${branch}`);
        assert.ok(Math.abs(Number(first?.[2]) / both[i] - 1) < 1e-6, `${branch}: ${first}`);
      });
    });
    await context.close();
  });

  test("two fingers zoom the muscle", async () => {
    const { page, context } = await open("#muscle", { hasTouch: true });
    await alive(page);
    const bar = () =>
      page.evaluate(() => {
        const box = /** @type {HTMLElement} */ (document.querySelector(".stage .bar"));
        return (
          Number(box.querySelector("span")?.getBoundingClientRect().width) /
          parseFloat(box.textContent ?? "")
        );
      });
    const before = await bar();
    await page.evaluate(() => {
      const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector(".stage canvas")),
        { x, y, width, height } = canvas.getBoundingClientRect();
      canvas.setPointerCapture = () => {};
      const send = (
        /** @type {string} */ type,
        /** @type {number} */ pointerId,
        /** @type {number} */ dx,
      ) =>
        canvas.dispatchEvent(
          new PointerEvent(type, {
            pointerId,
            pointerType: "touch",
            clientX: x + width / 2 + dx,
            clientY: y + height / 2,
            bubbles: true,
          }),
        );
      send("pointerdown", 1, -50);
      send("pointerdown", 2, 50);
      send("pointermove", 2, 150);
      send("pointerup", 2, 150);
      send("pointerup", 1, -50);
    });
    await soon(async () =>
      assert.ok(Math.abs((await bar()) / before / 2 - 1) < 0.02, `${(await bar()) / before}`),
    );
    await context.close();
  });

  test("on a phone a finger drags the end of the muscle and a curve's ring; the muscle stays in sight", async () => {
    const { page, errors, context } = await open("#muscle", {
      viewport: { width: 400, height: 800 },
      hasTouch: true,
      isMobile: true,
    });
    await alive(page);
    await drawn(page);
    const session = await context.newCDPSession(page);
    /** A finger from the middle of a thing, or a share of its width along it. @param {string} of @param {number} dx @param {number} dy */
    const drag = async (of, dx, dy, share = 0.5) => {
      const box = /** @type {{ x: number, y: number, width: number, height: number }} */ (
        await page.locator(of).first().boundingBox()
      );
      const [x, y] = [box.x + share * box.width, box.y + box.height / 2];
      const send = (/** @type {string} */ type, /** @type {number} */ t) =>
        session.send("Input.dispatchTouchEvent", {
          type: /** @type {any} */ (type),
          touchPoints: type === "touchEnd" ? [] : [{ x: x + t * dx, y: y + t * dy }],
        });
      await send("touchStart", 0);
      for (const t of [0.25, 0.5, 0.75, 1]) await send("touchMove", t);
      await send("touchEnd", 1);
    };
    const value = async (/** @type {string} */ label) =>
      parseFloat(await page.getByRole("textbox", { name: label }).first().inputValue());
    const e = await value("Contraction");
    await soon(async () => {
      await drag(".stage canvas", -12, 0, 0.78);
      assert.ok((await value("Contraction")) > e);
    });
    const wall = page.getByRole("slider", { name: "Wall" });
    await wall.scrollIntoViewIfNeeded();
    const [stage, slider] = await Promise.all(
      [page.locator(".stage"), wall].map((one) => one.boundingBox()),
    );
    assert.ok(stage && slider && stage.y >= 0, "the muscle is in sight");
    assert.ok(slider.y > stage.y + stage.height, "beside the slider");
    await page.screenshot({ path: `${shots}/phone-${name}.png` });
    const at = await value("Contraction");
    await page.locator(".chart .ring").first().scrollIntoViewIfNeeded();
    await soon(async () => {
      await drag(".chart .ring", 40, 0);
      assert.notEqual(await value("Contraction"), at);
    });
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("on a phone two rows are above the muscle, and targets are 44 px", async () => {
    const { page, context } = await open("#muscle", {
      viewport: { width: 400, height: 800 },
      hasTouch: true,
      isMobile: true,
    });
    await alive(page);
    const frame = /** @type {{ height: number }} */ (await page.locator(".frame").boundingBox());
    assert.ok(frame.height <= 108, `${frame.height}`);
    const small = () =>
      page.evaluate(() =>
        [
          ...document.querySelectorAll(
            "main button, main select, summary, main input[type=range], header a, .frame button",
          ),
        ]
          .filter((e) => {
            const b = e.getBoundingClientRect();
            return b.width > 0 && (b.height < 43.5 || (e.tagName === "BUTTON" && b.width < 43.5));
          })
          .map((e) => `${e.tagName} ${e.textContent} ${e.getBoundingClientRect().height}`),
      );
    await soon(async () => assert.deepEqual(await small(), []));
    await soon(async () =>
      assert.ok(
        await page.evaluate(
          () => document.documentElement.scrollWidth <= document.documentElement.clientWidth,
        ),
      ),
    );
    await context.close();
  });

  test("the range of a joint file that is not symmetric is the page's: its limits, its curves, its angle", async () => {
    const file = `[joint]\nradius = "25 mm"\nrange = "-10..110 deg"\n[muscle_1]\nfile = "muscle.toml"\ncontraction_at_neutral = "12%"\n[muscle_2]\nfile = "muscle.toml"\ncontraction_at_neutral = "12%"\n`;
    const { page, errors, context } = await open(`#joint?joint=${encodeURIComponent(file)}`);
    await page.waitForSelector(".numbers dl", { timeout: 60_000 });
    const text = (/** @type {string} */ of) =>
      page.getByRole("textbox", { name: of, exact: true }).inputValue();
    await soon(async () =>
      assert.deepEqual([await text("Range from"), await text("Range to")], ["−10", "110"]),
    );
    await page.locator("[aria-label='joint torque'] svg.curves").waitFor();
    await soon(async () => {
      const angles = (await saved(page))
        .slice(1)
        .filter(([curve]) => / \| /.test(curve))
        .map(([, x]) => Number(x));
      assert.deepEqual([Math.min(...angles), Math.max(...angles)], [-10, 110]);
    });
    const arm = page.getByRole("slider", { name: "Angle", exact: true });
    await arm.focus();
    for (let i = 0; i < 30; i++) await page.keyboard.press("PageDown");
    await page.waitForFunction(() => /phi=-10/.test(location.hash));
    // A link of before has one number for both sides.
    await page.goto(url() + "#joint?range=45deg");
    await page.waitForFunction(() =>
      /** @type {HTMLInputElement[]} */ ([...document.querySelectorAll("input")]).some(
        (f) => f.value === "−45",
      ),
    );
    assert.deepEqual(errors, []);
    await context.close();
  });

  test("the joint is drawn to scale, with its range and what it reaches", async () => {
    const { page, errors, context } = await open("#joint");
    await page.getByText("mean pressure 0 to 1 bar").waitFor({ timeout: 60_000 });
    await page.waitForSelector(".numbers dl");
    // Pulley of 25 mm and scale of 50 mm in the same units.
    const scale = () =>
      page.evaluate(() => {
        const joint = /** @type {SVGElement} */ (document.querySelector("svg.joint"));
        return {
          radius: Number(joint.querySelector(".pulley")?.getAttribute("r")),
          bar: /** @type {SVGPathElement} */ (joint.querySelector(".line")).getBBox().width,
        };
      });
    await soon(async () => assert.deepEqual(await scale(), { radius: 25, bar: 50 }));
    await soon(async () => assert.equal(await page.locator("svg.joint .range").count(), 1));
    await soon(async () =>
      assert.equal(
        await page
          .locator('section[aria-label="joint torque"] svg.curves svg path[fill-opacity]')
          .count(),
        1,
      ),
    );
    assert.deepEqual(errors, []);
    await context.close();
  });
});
