// The muscle that all pages share: its measures, pressure and contraction, as fields of requests and as words of the address.
import { engine, understood } from "./ask.js";
import { typed, unitsFromAddress, unitsInAddress } from "./units.js";

/** Quantities: key of the address, field of requests, kind, name, symbol, bounds of the slider. */
export const QUANTITIES = /** @type {const} */ ([
  { key: "D", field: "outer_diameter_mm", kind: "length", label: "Outer diameter", symbol: "D0", low: 6, high: 80 },
  { key: "s", field: "wall_mm", kind: "length", label: "Wall", symbol: "s", low: 0.3, high: 10 },
  { key: "L", field: "length_mm", kind: "length", label: "Length", symbol: "L0", low: 60, high: 900 },
  { key: "angle", field: "angle_deg", kind: "angle", label: "Braid angle", symbol: "θ0", low: 12, high: 45 },
]);
export const PRESSURE = /** @type {const} */ ({ key: "p", field: "pressure_mpa", kind: "pressure", label: "Pressure", symbol: "p", low: 0, high: 0.6 });
export const CONTRACTION = /** @type {const} */ ({ key: "e", field: "contraction", kind: "ratio", label: "Contraction", symbol: "ε", low: 0, high: 0.35 });
export const LOAD = /** @type {const} */ ({ key: "F", field: "force_n", kind: "force", label: "Load", symbol: "F", low: 0, high: 1000 });
const ALL = [...QUANTITIES, PRESSURE, CONTRACTION, LOAD];
const WORDS = ["rubber", "braid", "k", "file"];

/** @typedef {{ D: number, s: number, L: number, angle: number, p: number, e: number, F: number | undefined, rubber: string, braid: string, k: string, file: string }} Values */

/** @type {Values} */
const PROTOTYPE = { D: 30, s: 3, L: 285, angle: 28, p: 0.25, e: 0.15, F: undefined, rubber: "paper", braid: "", k: "", file: "" };

export class MuscleState {
  constructor() {
    /** @type {Values} */
    this.values = { ...PROTOTYPE };
    /** What is said over the muscle file. @type {Set<string>} */
    this.said = new Set();
    /** @type {[string, string][]} */
    this.unknown = [];
    /** @type {Map<string, string>} */
    this.wrong = new Map();
  }

  /** Fields of a request. */
  fields() {
    const v = this.values;
    /** @type {Record<string, any>} */
    const fields = {};
    if (v.file) fields.muscle = { name: "muscle.toml", text: v.file };
    const stated = (/** @type {string} */ key) => !v.file || this.said.has(key);
    for (const { key, field } of QUANTITIES) if (stated(key) && !(key === "angle" && v.braid)) fields[field] = v[key];
    if (stated("rubber") && v.rubber) fields.rubber = v.rubber;
    if (v.braid) fields.braid = v.braid;
    if (v.k && !v.braid) fields.stiffness = Number.isFinite(Number(v.k)) ? Number(v.k) : v.k;
    return fields;
  }

  /** The muscle file that says the same. */
  toml() {
    const { D, s, L, angle, rubber, braid, k, file } = this.values;
    if (file && this.said.size === 0) return file;
    const stiffness = k ? (Number.isFinite(Number(k)) ? `${k} N/mm` : k) : "paper";
    const sleeve = braid ? [`name = "${braid}"`] : [`angle = "${angle} deg"`, `stiffness = "${stiffness}"`];
    return ["[tube]", `outer_diameter = "${D} mm"`, `wall_thickness = "${s} mm"`, `length = "${L} mm"`, `rubber = "${rubber || "paper"}"`, "", "[braid]", ...sleeve, ""].join("\n");
  }

  /** @param {keyof Values} key @param {any} value */
  set(key, value) {
    /** @type {any} */ (this.values)[key] = value;
    this.said.add(key);
  }

  /** Words of the address. */
  params() {
    const v = /** @type {any} */ (this.values);
    /** @type {Record<string, string | undefined>} */
    const out = {};
    for (const { key, kind } of ALL) if (v[key] !== undefined && (!v.file || this.said.has(key) || ["p", "e", "F"].includes(key))) out[key] = typed(kind, v[key]);
    if (v.F !== undefined) delete out.e;
    for (const key of WORDS) if (v[key] && (!v.file || this.said.has(key) || key === "file")) out[key] = v[key];
    out.u = unitsInAddress() || undefined;
    for (const [key, text] of this.unknown) out[key] = text;
    return out;
  }

  /**
   * From an address; keys that the page `own`s are not unknown. @param {URLSearchParams} params @param {string[]} own
   */
  async read(params, own = []) {
    unitsFromAddress(params.get("u") ?? "");
    const values = /** @type {any} */ ({ ...PROTOTYPE });
    this.said = new Set();
    this.wrong = new Map();
    const asked = ALL.filter(({ key }) => params.has(key));
    const texts = asked.map(({ key, kind }) => ({ text: params.get(key) ?? "", kind }));
    const readings = await understood(texts);
    asked.forEach(({ key }, i) => {
      if (readings[i].problem) return this.wrong.set(key, readings[i].problem.message);
      values[key] = readings[i].value;
      this.said.add(key);
    });
    for (const key of WORDS) if (params.has(key)) { values[key] = params.get(key); this.said.add(key); }
    this.values = values;
    const known = new Set([...ALL.map(({ key }) => key), ...WORDS, "u", ...own]);
    this.unknown = [...params].filter(([key]) => !known.has(key));
  }

  /** A muscle file in place of everything else. @param {string} text */
  async take(text) {
    const shown = await engine().ask("muscle-show", { muscle: { name: "muscle.toml", text } });
    const { p, e } = this.values;
    this.values = { ...PROTOTYPE, p, e, file: text, rubber: "", D: shown.outer_diameter_mm, s: shown.wall_mm, L: shown.length_mm, angle: shown.angle_deg };
    this.said = new Set();
    return shown;
  }
}
export const muscle = new MuscleState();
