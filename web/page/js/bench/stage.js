// The muscle in space with what belongs to its picture: the pull, a scale, the colours, the gauge.
import { choice } from "../controls.js";
import { viridis } from "../chart.js";
import { block, button, dragging, el } from "../dom.js";
import { muscle } from "../muscle.js";
import { playing } from "../play.js";
import { PRESSURE } from "../state.js";
import {
  asBuilt,
  clamp,
  evenly,
  modelPull,
  niceUp,
  number,
  outside,
  show,
  showLength,
  showPressure,
  showRatio,
} from "../units.js";
import { reach, viewOf } from "../view3d.js";
import { dimensions } from "./dimensions.js";
import { MOVES } from "./family.js";

/** What colours the muscle: field, name, kind of its unit. */
const SHOWN = /** @type {[string, string, string][]} */ ([
  ["max_stretch", "Largest stretch", ""],
  ["hoop_stretch", "Hoop stretch", ""],
  ["stress_hoop_mpa", "Hoop stress", "pressure"],
  ["stress_axial_mpa", "Axial stress", "pressure"],
  ["strand_tension_n_per_mm", "Tension of the strands per width", "N/mm"],
  ["strand_tension_n", "Tension of a strand", "force"],
  ["strand_angle_deg", "Angle of the strands", "angle"],
]);

/** @param {Store} store @param {HTMLElement} busy */
export function stageView(store, busy) {
  const said = el("p", { class: "say" }),
    scale = block("bar"),
    legend = block("legend");
  const stage = block("stage", said, scale, legend, busy);
  const dial = gauge(stage, (pressure, settled) => store.changed("p", pressure, settled));
  let scaled = 0,
    legendKey = "";
  /** As long as it says at every zoom. */
  const paintScale = () => {
    const perPixel = view.millimetresPerPixel;
    if (!store.shape || perPixel === scaled) return;
    scaled = perPixel;
    const step = niceUp(80 * perPixel * 0.6);
    const line = el("span", {
      style: `display:block;border:1px solid currentColor;border-top:0;height:5px;width:${step / perPixel}px`,
    });
    scale.replaceChildren(line, showLength(step, 3));
  };
  const drawn = () => {
    paintScale();
    measures.paint();
  };
  const view = viewOf(stage, { drawn, contract: contracting(store) });
  const measures = dimensions(stage, store, () => view);
  const colour = choice(
    "Colour",
    SHOWN.map(([name, text]) => [name, text]),
    store.wanted.show,
    (name) => store.look({ show: name }),
  );
  const cut = button("Cut open", () => store.look({ cut: store.wanted.cut ? "" : "1" }), {
    ariaPressed: false,
  });
  const pump = pumping(store),
    present = button("Present", () => stage.requestFullscreen(), {
      title: "The muscle and its numbers in the whole window; Escape ends it",
    });
  const measure = button(
    "Dimensions",
    () => {
      const on = measure.ariaPressed !== "true";
      measure.ariaPressed = String(on);
      measures.show(on);
    },
    { ariaPressed: "true" },
  );

  function paint() {
    const { shape, point } = store;
    if (!shape) return;
    const [name, words, kind] =
      SHOWN.find(([f]) => f === store.wanted.show && shape.arrays[f]) ?? SHOWN[0];
    const [low, high] = store.ranges?.[name] ?? reach(shape.arrays[name]);
    colour.set(name);
    const isCut = Boolean(store.wanted.cut);
    cut.ariaPressed = String(isCut);
    view.set(shape, { field: name, low, high, cut: isCut });
    if (!point) return;
    paintLegend(words, kind, low, high);
    said.replaceChildren(...sentence(shape, point));
    dial.set(point.pressure_mpa, Math.max(PRESSURE.high, point.pressure_mpa));
  }

  /** @param {string} words @param {string} kind @param {number} low @param {number} high */
  function paintLegend(words, kind, low, high) {
    const end = (/** @type {number} */ x) =>
      kind === "N/mm" ? `${number(x, 3)} N/mm` : kind ? show(kind, x, 3) : number(x, 3);
    const key = `${words} ${end(low)} ${end(high)}`;
    if (key === legendKey) return;
    legendKey = key;
    const ramp = evenly(0, 1, 9)
      .map((t) => viridis(t, 1))
      .join(",");
    const bar = el("i", { style: `background:linear-gradient(90deg,${ramp})` });
    legend.replaceChildren(
      el("span", words),
      bar,
      el("span", el("b", end(low)), el("b", end(high))),
    );
  }

  for (const event of /** @type {const} */ (["answer", "look", "ranges"])) store.on(event, paint);
  store.on("changed", pump.stop);
  return {
    stage,
    tools: block("row", colour.element, cut, measure, pump.button, present),
    /** In other units. */
    units() {
      scaled = 0;
      legendKey = "";
      paint();
      paintScale();
      measures.paint();
    },
  };
}

/**
 * The pull in words.
 * @param {NonNullable<Store["shape"]>} shape @param {NonNullable<Store["point"]>} point
 */
function sentence(shape, point) {
  if (point.slack)
    return [
      el("b", "Slack"),
      el("br"),
      `The muscle is slack: contracted by ${showRatio(shape.shape_contraction, 3)}, no pull.`,
    ];
  const at = `at ${showPressure(point.pressure_mpa, 3)} and ${showRatio(point.contraction, 3)}`;
  return [
    el("b", asBuilt(point)),
    el("br"),
    `as built${MOVES[point.predicted_direction ?? ""] ?? ""}; ${modelPull(point)}`,
    el("br"),
    at,
  ];
}

/** The end of the muscle is dragged. @param {Store} store */
function contracting(store) {
  let from = /** @type {number | undefined} */ (undefined);
  return (/** @type {number} */ share, /** @type {boolean} */ settled) => {
    from ??= Number(store.shape?.shape_contraction);
    const to = clamp(Math.round(1000 * (from + share)) / 1000, -0.1, 0.9);
    if (settled) from = undefined;
    store.changed("e", to, settled);
  };
}

/** The pressure rises, the muscle shortens, and both go back. @param {Store} store */
const pumping = (store) =>
  playing(
    "Pump",
    (share) => {
      const { p, e } = muscle,
        part = (/** @type {number} */ x) => clamp(x, 0, 1),
        t = 3 * share;
      store.ask(
        share < 1
          ? {
              pressure_mpa: p * (part(t) - part(t - 2)),
              contraction: e * (part(t - 1) - part(t - 2)),
            }
          : undefined,
      );
    },
    () => 4500,
    "Fills it, lets it shorten, and lets go",
  );

// The pressure gauge: dragged about its centre. The slider says the same to keyboards and screen
// readers.
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
  const part = (/** @type {string} */ name) => /** @type {SVGElement} */ (svg.querySelector(name));
  const needle = part(".needle"),
    label = part(".top");
  let top = 1;
  const at = (/** @type {PointerEvent} */ event, /** @type {boolean} */ settled) => {
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
