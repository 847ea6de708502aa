// The numbers of the page Muscle: the pull of the model and as built, the parts of the ±, the
// margins, and what the engine warns of.
import { button, capital, el, remark, termsOf } from "../dom.js";
import { muscle } from "../muscle.js";
import {
  asBuilt,
  inWords,
  interval,
  number,
  show,
  showForce,
  showLength,
  showPressure,
  showRatio,
} from "../units.js";
import { watch } from "../watch.js";
import { solveView, tornadoView } from "./what-if.js";

/** @typedef {NonNullable<Store["point"]["value"]>} Point */

/** @param {Store} store */
export function numbersView(store) {
  const notes = el("ul", { class: "warnings" });
  const parts = partsView(store),
    list = el("dl");
  const built = button(
    "",
    () => {
      parts.element.hidden = !parts.element.hidden;
      built.ariaExpanded = String(!parts.element.hidden);
    },
    { class: "bare", ariaExpanded: "false", title: "Parts of the ±" },
  );

  const remarks = remark(
    "As built: median and 95 % of such muscles. Model: finite elements (fe), mean of both " +
      "ways. Take-up: the way the sleeve gives before it bears.",
  );
  const element = el(
    "section",
    { class: "numbers", ariaLabel: "Numbers", hidden: true },
    el("dl", el("dt", "Pull as built"), el("dd", { class: "head" }, built)),
    parts.element,
    list,
    notes,
    solveView(store).element,
    tornadoView(store).element,
    remarks,
  );
  watch(() => {
    const point = store.point.value;
    if (!point) return;
    element.hidden = false;
    built.textContent = asBuilt(point);
    list.replaceChildren(
      ...termsOf(rows(store.facts.value, point).filter(([, text]) => text !== "–")),
    );
    notes.replaceChildren(...warned(point).map((w) => el("li", w)));
  });
  return { element };
}

/**
 * @param {Store["facts"]["value"]} facts @param {Point} point
 * @returns {[string, string][]}
 */
function rows(facts, point) {
  const c = facts.characteristics,
    as = muscle.assessed,
    limit = (/** @type {number | null | undefined} */ mpa) =>
      mpa ? showPressure(mpa, 3) : "unknown";
  return [
    [`Model ${point.model}`, point.slack ? "slack" : showForce(point.force_n)],
    ["Stiffness", show("stiffness", point.stiffness_n_per_mm, 3)],
    ["Contraction", showRatio(point.contraction, 3)],
    [
      "Contraction as built",
      interval("ratio", [as?.predicted, as?.predicted_low, as?.predicted_high]),
    ],
    [
      "Stretch of the rubber",
      facts.fitted_to_stretch
        ? `${number(point.max_stretch, 3)} of ${number(facts.fitted_to_stretch, 3)}`
        : "–",
    ],
    ["Bulged diameter", showLength(point.bulged_diameter_mm)],
    ["Cavity", point.volume_mm3 ? show("volume", point.volume_mm3, 3) : "–"],
    ["Threshold pressure", showPressure(as?.start_pressure_mpa, 3)],
    ["Blocked force", showForce(c?.blocked_force_n)],
    ["Free contraction", showRatio(c?.free_contraction, 3)],
    ["Least burst pressure", limit(c?.burst_pressure_mpa)],
    ["Allowed pressure", limit(c?.allowed_pressure_mpa)],
    ["Work over the full stroke", show("J", c?.work_j, 3)],
    ["Air over the full stroke", show("normal L", c?.air_normal_litres, 3)],
  ];
}

/** @param {Point} point */
function warned(point) {
  const unknown = muscle.unknown.map(([key]) => key).join(", ");
  const list = new Set([
    ...[...muscle.warnings, ...(point.warnings ?? [])].map((w) => w.message),
    ...muscle.wrong.values(),
    unknown && `Not understood in the address: ${unknown}`,
  ]);
  return [...list].filter(Boolean).map((w) => capital(inWords(w)));
}

// What a muscle that is built will pull, the parts of the ±, and what to measure.
/** Names of the parts that are no words yet. @type {Record<string, string>} */
const PARTS = {
  pull_factor: "muscle to muscle",
  take_up: "take-up",
  beyond_measured: "beyond measured muscles (judgement)",
  braid: "stiffness of the braid",
  fit: "own points",
  measured: "model against tests",
};

/** @param {Store} store */
function partsView(store) {
  const list = el("dl", { class: "parts" }),
    note = remark();
  const element = el(
    "div",
    { class: "breakdown", role: "region", ariaLabel: "Parts of the ±", hidden: true },
    list,
    note,
  );
  watch(() => {
    const parts = Object.entries(store.point.value?.uncertainty_parts_n ?? {})
      .filter((pair) => typeof pair[1] === "number")
      .sort((a, b) => b[1] - a[1]);
    const words = muscle.assessed?.uncertainty_words;
    const said = [
      words?.built && `As built ${words.built}.`,
      "95 % half-widths; they add as squares.",
      words?.bench && `To measure: ${words.bench}.`,
    ].filter(Boolean);
    list.replaceChildren(...parts.flatMap(([name, value]) => row(name, value, parts[0][1])));
    note.textContent = inWords(said.join(" "));
  });
  return { element };
}

/** @param {string} name @param {number} value @param {number} max */
function row(name, value, max) {
  return [
    el("dt", PARTS[name] ?? name),
    el("dd", `± ${showForce(value, 2)}`),
    el("dd", { class: "wide" }, el("progress", { max, value, ariaHidden: "true" })),
  ];
}
