// The joint as people see it: arm and muscles, torques over the angle, what it can reach, and its numbers.
import { KINDS, isDark, viridis } from "./chart.js";
import { el } from "./dom.js";
import { number, outside, show, unitName } from "./units.js";

/** @typedef {import("../../types/commands").Commands["joint"]["answer"]} Answer */
/** A point as the page shows it. @typedef {any} Point */

/** A muscle of the drawing. @param {number} y @param {number} e its contraction @param {number} share of the supply's pressure @param {string} text */
function tube(y, e, share, text) {
  const short = 150 * (1 - (e ?? 0)), x0 = -190, fat = 6 + 26 * Math.max(0, e ?? 0) + 3 * share;
  const colour = isDark() ? viridis(0.25 + 0.75 * share, 1) : viridis(share);
  return `<path d="M${x0} ${y - 5}q8 ${-fat} ${short / 2} ${-fat}t${short / 2} ${fat}v10q-8 ${fat} ${-short / 2} ${fat}t${-short / 2} ${-fat}z" fill="${colour}" stroke="currentColor"/>`
    + `<path d="M${x0 + short} ${y}L0 ${y}" stroke="currentColor" fill="none"/><text x="${x0}" y="${y < 0 ? y - 26 : y + 38}" font-size="11" fill="currentColor">${text}</text>`;
}

/** The arm and its muscles as SVG. @param {Point | undefined} point @param {number} angle in degrees @param {number} supply */
export function armDrawing(point, angle, supply) {
  const R = 26, far = 120, phi = (angle * Math.PI) / 180, tip = [far * Math.cos(phi), -far * Math.sin(phi)];
  const label = (/** @type {1 | 2} */ i) => (point ? `${i}: ${show("pressure", point[`pressure_${i}_mpa`], 3)}` : String(i));
  const share = (/** @type {1 | 2} */ i) => (point?.[`pressure_${i}_mpa`] ?? 0) / supply;
  const muscles = tube(-R, point?.contraction_1, share(1), label(1)) + (point && point.pressure_2_mpa === undefined ? "" : tube(R, point?.contraction_2, share(2), label(2)));
  return `<svg class="section" viewBox="-210 -140 360 280"><g stroke-width="1.5">${muscles}<circle r="${R}" fill="none" stroke="currentColor"/>`
    + `<path d="M0 0L${tip[0]} ${tip[1]}" stroke="currentColor" stroke-width="7" stroke-linecap="round"/><circle cx="${tip[0]}" cy="${tip[1]}" r="8" fill="${KINDS[1]}"/></g></svg>`;
}

/** The angle under the pointer in degrees. @param {HTMLElement} stage @param {PointerEvent} event */
export function angleAt(stage, event) {
  const svg = stage.querySelector("svg"), matrix = svg?.getScreenCTM()?.inverse();
  if (!svg || !matrix) return undefined;
  const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix);
  return (Math.atan2(-at.y, at.x) * 180) / Math.PI;
}

/** @param {Point} point @param {string} which muscles these are */
export function numbersView(point, which) {
  const half = (/** @type {number | undefined} */ u) => (u ? ` ± ${number(u, 2)}` : "");
  const stiffness = (/** @type {Point} */ { stiffness_nm_per_rad: k, stiffness_uncertainty_nm_per_rad: u }) => `${number(outside("angular-stiffness", k), 3)}${half(u && outside("angular-stiffness", u))} ${unitName("angular-stiffness")}`;
  const rows = /** @type {[string, string][]} */ ([
    ["pressure of muscle 1", show("pressure", point.pressure_1_mpa, 3)], ["pressure of muscle 2", show("pressure", point.pressure_2_mpa, 3)],
    ["stiffness", stiffness(point)], ["pulls", `${show("force", point.force_1_n, 3)}, ${show("force", point.force_2_n, 3)}`],
    ["contractions", `${show("ratio", point.contraction_1, 3)}, ${show("ratio", point.contraction_2, 3)}`],
  ]);
  const words = point.words ? ` The ± of the torque ${point.words}.` : "";
  return [
    el("dl", {}, el("dt", { class: "head" }, "rests at"), el("dd", { class: "head" }, `${number(point.angle_deg, 3)}${half(point.angle_uncertainty_deg)}°`), ...rows.flatMap(([name, value]) => [el("dt", {}, name), el("dd", {}, value)])),
    el("p", { class: "small soft" }, `${which} Pressures by ${point.model}; curves and map by universal.${words}`),
  ];
}

/** Torques over the angle at pairs of pressures. @param {{ answer: any, angles: number[], pairs: number[][] }} family @param {Point | undefined} point @returns {import("./chart.js").Spec} */
export function torqueChart({ answer, angles, pairs }, point) {
  const series = pairs.map((pair, i) => {
    const rows = answer.points.slice(i * angles.length, (i + 1) * angles.length);
    const name = pair.map((p) => number(outside("pressure", p), 3)).join(" | ") + " " + unitName("pressure");
    return { name, end: name, colour: KINDS[i], x: angles, y: rows.map((/** @type {any} */ q) => outside("torque", q.torque_nm)) };
  });
  const marks = point ? [{ x: point.angle_deg, y: outside("torque", point.torque_nm ?? 0), text: "required" }] : [];
  return { x: "angle φ [°]", y: `torque [${unitName("torque")}]`, yaxis: {}, series, marks };
}

/** Rest angles and stiffnesses that it reaches. @param {any} map @returns {import("./chart.js").Spec} */
export function reachChart(map) {
  const points = map.points.filter(Boolean), unit = unitName("pressure");
  const mean = (/** @type {any} */ q) => outside("pressure", q.pressures_mpa.reduce((/** @type {number} */ a, /** @type {number} */ b) => a + b, 0) / q.pressures_mpa.length);
  const of = (/** @type {string} */ key) => points.map((/** @type {any} */ q) => q[key]);
  const marker = { size: 5, color: points.map(mean), colorscale: "Viridis", colorbar: { title: { text: `mean pressure [${unit}]` } } };
  return {
    x: "rest angle φ [°]", y: `stiffness [${unitName("angular-stiffness")}]`, z: `mean pressure [${unit}]`, series: [],
    data: [{ type: "scatter", name: "reached", mode: "markers", showlegend: false, x: of("angle_deg"), y: of("stiffness_nm_per_rad").map((/** @type {number} */ k) => outside("angular-stiffness", k)), marker, hovertemplate: `%{x:.3g}°, %{y:.3g} ${unitName("angular-stiffness")}<extra></extra>` }],
  };
}
