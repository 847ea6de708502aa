// A small picture of a muscle: tube, braid and ends in proportion, from its measures alone.
import { body } from "./body.js";
import { el } from "./dom.js";

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
    `<g transform="translate(${(WIDTH - length) / 2} ${HEIGHT / 2})">` +
    `${body({ length, diameter, bulged: 1.08 * diameter, angle })}</g>`
  );
}

/**
 * A card to click.
 * @param {() => unknown} act @param {Element} picture @param {string} title @param {string} about
 */
export function card(act, picture, title, about) {
  picture.classList.add("picture");
  return el(
    "button",
    { type: "button", class: "card", onclick: act },
    picture,
    el("b", title),
    el("span", { class: "small soft" }, about),
  );
}

/**
 * @param {MuscleMeasures | undefined} of nothing leaves it empty
 * @param {string} [label] without one it is decoration
 */
export function thumbnail(of, label) {
  const box = el("span", {
    class: "thumbnail",
    ariaHidden: label ? undefined : "true",
    role: label ? "img" : undefined,
    ariaLabel: label,
  });
  const isThere = of && [of.outer_diameter_mm, of.wall_mm, of.length_mm].every((x) => x > 0);
  box.innerHTML = `<svg viewBox="0 0 ${WIDTH} ${HEIGHT}">${isThere ? drawing(of) : ""}</svg>`;
  return box;
}
