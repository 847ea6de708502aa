// What the engine says, in the words of the page: names of fields as their labels, pressures in the unit that is shown.
import { number, outside, unitName } from "./units.js";

/** Fields of requests and keys of muscle files, and what the page calls them. @type {Record<string, string>} */
const LABELS = {
  outer_diameter_mm: "outer diameter", "tube.outer_diameter": "outer diameter", wall_mm: "wall", "tube.wall_thickness": "wall", length_mm: "length", "tube.length": "length",
  angle_deg: "braid angle", "braid.angle": "braid angle", stiffness: "stiffness of a strand family", "braid.stiffness": "stiffness of a strand family",
  strand_diameter_mm: "diameter of a strand", strand_modulus_mpa: "Young's modulus of a strand", seating_mm: "seating of both ends", "terminals.seating": "seating of both ends",
  slip_mm_per_n: "slip of both ends", "terminals.slip": "slip of both ends", grip_mm: "length held at each end", "terminals.grip": "length held at each end",
  pressure_mpa: "pressure", pressures_mpa: "pressures", max_pressure_mpa: "pressure of the supply", contraction: "contraction", contractions: "contractions", force_n: "pull", angles_deg: "angles",
  torque_nm: "torque", stiffness_nm_per_rad: "stiffness", stroke_mm: "stroke", outer_diameter: "outer diameter", wall_thickness: "wall", strand_diameter: "diameter of a strand", strand_modulus: "Young's modulus of a strand",
  braid: "braid", rubber: "rubber", supply_mpa: "supply", until_s: "end", damping_n_s_per_m: "damping", model: "model", load: "load", valve: "valve", extrapolate: "to answer outside of the model's range",
};
const KEY = new RegExp(`\`(${Object.keys(LABELS).map((k) => k.replaceAll(".", "\\.")).join("|")})\`|\\b(${Object.keys(LABELS).filter((k) => /[._]/.test(k) && !k.startsWith("strand_")).map((k) => k.replaceAll(".", "\\.")).join("|")}|strand_diameter|strand_modulus)\\b(?!["=])`, "g");

/** A sentence of the engine. @param {string} text */
export function inWords(text) {
  const named = text.replace(KEY, (all, quoted, plain) => LABELS[quoted ?? plain] ?? all);
  const unit = unitName("pressure");
  if (!unit || unit === "MPa") return named;
  // Moduli stay in MPa, and so do units that MPa is a part of.
  return named.replace(/(-?\d+(?:\.\d+)?(?:e-?\d+)?) MPa\b(?![·^/²])/gi, (all, value, at) => (/modul|\bmu\b|c\d\d/i.test(named.slice(Math.max(0, at - 40), at)) ? all : `${number(outside("pressure", Number(value)), 4)} ${unit}`));
}
