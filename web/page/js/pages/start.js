// The first screen: what a McKibben muscle is, one question, and its answer.
import { address } from "../address.js";
import { Slot, engine } from "../ask.js";
import { closestView, decisionView, openCandidate } from "../design-view.js";
import { block, button, dim, el, mainButton, problemBox, rowOf } from "../dom.js";
import { fieldsOf, form, kindsOf, warnings } from "../form.js";
import { liftView } from "../lift.js";
import { openDialog } from "../open.js";
import { onUnits, showLength, showPressure } from "../units.js";

/** What each is the best for, and what is asked for it. @type {[string, Design["request"]][]} */
const WISHES = [
  ["Recommended", { objective: "bulged-diameter" }],
  ["Least air", { objective: "air" }],
  ["Strong enough with 95 % certainty", { objective: "bulged-diameter", guaranteed: 0.95 }],
];
/** @type {Field[]} */
const WANTED = fieldsOf([
  ["F", "force_n", "It must pull", "force", "300 N"],
  ["M", "torques", "It must turn with", "torque", "8 N m"],
  ["m", "load", "It must lift", "mass", "20 kg"],
  ["e", "contraction", "while it shortens by", "ratio", "15 %"],
  ["angle", "angle_deg", "at", "angle", "45°"],
  ["stroke", "stroke_mm", "by", "length", "40 mm"],
  ["pmax", "max_pressure_mpa", "at", "pressure", "2.5 bar"],
]);
/** What it must do, each with its fields. @type {[string, string, string[]][]} */
const KINDS = [
  ["pull", "Pull", ["F", "e"]],
  ["joint", "Joint", ["M", "angle"]],
  ["load", "Load", ["m", "stroke"]],
];
/** The reference muscle, until there is an answer. */
const REFERENCE = {
  candidates: [
    {
      count: 1,
      outer_diameter_mm: 30,
      length_mm: 285,
      angle_deg: 28,
      points: [{ contraction: 0.15, force_n: 210 }],
    },
  ],
};

/** What to set, and how wide it gets. @param {Candidate} c */
const inUse = ({ count, pressure_mpa: set, bulged_diameter_mm: wide }) =>
  `${showPressure(set, 3)}, ${count > 1 ? `${count} × ` : ""}${showLength(wide, 3)} wide`;

/** @type {Mount} */
export const mount = (main) => {
  let kind = "pull",
    chosen = 0,
    of = "";
  /** @type {(Design["answer"] | Problem | undefined)[]} */ let answers = [];
  const slots = WISHES.map(() => new Slot()),
    lift = liftView(),
    fields = form(WANTED, () => ask());
  const result = block(),
    head = el("h2", { class: "grow", ariaLive: "polite" }),
    chips = block("chips"),
    act = rowOf();

  function paint() {
    const answer = answers[chosen];
    chips.replaceChildren(
      ...WISHES.map(([title], i) => {
        const one = answers[i],
          best = one && "candidates" in one ? one.candidates[0] : undefined;
        const said = best ? inUse(best) : one ? "none" : "…";
        return el(
          "button",
          {
            type: "button",
            class: "card",
            onclick: () => choose(i),
            ariaPressed: String(i === chosen),
          },
          el("span", { class: "small soft" }, title),
          el("b", said),
        );
      }),
    );
    // The first muscle says what a muscle is, not what is asked.
    dim([result, head, lift.element], !answer && result.hasChildNodes());
    act.hidden = !answer;
    if (!answer) return;
    const isFound = "candidates" in answer;
    act.hidden = !isFound || !answer.candidates[0];
    head.hidden = act.hidden;
    if (!isFound) return result.replaceChildren(fields.at(answer) ? "" : problemBox(answer));
    dim([lift.element], act.hidden);
    if (act.hidden) return result.replaceChildren(...closestView(answer));
    head.textContent = `Yes: set ${inUse(answer.candidates[0])}.`;
    result.replaceChildren(decisionView(answer), warnings(answer.warnings));
    lift.show(answer);
    act.replaceChildren(
      mainButton("Open this muscle", () => openCandidate(answer)),
      button("More requirements", more, { class: "bare" }),
    );
  }
  function choose(/** @type {number} */ i) {
    chosen = i;
    paint();
  }
  const more = () => {
    const text = (/** @type {string} */ key) => fields.text(key);
    const own = {
      pull: { F: text("F"), e: text("e") },
      joint: { joint: `${text("M")} at ${text("angle")}` },
      load: { load: text("m"), stroke: text("stroke") },
    }[kind];
    location.hash = address("design", { ...own, pmax: text("pmax") });
  };

  /** @param {number} i @param {Design["request"]} request @param {() => void} [then] */
  function search(i, request, then) {
    const mine = of;
    const take = (/** @type {Design["answer"] | Problem} */ answer) => {
      if (mine !== of) return;
      answers[i] = answer;
      paint();
      then?.();
    };
    slots[i].ask("design", { ...request, ...WISHES[i][1], top: 1 }, take, take);
  }
  async function ask() {
    const read = await fields.read();
    if (!read) {
      of = "";
      answers = [];
      return paint();
    }
    const { load, torques, angle_deg, ...request } = read;
    if (load !== undefined) request.load = `${load} kg`;
    if (torques !== undefined) request.torques = [{ torque_nm: torques, angle_deg }];
    // Enter and a pause in typing ask the same.
    const next = JSON.stringify(request);
    if (next === of) return paint();
    of = next;
    if (!answers[chosen]) head.textContent = "Searching …";
    answers = [];
    paint();
    // The first answer comes first.
    const first = chosen;
    search(first, request, () => WISHES.forEach((_, i) => i !== first && search(i, request)));
  }
  // The picture says it, and a drawing would hide the answer.
  for (const { row } of fields.rows.values()) delete row.dataset.sketch;
  const what = kindsOf(fields, KINDS, (name) => {
    kind = name;
    ask();
  });
  let waits = 0;
  fields.element.addEventListener("input", () => {
    clearTimeout(waits);
    waits = window.setTimeout(ask, 300);
  });
  onUnits(paint);
  main.replaceChildren(
    block(
      "start",
      lift.element,
      block(
        "question",
        el(
          "h1",
          "A McKibben muscle is a rubber tube in a braided sleeve that gets thicker and shorter under pressure and pulls.",
        ),
        what.list,
        fields.element,
        block("row", head, act),
        chips,
        result,
        button("Open a muscle", openDialog, { class: "bare" }),
      ),
    ),
  );
  // A page that brings its engine loads that of the search when it is asked for.
  const isLarge = engine().files?.length;
  lift.show(REFERENCE);
  return {
    async load() {
      if (isLarge) {
        head.replaceChildren(mainButton("Find a muscle", ask));
        fields.element.addEventListener("focusin", ask, { once: true });
      } else ask();
    },
  };
};
