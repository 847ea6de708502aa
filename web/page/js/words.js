// What the engine says, in the words of the page: names of fields as their labels, pressures in the unit that is shown.
import { number, outside, unitName } from "./units.js";

/** A part as people call it: those of the reference muscle by their source. @param {string | null | undefined} name */
export const partName = (name) => (name === "paper" ? "silicone (Antonelli 2018)" : name ?? "");
/** The same of a braid. @param {string | null | undefined} name */
export const braidName = (name) => (name === "paper" ? "braid (Antonelli 2018)" : name ?? "");

/**
 * Fields of requests and keys of muscle files, and what the page calls them; those of measures are added.
 * @type {Record<string, string>}
 */
const LABELS = {
  strand_diameter: "diameter of a strand",
  pressure_mpa: "pressure",
  pressures_mpa: "pressures",
  max_pressure_mpa: "pressure of the supply",
  contraction: "contraction",
  contractions: "contractions",
  force_n: "pull",
  angles_deg: "angles",
  torque_nm: "torque",
  stiffness_nm_per_rad: "stiffness",
  stroke_mm: "stroke",
  braid: "braid",
  rubber: "rubber",
  supply_mpa: "supply",
  until_s: "end",
  damping_n_s_per_m: "damping",
  model: "model",
  load: "load",
  valve: "valve",
  extrapolate: "to answer outside of the model's range",
};
/** In backquotes, or as a word that only a field or a key is. */
let pattern = /$^/;

/** Names of measures, by field, key and key in its table. @param {readonly Measure[]} measures */
export function learn(measures) {
  for (const { field, filed, label } of measures) {
    const name = label.replace(/^[A-Z](?!oung)/, (letter) => letter.toLowerCase());
    for (const key of [field, filed, filed?.split(".")[1]]) if (key) LABELS[key] ??= name;
  }
  const names = Object.keys(LABELS),
    any = (/** @type {string[]} */ list) => list.map((k) => k.replaceAll(".", "\\.")).join("|");
  pattern = new RegExp(`\`(${any(names)})\`|\\b(${any(names.filter((k) => /[._]/.test(k)))})\\b(?!["=])`, "g");
}

/**
 * A number before a unit inside: kind, pattern, and where it is no quantity of that kind.
 * @type {[string, RegExp][]}
 */
const UNITS = [
  ["pressure", /(-?\d+(?:\.\d+)?(?:e-?\d+)?) MPa\b(?![·^/²])/gi],
  ["force", /(-?\d+(?:\.\d+)?(?:e-?\d+)?) N\b(?!\/| m\b| mm\b| s\b|[·^²])/g],
  ["length", /(-?\d+(?:\.\d+)?(?:e-?\d+)?) mm\b(?![·^/²³])/g],
];
const INSIDE = { pressure: "MPa", force: "N", length: "mm" };

/** A sentence of the engine. @param {string} text */
export function inWords(text) {
  const named = text.replace(pattern, (all, quoted, plain) => LABELS[quoted ?? plain] ?? all);
  return UNITS.reduce((said, [kind, number_]) => {
    const unit = unitName(kind);
    if (!unit || unit === INSIDE[/** @type {keyof typeof INSIDE} */ (kind)]) return said;
    // Moduli stay in MPa, and so do units that MPa is a part of.
    return said.replace(number_,
      (all, value, at) => (kind === "pressure" && /modul|\bmu\b|c\d\d/i.test(said.slice(Math.max(0, at - 40), at))
        ? all
        : `${number(outside(kind, Number(value)), 4)} ${unit}`));
  }, named);
}
