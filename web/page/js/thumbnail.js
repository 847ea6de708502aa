// A small picture of a muscle: tube, braid and ends in proportion, from its measures alone.
import { body, ground } from "./body.js";
import { el } from "./dom.js";

const SVG = "http://www.w3.org/2000/svg";
const WIDTH = 96,
  HEIGHT = 40;

/**
 * Lengths by their logarithms, so that a muscle of 2 mm and one of 80 mm can both be seen.
 * @param {MuscleMeasures} of @returns {string} the inside of an SVG of 96 by 40
 */
function drawing({ outer_diameter_mm: D, length_mm: L, angle_deg: angle }) {
  const length = Math.min(74, Math.max(26, 30 + 20 * Math.log2(L / 100))),
    diameter = Math.min(30, Math.max(6, 6 + 4.6 * Math.log2(D / 2)));
  return (
    `<g transform="translate(${(WIDTH - length) / 2} ${HEIGHT / 2 - 2})">${ground(length, diameter / 2)}` +
    `${body({ length, diameter, bulged: 1.08 * diameter, angle })}</g>`
  );
}

/**
 * What a muscle of the gallery is besides a muscle: two of them on a pulley, or measured points over it.
 * @type {Record<string, (of: MuscleMeasures) => string>}
 */
const BESIDE = {
  joint: (of) =>
    '<circle cx="78" cy="20" r="9" class="port"/><path d="M78 20 92 8" class="arm"/>' +
    `<path d="M10 11h58M10 29h58" class="rope"/><g transform="translate(2 2) scale(.62 .5)">${drawing(of)}</g>` +
    `<g transform="translate(2 20) scale(.62 .5)">${drawing(of)}</g>`,
  data: (of) =>
    `<g opacity=".35">${drawing(of)}</g><path d="M8 35 30 24 52 16 88 8" class="fit"/><g class="points">` +
    '<circle cx="14" cy="34" r="2.2"/><circle cx="32" cy="21" r="2.2"/><circle cx="50" cy="18.5" r="2.2"/>' +
    '<circle cx="68" cy="11" r="2.2"/><circle cx="84" cy="10" r="2.2"/></g>',
};

/**
 * A card to click.
 * @param {() => unknown} act @param {Element} picture @param {string} title @param {string[]} lines the last is small
 */
export function card(act, picture, title, ...lines) {
  const last = lines.length - 1;
  picture.classList.add("picture");
  return el(
    "button",
    { type: "button", class: "card", onclick: act },
    picture,
    el("b", {}, title),
    ...lines.map((text, i) =>
      el("span", { class: i === last && "small soft" }, text),
    ),
  );
}

/**
 * @param {MuscleMeasures | undefined} of nothing leaves it empty @param {string} [label] without one it is decoration
 * @param {string} [page] what it is shown for
 */
export function thumbnail(of, label, page = "") {
  const box = el("span", {
    class: "thumbnail",
    "aria-hidden": label ? undefined : "true",
    role: label ? "img" : undefined,
    "aria-label": label,
  });
  const svg = document.createElementNS(SVG, "svg");
  svg.setAttribute("viewBox", `0 0 ${WIDTH} ${HEIGHT}`);
  if (
    of &&
    [of.outer_diameter_mm, of.wall_mm, of.length_mm].every((x) => x > 0)
  )
    svg.innerHTML = (BESIDE[page] ?? drawing)(of);
  box.append(svg);
  return box;
}
