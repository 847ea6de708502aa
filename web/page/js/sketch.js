// A drawing of what a symbol measures: shown while its name is pointed at, or its field has the
// focus.
import { el, smallPrint } from "./dom.js";
import { measured } from "./state.js";

// The muscle in section, at rest: tube from 40 to 200, its axis at y = 60.
const BODY =
  '<path class="rubber" d="M40 36h160v10H40zM40 74h160v10H40z"/>' +
  '<path class="plug" d="M30 33h16v54H30zM194 33h16v54H194z"/><path class="axis" d="M14 60h212"/>';
// Contracted: the tube bulges between the ends.
const BULGED =
  '<path class="rubber" d="M58 44Q120 6 182 44L182 52Q120 16 58 52zM58 76Q120 114 182 76L182 68Q120 104 58 68z"/>' +
  '<path class="plug" d="M48 40h14v40H48zM178 40h14v40H178z"/><path class="axis" d="M14 60h212"/>';
const BRAID =
  '<path class="strand" d="M50 84 74 36M74 84 98 36M98 84 122 36M122 84 146 36M146 84 170 36M170 84 194 36' +
  'M74 84 50 36M98 84 74 36M122 84 98 36M146 84 122 36M170 84 146 36M194 84 170 36"/>';
const PULLEY =
  '<circle class="plain" cx="150" cy="60" r="22"/><path class="arm" d="M150 60 214 30"/>' +
  '<path class="rubber" d="M20 32q40-12 80 0v12q-40 12-80 0zM20 76q40-12 80 0v12q-40 12-80 0z"/>' +
  '<path class="plain" d="M100 38h50M100 82h50"/>';
/**
 * A dimension line between two points, with its symbol.
 * @param {number} x1 @param {number} y1 @param {number} x2 @param {number} y2 @param {string} text
 */
function dimension(x1, y1, x2, y2, text) {
  const long = Math.hypot(x2 - x1, y2 - y1) || 1,
    [u, v] = [(x2 - x1) / long, (y2 - y1) / long];
  const tip = (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ way) =>
    `M${x} ${y}l${way * (6 * u - 3 * v)} ` +
    `${way * (6 * v + 3 * u)}M${x} ${y}l${way * (6 * u + 3 * v)} ${way * (6 * v - 3 * u)}`;
  const [tx, ty] =
    Math.abs(u) > Math.abs(v) ? [(x1 + x2) / 2, y1 - 5] : [x1 + 6, (y1 + y2) / 2 + 4];
  return (
    `<path class="measure" d="M${x1} ${y1}L${x2} ${y2}${tip(x1, y1, 1)}${tip(x2, y2, -1)}"/>` +
    `<text x="${tx}" y="${ty}" text-anchor="${Math.abs(u) > Math.abs(v) ? "middle" : "start"}">${text}</text>`
  );
}
const arrow = (
  /** @type {string} */ d,
  /** @type {string} */ text,
  /** @type {[number, number]} */ [x, y],
) => `<path class="measure" d="${d}"/><text x="${x}" y="${y}">${text}</text>`;
/** @param {string} text @param {number} x @param {number} y */
const word = (text, x, y) => `<text x='${x}' y='${y}'>${text}</text>`;
const ANGLE = arrow("M86 60h44M86 60 102 28M112 60a26 26 0 0 0-14-23", "θ", [116, 48]);
const PRESSURE = arrow(
  "M120 60v-22M116 44l4-6 4 6M120 60v22M116 76l4 6 4-6M80 60v-16M76 50l4-6 4 6M80 60v16M76 " +
    "70l4 6 4-6M160 60v-16M156 50l4-6 4 6M160 60v16M156 70l4 6 4-6",
  "p",
  [128, 63],
);
const PULL = arrow("M192 60h38M222 55l8 5-8 5M48 60H10M18 55l-8 5 8 5", "F", [216, 48]);
const STRAND = '<circle class="rubber" cx="120" cy="60" r="30"/>';

/**
 * Drawings by the keys of fields; `web/symbols.mjs` makes those of the glossary of them.
 * @type {Record<string, () => string>}
 */
export const DRAWINGS = {
  D: () => BODY + dimension(120, 36, 120, 84, "D0"),
  s: () =>
    BODY + dimension(120, 22, 120, 36, "") + dimension(120, 60, 120, 46, "") + word("s", 128, 30),
  L: () => BODY + dimension(46, 106, 194, 106, "L0"),
  angle: () => BODY + BRAID + ANGLE,
  p: () => BULGED + PRESSURE,
  e: () =>
    BULGED +
    '<path class="ghost" d="M30 33h16v54H30zM194 33h16v54H194z"/>' +
    dimension(62, 112, 178, 112, "L = L0 (1 − ε)"),
  F: () => BULGED + PULL,
  k: () => BODY + BRAID + arrow("M122 84 146 36M140 39l6-3v7", "k", [150, 34]),
  sd: () => STRAND + dimension(90, 60, 150, 60, "d"),
  strand_area_mm2: () => STRAND + word("A", 114, 64),
  sE: () =>
    '<path class="strand thick" d="M40 60h160"/>' +
    arrow("M40 60H14M200 60h26M20 55l-6 5 6 5M220 55l6 5-6 5", "E", [116, 50]),
  seating: () => BULGED + dimension(62, 104, 82, 104, "") + word("bonded end", 86, 108),
  grip: () => BODY + dimension(46, 104, 70, 104, "") + word("grip", 76, 108),
  slip: () => BODY + arrow("M30 96h22M46 91l6 5-6 5", "slip under load", [58, 100]),
  bulge: () => BULGED + dimension(120, 25, 120, 95, "D"),
  stroke: () =>
    BULGED +
    '<path class="ghost" d="M194 33h16v54H194z"/>' +
    dimension(186, 106, 202, 106, "") +
    word("stroke", 120, 110),
  r: () => PULLEY + dimension(150, 60, 150, 38, "") + word("r", 155, 53),
  phi: () => PULLEY + arrow("M150 60h60M196 60a46 46 0 0 0-5-19", "φ", [202, 52]),
  range: () => PULLEY + arrow("M150 60 206 96M150 60 206 24M196 90a50 50 0 0 0 0-60", "", [0, 0]),
  e0: () => PULLEY + dimension(20, 110, 100, 110, "L0 (1 − ε0)"),
  K: () => PULLEY + arrow("M214 30l6 14M216 38l4 6 1-7", "K = −∂τ/∂φ", [146, 20]),
};
/**
 * Fields of other names that mean the same, but for those of measures.
 * @type {Record<string, string>}
 */
const SAME = {
  max_pressure_mpa: "p",
  supply_mpa: "p",
  pmax: "p",
  max_bulged_diameter_mm: "bulge",
  stroke_mm: "stroke",
  radius_mm: "r",
};

/**
 * The drawing of a key or a field, where there is one.
 * @param {string} [key] @returns {(() => string) | undefined}
 */
export const drawing = (key = "") =>
  DRAWINGS[key] ?? DRAWINGS[SAME[key] ?? measured().find(({ field }) => field === key)?.key ?? ""];

/**
 * Marks the row of a field as one with a drawing.
 * @param {HTMLElement} row @param {...(string | undefined)} keys
 */
export function sketched(row, ...keys) {
  const key = keys.find((name) => drawing(name));
  if (key) row.dataset.sketch = key;
}

/** Drawings appear beside rows, and go with the pointer, the focus, or Escape. */
export function sketches() {
  const box = el("div", { class: "sketch drawn", role: "tooltip", hidden: true });
  document.body.append(box);
  /** @type {HTMLElement | undefined} */ let of;
  let waits = 0,
    top = 0;
  const hide = () => {
    clearTimeout(waits);
    box.hidden = true;
    of = undefined;
  };
  /** @param {HTMLElement} row */
  function show(row) {
    const draw = drawing(row.dataset.sketch);
    if (!draw || !row.isConnected) return;
    box.innerHTML = `<svg viewBox="0 0 240 120" aria-hidden="true">${draw()}</svg>`;
    const about = row.dataset.about;
    if (about) box.append(smallPrint(about));
    box.hidden = false;
    const at = row.getBoundingClientRect();
    top = at.top;
    const { width, height } = box.getBoundingClientRect();
    // Beside the row, and below the headline; below the row where the window is narrow.
    const beside = at.right + width + 16 < innerWidth,
      headline = document.querySelector(".say")?.getBoundingClientRect().bottom ?? 0;
    box.style.left = `${beside ? at.right + 8 : Math.max(8, Math.min(innerWidth - width - 8, at.left))}px`;
    box.style.top = `${Math.max(8, Math.min(innerHeight - height - 8, beside ? Math.max(headline, at.top - 20) : at.bottom + 6))}px`;
  }
  const over = (/** @type {Event} */ event, /** @type {number} */ wait) => {
    const target = /** @type {Element} */ (event.target);
    if (box.contains(target)) return;
    const row = /** @type {HTMLElement | null} */ (target.closest?.("[data-sketch]") ?? null);
    if (row === (of ?? null)) return;
    hide();
    // Not while a slider is dragged.
    if (!row || ("buttons" in event && event.buttons)) return;
    of = row;
    waits = window.setTimeout(() => show(row), wait);
  };
  document.addEventListener("pointerover", (event) => {
    if (event.pointerType !== "touch") over(event, 400);
  });
  document.addEventListener("focusin", (event) => {
    if (/** @type {Element} */ (event.target).matches("input[type=text]")) over(event, 250);
  });
  document.addEventListener("focusout", hide);
  document.addEventListener("pointerdown", (event) => {
    if (!box.contains(/** @type {Node} */ (event.target))) hide();
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") hide();
  });
  // What comes above a row may scroll the page, and leaves the row where it is seen.
  const moved = () => Math.abs((of?.getBoundingClientRect().top ?? top) - top) > 4 && !box.hidden;
  addEventListener(
    "scroll",
    () => {
      if (moved()) hide();
    },
    { capture: true, passive: true },
  );
  addEventListener("popstate", hide);
}
