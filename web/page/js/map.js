// A field over two axes as a picture below curves: painted on a canvas, with lines of equal values
// and what they are.
import { el } from "./dom.js";
import { ticks } from "./plot.js";
import { evenly, number } from "./units.js";

/**
 * A field on a grid; `null` where it has no value.
 * @typedef {{ x: number[], y: number[], values: (number | null)[][] }} Field
 */

/**
 * The corners of the cell of a place, with their shares: below left and right, above left and
 * right.
 * @param {number[]} x @param {number[]} y @param {number} px @param {number} py
 * @returns {[i: number, j: number, share: number][]}
 */
export function corners(x, y, px, py) {
  const place = (/** @type {number[]} */ list, /** @type {number} */ v) => {
    let i = 0;
    while (i < list.length - 2 && list[i + 1] <= v) i++;
    return { i, t: (v - list[i]) / (list[i + 1] - list[i]) };
  };
  const { i, t } = place(x, px),
    { i: j, t: s } = place(y, py);
  return [
    [i, j, (1 - t) * (1 - s)],
    [i + 1, j, t * (1 - s)],
    [i, j + 1, (1 - t) * s],
    [i + 1, j + 1, t * s],
  ];
}

/** Between the values of a grid. @param {Field} field @param {number} px @param {number} py */
export function valueBetween({ x, y, values }, px, py) {
  const sum = corners(x, y, px, py).reduce(
    (all, [i, j, share]) => all + share * (values[j][i] ?? NaN),
    0,
  );
  return Number.isFinite(sum) ? sum : null;
}

/**
 * The same on a grid that is so much finer.
 * @param {number[]} x @param {number[]} y @param {number} by
 * @param {(x: number, y: number) => number | null} at
 * @returns {Field}
 */
export function sampled(x, y, by, at) {
  const finer = (/** @type {number[]} */ list) =>
    evenly(list[0], list[list.length - 1], (list.length - 1) * by + 1);
  const [fx, fy] = [finer(x), finer(y)];
  return { x: fx, y: fy, values: fy.map((py) => fx.map((px) => at(px, py))) };
}

/**
 * A pixel for each place of a field.
 * @param {Field} field
 * @param {(value: number | null, x: number, y: number) => number[]} colour red, green, blue and
 *   opacity up to 255
 * @returns {Picture}
 */
export function picture({ x, y, values }, colour) {
  const [width, height] = [x.length, y.length],
    canvas = el("canvas", { width, height });
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  const pixels = context.createImageData(width, height);
  values.forEach((row, j) =>
    row.forEach((value, i) =>
      pixels.data.set(colour(value, x[i], y[j]), 4 * ((height - 1 - j) * width + i)),
    ),
  );
  context.putImageData(pixels, 0, 0);
  // The middle of a pixel is where its value is.
  const ends = (/** @type {number[]} */ list) => {
    const [first, last] = [list[0], list[list.length - 1]],
      half = (last - first) / (list.length - 1) / 2;
    return /** @type {[number, number]} */ ([first - half, last + half]);
  };
  return { href: canvas.toDataURL(), x: ends(x), y: ends(y) };
}

/** Pieces of the line of a value. @param {Field} field @param {number} level */
function levelLine({ x, y, values }, level) {
  const out = /** @type {Segment[]} */ ([]);
  for (let j = 0; j + 1 < y.length; j++) {
    for (let i = 0; i + 1 < x.length; i++) {
      const around = [
          [i, j],
          [i + 1, j],
          [i + 1, j + 1],
          [i, j + 1],
        ],
        v = around.map(([a, b]) => values[b][a]);
      if (v.includes(null)) continue;
      const points = around.flatMap(([a, b], k) => {
        const [c, d] = around[(k + 1) % 4],
          [from, to] = [Number(v[k]), Number(v[(k + 1) % 4])];
        if (from > level === to > level) return [];
        const t = (level - from) / (to - from);
        return [[x[a] + t * (x[c] - x[a]), y[b] + t * (y[d] - y[b])]];
      });
      for (let k = 0; k + 1 < points.length; k += 2)
        out.push([points[k][0], points[k][1], points[k + 1][0], points[k + 1][1]]);
    }
  }
  return out;
}

/**
 * Pieces of lines as a curve that nobody reads off.
 * @param {Segment[]} list @param {object} look
 */
export const pieces = (list, look) =>
  /** @type {Series} */ ({
    name: "",
    silent: true,
    x: list.flatMap(([a, , b]) => [a, b, b]),
    y: list.flatMap(([, a, , b]) => [a, b, null]),
    ...look,
  });

/** An axis from the first to the last of a list. @param {number[]} list @returns {Axis} */
export const whole = (list) => ({ range: [list[0], list[list.length - 1]] });

/** The least and the largest of what is known. @param {(number | null)[][]} values */
export function span(values) {
  const known = values.flat().filter((v) => v !== null);
  return /** @type {[number, number]} */ ([Math.min(...known), Math.max(...known)]);
}

/**
 * Lines of equal values at round ones, and their names in the middle of each.
 * @param {Field} field @param {string} unit
 */
export function levels(field, unit) {
  const all = ticks(span(field.values), 7).map(({ value }) => ({
    value,
    list: levelLine(field, value),
  }));
  // Not where they would lie on the axis.
  const [least, most] = [0.07, 0.93].map(
    (share) => field.x[Math.round(share * (field.x.length - 1))],
  );
  const notes = all.flatMap(({ value, list }) => {
    const free = list.filter(([x]) => x > least && x < most),
      [x, y] = free[Math.floor(free.length / 2)] ?? [];
    return free.length > 8 ? [{ x, y, text: `${number(value, 3)} ${unit}` }] : [];
  });
  return {
    series: [
      pieces(
        all.flatMap(({ list }) => list),
        { colour: "#333", width: 1 },
      ),
    ],
    notes,
  };
}
