// Quantities as people read them. Inside everything is in mm, MPa, N, degrees; factors come from the engine.
import { engine } from "./ask.js";

/**
 * Kinds of the engine, moduli (pressures that are always in MPa), and plain numbers (ratios that nobody writes in %).
 * @typedef {import("../../types/commands").Commands["units"]["answer"]["kinds"][number]["kind"]} EngineKind
 * @typedef {EngineKind | "modulus" | "number"} Kind
 */
/** The engine's kind. @param {Kind} kind @returns {EngineKind} */
export const kindOf = (kind) => (kind === "modulus" ? "pressure" : kind === "number" ? "ratio" : kind);
/** @type {Map<string, { expectation: string, units: { name: string, multiply: number, divide: number }[] }>} */
const kinds = new Map();
/** Units to choose from by a click; the first is the usual one. @type {Record<string, string[]>} */
const CHOICES = { pressure: ["bar", "kPa", "MPa", "psi"], force: ["N", "lbf"], length: ["mm", "in"], ratio: ["%"], angle: ["deg"], torque: ["N m"], "angular-stiffness": ["N m/rad"] };
/** @type {Record<string, string>} */
const chosen = Object.fromEntries(Object.entries(CHOICES).map(([kind, list]) => [kind, list[0]]));
/** @type {Set<() => void>} */
const listeners = new Set();

export async function loadUnits() { takeUnits(await engine().ask("units", {}, { lane: "state" })); }
/** @param {{ kinds: readonly any[] }} answer of `units` */
export function takeUnits(answer) {
  for (const { kind, expectation, units } of answer.kinds) kinds.set(kind, { expectation, units });
  const pressure = kinds.get("pressure");
  if (pressure) kinds.set("modulus", { ...pressure, expectation: "a modulus such as 2500MPa or 3.5GPa" });
  kinds.set("number", { expectation: "a number", units: [{ name: "", multiply: 1, divide: 1 }] });
}

/** @param {string} kind */
export const expectation = (kind) => kinds.get(kind)?.expectation ?? "";
/** Names of its units. @param {string} kind */
export const unitsOf = (kind) => (kinds.get(kind)?.units ?? []).map((u) => u.name);
/** The unit inside. @param {string} kind */
const baseUnit = (kind) => (kind === "modulus" ? "MPa" : kinds.get(kind)?.units.find((u) => u.multiply === u.divide)?.name ?? "");
/** @param {string} kind */
export const unitName = (kind) => (kind === "angle" ? "°" : chosen[kind] ?? baseUnit(kind));

/** @param {string} kind */
function factor(kind) {
  const unit = kinds.get(kind)?.units.find((u) => u.name === chosen[kind]);
  return unit ?? { multiply: 1, divide: 1 };
}
/** A value inside in the shown unit. @param {string} kind @param {number} inside */
export const outside = (kind, inside) => { const u = factor(kind); return (inside * u.multiply) / u.divide; };
/** The other way, as the engine reads it: to 15 digits, so that 0.7 bar is 0.07 MPa. @param {string} kind @param {number} shown */
export const inside = (kind, shown) => { const u = factor(kind); return u.divide === u.multiply ? shown : Number(((shown * u.divide) / u.multiply).toPrecision(15)); };

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
export const show = (kind, value, digits = 4) => (value === null || value === undefined ? "–" : `${number(outside(kind, value), digits)}${kind === "angle" ? "°" : " " + unitName(kind)}`.trimEnd());
/** As it is typed and stands in an address, to the last digit: `2.5bar`. @param {string} kind @param {number} value */
export function typed(kind, value) {
  const shown = [6, 9, 12, 15].map((digits) => Number(outside(kind, value).toPrecision(digits))).find((x) => inside(kind, x) === value);
  // What no short number in the shown unit means is written in the unit inside.
  const unit = kind === "angle" ? "deg" : shown === undefined ? baseUnit(kind) : unitName(kind);
  const bare = ["length", "angle", "force"].includes(kind) && ["mm", "deg", "N"].includes(unit);
  return String(shown ?? value) + (bare ? "" : unit.replace(" ", ""));
}

/**
 * What was typed into a field of a kind, as the engine shall read it, and what to say of it. A bare number is in the unit beside the field;
 * for a field in % it is a ratio up to 1, as on the command line, and a percentage above, and that is said.
 * @param {string} kind @param {string} text @returns {{ text: string, value?: number, note?: string }}
 */
export function meant(kind, text) {
  const bare = text !== "" && Number.isFinite(Number(text));
  if (!bare) return { text };
  const value = Number(text);
  if (kind !== "ratio") return { text, value: inside(kind, value) };
  if (value === 0) return { text, value };
  const percent = Math.abs(value) > 1 ? value : Number((100 * value).toPrecision(15));
  return { text: `${percent} %`, note: `${text} without a unit was read as ${number(percent, 6)} %.` };
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
