// A chart: lines and points by plotly.js, which is loaded when the first chart is shown; with a table, PNG, SVG and CSV.
import { download, el } from "./dom.js";
import { number, outside } from "./units.js";

/**
 * @typedef {{ name: string, x: number[], y: (number | null)[], end?: string, at?: "start" | "end", colour?: string, dash?: "solid" | "dash" | "dot", mode?: "lines" | "markers" | "lines+markers", width?: number, legend?: string, band?: boolean }} Series
 * @typedef {{ x: string, y: string, series: Series[], marks?: { x: number, y: number, text: string }[], data?: any[], z?: string, xaxis?: any, yaxis?: any, layout?: any }} Spec
 */

/** @type {Promise<any> | undefined} */ let library;
/** The chart library, once. */
function plotly() {
  library ??= new Promise((resolve, reject) => {
    const script = el("script", { src: new URL("./plotly.js", import.meta.url).href });
    script.onload = () => resolve(/** @type {any} */ (window).Plotly);
    script.onerror = () => { library = undefined; reject(new Error("The chart library could not be loaded.")); };
    document.head.append(script);
  });
  return library;
}

/** Okabe and Ito's colours, for what differs in kind; in the order of the figures of the command line. */
export const KINDS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#8a8a8a"];
const VIRIDIS = [[68, 1, 84], [71, 44, 122], [59, 81, 139], [44, 113, 142], [33, 144, 141], [39, 173, 129], [92, 200, 99], [170, 220, 50], [253, 231, 37]];
/** Viridis between 0 and 1; without its palest end, which a white page would swallow. @param {number} share */
export function viridis(share, most = 0.82) {
  const t = Math.min(1, Math.max(0, share)) * most * (VIRIDIS.length - 1);
  const [i, f] = [Math.min(VIRIDIS.length - 2, Math.floor(t)), t - Math.min(VIRIDIS.length - 2, Math.floor(t))];
  const c = VIRIDIS[i].map((a, k) => Math.round(a + f * (VIRIDIS[i + 1][k] - a)));
  return `rgb(${c.join(",")})`;
}
/** The colour of a pressure: the same in every chart of a page. @param {number} pressure @param {number} top */
export function pressureColour(pressure, top) {
  const dark = isDark();
  return dark ? viridis(0.25 + 0.75 * (pressure / top), 1) : viridis(pressure / top);
}
export const isDark = () => (document.documentElement.dataset.theme ? document.documentElement.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches);
/** @param {string} name */
export const token = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

export class Chart {
  /** @param {string} name of its files @param {{ tools?: Node, tall?: boolean, drag?: (x: number, y: number, settled: boolean) => void }} [options] */
  constructor(name, { tools, tall, drag } = {}) {
    this.name = name;
    /** @type {Spec | undefined} */ this.spec = undefined;
    this.plot = el("div", { class: "plot" }, el("p", { class: "waiting" }, "Loading the chart …"));
    this.table = el("div", { class: "scroll", hidden: true, tabindex: 0 });
    this.asTable = el("button", { type: "button", "aria-pressed": false, onclick: () => this.flip() }, "Table");
    const save = (/** @type {string} */ kind) => el("button", { type: "button", onclick: () => this.save(kind) }, kind.toUpperCase());
    const bar = el("div", { class: "row" }, tools ?? null, el("span", { class: "grow" }), this.asTable, save("csv"), save("svg"), save("png"));
    this.element = el("section", { class: tall ? "chart tall" : "chart", "aria-label": name.replaceAll("-", " ") }, bar, this.plot, this.table);
    this.drag = drag;
    this.ring = el("i", { class: "ring", hidden: true });
    /** @type {number[] | undefined} */ this.at = undefined;
    this.drawing = false;
    this.again = false;
    this.ready = false;
    /** What drawing took the last time, in milliseconds. */
    this.cost = 0;
    new ResizeObserver(() => this.ready && this.plot.offsetWidth && this.draw()).observe(this.plot);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.draw());
    document.addEventListener("theme", () => this.draw());
    if (drag) this.listen(drag);
  }

  /** A ring over the curves at values of the axes; none without. Nothing is drawn anew for it. @param {number} [x] @param {number} [y] */
  mark(x, y) {
    this.at = x === undefined || y === undefined ? undefined : [x, y];
    this.placeMark();
  }

  placeMark() {
    const full = /** @type {any} */ (this.plot)._fullLayout;
    this.ring.hidden = !this.at || !full?.xaxis;
    if (this.ring.hidden || !this.at) return;
    const place = (/** @type {any} */ axis, /** @type {number} */ v) => axis._offset + Math.max(0, Math.min(axis._length, axis.d2p(v)));
    this.ring.style.transform = `translate(${place(full.xaxis, this.at[0])}px, ${place(full.yaxis, this.at[1])}px)`;
    this.plot.append(this.ring);
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
    this.spec = spec;
    if (!this.table.hidden) this.tabulate();
    this.draw();
  }

  async draw() {
    if (!this.spec || this.plot.hidden) return;
    if (this.drawing) { this.again = true; return; }
    this.drawing = true;
    try {
      const Plotly = await plotly();
      if (!this.ready) this.plot.replaceChildren();
      this.ready = true;
      const began = performance.now();
      await Plotly.react(this.plot, this.traces(), this.layout(), { displayModeBar: false, responsive: false });
      this.cost = performance.now() - began;
      this.placeMark();
    } catch (error) {
      const retry = el("button", { type: "button", onclick: () => this.draw() }, "Try again");
      this.plot.replaceChildren(el("p", { class: "waiting" }, `${/** @type {Error} */ (error).message} The table shows the numbers. `, retry));
      this.ready = false;
    }
    this.drawing = false;
    if (this.again) { this.again = false; this.draw(); }
  }

  traces() {
    const spec = /** @type {Spec} */ (this.spec);
    const named = new Set();
    const lines = spec.series.map((s, i) => s.band ? {
      x: s.x, y: s.y, mode: "lines", type: "scatter", fill: "toself", fillcolor: s.colour, opacity: 0.14, line: { width: 0 }, showlegend: false, hoverinfo: "skip",
    } : ({
      x: s.x, y: s.y, name: s.name, mode: s.mode ?? "lines", type: "scatter", connectgaps: false,
      showlegend: Boolean(s.legend) && !named.has(s.legend) && Boolean(named.add(s.legend)),
      line: { color: s.colour ?? KINDS[i % KINDS.length], width: s.width ?? 1.5, dash: s.dash ?? "solid" },
      marker: { symbol: "circle-open", size: 7, color: s.colour ?? KINDS[i % KINDS.length] },
      hovertemplate: `%{x:.4g}, %{y:.4g}<extra>${s.name}</extra>`,
    }));
    const marks = (spec.marks ?? []).map((m) => ({
      x: [m.x], y: [m.y], mode: "markers", type: "scatter", showlegend: false, hovertemplate: `${m.text}<extra></extra>`,
      marker: { symbol: "circle-open", size: 12, color: token("--ink"), line: { width: 2 } },
    }));
    return [...(spec.data ?? []), ...lines, ...marks];
  }

  layout() {
    const spec = /** @type {Spec} */ (this.spec);
    const [ink, line, faint] = [token("--ink"), token("--line"), token("--faint")];
    const axis = (/** @type {string} */ title) => ({ title: { text: title, standoff: 8 }, gridcolor: faint, linecolor: line, zerolinecolor: line, tickcolor: line, automargin: true, color: ink, fixedrange: true, zeroline: false });
    // A label without a place would take the axis to where the library puts it.
    const known = (/** @type {Series} */ s, /** @type {number} */ i) => Number.isFinite(s.x[i]) && Number.isFinite(s.y[i]);
    const ends = spec.series.flatMap((s) => {
      const start = s.at === "start", places = s.x.map((_, i) => i), i = (start ? places : places.reverse()).find((i) => known(s, i));
      if (!s.end || i === undefined) return [];
      return [{ x: s.x[i], y: s.y[i], text: s.end, showarrow: false, xanchor: "left", yanchor: start ? "bottom" : "middle", xshift: start ? 10 : 4, font: { color: s.colour ?? ink, size: 12 } }];
    });
    const longest = Math.max(0, ...spec.series.map((s) => (s.at === "start" ? 0 : (s.end ?? "").length)));
    return {
      margin: { l: 48, r: 16 + 7 * longest, t: 12, b: 40 }, paper_bgcolor: "rgba(0,0,0,0)", plot_bgcolor: "rgba(0,0,0,0)",
      font: { family: "system-ui, sans-serif", size: 13, color: ink }, xaxis: { ...axis(spec.x), ...spec.xaxis }, yaxis: { ...axis(spec.y), ...(spec.yaxis ?? { rangemode: "tozero" }) },
      legend: { orientation: "h", y: 1, yanchor: "bottom", x: 0, font: { size: 12 } },
      annotations: apart(ends), hovermode: "closest", dragmode: false, height: this.plot.clientHeight, width: this.plot.clientWidth, ...spec.layout,
    };
  }

  /** Drags and clicks in the plotting area as values of its axes. @param {(x: number, y: number, settled: boolean) => void} drag */
  listen(drag) {
    let on = false;
    const at = (/** @type {PointerEvent} */ event, /** @type {boolean} */ settled) => {
      const full = /** @type {any} */ (this.plot)._fullLayout;
      if (!full?.xaxis) return;
      const box = this.plot.getBoundingClientRect();
      drag(full.xaxis.p2d(event.clientX - box.left - full.xaxis._offset), full.yaxis.p2d(event.clientY - box.top - full.yaxis._offset), settled);
    };
    this.plot.addEventListener("pointerdown", (event) => { if (event.button === 0) { on = true; this.plot.setPointerCapture(event.pointerId); at(event, false); } });
    this.plot.addEventListener("pointermove", (event) => on && at(event, false));
    this.plot.addEventListener("pointerup", (event) => { if (on) at(event, true); on = false; });
    this.plot.addEventListener("pointercancel", () => { on = false; });
    this.plot.style.touchAction = "pan-y";
    this.plot.style.cursor = "crosshair";
  }

  /** What the columns of the table are. */
  head() {
    const spec = /** @type {Spec} */ (this.spec);
    return ["curve", spec.x, spec.y, ...(spec.z ? [spec.z] : [])];
  }

  /** Rows of all series: name, x, y; of maps and surfaces also what they show there. @returns {(string | number | null)[][]} */
  rows() {
    const lines = (this.spec?.series ?? []).flatMap((s) => s.x.map((x, i) => [s.name, x, s.y[i]]));
    const maps = (this.spec?.data ?? []).flatMap((d) => (d.type === "scatter" ? d.x.map((/** @type {number} */ x, /** @type {number} */ i) => [d.name, x, d.y[i], d.marker.color[i]])
      : d.y.flatMap((/** @type {number} */ y, /** @type {number} */ j) => d.x.flatMap((/** @type {number} */ x, /** @type {number} */ i) => (d.z[j][i] === null ? [] : [[d.name, x, y, d.text ? d.text[j][i] : d.z[j][i]]])))));
    return [...lines, ...maps];
  }

  tabulate() {
    const head = el("tr", {}, ...this.head().map((text, i) => el("th", { class: i ? undefined : "text", scope: "col" }, text)));
    const body = this.rows().map((row) => el("tr", {}, ...row.map((v, i) => el("td", { class: i ? undefined : "text" }, typeof v === "string" ? v : number(v)))));
    this.table.replaceChildren(el("table", {}, el("thead", {}, head), el("tbody", {}, ...body)));
  }

  /** @param {string} kind */
  async save(kind) {
    if (!this.spec) return;
    if (kind === "csv") {
      const quoted = (/** @type {any} */ v) => (typeof v === "string" && /[",\n]/.test(v) ? `"${v.replaceAll('"', '""')}"` : v ?? "");
      const lines = [this.head(), ...this.rows()].map((row) => row.map(quoted).join(","));
      return download(`${this.name}.csv`, lines.join("\n") + "\n", "text/csv");
    }
    const Plotly = await plotly();
    const size = { width: Math.max(640, this.plot.clientWidth), height: Math.max(400, this.plot.clientHeight) };
    const layout = { ...this.layout(), paper_bgcolor: token("--paper"), plot_bgcolor: token("--paper") };
    const url = await Plotly.toImage({ data: this.traces(), layout }, { format: kind, scale: kind === "png" ? 2 : 1, ...size });
    el("a", { href: url, download: `${this.name}.${kind}` }).click();
  }
}

/** Points of an isobaric curve as a line of pull over contraction in %; it ends at the free contraction, wherever the points lie. @param {any[]} points */
export function isobar(points) {
  const slack = points.findIndex((q) => q.slack), free = points[slack]?.free_contraction;
  const taut = slack < 0 ? points : points.slice(0, slack);
  const ends = slack > 0 && typeof free === "number" && free > taut[slack - 1].contraction ? [100 * free] : [];
  return {
    x: [...taut.map((q) => 100 * q.contraction), ...ends],
    y: [...taut.map((q) => (q.status === "ok" ? outside("force", q.force_n) : null)), ...ends.map(() => 0)],
  };
}

/** Labels at the ends of curves, moved apart where they would lie on one another; plotly's shifts are in pixels. @param {any[]} ends */
function apart(ends) {
  const sorted = [...ends].sort((a, b) => a.y - b.y);
  const reach = Math.max(1e-12, ...sorted.map((e) => Math.abs(e.y)));
  // About 250 pixels for the reach of the axis.
  let before = -Infinity;
  for (const end of sorted) {
    const place = (250 * end.y) / reach;
    const moved = Math.max(place, before + 14);
    end.yshift = moved - place;
    before = moved;
  }
  return ends;
}
