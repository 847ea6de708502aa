// Figures of the engine (data: panels, axes, series, marks) as charts.
import { chartOf, KINDS, shade } from "./chart.js";
import { block, capital, el, remark } from "./dom.js";
import { inWords } from "./units.js";

/** @typedef {NonNullable<Commands["curve"]["answer"]["figure"]>} Figure */
/** @typedef {Figure["panels"][number]} Panel */
const DASHES = /** @type {const} */ (["solid", "dash", "dot", "dash"]);

/** Charts for the panels of a figure; those made before are used again. */
export class Figures {
  /** @param {string} name of the files */
  constructor(name) {
    this.name = name;
    /** @type {import("./chart.js").Chart[]} */ this.charts = [];
    this.caption = remark();
    this.grid = block("charts");
    this.element = block("", this.grid, this.caption);
    this.element.hidden = true;
  }

  /** @param {Figure | null | undefined} figure */
  show(figure) {
    this.element.hidden = !figure;
    if (!figure) return;
    while (this.charts.length < figure.panels.length) {
      const title = el("h3", { class: "grow" });
      const chart = chartOf(`${this.name}-${this.charts.length + 1}`, { tools: title });
      this.charts.push(chart);
    }
    this.grid.replaceChildren(...this.charts.slice(0, figure.panels.length).map((c) => c.element));
    figure.panels.forEach((panel, i) => {
      const heading = this.charts[i].element.querySelector("h3");
      if (heading)
        heading.textContent = capital(panel.title || `${named(panel.y)} over ${named(panel.x)}`);
      this.charts[i].show(spec(panel, figure));
    });
    this.caption.textContent = inWords(figure.caption);
  }
}

/** What an axis shows, without symbol and unit. @param {Panel["x"]} axis */
const named = ({ label }) => label.replace(/( \S{1,2})? \[.*$/, "").replace(" ratio", "");
/** Contractions are in % everywhere on the page. @param {Panel["x"]} axis */
const scale = ({ label }) => (label.endsWith("ε [–]") ? 100 : 1);
const words = (/** @type {Panel["x"]} */ axis) =>
  scale(axis) === 100 ? "contraction ε [%]" : axis.label;

/** @param {Panel} panel @param {Figure} figure @returns {Spec} */
function spec(panel, figure) {
  const [kx, ky] = [scale(panel.x), scale(panel.y)],
    ordered = figure.palette === "sequential",
    most = Math.max(1, ...figure.panels.flatMap((p) => p.series.map((s, i) => s.colour ?? i)));
  /** @returns {Series} */
  const one = (/** @type {Panel["series"][number]} */ s, /** @type {number} */ i) => {
    const n = s.colour ?? i,
      auto = ordered ? "solid" : DASHES[n % DASHES.length],
      band = s.style === "band";
    /** @type {Record<string, Series["dash"]>} */ const dashes = {
      dashed: "dash",
      dotted: "dot",
      "dash-dot": "dash",
      auto,
    };
    return {
      name: band ? "±" : s.label || s.end_label || panel.y.label,
      legend: band ? "" : s.label,
      end: s.end_label || undefined,
      band,
      dash: dashes[s.style],
      mode: s.style === "points" ? "markers" : "lines",
      colour: ordered ? shade(n / most) : s.neutral ? "currentColor" : KINDS[n % KINDS.length],
      // A gap is no number.
      x: s.points.map((p) => kx * (p[0] ?? NaN)),
      y: s.points.map((p) => ky * (p[1] ?? NaN)),
    };
  };
  const range = (/** @type {Panel["x"]} */ axis) =>
    axis.range
      ? { range: axis.range.map((v) => scale(axis) * v) }
      : { rangemode: axis.from_zero ? "tozero" : "normal" };
  return {
    x: words(panel.x),
    y: words(panel.y),
    series: panel.series.map(one),
    marks: panel.marks.map((m) => ({ x: kx * m.x, y: ky * m.y, text: m.label })),
    xaxis: range(panel.x),
    yaxis: range(panel.y),
  };
}
