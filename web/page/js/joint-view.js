// The joint in numbers and curves: torques over the angle, what it can reach, and its numbers.
import { KINDS, shade } from "./chart.js";
import { el, remark, termsOf } from "./dom.js";
import {
  interval,
  niceUp,
  number,
  outside,
  show,
  showForce,
  showLength,
  showPressure,
  showRatio,
  unitName,
} from "./units.js";
import { body, contracted } from "./body.js";
import { path, svg, words } from "./svg.js";

/** @typedef {NonNullable<JointAnswer["map"]>} Reached */
/** @typedef {NonNullable<Reached["points"][number]>} Reach */

const ANGULAR = "angular-stiffness";
/**
 * The angle under the pointer in degrees. @param {HTMLElement} stage @param {PointerEvent} event
 */
export function angleAt(stage, event) {
  const svg = stage.querySelector("svg"),
    matrix = svg?.getScreenCTM()?.inverse();
  if (!svg || !matrix) return undefined;
  const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix);
  return (Math.atan2(-at.y, at.x) * 180) / Math.PI;
}

/** @param {JointPoint} point @param {string} which muscles these are */
export function numbersView(point, which) {
  const half = (/** @type {number | null | undefined} */ u) => (u ? ` ± ${number(u, 2)}` : "");
  const stiffness = (
    /** @type {JointPoint} */ { stiffness_nm_per_rad: k, stiffness_uncertainty_nm_per_rad: u },
  ) => `${number(outside(ANGULAR, k), 3)}${half(u && outside(ANGULAR, u))} ` + unitName(ANGULAR);
  const closed = [
    point.stiffness_shut_isothermal_nm_per_rad,
    point.stiffness_shut_adiabatic_nm_per_rad,
  ].flatMap((k) => (typeof k === "number" ? [number(outside(ANGULAR, k), 3)] : []));
  const built = interval("torque", [
    point.predicted_nm,
    point.predicted_low_nm,
    point.predicted_high_nm,
  ]);
  // Less than a milligram's weight is what the solution leaves of a slack muscle.
  const pull = (/** @type {number | null | undefined} */ n) =>
    showForce(Math.abs(Number(n)) < 1e-5 ? 0 : n, 3);
  const rows = /** @type {[string, string][]} */ ([
    ["Pressure 1", showPressure(point.pressure_1_mpa, 3)],
    ["Pressure 2", showPressure(point.pressure_2_mpa, 3)],
    ["Stiffness", stiffness(point)],
    ...(closed.length
      ? [["Stiffness, valves closed", `${closed.join(" to ")} ${unitName(ANGULAR)}`]]
      : []),
    ["Pulls", `${pull(point.force_1_n)}, ${pull(point.force_2_n)}`],
    ["Contractions", `${showRatio(point.contraction_1, 3)}, ${showRatio(point.contraction_2, 3)}`],
  ]);
  const words = point.words ? ` The torque as built is ${built}, with its ± ${point.words}.` : "";
  return [
    remark(
      point.model === "fe" ? "Final: finite elements" : "First estimate: a formula (universal)",
    ),
    el(
      "dl",
      el("dt", { class: "head" }, "Equilibrium angle"),
      el(
        "dd",
        { class: "head" },
        `${number(point.angle_deg, 3)}${half(point.angle_uncertainty_deg)}°`,
      ),
      ...termsOf(rows),
    ),
    remark(
      `${which} Curves and map by the formula universal, which was fitted to finite elements.${words}`,
    ),
  ];
}

/**
 * Torques over the angle at pairs of pressures, with the point and what was asked.
 * @param {Family} family @param {JointPoint | undefined} point
 * @param {{ angle: number, torque: number } | undefined} asked @returns {Spec}
 */
export function torqueChart({ answer, angles, pairs }, point, asked) {
  const series = pairs.map((pair, i) => {
    const rows = answer.points.slice(i * angles.length, (i + 1) * angles.length);
    const name =
      pair.map((p) => number(outside("pressure", p), 3)).join(" | ") + " " + unitName("pressure");
    return {
      name,
      end: name,
      colour: KINDS[i],
      x: angles,
      y: rows.map((q) => outside("torque", q.torque_nm)),
    };
  });
  const marks = [
    ...(point
      ? [{ angle: point.angle_deg, torque: point.torque_nm ?? 0, text: "this state" }]
      : []),
    ...(asked ? [{ ...asked, text: "asked" }] : []),
  ].map(({ angle, torque, text }) => ({ x: angle, y: outside("torque", torque), text }));
  return {
    x: "angle φ [°]",
    y: `torque [${unitName("torque")}]`,
    yaxis: {},
    series: [
      // Between the pairs of pressures that pull hardest to either side.
      {
        name: "reachable torque",
        band: true,
        colour: KINDS[0],
        x: [...angles, ...angles.toReversed()],
        y: [...series[0].y, ...series[series.length - 1].y.toReversed()],
      },
      ...series,
    ],
    marks,
  };
}

/** Rest angles and stiffnesses that it reaches. @param {Reached} map @returns {Spec} */
export function reachChart(map) {
  const points = map.points.filter((q) => q !== null),
    unit = unitName("pressure");

  const mean = (/** @type {Reach} */ { pressures_mpa: list }) =>
    outside("pressure", list.reduce((a, b) => a + b, 0) / list.length);
  const most = Math.max(1e-9, ...points.map(mean)),
    step = niceUp(most / 6);
  const count = Math.max(1, Math.ceil(most / step - 1e-9));
  const series = Array.from({ length: count }, (_, i) => {
    const of = points.filter((q) => Math.min(count - 1, Math.floor(mean(q) / step)) === i);
    const name = `${number(i * step, 3)} to ${number((i + 1) * step, 3)} ${unit}`;
    const y = of.map((q) => outside(ANGULAR, q.stiffness_nm_per_rad));
    const x = of.map((q) => q.angle_deg),
      colour = shade((i + 0.5) / count);
    const legend = i ? name : `mean pressure ${name}`;
    return { name, legend, mode: /** @type {const} */ ("markers"), colour, x, y };
  });
  return { x: "rest angle φ [°]", y: `stiffness [${unitName(ANGULAR)}]`, series };
}

// The joint to scale: pulley, both muscles as long and as thick as they are, the arm in its range,
// and the torque that it holds.
/**
 * Radius, limits and contraction at the neutral angle of the joint; length, diameter and braid
 * angle of its muscle.
 * @typedef {{ r: number, low: number, high: number, e0: number, length: number, diameter: number,
 *   angle: number }} Measures
 */

const at = (/** @type {number} */ radius, /** @type {number} */ degrees) =>
  `${(radius * Math.cos((degrees * Math.PI) / 180)).toFixed(1)} ` +
  `${(-radius * Math.sin((degrees * Math.PI) / 180)).toFixed(1)}`;

/**
 * A muscle of the drawing: its rubber has the colour of its pressure.
 * @param {Measures} m @param {1 | 2} which @param {JointPoint | undefined} point
 * @param {number} supply @param {number} left
 */
function tube(m, which, point, supply, left) {
  const y = which === 1 ? -m.r : m.r,
    e = point?.[`contraction_${which}`] ?? m.e0,
    p = point?.[`pressure_${which}_mpa`];
  const length = m.length * (1 - e),
    now = contracted(m.diameter, m.angle, e),
    fill = shade((p ?? 0) / supply),
    thread = `color-mix(in srgb, ${fill} 62%, #fff)`,
    b = Math.max(m.diameter, now.bulged) / 2;
  const text =
    p === undefined ? String(which) : `${which}: ${showPressure(p, 3)}, ${showRatio(e, 3)}`;
  return [
    path(`M${left + length} ${y}H0`, "tendon"),
    svg(
      "g",
      { transform: `translate(${left} ${y})`, class: "woven" },
      body({ length, diameter: m.diameter, ...now, fill, thread }),
    ),
    words(text, left, which === 1 ? y - b - 0.02 * m.length : y + b + 0.055 * m.length),
  ];
}

/**
 * The arm and its muscles as SVG; its axis is the origin.
 * @param {JointPoint | undefined} point @param {number} angle in degrees @param {number} supply
 * @param {Measures} m
 */
export function jointDrawing(point, angle, supply, m) {
  const arm = 0.45 * m.length,
    most = Math.max(Math.abs(m.low), Math.abs(m.high)),
    [x, y] = at(arm, angle).split(" "),
    left = -(m.length * (1 - m.e0) + m.r * ((most * Math.PI) / 180) + m.diameter);
  const width = arm * 1.25 - left + 0.2 * m.length;
  const rise = arm * Math.sin((Math.min(90, most) * Math.PI) / 180) + 0.1 * m.length,
    tall = 2 * Math.max(rise, m.r + 1.6 * m.diameter);
  const bar = niceUp(0.13 * m.length),
    tick = 0.015 * m.length;
  const second = !point || point.pressure_2_mpa !== undefined;
  return svg(
    "svg",
    {
      class: "section joint",
      viewBox: `${left - m.diameter} ${-tall / 2} ${width} ${tall}`,
      "font-size": m.length / (innerWidth < 700 ? 15 : 26),
    },
    path(
      `M0 0L${at(arm, m.low)}A${arm} ${arm} 0 ${m.high - m.low > 180 ? 1 : 0} 0 ${at(arm, m.high)}Z`,
      "range",
    ),
    path(`M${left - 0.5 * m.diameter} ${-m.r - m.diameter}V${m.r + m.diameter}`, "wall"),
    ...tube(m, 1, point, supply, left),
    ...(second ? tube(m, 2, point, supply, left) : []),
    svg("circle", { r: m.r, class: "pulley" }),
    svg("path", { d: `M0 0L${x} ${y}`, class: "arm", "stroke-width": 0.035 * m.length }),
    svg("circle", { r: 0.02 * m.length, fill: "currentColor" }),
    svg("circle", { cx: x, cy: y, r: 0.035 * m.length, fill: KINDS[1] }),
    ...load(point, angle, arm),
    path(`M${left} ${tall / 2 - 2 * tick}v${tick}h${bar}v${-tick}`, "line"),
    words(showLength(bar, 2), left + bar + 4, tall / 2 - 0.67 * tick),
    words(
      `colour: pressure, 0 to ${showPressure(supply, 3)}`,
      arm * 1.2,
      -tall / 2 + 0.07 * m.length,
      "end",
    ),
  );
}

/**
 * The torque that the joint holds against its load, as an arrow about the axis.
 * @param {JointPoint | undefined} point @param {number} angle @param {number} arm
 */
function load(point, angle, arm) {
  const torque = Number(point?.torque_nm ?? 0),
    way = Math.sign(torque);
  if (Math.abs(torque) < 1e-6) return [];
  const r = 0.6 * arm,
    tip = angle + 28 * way,
    back = tip - 5 * way,
    [x, y] = at(1.1 * r, tip)
      .split(" ")
      .map(Number);
  return [
    path(
      `M${at(r, angle)}A${r} ${r} 0 0 ${way > 0 ? 0 : 1} ${at(r, tip)}M${at(0.94 * r, back)}` +
        `L${at(r, tip)}L${at(1.06 * r, back)}`,
      "load",
    ),
    words(show("torque", torque, 3), x, y),
  ];
}
