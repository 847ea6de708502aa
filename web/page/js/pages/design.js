// From a specification to ranked muscles, with a map of what is feasible and why the rest is not.
import { engine } from "../ask.js";
import { address, write } from "../address.js";
import { designMap } from "../design-map.js";
import { designTarget } from "../design-target.js";
import { closestView, foundView, rejectedView } from "../design-view.js";
import { el, faded, folded, heading } from "../dom.js";
import { Figures } from "../figure.js";
import { bench, form, job } from "../form.js";
import { muscle } from "../muscle.js";
import { STIFFNESS_NAMES, candidate, missing } from "../state.js";
import { onUnits, typed, unitName } from "../units.js";

const OBJECTIVES = /** @type {[string, string][]} */ ([
  ["diameter", "narrowest at rest"],
  ["pressure", "lowest pressure"],
  ["air", "least air or liquid"],
  ["margin", "largest margin of pull"],
  ["bulged-diameter", "narrowest in use"],
  ["length", "shortest"],
]);
/** @type {Field[]} */
export const WANTED = [
  { key: "F", field: "force_n", label: "Pull", kind: "force", value: "700 N" },
  {
    key: "e",
    field: "contraction",
    label: "at a contraction of",
    kind: "ratio",
    value: "15 %",
  },
  {
    key: "at",
    field: "points",
    label: "or several pulls",
    pair: [
      ["force", "force_n"],
      ["ratio", "contraction"],
    ],
    hint: "700N@15%, 1200N@5%",
  },
  {
    key: "joint",
    field: "torques",
    label: "or torques of a joint",
    pair: [
      ["torque", "torque_nm"],
      ["angle", "angle_deg"],
    ],
    hint: "8Nm@45deg",
  },
  { key: "load", field: "load", label: "or a load to lift", hint: "mass:20kg" },
  {
    key: "stroke",
    field: "stroke_mm",
    label: "Stroke",
    kind: "length",
    hint: "40 mm",
  },
  {
    key: "pmax",
    field: "max_pressure_mpa",
    label: "Pressure of the supply",
    kind: "pressure",
    value: "2.5 bar",
  },
  {
    key: "bulge",
    field: "max_bulged_diameter_mm",
    label: "Largest bulged diameter",
    kind: "length",
    hint: "60 mm",
  },
  {
    key: "sure",
    field: "guaranteed",
    label: "Guaranteed share",
    kind: "ratio",
    hint: "95 %",
  },
  {
    key: "for",
    field: "objective",
    label: "Rank by",
    options: OBJECTIVES,
    value: "bulged-diameter",
  },
];
/** @type {() => Field[]} */
export const choices = () => [
  {
    key: "D",
    field: "outer_diameter_mm",
    label: "Outer diameters",
    kind: "length",
    list: true,
    hint: "10..60 mm",
  },
  {
    key: "s",
    field: "wall_mm",
    label: "Walls",
    kind: "length",
    list: true,
    hint: "1..4:0.5 mm",
  },
  {
    key: "L",
    field: "length_mm",
    label: "Length",
    kind: "length",
    list: true,
    hint: "285 mm",
  },
  {
    key: "angle",
    field: "angle_deg",
    label: "Braid angles",
    kind: "angle",
    list: true,
    hint: "28 deg",
  },
  {
    key: "rubber",
    field: "rubbers",
    label: "Rubbers",
    words: true,
    hint: "paper, ecoflex-00-30",
  },
  {
    key: "braid",
    field: "braids",
    label: "Sleeves as sold",
    words: true,
    hint: "names of the list",
  },
  {
    key: "sd",
    field: "strand_diameter_mm",
    label: "Diameter of a strand",
    kind: "length",
    hint: "0.25 mm",
    hidden: true,
  },
  {
    key: "sE",
    field: "strand_modulus_mpa",
    label: "Young's modulus of a strand",
    kind: "modulus",
    hint: "2500 MPa",
    hidden: true,
  },
  {
    key: "k",
    field: "stiffness",
    label: "Stiffness of a strand family",
    kind: "stiffness",
    or: STIFFNESS_NAMES,
    hint: "500 N/mm; inextensible",
  },
  {
    key: "r",
    field: "radius_mm",
    label: "Pulley of a joint",
    kind: "length",
    list: true,
    hint: "20..40 mm",
  },
  {
    key: "liquid",
    field: "liquid",
    label: "Liquid in the place of air",
    hint: "water, oil or glycol",
  },
  {
    key: "most",
    field: "max_liquid_volume_mm3",
    label: "Largest liquid volume",
    kind: "volume",
    hint: "20 mL",
  },
  {
    key: "burst",
    field: "min_burst_margin",
    label: "Safety factor of strands and clamps",
    kind: "ratio",
    factor: true,
    hint: "4",
  },
];

/** The forms of a specification, and the request that they make. @param {() => void} submit */
function specification(submit) {
  const wanted = form(WANTED, submit),
    choice = form(choices(), submit),
    forms = [wanted, choice];
  const vary = folded("Search space", choice.element);
  /** What the sleeves need beside their names has a field. */
  const lacking = () => {
    const k = choice.text("k"),
      names = choice
        .text("braid")
        .split(",")
        .map((name) => name.trim())
        .filter(Boolean);
    return [
      ...new Set(
        names.flatMap((braid) =>
          missing({ said: k ? { braid, k } : { braid } }, muscle.sleeves),
        ),
      ),
    ];
  };
  const offer = () => {
    const lacks = lacking();
    for (const key of ["sd", "sE"]) choice.shown(key, lacks.includes(key));
    if (lacks.length) vary.open = true;
  };
  choice.element.addEventListener("input", offer);
  return {
    elements: [wanted.element, vary],
    offer,
    put: (/** @type {string} */ key, /** @type {string} */ text) =>
      wanted.put(key, text),
    options: (/** @type {string} */ key, /** @type {string[]} */ names) =>
      choice.options(key, names),
    texts: () => Object.assign({}, ...forms.map((f) => f.texts())),
    set: (/** @type {URLSearchParams} */ params) =>
      forms.forEach((f) => f.set(params)),
    /** The request, or nothing where a text cannot be read. @returns {Promise<Design["request"] | undefined>} */
    async read() {
      const [want, space] = await Promise.all([
        wanted.read(),
        choice.read({ intervals: true }),
      ]);
      if (!want || !space) return undefined;
      // Several points or torques stand in place of the one pull; a load in place of its force.
      if (want.points || want.torques || want.load) delete want.force_n;
      if (want.points || want.torques || (want.load && want.stroke_mm))
        delete want.contraction;
      return { ...want, ...space, figure: unitName("pressure") };
    },
    /** @param {Problem} problem */
    at(problem) {
      forms.some((f) => f.at(problem));
      for (const key of lacking())
        if (!choice.text(key))
          choice.mark(
            key,
            "The source of the sleeve does not state it: measure it, or give a stiffness.",
          );
    },
  };
}

/** Prices of tubes; asked once. @type {Promise<Map<string, string>> | undefined} */ let prices;
const priced = () =>
  (prices ??= engine()
    .ask("parts-list", { kind: "tubes" })
    .then(
      ({ tubes }) =>
        new Map(
          tubes.flatMap((part) => {
            const { price } = /** @type {{ price?: string | null }} */ (part);
            return price
              ? [/** @type {[string, string]} */ ([part.name, price])]
              : [];
          }),
        ),
      () => new Map(),
    ));

/**
 * The address of a muscle of the search: that muscle, and nothing of the one of the other pages.
 * @param {Chosen} c @param {Design["request"]} of the request @param {{ p: number, e: number }} at
 */
const linked = (c, of, at) =>
  address("muscle", muscle.paramsOf(candidate(c, of, at)));

/** @type {Mount} */
export const mount = (main) => {
  /** @type {Design["answer"] | undefined} */ let found;
  /** What the answer that is shown was asked by, and the newest question. @type {Design["request"]} */
  let of = {},
    /** @type {Design["request"] | undefined} */ asked;
  const spec = specification(() => search.run());
  const results = el(
    "div",
    {},
    faded(
      "State the requirement. The search ranks tubes and sleeves that you can buy or cast, or free diameters and " +
        "walls where you give them; finite elements compute the final values.",
    ),
  );
  const figures = new Figures("design"),
    map = designMap((c, at) => linked(c, of, at));
  const target = designTarget({
    moved: (to) => map.preview(to),
    settled(to) {
      spec.put("F", typed("force", to.force_n));
      spec.put("e", typed("ratio", to.contraction));
      search.run();
    },
  });
  const search = job(
    "Design",
    "design",
    async () => {
      asked = await spec.read();
      if (asked) place();
      return asked;
    },
    (answer) => {
      [found, of] = [answer, asked ?? {}];
      paint();
      figures.show(answer.figure);
      target.show(found, of);
      map.show(found, of);
    },
    {
      fields: spec,
      shown: [results, target.element, ...map.elements, figures.element],
    },
  );
  const place = () =>
    write(address("design", { ...spec.texts(), m: muscle.word() }));

  async function paint() {
    if (!found) return;
    const answer = found;
    const act = {
      open: (/** @type {Candidate} */ c) => {
        location.hash = linked(c, of, {
          p: c.pressure_mpa,
          e: c.points[0].contraction,
        });
      },
      ask(/** @type {Record<string, string>} */ words) {
        Object.entries(words).forEach(([key, text]) => spec.put(key, text));
        search.run();
      },
    };
    const show = (/** @type {Map<string, string>} */ known) =>
      results.replaceChildren(
        ...(answer.candidates[0]
          ? foundView(answer, known, act)
          : closestView(answer)),
        ...rejectedView(answer),
      );
    show(new Map());
    if (!answer.candidates.some((c) => c.tube || c.sleeve)) return;
    const known = await priced();
    if (answer === found && known.size) show(known);
  }

  main.replaceChildren(
    bench(
      "Specification",
      [heading("Specification"), ...spec.elements, search.element],
      [results, target.element, ...map.elements, figures.element],
    ),
  );
  onUnits(() => {
    paint();
    target.draw();
    map.draw();
  });
  return {
    async load(params) {
      // The muscle's own words mean other things here: it is one word.
      const own = params.get("m");
      if (own) await muscle.read(new URLSearchParams(own));
      else await Promise.all([muscle.known(), muscle.shown ?? muscle.look()]);
      spec.set(params);
      spec.options(
        "braid",
        muscle.sleeves.map((s) => s.name),
      );
      spec.offer();
      await search.run();
    },
  };
};
