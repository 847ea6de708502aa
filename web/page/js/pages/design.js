// Ask: what a McKibben muscle is, one question, its answer with its chance, and all that fits.
import { answerTo, engine } from "../ask.js";
import { chanceCurve, verdict } from "../chance.js";
import {
  choicesView,
  closestView,
  foundView,
  headView,
  openCandidate,
  rejectedView,
  widthOf,
} from "../design-view.js";
import { block, button, dim, el, folded, mainButton, rowOf, tabs } from "../dom.js";
import { fieldsOf, form, job } from "../form.js";
import { keepWords } from "../kept.js";
import { liftView } from "../lift.js";
import { muscle } from "../muscle.js";
import { openDialog } from "../gallery.js";
import { STIFFNESS_NAMES, missing } from "../state.js";
import { showPressure } from "../units.js";
import { rested, signal, watch } from "../watch.js";

/** @type {[string, string][]} */ const OBJECTIVES = [
  ["bulged-diameter", "recommended: slim, sold"],
  ["diameter", "slimmest at rest"],
  ["pressure", "lowest pressure"],
  ["air", "least air or liquid"],
  ["length", "shortest"],
  ["mass", "lightest"],
  ["chance", "surest"],
];
/** The question. @type {Field[]} */
export const WANTED = fieldsOf([
  ["F", "force_n", "It must pull", "force", "300 N"],
  ["e", "contraction", "while it shortens by", "ratio", "15 %"],
  [
    "at",
    "points",
    "It must reach",
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
    "It must turn with",
    {
      pair: [
        ["torque", "torque_nm"],
        ["angle", "angle_deg"],
      ],
      hint: "8 N m at 45°",
    },
  ],
  ["load", "load", "It must lift", { hint: "20 kg" }],
  ["stroke", "stroke_mm", "over a stroke of", "length", { hint: "any" }],
  ["pmax", "max_pressure_mpa", "at", "pressure", "2.5 bar"],
]);
/** What the muscle must do, each with its fields. @type {[string, string, string[]][]} */
const KINDS = [
  ["F", "Pull", ["F", "e", "stroke"]],
  ["at", "Several pulls", ["at", "stroke"]],
  ["joint", "Joint", ["joint"]],
  ["load", "Load", ["load", "stroke"]],
];
/** What else may be asked, and what is searched. @type {() => Field[]} */
export const choices = () =>
  fieldsOf([
    ["sure", "certainty", "Certainty", "ratio", { hint: "90 %" }],
    ["for", "objective", "Rank by", { options: OBJECTIVES, value: "bulged-diameter" }],
    ["bulge", "max_bulged_diameter_mm", "Largest bulged diameter", "length", { hint: "60 mm" }],
    ["D", "outer_diameter_mm", "Outer diameters", "length", { list: true, hint: "10..60 mm" }],
    ["s", "wall_mm", "Walls", "length", { list: true, hint: "1..4:0.5 mm" }],
    ["L", "length_mm", "Length", "length", { list: true, hint: "285 mm" }],
    ["angle", "angle_deg", "Braid angles", "angle", { list: true, hint: "28 deg" }],
    ["rubber", "rubbers", "Rubbers", { words: true, hint: "latex, ecoflex-00-30" }],
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
    forms = [wanted, choice],
    more = folded("More requirements", choice.element);
  const hint = (/** @type {string} */ key) => WANTED.find((f) => f.key === key)?.hint ?? "";
  const kinds = tabs(
    "What it must do",
    KINDS.map(([kind, text]) => [kind, text]),
    "",
    (kind) => {
      select(kind);
      for (const key of ["at", "joint", "load"]) wanted.put(key, key === kind ? hint(key) : "");
      wanted.put("stroke", kind === "load" ? "40 mm" : "");
      submit();
    },
  );
  /** Its fields are seen. @param {string} chosen */
  function select(chosen) {
    kinds.set(chosen);
    const own = KINDS.find(([kind]) => kind === chosen)?.[2];
    for (const key of KINDS.flatMap(([, , keys]) => keys))
      wanted.shown(key, Boolean(own?.includes(key)));
  }
  /** What the sleeves need beside their names has a field. */
  const lacking = () => {
    const k = choice.text("k"),
      names = choice.text("braid").split(/\s*,\s*/);
    return names.flatMap((braid) =>
      missing({ said: k ? { braid, k } : { braid } }, muscle.sleeves),
    );
  };
  const offer = () => {
    const lacks = lacking();
    for (const key of ["sd", "sE"]) choice.shown(key, lacks.includes(key));
  };
  choice.element.addEventListener("input", offer);
  return {
    element: block("", kinds.list, wanted.element, more),
    texts: () => Object.assign({}, ...forms.map((f) => f.texts())),
    /** Another certainty. @param {number} chance */
    ensure(chance) {
      more.open = true;
      choice.put("sure", `${100 * chance} %`);
      submit();
    },
    /** @param {URLSearchParams} params */
    set(params) {
      forms.forEach((f) => f.set(params));
      select(["at", "joint", "load"].find((key) => wanted.text(key)) ?? "F");
      more.open = Object.values(choice.texts()).some(Boolean);
      choice.options(
        "braid",
        muscle.sleeves.map((s) => s.name),
      );
      offer();
    },
    /** @returns {Promise<Design["request"] | undefined>} nothing where a text cannot be read */
    async read() {
      const [want, space] = await Promise.all([wanted.read(), choice.read({ intervals: true })]);
      // What it must lift is a mass.
      const load = want?.load?.replace(/^[-\d.]+$/, "$& kg");
      return want && space && { ...want, ...space, load };
    },
    /** @param {Problem} problem */
    at(problem) {
      for (const key of lacking())
        if (!choice.text(key))
          choice.mark(
            key,
            "The source of the sleeve does not state it: measure it, or give a stiffness.",
          );
      return forms.map((f) => f.at(problem)).some(Boolean);
    },
  };
}

/** What to set, and how wide it gets. @param {Candidate} c */
const inUse = (c) => `${showPressure(c.pressure_mpa, 3)}, ${widthOf(c)} wide`;

/** @type {Mount} */
export const mount = (main) => {
  /** @type {Signal<Design["answer"] | undefined>} */ const first = signal(),
    /** @type {Signal<Design["answer"] | undefined>} */ all = signal(),
    /** @type {Signal<Map<string, string>>} */ known = signal(new Map());
  /** The question of the answer that comes. */
  /** @type {Signal<Design["request"] | undefined>} */ const question = signal();
  const spec = specification(() => ask.run());
  const head = el("h2", { class: "grow", ariaLive: "polite" }),
    act = rowOf(),
    result = block(),
    others = block(),
    list = block("below"),
    lift = liftView();
  const ask = job(
    "Find a muscle",
    "design",
    async () => {
      // At once: a text that is read late takes no answer of a later one away.
      first.value = all.value = undefined;
      const asked = await spec.read();
      question.value = asked;
      if (asked) keepWords("design", spec.texts());
      return asked && { ...asked, top: 1 };
    },
    (answer) => {
      first.value = answer;
      if (answer.candidates.length) whole.run();
    },
    {
      fields: {
        at(problem) {
          question.value = undefined;
          return spec.at(problem);
        },
      },
    },
  );
  const whole = job(
    "All that fit",
    "design",
    async () => question.value,
    (answer) => {
      all.value = answer;
      answerTo("parts-list", { kind: "tubes" }).then(
        ({ tubes }) => (known.value = new Map(tubes.map(({ name, price }) => [name, price ?? ""]))),
        () => {},
      );
    },
    { minor: true },
  );
  const curve = chanceCurve();

  watch(() => {
    const answer = first.value,
      best = answer?.candidates[0];
    // Until the answer comes no number of another muscle stands beside the question.
    for (const part of [head, result, lift.element])
      part.classList.toggle("skeleton", !answer && Boolean(question.value));
    act.hidden = !best;
    lift.show(best);
    if (!answer) {
      head.textContent = question.value ? "Searching …" : "";
      return result.replaceChildren();
    }
    if (!best) {
      head.textContent = "";
      return result.replaceChildren(...closestView(answer), rejectedView(answer));
    }
    const said = verdict(best.chance);
    head.textContent = `${said ? `${said}: set` : "Set"} ${inUse(best)}.`;
    act.replaceChildren(
      mainButton("Open this muscle", () => openCandidate(answer, question.value)),
    );
    result.replaceChildren(...headView(answer));
  });
  watch(() => {
    const { choices = [] } = first.value ?? {};
    others.replaceChildren(choicesView(choices, spec.ensure), curve.element);
    curve.show(choices);
  });
  watch(() => {
    const answer = all.value;
    list.replaceChildren(
      ...(answer ? [...foundView(answer, question.value, known.value), rejectedView(answer)] : []),
    );
    dim([list], !answer);
    whole.element.hidden = !first.value?.candidates.length;
  });

  /** A page that brings its engine loads that of the search when it is asked for. */
  let large = Boolean(engine().files?.length);
  const soon = rested(ask.run, 300);
  spec.element.addEventListener("input", () => {
    if (!large) soon();
  });
  spec.element.addEventListener("focusin", () => {
    if (large) ask.run();
    large = false;
  });
  main.replaceChildren(
    block(
      "start",
      block(
        "question",
        el(
          "h1",
          "A McKibben muscle is a rubber tube in a braided sleeve that gets thicker and shorter under pressure and pulls.",
        ),
        spec.element,
        ask.element,
        block("row", head, act),
        result,
        button("Open a muscle", openDialog, { class: "bare" }),
      ),
      lift.element,
    ),
    others,
    whole.element,
    list,
  );
  return {
    async load(params) {
      // The muscle's own words mean other things here: it is one word.
      const own = params.get("m");
      if (own || !muscle.shown) await muscle.read(new URLSearchParams(own ?? ""));
      spec.set(params);
      if (!large || [...params.keys()].some((key) => key !== "m")) await ask.run();
    },
  };
};
