// The muscle of the page as one state, and what every page asks about it. Nothing here touches the
// document or the engine: the muscle is what the engine says that the muscle file and the fields
// over it are.

import { replaced } from "./toml.js";
/**
 * What the page adds to measures of the program, by their fields: short keys of the address, and
 * sliders; of those `around` the muscle's own value the ends are where there is none.
 * @type {Record<string, { key: string, low: number, high: number, around?: boolean }>}
 */
const OWN = {
  outer_diameter_mm: { key: "D", low: 9, high: 90, around: true },
  wall_mm: { key: "s", low: 0.9, high: 9, around: true },
  length_mm: { key: "L", low: 85, high: 850, around: true },
  angle_deg: { key: "angle", low: 12, high: 45 },
  strand_modulus_mpa: { key: "sE", low: 500, high: 200000, around: true },
  stiffness: { key: "k", low: 20, high: 2000, around: true },
  seating_mm: { key: "seating", low: 0, high: 10 },
  slip_mm_per_n: { key: "slip", low: 0, high: 0.02 },
  grip_mm: { key: "grip", low: 0, high: 40 },
};
/**
 * Another way to state the cross-section of a strand; no measure of the program. @type {Measure}
 */
const STRAND_DIAMETER = {
  key: "sd",
  field: "strand_diameter_mm",
  group: "braid",
  kind: "length",
  label: "Diameter of a strand",
  low: 0.05,
  high: 1,
};
/** Measures of the muscle, as the program lists them. */
/** @type {Measure[]} */ export let MEASURES = [];
/**
 * The usual ones; of the strands of a named sleeve, where its source does not state them; all
 * others.
 */
export let QUANTITIES = MEASURES,
  STRANDS = MEASURES,
  MORE = MEASURES;
export let STIFFNESS = STRAND_DIAMETER;

/** @param {Commands["measures"]["answer"]} answer */
export function takeMeasures({ measures }) {
  MEASURES = measures.flatMap(
    ({ key, group, field, label, quantity, unit, default: usual, ...rest }) => {
      if (!field) return [];
      /** @type {Kind} */ const kind =
        /modul/.test(key) && quantity === "pressure" ? "modulus" : (quantity ?? "number");
      const found = /** @type {Measure} */ ({
        ...rest,
        ...OWN[field],
        key: OWN[field]?.key ?? field,
        field,
        filed: key,
        group,
        kind,
        usual,
        label: label.charAt(0).toUpperCase() + label.slice(1),
        unit: quantity ? undefined : unit,
      });
      return found.key === "sE" ? [STRAND_DIAMETER, found] : [found];
    },
  );
  const of = (/** @type {string[]} */ keys) =>
    keys.flatMap((key) => MEASURES.filter((m) => m.key === key));
  QUANTITIES = of(["D", "s", "L", "angle"]);
  STRANDS = of(["sd", "sE"]);
  [STIFFNESS] = of(["k"]);
  MORE = MEASURES.filter((m) => ![...QUANTITIES, STIFFNESS].includes(m));
}
export const PRESSURE = /** @type {const} @satisfies {Measure} */ ({
  key: "p",
  field: "pressure_mpa",
  kind: "pressure",
  label: "Pressure",
  symbol: "p",
  low: 0,
  high: 0.6,
});
export const CONTRACTION = /** @type {const} @satisfies {Measure} */ ({
  key: "e",
  field: "contraction",
  kind: "ratio",
  label: "Contraction",
  symbol: "ε",
  low: 0,
  high: 0.35,
});
export const LOAD = /** @type {const} @satisfies {Measure} */ ({
  key: "F",
  field: "force_n",
  kind: "force",
  label: "Load",
  symbol: "F",
  low: 0,
  high: 1000,
});

/** What is measured: all of the muscle, and its point. @returns {Measure[]} */
export const measured = () => [...MEASURES, PRESSURE, CONTRACTION, LOAD];
/**
 * Parts by name; words of the address that are no quantities: those, and which way the muscle
 * moves.
 */
const NAMES = ["rubber", "braid"],
  WORDS = [...NAMES, "branch"];
/** Stiffnesses that have a name. */
export const STIFFNESS_NAMES = ["inextensible", "antonelli2018"];

/** The prototype at its usual point. @returns {State} */
export const prototype = () => ({ file: "", said: {}, p: 0.25, e: 0.15, F: undefined });

/**
 * The state of a muscle file at the same pressure.
 * @param {State} state @param {string} file @returns {State}
 */
export const opened = (state, file) => ({ ...prototype(), p: state.p, e: state.e, file });

/** What gives the stiffness of strands, and all of the strands of a sleeve. */
const SECTION = ["sd", "sE", "strand_area_mm2"],
  OF_SLEEVE = [...SECTION, "strands", "strand_strength_n"];
/**
 * What excludes what: a sleeve has its angle and its strands, and a stiffness takes the place of
 * their section.
 * @type {Record<string, string[]>}
 */
const OUSTS = {
  braid: ["angle", ...OF_SLEEVE],
  k: SECTION,
  sd: ["k", "strand_area_mm2"],
  sE: ["k"],
  strand_area_mm2: ["k", "sd"],
};

/**
 * The state with something said; nothing (`undefined` or an empty text) takes it back.
 * @param {State} state @param {string} key @param {number | string | undefined} value
 * @returns {State}
 */
export function say(state, key, value) {
  if (key === "p") return { ...state, p: Number(value) };
  if (key === "e") return { ...state, e: Number(value), F: undefined };
  if (key === "F") return { ...state, F: value === undefined ? undefined : Number(value) };
  const said = { ...state.said };
  if (value === undefined || value === "") {
    delete said[key];
    if (key === "braid") {
      for (const other of OF_SLEEVE) delete said[other];
    }
  } else {
    const others =
      key === "angle" && said.braid !== undefined ? ["braid", ...OF_SLEEVE] : (OUSTS[key] ?? []);
    if (said[key] !== value) {
      for (const other of others) delete said[other];
    }
    said[key] = value;
  }
  return { ...state, said };
}

/**
 * The muscle of a request; its branch stands in the job of its file, which has a pressure.
 * @param {State} state @returns {MuscleFields}
 */
export function fields({ file, said }, pressure = 0.1) {
  /** @type {Record<string, unknown>} */
  const out = file ? { file: { name: "muscle.toml", text: file } } : {};
  for (const { key, field } of MEASURES) if (said[key] !== undefined) out[field] = said[key];
  for (const key of NAMES) if (said[key] !== undefined) out[key] = said[key];
  if (said.branch)
    out.with = [
      `job.branch=${said.branch}`,
      ...(file.includes("[job]") ? [] : [`job.pressure=${pressure}MPa`]),
    ];
  return out;
}

/**
 * The measure that a problem is about: that of its field, or the first that its message names as
 * muscle files do.
 * @param {{ field: string, message: string }} problem
 */
export function about({ field, message }) {
  const named = [field, ...(message.match(/[a-z]+\.\w+/g) ?? [])];
  return named.flatMap(
    (name) => measured().find((m) => m.field === name || m.filed === name) ?? [],
  )[0]?.key;
}

/** Where it is asked. @param {State} state */
export const point = ({ p, e, F }) => ({
  pressure_mpa: p,
  ...(F === undefined ? { contraction: e } : { force_n: F }),
});

/** What is asked of a state: its muscle at its point. @param {State} state */
export const question = (state) => ({ muscle: fields(state), ...point(state) });

/**
 * The muscle file that says the same: the file itself where nothing is said over it.
 * @param {State} state
 * @param {(command: "check", request: { muscle: MuscleFields, muscle_file: true, only_data: true })
 * =>
 *   Promise<Commands["check"]["answer"]>} ask
 */
export async function canonical(state, ask) {
  if (state.file && !Object.keys(state.said).length) return state.file;
  return /** @type {string} */ (
    (
      await ask("check", {
        muscle: fields(state, state.p || undefined),
        muscle_file: true,
        only_data: true,
      })
    ).muscle_file
  );
}

/**
 * A measure as a control shows it: what is said, or what the engine read.
 * @param {State} state @param {object | undefined} shown an answer's muscle
 * @param {Measure} measure
 */
export function shownValue(state, shown, { key, field, usual }) {
  const said = state.said[key];
  if (typeof said === "number") return said;
  const of = /** @type {Record<string, unknown>} */ (shown ?? {});
  const read = key === "k" ? of.stiffness_n_per_mm : of[field];
  return typeof read === "number"
    ? read
    : QUANTITIES.some((m) => m.key === key)
      ? usual
      : undefined;
}

/**
 * What a named sleeve needs beside its name: keys of measures.
 * @param {{ said: State["said"] }} state
 * @param {{ name: string, missing: string }[]} sleeves those of the library
 */
export function missing({ said }, sleeves) {
  if (said.braid === undefined || said.k !== undefined) return [];
  const words = sleeves.find((s) => s.name === said.braid)?.missing.split(" ") ?? [];
  const lacks = STRANDS.filter(({ field }) => words.includes(field.replace(/_(mm|mpa)$/, ""))).map(
    ({ key }) => key,
  );
  return lacks.filter((key) => key !== "sd" || said.strand_area_mm2 === undefined);
}

/**
 * Words of the address: all that is said, to the last digit.
 * @param {State} state @param {(kind: Kind, value: number) => string} typed
 */
export function words({ file, said, p, e, F }, typed) {
  /** @type {Record<string, string | undefined>} */
  const out = {};
  for (const { key, kind } of MEASURES) {
    const value = said[key];
    if (value !== undefined) out[key] = typeof value === "number" ? typed(kind, value) : value;
  }
  for (const key of WORDS) if (said[key] !== undefined) out[key] = String(said[key]);
  out.p = typed("pressure", p);
  if (F === undefined) out.e = typed("ratio", e);
  else out.F = typed("force", F);
  if (file) out.file = file;
  return out;
}

/** Texts of an address that the engine has to read. @param {URLSearchParams} params */
export function texts(params) {
  const list = measured().map(({ key, kind }) => ({ key, kind, text: params.get(key) ?? "" }));
  return list.filter(
    ({ key, text }) => params.has(key) && !(key === "k" && STIFFNESS_NAMES.includes(text)),
  );
}

/**
 * The state of an address, with what was read of its texts.
 * @param {URLSearchParams} params
 * @param {{ value?: number, problem?: { message: string } }[]} readings of `texts`, in their order
 * @returns {{ state: State, wrong: Map<string, string> }}
 */
export function fromWords(params, readings) {
  /** @type {Record<string, number | string>} */ const said = {};
  /** @type {Map<string, string>} */ const wrong = new Map();
  const at = {
    p: prototype().p,
    e: prototype().e,
    F: /** @type {number | undefined} */ (undefined),
  };
  texts(params).forEach(({ key }, i) => {
    const { value, problem } = readings[i];
    if (problem || value === undefined) return wrong.set(key, problem?.message ?? "");
    if (key === "p" || key === "e" || key === "F") at[key] = value;
    else said[key] = value;
  });
  const stiffness = params.get("k") ?? "";
  if (STIFFNESS_NAMES.includes(stiffness)) said.k = stiffness;
  for (const key of WORDS) if (params.get(key)) said[key] = params.get(key) ?? "";
  return { state: { file: params.get("file") ?? "", said, ...at }, wrong };
}

/** Keys of the address that are the muscle's. */
export const keys = () =>
  measured()
    .map(({ key }) => key)
    .concat(WORDS, "file");

/** A joint of two muscles; a link where it has a mass. @param {boolean} hasMass */
const template = (hasMass) =>
  `#:schema joint.schema.json\n\n[joint]\nradius = ""\nrange = ""\ninertia = ""\n` +
  `${hasMass ? '[link]\nmass = ""\ncentre = ""\ninclination = "-90 deg"\n' : ""}[muscle_1]\nfile = ""\n` +
  'contraction_at_neutral = ""\n[muscle_2]\nfile = ""\ncontraction_at_neutral = ""\n';

/**
 * A request for a joint with this muscle against itself or another one: that of a file, where there
 * is one, with what was typed over it.
 * @param {string} file the muscle's
 * @param {string} second file of the other one; empty where it is the same
 * @param {{ r?: number, low?: number, high?: number, e0?: number, mass?: number, centre?: number,
 * inertia?: number }} of mm, degrees, ratio, kg, kg m²; the arm hangs at the neutral angle
 * @param {string} [text] a joint file
 */
export function joint(
  file,
  second,
  { r, low, high, e0, mass, centre, inertia },
  text = template(Boolean(mass)),
) {
  const other = second ? "muscle-2.toml" : "muscle.toml",
    neutral = e0 === undefined ? undefined : String(e0);
  const said = (/** @type {number | undefined} */ value, /** @type {string} */ unit) =>
    value === undefined ? undefined : `${value} ${unit}`;
  const put = {
    "muscle_1.file": "muscle.toml",
    "muscle_2.file": other,
    "joint.radius": said(r, "mm"),
    "joint.inertia": said(inertia || undefined, "kg m2"),
    "link.mass": said(mass, "kg"),
    "link.centre": said(centre, "mm"),
    "joint.range": low === undefined || high === undefined ? undefined : `${low}..${high} deg`,
    "muscle_1.contraction_at_neutral": neutral,
    "muscle_2.contraction_at_neutral": neutral,
  };
  // What stays empty is not stated.
  const written = replaced(text, put).replace(/^\w+ = ""\n/gm, "");
  return {
    joint: { name: "joint.toml", text: written },
    muscles: [
      { name: "muscle.toml", text: file },
      ...(second ? [{ name: other, text: second }] : []),
    ],
  };
}

/**
 * A step of this muscle's pressure.
 * @param {string} file the muscle's @param {Read} read fields of the form
 */
export function motion(file, { model, ...step }) {
  return { step, muscle: { name: "muscle", text: file }, model: { name: model } };
}
