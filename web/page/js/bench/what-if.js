// Which pressure, contraction, diameter, wall or angle gives a wanted pull; the others stay as they
// are.
import { engine } from "../ask.js";
import { block, button, el, folded, remark } from "../dom.js";
import { isAbort } from "../engine/problem.js";
import { fieldsOf, form } from "../form.js";
import { atEnd, renewing } from "../life.js";
import { muscle } from "../muscle.js";
import { CONTRACTION, PRESSURE, QUANTITIES, question, say } from "../state.js";
import { inWords, number, outside, show, showForce, unitName } from "../units.js";
import { watch } from "../watch.js";

/** Secants at most, and as near as this, as a share of the wanted pull. */
const MOST = 12,
  NEAR = 2e-4;

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
 * @param {Measure} measure @param {number} force @param {AbortSignal} signal
 * @returns {Promise<number>}
 */
async function solved(measure, force, signal) {
  const { state } = muscle,
    options = { signal },
    asked = { muscle: muscle.fields(), force_n: force };
  // Both have an inverse of their own.
  if (measure.key === "p") {
    const request = { ...asked, contraction: state.e };
    return (await engine().ask("pressure", request, options)).pressure_mpa;
  }
  if (measure.key === "e") {
    const request = { ...asked, pressure_mpa: state.p };
    return (await engine().ask("contraction", request, options)).contraction;
  }
  const over = async (/** @type {number} */ value) => {
    const changed = say({ ...state, F: undefined }, measure.key, value);
    return (await engine().ask("force", question(changed), options)).force_n - force;
  };
  return root(over, Number(muscle.value(measure.key)), measure, NEAR * Math.abs(force));
}

/**
 * Where a function is zero between the ends of a slider: outwards from a value to both sides until
 * its sign changes, then secants that keep it between (Illinois).
 * @param {(value: number) => Promise<number>} of @param {number} from @param {Measure} measure
 * @param {number} near
 */
async function root(of, from, { low = 0, high = 1, around, label, kind }, near) {
  // A muscle that cannot be has no value.
  const at = async (/** @type {number} */ x) => ({
    x,
    f: await of(x).catch((problem) => {
      if (isAbort(problem)) throw problem;
      return NaN;
    }),
  });
  const start = await at(from),
    ends = around ? [0.3 * from, 3 * from] : [low, high];
  let a = start,
    b = start;
  for (const share of [0.12, 0.3, 0.5, 0.75, 1]) {
    const both = await Promise.all(ends.map((end) => at(from + share * (end - from))));
    b = both.find(({ f }) => f * start.f <= 0) ?? start;
    if (b !== start || Math.abs(start.f) <= near) break;
  }
  if (b === start && !(Math.abs(start.f) <= near))
    throw new Error(
      `No ${label.toLowerCase()} between ${show(kind, ends[0])} and ${show(kind, ends[1])} gives this ` +
        "pull with all else as it is.",
    );
  for (let i = 0; i < MOST && Math.abs(b.f) > near; i++) {
    const next = await at((a.x * b.f - b.x * a.f) / (b.f - a.f));
    a = next.f * b.f > 0 ? { ...a, f: a.f / 2 } : b;
    b = next;
  }
  if (Math.abs(b.f) <= near) return b.x;
  throw new Error(
    `The search did not converge in ${MOST} steps: give a value that is nearer to the wanted one.`,
  );
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
  const begin = renewing();
  let of = "",
    timer = 0;

  async function start() {
    const { state } = muscle,
      at = store.point.value;
    const key = JSON.stringify([state, ...["force", "length", "pressure"].map(unitName)]);
    if (!element.open || !at || at.slack || key === of) return;
    of = key;
    const signal = begin();
    words.textContent = "Computing …";
    const list = /** @type {Measure[]} */ ([...QUANTITIES, PRESSURE, CONTRACTION]).filter(
      (m) =>
        (m.key !== "angle" || !muscle.shown?.sleeve) && !(m.key === "e" && state.F !== undefined),
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
    const size = (/** @type {number[]} */ changes) => Math.max(...changes.map(Math.abs));
    found.sort(([, a], [, b]) => size(b) - size(a));
    bars.replaceChildren(
      ...found.map(([m, changes]) => bar(m, changes, Math.max(1e-9, size(found[0][1])))),
    );
    words.textContent = `Change of the pull of ${showForce(at.force_n, 3)}, all else as it is: to the right more pull.`;
  }

  element.addEventListener("toggle", start);
  watch(() => {
    void [muscle.state, store.point.value, unitName("force")];
    // What belongs to another muscle is given up at once.
    begin();
    of = "";
    clearTimeout(timer);
    timer = window.setTimeout(start, REST);
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
  const label = el("span", m.label, el("span", { class: "soft" }, ` ± ${text}`));
  const value = el("span", changes.length === 2 ? changes.map(signed).join(", ") : "–");
  return block("", label, value, el("i", ...changes.map(piece)));
}
