// What a small change of each measure does to the pull: one millimetre, a degree, 0.1 bar. Each is computed, on demand.
import { Slot } from "../ask.js";
import { el } from "../dom.js";
import { muscle } from "../muscle.js";
import { CONTRACTION, PRESSURE, QUANTITIES, say } from "../state.js";
import { fields, point } from "../state.js";
import { number, outside, show, unitName } from "../units.js";

/** @typedef {import("./store.js").Store} Store */
/** @typedef {import("../state.js").Measure} Measure */
/** Changes, by keys of measures. @type {Record<string, number>} */
const STEPS = { D: 1, s: 0.1, L: 1, angle: 1, p: 0.01, e: 0.01 };
/** After a change it waits so long, in milliseconds. */
const REST = 250;

/** @param {Store} store */
export function tornadoView(store) {
  const slot = new Slot(), bars = el("div", { class: "tornado" }), words = el("p", { class: "small soft" });
  const element = el("details", {}, el("summary", {}, "What a small change does"), bars, words);
  let of = "", timer = 0;

  function start() {
    const { state } = muscle,
      { point: at } = store,
      key = JSON.stringify([state, unitName("force"), unitName("length"), unitName("pressure")]);
    if (!element.open || !at || at.slack || key === of) return;
    of = key;
    const list = /** @type {Measure[]} */ ([...QUANTITIES, PRESSURE, CONTRACTION]).filter(
      (m) => (m.key !== "angle" || !muscle.shown?.sleeve) && !(m.key === "e" && state.F !== undefined),
    );
    const jobs = list.flatMap((m) => [-1, 1].map((sign) => ({ m, sign })));
    /** @type {Map<string, number[]>} */
    const found = new Map();
    const next = () => {
      const job = jobs.shift();
      if (of !== key) return;
      if (!job) return paint(list, found, at.force_n);
      const { m, sign } = job, value = muscle.value(m.key);
      if (value === undefined) return next();
      const changed = say({ ...state, F: undefined, e: at.contraction }, m.key, value + sign * STEPS[m.key]);
      const request = { ...fields(changed), ...point(changed) };
      slot.ask(
        "force",
        request,
        ({ force_n: force }) => {
          found.set(m.key, [...(found.get(m.key) ?? []), force - at.force_n]);
          next();
        },
        next,
      );
    };
    words.textContent = "Computing …";
    next();
  }

  /** @param {Measure[]} list @param {Map<string, number[]>} found @param {number} force */
  function paint(list, found, force) {
    const reach = Math.max(1e-9, ...[...found.values()].flat().map(Math.abs));
    const sorted = list.filter((m) => found.has(m.key)).sort((a, b) => size(found.get(b.key)) - size(found.get(a.key)));
    bars.replaceChildren(...sorted.map((m) => bar(m, found.get(m.key) ?? [], reach)));
    words.textContent = `Change of the pull of ${show("force", force, 3)}, all else as it is: to the right more pull.`;
  }

  const soon = () => {
    // What belongs to another muscle is given up at once.
    if (of !== "" && element.open) { of = ""; slot.end(); }
    clearTimeout(timer);
    timer = window.setTimeout(start, REST);
  };
  element.addEventListener("toggle", start);
  store.on("changed", soon);
  store.on("answer", () => { if (element.open && of === "") soon(); });
  return { element, end() { clearTimeout(timer); slot.end(); } };
}

/** @param {number[] | undefined} list */
const size = (list) => Math.max(...(list ?? [0]).map(Math.abs));

/** @param {Measure} m @param {number[]} changes @param {number} reach */
function bar(m, changes, reach) {
  const step = STEPS[m.key],
    text = m.kind === "ratio" ? `${100 * step} %` : show(m.kind, step, 2);
  const signed = (/** @type {number} */ v) =>
    `${v < 0 ? "−" : "+"}${number(outside("force", Math.abs(v)), 2)} ${unitName("force")}`;
  const piece = (/** @type {number} */ v, /** @type {number} */ i) =>
    el("b", {
      class: i ? "more" : "less",
      style: `${v < 0 ? "right" : "left"}:50%;width:${((50 * Math.abs(v)) / reach).toFixed(1)}%`,
    });
  const label = el("span", {}, m.label, el("span", { class: "soft" }, ` ± ${text}`));
  const value = el("span", {}, changes.length === 2 ? `${signed(changes[0])}, ${signed(changes[1])}` : "–");
  return el("div", {}, label, value, el("i", {}, ...changes.map(piece)));
}
