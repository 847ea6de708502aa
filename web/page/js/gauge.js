// A pressure gauge beside the muscle: dragged about its centre. The slider says the same to keyboards and screen
// readers.
import { dragging } from "./dom.js";
import { clamp, number, outside } from "./units.js";

/** From straight down, clockwise: where the dial begins, and how far it goes, in degrees. */
const FROM = 45,
  REACH = 270;
const point = (/** @type {number} */ share, /** @type {number} */ r) => {
  const a = ((FROM + REACH * share + 90) * Math.PI) / 180;
  return [r * Math.cos(a), r * Math.sin(a)].map((x) => x.toFixed(2));
};

/** @param {HTMLElement} stage @param {(pressure: number, settled: boolean) => void} turn */
export function gauge(stage, turn) {
  const [[x0, y0], [x1, y1]] = [point(0, 40), point(1, 40)];
  const tick = (/** @type {number} */ i) =>
    `M${point(i / 10, i % 5 ? 36 : 33).join(" ")}L${point(i / 10, 40).join(" ")}`;
  const ticks = Array.from({ length: 11 }, (_, i) => tick(i)).join("");
  stage.insertAdjacentHTML(
    "beforeend",
    `<svg class="gauge" viewBox="-50 -50 100 100" aria-hidden="true">` +
      `<circle r="48" class="face"/><path d="M${x0} ${y0}A40 40 0 1 1 ${x1} ${y1}${ticks}" class="dial"/>` +
      `<text x="-24" y="46">0</text><text x="24" y="46" class="top"></text>` +
      `<path d="M0 8L-2.5 0L0 -36L2.5 0z" class="needle"/><circle r="4" class="hub"/></svg>`,
  );
  const svg = /** @type {SVGSVGElement} */ (stage.lastElementChild);
  const part = (/** @type {string} */ name) =>
    /** @type {SVGElement} */ (svg.querySelector(name));
  const needle = part(".needle"),
    label = part(".top");
  let top = 1;
  const at = (
    /** @type {PointerEvent} */ event,
    /** @type {boolean} */ settled,
  ) => {
    const box = svg.getBoundingClientRect();
    const [x, y] = [
      event.clientX - box.left - box.width / 2,
      event.clientY - box.top - box.height / 2,
    ];
    // Clockwise from straight down.
    const angle = ((Math.atan2(y, x) * 180) / Math.PI + 270) % 360;
    const share = clamp((angle - FROM) / REACH, 0, 1);
    turn(Math.round(share * top * 1000) / 1000, settled);
  };
  dragging(svg, at);
  return {
    /** @param {number} pressure @param {number} highest what the end of the dial stands for */
    set(pressure, highest) {
      top = highest;
      const text = number(outside("pressure", top), 2);
      if (label.textContent !== text) label.textContent = text;
      needle.style.transform = `rotate(${FROM + REACH * Math.min(1, pressure / top) - 180}deg)`;
    },
  };
}
