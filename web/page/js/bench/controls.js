// The controls of the page Muscle: its state, its measures, its ends, its file.
import { engine } from "../ask.js";
import { choice, fileField, quantity } from "../controls.js";
import { capital, download, el, problemBox } from "../dom.js";
import { muscle } from "../muscle.js";
import { CONTRACTION, ENDS, LOAD, MORE, PRESSURE, QUANTITIES, STIFFNESS, STRANDS, about } from "../state.js";
import { show } from "../units.js";
import { niceUp } from "./round.js";

/** @typedef {import("./store.js").Store} Store */
/** Tables of the muscle file as the page calls them. @type {Record<string, string>} */
const GROUPS = { tube: "Tube", braid: "Braid", terminals: "Ends", friction: "Friction" };
const ORDER = Object.keys(GROUPS);

/** @param {Store} store @param {(problem: unknown) => void} fail */
export function controlsView(store, fail) {
  const controls = /** @type {Record<string, ReturnType<typeof quantity>>} */ ({});
  const make = (/** @type {import("../state.js").Measure} */ spec) => {
    const change = (/** @type {number | undefined} */ value, /** @type {boolean} */ settled) =>
      store.changed(spec.key, value, settled);
    controls[spec.key] = quantity({ ...spec, value: muscle.value(spec.key), clears: Boolean(spec.group), change });
    return controls[spec.key].element;
  };
  const picks = choices(store);
  /** What a named sleeve needs is beside it. */
  const needed = el("div", {});
  const built = el("div", { class: "small", "aria-live": "polite" });
  const fileName = el("p", { class: "small soft" });
  const take = (/** @type {string} */ text) => takeFile(store, text, revealAll, fail);
  const buttons = {
    file: fileField("Open a muscle file (TOML)", ".toml", (_, text) => take(text)),
    save: el("button", { type: "button", onclick: () => save(fail) }, "Download this muscle"),
    build: el("button", { type: "button", onclick: () => build(built) }, "Build it"),
  };
  const element = section(make, picks, buttons, { needed, fileName, built });
  const homes = new Map(
    STRANDS.map(({ key }) => [key, /** @type {HTMLElement} */ (controls[key].element.parentElement)]),
  );
  const clear = () => Object.values(controls).forEach((c) => c.mark(""));

  /** Opens what holds a control. @param {string} key */
  function reveal(key) {
    const box = controls[key]?.element.closest("details");
    if (box) box.open = true;
  }
  /** Opens what holds a measure that the address or the file states. */
  function revealAll() {
    const { file, said } = muscle.state;
    const stated = (/** @type {string} */ key) =>
      said[key] !== undefined || muscle.wrong.has(key) || (file && muscle.value(key) !== undefined);
    [...ENDS, ...MORE].filter(({ key }) => stated(key)).forEach(({ key }) => reveal(key));
  }
  store.on("sync", () => { sync(controls, picks, fileName); place(controls, needed, homes); });
  store.on("changed", () => built.replaceChildren());
  store.on("answer", clear);
  store.on("problem", ({ problem, state }) => {
    const lacks = muscle.missing().filter((key) => state.said[key] === undefined), key = about(problem);
    clear();
    if (lacks.length)
      lacks.forEach((key) =>
        controls[key].mark(`The source of ${state.said.braid} does not state it: measure it, or select a stiffness.`),
      );
    else if (key) {
      controls[key].mark(problem.message);
      reveal(key);
    }
  });
  store.on("facts", () => {
    const { free_contraction: free, blocked_force_n: blocked } = store.facts.characteristics ?? {};
    if (free) controls.e.reach(0, Math.max(0.1, Math.ceil(free * 22) / 20));
    controls.F.reach(0, Math.max(10, niceUp(blocked ?? 1000)));
  });
  engine()
    .ask("parts-list", { kind: "rubbers" })
    .then(
      (answer) => picks.rubber.options(answer.rubbers.map(({ name }) => name)),
      () => {},
    );
  return { element, take, revealAll, braids: () => picks.braid.options(muscle.sleeves.map((s) => s.name)) };
}

/**
 * @param {(spec: import("../state.js").Measure) => HTMLElement} make @param {ReturnType<typeof choices>} picks
 * @param {{ file: Node, save: Node, build: Node }} buttons @param {{ needed: Node, fileName: Node, built: Node }} parts
 */
function section(make, { rubber, braid, strands, held }, buttons, { needed, fileName, built }) {
  const group = (/** @type {string} */ name, /** @type {Node[]} */ ...list) =>
    el("details", {}, el("summary", {}, name), ...list);
  const state = [make(PRESSURE), held.element, make(CONTRACTION), make(LOAD)];
  const tube = [...QUANTITIES.map(make), rubber.element, braid.element, strands.element, make(STIFFNESS), needed];
  return el("section", { class: "controls", "aria-label": "Muscle" },
    el("fieldset", { class: "state" }, el("legend", {}, "State"), ...state),
    el("fieldset", {}, el("legend", {}, "Tube and braid"), ...tube),
    group("Ends", ...ENDS.map(make)),
    moreMeasures(make),
    group("Muscle file", fileName, buttons.file, el("p", { style: "margin-top:8px" }, buttons.save)),
    el("p", { class: "row" }, buttons.build), built);
}

/** @param {Store} store */
function choices(store) {
  const stiffness = () => Math.round(store.facts.stiffness_n_per_mm ?? 300);
  const load = () => Math.max(1, Math.round(store.point?.force_n ?? 100));
  const names = /** @type {[string, string][]} */ ([
    ["", ""],
    ["inextensible", "inextensible"],
    ["paper", "paper's braid"],
    ["k", "of this stiffness"],
  ]);
  return {
    rubber: choice("Rubber", [["", ""]], "", (name) => store.changed("rubber", name, true)),
    braid: choice("Braid", [["", ""]], "", (name) => store.changed("braid", name, true)),
    strands: choice("Strands", names, "", (name) => store.changed("k", name === "k" ? stiffness() : name, true)),
    held: choice(
      "Held",
      [
        ["e", "contraction"],
        ["F", "load"],
      ],
      "e",
      (what) => store.changed("F", what === "F" ? load() : undefined, true),
    ),
  };
}

/**
 * All other measures, by the tables of the muscle file.
 * @param {(spec: import("../state.js").Measure) => HTMLElement} make
 */
function moreMeasures(make) {
  const groups = [...new Set(MORE.map(({ group = "" }) => group))].sort((a, b) => ORDER.indexOf(a) - ORDER.indexOf(b));
  const box = (/** @type {string} */ group) =>
    el(
      "fieldset",
      {},
      el("legend", {}, GROUPS[group] ?? capital(group)),
      ...MORE.filter((m) => m.group === group).map((m) => el("div", {}, make(m))),
    );
  return el("details", {}, el("summary", {}, "More measures"), ...groups.map(box));
}

/**
 * Every control as file, address and engine have it.
 * @param {Record<string, ReturnType<typeof quantity>>} controls @param {ReturnType<typeof choices>} picks
 * @param {HTMLElement} fileName
 */
function sync(controls, { rubber, braid, strands, held }, fileName) {
  const { file, said, F } = muscle.state, { shown } = muscle;
  for (const key of Object.keys(controls)) controls[key].set(muscle.value(key));
  for (const [key, message] of muscle.wrong) controls[key]?.mark(message);
  const own = file ? "as in the file" : "";
  const ofStrands = STRANDS.some(({ key }) => said[key] !== undefined) || said.strand_area_mm2 !== undefined;
  rubber.first(own || "paper (default)");
  braid.first(own || "its own angle");
  strands.first(said.braid ? "of the sleeve" : ofStrands ? "of its strands" : own || "paper's braid (default)");
  rubber.set(String(said.rubber ?? ""));
  braid.set(String(said.braid ?? ""));
  strands.set(typeof said.k === "number" ? "k" : String(said.k ?? ""));
  const changed = Object.keys(said).length ? "; changed here" : "";
  fileName.textContent = file
    ? `Open: D0 ${show("length", shown?.outer_diameter_mm)}, ${shown?.rubber ?? ""}, ${shown?.braid ?? ""}${changed}`
    : "";
  held.set(F === undefined ? "e" : "F");
  controls.F.element.hidden = F === undefined;
  controls.e.element.hidden = F !== undefined;
  // A named sleeve has its angle, and may need to be said what its strands are.
  controls.angle.enable(!(said.braid ?? shown?.sleeve) || said.angle !== undefined);
  controls.k.element.hidden = typeof said.k !== "number";
}

/**
 * @param {Record<string, ReturnType<typeof quantity>>} controls @param {HTMLElement} needed
 * @param {Map<string, HTMLElement>} homes
 */
function place(controls, needed, homes) {
  const lacks = muscle.missing();
  for (const [key, home] of homes) {
    const to = lacks.includes(key) ? needed : home;
    if (controls[key].element.parentElement !== to) to.append(controls[key].element);
  }
}

/** @param {Store} store @param {string} text @param {() => void} reveal @param {(problem: unknown) => void} fail */
async function takeFile(store, text, reveal, fail) {
  try {
    await muscle.take(text);
    store.tell("sync");
    reveal();
    store.ask();
    store.follow();
    store.settle();
  } catch (problem) {
    fail(problem);
  }
}

/** @param {(problem: unknown) => void} fail */
async function save(fail) {
  try {
    download("muscle.toml", await muscle.file(), "application/toml");
  } catch (problem) {
    fail(problem);
  }
}

/** What the workshop needs, below the button. @param {HTMLElement} built */
async function build(built) {
  try {
    await (await import("../build-view.js")).build(built);
  } catch (problem) {
    built.replaceChildren(problemBox(problem));
  }
}
