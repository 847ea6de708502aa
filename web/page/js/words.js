// What the engine says, in the words of the page: names of fields as their labels, pressures in the unit that is shown.
import { number, outside, unitName } from "./units.js";

/** Fields of requests and keys of muscle files, and what the page calls them; those of measures are added. @type {Record<string, string>} */
const LABELS = {
  strand_diameter: "diameter of a strand", pressure_mpa: "pressure", pressures_mpa: "pressures", max_pressure_mpa: "pressure of the supply", contraction: "contraction", contractions: "contractions", force_n: "pull", angles_deg: "angles",
  torque_nm: "torque", stiffness_nm_per_rad: "stiffness", stroke_mm: "stroke",
  braid: "braid", rubber: "rubber", supply_mpa: "supply", until_s: "end", damping_n_s_per_m: "damping", model: "model", load: "load", valve: "valve", extrapolate: "to answer outside of the model's range",
};
/** In backquotes, or as a word that only a field or a key is. */
let pattern = /$^/;

/** Names of measures, by field, key and key in its table. @param {readonly import("./state.js").Measure[]} measures */
export function learn(measures) {
  for (const { field, filed, label } of measures) {
    const name = label.replace(/^[A-Z](?!oung)/, (letter) => letter.toLowerCase());
    for (const key of [field, filed, filed?.split(".")[1]]) if (key) LABELS[key] ??= name;
  }
  const names = Object.keys(LABELS), any = (/** @type {string[]} */ list) => list.map((k) => k.replaceAll(".", "\\.")).join("|");
  pattern = new RegExp(`\`(${any(names)})\`|\\b(${any(names.filter((k) => /[._]/.test(k)))})\\b(?!["=])`, "g");
}

/** A sentence of the engine. @param {string} text */
export function inWords(text) {
  const named = text.replace(pattern, (all, quoted, plain) => LABELS[quoted ?? plain] ?? all);
  const unit = unitName("pressure");
  if (!unit || unit === "MPa") return named;
  // Moduli stay in MPa, and so do units that MPa is a part of.
  return named.replace(/(-?\d+(?:\.\d+)?(?:e-?\d+)?) MPa\b(?![·^/²])/gi, (all, value, at) => (/modul|\bmu\b|c\d\d/i.test(named.slice(Math.max(0, at - 40), at)) ? all : `${number(outside("pressure", Number(value)), 4)} ${unit}`));
}
