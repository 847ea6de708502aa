// A small picture of a muscle: tube, braid and ends in proportion, from its measures alone.
import { body } from "./body.js";
import { el } from "./dom.js";
import { clamp } from "./units.js";

/**
 * A card to click.
 * @param {() => unknown} act @param {Element} picture @param {string} title @param {string} about
 */
export const card = (act, picture, title, about) =>
  el(
    "button",
    { type: "button", class: "card", onclick: act },
    picture,
    el("b", title),
    el("span", { class: "small soft" }, about),
  );

/**
 * Lengths by their logarithms, so that a muscle of 2 mm and one of 80 mm can both be seen.
 * @param {Omit<MuscleMeasures, "wall_mm"> | undefined} of nothing leaves it empty
 */
export function thumbnail(of) {
  const { outer_diameter_mm: D, length_mm: L, angle_deg: angle } = of ?? {},
    length = clamp(30 + 20 * Math.log2((L ?? 0) / 100), 26, 74),
    diameter = clamp(6 + 4.6 * Math.log2((D ?? 0) / 2), 6, 30);
  const box = el("span", { class: "thumbnail", ariaHidden: "true" });
  box.innerHTML = `<svg viewBox="${(length - 96) / 2} -20 96 40">${
    of ? body({ length, diameter, bulged: 1.08 * diameter, angle }) : ""
  }</svg>`;
  return box;
}
