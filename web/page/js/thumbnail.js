// A small picture of a muscle: tube, braid and ends in proportion, from its measures alone.
import { el } from "./dom.js";

/** @typedef {{ outer_diameter_mm: number, wall_mm: number, length_mm: number, angle_deg?: number | null }} Measures */
const SVG = "http://www.w3.org/2000/svg";
const WIDTH = 96, HEIGHT = 40;

/** Lengths in the picture: long muscles are drawn shorter than they are, so that a diameter can be seen. @param {Measures} of */
function proportions({ outer_diameter_mm: D, wall_mm: s, length_mm: L }) {
  const slender = Math.min(12, Math.max(1.5, L / D)), long = Math.min(80, 8 * slender ** 0.95 + 12);
  const high = Math.min(28, Math.max(7, long / slender ** 0.85));
  return { long, high, wall: Math.max(1, Math.min(high / 2 - 1, (high * s) / D)) };
}

/** The strands of one family across the tube. @param {number} x @param {number} long @param {number} high @param {number} slope */
function strands(x, long, high, slope) {
  const y = (HEIGHT - high) / 2, rise = high / Math.abs(slope), step = Math.max(4, rise * 0.6), out = [];
  for (let at = x - rise; at < x + long; at += step) {
    const [from, to] = [Math.max(x, at), Math.min(x + long, at + rise)];
    const height = (/** @type {number} */ here) => (slope > 0 ? y + (here - at) * slope : y + high + (here - at) * slope);
    if (to > from) out.push(`M${from.toFixed(1)} ${height(from).toFixed(1)}L${to.toFixed(1)} ${height(to).toFixed(1)}`);
  }
  return out.join("");
}

/** @param {Measures} of @returns {string} the inside of an SVG of 96 by 40 */
function drawing(of) {
  const { long, high, wall } = proportions(of), x = (WIDTH - long) / 2, y = (HEIGHT - high) / 2;
  const slope = Math.tan((Math.min(70, Math.max(8, of.angle_deg ?? 28)) * Math.PI) / 180);
  const plug = (/** @type {number} */ at) => `<rect x="${at}" y="${y - 1}" width="6" height="${high + 2}" rx="1" class="plug"/>`;
  return `<rect x="${x}" y="${y}" width="${long}" height="${high}" class="tube"/>`
    + `<rect x="${x}" y="${y + wall}" width="${long}" height="${Math.max(1, high - 2 * wall)}" class="bore"/>`
    + `<path d="${strands(x, long, high, slope)}${strands(x, long, high, -slope)}" class="strands"/>`
    + `${plug(x - 3)}${plug(x + long - 3)}<path d="M${x - 9} ${HEIGHT / 2}h6M${x + long + 3} ${HEIGHT / 2}h6" class="port"/>`;
}

/** @param {Measures | undefined} of nothing leaves it empty @param {string} [label] without one it is decoration */
export function thumbnail(of, label) {
  const box = el("span", { class: "thumbnail", "aria-hidden": label ? undefined : "true", role: label ? "img" : undefined, "aria-label": label });
  const svg = document.createElementNS(SVG, "svg");
  svg.setAttribute("viewBox", `0 0 ${WIDTH} ${HEIGHT}`);
  if (of && [of.outer_diameter_mm, of.wall_mm, of.length_mm].every((x) => x > 0)) svg.innerHTML = drawing(of);
  box.append(svg);
  return box;
}
