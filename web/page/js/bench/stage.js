// The muscle in space with what belongs to its picture: the pull, a scale, the colours, the gauge.
import { choice } from "../controls.js";
import { viridis } from "../chart.js";
import { block, button, el } from "../dom.js";
import { gauge } from "../gauge.js";
import { muscle } from "../muscle.js";
import { playing } from "../play.js";
import { PRESSURE } from "../state.js";
import {
  asBuilt,
  clamp,
  evenly,
  modelPull,
  number,
  show,
  showLength,
  showPressure,
  showRatio,
} from "../units.js";
import { View, reach } from "../view3d.js";
import { dimensions } from "./dimensions.js";
import { MOVES } from "./family.js";
import { niceUp } from "./round.js";

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
  const dial = gauge(stage, (pressure, settled) =>
    store.changed("p", pressure, settled),
  );
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
  const view = new View(stage, { drawn, contract: contracting(store) });
  const measures = dimensions(stage, store, () => view);
  const colour = choice(
    "Colour",
    SHOWN.map(([name, text]) => [name, text]),
    store.wanted.show,
    (name) => store.look({ show: name }),
  );
  const cut = button(
    "Cut open",
    () => store.look({ cut: store.wanted.cut ? "" : "1" }),
    { "aria-pressed": false },
  );
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
    { "aria-pressed": "true" },
  );

  function paint() {
    const { shape, point } = store;
    if (!shape) return;
    const [name, words, kind] =
      SHOWN.find(([f]) => f === store.wanted.show && shape.arrays[f]) ??
      SHOWN[0];
    const [low, high] = store.ranges?.[name] ?? reach(shape.arrays[name]);
    colour.set(name);
    view.cut = Boolean(store.wanted.cut);
    cut.ariaPressed = String(view.cut);
    view.set(shape, { field: name, low, high });
    if (!point) return;
    paintLegend(words, kind, low, high);
    said.replaceChildren(...sentence(shape, point));
    dial.set(point.pressure_mpa, Math.max(PRESSURE.high, point.pressure_mpa));
  }

  /** @param {string} words @param {string} kind @param {number} low @param {number} high */
  function paintLegend(words, kind, low, high) {
    const end = (/** @type {number} */ x) =>
      kind === "N/mm"
        ? `${number(x, 3)} N/mm`
        : kind
          ? show(kind, x, 3)
          : number(x, 3);
    const key = `${words} ${end(low)} ${end(high)}`;
    if (key === legendKey) return;
    legendKey = key;
    const ramp = evenly(0, 1, 9)
      .map((t) => viridis(t, 1))
      .join(",");
    const bar = el("i", { style: `background:linear-gradient(90deg,${ramp})` });
    legend.replaceChildren(
      el("span", {}, words),
      bar,
      el("span", {}, el("b", {}, end(low)), el("b", {}, end(high))),
    );
  }

  for (const event of /** @type {const} */ (["answer", "look", "ranges"]))
    store.on(event, paint);
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

/** The pull in words. @param {NonNullable<Store["shape"]>} shape @param {NonNullable<Store["point"]>} point */
function sentence(shape, point) {
  if (point.slack)
    return [
      el("b", {}, "Slack"),
      el("br"),
      `The muscle is slack: contracted by ${showRatio(shape.shape_contraction, 3)}, no pull.`,
    ];
  const at = `at ${showPressure(point.pressure_mpa, 3)} and ${showRatio(point.contraction, 3)}`;
  return [
    el("b", {}, asBuilt(point)),
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
