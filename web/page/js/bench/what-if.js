// Which pressure, contraction, diameter, wall or angle gives a wanted pull; the others stay as they
// are.
import { answerTo } from "../ask.js";
import { block, button, el, folded, remark } from "../dom.js";
import { fieldsOf, form } from "../form.js";
import { muscle } from "../muscle.js";
import { CONTRACTION, PRESSURE, QUANTITIES, question, say } from "../state.js";
import { evenly, inWords, show, showForce, unitName } from "../units.js";
import { renewing, rested, watch } from "../watch.js";

/** Values that are tried between two, and how often. */
const POINTS = 13,
  ROUNDS = 4;

/** @param {Store} store */
export function solveView(store) {
  const choices = [PRESSURE, CONTRACTION, ...QUANTITIES.filter((m) => m.key !== "L")];
  const asked = form(
    fieldsOf([
      [
        "what",
        "what",
        "Solve for",

        { value: PRESSURE.key, options: choices.map((m) => [m.key, m.label]) },
      ],
      ["pull", "force_n", "Wanted pull", "force", { hint: "500 N" }],
    ]),
    () => solve(),
  );
  const said = el("p", { class: "small", role: "status" });
  const element = folded(
    "Solve for a wanted pull",
    asked.element,
    button("Solve", () => solve()),
    said,
  );
  const begin = renewing();

  async function solve() {
    const signal = begin(),
      { what, force_n: force } = (await asked.read()) ?? {};
    if (force === undefined || signal.aborted) return;
    said.textContent = "…";
    try {
      const measure = /** @type {Measure} */ (choices.find((m) => m.key === what));
      const value = await solved(measure, force, signal);
      said.textContent = `${measure.label} ${show(measure.kind, value, 4)} gives ${showForce(force, 4)}.`;
      store.changed(measure.key, value, true);
    } catch (problem) {
      if (!signal.aborted) said.textContent = inWords(/** @type {Error} */ (problem).message);
    }
  }
  return { element };
}

/**
 * The value of a measure with which the muscle pulls so much: between the ends of its slider where
 * the difference changes its sign, nearest to the present one, then between ever closer values.
 * @param {Measure} measure @param {number} force @param {AbortSignal} signal
 * @returns {Promise<number>}
 */
async function solved({ key, low = 0, high = 1, around, label, kind }, force, signal) {
  const state = { ...muscle.state, F: undefined },
    from = Number(muscle.value(key)),
    [least, most] = around ? [0.3 * from, 3 * from] : [low, high];
  // A muscle that cannot be has no value.
  const off = (/** @type {number} */ x) =>
    answerTo("force", question(say(state, key, x)), { signal }).then(
      (answer) => answer.force_n - force,
      () => NaN,
    );
  let [a, b] = [least, most].map((x) => ({ x, f: 0 }));
  for (let round = 0; round < ROUNDS; round++) {
    const all = await Promise.all(
      evenly(a.x, b.x, POINTS).map(async (x) => ({ x, f: await off(x) })),
    );
    const far = (/** @type {number} */ i) => Math.abs(all[i].x - from),
      [at] = evenly(1, POINTS - 1, POINTS - 1)
        .filter((i) => all[i - 1].f * all[i].f <= 0)
        .sort((i, k) => far(i) - far(k));
    if (!at)
      throw new Error(
        `No ${label.toLowerCase()} between ${show(kind, least)} and ${show(kind, most)} gives this ` +
          "pull with all else as it is.",
      );
    [a, b] = [all[at - 1], all[at]];
  }
  return a.f === b.f ? a.x : (a.x * b.f - b.x * a.f) / (b.f - a.f);
}

// What a small change of each measure does to the pull: one millimetre, a degree, 0.1 bar. Each is
// computed, on demand.
/** Changes, by keys of measures. @type {Record<string, number>} */
const STEPS = { D: 1, s: 0.1, L: 1, angle: 1, p: 0.01, e: 0.01 };
/** After a change it waits so long, in milliseconds. */
const REST = 250;

/** @param {Store} store */
export function tornadoView(store) {
  const bars = block("tornado"),
    words = remark();
  const element = folded("What a small change does", bars, words);
  const begin = renewing(),
    soon = rested(start, REST);

  async function start() {
    const at = store.point.value;
    if (!element.open || !at || at.slack) return;
    const signal = begin(),
      held = muscle.state.F !== undefined,
      state = { ...muscle.state, F: undefined, e: at.contraction };
    words.textContent = "Computing …";
    /** @type {Measure[]} */ const list = [...QUANTITIES, PRESSURE, CONTRACTION].filter(
      ({ key }) => !(key === "angle" && muscle.shown?.sleeve) && !(key === "e" && held),
    );
    const change = (/** @type {string} */ key, /** @type {number} */ sign) =>
      answerTo("force", question(say(state, key, Number(muscle.value(key)) + sign * STEPS[key])), {
        signal,
      }).then(
        ({ force_n: force }) => [force - at.force_n],
        () => [],
      );
    const found = await Promise.all(
      list.map(async (m) => {
        const changes = (await Promise.all([change(m.key, -1), change(m.key, 1)])).flat();
        return { m, changes, size: Math.max(0, ...changes.map(Math.abs)) };
      }),
    );
    if (signal.aborted) return;
    found.sort((a, b) => b.size - a.size);
    bars.replaceChildren(
      ...found.map(({ m, changes }) => bar(m, changes, Math.max(1e-9, found[0].size))),
    );
    words.textContent = `Change of the pull of ${showForce(at.force_n, 3)}, all else as it is: to the right more pull.`;
  }

  element.addEventListener("toggle", start);
  watch(() => {
    void [muscle.state, store.point.value, unitName("force")];
    // What belongs to another muscle is given up at once.
    begin();
    soon();
  });
  return { element };
}

/** @param {Measure} m @param {number[]} changes @param {number} reach */
function bar(m, changes, reach) {
  const signed = (/** @type {number} */ v) => `${v < 0 ? "−" : "+"}${showForce(Math.abs(v), 2)}`;
  const piece = (/** @type {number} */ v, /** @type {number} */ i) =>
    el("b", {
      class: i ? "more" : "less",
      style: `${v < 0 ? "right" : "left"}:50%;width:${((50 * Math.abs(v)) / reach).toFixed(1)}%`,
    });
  const label = el(
    "span",
    m.label,
    el("span", { class: "soft" }, ` ± ${show(m.kind, STEPS[m.key], 2)}`),
  );
  const value = el("span", changes.length === 2 ? changes.map(signed).join(", ") : "–");
  return block("", label, value, el("i", ...changes.map(piece)));
}
