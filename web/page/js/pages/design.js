// From a specification to ranked muscles, with a map of what is feasible and why the rest is not.
import { engine } from "../ask.js";
import { address, write } from "../address.js";
import { picture } from "../body.js";
import { designMap } from "../design-map.js";
import { designTarget } from "../design-target.js";
import { closestView, foundView, headView, rejectedView } from "../design-view.js";
import { block, folded, heading } from "../dom.js";
import { fieldsOf, form, inputs, job, kindsOf } from "../form.js";
import { muscle } from "../muscle.js";
import { STIFFNESS_NAMES, candidate, missing } from "../state.js";
import { onUnits, typed } from "../units.js";

const OBJECTIVES = /** @type {[string, string][]} */ ([
  ["diameter", "slimmest at rest"],
  ["pressure", "lowest pressure"],
  ["air", "least air or liquid"],
  ["margin", "largest margin of pull"],
  ["bulged-diameter", "recommended: slim, sold, sure"],
  ["length", "shortest"],
]);
/** @type {Field[]} */
export const WANTED = fieldsOf([
  ["F", "force_n", "Pull", "force", "300 N"],
  ["e", "contraction", "at a contraction of", "ratio", "15 %"],
  [
    "at",
    "points",
    "Pulls",

    {
      pair: [
        ["force", "force_n"],
        ["ratio", "contraction"],
      ],
      hint: "700 N at 15 %, 1200 N at 5 %",
    },
  ],
  [
    "joint",
    "torques",
    "Torques",

    {
      pair: [
        ["torque", "torque_nm"],
        ["angle", "angle_deg"],
      ],
      hint: "8 N m at 45°",
    },
  ],
  ["load", "load", "Load", { hint: "20 kg" }],
  ["stroke", "stroke_mm", "Stroke", "length", { hint: "40 mm" }],
  ["pmax", "max_pressure_mpa", "Pressure of the supply", "pressure", "2.5 bar"],
  ["bulge", "max_bulged_diameter_mm", "Largest bulged diameter", "length", { hint: "60 mm" }],
  ["sure", "guaranteed", "Certainty", "ratio", { hint: "95 %" }],
  ["for", "objective", "Rank by", { options: OBJECTIVES, value: "bulged-diameter" }],
]);
/** What the muscle must do, each with its fields. @type {[string, string, string[]][]} */
const KINDS = [
  ["F", "Pull", ["F", "e", "stroke"]],
  ["at", "Pulls", ["at", "stroke"]],
  ["joint", "Joint", ["joint"]],
  ["load", "Load", ["load", "e", "stroke"]],
];
/** @type {() => Field[]} */
export const choices = () =>
  fieldsOf([
    ["D", "outer_diameter_mm", "Outer diameters", "length", { list: true, hint: "10..60 mm" }],
    ["s", "wall_mm", "Walls", "length", { list: true, hint: "1..4:0.5 mm" }],
    ["L", "length_mm", "Length", "length", { list: true, hint: "285 mm" }],
    ["angle", "angle_deg", "Braid angles", "angle", { list: true, hint: "28 deg" }],
    ["rubber", "rubbers", "Rubbers", { words: true, hint: "paper, ecoflex-00-30" }],
    ["braid", "braids", "Sleeves as sold", { words: true, hint: "names of the list" }],
    [
      "sd",
      "strand_diameter_mm",
      "Diameter of a strand",
      "length",
      { hint: "0.25 mm", hidden: true },
    ],
    [
      "sE",
      "strand_modulus_mpa",
      "Young's modulus of a strand",
      "modulus",
      { hint: "2500 MPa", hidden: true },
    ],
    [
      "k",
      "stiffness",
      "Stiffness of a strand family",
      "stiffness",
      { or: STIFFNESS_NAMES, hint: "500 N/mm; inextensible" },
    ],
    ["r", "radius_mm", "Pulley of a joint", "length", { list: true, hint: "20..40 mm" }],
    ["liquid", "liquid", "Liquid in the place of air", { hint: "water, oil or glycol" }],
    ["most", "max_liquid_volume_mm3", "Largest liquid volume", "volume", { hint: "20 mL" }],
    [
      "burst",
      "min_burst_margin",
      "Safety factor of strands and clamps",
      "ratio",
      { factor: true, hint: "4" },
    ],
  ]);

/** The forms of a specification, and the request that they make. @param {() => void} submit */
function specification(submit) {
  const wanted = form(WANTED, submit),
    choice = form(choices(), submit),
    forms = [wanted, choice];
  const vary = folded("Search space", choice.element);
  const others = KINDS.slice(1).map(([kind]) => kind);
  const kinds = kindsOf(wanted, KINDS, (kind) => {
    const { hint = "" } = WANTED.find(({ key }) => key === kind) ?? {};
    for (const key of others) wanted.put(key, key === kind ? hint : "");
    submit();
  });
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
        names.flatMap((braid) => missing({ said: k ? { braid, k } : { braid } }, muscle.sleeves)),
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
    elements: [kinds.list, wanted.element, vary],
    offer,
    wanted,
    choice,
    texts: () => Object.assign({}, ...forms.map((f) => f.texts())),
    set(/** @type {URLSearchParams} */ params) {
      forms.forEach((f) => f.set(params));
      kinds.select(others.find((key) => wanted.text(key)) ?? "F");
    },
    /**
     * The request, or nothing where a text cannot be read.
     * @returns {Promise<Design["request"] | undefined>}
     */
    async read() {
      const [want, space] = await Promise.all([wanted.read(), choice.read({ intervals: true })]);
      if (!want || !space) return undefined;
      // The stroke of a load says how far.
      if (want.load && want.stroke_mm) delete want.contraction;
      return { ...want, ...space };
    },
    /** @param {Problem} problem */
    at(problem) {
      for (const key of lacking())
        if (!choice.text(key))
          choice.mark(
            key,
            "The source of the sleeve does not state it: measure it, or give a stiffness.",
          );
      return forms.some((f) => f.at(problem));
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
            return price ? [/** @type {[string, string]} */ ([part.name, price])] : [];
          }),
        ),
      () => new Map(),
    ));

/**
 * The address of a muscle of the search: that muscle, and nothing of the one of the other pages.
 * @param {Chosen} c @param {Design["request"]} of the request @param {{ p: number, e: number }} at
 */
const linked = (c, of, at) => address("muscle", muscle.paramsOf(candidate(c, of, at)));

/** @type {Mount} */
export const mount = (main) => {
  /** @type {Design["answer"] | undefined} */ let found;
  /**
   * What the answer that is shown was asked by, and the newest question. @type {Design["request"]}
   */
  let of = {},
    /** @type {Design["request"] | undefined} */ asked;
  const spec = specification(() => search.run());
  const drawn = block("best"),
    side = block(),
    list = block("below");
  const map = designMap((c, at) => linked(c, of, at));
  const target = designTarget({
    moved: (to) => map.preview(to),
    settled(to) {
      spec.wanted.put("F", typed("force", to.force_n));
      spec.wanted.put("e", typed("ratio", to.contraction));
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
      target.show(found, of);
      map.show(found, of);
    },
    { fields: spec, shown: [drawn, side, list, target.element, ...map.elements] },
  );
  const place = () => write(address("design", { ...spec.texts(), m: muscle.word() }));

  async function paint() {
    if (!found) return;
    const answer = found;
    const certain = () => {
      spec.wanted.put("sure", "95 %");
      search.run();
    };
    const [best] = answer.candidates;
    drawn.hidden = !best;
    if (best)
      drawn.innerHTML = picture(
        best,
        best.length_mm,
        best.bulged_diameter_mm ?? best.outer_diameter_mm,
      );
    side.replaceChildren(...(best ? headView(answer, certain) : closestView(answer)));
    const show = (/** @type {Map<string, string>} */ known) =>
      list.replaceChildren(...(best ? foundView(answer, known) : []), ...rejectedView(answer));
    show(new Map());
    if (!answer.candidates.some((c) => c.tube || c.sleeve)) return;
    const known = await priced();
    if (answer === found && known.size) show(known);
  }

  main.replaceChildren(
    block(
      "bench",
      inputs("Specification", heading("Specification"), ...spec.elements, search.element),
      block("middle", drawn, ...map.elements, target.element),
      block("side", side),
      list,
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
      spec.choice.options(
        "braid",
        muscle.sleeves.map((s) => s.name),
      );
      spec.offer();
      await search.run();
    },
  };
};
