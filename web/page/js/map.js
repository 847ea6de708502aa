// Maps and surfaces by plotly.js, which is loaded when the first of them is shown.
import { el, token } from "./dom.js";

/**
 * `data`: traces of a map or surface.
 * @typedef {{ x: (number | null)[], y: (number | null)[], z?: (number | null)[][], text?: string[][], name?: string,
 *   type?: string, picture?: boolean, [more: string]: unknown }} Trace
 * @typedef {{ range?: number[] | null, rangemode?: string, title?: object }} Axis
 * @typedef {import("./plot.js").Curves & { data?: Trace[], z?: string, xaxis?: Axis, yaxis?: Axis,
 *   layout?: Record<string, unknown> }} Spec
 */
/**
 * What the page uses of the library.
 * @typedef {{ _offset: number, _length: number, d2p: (value: number) => number,
 *   p2d: (pixel: number) => number }} LibraryAxis
 * @typedef {{ react: Function, toImage: Function, purge: (host: HTMLElement) => void }} Library
 */
/** @type {Promise<Library> | undefined} */ let library;
/** The library, once. */
function plotly() {
  library ??= new Promise((resolve, reject) => {
    const script = el("script", { src: new URL("./plotly.js", import.meta.url).href });
    script.onload = () =>
      resolve(/** @type {Window & { Plotly?: Library }} */ (window).Plotly ?? /** @type {never} */ (undefined));
    script.onerror = () => {
      library = undefined;
      reject(new Error("The chart library could not be loaded."));
    };
    document.head.append(script);
  });
  return library;
}

export class PlotlyMap {
  /** @param {HTMLElement} host @param {((x: number, y: number, settled: boolean) => void) | undefined} drag */
  constructor(host, drag) {
    this.host = host;
    /** @type {Spec | undefined} */ this.spec = undefined;
    /** @type {Library | undefined} */ this.plotly = undefined;
    this.ends = new AbortController();
    host.replaceChildren(el("p", { class: "waiting" }, "Loading the chart …"));
    if (drag) this.listen(drag);
  }

  /** @param {Spec} spec */
  async draw(spec) {
    this.spec = spec;
    const Plotly = await plotly();
    if (this.ends.signal.aborted) return;
    if (!this.plotly) this.host.replaceChildren();
    this.plotly = Plotly;
    await Plotly.react(this.host, this.traces(), this.layout(), { displayModeBar: false, responsive: false });
    // The page was left while the library was drawing.
    if (this.ends.signal.aborted) Plotly.purge(this.host);
  }

  /** @returns {{ xaxis: LibraryAxis, yaxis: LibraryAxis } | undefined} */
  get axes() {
    const full = /** @type {HTMLElement & { _fullLayout?: { xaxis: LibraryAxis, yaxis: LibraryAxis } }} */ (this.host)
      ._fullLayout;
    return full?.xaxis ? full : undefined;
  }

  /** @param {number} x @param {number} y */
  place(x, y) {
    const { axes } = this;
    if (!axes) return undefined;
    const at = (/** @type {LibraryAxis} */ axis, /** @type {number} */ v) =>
      axis._offset + Math.max(0, Math.min(axis._length, axis.d2p(v)));
    return [at(axes.xaxis, x), at(axes.yaxis, y)];
  }

  /** @param {number} px @param {number} py */
  values(px, py) {
    const { axes } = this;
    return axes && [axes.xaxis.p2d(px - axes.xaxis._offset), axes.yaxis.p2d(py - axes.yaxis._offset)];
  }

  traces() {
    const spec = /** @type {Spec} */ (this.spec);
    const lines = spec.series.map((s) => ({
      x: s.x,
      y: s.y,
      name: s.name,
      mode: "lines",
      type: "scatter",
      showlegend: false,
      line: { color: s.colour, width: s.width ?? 1.5, dash: s.dash ?? "solid" },
      hoverinfo: "skip",
    }));
    const marks = (spec.marks ?? []).map((m) => ({
      x: [m.x],
      y: [m.y],
      mode: "markers",
      type: "scatter",
      showlegend: false,
      hovertemplate: `${m.text}<extra></extra>`,
      marker: { symbol: "circle-open", size: 12, color: token("--ink"), line: { width: 2 } },
    }));
    return [...(spec.data ?? []), ...lines, ...marks];
  }

  layout() {
    const spec = /** @type {Spec} */ (this.spec);
    const [ink, line, faint] = [token("--ink"), token("--line"), token("--faint")];
    const axis = (/** @type {string} */ title) => ({
      title: { text: title, standoff: 8 },
      gridcolor: faint,
      linecolor: line,
      zerolinecolor: line,
      tickcolor: line,
      automargin: true,
      color: ink,
      fixedrange: true,
      zeroline: false,
    });
    return {
      margin: { l: 48, r: 16, t: 12, b: 40 },
      paper_bgcolor: "rgba(0,0,0,0)",
      plot_bgcolor: "rgba(0,0,0,0)",
      font: { family: "system-ui, sans-serif", size: 13, color: ink },
      xaxis: { ...axis(spec.x), ...spec.xaxis },
      yaxis: { ...axis(spec.y), ...(spec.yaxis ?? { rangemode: "tozero" }) },
      hovermode: "closest",
      dragmode: false,
      height: this.host.clientHeight,
      width: this.host.clientWidth,
      ...spec.layout,
    };
  }

  /**
   * Drags and clicks in the plotting area as values of its axes.
   * @param {(x: number, y: number, settled: boolean) => void} drag
   */
  listen(drag) {
    let on = false;
    const { host } = this, { signal } = this.ends;
    const at = (/** @type {PointerEvent} */ event, /** @type {boolean} */ settled) => {
      const { axes } = this,
        box = host.getBoundingClientRect();
      if (axes)
        drag(
          axes.xaxis.p2d(event.clientX - box.left - axes.xaxis._offset),
          axes.yaxis.p2d(event.clientY - box.top - axes.yaxis._offset),
          settled,
        );
    };
    host.addEventListener(
      "pointerdown",
      (event) => {
        if (event.button === 0) {
          on = true;
          host.setPointerCapture(event.pointerId);
          at(event, false);
        }
      },
      { signal },
    );
    host.addEventListener("pointermove", (event) => on && at(event, false), { signal });
    host.addEventListener("pointerup", (event) => { if (on) at(event, true); on = false; }, { signal });
    host.addEventListener("pointercancel", () => { on = false; }, { signal });
    host.style.touchAction = "pan-y";
    host.style.cursor = "crosshair";
  }

  /** As an image's address. @param {"svg" | "png"} kind @param {{ width: number, height: number }} size */
  async picture(kind, size) {
    const layout = { ...this.layout(), paper_bgcolor: token("--paper"), plot_bgcolor: token("--paper") };
    return /** @type {Promise<string>} */ (
      (await plotly()).toImage(
        { data: this.traces(), layout },
        { format: kind, scale: kind === "png" ? 2 : 1, ...size },
      )
    );
  }

  destroy() {
    this.ends.abort();
    this.plotly?.purge(this.host);
    this.host.replaceChildren();
  }
}
