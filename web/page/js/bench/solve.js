// Which pressure, contraction, diameter, wall or angle gives a wanted pull; the others stay as they are.
import { engine, understood } from "../ask.js";
import { el } from "../dom.js";
import { muscle } from "../muscle.js";
import { CONTRACTION, PRESSURE, QUANTITIES, fields, point, say } from "../state.js";
import { meant, show } from "../units.js";
import { inWords } from "../words.js";

/** @typedef {import("./store.js").Store} Store */
/** @typedef {import("../state.js").Measure} Measure */
/** Questions at most. */
const MOST = 12;
/** As near as this, as a share of the wanted pull. */
const NEAR = 2e-4;

/** @param {Store} store */
export function solveView(store) {
  const choices = [PRESSURE, CONTRACTION, ...QUANTITIES.filter((m) => m.key !== "L")];
  const what = el(
    "select",
    { "aria-label": "Solve for" },
    ...choices.map((m) => el("option", { value: m.key }, m.label)),
  );
  const wanted = el("input", {
    type: "text",
    "aria-label": "Wanted pull",
    placeholder: "500 N",
    size: 8,
    autocomplete: "off",
    spellcheck: "false",
  });
  const said = el("p", { class: "small", role: "status" });
  const run = el("button", { type: "submit" }, "Solve");
  const form = el(
    "form",
    {
      class: "row",
      onsubmit: (/** @type {Event} */ event) => {
        event.preventDefault();
        solve();
      },
    },
    what,
    el("span", {}, "for a pull of"),
    wanted,
    run,
  );
  const element = el("details", {}, el("summary", {}, "Solve for a wanted pull"), form, said);
  let ends = new AbortController();

  async function solve() {
    ends.abort();
    const { signal } = (ends = new AbortController());
    said.textContent = "…";
    try {
      const measure = /** @type {Measure} */ (choices.find((m) => m.key === what.value));
      const force = await pull(wanted.value.trim());
      const value = await solved(measure, force, signal);
      if (signal.aborted) return;
      said.textContent = `${measure.label} ${show(measure.kind, value, 4)} gives ${show("force", force, 4)}.`;
      store.changed(measure.key, value, true);
    } catch (problem) {
      if (!signal.aborted) said.textContent = inWords(/** @type {Error} */ (problem).message);
    }
  }
  return { element, end: () => ends.abort() };
}

/** @param {string} text */
async function pull(text) {
  const { text: asked, value } = meant("force", text);
  if (value !== undefined) return value;
  const [reading] = await understood([{ text: asked, kind: "force" }]);
  if (reading.problem) throw new Error(reading.problem.message);
  return /** @type {number} */ (reading.value);
}

/** @param {Measure} measure @param {number} force @param {AbortSignal} signal @returns {Promise<number>} */
async function solved(measure, force, signal) {
  const { state } = muscle, muscleFields = muscle.fields(), options = /** @type {const} */ ({ lane: "side", signal });
  // The command has an inverse of its own for both.
  if (measure.key === "p")
    return (await engine().ask("pressure", { ...muscleFields, force_n: force, contraction: state.e }, options))
      .pressure_mpa;
  if (measure.key === "e")
    return (await engine().ask("contraction", { ...muscleFields, force_n: force, pressure_mpa: state.p }, options))
      .contraction;
  const of = async (/** @type {number} */ value) => {
    const changed = say({ ...state, F: undefined }, measure.key, value);
    return (await engine().ask("force", { ...fields(changed), ...point(changed) }, options)).force_n - force;
  };
  return root(
    of,
    /** @type {number} */ (muscle.value(measure.key)),
    measure,
    NEAR * Math.abs(force),
    () => signal.aborted,
  );
}

/**
 * Where `of` is zero between the ends of a slider, beginning from a value: steps outwards until the sign changes, then
 * bisection with
 * secants (Illinois).
 * @param {(value: number) => Promise<number>} of @param {number} from @param {Measure} measure @param {number} near
 * @param {() => boolean} aborted
 */
export async function root(of, from, { low = 0, high = 1, label, kind }, near, aborted) {
  let asked = 0;
  const ask = async (/** @type {number} */ x) => { asked++; return of(x); };
  let [a, fa] = [from, await ask(from)];
  if (Math.abs(fa) <= near) return a;
  const found = await bracket(ask, a, fa, low, high);
  if (!found)
    throw new Error(
      `No ${label.toLowerCase()} between ${show(kind, low)} and ${show(kind, high)} gives this pull with all else ` +
        `as it is.`,
    );
  let [b, fb, previous] = [found.x, found.f, found.before];
  [a, fa] = [previous.x, previous.f];
  let side = 0;
  while (asked < MOST && !aborted()) {
    const x = (a * fb - b * fa) / (fb - fa), f = await ask(x);
    if (Math.abs(f) <= near) return x;
    if (Math.sign(f) === Math.sign(fb)) { [b, fb] = [x, f]; if (side === 1) fa /= 2; side = 1; }
    else { [a, fa] = [x, f]; if (side === -1) fb /= 2; side = -1; }
  }
  throw new Error("The search did not converge in 12 steps: give a value that is nearer to the wanted one.");
}

/**
 * Two values with different signs: a step to both sides shows which one leads there.
 * @param {(x: number) => Promise<number>} ask @param {number} x0 @param {number} f0 @param {number} low
 * @param {number} high
 */
async function bracket(ask, x0, f0, low, high) {
  const at = async (/** @type {number} */ x) => {
    try {
      return { x, f: await ask(x) };
    } catch (problem) {
      if (/** @type {Error} */ (problem).name === "AbortError") throw problem;
      return undefined;
    }
  };
  const first = await Promise.all([low, high].map(async (end) => ({ end, at: await at(x0 + 0.12 * (end - x0)) })));
  const [best] = first.filter((side) => side.at).sort((a, b) => Math.sign(f0) * (Number(a.at?.f) - Number(b.at?.f)));
  if (!best?.at) return undefined;
  let before = { x: x0, f: f0 };
  let now = /** @type {{ x: number, f: number } | undefined} */ (best.at);
  for (const share of [0.4, 0.7, 0.9, 1]) {
    if (now && Math.sign(now.f) !== Math.sign(f0)) return { ...now, before };
    before = now ?? before;
    now = await at(x0 + share * (best.end - x0));
  }
  return now && Math.sign(now.f) !== Math.sign(f0) ? { ...now, before } : undefined;
}
