// The answer of a design as people read it: what to take and set, what else could take its place,
// the table of all, and what would fit.
import { certaintyOf, inTen } from "./chance.js";
import { csv } from "./columns.js";
import {
  button,
  capital,
  download,
  el,
  folded,
  heading,
  notice,
  paragraph,
  table,
  warnings,
} from "./dom.js";
import { muscle, visit } from "./muscle.js";
import { prototype } from "./state.js";
import { thumbnail } from "./thumbnail.js";
import {
  asBuilt,
  inWords,
  outside,
  show,
  showForce,
  showLength,
  showPressure,
  showRatio,
  unitName,
} from "./units.js";

/** Prices of tubes and sleeves by their names. @typedef {Map<string, string>} Prices */
/** @typedef {import("./chance.js").Choice} Choice */

/** How many side by side, and how wide each gets. @param {Pick<Candidate, "count" | "width_mm">} c */
export const widthOf = ({ count, width_mm: width }) =>
  `${count > 1 ? `${count} × ` : ""}${showLength(width, 3)}`;
/** The pressure to begin with, and between which nine of ten end. @param {Choice} c */
const set = ({ pressure_mpa: p, pressure_low_mpa: low, pressure_high_mpa: high }) =>
  showPressure(p, 3) +
  (low && high ? ` (${[low, high].map((v) => showPressure(v, 3)).join(" to ")})` : "");
const chance = (/** @type {Candidate} */ c) => (c.chance == null ? "–" : inTen(c.chance));

/** Columns: heading, value, kind of its quantity or its unit, and digits. @typedef {[string, (c: Candidate) => string | number | null | undefined, string?, number?]} Column */
/**
 * Columns that tell the candidates apart; what all have alike is said above.
 * @param {Candidate[]} all @param {Prices} prices @returns {Column[]}
 */
function columns(all, prices) {
  const price = (/** @type {Candidate} */ { tube, sleeve }) =>
    [tube, sleeve].flatMap((name) => prices.get(name ?? "") || []).join(" + ");
  /** @type {Column[]} */ const list = [
    ["tube", (c) => c.tube],
    ["sleeve", (c) => c.sleeve],
    ["D0", (c) => c.outer_diameter_mm, "length"],
    ["s", (c) => c.wall_mm, "length"],
    ["L0", (c) => c.length_mm, "length"],
    ["θ0", (c) => c.angle_deg, "angle"],
    ["rubber", (c) => c.rubber],
    ["chance", chance],
    ["set", (c) => c.pressure_mpa, "pressure", 3],
    ["± of the pull", (c) => c.uncertainty_n, "force", 2],
    ["width in use", (c) => c.width_mm, "length"],
    ["burst pressure", (c) => c.burst_pressure_mpa, "pressure", 3],
    ["liquid per stroke", (c) => c.liquid_volume_mm3, "volume", 3],
    ["air per stroke", (c) => (c.liquid_volume_mm3 ? null : c.air_normal_litres), "normal L", 3],
    ["mass", (c) => c.mass_g ?? c.rubber_mass_g, "g", 3],
    ["price", price],
  ];
  return list.filter(([head, of]) => {
    const values = new Set(all.map(of));
    if (head === "L0") return values.size > 1;
    if (head === "rubber" || head === "s") return !all.every((c) => c.tube);
    if (head === "θ0") return !all.every((c) => c.sleeve);
    return [...values].some((v) => v || v === 0);
  });
}

/**
 * A candidate as its own file: branch and required pulls are in it. A joint has the question of it,
 * of several side by side the share of one.
 * @param {Design["answer"]} answer @param {Design["request"] | undefined} asked
 */
export function openCandidate({ candidates, muscle_files = [], max_pressure_mpa }, asked, i = 0) {
  const { pressure_mpa: p, points, joint, count, highest_pressure_mpa } = candidates[i],
    [turn] = asked?.torques ?? [];
  muscle.state = { ...prototype(), file: muscle_files[i].text, p, e: points[0].contraction };
  muscle.called = "";
  if (count > 1) notice(`This is one of ${count} side by side, with its share of what was asked.`);
  if (!joint) return visit("muscle", {});
  visit("joint", {
    r: `${joint.radius_mm}mm`,
    e0: `${joint.contraction_at_neutral}`,
    low: `-${joint.largest_angle_deg}deg`,
    high: `${joint.largest_angle_deg}deg`,
    pmax: `${highest_pressure_mpa ?? max_pressure_mpa}MPa`,
    phi: turn && `${turn.angle_deg}deg`,
    M: turn && `${turn.torque_nm / count}Nm`,
    K: "0Nm/rad",
  });
}

/** The decision: what each line is about, and the line. @param {Design["answer"]} answer */
const decisionView = ({ decision = [] }) =>
  el(
    "ul",
    { class: "decision" },
    ...decision.map((line) => {
      const [, about, rest] = /^(\S+)(.*)$/.exec(inWords(line)) ?? [];
      return el("li", el("b", about), rest);
    }),
  );

/** The decision, and what was assumed for it. @param {Design["answer"]} answer */
export function headView(answer) {
  const [{ joint }] = answer.candidates,
    { uncertainty_words: said, assumptions = [] } = answer;
  const more = [said?.built && `As built ${said.built}.`, said?.text && `${said.text}.`];
  return [
    decisionView(answer),
    joint
      ? paragraph(
          `Pulley of radius ${showLength(joint.radius_mm, 3)}, ` +
            `${showRatio(joint.contraction_at_neutral, 3)} contracted at the neutral angle.`,
        )
      : "",
    warnings(answer.warnings),
    folded("What was assumed", warnings([...more.flatMap((text) => text || []), ...assumptions])),
  ];
}

/**
 * What could take the place of the first muscle; that of another chance is asked for.
 * @param {readonly Choice[]} list @param {(certainty: number) => void} ensure
 */
export function choicesView(list, ensure) {
  const rows = list.map((c) => [
    c.kind === "chance" ? button(c.name, () => ensure(certaintyOf(c)), { class: "bare" }) : c.name,
    chance(c),
    widthOf(c),
    showLength(c.envelope_mm, 3),
    showLength(c.length_mm),
    set(c),
    pulls(c),
    c.parts,
  ]);
  const head = ["choice", "chance", "width", "width of all", "L0", "set", "pulls (95 %)", "parts"];
  return list.length
    ? table(head, rows, { text: [0, 7], label: "One muscle, and what could take its place" })
    : "";
}

/** Between which a built one pulls at its first point. @param {Choice} choice */
const pulls = ({ points: [p] }) =>
  p?.predicted_low_n == null
    ? ""
    : `${showForce(p.predicted_low_n, 2)} to ${showForce(p.predicted_high_n, 2)}`;

/** Where it is asked at several points. @param {Candidate} best */
function points(best) {
  const rows = best.points.map((p) => [
    showForce(p.required_n),
    asBuilt(p),
    showForce(p.force_n),
    showRatio(p.contraction, 3),
    showPressure(p.pressure_mpa, 3),
  ]);
  return rows.length > 1
    ? table(["pull", "as built", "the model", "at", "set"], rows, {
        text: [],
        label: "the operating points",
      })
    : "";
}

/**
 * All that was found.
 * @param {Design["answer"]} answer @param {Design["request"] | undefined} asked
 * @param {Prices} prices
 */
export function foundView(answer, asked, prices) {
  const { candidates } = answer,
    list = columns(candidates, prices);
  const save = () => {
    const rows = candidates.map((c) =>
      list.map(([, of, kind]) => {
        const value = of(c);
        return kind ? Number(outside(kind, Number(value)).toPrecision(8)) : value;
      }),
    );
    const head = list.map(([name, , kind]) => (kind ? `${name} [${unitName(kind)}]` : name));
    download("design.csv", csv([head, ...rows]));
  };
  const cell = (/** @type {Candidate} */ c, /** @type {Column} */ [, of, kind, digits]) => {
    const value = of(c);
    return typeof value === "number" ? show(kind ?? "", value, digits) : value || "–";
  };
  return [
    table(
      ["", ...list.map(([name]) => name)],
      candidates.map((c) => [thumbnail(c), ...list.map((column) => cell(c, column))]),
      {
        text: list.flatMap(([, , kind], i) => (kind ? [] : [i + 1])),
        pick: (i) => openCandidate(answer, asked, i),
        label: "Muscles that fit, best first",
      },
    ),
    el(
      "p",
      { class: "row small soft" },
      el(
        "span",
        { class: "grow" },
        `${answer.fitting} of ${answer.looked_at} muscles fit; the best ${candidates.length} are ` +
          "listed. Click one to open it.",
      ),
      button("CSV of the table", save),
    ),
    points(candidates[0]),
  ];
}

/** What comes closest where nothing fits, and what would have to give. @param {Design["answer"]} answer */
export function closestView(answer) {
  const c = answer.closest,
    size = c && `D0 ${showLength(c.outer_diameter_mm)}, s ${showLength(c.wall_mm)}`;
  return [
    heading("Nothing fits."),
    c
      ? paragraph(`Closest: ${size}${c.sleeve ? ` in ${c.sleeve}` : ""}: ${inWords(c.reason)}.`)
      : "",
    warnings(answer.warnings),
    el("ul", ...(c?.relaxations ?? []).map((r) => el("li", capital(inWords(r.text))))),
  ];
}

/** @param {Design["answer"]} answer */
export function rejectedView({ rejected }) {
  const rows = (rejected ?? []).map((r) => [
    ...[r.outer_diameter_mm, r.wall_mm, r.length_mm].map((v) => showLength(v)),
    inWords(r.reason),
  ]);
  return rows.length
    ? folded("Why others fail", table(["D0", "s", "L0", "reason"], rows, { text: [3] }))
    : "";
}
