// A muscle that hangs from a bar and lifts a weight, to scale beside a coin.
import { body, contracted } from "./body.js";
import { block } from "./dom.js";
import { isStill, playing } from "./play.js";
import { path, svg, words } from "./svg.js";
import { widthOf } from "./design-view.js";
import { clamp, showForce, showLength } from "./units.js";

/** Diameter of a coin of one euro. */
const COIN = 23.25;
/**
 * In millimetres from the middle of the bar. @param {Candidate} c @param {number} share of its way
 */
function drawn(c, share) {
  const [{ contraction, required_n: force }] = c.points,
    { count, outer_diameter_mm: diameter, length_mm: rest, angle_deg } = c;
  const free = contracted(diameter, angle_deg, contraction).bulged,
    most = c.bulged_diameter_mm ?? free,
    now = contracted(diameter, angle_deg, share * contraction),
    bulged = now.bulged * (1 + share * (most / free - 1));
  // Of muscles side by side in a circle so many are seen.
  const across = Math.round(Math.sqrt(1.3 * count)),
    beside = (across * most) / 2,
    half = 0.2 * rest;
  const way = rest * contraction,
    up = share * way,
    length = rest - up,
    plug = 0.6 * diameter,
    weight = 2 * plug + 1.05 * rest,
    tall = weight + half;
  const font = tall / (innerWidth < 900 ? 24 : 36),
    wide = Math.max(half, beside),
    x = beside + font,
    y = plug + rest / 2,
    left = -half - font;
  const one = body({ length, diameter, bulged, angle: now.angle });
  const all = Array.from({ length: across }, (_, i) => {
    const place = `translate(${(i - (across - 1) / 2) * most} ${plug}) rotate(90)`;
    return svg("g", { transform: place }, one);
  });
  const steel = (/** @type {number} */ y, /** @type {string} */ kind) =>
    svg("rect", { class: kind, x: -half, y, width: 2 * half, height: half });
  const round = (/** @type {string} */ kind, /** @type {number} */ r) =>
    svg("circle", { class: kind, cx: x + COIN / 2, cy: y + COIN / 2, r });
  const box = [-wide - 8 * font, -font, 2 * wide + 18 * font + COIN, tall + 2 * font];
  return svg(
    "svg",
    {
      viewBox: box.join(" "),
      "font-size": font,
      role: "img",
      "aria-label": "The muscle to scale, beside a coin",
    },
    svg("path", {
      d: `M${-wide} 0H${wide}M0 ${2 * plug + length}V${weight - up}`,
      class: "bar",
      "stroke-width": font / 6,
    }),
    ...all,
    steel(weight, "ghost"),
    steel(weight - up, "steel"),
    path(`M${left} ${weight}v${-way}M${left - font} ${weight}h${font}m0 ${-way}h${-font}`, "way"),
    words(showLength(way, 3), left - font, weight - way / 2, "end"),
    words(showForce(force * count, 3), 0, weight - up + half / 2, "middle"),
    words(`${widthOf(c)} wide`, x, y - font),
    words("1 € coin", x, y + COIN + 1.2 * font),
    round("coin", COIN / 2),
    round("core", COIN / 3),
  );
}

/** It moves by itself, unless motion is not wanted. */
export function liftView() {
  const box = block("lift"),
    still = isStill();
  /** @type {Candidate | undefined} */ let one;
  let shown = NaN;
  const draw = (/** @type {number} */ share) => {
    if (!one || share === shown) return;
    shown = share;
    box.innerHTML = drawn(one, share);
  };
  const play = playing(
    "the muscle",
    // It rests at both ends, and moves in steps: the search needs the processor too.
    (share) => draw(clamp(Math.round(16 - 22 * Math.cos(79 * share)) / 32, 0, 1)),
    () => (still ? 3000 : 60_000),
  );
  return {
    element: block("stand", box, play.button),
    /** @param {Candidate | undefined} next nothing leaves its place empty */
    show(next) {
      play.button.hidden = !next;
      if (one === next) return;
      one = next;
      shown = NaN;
      if (!one) return box.replaceChildren();
      draw(1);
      if (!still) play.start();
    },
  };
}
