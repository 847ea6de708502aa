// A fitted formula as people see it: its errors, its figures, and maps of its pull.
import { engine } from "./ask.js";
import { Chart, viridisAt } from "./chart.js";
import {
  button,
  download,
  el,
  folded,
  heading,
  paragraph,
  remark,
  smallPrint,
} from "./dom.js";
import { Figures } from "./figure.js";
import { table } from "./form.js";
import { atEnd } from "./life.js";
import { levels, picture, sampled, valueBetween } from "./map.js";
import {
  evenly,
  outside,
  ratioAxis,
  showLength,
  showRatio,
  unitName,
} from "./units.js";

/** The paper's formula, with the box that it was fitted in. */
export const PUBLISHED = {
  name: "Formula (Antonelli 2018)",
  range:
    /** @type {Record<"outer_diameter_mm" | "wall_mm" | "contraction", [number, number]>} */ ({
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
export function errorsView(file) {
  const e = file.errors,
    share = (/** @type {number} */ x) => showRatio(x, 3);
  const row = (
    /** @type {string} */ name,
    /** @type {File["errors"]["fit"]} */ x,
  ) => [
    name,
    String(x.points),
    share(x.rms_of_blocked),
    share(x.p95_of_blocked),
    share(x.max_of_blocked),
  ];
  const kept = "held_out" in e ? e.held_out : undefined;
  const rows = [
    row("fitted to", e.fit),
    ...(kept ? [row("kept out", kept)] : []),
  ];
  const save = () =>
    download(
      `${file.name}.json`,
      JSON.stringify(file, null, 2) + "\n",
      "application/json",
    );
  return [
    heading(file.name),
    smallPrint(el("code", {}, file.equation)),
    table(
      ["against finite elements", "points", "rms", "95 %", "largest"],
      rows,
      { label: "errors of the formula, of the blocked force" },
    ),
    remark("Errors as shares of the blocked force."),
    paragraph(button("Download the formula", save)),
  ];
}

/** Figures that are drawn when they are opened. @param {Fitted["figures"]} drawn */
export const figuresView = (drawn) =>
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
export function surfaces() {
  const wallTitle = el("h2"),
    diameterTitle = el("h2");
  const overWall = new Chart("map-wall", { tools: wallTitle, tall: true }),
    overDiameter = new Chart("map-diameter", {
      tools: diameterTitle,
      tall: true,
    });
  const element = el(
      "div",
      { class: "charts", hidden: true },
      overWall.element,
      overDiameter.element,
    ),
    ends = new AbortController();
  atEnd(() => ends.abort());
  /**
   * @param {Chart} chart @param {string} label @param {number[]} list @param {number[]} E
   * @param {(value: number) => Promise<(number | null)[]>} line
   */
  async function draw(chart, label, list, E, line) {
    /** @type {(number | null)[][]} */ const values = [];
    for (const value of list) values.push(await line(value));
    const x = E.map((e) => 100 * e),
      y = list.map((v) => outside("length", v)),
      unit = unitName("force");
    const field = sampled(x, y, 8, (px, py) =>
      valueBetween({ x, y, values }, px, py),
    );
    const known = values.flat().filter((v) => v !== null),
      [low, high] = [Math.min(...known), Math.max(...known)];
    const image = picture(field, (v) =>
      v === null
        ? [0, 0, 0, 0]
        : [...viridisAt((v - low) / (high - low || 1), 1), 255],
    );
    chart.show({
      x: ratioAxis,
      y: label,
      z: `pull F [${unit}]`,
      picture: image,
      ...levels(field, unit),
      xaxis: { range: [x[0], x[x.length - 1]] },
      yaxis: { range: [y[0], y[y.length - 1]] },
      rows: y.flatMap((v, j) => x.map((u, i) => ["pull", u, v, values[j][i]])),
    });
  }
  return {
    element,
    /** @param {File | typeof PUBLISHED} formula @param {number | undefined} at the pressure in MPa */
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
        formula === PUBLISHED
          ? "paper"
          : { name: formula.name, text: JSON.stringify(formula) };
      const line =
        (/** @type {string} */ field) =>
        async (/** @type {number} */ value) => {
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
          return answer.points.map((q) =>
            "force_n" in q ? outside("force", q.force_n) : null,
          );
        };
      await draw(overWall, `s [${unitName("length")}]`, S, E, line("wall_mm"));
      await draw(
        overDiameter,
        `D0 [${unitName("length")}]`,
        D,
        E,
        line("outer_diameter_mm"),
      );
    },
  };
}
