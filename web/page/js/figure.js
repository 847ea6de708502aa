// Figures of the engine (data: panels, axes, series, marks) as charts.
import { Chart, KINDS, isDark, token, viridis } from "./chart.js";
import { el } from "./dom.js";

const DASHES = /** @type {const} */ (["solid", "dash", "dot", "dash"]);

/** Charts for the panels of a figure; those made before are used again. */
export class Figures {
  /** @param {string} name of the files */
  constructor(name) {
    this.name = name;
    /** @type {Chart[]} */ this.charts = [];
    this.caption = el("p", { class: "small soft" });
    this.grid = el("div", { class: "charts" });
    this.element = el("div", {}, this.grid, this.caption);
    this.element.hidden = true;
  }

  /** @param {any} figure */
  show(figure) {
    this.element.hidden = !figure;
    if (!figure) return;
    while (this.charts.length < figure.panels.length) {
      const title = el("h3", { class: "grow" });
      const chart = new Chart(`${this.name}-${this.charts.length + 1}`, { tools: title });
      this.charts.push(chart);
    }
    this.grid.replaceChildren(...this.charts.slice(0, figure.panels.length).map((c) => c.element));
    figure.panels.forEach((/** @type {any} */ panel, /** @type {number} */ i) => {
      const heading = this.charts[i].element.querySelector("h3");
      if (heading) heading.textContent = panel.title || panel.y.label;
      this.charts[i].show(spec(panel, figure));
    });
    this.caption.textContent = figure.caption;
  }
}

/** @param {any} panel @param {any} figure */
function spec(panel, figure) {
  const numbers = figure.panels.flatMap((/** @type {any} */ p) =>
    p.series.map((/** @type {any} */ s, /** @type {number} */ i) => s.colour ?? i),
  );
  const most = Math.max(1, ...numbers);
  const colour = (/** @type {any} */ s, /** @type {number} */ i) => {
    const n = s.colour ?? i;
    if (s.neutral && figure.palette !== "sequential") return token("--ink");
    if (figure.palette !== "sequential") return KINDS[n % KINDS.length];
    return isDark() ? viridis(0.42 + (0.58 * n) / most, 1) : viridis(n / most);
  };
  const series = panel.series.map((/** @type {any} */ s, /** @type {number} */ i) => {
    const points = s.style === "points" || s.style === "line-and-points";
    const dash =
      s.style === "dashed"
        ? "dash"
        : s.style === "dotted"
          ? "dot"
          : s.style === "auto" && figure.palette !== "sequential"
            ? DASHES[(s.colour ?? i) % DASHES.length]
            : "solid";
    if (s.style === "band")
      return {
        name: "±",
        colour: colour(s, i),
        band: true,
        x: s.points.map((/** @type {any} */ p) => p[0]),
        y: s.points.map((/** @type {any} */ p) => p[1]),
        legend: "",
      };
    return {
      name: s.label || s.end_label || panel.y.label,
      end: s.end_label || undefined,
      colour: colour(s, i),
      dash,
      mode: s.style === "points" ? "markers" : points ? "lines+markers" : "lines",
      x: s.points.map((/** @type {any} */ p) => p[0]),
      y: s.points.map((/** @type {any} */ p) => p[1]),
      legend: s.label,
    };
  });
  const range = (/** @type {any} */ axis) =>
    axis.range ? { range: axis.range } : { rangemode: axis.from_zero ? "tozero" : "normal" };
  return {
    x: panel.x.label,
    y: panel.y.label,
    series,
    marks: panel.marks.map((/** @type {any} */ m) => ({ x: m.x, y: m.y, text: m.label })),
    xaxis: range(panel.x),
    yaxis: range(panel.y),
  };
}
