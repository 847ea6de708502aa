// The joint to scale: pulley, both muscles as long and as thick as they are, the arm in its range, and the torque that
// it holds.
import { niceUp } from "./bench/round.js";
import { body, contracted } from "./body.js";
import { KINDS, pressureColour } from "./chart.js";
import {
  number,
  outside,
  showLength,
  showPressure,
  showRatio,
  unitName,
} from "./units.js";

/**
 * Radius, limits and contraction at the neutral angle of the joint; length, diameter and braid angle of its muscle.
 * @typedef {{ r: number, low: number, high: number, e0: number, length: number, diameter: number,
 *   angle: number }} Measures
 */

const at = (/** @type {number} */ radius, /** @type {number} */ degrees) =>
  `${(radius * Math.cos((degrees * Math.PI) / 180)).toFixed(1)} ` +
  `${(-radius * Math.sin((degrees * Math.PI) / 180)).toFixed(1)}`;

/**
 * A muscle of the drawing: its rubber has the colour of its pressure.
 * @param {Measures} m @param {1 | 2} which @param {JointPoint | undefined} point @param {number} supply @param {number} left
 */
function tube(m, which, point, supply, left) {
  const y = which === 1 ? -m.r : m.r,
    e = point?.[`contraction_${which}`] ?? m.e0,
    p = point?.[`pressure_${which}_mpa`];
  const length = m.length * (1 - e),
    now = contracted(m.diameter, m.angle, e),
    fill = pressureColour(p ?? 0, supply),
    b = Math.max(m.diameter, now.bulged) / 2,
    thread = `color-mix(in srgb, ${fill} 62%, #fff)`;
  const text =
    p === undefined
      ? String(which)
      : `${which}: ${showPressure(p, 3)}, ${showRatio(e, 3)}`;
  const place =
    which === 1 ? y - b - 0.02 * m.length : y + b + 0.055 * m.length;
  return (
    `<path d="M${left + length} ${y}H0" class="tendon"/><g transform="translate(${left} ${y})" class="woven">` +
    `${body({ length, diameter: m.diameter, ...now, fill, thread })}</g>` +
    `<text x="${left}" y="${place}">${text}</text>`
  );
}

/**
 * The arm and its muscles as SVG; its axis is the origin.
 * @param {JointPoint | undefined} point @param {number} angle in degrees @param {number} supply @param {Measures} m
 */
export function jointDrawing(point, angle, supply, m) {
  const arm = 0.45 * m.length,
    most = Math.max(Math.abs(m.low), Math.abs(m.high)),
    size = m.length / 26;
  const left = -(
    m.length * (1 - m.e0) +
    m.r * ((most * Math.PI) / 180) +
    m.diameter
  );
  const width = arm * 1.25 - left + 0.2 * m.length;
  const tall =
    2 *
    Math.max(
      arm * Math.sin((Math.min(90, most) * Math.PI) / 180) + 0.1 * m.length,
      m.r + 1.6 * m.diameter,
    );
  const range =
    `<path d="M0 0L${at(arm, m.low)}A${arm} ${arm} 0 ${m.high - m.low > 180 ? 1 : 0} 0 ${at(arm, m.high)}Z" ` +
    'class="range"/>';
  const second = !point || point.pressure_2_mpa !== undefined;
  const muscles =
    tube(m, 1, point, supply, left) +
    (second ? tube(m, 2, point, supply, left) : "");
  const bar = niceUp(0.13 * m.length),
    scale =
      `<path d="M${left} ${tall / 2 - 0.03 * m.length}v${0.015 * m.length}` +
      `h${bar}v${-0.015 * m.length}" fill="none" class="line"/><text x="${left + bar + 4}" ` +
      `y="${tall / 2 - 0.01 * m.length}">${showLength(bar, 2)}</text>`;
  const wall = `<path d="M${left - 0.5 * m.diameter} ${-m.r - m.diameter}V${m.r + m.diameter}" class="wall"/>`;
  const legend =
    `<text x="${arm * 0.2}" y="${-tall / 2 + 0.05 * m.length}">colour: pressure, 0 to ` +
    `${showPressure(supply, 3)}</text>`;
  return (
    `<svg class="section joint" viewBox="${left - m.diameter} ${-tall / 2} ${width} ${tall}" ` +
    `font-size="${size}">${range}${wall}${muscles}<circle r="${m.r}" class="pulley"/>` +
    `<path d="M0 0L${at(arm, angle)}" class="arm" stroke-width="${0.035 * m.length}"/><circle ` +
    `r="${0.02 * m.length}" fill="currentColor"/>` +
    `<circle cx="${at(arm, angle).replace(" ", '" cy="')}" r="${0.035 * m.length}" fill="${KINDS[1]}"/>` +
    `${load(point, angle, arm, size)}${scale}${legend}</svg>`
  );
}

/**
 * The torque that the joint holds against its load, as an arrow about the axis.
 * @param {JointPoint | undefined} point @param {number} angle @param {number} arm @param {number} size
 */
function load(point, angle, arm, size) {
  const torque = Number(point?.torque_nm ?? 0);
  if (Math.abs(torque) < 1e-6) return "";
  const r = 0.6 * arm,
    sweep = Math.sign(torque) * 28,
    tip = angle + sweep,
    back = tip - Math.sign(torque) * 5;
  const text = `${number(outside("torque", torque), 3)} ${unitName("torque")}`;
  return (
    `<path d="M${at(r, angle)}A${r} ${r} 0 0 ${torque > 0 ? 0 : 1} ${at(r, tip)}M${at(0.94 * r, back)}` +
    `L${at(r, tip)}L${at(1.06 * r, back)}" class="load"/>` +
    `<text x="${at(1.1 * r, tip).replace(" ", '" y="')}" font-size="${size}">${text}</text>`
  );
}
