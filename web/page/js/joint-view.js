// The joint in numbers and curves: torques over the angle, what it can reach, and its numbers.
import { niceUp } from "./bench/round.js";
import { KINDS, pressureColour } from "./chart.js";
import { el, remark, termsOf } from "./dom.js";
import {
  interval,
  number,
  outside,
  showForce,
  showPressure,
  showRatio,
  unitName,
} from "./units.js";

/** @typedef {NonNullable<JointAnswer["map"]>} Reached */
/** @typedef {NonNullable<Reached["points"][number]>} Reach */

const ANGULAR = "angular-stiffness";
/** The angle under the pointer in degrees. @param {HTMLElement} stage @param {PointerEvent} event */
export function angleAt(stage, event) {
  const svg = stage.querySelector("svg"),
    matrix = svg?.getScreenCTM()?.inverse();
  if (!svg || !matrix) return undefined;
  const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix);
  return (Math.atan2(-at.y, at.x) * 180) / Math.PI;
}

/** Whether finite elements have answered yet. @param {string} model */
const badge = (model) =>
  el(
    "p",
    { class: model === "fe" ? "badge final" : "badge" },
    model === "fe" ? "Final: finite elements" : `First estimate: ${model}`,
  );

/** @param {JointPoint} point @param {string} which muscles these are */
export function numbersView(point, which) {
  const half = (/** @type {number | null | undefined} */ u) =>
    u ? ` ± ${number(u, 2)}` : "";
  const stiffness = (
    /** @type {JointPoint} */ {
      stiffness_nm_per_rad: k,
      stiffness_uncertainty_nm_per_rad: u,
    },
  ) =>
    `${number(outside(ANGULAR, k), 3)}${half(u && outside(ANGULAR, u))} ` +
    unitName(ANGULAR);
  const closed = [
    point.stiffness_shut_isothermal_nm_per_rad,
    point.stiffness_shut_adiabatic_nm_per_rad,
  ].flatMap((k) =>
    typeof k === "number" ? [number(outside(ANGULAR, k), 3)] : [],
  );
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
      ? [
          [
            "Stiffness, valves closed",
            `${closed.join(" to ")} ${unitName(ANGULAR)}`,
          ],
        ]
      : []),
    ["Pulls", `${pull(point.force_1_n)}, ${pull(point.force_2_n)}`],
    [
      "Contractions",
      `${showRatio(point.contraction_1, 3)}, ${showRatio(point.contraction_2, 3)}`,
    ],
  ]);
  const words = point.words
    ? ` The torque as built is ${built}, with its ± ${point.words}.`
    : "";
  return [
    badge(point.model),
    el(
      "dl",
      {},
      el("dt", { class: "head" }, "Equilibrium angle"),
      el(
        "dd",
        { class: "head" },
        `${number(point.angle_deg, 3)}${half(point.angle_uncertainty_deg)}°`,
      ),
      ...termsOf(rows),
    ),
    remark(`${which} Curves and map by universal.${words}`),
  ];
}

/**
 * Torques over the angle at pairs of pressures.
 * @param {Family} family @param {JointPoint | undefined} point @returns {Spec}
 */
export function torqueChart({ answer, angles, pairs }, point) {
  const series = pairs.map((pair, i) => {
    const rows = answer.points.slice(
      i * angles.length,
      (i + 1) * angles.length,
    );
    const name =
      pair.map((p) => number(outside("pressure", p), 3)).join(" | ") +
      " " +
      unitName("pressure");
    return {
      name,
      end: name,
      colour: KINDS[i],
      x: angles,
      y: rows.map((q) => outside("torque", q.torque_nm)),
    };
  });
  const marks = point
    ? [
        {
          x: point.angle_deg,
          y: outside("torque", point.torque_nm ?? 0),
          text: "required",
        },
      ]
    : [];
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
    const of = points.filter(
      (q) => Math.min(count - 1, Math.floor(mean(q) / step)) === i,
    );
    const name = `${number(i * step, 3)} to ${number((i + 1) * step, 3)} ${unit}`;
    const y = of.map((q) => outside(ANGULAR, q.stiffness_nm_per_rad));
    const x = of.map((q) => q.angle_deg),
      colour = pressureColour(i + 0.5, count);
    const legend = i ? name : `mean pressure ${name}`,
      z = of.map(mean);
    return {
      name,
      legend,
      mode: /** @type {const} */ ("markers"),
      colour,
      x,
      y,
      z,
    };
  });
  return {
    x: "rest angle φ [°]",
    y: `stiffness [${unitName(ANGULAR)}]`,
    z: `mean pressure [${unit}]`,
    series,
  };
}
