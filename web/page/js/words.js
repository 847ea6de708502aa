// What the engine says, in the words of the page: names of fields as their labels, pressures in the unit that is shown.
import { number, outside, unitName } from "./units.js";

/** A part as people call it: those of the reference muscle by their source. @param {string | null | undefined} name */
export const partName = (name) => (name === "paper" ? "silicone (Antonelli 2018)" : name ?? "");
/** The same of a braid. @param {string | null | undefined} name */
export const braidName = (name) => (name === "paper" ? "braid (Antonelli 2018)" : name ?? "");

/**
 * Fields and keys that the page calls otherwise than they are; those of measures are added.
 * @type {Record<string, string>}
 */
const LABELS = { strand_diameter: "diameter of a strand", max_pressure_mpa: "pressure of the supply", force_n: "pull",
  until_s: "end", extrapolate: "to answer outside of the model's range" };
/** A field without its unit. @param {string} field */
const plain = (field) => field.replace(/_(mm|mpa|n|nm|deg|s|nm_per_rad|n_s_per_m)$/, "").replaceAll("_", " ");
/** Words that only a field or a key is. */
let pattern = /$^/;

/** Names of measures, by field, key and key in its table. @param {readonly Measure[]} measures */
export function learn(measures) {
  for (const { field, filed, label } of measures) {
    const name = label.replace(/^[A-Z](?!oung)/, (letter) => letter.toLowerCase());
    for (const key of [field, filed, filed?.split(".")[1]]) if (key) LABELS[key] ??= name;
  }
  const keys = Object.keys(LABELS).filter((k) => /[._]/.test(k)).map((k) => k.replaceAll(".", "\\."));
  pattern = new RegExp(`\\b(${keys.join("|")})\\b(?!["=])`, "g");
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
  const named = text.replace(/`([\w.]+)`/g, (_, key) => LABELS[key] ?? plain(key))
    .replace(pattern, (key) => LABELS[key]);
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
