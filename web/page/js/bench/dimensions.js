// Dimension lines over the muscle, and its shape at rest as a ghost.
import { path, words } from "../svg.js";
import { showLength } from "../units.js";

/** @typedef {[number, number]} Place */
/** Pixels between the muscle and a dimension line. */
const GAP = 14;
const at = (/** @type {Place} */ [x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`;

/** @param {HTMLElement} stage @param {Store} store @param {() => View} view */
export function dimensions(stage, store, view) {
  stage.insertAdjacentHTML("beforeend", '<svg class="dimensions" aria-hidden="true"></svg>');
  const svg = /** @type {SVGSVGElement} */ (stage.lastElementChild);
  let on = true;
  function paint() {
    const shape = store.shape.peek();
    svg.style.display = on && shape ? "" : "none";
    if (on && shape) svg.innerHTML = drawing(view(), shape);
  }
  return {
    paint,
    /** @param {boolean} shown */
    show(shown) {
      on = shown;
      paint();
    },
  };
}

/** @param {View} view @param {NonNullable<Store["shape"]["value"]>} shape */
function drawing(view, { length_mm: now, bulged_diameter_mm: wide }) {
  const { restLength: length, restRadius: radius } = view.show,
    pixels = (/** @type {number} */ mm) => mm / view.millimetresPerPixel;
  const place = (/** @type {number} */ x) => /** @type {Place} */ (view.project(x));
  const [left, end, rest] = [-now / 2, now / 2, length - now / 2].map(place);
  const [dx, dy] = [rest[0] - left[0], rest[1] - left[1]],
    long = Math.sign(dx || 1) * (Math.hypot(dx, dy) || 1);
  /** So far upwards across the axis. */
  const off = (/** @type {Place} */ [x, y], /** @type {number} */ up) =>
    /** @type {Place} */ ([x + (dy * up) / long, y - (dx * up) / long]);
  const [r, bulge] = [radius, view.largest()].map(pixels);
  const outline = [off(left, r), off(rest, r), off(rest, -r), off(left, -r)];
  const low = -Math.max(bulge, r) - GAP,
    line = [left, end].map((foot) => off(foot, low)),
    feet = [left, end].map((foot) => `M${at(off(foot, low - 5))}L${at(off(foot, -r))}`);
  const middle = (/** @type {Place[]} */ [a, b]) =>
    /** @type {Place} */ ([(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]);
  const across = middle([left, end]),
    top = off(across, bulge);
  const [x, y] = middle(line);
  return [
    path(`M${outline.map(at).join("L")}Z`, "ghost"),
    path(`M${at(line[0])}L${at(line[1])}${feet.join("")}`),
    path(`M${at(top)}L${at(off(top, GAP))}`),
    words(`L ${showLength(now, 4)}`, x, y + 15, "middle"),
    words(`⌀ ${showLength(wide ?? 2 * radius, 4)}`, ...off(top, GAP + 4), "middle"),
    view.width > 560
      ? words(
          `dashed: at rest ⌀ ${showLength(2 * radius, 4)}, L0 ${showLength(length, 4)}`,
          12,
          view.height - 46,
        )
      : "",
  ].join("");
}
