// A chart: curves over a picture or none, as SVG (lines.js); with a table, PNG, SVG and CSV.
import { atEnd } from "./life.js";
import { block, button, csv, download, el, menu } from "./dom.js";
import { table } from "./form.js";
import { Lines } from "./lines.js";
import { KINDS } from "./plot.js";
import { VIRIDIS } from "./shaders.js";
import { isDark, onTheme } from "./theme.js";
import { builtPull, clamp, number, outside } from "./units.js";

export { KINDS };

/** Viridis between 0 and 1 as red, green and blue. @param {number} share @param {number} most of the map */
export function viridisAt(share, most) {
  const t = clamp(share, 0, 1) * most * (VIRIDIS.length - 1);
  const i = Math.min(VIRIDIS.length - 2, Math.floor(t));
  return VIRIDIS[i].map((a, k) =>
    Math.round(a + (t - i) * (VIRIDIS[i + 1][k] - a)),
  );
}
/** Without its palest end, which a white page would swallow. @param {number} share */
export const viridis = (share, most = 0.82) =>
  `rgb(${viridisAt(share, most).join(",")})`;
/** The colour of a share, to be seen on the page. @param {number} share */
export const shade = (share) =>
  isDark() ? viridis(0.3 + 0.7 * share, 1) : viridis(share);
/** The colour of a pressure: the same in every chart of a page. @param {number} pressure @param {number} top */
export const pressureColour = (pressure, top) => shade(pressure / top);
export class Chart extends Lines {
  /**
   * @param {string} name of its files
   * @param {{ tools?: Node, tall?: boolean, drag?: (x: number, y: number, settled: boolean) => unknown }} [options]
   */
  constructor(name, { tools, tall, drag } = {}) {
    super(block("plot"), name, drag);
    this.name = name;
    this.table = el("div", { class: "scroll", hidden: true, tabindex: 0 });
    this.asTable = button("Table", () => this.flip(), {
      "aria-pressed": false,
    });
    const save = (/** @type {"csv" | "svg" | "png"} */ kind) =>
      button(kind.toUpperCase(), () => this.save(kind));
    const bar = block(
      "row",
      tools ?? null,
      el("span", { class: "grow" }),
      menu(this.asTable, save("csv"), save("svg"), save("png")),
    );
    this.element = el(
      "section",
      {
        class: tall ? "chart tall" : "chart",
        "aria-label": name.replaceAll("-", " "),
      },
      bar,
      this.host,
      this.table,
    );
    const sized = new ResizeObserver(
      () => this.host.offsetWidth && this.draw(),
    );
    sized.observe(this.host);
    onTheme(() => this.draw());
    // An answer that comes after the page was left has nothing to draw on.
    atEnd(() => {
      sized.disconnect();
      this.element.remove();
    });
  }

  flip() {
    const on = this.asTable.getAttribute("aria-pressed") !== "true";
    this.asTable.ariaPressed = String(on);
    this.table.hidden = !on;
    this.host.hidden = on;
    if (on) this.tabulate();
    else this.draw();
  }

  /** @param {Spec} spec */
  show(spec) {
    this.spec = spec;
    if (!this.table.hidden) this.tabulate();
    this.draw();
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
    const more = (/** @type {Series} */ s, /** @type {number} */ i) =>
      third ? [s.z?.[i] ?? null] : [];
    const line = (/** @type {Series} */ s) =>
      s.x.map((x, i) => [s.name, x, s.y[i], ...more(s, i)]);
    return rows ?? series.filter((s) => !s.silent).flatMap(line);
  }

  tabulate() {
    const rows = this.rows().map((row) =>
      row.map((v) => (typeof v === "string" ? v : number(v))),
    );
    this.table.replaceChildren(
      table(this.head(), rows).firstElementChild ?? "",
    );
  }

  /** @param {"csv" | "svg" | "png"} kind */
  async save(kind) {
    if (!this.spec) return;
    const [width, height] = [
      Math.max(640, this.host.clientWidth),
      Math.max(400, this.host.clientHeight),
    ];
    const content =
      kind === "csv"
        ? csv([this.head(), ...this.rows()])
        : await this[kind](width, height);
    download(`${this.name}.${kind}`, content);
  }
}

/**
 * Points of an isobaric curve as a line of pull over contraction in %; it ends at the free contraction, wherever the
 * points lie.
 * @param {Commands["curve"]["answer"]["points"]} points
 */
export function isobar(points) {
  const slack = points.findIndex((q) => "force_n" in q && q.slack),
    last = points[slack];
  const free = last && "force_n" in last ? last.free_contraction : undefined;
  const taut = slack < 0 ? points : points.slice(0, slack),
    at = taut.map((q) => 100 * (q.contraction ?? NaN));
  const ends =
    slack > 0 && typeof free === "number" && 100 * free > at[slack - 1]
      ? [100 * free]
      : [];
  return {
    x: [...at, ...ends],
    y: [
      ...taut.map((q) => ("force_n" in q ? outside("force", q.force_n) : null)),
      ...ends.map(() => 0),
    ],
  };
}

/** What a muscle that is built pulls, where it is known. @param {Parameters<typeof builtPull>[0]} q */
export const builtAt = (q) => builtPull(q).map((n) => outside("force", n));
/**
 * A model's curve, and that of a muscle that is built: its median, dashed, in its interval, where it is known.
 * @param {Series} model @param {number[]} x @param {number[][]} list median, low and high at each
 * @returns {Series[]}
 */
export function withBuilt(model, x, list) {
  const known = x.map((_, i) => i).filter((i) => list[i].length),
    at = known.map((i) => x[i]);
  const [y, low, high] = [0, 1, 2].map((k) => known.map((i) => list[i][k]));
  if (!known.length) return [model];
  return [
    {
      name: "",
      colour: model.colour,
      band: true,
      silent: true,
      x: [...at, ...at.toReversed()],
      y: [...high, ...low.toReversed()],
    },
    model,
    {
      ...model,
      name: `${model.name} as built`,
      end: "",
      legend: "as built",
      dash: "dash",
      strong: false,
      x: at,
      y,
      low,
      high,
    },
  ];
}
/**
 * A model's isobar, and that of a muscle that is built.
 * @param {Omit<Series, "x" | "y">} of @param {CurveAnswer["points"]} points
 */
export const isobars = (of, points) =>
  withBuilt(
    { ...of, ...isobar(points) },
    points.map((q) => 100 * (q.contraction ?? NaN)),
    points.map(builtAt),
  );
