// The controls of the page Muscle: its state and its measures.
import { answerTo } from "../ask.js";
import { choice, quantity } from "../controls.js";
import { block, capital, el, folded, inputs } from "../dom.js";
import { muscle } from "../muscle.js";
import {
  CONTRACTION,
  LOAD,
  MORE,
  PRESSURE,
  QUANTITIES,
  STIFFNESS,
  STRANDS,
  about,
} from "../state.js";
import { braidName, niceUp, partName } from "../units.js";
import { watch } from "../watch.js";

/** @param {Store} store */
export function controlsView(store) {
  /** @type {Record<string, ReturnType<typeof quantity>>} */ const controls = {};
  const make = (/** @type {Measure} */ spec) => {
    const { key, group } = spec;
    controls[key] = quantity({
      ...spec,
      value: muscle.value(key),
      clears: Boolean(group),
      change: (value, settled) => store.changed(key, value, settled),
    });
    return controls[key].element;
  };
  const picks = choices(store);
  const element = section(make, picks);
  const clear = () => Object.values(controls).forEach((c) => c.mark(""));

  /** Opens what holds a control. @param {string} key */
  function reveal(key) {
    const box = controls[key]?.element.closest("details");
    if (box) box.open = true;
  }
  /** Opens what holds a measure that the address or the file states. */
  function revealAll() {
    const { file, said } = muscle.state;
    // Every file that was written states the density.
    const stated = (/** @type {string} */ key) =>
      said[key] !== undefined ||
      muscle.wrong.has(key) ||
      (file && key !== "density_kg_per_m3" && muscle.value(key) !== undefined);
    MORE.filter(({ key }) => stated(key)).forEach(({ key }) => reveal(key));
  }
  watch(() => {
    sync(controls, picks);
    // What a named sleeve needs is seen.
    muscle.missing().forEach(reveal);
  });
  watch(() => {
    const found = store.problem.value;
    clear();
    if (!found) return;
    const { problem, state } = found;
    const lacks = muscle.missing().filter((key) => state.said[key] === undefined),
      key = about(problem);
    if (lacks.length)
      lacks.forEach((key) =>
        controls[key].mark(
          `The source of ${state.said.braid} does not state it: measure it, or select a stiffness.`,
        ),
      );
    else if (key) {
      controls[key].mark(problem.message);
      reveal(key);
    }
  });
  watch(() => {
    const { free_contraction: free, blocked_force_n: blocked } =
      store.facts.value.characteristics ?? {};
    if (free) controls.e.reach(0, Math.max(0.1, Math.ceil(free * 22) / 20));
    controls.F.reach(0, Math.max(10, niceUp(blocked ?? 1000)));
  });
  answerTo("parts-list", { kind: "rubbers" }).then(
    (answer) => picks.rubber.options(answer.rubbers.map(({ name }) => name)),
    () => {},
  );
  /** Sliders run around the muscle as it was opened, within its sleeve. */
  function anchor() {
    const sleeve = muscle.sleeves.find(
      ({ name }) => name === (muscle.state.said.braid ?? muscle.shown?.sleeve),
    );
    for (const [key, c] of Object.entries(controls))
      c.anchor(
        ...(key === "D" && sleeve ? [sleeve.least_diameter_mm, sleeve.largest_diameter_mm] : []),
      );
  }
  return {
    element,
    revealAll,
    anchor,
    braids: () => picks.braid.options(muscle.sleeves.map((s) => s.name)),
  };
}

/**
 * @param {(spec: Measure) => HTMLElement} make @param {ReturnType<typeof choices>} picks
 */
function section(make, { rubber, braid, strands, held, branch }) {
  const state = [make(PRESSURE), held.element, make(CONTRACTION), make(LOAD), branch.element];
  const tube = [
    ...QUANTITIES.map(make),
    rubber.element,
    braid.element,
    strands.element,
    make(STIFFNESS),
  ];
  return inputs(
    "Muscle",
    el("fieldset", { class: "state" }, el("legend", "State"), ...state),
    el("fieldset", el("legend", "Tube and braid"), ...tube),
    moreMeasures(make),
  );
}

/** @param {Store} store */
function choices(store) {
  const stiffness = () => Math.round(store.facts.value.stiffness_n_per_mm ?? 300);
  const load = () => Math.max(1, Math.round(store.point.value?.force_n ?? 100));
  /** @type {[string, string][]} */ const names = [
    ["", ""],
    ["inextensible", "inextensible"],
    ["antonelli2018", "braid (Antonelli 2018)"],
    ["k", "Custom stiffness"],
  ];
  const put = (/** @type {string} */ key) => (/** @type {string} */ name) =>
    store.changed(key, name, true);
  return {
    rubber: choice("Rubber", [["", ""]], put("rubber")),
    braid: choice("Braid", [["", ""]], put("braid")),
    strands: choice("Strands", names, (name) =>
      store.changed("k", name === "k" ? stiffness() : name, true),
    ),
    branch: choice(
      "Friction",
      [
        ["", "usual"],
        ["contraction", "while it shortens"],
        ["mean", "mean of both ways"],
        ["elongation", "while it lengthens"],
      ],
      put("branch"),
    ),
    held: choice(
      "Hold",
      [
        ["e", "contraction"],
        ["F", "load"],
      ],
      (what) => store.changed("F", what === "F" ? load() : undefined, true),
    ),
  };
}

/**
 * All other measures, by the tables of the muscle file.
 * @param {(spec: Measure) => HTMLElement} make
 */
function moreMeasures(make) {
  const groups = [...new Set(MORE.map(({ group = "" }) => group))];
  const box = (/** @type {string} */ group) =>
    el(
      "fieldset",
      el("legend", capital(group)),
      ...MORE.filter((m) => m.group === group).map((m) => block("", make(m))),
    );
  return folded("More properties", ...groups.map(box));
}

/**
 * Every control as file, address and engine have it.
 * @param {Record<string, ReturnType<typeof quantity>>} controls
 * @param {ReturnType<typeof choices>} picks
 */
function sync(controls, { rubber, braid, strands, held, branch }) {
  const { said, F } = muscle.state,
    { shown } = muscle;
  for (const key of Object.keys(controls)) controls[key].set(muscle.value(key));
  for (const [key, message] of muscle.wrong) controls[key]?.mark(message);
  const ofStrands =
    STRANDS.some(({ key }) => said[key] !== undefined) || said.strand_area_mm2 !== undefined;
  if (said.rubber === undefined)
    rubber.first(partName(shown?.rubber) || "silicone (Antonelli 2018)");
  if (said.braid === undefined) braid.first(shown?.sleeve ?? "Custom angle");
  if (said.k === undefined)
    strands.first(
      (said.braid ?? shown?.sleeve)
        ? "of the sleeve"
        : ofStrands
          ? "of its strands"
          : braidName(shown?.braid) || "braid (Antonelli 2018)",
    );
  rubber.set(String(said.rubber ?? ""));
  braid.set(String(said.braid ?? ""));
  strands.set(typeof said.k === "number" ? "k" : String(said.k ?? ""));
  held.set(F === undefined ? "e" : "F");
  branch.set(String(said.branch ?? ""));
  controls.F.element.hidden = F === undefined;
  controls.e.element.hidden = F !== undefined;
  // A named sleeve has its angle, and may need to be said what its strands are.
  controls.angle.enable(!(said.braid ?? shown?.sleeve) || said.angle !== undefined);
  controls.k.element.hidden = typeof said.k !== "number";
}
