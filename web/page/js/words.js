// What the engine says, in the words and units of the page: it names fields in backquotes, and joins quantities to
// their unit by a no-break space.
import { kindInside, show, unitName } from "./units.js";

/** Parts as people call them: those of the reference muscle by their source. @param {string} what */
const named = (what) => (/** @type {string | null | undefined} */ name) =>
  name === "paper" ? `${what} (Antonelli 2018)` : (name ?? "");
export const partName = named("silicone"),
  braidName = named("braid");

/**
 * Fields and keys that the page calls otherwise than they are; those of measures are added.
 * @type {Record<string, string>}
 */
const LABELS = {
  strand_diameter: "diameter of a strand",
  max_pressure_mpa: "pressure of the supply",
  force_n: "pull",
  until_s: "end",
  extrapolate: "to answer outside of the model's range",
  set: "constants of the table",
  "tube.material.mu": "shear modulus",
  "tube.material.modulus": "factor of the modulus",
  pull_factor: "factor of the pull",
  force_offset: "zero of the load cell",
};
/** A field without its unit. @param {string} field */
const plain = (field) =>
  field
    .replace(/_(mm|mpa|n|nm|deg|s|nm_per_rad|n_s_per_m)$/, "")
    .replaceAll("_", " ");

/** Names of measures, by field, key and key in its table. @param {readonly Measure[]} measures */
export function learn(measures) {
  for (const { field, filed, label } of measures) {
    const name = label.replace(/^[A-Z](?!oung)/, (letter) =>
      letter.toLowerCase(),
    );
    for (const key of [field, filed, filed?.split(".")[1]])
      if (key) LABELS[key] ??= name;
  }
}

/** The label of a key of muscle files; any other word as it is. @param {string} word */
export const worded = (word) =>
  (/[._]/.test(word) && LABELS[word]) || word.replace(/^tube\.material\./, "");
/** The key of a label; any other word as it is. @param {string} label */
export const keyed = (label) =>
  Object.keys(LABELS).find(
    (key) =>
      /\.|_(factor|offset)$/.test(key) &&
      LABELS[key].toLowerCase() === label.toLowerCase(),
  ) ?? label;
/** A quantity in the unit that is shown. @param {string} _ @param {string} value @param {string} unit inside */
function quantity(_, value, unit) {
  const kind = kindInside(unit);
  return kind && unitName(kind) !== unit
    ? show(kind, Number(value))
    : `${value} ${unit}`;
}

/** A sentence of the engine. @param {string} text */
export const inWords = (text) =>
  text
    // What the command line is told otherwise.
    .replace(
      /assign it with `columns` \S+/,
      "write it into its heading in Table",
    )
    .replace(/`parts list (\w+)`/, "Parts & library ($1)")
    .split("`")
    .map((part, i) =>
      i % 2
        ? (LABELS[part] ?? plain(part))
        : part.replace(/\w[\w.]*\w/g, worded),
    )
    .join("")
    .replace(/([-\d.e]+)\u00a0([A-Za-z/]+)/g, quantity)
    .replace(/(?<![\w.])-(?=\d)/g, "−")
    .replaceAll("± ", "±\u00a0");
