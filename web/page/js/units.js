// Quantities as people read them. Inside everything is in mm, MPa, N, degrees; factors come from
// the engine.
import { signal } from "./watch.js";
/** The engine's kind. @param {Kind} kind @returns {EngineKind} */
export const kindOf = (kind) =>
  kind === "modulus" ? "pressure" : kind === "number" ? "ratio" : kind;
/**
 * @type {Map<string, { expectation: string, units: { name: string, multiply: number, divide: number
 * }[] }>}
 */
const kinds = new Map();
/** Units to choose from by a click; the first is the usual one. @type {Record<string, string[]>} */
const CHOICES = {
  pressure: ["bar", "kPa", "MPa", "psi"],
  force: ["N", "kN", "lbf"],
  length: ["mm", "cm", "in"],
  ratio: ["%"],
  angle: ["deg", "rad"],
  modulus: ["MPa", "GPa"],
  stiffness: ["N/mm", "kN/m", "lbf/in"],
  torque: ["N m", "N cm", "lbf in"],
  "angular-stiffness": ["N m/rad", "N m/deg"],
  volume: ["cm3", "L"],
  area: ["mm2", "cm2"],
  mass: ["kg", "g", "lb"],
  density: ["kg/m3", "g/cm3"],
  time: ["s", "ms"],
  compliance: ["mm/N", "mm/kN", "in/lbf"],
  damping: ["N s/m", "N s/mm"],
  inertia: ["kg m2"],
};
/** The units that are shown. */
const chosen = signal(
  Object.fromEntries(Object.entries(CHOICES).map(([kind, list]) => [kind, list[0]])),
);

/** @param {Pick<Commands["units"]["answer"], "kinds">} answer of `units` */
export function takeUnits(answer) {
  for (const { kind, expectation, units } of answer.kinds) kinds.set(kind, { expectation, units });
  const pressure = kinds.get("pressure");
  if (pressure)
    kinds.set("modulus", {
      ...pressure,
      expectation: "a modulus such as 2500MPa or 3.5GPa (a bare number is MPa)",
    });
  kinds.set("number", { expectation: "a number", units: [{ name: "", multiply: 1, divide: 1 }] });
}

/** What may be typed; a number alone has the unit that is shown. @param {string} kind */
export const expectation = (kind) => bareIn(kinds.get(kind)?.expectation ?? "", kind);
/** With what a number alone means on the page. @param {string} text @param {string} kind */
export const bareIn = (text, kind) =>
  text.replace(/\(a bare number is [^)]*\)$/, () => `(a number alone is in ${unitName(kind)})`);
/** The unit inside; what is no kind is a unit itself. @param {string} kind */
const baseUnit = (kind) =>
  kinds.get(kind)?.units.find((u) => u.multiply === u.divide)?.name ?? kind;
/** The kind of quantities that have a unit inside. @param {string} unit */
const kindInside = (unit) => [...kinds.keys()].find((kind) => baseUnit(kind) === unit);
/** As the engine writes it. @param {string} kind */
const writtenUnit = (kind) => chosen.value[kind] ?? baseUnit(kind);
/** As people write it. @param {string} kind */
export const unitName = (kind) => {
  const unit = writtenUnit(kind);
  return unit === "deg" ? "°" : unit.replace(/(?<=m)2\b/, "²").replace(/(?<=m)3\b/, "³");
};

/** @param {string} kind */
function factor(kind) {
  const unit = kinds.get(kind)?.units.find((u) => u.name === chosen.value[kind]);
  return unit ?? { multiply: 1, divide: 1 };
}
/** A value inside in the shown unit. @param {string} kind @param {number} inside */
export const outside = (kind, inside) => {
  const u = factor(kind);
  return (inside * u.multiply) / u.divide;
};
/**
 * The other way, as the engine reads it: to 15 digits, so that 0.7 bar is 0.07 MPa.
 * @param {string} kind @param {number} shown
 */
export const inside = (kind, shown) => {
  const u = factor(kind);
  return u.divide === u.multiply
    ? shown
    : Number(((shown * u.divide) / u.multiply).toPrecision(15));
};

/** A number within two others. @param {number} v @param {number} low @param {number} high */
export const clamp = (v, low, high) => Math.min(high, Math.max(low, v));
/**
 * Numbers at equal distances, with both ends.
 * @param {number} low @param {number} high @param {number} count
 */
export const evenly = (low, high, count) =>
  Array.from({ length: count }, (_, i) => low + ((high - low) * i) / (count - 1));
/**
 * A number to so many significant digits, without an exponent where it is short without.
 * @param {number | null | undefined} v
 */
export function number(v, digits = 4) {
  if (v == null || !Number.isFinite(v)) return "–";
  if (v === 0) return "0";
  const size = Math.floor(Math.log10(Math.abs(v)));
  if (size < -5 || size > 14) return v.toExponential(digits - 1);
  const text = String(Number(v.toFixed(clamp(digits - 1 - size, 0, 20))));
  return text.replace("-", "−");
}
/** `2.5 bar`. @param {string} kind @param {number | null | undefined} value */
export const show = (kind, value, digits = 4) =>
  value == null
    ? "–"
    : `${number(outside(kind, value), digits)}${unitName(kind) === "°" ? "°" : " " + unitName(kind)}`.trimEnd();
const shown =
  (/** @type {string} */ kind) =>
  (/** @type {number | null | undefined} */ value, /** @type {number} */ digits = 4) =>
    show(kind, value, digits);
export const showLength = shown("length"),
  showForce = shown("force"),
  showPressure = shown("pressure"),
  showRatio = shown("ratio");
/**
 * As it is typed and stands in an address, to the last digit: `2.5bar`.
 * @param {string} kind @param {number} value
 */
export function typed(kind, value) {
  const shown = [6, 9, 12, 15]
    .map((digits) => Number(outside(kind, value).toPrecision(digits)))
    .find((x) => inside(kind, x) === value);
  // What no short number in the shown unit means is written in the unit inside.
  const unit = shown === undefined ? baseUnit(kind) : writtenUnit(kind);
  const bare = ["length", "angle", "force"].includes(kind) && ["mm", "deg", "N"].includes(unit);
  return String(shown ?? value) + (bare ? "" : unit.replace(" ", ""));
}

/**
 * A number with a decimal comma, and what follows it. Behind three digits a comma may separate
 * thousands: that the engine asks about.
 */
const COMMA = /^([-+]?)(\d+),(\d+)(?![\d,.])(.*)$/s;
/**
 * With a point in place of a decimal comma, and `1 1/4` as 1.25; points before it separate
 * thousands.
 * @param {string} text
 */
export function pointed(text) {
  const [, first = 0, over, under, unit] = /^(?:(\d+) )?(\d+)\/(\d+)(.*)$/.exec(text) ?? [];
  if (under) return `${Number(first) + Number(over) / Number(under)}${unit}`;
  if (/^[-+]?\d{1,3}(\.\d{3})+,\d+(?![\d,.])/.test(text))
    return text.replaceAll(".", "").replace(",", ".");
  const [, sign, whole, decimals, rest] = COMMA.exec(text) ?? [];
  return whole !== undefined &&
    (decimals.length !== 3 || /^0*$/.test(whole)) &&
    !/\d/.test(rest.replace(/[a-z]+\d/gi, ""))
    ? `${sign}${whole}.${decimals}${rest}`
    : text;
}

/**
 * What was typed into a field of a kind, as the engine shall read it, and what to say of it. A bare
 * number is in the unit beside the field; for a field in % it is a ratio up to 1, as on the command
 * line, and a percentage above, and that is said.
 * @param {string} kind @param {string} typed
 * @returns {{ text: string, value?: number, note?: string }}
 */
export function meant(kind, typed) {
  const plain = typed.replaceAll("−", "-"),
    text = pointed(plain),
    comma = text === plain ? {} : { note: `${typed} was read as ${text}.` };
  if (!/^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(text) || !Number.isFinite(Number(text)))
    return { text, ...comma };
  const value = Number(text);
  if (kind !== "ratio") return { text, value: inside(kind, value), ...comma };
  if (value === 0) return { text, value };
  const percent = Math.abs(value) > 1 ? value : Number((100 * value).toPrecision(15));
  return {
    text: `${percent} %`,
    note: `${typed} without a unit was read as ${number(percent, 6)} %.`,
  };
}

/**
 * Numbers of a form without any unit have the one that is shown: `2.5` and `1..3` in bar.
 * @param {string} kind @param {string} text
 */
export function withUnit(kind, text) {
  const hasUnit = /[a-z%°‰]/i.test(text.replace(/\de[-+]?\d/gi, ""));
  if (kind === "ratio" || kind === "number" || hasUnit || !/\d/.test(text)) return text;
  return `${text} ${writtenUnit(kind)}`;
}

/**
 * A median with its interval, to the digits that half of it leaves: `520 N (170 to 900 N)`.
 * @param {number} median @param {number} low @param {number} high
 * @param {string} unit with the space before it
 */
export function between(median, low, high, unit) {
  const place = Math.floor(Math.log10((high - low) / 2 || 1)) - 1,
    step = 10 ** place;
  const [m, l, h] = [median, low, high].map((v) =>
    (Math.round(v / step) * step)
      .toFixed(clamp(-place, 0, 8))
      .replace(/^-(?=[0.]*$)/, "")
      .replace("-", "−"),
  );
  return `${m}${unit} (${l} to ${h}${unit})`;
}
/**
 * A value with half of its interval, both to the digits that it leaves: `2.1 ± 2.4 mm`.
 * @param {number} value @param {number} half @param {string} unit
 */
export function plusMinus(value, half, unit) {
  const digits = clamp(1 - Math.floor(Math.log10(half)), 0, 12);
  return `${value.toFixed(digits).replace("-", "−")} ±\u00a0${half.toFixed(digits)} ${unit}`;
}
/**
 * The same of a quantity.
 * @param {string} kind @param {(number | null | undefined)[]} list median, low and high
 */
export function interval(kind, list) {
  const [m, l, h] = list.map((v) => outside(kind, v ?? NaN));
  return m >= l ? between(m, l, h, ` ${unitName(kind)}`) : "–";
}
/**
 * Pull of a muscle that is built: median, low and high in N, where they are known.
 * @param {CurveAnswer["points"][number] | Built} q
 */
export const builtPull = (q) =>
  "predicted_n" in q ? [q.predicted_n, q.predicted_low_n, q.predicted_high_n].map(Number) : [];
/** The same in words. @param {Built} answer */
export const asBuilt = (answer) => interval("force", builtPull(answer));
/** @param {{ model: string, force_n: number }} answer */
export const modelPull = ({ model, force_n: force }) =>
  `the model (${model}): ${show("force", force)}`;

/** What axes of charts are called. */
export const ratioAxis = "contraction ε [%]",
  forceAxis = () => `pull F [${unitName("force")}]`;

/** Changes a unit everywhere, to the next one. @param {string} kind */
export function changeUnit(kind) {
  const list = CHOICES[kind],
    next = list[(list.indexOf(chosen.value[kind]) + 1) % list.length];
  chosen.value = { ...chosen.value, [kind]: next };
}
/** Names that are not the usual ones, as they stand in an address. */
export const unitsInAddress = () =>
  Object.entries(CHOICES)
    .filter(([kind, list]) => chosen.value[kind] !== list[0])
    .map(([kind]) => chosen.value[kind])
    .join(",");
/** @param {string} names */
export function unitsFromAddress(names) {
  const next = Object.entries(CHOICES).map(([kind, list]) => [
    kind,
    names.split(",").find((n) => list.includes(n)) ?? list[0],
  ]);
  if (names !== unitsInAddress()) chosen.value = Object.fromEntries(next);
}
/** Whether it has several units to choose from. @param {string} kind */
export const hasChoice = (kind) => (CHOICES[kind]?.length ?? 0) > 1;

/** The next of 1, 2, 2.5, 5 times a power of ten. @param {number} x */
export function niceUp(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  return power * ([1, 2, 2.5, 5, 10].find((m) => m * power >= x * 0.999) ?? 10);
}

// What the engine says, in the words and units of the page: it names fields in backquotes, and
// joins quantities to their unit by a no-break space.
/**
 * Parts as people call them: those of the reference muscle by their source. @param {string} what
 */
const named = (what) => (/** @type {string | null | undefined} */ name) =>
  name === "antonelli2018" ? `${what} (Antonelli 2018)` : (name ?? "");
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
  friction_share: "friction of the usual one",
  force_offset: "zero of the load cell",
};
/** A field without its unit; a key of files as it is. @param {string} field */
const plain = (field) =>
  field.includes(".")
    ? field
    : field.replace(/_(mm|mpa|n|nm|deg|s|nm_per_rad|n_s_per_m)$/, "").replaceAll("_", " ");

/** Names of measures, by field, key and key in its table. @param {readonly Measure[]} measures */
export function learn(measures) {
  for (const { field, filed, label } of measures) {
    const name = label.replace(/^[A-Z](?!oung)/, (letter) => letter.toLowerCase());
    for (const key of [field, filed, filed?.split(".")[1]]) if (key) LABELS[key] ??= name;
  }
}

/** The label of a key of muscle files; any other word as it is. @param {string} word */
export const worded = (word) =>
  (/[._]/.test(word) && LABELS[word]) || word.replace(/^tube\.material\./, "");
/** The key of a label; any other word as it is. @param {string} label */
export const keyed = (label) =>
  Object.keys(LABELS).find(
    (key) => /\.|_(factor|offset)$/.test(key) && LABELS[key].toLowerCase() === label.toLowerCase(),
  ) ?? label;
/**
 * A quantity in the unit that is shown.
 * @param {string} _ @param {string} value @param {string} unit inside
 */
function quantity(_, value, unit) {
  const kind = kindInside(unit);
  return kind && unitName(kind) !== unit ? show(kind, Number(value)) : `${value} ${unit}`;
}

/** A sentence of the engine. @param {string} text */
export const inWords = (text) =>
  text
    // What a heading in Table says.
    .replace(/(, or|; a minus)(?:(?!, or).)*`columns`[^(]*(\(:[^)]*\))?/, "")
    .replace(/select one with `columns`.*/, "rename the others in Table")
    .replace(/`parts list (\w+)`/, "Parts ($1)")
    .replace("BURST NOT CHECKED", "burst pressure not known")
    .replace(/(\d) deg\b/g, "$1°")
    .split("`")
    .map((part, i) => (i % 2 ? (LABELS[part] ?? plain(part)) : part.replace(/\w[\w.]*\w/g, worded)))
    .join("")
    .replace(/([-\d.e]+)\u00a0([A-Za-z/]+)/g, quantity)
    .replace(/(?<![\w.])-(?=\d)/g, "−")
    .replaceAll("± ", "±\u00a0");
