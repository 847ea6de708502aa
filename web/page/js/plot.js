// Spec and points as SVG: the same drawing on the page and in files. Nothing here asks the document
// anything.
import { svg } from "./svg.js";
import { clamp, niceUp, number } from "./units.js";

/**
 * Okabe and Ito's colours, for what differs in kind; in the order of the figures of the command
 * line.
 */
export const KINDS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#8a8a8a"];
const DASHES = { solid: undefined, dash: "7 4", dot: "2 3" };
/**
 * Signs of points, from their middle: of no branch, of a muscle that shortens, and that lengthens.
 */
const GLYPHS = {
  mean: "m-3.2 0a3.2 3.2 0 1 0 6.4 0a3.2 3.2 0 1 0-6.4 0",
  contraction: "m-4-3h8l-4 7z",
  elongation: "m-4 3h8l-4-7z",
};
const FONT = 12.5,
  GLYPH = 6.8;

/** @typedef {{ ink: string, line: string, faint: string, paper: string }} Colours */
const finite = (/** @type {number | null | undefined} */ v) =>
  typeof v === "number" && Number.isFinite(v);
const escaped = (/** @type {string} */ text) =>
  text.replace(
    /[&<>"]/g,
    (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c] ?? c,
  );
const short = (/** @type {number} */ v) => v.toFixed(1);
/** @param {Series} s @param {number} i */
export const colourOf = (s, i) => s.colour ?? KINDS[i % KINDS.length];

/** What the axes have to show of the curves. @param {Spec} spec @returns {Reach} */
export function reachOf(spec) {
  const [x, y] = [
    [Infinity, -Infinity],
    [Infinity, -Infinity],
  ];
  const take = (/** @type {number[]} */ r, /** @type {number} */ v) => {
    r[0] = Math.min(r[0], v);
    r[1] = Math.max(r[1], v);
  };
  let points = false;
  for (const s of spec.series) {
    points ||= s.mode === "markers";
    s.x.forEach((v, i) => {
      const value = s.y[i];
      if (!finite(v) || !finite(value)) return;
      take(x, v);
      take(y, /** @type {number} */ (value));
    });
  }
  for (const m of spec.marks ?? []) {
    take(x, m.x);
    take(y, m.y);
  }
  return {
    x: axisReach(x, spec.xaxis ?? {}, points ? 0.03 : 0),
    y: axisReach(y, spec.yaxis ?? { rangemode: "tozero" }, 0.05),
  };
}

/** @param {number[]} found @param {Axis} axis @param {number} spare @returns {[number, number]} */
function axisReach(found, axis, spare) {
  if (axis.range) return [axis.range[0], axis.range[1]];
  let [low, high] = found[0] <= found[1] ? found : [0, 1];
  const zero = axis.rangemode === "tozero";
  if (zero) {
    low = Math.min(0, low);
    high = Math.max(0, high);
  }
  const wide = high - low || Math.abs(high) || 1;
  if (high === low) return [low - 0.5 * wide, high + 0.5 * wide];
  return [zero && low === 0 ? 0 : low - spare * wide, zero && high === 0 ? 0 : high + spare * wide];
}

/** Round values between two others. @param {[number, number]} reach @param {number} most */
function ticks([low, high], most) {
  const step = niceUp((high - low) / Math.max(1, most)),
    first = Math.ceil(low / step - 1e-9),
    count = Math.floor(high / step + 1e-9) - first + 1;
  const values = Array.from({ length: clamp(count, 0, 50) }, (_, i) =>
    Number(((first + i) * step).toPrecision(12)),
  );
  return values.map((value) => ({
    value,
    text: number(
      value,
      Math.max(3, Math.ceil(Math.log10(Math.max(1, Math.abs(value) / step)) + 2)),
    ),
  }));
}

/**
 * Where the axes lie, and values to pixels and back.
 * @param {Spec} spec @param {number} width @param {number} height @param {Reach} reach
 */
export function frame(spec, width, height, reach) {
  const longest = Math.max(
    0,
    ...spec.series.map((s) => (s.at === "start" ? 0 : (s.end ?? "").length)),
  );
  const across = ticks(reach.y, Math.max(2, height / 60));
  const left = 30 + GLYPH * Math.max(2, ...across.map((t) => t.text.length));
  const named = legends(spec, left, width),
    top = named.length ? named[named.length - 1].y + 12 : 12,
    bottom = 40;
  const right = Math.min(0.4 * width, 20 + 1.06 * GLYPH * longest);
  const [w, h] = [Math.max(20, width - left - right), Math.max(20, height - top - bottom)];
  const [fx, fy] = [w / (reach.x[1] - reach.x[0]), h / (reach.y[1] - reach.y[0])];
  return {
    width,
    height,
    left,
    top,
    w,
    h,
    reach,
    across,
    named,
    along: ticks(reach.x, Math.max(2, w / 80)),
    px: (/** @type {number} */ v) => left + (v - reach.x[0]) * fx,
    py: (/** @type {number} */ v) => top + h - (v - reach.y[0]) * fy,
    x: (/** @type {number} */ p) => reach.x[0] + (p - left) / fx,
    y: (/** @type {number} */ p) => reach.y[0] + (top + h - p) / fy,
  };
}
/** @typedef {ReturnType<typeof frame>} Frame */

/**
 * Each name of the legend once, with the curve that it is first said of, and its place: in as many
 * lines as it takes.
 * @param {Spec} spec @param {number} left @param {number} width
 */
function legends(spec, left, width) {
  /** @type {Map<string, number>} */
  const found = new Map();
  spec.series.forEach((s, i) => {
    if (s.legend && !found.has(s.legend)) found.set(s.legend, i);
  });
  let [x, y] = [left, 16];
  return [...found].map(([text, i]) => {
    const long = 40 + GLYPH * text.length;
    if (x > left && x + long > width) [x, y] = [left, y + 18];
    x += long;
    return { text, i, x: x - long, y };
  });
}

const MIDDLE = { "text-anchor": "middle" };
/**
 * @param {number} x @param {number} y @param {string} text
 * @param {Record<string, string | number>} [more] attributes
 */
const words = (x, y, text, more = {}) =>
  svg("text", { x: short(x), y: short(y), ...more }, escaped(text));
/** Words on curves stand on paper. @param {Colours} colours @param {string} [fill] */
const onPaper = ({ ink, paper }, fill = ink) => ({
  fill,
  stroke: paper,
  "stroke-width": 3,
  "paint-order": "stroke",
});

/**
 * The whole drawing.
 * @param {Spec} spec @param {Frame} at @param {Colours} colours
 * @param {boolean} [file] as a file of its own
 */
export function drawing(spec, at, colours, file = false) {
  const { width, height, left, top, w, h, px, py } = at,
    box = [left - 4, top - 4, w + 8, h + 8];
  // Bands lie below.
  const inner = [true, false].flatMap((below) =>
    spec.series.map((s, i) => (Boolean(s.band) === below ? curve(s, i, at) : "")),
  );
  const marks = (spec.marks ?? []).map((m) =>
    svg(
      "circle",
      {
        cx: short(px(m.x)),
        cy: short(py(m.y)),
        r: 6,
        fill: "none",
        stroke: colours.ink,
        "stroke-width": 2,
      },
      svg("title", {}, escaped(m.text)),
    ),
  );
  const viewBox = box.join(" ");
  return svg(
    "svg",
    {
      xmlns: "http://www.w3.org/2000/svg",
      class: "curves",
      width,
      height,
      viewBox: `0 0 ${width} ${height}`,
      "font-family": "system-ui, sans-serif",
      "font-size": FONT,
      fill: colours.ink,
      color: colours.ink,
      "aria-hidden": file ? undefined : "true",
    },
    file ? svg("rect", { width, height, fill: colours.paper }) : "",
    ...axes(spec, at, colours),
    svg(
      "svg",
      { x: box[0], y: box[1], width: box[2], height: box[3], viewBox, overflow: "hidden" },
      ...inner,
    ),
    ...marks,
    ...labels(spec, at, colours),
    ...legend(spec, at),
  );
}

/** @param {Spec} spec @param {Frame} at @param {Colours} colours */
function axes(spec, { left, top, w, h, along, across, px, py }, { line, faint }) {
  const bottom = top + h,
    rule = (/** @type {string} */ d, stroke = faint) => svg("path", { d, stroke, fill: "none" });
  return [
    ...along.flatMap(({ value, text }) => [
      rule(`M${short(px(value))} ${top}V${bottom}`),
      words(px(value), bottom + 17, text, MIDDLE),
    ]),
    ...across.flatMap(({ value, text }) => [
      rule(`M${left} ${short(py(value))}h${w}`),
      words(left - 6, py(value) + 4, text, { "text-anchor": "end" }),
    ]),
    rule(`M${left} ${top}V${bottom}H${left + w}`, line),
    words(left + w / 2, bottom + 34, spec.x, MIDDLE),
    words(0, 0, spec.y, { ...MIDDLE, transform: `translate(12 ${top + h / 2}) rotate(-90)` }),
  ];
}

/**
 * Lists of neighbouring points that have a value.
 * @param {Series} s @param {(i: number) => boolean} [has]
 */
function runs(s, has = () => true) {
  /** @type {number[][]} */ const out = [[]];
  s.x.forEach((x, i) => {
    if (finite(x) && finite(s.y[i]) && has(i)) out[out.length - 1].push(i);
    else if (out[out.length - 1].length) out.push([]);
  });
  return out.filter((run) => run.length);
}

/** Places of the points of a series. @param {Series} s @param {Frame} at */
const placed =
  (s, { px, py }) =>
  (/** @type {number} */ i) =>
    `${short(px(s.x[i]))} ${short(py(Number(s.y[i])))}`;

/** @param {Series} s @param {number} which @param {Frame} at */
function curve(s, which, at) {
  const place = placed(s, at),
    colour = colourOf(s, which),
    all = runs(s),
    lines = all.map((run) => `M${run.map((i) => place(i)).join("L")}`);
  if (s.band) return svg("path", { d: `${lines.join("Z")}Z`, fill: colour, "fill-opacity": 0.14 });
  const look = { fill: "none", stroke: colour };
  if (s.mode === "markers") {
    const d = all.flat().map((i) => `M${place(i)}${GLYPHS[s.glyph ?? "mean"]}`);
    return svg("path", { d: d.join(""), ...look, "stroke-width": 1.4 });
  }
  return svg("path", {
    d: lines.join(""),
    ...look,
    "stroke-width": s.strong ? 3 : 1.75,
    "stroke-linejoin": "round",
    "stroke-dasharray": DASHES[s.dash ?? "solid"],
  });
}

/**
 * Names at the ends of curves, moved apart where they would lie on one another.
 * @param {Spec} spec @param {Frame} at @param {Colours} colours
 */
function labels(spec, { px, py, left, top, w, h, reach }, colours) {
  const ends = spec.series.flatMap((s, k) => {
    const start = s.at === "start",
      seen = runs(s, (i) => s.x[i] >= reach.x[0] && s.x[i] <= reach.x[1]).flat();
    const i = start ? seen[0] : seen[seen.length - 1],
      y = py(Number(s.y[i]));
    if (!s.end || i === undefined || y < top - 20 || y > top + h + 20) return [];
    return [
      {
        x: start ? px(s.x[i]) + 8 : Math.min(px(s.x[i]), left + w) + 5,
        y: start ? y - 4 : y + 4,
        text: s.end,
        strong: s.strong,
        colour: s.colour && colourOf(s, k),
      },
    ];
  });
  let below = top + h + 6;
  for (const end of [...ends].sort((a, b) => b.y - a.y)) {
    end.y = Math.min(end.y, below);
    below = end.y - 14;
  }
  return ends.map(({ x, y, text, strong, colour }) =>
    words(x, y, text, { ...onPaper(colours, colour), ...(strong ? { "font-weight": 600 } : {}) }),
  );
}

/** @param {Spec} spec @param {Frame} at */
const legend = (spec, { named }) =>
  named.flatMap(({ text, i, x, y }) => {
    const s = spec.series[i],
      d =
        s.mode === "markers"
          ? `M${x + 10} ${y - 4}${GLYPHS[s.glyph ?? "mean"]}`
          : `M${x} ${y - 4}h20`;
    return [
      svg("path", {
        d,
        fill: "none",
        stroke: colourOf(s, i),
        "stroke-width": 1.75,
        "stroke-dasharray": DASHES[s.dash ?? "solid"],
      }),
      words(x + 25, y, text),
    ];
  });

/**
 * Slopes of a cubic through points that rises and falls with them (Steffen 1990).
 * @param {number[]} x @param {number[]} y
 */
function slopes(x, y) {
  const h = x.slice(1).map((v, i) => v - x[i]),
    d = h.map((w, i) => (y[i + 1] - y[i]) / w),
    last = d.length;
  const m = x.map((_, i) => {
    const [a, b] = [d[i - 1], d[i]],
      p = (a * h[i] + b * h[i - 1]) / (h[i - 1] + h[i]);
    return (Math.sign(a) + Math.sign(b)) * Math.min(Math.abs(a), Math.abs(b), 0.5 * Math.abs(p));
  });
  m[0] = last > 1 ? (3 * d[0] - m[1]) / 2 : d[0];
  m[last] = last > 1 ? (3 * d[last - 1] - m[last - 1]) / 2 : d[0];
  return m;
}

/** Points between two of a smooth curve. */
const FINE = 4;
/**
 * A smooth curve by its cubic, with points that lie closer; any other, and one with an interval, as
 * it is. @param {Series} s
 */
export function smoothed(s) {
  if (!s.smooth || s.low) return s;
  /** @type {number[]} */ const x = [],
    /** @type {(number | null)[]} */ y = [];
  for (const run of runs(s)) {
    const [u, v] = [run.map((i) => s.x[i]), run.map((i) => Number(s.y[i]))],
      m = slopes(u, v);
    for (let i = 1; i < run.length; i++)
      for (let k = 0; k < FINE; k++) {
        const t = k / FINE,
          back = 1 - t,
          h = u[i] - u[i - 1];
        x.push(u[i - 1] + t * h);
        y.push(
          v[i - 1] * back * back * (1 + 2 * t) +
            m[i - 1] * h * t * back * back +
            v[i] * t * t * (3 - 2 * t) -
            m[i] * h * t * t * back,
        );
      }
    x.push(u[u.length - 1], NaN);
    y.push(v[v.length - 1], null);
  }
  return { ...s, x, y };
}

/**
 * A curve at a value of the lower axis, on the line between its points.
 * @param {{ x: number[], y: (number | null)[] }} s @param {number} x
 */
export function valueAt(s, x) {
  for (let i = 1; i < s.x.length; i++) {
    const [a, b, ya, yb] = [s.x[i - 1], s.x[i], s.y[i - 1], s.y[i]];
    if (ya == null || yb == null || a === b || Math.min(a, b) > x || Math.max(a, b) < x) continue;
    return ya + ((x - a) / (b - a)) * (yb - ya);
  }
  return undefined;
}

/**
 * What is nearest to a place in pixels: a point of a marked series, or a place on a curve.
 * @param {Spec} spec @param {Frame} at @param {number} x @param {number} y
 */
export function nearest(spec, at, x, y) {
  /** @type {(Found & { far: number }) | undefined} */ let best;
  const take = (
    /** @type {number} */ which,
    /** @type {number} */ vx,
    /** @type {number} */ vy,
    more = 0,
  ) => {
    const far = Math.hypot(at.px(vx) - x, at.py(vy) - y) + more;
    if (!best || far < best.far) best = { far, which, x: vx, y: vy };
  };
  const value = at.x(x);
  spec.series.forEach((s, which) => {
    if (s.band) return;
    if (s.mode === "markers")
      s.x.forEach((vx, i) => {
        const vy = s.y[i];
        if (finite(vx) && typeof vy === "number") take(which, vx, vy);
      });
    const on = s.mode === "markers" ? undefined : valueAt(s, value);
    // Points come first where a curve runs through them.
    if (on !== undefined) take(which, value, on, 4);
  });
  return best;
}
