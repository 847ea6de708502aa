// The answer of a design as people read it: the best muscle, the table of all, what is not sure,
// and what would fit.
import { address, pack } from "./address.js";
import { picture } from "./body.js";
import {
  button,
  capital,
  csv,
  download,
  el,
  folded,
  heading,
  paragraph,
  remark,
  smallPrint,
} from "./dom.js";
import { table, warnings } from "./form.js";
import { muscle } from "./muscle.js";
import { prototype } from "./state.js";
import {
  asBuilt,
  inWords,
  number,
  outside,
  show,
  showForce,
  showLength,
  showPressure,
  showRatio,
  unitName,
} from "./units.js";

/**
 * Prices of tubes and sleeves by their names, where the catalogue has them. @typedef {Map<string,
 * string>} Prices
 */

/** The least pull to spare at any of its points. @param {Candidate} c */
const spare = (c) =>
  Math.min(...c.points.map((q) => (q.force_at_max_pressure_n * q.margin) / (1 + q.margin)));
/** @param {Candidate} c @param {Prices} prices */
const price = (c, prices) =>
  [c.tube, c.sleeve]
    .map((name) => prices.get(name ?? ""))
    .filter(Boolean)
    .join(" + ");
const grams = (/** @type {number | null | undefined} */ g) => (g ? `${number(g, 3)} g` : "–");

/**
 * Columns: heading, unit for CSV, cell for people, value for CSV.
 * @typedef {[string, string, (c: Candidate) => string, (c: Candidate) => string | number | null |
 * undefined]} Column
 */
/**
 * @param {Prices} prices @param {boolean} liquid whether the muscles are filled with one
 * @returns {Column[]}
 */
function columns(prices, liquid) {
  /**
   * @param {string} head @param {string} kind
   * @param {(c: Candidate) => number | null | undefined} of @returns {Column}
   */
  const quantity = (head, kind, of, digits = 4) => [
    head,
    unitName(kind),
    (c) => show(kind, of(c), digits),
    (c) => {
      const v = of(c);
      return v == null ? "" : Number(outside(kind, v).toPrecision(8));
    },
  ];
  /**
   * @param {string} head @param {(c: Candidate) => string | null | undefined} of @returns {Column}
   */
  const words = (head, of) => [head, "", (c) => of(c) ?? "", of];
  return [
    words("tube", (c) => c.tube),
    words("sleeve", (c) => c.sleeve),
    quantity("D0", "length", (c) => c.outer_diameter_mm),
    quantity("s", "length", (c) => c.wall_mm),
    quantity("L0", "length", (c) => c.length_mm),
    quantity("θ0", "angle", (c) => c.angle_deg),
    words("rubber", (c) => c.rubber),
    quantity("set", "pressure", (c) => c.pressure_mpa, 3),
    quantity("spare pull", "force", spare, 3),
    [
      "± of the pull",
      unitName("force"),
      (c) => (c.uncertainty_n ? `± ${showForce(c.uncertainty_n, 2)}` : "–"),
      (c) => c.uncertainty_n && outside("force", c.uncertainty_n),
    ],
    quantity("95 % certain at", "pressure", (c) => c.sure_pressure_mpa, 3),
    quantity("width in use", "length", (c) => c.bulged_diameter_mm),
    quantity(
      "burst pressure",
      "pressure",
      (c) => c.least_burst_pressure_mpa ?? c.burst_pressure_mpa,
      3,
    ),
    liquid
      ? [
          "liquid per stroke",
          "mL",
          (c) => (c.liquid_volume_mm3 ? `${number(1e-3 * c.liquid_volume_mm3, 3)} mL` : "–"),
          (c) => c.liquid_volume_mm3 && 1e-3 * c.liquid_volume_mm3,
        ]
      : [
          "air per stroke",
          "normal L",
          (c) => (c.air_normal_litres ? `${number(c.air_normal_litres, 3)} L` : "–"),
          (c) => c.air_normal_litres,
        ],
    ["mass", "g", (c) => grams(c.mass_g ?? c.rubber_mass_g), (c) => c.mass_g ?? c.rubber_mass_g],
    words("price", (c) => price(c, prices) || "–"),
  ];
}

/** Whether muscles are filled with a liquid. @param {Candidate[]} candidates */
const filled = (candidates) => candidates.some((c) => c.liquid_volume_mm3);

/**
 * Columns that tell the candidates apart: a rubber that tubes name, and one length of all, is said
 * above.
 * @param {Candidate[]} candidates @param {Prices} prices
 */
function shownColumns(candidates, prices) {
  const named = candidates.every((c) => c.tube),
    sleeved = candidates.every((c) => c.sleeve);
  const same = {
    rubber: named,
    s: named,
    θ0: sleeved,
    L0: candidates.every((c) => c.length_mm === candidates[0].length_mm),
    tube: candidates.every((c) => !c.tube),
    sleeve: candidates.every((c) => !c.sleeve),
  };
  return columns(prices, filled(candidates)).filter(
    ([name]) => !(/** @type {Record<string, boolean>} */ (same)[name]),
  );
}

/** @param {Candidate[]} candidates @param {Prices} prices */
function rowsOf(candidates, prices) {
  const list = columns(prices, filled(candidates)),
    head = list.map(([name, unit]) => (unit ? `${name} [${unit}]` : name));
  return [head, ...candidates.map((c) => list.map(([, , , of]) => of(c)))];
}

/**
 * A candidate as its own file: branch and required pulls are in it.
 * @param {Design["answer"]} answer
 */
export async function openCandidate({ candidates, muscle_files = [], max_pressure_mpa }, i = 0) {
  const { pressure_mpa: p, points, joint, highest_pressure_mpa } = candidates[i],
    state = { ...prototype(), file: muscle_files[i].text, p, e: points[0].contraction },
    pulley = joint && {
      r: `${joint.radius_mm}mm`,
      e0: `${joint.contraction_at_neutral}`,
      low: `-${joint.largest_angle_deg}deg`,
      high: `${joint.largest_angle_deg}deg`,
      pmax: `${highest_pressure_mpa ?? max_pressure_mpa}MPa`,
    };
  await pack(state.file);
  location.hash = address(joint ? "joint" : "muscle", { ...muscle.paramsOf(state), ...pulley });
}

/** The decision: what each line is about, and the line. @param {Design["answer"]} answer */
export const decisionView = ({ decision = [] }) =>
  el(
    "ul",
    { class: "decision" },
    ...decision.map((line) => {
      const [, about, rest] = /^(\S+)(.*)$/.exec(inWords(line)) ?? [];
      return el("li", el("b", about), rest);
    }),
  );

/**
 * The decision, and how to ask for a muscle that is sure.
 * @param {Design["answer"]} answer @param {() => void} certain
 */
export function headView(answer, certain) {
  const [best] = answer.candidates,
    words = answer.uncertainty_words,
    { joint } = best;
  const size =
    `Outer diameter ${showLength(best.outer_diameter_mm, 4)}, wall ${showLength(best.wall_mm)}, ` +
    `length ${showLength(best.length_mm)}, braid ${show("angle", best.angle_deg)}`;
  const sentences = [
    words?.built && `As built ${words.built}.`,
    words?.text && `${words.text}.`,
  ].filter(Boolean);
  return there([
    heading(size),
    decisionView(answer),
    joint &&
      paragraph(
        `Pulley of radius ${showLength(joint.radius_mm, 3)}, ` +
          `${showRatio(joint.contraction_at_neutral, 3)} contracted at the neutral angle.`,
      ),
    !answer.searched.guaranteed && button("Design for 95 % certainty", certain),
    sentences.length > 0 && remark(inWords(sentences.join(" "))),
    warnings(answer.warnings),
  ]);
}

/** What stands beside the first muscle. @param {Design["answer"]} answer */
function choices({ choices = [] }) {
  const rows = choices.map((c) => [
    c.name,
    showLength(c.envelope_mm, 3),
    showLength(c.length_mm),
    showPressure(c.pressure_mpa, 3),
    `${showForce(c.predicted_low_n, 2)} to ${showForce(c.predicted_high_n, 2)}`,
    c.parts,
  ]);
  return (
    rows.length > 0 &&
    table(["choice", "width", "L0", "set", "pulls (95 %)", "parts"], rows, {
      text: [0, 5],
      label: "One muscle, and what could take its place",
    })
  );
}

/** Where it is asked at several points. @param {Candidate} best */
function points(best) {
  const rows = best.points.map((p) => [
    showForce(p.force_n),
    asBuilt(p),
    showForce(p.model_force_n),
    showRatio(p.contraction, 3),
    showPressure(p.pressure_mpa, 3),
  ]);
  return (
    rows.length > 1 &&
    table(["pull", "as built", "model alone", "at", "set"], rows, {
      text: [],
      label: "the operating points",
    })
  );
}

/** A candidate in use, to the scale of all. @param {Candidate} c @param {Candidate[]} all */
function inUse(c, all) {
  const most = (/** @type {(one: Candidate) => number} */ of) => Math.max(...all.map(of));
  const box = el("span", { class: "thumbnail" });
  box.innerHTML = picture(
    c,
    most((one) => one.length_mm),
    most((one) => one.bulged_diameter_mm ?? one.outer_diameter_mm),
  );
  return box;
}

/** What there is of a list. @param {(HTMLElement | false | null | undefined)[]} list */
const there = (list) => list.flatMap((part) => (part ? [part] : []));

/**
 * What was found.
 * @param {Design["answer"]} answer @param {Prices} prices
 */
export function foundView(answer, prices) {
  const { candidates, assumptions = [] } = answer,
    list = shownColumns(candidates, prices);
  const rows = candidates.map((c) => [inUse(c, candidates), ...list.map(([, , cell]) => cell(c))]);
  const text = list.flatMap(([name], i) =>
    ["tube", "sleeve", "rubber", "price"].includes(name) ? [i + 1] : [],
  );
  const save = () => download("design.csv", csv(rowsOf(candidates, prices)));
  const words =
    `${answer.fitting} of ${answer.looked_at} muscles fit; the best ${candidates.length} are listed. ` +
    `Click one to show it. 95 % certain at: pull minus ± meets the requirement.`;
  return there([
    choices(answer),
    table(["", ...list.map(([name]) => name)], rows, {
      text,
      pick: (i) => openCandidate(answer, i),
      label: "Muscles that fit, best first",
    }),
    el(
      "p",
      { class: "row small soft" },
      el("span", { class: "grow" }, words),
      button("CSV of the table", save),
    ),
    points(candidates[0]),
    boughtView(answer),
    assumptions.length > 0 &&
      folded(
        "What was assumed",
        el(
          "ul",
          { class: "small" },
          ...assumptions.map((line) => el("li", capital(inWords(line)))),
        ),
      ),
  ]);
}

/** Muscles as sold that would do. @param {Design["answer"]} answer */
function boughtView({ bought }) {
  const one = (/** @type {NonNullable<Design["answer"]["bought"]>[number]} */ b) =>
    `${b.product} (${b.name}, L0 ${showLength(b.length_mm)}): as built ${showForce(b.force_n)} ± ${showForce(b.uncertainty_n, 2)} ` +
    `at ${showRatio(b.wanted.contraction, 3)} and ${showPressure(b.pressure_mpa, 3)}`;
  return bought?.length
    ? smallPrint(`Sold muscles that fit: ${bought.map(one).join("; ")}.`)
    : null;
}

/** What comes closest where nothing fits. @param {Design["answer"]} answer */
export function closestView(answer) {
  const c = answer.closest,
    size = c && `D0 ${showLength(c.outer_diameter_mm)}, s ${showLength(c.wall_mm)}`;
  return there([
    heading("Nothing fits."),
    c && paragraph(`Closest: ${size}${c.sleeve ? ` in ${c.sleeve}` : ""}: ${inWords(c.reason)}.`),
    warnings(answer.warnings),
    c?.hint ? paragraph(capital(inWords(c.hint))) : null,
    boughtView(answer),
    c && el("ul", ...c.relaxations.map((r) => el("li", capital(inWords(r.text))))),
  ]);
}

/** @param {Design["answer"]} answer */
export function rejectedView({ rejected }) {
  const sizes = (/** @type {number[]} */ list) => list.map((v) => showLength(v));
  const rows = (rejected ?? []).map((r) => [
    ...sizes([r.outer_diameter_mm, r.wall_mm, r.length_mm]),
    inWords(r.reason),
  ]);
  return there([
    rows.length > 0 &&
      folded("Why others fail", table(["D0", "s", "L0", "reason"], rows, { text: [3] })),
  ]);
}
