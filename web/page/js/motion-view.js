// A motion as people see it: pressures, the way of muscle or joint over time, and its figures.
import { KINDS } from "./chart.js";
import { table } from "./form.js";
import {
  number,
  outside,
  ratioAxis,
  showPressure,
  showRatio,
  unitName,
} from "./units.js";

/** Whether it is a joint's. @param {Run} run */
export const isJoint = (run) => Boolean(run.series.angle_deg);
/** Series of pressures of a muscle or of a joint: what each is called, and its colour; commands are dotted. */
const PRESSURES = /** @type {const} */ ([
  ["pressure_mpa", "muscle", 0],
  ["command", "command", 6],
  ["pressure_1_mpa", "muscle 1", 0],
  ["command_1", "command 1", 6],
  ["pressure_2_mpa", "muscle 2", 1],
  ["command_2", "command 2", 6],
]);

/** @param {Run} run @returns {Spec} */
export const pressureChart = ({ series: s }) => ({
  x: "time [s]",
  y: `pressure [${unitName("pressure")}]`,
  series: PRESSURES.flatMap(([key, name, colour]) =>
    s[key]
      ? [
          {
            name,
            x: s.time_s,
            y: s[key].map((p) => outside("pressure", p)),
            colour: KINDS[colour],
            end: name,
            dash: colour === 6 ? "dot" : undefined,
          },
        ]
      : [],
  ),
});

/** @param {Run} run @returns {Spec} */
export function wayChart(run) {
  const { series: s } = run;
  if (isJoint(run))
    return {
      x: "time [s]",
      y: "angle φ [°]",
      yaxis: {},
      series: [
        { name: "angle", x: s.time_s, y: s.angle_deg ?? [], colour: KINDS[1] },
      ],
    };
  return {
    x: "time [s]",
    y: ratioAxis,
    series: [
      {
        name: "contraction",
        x: s.time_s,
        y: (s.contraction ?? []).map((e) => 100 * e),
        colour: KINDS[1],
      },
    ],
  };
}

/** Largest speed, of the motion itself. @param {Run} run */
function speed(run) {
  if (isJoint(run))
    return `${number(run.largest_velocity_deg_per_s ?? 0, 3)} °/s`;
  const inside = run.largest_velocity_mm_per_s ?? 0;
  return `${number(outside("length", inside), 3)} ${unitName("length")}/s`;
}

/** @param {Run} run */
export function figures(run) {
  const time = (/** @type {number | null | undefined} */ x) =>
    x == null ? "–" : `${number(x, 3)} s`;
  return table(
    ["", ""],
    [
      ["Rise time, 10–90 %", time(run.rise_time_s)],
      ["Settling time, 2 %", time(run.settling_time_s)],
      ["Overshoot", showRatio(run.overshoot, 3)],
      ["Filled within 2 % after", time(run.fill_time_s)],
      run.liquid_volume_mm3 == null
        ? [
            "Air from the supply",
            `${number(run.air_normal_litres, 3)} normal L`,
          ]
        : ["Liquid pushed in", `${number(run.liquid_volume_mm3 / 1000, 4)} mL`],
      ["Largest speed", speed(run)],
      ["Largest power", `${number(run.largest_power_w, 3)} W`],
    ],
    { label: "figures of the step" },
  );
}

/** The state at a place of the record, in a line. @param {Run} run @param {number} i */
export function stateLine(run, i) {
  const { series: s } = run;
  const both = [s.pressure_1_mpa, s.pressure_2_mpa].flatMap((p) =>
    p ? [showPressure(p[i], 3)] : [],
  );
  if (isJoint(run))
    return `${number(s.angle_deg?.[i], 3)}°, ${both.join(" and ")}`;
  return `${showPressure(s.pressure_mpa?.[i], 3)}, ${showRatio(s.contraction?.[i], 3)}`;
}

/** The muscle at a place of the record: that of the page, or muscle 1 of a joint. @param {Run} run @param {number} i */
export function stateAt({ series: s }, i) {
  const [p, e] = [
    s.pressure_mpa ?? s.pressure_1_mpa ?? [],
    s.contraction ?? s.contraction_1 ?? [],
  ];
  return { pressure_mpa: Math.max(0, p[i]), contraction: e[i] };
}
