// What a small change of each measure does to the pull: one millimetre, a degree, 0.1 bar. Each is computed, on demand.
import { engine } from "../ask.js";
import { block, el, folded, remark } from "../dom.js";
import { atEnd, renewing } from "../life.js";
import { muscle } from "../muscle.js";
import { CONTRACTION, PRESSURE, QUANTITIES, question, say } from "../state.js";
import { number, outside, show, showForce, unitName } from "../units.js";

/** Changes, by keys of measures. @type {Record<string, number>} */
const STEPS = { D: 1, s: 0.1, L: 1, angle: 1, p: 0.01, e: 0.01 };
/** After a change it waits so long, in milliseconds. */
const REST = 250;

/** @param {Store} store */
export function tornadoView(store) {
  const bars = block("tornado"),
    words = remark();
  const element = folded("What a small change does", bars, words);
  const begin = renewing();
  let of = "",
    timer = 0;

  async function start() {
    const { state } = muscle,
      { point: at } = store;
    const key = JSON.stringify([
      state,
      ...["force", "length", "pressure"].map(unitName),
    ]);
    if (!element.open || !at || at.slack || key === of) return;
    of = key;
    const signal = begin();
    words.textContent = "Computing …";
    const list = /** @type {Measure[]} */ ([
      ...QUANTITIES,
      PRESSURE,
      CONTRACTION,
    ]).filter(
      (m) =>
        (m.key !== "angle" || !muscle.shown?.sleeve) &&
        !(m.key === "e" && state.F !== undefined),
    );
    /** @type {[Measure, number[]][]} */ const found = [];
    for (const m of list) {
      const value = muscle.value(m.key) ?? NaN,
        changes = [];
      for (const sign of [-1, 1]) {
        const changed = say(
          { ...state, F: undefined, e: at.contraction },
          m.key,
          value + sign * STEPS[m.key],
        );
        const answer = await engine()
          .ask("force", question(changed), { signal })
          .catch(() => undefined);
        if (signal.aborted) return;
        if (answer) changes.push(answer.force_n - at.force_n);
      }
      if (changes.length) found.push([m, changes]);
    }
    const size = (/** @type {number[]} */ changes) =>
      Math.max(...changes.map(Math.abs));
    found.sort(([, a], [, b]) => size(b) - size(a));
    bars.replaceChildren(
      ...found.map(([m, changes]) =>
        bar(m, changes, Math.max(1e-9, size(found[0][1]))),
      ),
    );
    words.textContent = `Change of the pull of ${showForce(at.force_n, 3)}, all else as it is: to the right more pull.`;
  }

  const soon = () => {
    // What belongs to another muscle is given up at once.
    of = "";
    begin();
    clearTimeout(timer);
    timer = window.setTimeout(start, REST);
  };
  element.addEventListener("toggle", start);
  store.on("changed", soon);
  store.on("answer", () => {
    if (element.open && of === "") soon();
  });
  atEnd(() => clearTimeout(timer));
  return { element };
}

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
  const label = el(
    "span",
    {},
    m.label,
    el("span", { class: "soft" }, ` ± ${text}`),
  );
  const value = el(
    "span",
    {},
    changes.length === 2 ? changes.map(signed).join(", ") : "–",
  );
  return block("", label, value, el("i", {}, ...changes.map(piece)));
}
