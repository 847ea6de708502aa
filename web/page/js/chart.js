// A chart: curves over a picture or none, as SVG (lines.js); with a table, PNG, SVG and CSV.
import { csv } from "./columns.js";
import { block, button, download, el, menu, table } from "./dom.js";
import { linesOf } from "./lines.js";
import { KINDS } from "./plot.js";
import { VIRIDIS } from "./shaders.js";
import { isDark } from "./theme.js";
import { builtPull, clamp, number, outside } from "./units.js";
import { atEnd, signal, watch } from "./watch.js";

export { KINDS };

/**
 * Viridis between 0 and 1 as red, green and blue.
 * @param {number} share @param {number} most of the map
 */
function viridisAt(share, most) {
  const t = clamp(share, 0, 1) * most * (VIRIDIS.length - 1);
  const i = Math.min(VIRIDIS.length - 2, Math.floor(t));
  return VIRIDIS[i].map((a, k) => Math.round(a + (t - i) * (VIRIDIS[i + 1][k] - a)));
}
/** Without its palest end, which a white page would swallow. @param {number} share */
export const viridis = (share, most = 0.82) => `rgb(${viridisAt(share, most).join(",")})`;
/** The colour of a share, of a pressure that of its highest one: the same in every chart. @param {number} share */
export const shade = (share) => (isDark() ? viridis(0.3 + 0.7 * share, 1) : viridis(share));
/** @typedef {ReturnType<typeof chartOf>} Chart */
/**
 * @param {string} name of its files
 * @param {{ tools?: Node, drag?: (x: number, y: number, settled: boolean) =>
 * unknown }} [options]
 */
export function chartOf(name, { tools, drag } = {}) {
  /** @type {Signal<Spec | undefined>} */ const spec = signal(),
    lines = linesOf(name, drag),
    { host } = lines,
    cells = el("div", { class: "scroll", hidden: true, tabindex: 0 });
  const asTable = button("Table", flip, { ariaPressed: false });
  const saved = /** @type {const} */ (["csv", "svg", "png"]).map((kind) =>
    button(kind.toUpperCase(), () => save(kind)),
  );
  const element = el(
    "section",
    { class: "chart", ariaLabel: name.replaceAll("-", " ") },
    block("row", tools ?? null, el("span", { class: "grow" }), menu(asTable, ...saved)),
    host,
    cells,
  );
  const sized = new ResizeObserver(() => host.offsetWidth && lines.draw());
  sized.observe(host);
  watch(() => {
    if (!spec.value) return;
    lines.spec = spec.value;
    if (!cells.hidden) tabulate(spec.value);
    lines.draw();
  });
  // An answer that comes after the page was left has nothing to draw on.
  atEnd(() => {
    sized.disconnect();
    element.remove();
  });

  function flip() {
    const on = cells.hidden;
    asTable.ariaPressed = String(on);
    cells.hidden = !on;
    host.hidden = on;
    if (on && spec.value) tabulate(spec.value);
    else lines.draw();
  }

  /** What the columns of the table are. @param {Spec} spec */
  const head = ({ x, y }) => ["curve", x, y];
  /** Rows of all series: name, x, y. @param {Spec} spec */
  const rowsOf = ({ series }) =>
    series.filter((s) => s.name).flatMap((s) => s.x.map((x, i) => [s.name, x, s.y[i]]));

  /** @param {Spec} spec */
  function tabulate(spec) {
    const rows = rowsOf(spec).map((row) => row.map((v) => (typeof v === "string" ? v : number(v))));
    cells.replaceChildren(table(head(spec), rows).firstElementChild ?? "");
  }

  /** @param {"csv" | "svg" | "png"} kind */
  async function save(kind) {
    if (!spec.value) return;
    const content =
      kind === "csv"
        ? csv([head(spec.value), ...rowsOf(spec.value)])
        : await lines[kind](Math.max(640, host.clientWidth), Math.max(400, host.clientHeight));
    download(`${name}.${kind}`, content);
  }
  return {
    element,
    mark: lines.mark,
    get spec() {
      return spec.value;
    },
    /** @param {Spec} next */
    show(next) {
      spec.value = next;
    },
  };
}

/**
 * Points of an isobaric curve as a line of pull over contraction in %; it ends at the free
 * contraction, wherever the points lie.
 * @param {Commands["curve"]["answer"]["points"]} points
 */
export function isobar(points) {
  const slack = points.findIndex((q) => "force_n" in q && q.slack),
    last = points[slack];
  const free = last && "force_n" in last ? last.free_contraction : undefined;
  const taut = slack < 0 ? points : points.slice(0, slack),
    at = taut.map((q) => 100 * (q.contraction ?? NaN));
  const ends =
    slack > 0 && typeof free === "number" && 100 * free > at[slack - 1] ? [100 * free] : [];
  return {
    x: [...at, ...ends],
    y: [
      ...taut.map((q) => ("force_n" in q ? outside("force", q.force_n) : null)),
      ...ends.map(() => 0),
    ],
  };
}

/**
 * What a muscle that is built pulls, where it is known. @param {Parameters<typeof builtPull>[0]} q
 */
export const builtAt = (q) => builtPull(q).map((n) => outside("force", n));
/**
 * A model's curve, and that of a muscle that is built: its median, dashed, in its interval, where
 * it is known.
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
