// Quantities as people read them. Inside everything is in mm, MPa, N, degrees; factors come from the engine.
import { engine } from "./ask.js";

/** @typedef {import("../../types/commands").units_answer.Answer["kinds"][number]["kind"]} Kind */
/** @type {Map<string, { expectation: string, units: { name: string, multiply: number, divide: number }[] }>} */
const kinds = new Map();
/** Units to choose from by a click; the first is the usual one. @type {Record<string, string[]>} */
const CHOICES = { pressure: ["bar", "kPa", "MPa", "psi"], force: ["N", "lbf"], length: ["mm", "in"], ratio: ["%"], angle: ["deg"], torque: ["N m"], "angular-stiffness": ["N m/rad"] };
/** @type {Record<string, string>} */
const chosen = Object.fromEntries(Object.entries(CHOICES).map(([kind, list]) => [kind, list[0]]));
/** @type {Set<() => void>} */
const listeners = new Set();

export async function loadUnits() {
  const answer = await engine().ask("units", {}, { lane: "state" });
  for (const { kind, expectation, units } of answer.kinds) kinds.set(kind, { expectation, units });
}

/** @param {string} kind */
export const expectation = (kind) => kinds.get(kind)?.expectation ?? "";
/** Names of its units. @param {string} kind */
export const unitsOf = (kind) => (kinds.get(kind)?.units ?? []).map((u) => u.name);
/** @param {string} kind */
export const unitName = (kind) => (kind === "angle" ? "°" : chosen[kind] ?? kinds.get(kind)?.units.find((u) => u.multiply === u.divide)?.name ?? "");

/** @param {string} kind */
function factor(kind) {
  const unit = kinds.get(kind)?.units.find((u) => u.name === chosen[kind]);
  return unit ?? { multiply: 1, divide: 1 };
}
/** A value inside in the shown unit. @param {string} kind @param {number} inside */
export const outside = (kind, inside) => { const u = factor(kind); return (inside * u.multiply) / u.divide; };
/** The other way. @param {string} kind @param {number} shown */
export const inside = (kind, shown) => { const u = factor(kind); return (shown * u.divide) / u.multiply; };

/** A number to so many significant digits, without an exponent where it is short without. @param {number | null | undefined} v */
export function number(v, digits = 4) {
  if (v === null || v === undefined || !Number.isFinite(v)) return "–";
  if (v === 0) return "0";
  const size = Math.floor(Math.log10(Math.abs(v)));
  if (size < -5 || size > 14) return v.toExponential(digits - 1);
  const text = String(Number(v.toFixed(Math.min(20, Math.max(0, digits - 1 - size)))));
  return text.replace("-", "−");
}
/** `2.5 bar`. @param {string} kind @param {number | null | undefined} value */
export const show = (kind, value, digits = 4) => (value === null || value === undefined ? "–" : `${number(outside(kind, value), digits)}${kind === "angle" ? "°" : " " + unitName(kind)}`);
/** As it is typed and stands in an address: `2.5bar`. @param {string} kind @param {number} value */
export function typed(kind, value) {
  const unit = kind === "angle" ? "deg" : unitName(kind);
  const bare = ["length", "angle", "force"].includes(kind) && ["mm", "deg", "N"].includes(unit);
  return number(outside(kind, value), 6).replace("−", "-") + (bare ? "" : unit.replace(" ", ""));
}

/** A pull to the digits that its ± leaves. @param {string} kind @param {number} value @param {number | null | undefined} half */
export function withUncertainty(kind, value, half) {
  if (!half) return show(kind, value);
  const [v, u] = [outside(kind, value), outside(kind, half)];
  const decimals = Math.min(8, Math.max(0, 1 - Math.floor(Math.log10(u))));
  return `${v.toFixed(decimals).replace("-", "−")} ± ${u.toFixed(decimals)} ${unitName(kind)}`;
}

/** Changes a unit everywhere, to the next one or to one by name. @param {string} kind @param {string} [name] */
export function changeUnit(kind, name) {
  const list = CHOICES[kind];
  if (!list) return;
  const next = name ?? list[(list.indexOf(chosen[kind]) + 1) % list.length];
  if (!list.includes(next)) return;
  chosen[kind] = next;
  listeners.forEach((tell) => tell());
}
/** Names that are not the usual ones, as they stand in an address. */
export const unitsInAddress = () => Object.entries(CHOICES).filter(([kind, list]) => chosen[kind] !== list[0]).map(([kind]) => chosen[kind]).join(",");
/** @param {string} names */
export function unitsFromAddress(names) {
  for (const [kind, list] of Object.entries(CHOICES)) chosen[kind] = names.split(",").find((n) => list.includes(n)) ?? list[0];
}
/** @param {() => void} tell */
export const onUnits = (tell) => { listeners.add(tell); return () => listeners.delete(tell); };
/** Whether it has several units to choose from. @param {string} kind */
export const hasChoice = (kind) => (CHOICES[kind]?.length ?? 0) > 1;
