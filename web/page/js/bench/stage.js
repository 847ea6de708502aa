// The muscle in space with what belongs to its picture: the pull, a scale, the colours.
import { choice } from "../controls.js";
import { viridis } from "../chart.js";
import { block, button, el } from "../dom.js";
import {
  asBuilt,
  clamp,
  evenly,
  inside,
  modelPull,
  niceUp,
  outside,
  show,
  showLength,
  showPressure,
  showRatio,
} from "../units.js";
import { watch } from "../watch.js";
import { reach, viewOf } from "../view3d.js";
import { dimensions } from "./dimensions.js";
import { MOVES } from "./family.js";

/** What colours the muscle: field, name, kind of its unit. */
/** @type {[string, string, string][]} */ const SHOWN = [
  ["max_stretch", "Largest stretch", "number"],
  ["hoop_stretch", "Hoop stretch", "number"],
  ["stress_hoop_mpa", "Hoop stress", "pressure"],
  ["stress_axial_mpa", "Axial stress", "pressure"],
  ["strand_tension_n_per_mm", "Tension of the strands per width", "N/mm"],
  ["strand_tension_n", "Tension of a strand", "force"],
  ["strand_angle_deg", "Angle of the strands", "angle"],
];

/** @param {Store} store @param {HTMLElement} busy */
export function stageView(store, busy) {
  const said = el("p", { class: "say" }),
    scale = block("bar"),
    legend = block("legend");
  const stage = block("stage", said, scale, legend, busy);
  /** As long as it says at every zoom. */
  const paintScale = () => {
    const perPixel = view.millimetresPerPixel,
      step = inside("length", niceUp(outside("length", 48 * perPixel)));
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
    (name) => store.look({ show: name }),
  );
  const cut = button("Cut open", () => store.look({ cut: store.wanted.value.cut ? "" : "1" }), {
    ariaPressed: false,
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

  watch(() => {
    const shape = store.shape.value,
      point = store.point.value,
      wanted = store.wanted.value;
    if (!shape) return;
    const [name, words, kind] =
      SHOWN.find(([f]) => f === wanted.show && shape.arrays[f]) ?? SHOWN[0];
    const here = reach(shape.arrays[name]),
      ends = store.ranges.value?.[name] ?? here,
      [low, high] = ends;
    colour.set(name);
    cut.ariaPressed = String(Boolean(wanted.cut));
    view.set(shape, { field: name, low, high, cut: Boolean(wanted.cut) });
    if (!point) return;
    paintLegend(words, kind, here, ends);
    said.replaceChildren(...sentence(shape, point));
  });

  /**
   * The range of this state, and that of the colours.
   * @param {string} words @param {string} kind @param {number[]} here @param {number[]} ends
   */
  function paintLegend(words, kind, here, ends) {
    const text = (/** @type {number} */ x) => show(kind, x, 3);
    const ramp = evenly(0, 1, 9)
      .map((t) => viridis(t, 1))
      .join(",");
    const bar = el("i", { style: `background:linear-gradient(90deg,${ramp})` });
    legend.replaceChildren(
      el("span", `${words}: now ${here.map(text).join(" to ")}`),
      bar,
      el("span", ...ends.map((end) => el("b", text(end)))),
    );
  }

  return { stage, tools: [colour.element, cut, measure] };
}

/**
 * The pull in words.
 * @param {NonNullable<Store["shape"]["value"]>} shape
 * @param {NonNullable<Store["point"]["value"]>} point
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
  /** @type {number | undefined} */ let from = undefined;
  return (/** @type {number} */ share, /** @type {boolean} */ settled) => {
    from ??= Number(store.shape.value?.shape_contraction);
    const to = clamp(Math.round(1000 * (from + share)) / 1000, -0.1, 0.9);
    if (settled) from = undefined;
    store.changed("e", to, settled);
  };
}
