// Dimension lines over the muscle, and its shape at rest as a ghost. The handles change the diameter and the length at
// rest.
import { dragging } from "../dom.js";
import { muscle } from "../muscle.js";
import { show } from "../units.js";

/** @typedef {[number, number]} Place */
const SVG = "http://www.w3.org/2000/svg";
/** Pixels between the muscle and a dimension line. */
const GAP = 14;
const at = (/** @type {Place} */ [x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`;

/** @param {HTMLElement} stage @param {Store} store @param {() => View} view */
export function dimensions(stage, store, view) {
  const svg = document.createElementNS(SVG, "svg"), lines = document.createElementNS(SVG, "g");
  svg.setAttribute("class", "dimensions");
  svg.setAttribute("aria-hidden", "true");
  const handles = [["D", "Drag to change the outer diameter"], ["L", "Drag to change the length"]
  ].map(([key, title]) => handle(key, title));
  svg.append(lines, ...handles);
  stage.append(svg);
  let on = true;

  function paint() {
    const { shape } = store, seen = view();
    svg.style.display = on && shape ? "" : "none";
    if (!on || !shape) return;
    const places = layout(seen, shape, seen.show.restLength, seen.show.restRadius);
    // On a narrow page they would lie on each other: there are sliders.
    handles.forEach((one) => { one.style.display = seen.width > 560 ? "" : "none"; });
    lines.innerHTML = drawing(places, shape, seen.show, seen.width, seen.height);
    const { rest: [, b], up, radius } = places;
    [[b[0] + up[0] * radius, b[1] + up[1] * radius], b].forEach(([x, y], i) =>
      handles[i].setAttribute("transform", `translate(${x.toFixed(1)} ${y.toFixed(1)})`),
    );
  }

  /** @param {string} key @param {string} title */
  function handle(key, title) {
    const circle = document.createElementNS(SVG, "circle"), words = document.createElementNS(SVG, "title");
    circle.setAttribute("r", "5");
    words.textContent = title;
    circle.append(words);
    let from = { x: 0, y: 0, value: 0 };
    dragging(circle, (event, settled, begins) => {
      if (begins) {
        from = { x: event.clientX, y: event.clientY, value: Number(muscle.value(key)) };
        event.stopPropagation();
      }
      const seen = view(), { restLength, restRadius } = seen.show;
      const { up, along, rest } = layout(seen, store.shape, restLength, restRadius);
      const [dx, dy] = [event.clientX - from.x, event.clientY - from.y];
      // Along the axis lengths are foreshortened.
      const long = Math.hypot(rest[1][0] - rest[0][0], rest[1][1] - rest[0][1]);
      const by = key === "D" ? 2 * (dx * up[0] + dy * up[1]) * seen.millimetresPerPixel
        : ((dx * along[0] + dy * along[1]) * restLength) / Math.max(20, long);
      if (!begins) store.changed(key, Math.max(1, Math.round(10 * (from.value + by)) / 10), settled);
    });
    return circle;
  }
  return {
    paint,
    /** @param {boolean} shown */
    show(shown) { on = shown; paint(); },
  };
}

/**
 * Where things are seen: ends of the axis now and at rest, directions along it and across it, radii in pixels.
 * @param {View} view @param {Store["shape"]} shape @param {number} length at rest @param {number} radius at rest
 */
function layout(view, shape, length, radius) {
  const now = shape?.length_mm ?? length;
  const place = (/** @type {number} */ x) => /** @type {Place} */ (view.project(x, 0, 0));
  const ends = [place(-now / 2), place(now / 2)], rest = [ends[0], place(length - now / 2)];
  const [dx, dy] = [rest[1][0] - rest[0][0], rest[1][1] - rest[0][1]], long = Math.hypot(dx, dy) || 1;
  const along = /** @type {Place} */ ([dx / long, dy / long]), up = /** @type {Place} */ ([along[1], -along[0]]);
  const perPixel = view.millimetresPerPixel;
  return { ends, rest, along, up: up[1] > 0 ? /** @type {Place} */ ([-up[0], -up[1]]) : up, radius: radius / perPixel,
    bulge: view.largest() / perPixel };
}

/**
 * @param {ReturnType<typeof layout>} places @param {NonNullable<Store["shape"]>} shape
 * @param {{ restRadius: number, restLength: number }} show @param {number} wide @param {number} tall
 */
function drawing({ ends, rest, up, radius, bulge }, shape, { restRadius, restLength }, wide, tall) {
  const off = (/** @type {Place} */ [x, y], /** @type {number} */ by) =>
    /** @type {Place} */ ([x + up[0] * by, y + up[1] * by]);
  const middle = (/** @type {Place[]} */ [a, b], share = 0.5) =>
    /** @type {Place} */ ([a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])]);
  const [a, b] = rest;
  const outline = [off(a, radius), off(b, radius), off(b, -radius), off(a, -radius)];
  const ghost = `<path class="ghost" d="M${outline.map(at).join("L")}Z"/>`;
  const low = -Math.max(bulge, radius) - GAP, line = ends.map((end) => off(end, low));
  const feet = ends.map((end) => `M${at(off(end, low - 5))}L${at(off(end, -radius))}`);
  const long = `<path d="M${at(line[0])}L${at(line[1])}${feet.join("")}"/>`;
  const across = middle(ends), [top, bottom] = [off(across, bulge), off(across, -bulge)];
  const round = `<path class="over" d="M${at(top)}L${at(bottom)}"/><path d="M${at(top)}L${at(off(top, GAP))}"/>`;
  const words = (/** @type {Place} */ [x, y], /** @type {string} */ text, anchor = "middle") =>
    `<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" text-anchor="${anchor}">${text}</text>`;
  const below = middle(line), above = off(top, GAP + 4);
  const atRest = `dashed: at rest ⌀ ${show("length", 2 * restRadius, 4)}, L0 ${show("length", restLength, 4)}`;
  return `${ghost}${long}${round}${words([below[0], below[1] + 15], `L ${show("length", shape.length_mm, 4)}`)}`
    + `${words(above, `⌀ ${show("length", shape.bulged_diameter_mm ?? 2 * restRadius, 4)}`)}`
    + (wide > 560 ? words([12, tall - 46], atRest, "start") : "");
}
