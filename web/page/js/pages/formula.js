// A campaign of finite-element tests and the formula fitted to it: errors, figures, surfaces, and
// the file.
import {
  block,
  button,
  download,
  el,
  faded,
  folded,
  heading,
  paragraph,
  remark,
  smallPrint,
} from "../dom.js";
import { bench, fieldsOf, form, job, table } from "../form.js";
import { fileOf, keepFile } from "../kept.js";
import { muscle } from "../muscle.js";
import { evenly, onUnits, outside, ratioAxis, showLength, showRatio, unitName } from "../units.js";
import { engine } from "../ask.js";
import { chartOf, viridisAt } from "../chart.js";
import { Figures } from "../figure.js";
import { atEnd } from "../life.js";
import { levels, picture, sampled, span, valueBetween, whole } from "../map.js";

const PLAN = `name = "page"

[tube]
length = "285 mm"
rubber = "paper"

[braid]
angle = "28 deg"
stiffness = "paper"

[sampling]
method = "factorial"

[vary]
tube.outer_diameter = "30,40,45,50 mm"
tube.wall_thickness = "1..5:1 mm"

[test]
contractions = "0..0.20:0.05"
pressures = "0..0.25:0.01 MPa"
`;
/** The plan that was computed before: it is computed again when one comes back. */
const COMPUTED = /** @type {const} */ ("campaign");

/** How a formula is fitted. @type {Field[]} */
export const HOW = fieldsOf([
  [
    "method",
    "method",
    "Method",

    {
      options: [
        ["paper", "seven steps (Antonelli 2018)"],
        ["global", "one least-squares problem"],
      ],
      value: "paper",
    },
  ],
  ["hold", "hold_out_mm", "Diameters kept out", "length", { list: true, hint: "45 mm" }],
  ["at", "at", "Maps at", "pressure", "2.5 bar"],
]);

// A fitted formula as people see it: its errors, its figures, and maps of its pull.
/** The paper's formula, with the box that it was fitted in. */
const PUBLISHED = {
  name: "Formula (Antonelli 2018)",
  range: /** @type {Record<"outer_diameter_mm" | "wall_mm" | "contraction", [number, number]>} */ ({
    outer_diameter_mm: [30, 50],
    wall_mm: [1, 5],
    contraction: [0, 0.2],
  }),
};

/**
 * A formula as a fit gives it.
 * @typedef {Commands["fit"]["answer"]} Fitted
 * @typedef {Omit<Fitted, "figures" | "tables">} File
 */
/** @param {File} file a formula */
function errorsView(file) {
  const e = file.errors,
    share = (/** @type {number} */ x) => showRatio(x, 3);
  const row = (/** @type {string} */ name, /** @type {File["errors"]["fit"]} */ x) => [
    name,
    String(x.points),
    share(x.rms_of_blocked),
    share(x.p95_of_blocked),
    share(x.max_of_blocked),
  ];
  const kept = "held_out" in e ? e.held_out : undefined;
  const rows = [row("fitted to", e.fit), ...(kept ? [row("kept out", kept)] : [])];
  const save = () => download(`${file.name}.json`, JSON.stringify(file, null, 2) + "\n");
  return [
    heading(file.name),
    smallPrint(el("code", file.equation)),
    table(["against finite elements", "points", "rms", "95 %", "largest"], rows, {
      label: "errors of the formula, of the blocked force",
    }),
    remark("Errors as shares of the blocked force."),
    paragraph(button("Download the formula", save)),
  ];
}

/** Figures that are drawn when they are opened. @param {Fitted["figures"]} drawn */
const figuresView = (drawn) =>
  (drawn ?? []).map((f) => {
    const box = folded(f.figure.title || f.name);
    box.addEventListener(
      "toggle",
      () => {
        const one = new Figures(f.name);
        box.append(one.element);
        one.show(f.figure);
      },
      { once: true },
    );
    return box;
  });

/** So many values between two ends. @param {[number, number]} ends */
const steps = ([low, high], n = 11) => evenly(low, high, n);

/** The formula as two maps: over contraction and wall, and over contraction and diameter. */
function surfaces() {
  const wallTitle = el("h2"),
    diameterTitle = el("h2");
  const overWall = chartOf("map-wall", { tools: wallTitle, tall: true }),
    overDiameter = chartOf("map-diameter", { tools: diameterTitle, tall: true });
  const element = el(
      "div",
      { class: "charts", hidden: true },
      overWall.element,
      overDiameter.element,
    ),
    ends = new AbortController();
  atEnd(() => ends.abort());
  /**
   * @param {import("../chart.js").Chart} chart @param {string} label @param {number[]} list
   * @param {number[]} E
   * @param {(value: number) => Promise<(number | null)[]>} line
   */
  async function draw(chart, label, list, E, line) {
    /** @type {(number | null)[][]} */ const values = [];
    for (const value of list) values.push(await line(value));
    const x = E.map((e) => 100 * e),
      y = list.map((v) => outside("length", v)),
      unit = unitName("force");
    const field = sampled(x, y, 8, (px, py) => valueBetween({ x, y, values }, px, py));
    const [low, high] = span(values);
    const image = picture(field, (v) =>
      v === null ? [0, 0, 0, 0] : [...viridisAt((v - low) / (high - low || 1), 1), 255],
    );
    chart.show({
      x: ratioAxis,
      y: label,
      z: `pull F [${unit}]`,
      picture: image,
      ...levels(field, unit),
      xaxis: whole(x),
      yaxis: whole(y),
      rows: y.flatMap((v, j) => x.map((u, i) => ["pull", u, v, values[j][i]])),
    });
  }
  return {
    element,
    /**
     * @param {File | typeof PUBLISHED} formula @param {number | undefined} at the pressure in MPa
     */
    async show(formula, at) {
      const { range } = formula;
      element.hidden = true;
      if (!("outer_diameter_mm" in range) || !at) return;
      element.hidden = false;
      const [D, S, E] = [
          steps(range.outer_diameter_mm),
          steps(range.wall_mm),
          steps(range.contraction, 21),
        ],
        middle = { outer_diameter_mm: D[5], wall_mm: S[5] };
      wallTitle.textContent = `Pull over contraction and wall, D0 ${showLength(D[5])}`;
      diameterTitle.textContent = `Pull over contraction and diameter, s ${showLength(S[5])}`;
      const name =
        formula === PUBLISHED ? "paper" : { name: formula.name, text: JSON.stringify(formula) };
      const line = (/** @type {string} */ field) => async (/** @type {number} */ value) => {
        const answer = await engine().ask(
          "curve",
          {
            muscle: { ...middle, [field]: value },
            model: { name },
            test: "isobaric",
            pressures_mpa: [at],
            contractions: E,
            extrapolate: true,
          },
          { signal: ends.signal },
        );
        return answer.points.map((q) => ("force_n" in q ? outside("force", q.force_n) : null));
      };
      await draw(overWall, `s [${unitName("length")}]`, S, E, line("wall_mm"));
      await draw(overDiameter, `D0 [${unitName("length")}]`, D, E, line("outer_diameter_mm"));
    },
  };
}

/** @type {Mount} */
export const mount = (main) => {
  /** @type {Commands["plan"]["answer"] | undefined} */ let made;
  /** @type {File | typeof PUBLISHED} */ let formula = PUBLISHED;
  const plan = el("textarea", {
    rows: 20,
    style: "width:100%;font:13px ui-monospace,monospace",
    ariaLabel: "Plan (TOML)",
  });
  plan.value = fileOf("plan") ?? PLAN;
  plan.addEventListener("input", () =>
    keepFile("plan", plan.value === PLAN ? undefined : plan.value),
  );
  const how = form(HOW, () => (made ? fit.run() : paint()));
  const table1 = smallPrint(),
    errors = block(),
    figures = block(),
    shown = surfaces();
  const about = { fields: how, shown: [errors, shown.element, figures] };
  const campaign = job(
    "Compute the plan",
    "plan",
    async () => ({ plan: { name: "page.toml", text: plan.value } }),
    (answer) => {
      made = answer;
      keepFile(COMPUTED, plan.value);
      table1.replaceChildren(
        `${answer.muscles} muscles, ${answer.points} points, ${answer.failed} without an answer. `,
        button("Download the table", () => download(answer.table.name, answer.table.text)),
      );
      fit.run();
    },
    about,
  );
  const fit = job(
    "Fit",
    "fit",
    async () => {
      if (!made) {
        errors.replaceChildren(faded("Compute the plan first."));
        return undefined;
      }
      const read = await how.read();
      if (!read) return undefined;
      place();
      return {
        table: made.table,
        method: read.method,
        hold_out_mm: read.hold_out_mm,
        figures: true,
      };
    },
    (answer) => {
      const { figures: drawn, tables, ...file } = answer;
      formula = file;
      errors.replaceChildren(...errorsView(file));
      figures.replaceChildren(...figuresView(drawn));
      paint();
    },
    { ...about, minor: true },
  );
  main.replaceChildren(
    bench(
      "Campaign",
      [
        heading("Campaign"),
        remark(
          "A plan lists the muscles to compute by finite elements. This is the plan of Antonelli (2018).",
        ),
        folded("Advanced", plan),
        campaign.element,
        table1,
        how.element,
        fit.element,
      ],
      [errors, shown.element, figures],
    ),
  );
  errors.append(heading(PUBLISHED.name), faded("Below is the published formula."));

  const place = () => muscle.place("formula", how.texts());
  async function paint() {
    place();
    const read = await how.read();
    await shown.show(formula, read?.at).catch(() => {
      shown.element.hidden = true;
    });
  }
  onUnits(paint);
  return {
    async load(params) {
      await muscle.read(params, how.keys);
      how.set(params);
      // One that was dropped meanwhile.
      plan.value = fileOf("plan") ?? plan.value;
      if (fileOf(COMPUTED) === plan.value && !made) campaign.run();
      else paint();
    },
  };
};
