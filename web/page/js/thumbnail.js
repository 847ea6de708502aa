// A small picture of a muscle: tube, braid and ends in proportion, from its measures alone.
import { el } from "./dom.js";

/** @typedef {{ outer_diameter_mm: number, wall_mm: number, length_mm: number, angle_deg?: number | null }} Measures */
const SVG = "http://www.w3.org/2000/svg";
const WIDTH = 96, HEIGHT = 40;

/**
 * Lengths in the picture: by their logarithms, so that a muscle of 2 mm and one of 80 mm can both be seen.
 * @param {Measures} of
 */
function proportions({ outer_diameter_mm: D, wall_mm: s, length_mm: L }) {
  const long = Math.min(78, Math.max(24, 30 + 20 * Math.log2(L / 100))),
    high = Math.min(34, Math.max(5, 5 + 5.2 * Math.log2(D / 2)));
  return { long, high, wall: Math.max(0.8, Math.min(high / 2 - 1, (high * s) / D)) };
}

/**
 * The strands of one family across the tube.
 * @param {number} x
 * @param {number} long
 * @param {number} high
 * @param {number} slope
 */
function strands(x, long, high, slope) {
  const y = (HEIGHT - high) / 2, rise = high / Math.abs(slope), step = Math.max(4, Math.min(rise * 0.6, high * 0.32)),
    out = [];
  for (let at = x - rise; at < x + long; at += step) {
    const [from, to] = [Math.max(x, at), Math.min(x + long, at + rise)];
    const height = (
      /** @type {number} */ here,
    ) => (slope > 0 ? y + (here - at) * slope : y + high + (here - at) * slope);
    if (to > from) out.push(`M${from.toFixed(1)} ${height(from).toFixed(1)}L${to.toFixed(1)} ${height(to).toFixed(1)}`);
  }
  return out.join("");
}

/** @param {Measures} of @returns {string} the inside of an SVG of 96 by 40 */
function drawing(of) {
  const { long, high, wall } = proportions(of), x = (WIDTH - long) / 2, y = (HEIGHT - high) / 2;
  const slope = Math.tan((Math.min(70, Math.max(8, of.angle_deg ?? 28)) * Math.PI) / 180);
  const plug = (/** @type {number} */ at) =>
    `<rect x="${at}" y="${y - 1}" width="6" height="${high + 2}" rx="1" class="plug"/>`;
  return `<rect x="${x}" y="${y}" width="${long}" height="${high}" class="tube"/>`
    + `<rect x="${x}" y="${y + wall}" width="${long}" height="${Math.max(1, high - 2 * wall)}" class="bore"/>`
    + `<path d="${strands(x, long, high, slope)}${strands(x, long, high, -slope)}" class="strands"/>`
    + `${plug(x - 3)}${plug(x + long - 3)}<path d="M${x - 9} ${HEIGHT / 2}h6M${x + long + 3} ${
      HEIGHT / 2
    }h6" class="port"/>`;
}

/**
 * What a muscle of the gallery is besides a muscle: two of them on a pulley, or measured points over it.
 * @type {Record<string, string>}
 */
const BESIDE = {
  joint: '<circle cx="78" cy="20" r="9" class="port"/><path d="M78 20 92 8" class="arm"/>'
    + '<path d="M10 11h58M10 29h58" class="rope"/>',
  data: '<path d="M8 35 30 24 52 16 88 8" class="fit"/><g class="points"><circle cx="14" cy="34" r="2.2"/>'
    + '<circle cx="32" cy="21" r="2.2"/><circle cx="50" cy="18.5" r="2.2"/><circle cx="68" cy="11" r="2.2"/>'
    + '<circle cx="84" cy="10" r="2.2"/></g>',
};
/** Two muscles against each other. @param {Measures} of */
const pair = (of) =>
  `${BESIDE.joint}<g transform="translate(2 0) scale(.62 .5)">${drawing(of)}</g>`
  + `<g transform="translate(2 20) scale(.62 .5)">${drawing(of)}</g>`;

/**
 * @param {Measures | undefined} of nothing leaves it empty
 * @param {string} [label] without one it is decoration
 * @param {string} [page] what it is shown for
 */
export function thumbnail(of, label, page) {
  const box = el("span", { class: "thumbnail", "aria-hidden": label ? undefined : "true",
    role: label ? "img" : undefined, "aria-label": label });
  const svg = document.createElementNS(SVG, "svg");
  svg.setAttribute("viewBox", `0 0 ${WIDTH} ${HEIGHT}`);
  if (of && [of.outer_diameter_mm, of.wall_mm, of.length_mm].every((x) => x > 0))
    svg.innerHTML = page === "joint"
      ? pair(of)
      : page === "data"
      ? `<g opacity=".35">${drawing(of)}</g>${BESIDE.data}`
      : drawing(of);
  box.append(svg);
  return box;
}
