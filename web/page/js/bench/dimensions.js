// Dimension lines over the muscle, and its shape at rest as a ghost. The handles change diameter,
// wall and length at rest, and the angle of a strand.
import { dragging } from "../dom.js";
import { muscle } from "../muscle.js";
import { clamp, evenly, showLength } from "../units.js";

/** @typedef {[number, number]} Place */
/**
 * Pixels between the muscle and a dimension line, and between two handles at least; fingers need
 * more.
 */
const GAP = matchMedia("(pointer: coarse)").matches ? 26 : 14;
/**
 * What the handles change, and to how many parts of a unit it is rounded.
 * @type {Record<string, [string, number]>}
 */
const HANDLES = {
  D: ["outer diameter", 10],
  L: ["length", 10],
  s: ["wall", 100],
  angle: ["braid angle", 10],
};
/** How far from the front a strand is taken hold of, about the axis. */
const HOLD = 0.8;
const at = (/** @type {Place} */ [x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`;

/** @param {HTMLElement} stage @param {Store} store @param {() => View} view */
export function dimensions(stage, store, view) {
  const circles = Object.values(HANDLES).map(
    ([name]) => `<circle r="5"><title>Drag to change the ${name}</title></circle>`,
  );
  stage.insertAdjacentHTML(
    "beforeend",
    `<svg class="dimensions" aria-hidden="true"><g></g>${circles.join("")}</svg>`,
  );
  const svg = /** @type {SVGSVGElement} */ (stage.lastElementChild),
    [lines, ...handles] = /** @type {Iterable<SVGElement>} */ (svg.children);
  let on = true;

  function paint() {
    const { shape } = store,
      seen = view();
    svg.style.display = on && shape ? "" : "none";
    if (!on || !shape) return;
    const places = layout(seen, shape),
      { said } = muscle.state,
      wide = seen.width > 560;
    // A named sleeve has its angle.
    const turns =
      wide && !seen.show.cut && (!(said.braid ?? muscle.shown?.sleeve) || said.angle !== undefined);
    lines.innerHTML = drawing(places, shape, seen, turns);
    const {
      rest: [, b],
      radius,
      bore,
      strand,
      off,
    } = places;
    const spots = [
      off(b, Math.max(radius, GAP)),
      b,
      off(b, -Math.max(bore, GAP)),
      strand[strand.length - 1],
    ];
    handles.forEach((one, i) => {
      // On a narrow page more than two would lie on each other: there are sliders.
      one.style.display = i < 2 || (i < 3 ? wide : turns) ? "" : "none";
      one.setAttribute("transform", `translate(${at(spots[i])})`);
    });
  }

  Object.entries(HANDLES).forEach(([key, [, parts]], i) => {
    let from = { x: 0, y: 0, value: 0 };
    dragging(handles[i], (event, settled, begins) => {
      if (begins) {
        from = { x: event.clientX, y: event.clientY, value: Number(muscle.value(key)) };
        return event.stopPropagation();
      }
      const seen = view(),
        { shape } = store,
        { restLength, restRadius } = seen.show;
      if (!shape) return;
      const { across, ahead, long, foot } = layout(seen, shape),
        box = stage.getBoundingClientRect();
      const to = /** @type {Place} */ ([event.clientX - from.x, event.clientY - from.y]);
      const by = across(to) * seen.millimetresPerPixel;
      const held = /** @type {Place} */ ([
        event.clientX - box.left - foot[0],
        event.clientY - box.top - foot[1],
      ]);
      /** @type {Record<string, () => number>} */ const next = {
        D: () => Math.max(1, from.value + 2 * by),
        s: () => clamp(from.value + by, 0.05, 0.9 * restRadius),
        // Along the axis lengths are foreshortened.
        L: () => Math.max(1, from.value + (ahead(to) * restLength) / Math.max(20, long)),
        angle: () => angleAtRest(shape, seen.largest(), (ahead(held) * restLength) / long),
      };
      store.changed(key, Math.round(parts * next[key]()) / parts, settled);
    });
  });
  return {
    paint,
    /** @param {boolean} shown */
    show(shown) {
      on = shown;
      paint();
    },
  };
}

/**
 * The strand angle at rest with which a strand is held so far along the axis from its foot, in mm.
 * Strands keep their length: at a contraction the ratio of the cosines is fixed, and the radius
 * grows like that of the sines.
 * @param {NonNullable<Store["shape"]>} shape @param {number} radius of the shape
 * @param {number} ahead
 */
function angleAtRest({ arrays, muscle: { angle_deg: rest } }, radius, ahead) {
  const degree = Math.PI / 180,
    now = arrays.strand_angle_deg[0] * degree;
  const ratio = Math.cos(now) / Math.cos(rest * degree),
    share = (radius * Math.sin(rest * degree)) / Math.sin(now);
  let [low, high] = [12, 54];
  for (let i = 0; i < 20; i++) {
    const middle = 0.5 * (low + high);
    if (
      HOLD * share * Math.min(1, ratio * Math.cos(middle * degree)) >
      ahead * Math.sin(middle * degree)
    )
      low = middle;
    else high = middle;
  }
  return low;
}

/**
 * Where things are seen: ends of the axis now and at rest, directions along it and across it, radii
 * in pixels, and a strand from its foot on the axis to where it is held.
 * @param {View} view @param {NonNullable<Store["shape"]>} shape
 */
function layout(view, { length_mm: now, muscle: { wall_mm: wall }, arrays }) {
  const { restLength: length, restRadius: radius } = view.show,
    perPixel = view.millimetresPerPixel;
  const place = (/** @type {number} */ x) => /** @type {Place} */ (view.project(x, 0, 0));
  const ends = [place(-now / 2), place(now / 2)],
    rest = [ends[0], place(length - now / 2)];
  const [dx, dy] = [rest[1][0] - rest[0][0], rest[1][1] - rest[0][1]],
    long = Math.hypot(dx, dy) || 1;
  const along = /** @type {Place} */ ([dx / long, dy / long]),
    sign = along[0] > 0 ? 1 : -1;
  const up = /** @type {Place} */ ([sign * along[1], -sign * along[0]]),
    bulge = view.largest() / perPixel;
  const dot =
    (/** @type {Place} */ [a, b]) =>
    (/** @type {Place} */ [x, y]) =>
      a * x + b * y;
  const off = (/** @type {Place} */ [x, y], /** @type {number} */ by, ahead = 0) =>
    /** @type {Place} */ ([x + up[0] * by + along[0] * ahead, y + up[1] * by + along[1] * ahead]);
  const foot = place(-0.2 * now),
    rise = Math.tan((arrays.strand_angle_deg[0] * Math.PI) / 180);
  const strand = evenly(0, HOLD, 9).map((turn) =>
    off(foot, bulge * Math.sin(turn), ((bulge * turn) / rise) * ((long * perPixel) / length)),
  );
  return {
    ends,
    rest,
    off,
    across: dot(up),
    ahead: dot(along),
    long,
    radius: radius / perPixel,
    bore: (radius - wall) / perPixel,
    bulge,
    foot,
    strand,
  };
}

/**
 * @param {ReturnType<typeof layout>} places @param {NonNullable<Store["shape"]>} shape
 * @param {View} view @param {boolean} turns whether a strand can be taken hold of
 */
function drawing({ ends, rest, off, radius, bore, bulge, strand }, shape, view, turns) {
  const {
    show: { restRadius, restLength },
    width: wide,
    height: tall,
  } = view;
  const middle = (/** @type {Place[]} */ [a, b], share = 0.5) =>
    /** @type {Place} */ ([a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])]);
  const [a, b] = rest;
  const outline = [off(a, radius), off(b, radius), off(b, -radius), off(a, -radius)];
  const inside = [bore, -bore].map((r) => `M${at(off(b, r))}L${at(off(b, r, -24))}`).join("");
  const ghost =
    `<path class="ghost" d="M${outline.map(at).join("L")}Z${inside}"/>` +
    (turns ? `<path class="over" d="M${strand.map(at).join("L")}"/>` : "");
  const low = -Math.max(bulge, radius) - GAP,
    line = ends.map((end) => off(end, low));
  const feet = ends.map((end) => `M${at(off(end, low - 5))}L${at(off(end, -radius))}`);
  const long = `<path d="M${at(line[0])}L${at(line[1])}${feet.join("")}"/>`;
  const across = middle(ends),
    [top, bottom] = [off(across, bulge), off(across, -bulge)];
  const round = `<path class="over" d="M${at(top)}L${at(bottom)}"/><path d="M${at(top)}L${at(off(top, GAP))}"/>`;
  const words = (/** @type {Place} */ [x, y], /** @type {string} */ text, anchor = "middle") =>
    `<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" text-anchor="${anchor}">${text}</text>`;
  const below = middle(line),
    above = off(top, GAP + 4);
  const atRest = `dashed: at rest ⌀ ${showLength(2 * restRadius, 4)}, L0 ${showLength(restLength, 4)}`;
  return (
    `${ghost}${long}${round}${words([below[0], below[1] + 15], `L ${showLength(shape.length_mm, 4)}`)}` +
    `${words(above, `⌀ ${showLength(shape.bulged_diameter_mm ?? 2 * restRadius, 4)}`)}` +
    (wide > 560 ? words([12, tall - 46], atRest, "start") : "")
  );
}
