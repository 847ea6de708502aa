// A chart: curves over a picture or none, as SVG (lines.js); with a table, PNG, SVG and CSV.
import { atEnd } from "./life.js";
import { csv, download, el } from "./dom.js";
import { table } from "./form.js";
import { Lines } from "./lines.js";
import { KINDS } from "./plot.js";
import { number, outside } from "./units.js";

export { KINDS };


const VIRIDIS = [[68, 1, 84], [71, 44, 122], [59, 81, 139], [44, 113, 142], [33, 144, 141], [39, 173, 129],
  [92, 200, 99], [170, 220, 50], [253, 231, 37]];
/** Viridis between 0 and 1 as red, green and blue. @param {number} share @param {number} most of the map */
export function viridisAt(share, most) {
  const t = Math.min(1, Math.max(0, share)) * most * (VIRIDIS.length - 1);
  const i = Math.min(VIRIDIS.length - 2, Math.floor(t));
  return VIRIDIS[i].map((a, k) => Math.round(a + (t - i) * (VIRIDIS[i + 1][k] - a)));
}
/** Without its palest end, which a white page would swallow. @param {number} share */
export const viridis = (share, most = 0.82) => `rgb(${viridisAt(share, most).join(",")})`;
/** The colour of a pressure: the same in every chart of a page. @param {number} pressure @param {number} top */
export function pressureColour(pressure, top) {
  const dark = isDark();
  return dark ? viridis(0.25 + 0.75 * (pressure / top), 1) : viridis(pressure / top);
}
export const isDark = () =>
  document.documentElement.dataset.theme
    ? document.documentElement.dataset.theme === "dark"
    : matchMedia("(prefers-color-scheme: dark)").matches;

export class Chart {
  /**
   * @param {string} name of its files
   * @param {{ tools?: Node, tall?: boolean, drag?: (x: number, y: number, settled: boolean) => void }} [options]
   */
  constructor(name, { tools, tall, drag } = {}) {
    this.name = name;
    /** @type {Spec | undefined} */ this.spec = undefined;
    this.plot = el("div", { class: "plot" });
    this.table = el("div", { class: "scroll", hidden: true, tabindex: 0 });
    this.asTable = el("button", { type: "button", "aria-pressed": false, onclick: () => this.flip() }, "Table");
    const save = (/** @type {"csv" | "svg" | "png"} */ kind) =>
      el("button", { type: "button", onclick: () => this.save(kind) }, kind.toUpperCase());
    const bar = el("div", { class: "row" }, tools ?? null, el("span", { class: "grow" }), this.asTable, save("csv"),
      save("svg"), save("png"));
    this.element = el("section", { class: tall ? "chart tall" : "chart", "aria-label": name.replaceAll("-", " ") }, bar,
      this.plot, this.table);
    this.ring = el("i", { class: "ring", hidden: true });
    /** @type {number[] | undefined} */ this.at = undefined;
    this.ends = new AbortController();
    const { signal } = this.ends;
    this.lines = new Lines(this.plot, name, drag, signal);
    /** What drawing took the last time, in milliseconds. */
    this.cost = 0;
    this.sized = new ResizeObserver(() => this.plot.offsetWidth && this.draw());
    this.sized.observe(this.plot);
    atEnd(() => this.destroy());
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.draw(), { signal });
    document.addEventListener("theme", () => this.draw(), { signal });
    this.plot.addEventListener("zoomed", () => this.placeMark(), { signal });
  }

  /** Nothing of it is kept, and no listener. */
  destroy() {
    this.ends.abort();
    this.sized.disconnect();
    this.spec = undefined;
    this.element.remove();
  }

  /**
   * A ring over the curves at values of the axes; none without. Nothing is drawn anew for it.
   * @param {number} [x] @param {number} [y]
   */
  mark(x, y) {
    this.at = x === undefined || y === undefined ? undefined : [x, y];
    this.placeMark();
  }

  /** What lies at a place of the plot, as values of its axes. @param {number} px @param {number} py */
  values(px, py) { return this.lines.values(px, py); }

  placeMark() {
    const place = this.at && this.lines.place(this.at[0], this.at[1]);
    this.ring.hidden = !place;
    if (!place) return;
    this.ring.style.transform = `translate(${place[0]}px, ${place[1]}px)`;
    if (this.ring.parentElement !== this.plot) this.plot.append(this.ring);
  }

  flip() {
    const on = this.asTable.getAttribute("aria-pressed") !== "true";
    this.asTable.setAttribute("aria-pressed", String(on));
    this.table.hidden = !on;
    this.plot.hidden = on;
    if (on) this.tabulate();
    else this.draw();
  }

  /** @param {Spec} spec */
  show(spec) {
    // An answer that comes after the page was left.
    if (this.ends.signal.aborted) return;
    this.spec = spec;
    if (!this.table.hidden) this.tabulate();
    this.draw();
  }

  draw() {
    if (!this.spec || this.plot.hidden) return;
    const began = performance.now();
    this.lines.draw(this.spec);
    this.cost = performance.now() - began;
    this.placeMark();
  }

  /** What the columns of the table are. */
  head() {
    const spec = /** @type {Spec} */ (this.spec);
    return ["curve", spec.x, spec.y, ...(spec.z ? [spec.z] : [])];
  }

  /**
   * Rows of all series: name, x, y, and the third number where there is one.
   * @returns {(string | number | null)[][]}
   */
  rows() {
    const { series = [], rows, z: third } = this.spec ?? {};
    const more = (/** @type {Series} */ s, /** @type {number} */ i) => (third ? [s.z?.[i] ?? null] : []);
    const line = (/** @type {Series} */ s) => s.x.map((x, i) => [s.name, x, s.y[i], ...more(s, i)]);
    return rows ?? series.filter((s) => !s.silent).flatMap(line);
  }

  tabulate() {
    const rows = this.rows().map((row) => row.map((v) => (typeof v === "string" ? v : number(v))));
    this.table.replaceChildren(table(this.head(), rows).firstElementChild ?? "");
  }

  /** @param {"csv" | "svg" | "png"} kind */
  async save(kind) {
    if (!this.spec) return;
    if (kind === "csv") return download(`${this.name}.csv`, csv([this.head(), ...this.rows()]), "text/csv");
    const size = { width: Math.max(640, this.plot.clientWidth), height: Math.max(400, this.plot.clientHeight) };
    const url = await this.lines.picture(kind, size);
    el("a", { href: url, download: `${this.name}.${kind}` }).click();
    if (url.startsWith("blob:")) setTimeout(() => URL.revokeObjectURL(url), 10_000);
  }
}

/**
 * Points of an isobaric curve as a line of pull over contraction in %; it ends at the free contraction, wherever the
 * points lie.
 * @param {Commands["curve"]["answer"]["points"]} points
 */
export function isobar(points) {
  const slack = points.findIndex((q) => "force_n" in q && q.slack), last = points[slack];
  const free = last && "force_n" in last ? last.free_contraction : undefined;
  const taut = slack < 0 ? points : points.slice(0, slack), at = taut.map((q) => 100 * (q.contraction ?? NaN));
  const ends = slack > 0 && typeof free === "number" && 100 * free > at[slack - 1] ? [100 * free] : [];
  return {
    x: [...at, ...ends],
    y: [...taut.map((q) => ("force_n" in q ? outside("force", q.force_n) : null)), ...ends.map(() => 0)],
    half: [...taut, ...(ends.length ? [last] : [])].map((q) =>
      "force_n" in q && q.uncertainty_n ? outside("force", q.uncertainty_n) : null,
    ),
  };
}
