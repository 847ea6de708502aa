// Radii and strand angle along the muscle.
import { KINDS } from "../chart.js";
import { outside, unitName } from "../units.js";

/** @param {NonNullable<Store["shape"]>} shape @returns {Spec} */
export function along({ arrays, stations, across }) {
  /** Of the half muscle, that of the whole. @param {(j: number) => number} at @param {number} sign */
  const mirror = (at, sign) => {
    const half = Array.from({ length: stations }, (_, j) => at(j));
    return [
      ...half
        .slice(1)
        .reverse()
        .map((x) => sign * x),
      ...half,
    ];
  };
  const radius = (/** @type {number} */ i) =>
    mirror((j) => outside("length", arrays.r_mm[j * across + i]), 1);
  const x = mirror(
      (j) => outside("length", arrays.z_mm[j * across + across - 1]),
      -1,
    ),
    unit = unitName("length");
  return {
    x: `z from the middle [${unit}]`,
    y: `radius [${unit}], strand angle [°]`,
    series: [
      {
        name: "outer radius",
        end: "outer",
        x,
        y: radius(across - 1),
        colour: KINDS[0],
      },
      { name: "inner radius", end: "inner", x, y: radius(0), colour: KINDS[4] },
      {
        name: "strand angle",
        end: "angle",
        x,
        y: mirror((j) => arrays.strand_angle_deg[j], 1),
        colour: KINDS[1],
        dash: "dot",
      },
    ],
  };
}
