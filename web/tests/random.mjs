// Random muscles: a muscle file, and what somebody says over it, as the command line's flags and as what is typed into the page's fields.

/** Mulberry32: the same numbers everywhere. @param {number} seed */
export function dice(seed) {
  let a = seed >>> 0;
  const next = () => {
    a = (a + 0x6d2b79f5) | 0;
    let t = Math.imul(a ^ (a >>> 15), 1 | a);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
  const between = (/** @type {number} */ low, /** @type {number} */ high, digits = 4) =>
    Number((low + (high - low) * next()).toPrecision(digits));
  /** @template T @param {readonly T[]} list @returns {T} */
  const pick = (list) => list[Math.floor(next() * list.length)];
  return { next, between, pick, chance: (/** @type {number} */ share) => next() < share };
}

const LAWS = [
  (/** @type {any} */ d) => `law = "neo-hookean"\nmu = "${d.between(0.1, 1.2)} MPa"`,
  (/** @type {any} */ d) =>
    `law = "mooney-rivlin"\nc10 = "${d.between(60, 300)} kPa"\nc01 = ${d.between(0.005, 0.05)}`,
  (/** @type {any} */ d) =>
    `law = "yeoh"\nc10 = ${d.between(0.1, 0.3)}\nc20 = ${d.between(0.001, 0.01)}\nc30 = ${d.between(0.0001, 0.001)}\nname = "mine"\nfitted_to_stretch = 2.5`,
  (/** @type {any} */ d) => `law = "gent"\nmu = ${d.between(0.2, 0.8)}\njm = ${d.between(20, 80)}`,
  (/** @type {any} */ d) =>
    `law = "ogden"\nmu = [${d.between(0.1, 0.3)}, ${d.between(0.01, 0.05)}]\nalpha = [1.8, 3.2]`,
  (/** @type {any} */ d) =>
    `law = "neo-hookean"\nmu = "${d.between(0.2, 1)} MPa"\nsoftening = { r = 1.6, m = "0.05 MPa" }\nconditioned = "2 bar"`,
];
const RUBBERS = [
  "antonelli2018",
  "dragon-skin-30",
  "dragon-skin-20",
  "ecoflex-00-50",
  "rebound-25",
  "dragon-skin-30:neo-hookean",
];
/** Sleeves: name, tubes that suit them in mm, what their sources do not state. @type {[string, number, number, string[]][]} */
export const SLEEVES = [
  ["s-muscle-13", 1.4, 2.1, ["sE"]],
  ["s-muscle-20", 2.2, 3.2, ["sE"]],
  ["s-muscle-40", 4.4, 6.5, ["sE"]],
  ["flexo-overexpanded-0.25in", 9, 13, ["sd"]],
  ["flexo-overexpanded-0.31in", 11, 16, ["sd"]],
  ["flexo-overexpanded-0.38in", 13.5, 19.5, ["sd"]],
  ["flexo-overexpanded-0.50in", 18, 26, ["sd"]],
  ["flexo-overexpanded-0.75in", 27, 39, ["sd"]],
  ["nfl-19", 15.5, 19, ["sd", "sE"]],
  ["kevlar-sock", 80, 86, ["sd", "sE"]],
];

/** What the words of the address are called on the command line, a flag or a key of `--with`, and in which units people type them: unit, mm (MPa, N, …) of one. @type {Record<string, [string, [string, number][]]>} */
const FLAGS = {
  D: [
    "-D",
    [
      ["mm", 1],
      ["in", 25.4],
      ["cm", 10],
      ["", 1],
    ],
  ],
  s: [
    "-s",
    [
      ["mm", 1],
      ["", 1],
    ],
  ],
  L: [
    "-L",
    [
      ["mm", 1],
      ["m", 1000],
      ["in", 25.4],
    ],
  ],
  angle: [
    "--angle",
    [
      ["deg", 1],
      ["", 1],
    ],
  ],
  sd: [
    "--strand-diameter",
    [
      ["mm", 1],
      ["um", 1e-3],
    ],
  ],
  sE: [
    "--strand-modulus",
    [
      ["MPa", 1],
      ["GPa", 1000],
    ],
  ],
  k: [
    "--stiffness",
    [
      ["N/mm", 1],
      ["", 1],
    ],
  ],
  prestretch: ["tube.prestretch", [["", 1]]],
  density_kg_per_m3: [
    "tube.density",
    [
      ["kg/m3", 1],
      ["g/cm3", 1000],
    ],
  ],
  end_factor: ["terminals.end_factor", [["", 1]]],
  strand_length_mm: [
    "braid.strand_length",
    [
      ["mm", 1],
      ["in", 25.4],
    ],
  ],
  turns: ["braid.turns", [["", 1]]],
  seating: ["terminals.seating", [["mm", 1]]],
  slip: [
    "terminals.slip",
    [
      ["mm/N", 1],
      ["mm/kN", 1e-3],
    ],
  ],
  grip: ["terminals.grip", [["mm", 1]]],
  rubber: ["--rubber", []],
  braid: ["--braid", []],
};

/** Measures that few muscles state: where in a muscle file, the lowest and highest value, and its units; a plain number has none. @type {Record<string, [string, number, number, [string, number][]]>} */
const MORE = {
  density_kg_per_m3: [
    "tube.density",
    900,
    1300,
    [
      ["kg/m3", 1],
      ["g/cm3", 1000],
    ],
  ],
  prestretch: ["tube.prestretch", 1.01, 1.15, []],
  insertion_mm: [
    "terminals.insertion",
    5,
    30,
    [
      ["mm", 1],
      ["in", 25.4],
    ],
  ],
  end_factor: ["terminals.end_factor", 1, 1.15, []],
  braid_thickness_mm: [
    "braid.thickness",
    0.005,
    0.02,
    [
      ["mm", 1],
      ["um", 1e-3],
    ],
  ],
  friction_lever_mm: ["friction.lever", 0.1, 2, [["mm", 1]]],
  friction_coefficient: ["friction.coefficient", 5, 60, []],
  friction_exponent: ["friction.exponent", 0.5, 0.9, []],
};
/** Where others of them are. @type {Record<string, string>} */
const PLACES = {
  ...Object.fromEntries(Object.entries(MORE).map(([key, [place]]) => [key, place])),
  strands: "braid.strands",
  strand_area_mm2: "braid.strand_area",
  strand_strength_n: "braid.strand_strength",
  braid_diameter_mm: "braid.diameter",
  crimp: "braid.crimp",
  crimp_stiffness: "braid.crimp_stiffness",
  strand_length_mm: "braid.strand_length",
  turns: "braid.turns",
};

/**
 * A random muscle: its file (empty for the prototype), what is said over it as key and text, the same as flags over a file (`ground`, which also
 * has what has no flag), and the file that somebody would write who says all of it there.
 * @param {number} seed
 */
export function muscle(seed) {
  const d = dice(seed);
  // What a file says, and what is said over it, drawn apart.
  const sleeve = d.chance(0.35) ? d.pick(SLEEVES) : undefined;
  const D = sleeve ? d.between(sleeve[1], sleeve[2]) : d.between(12, 50);
  const base = /** @type {Record<string, string>} */ ({
    D: `${D} mm`,
    s: `${d.between(0.05 * D, 0.16 * D)} mm`,
    L: `${d.between(4 * D, 10 * D)} mm`,
  });
  if (sleeve) {
    base.braid = sleeve[0];
    complete(base, sleeve[3]);
  } else {
    base.angle = `${d.between(20, 34)} deg`;
    base.k = d.pick(["antonelli2018", "inextensible", `${d.between(100, 900)} N/mm`]);
  }
  if (d.chance(0.5)) base.rubber = d.pick(RUBBERS);
  else base.law = d.pick(LAWS)(d);
  if (d.chance(0.4)) base.seating = `${d.between(0.1, 2)} mm`;
  if (d.chance(0.3)) base.slip = `${d.between(0.1, 2)} mm/kN`;
  if (d.chance(0.3)) base.grip = `${d.between(1, 5)} mm`;
  if (d.chance(0.2)) Object.assign(base, { friction_coefficient: "40", friction_exponent: "0.8" });
  const filed = d.chance(0.75);

  /** @param {Record<string, string>} into @param {string[]} lacks */
  function complete(into, lacks) {
    if (d.chance(0.25)) into.k = d.chance(0.5) ? "inextensible" : `${d.between(100, 900)} N/mm`;
    else {
      if (lacks.includes("sd")) into.sd = `${d.between(0.15, 0.35)} mm`;
      if (lacks.includes("sE")) into.sE = `${d.between(2000, 9000)} MPa`;
    }
  }

  /** @type {Record<string, string>} */
  const over = {};
  const said = filed ? 0.3 : 0.7;
  const say = (/** @type {string} */ key, /** @type {number} */ mm) => {
    const [unit, of] = d.pick(FLAGS[key][1]);
    over[key] =
      `${Number((mm / of).toPrecision(d.pick([3, 5])))}${unit && d.chance(0.5) ? " " : ""}${unit}`;
  };
  // Over a file with a sleeve the diameter stays within it.
  if (d.chance(said)) say("D", filed ? D * d.between(0.98, 1.08) : d.between(20, 45));
  if (d.chance(said)) say("s", filed ? D * d.between(0.06, 0.15) : d.between(1, 3));
  if (d.chance(said)) say("L", filed ? D * d.between(4, 9) : d.between(150, 350));
  if (!filed || !sleeve) {
    const other = d.chance(0.25)
      ? SLEEVES.find(([, low, high]) =>
          [over.D ? undefined : filed ? D : 30].every(
            (x) => x !== undefined && x > low * 1.05 && x < high * 0.95,
          ),
        )
      : undefined;
    if (other) {
      over.braid = other[0];
      complete(over, other[3]);
    } else {
      if (d.chance(said)) say("angle", d.between(20, 34));
      if (d.chance(said)) {
        if (d.chance(0.4)) over.k = d.pick(["inextensible", "antonelli2018"]);
        else say("k", d.between(100, 900));
      }
    }
  } else if (d.chance(0.2)) over.k = "inextensible";
  if (d.chance(0.3)) over.rubber = d.pick(RUBBERS);
  if (d.chance(0.2)) say("seating", d.between(0.1, 2));
  if (d.chance(0.2)) say("slip", d.between(1e-4, 2e-3));
  if (d.chance(0.2)) say("grip", d.between(1, 4));
  const ends = {
    p: `${d.between(0.8, 3, 3)}${d.pick(["bar", " bar"])}`,
    e: d.pick([`${d.between(1, 14, 3)}%`, `${d.between(0.01, 0.14, 3)}`]),
  };
  // The others are drawn last, so that a seed keeps what it had before them.
  few(base, 0.12, {});
  if (!sleeve && d.chance(0.2)) {
    delete base.k;
    ownStrands(base);
  }
  few(over, 0.12, filed ? base : {});
  const whole = merge(filed ? base : {}, over);
  if (!over.k && !over.braid && !(filed && base.braid) && d.chance(0.2)) ownStrands(over);
  if (!over.k && !over.braid && whole.k !== "inextensible" && d.chance(0.15)) {
    over.crimp = `${d.between(0.1, 1)} %`;
    if (d.chance(0.5)) over.crimp_stiffness = `${d.between(0.05, 0.5)}`;
  }
  if (!whole.braid && d.chance(0.1))
    over.braid_diameter_mm = `${Number((1.02 * millimetres(whole.D ?? "30")).toPrecision(6))} mm`;
  if (d.chance(0.08))
    Object.assign(over, {
      strand_length_mm: `${Number((1.14 * millimetres(whole.L ?? "285")).toPrecision(6))} mm`,
      turns: `${d.between(1, 3)}`,
    });
  // What has no flag the command line reads in the file, with what a muscle of it cannot do without.
  const beside = [
    ...(over.strands ? SECTION : []),
    ...(over.braid_diameter_mm ? ["D", "s", "L"] : []),
  ];
  const [beneath, flagged] = [false, true].map((flag) =>
    Object.fromEntries(
      Object.entries(over).filter(
        ([key]) => flag === (Boolean(FLAGS[key]) && !beside.includes(key)),
      ),
    ),
  );
  const ground =
    filed || Object.keys(beneath).length ? written(merge(filed ? base : {}, beneath)) : "";
  const flags = Object.entries(flagged).flatMap(([key, text]) => {
    const [name] = FLAGS[key];
    return name.startsWith("-") ? [name, text] : ["--with", `${name}=${text}`];
  });
  return {
    file: filed ? written(base) : "",
    over,
    ground,
    flags,
    merged: written(merge(filed ? base : {}, over)),
    ...ends,
  };

  /** A few of the measures that few muscles state. @param {Record<string, string>} into @param {number} share @param {Record<string, string>} beside */
  function few(into, share, beside) {
    for (const [key, [, low, high, units]] of Object.entries(MORE)) {
      if (!d.chance(share)) continue;
      // Its exponent and its coefficient make a friction; with a file's friction one of them alone is another one.
      const pair = {
        friction_coefficient: "friction_exponent",
        friction_exponent: "friction_coefficient",
      }[key];
      if (pair && into[pair] === undefined && beside[pair] === undefined)
        into[pair] = `${d.between(MORE[pair][1], MORE[pair][2])}`;
      const [unit, of] = units.length ? d.pick(units) : ["", 1];
      // The thickness of a braid goes with the tube's diameter.
      into[key] =
        `${Number(((d.between(low, high) * (key === "braid_thickness_mm" ? D : 1)) / of).toPrecision(5))}${unit}`;
    }
  }

  /** A braid by its strands. @param {Record<string, string>} into */
  function ownStrands(into) {
    into.strands = `${2 * Math.round(d.between(20, 60))}`;
    into.sE = `${d.between(2000, 9000)} MPa`;
    if (d.chance(0.5)) into.sd = `${d.between(0.15, 0.35)} mm`;
    else into.strand_area_mm2 = `${d.between(0.02, 0.1)} mm2`;
    if (d.chance(0.5)) into.strand_strength_n = `${d.between(20, 90)} N`;
  }
}

/** A length of this file's own writing in mm. @param {string} text */
function millimetres(text) {
  const { in: inch, cm, m } = { in: 25.4, cm: 10, m: 1000 },
    unit = text.replace(/[-\d.e ]/g, "");
  return parseFloat(text) * /** @type {Record<string, number>} */ ({ in: inch, cm, m }[unit] ?? 1);
}

const SECTION = ["sd", "sE", "strand_area_mm2"];

/** What is said takes the place of what it excludes. @param {Record<string, string>} base @param {Record<string, string>} over */
function merge(base, over) {
  const out = { ...base };
  if (over.braid)
    for (const key of ["angle", "k", ...SECTION, "strands", "strand_strength_n"]) delete out[key];
  if (over.k || over.strand_area_mm2 || over.sd)
    for (const key of ["sd", "strand_area_mm2"]) delete out[key];
  if (over.k) delete out.sE;
  if (SECTION.some((key) => over[key])) delete out.k;
  if (over.rubber) delete out.law;
  return { ...out, ...over };
}

/** A muscle file. @param {Record<string, string>} of */
function written({
  D,
  s,
  L,
  rubber,
  law,
  braid,
  angle,
  k,
  sd,
  sE,
  seating,
  slip,
  grip,
  ...others
}) {
  const key = (/** @type {string} */ name, /** @type {string | undefined} */ text) =>
    text === undefined ? "" : `${name} = ${/^[\d.]+$/.test(text) ? text : `"${text}"`}\n`;
  const more = (/** @type {string} */ table) =>
    Object.entries(others)
      .map(([name, text]) =>
        PLACES[name].startsWith(`${table}.`) ? key(PLACES[name].split(".")[1], text) : "",
      )
      .join("");
  const tube =
    key("outer_diameter", D) +
    key("wall_thickness", s) +
    key("length", L) +
    key("rubber", rubber) +
    more("tube") +
    (law ? `\n[tube.material]\n${law}\n` : "");
  const sleeve =
    key("name", braid) +
    key("angle", angle) +
    key("stiffness", k) +
    key("strand_diameter", sd) +
    key("strand_modulus", sE) +
    more("braid");
  const ends = key("seating", seating) + key("slip", slip) + key("grip", grip) + more("terminals"),
    friction = more("friction");
  return `name = "random"\n\n[tube]\n${tube}\n[braid]\n${sleeve}${ends ? `\n[terminals]\n${ends}` : ""}${friction ? `\n[friction]\n${friction}` : ""}`;
}
