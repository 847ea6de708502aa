// Which pressure, contraction, diameter, wall or angle gives a wanted pull; the others stay as they are.
import { engine } from "../ask.js";
import { button, el, folded } from "../dom.js";
import { isAbort } from "../engine/problem.js";
import { fieldsOf, form } from "../form.js";
import { renewing } from "../life.js";
import { muscle } from "../muscle.js";
import { CONTRACTION, PRESSURE, QUANTITIES, question, say } from "../state.js";
import { show, showForce } from "../units.js";
import { inWords } from "../words.js";

/** Secants at most, and as near as this, as a share of the wanted pull. */
const MOST = 12,
  NEAR = 2e-4;

/** @param {Store} store */
export function solveView(store) {
  const choices = [
    PRESSURE,
    CONTRACTION,
    ...QUANTITIES.filter((m) => m.key !== "L"),
  ];
  const asked = form(
    fieldsOf([
      [
        "what",
        "what",
        "Solve for",
        undefined,
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
      const measure = /** @type {Measure} */ (
        choices.find((m) => m.key === what)
      );
      const value = await solved(measure, force, signal);
      said.textContent = `${measure.label} ${show(measure.kind, value, 4)} gives ${showForce(force, 4)}.`;
      store.changed(measure.key, value, true);
    } catch (problem) {
      if (!signal.aborted)
        said.textContent = inWords(/** @type {Error} */ (problem).message);
    }
  }
  return { element };
}

/** @param {Measure} measure @param {number} force @param {AbortSignal} signal @returns {Promise<number>} */
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
    return (
      (await engine().ask("force", question(changed), options)).force_n - force
    );
  };
  return root(
    over,
    Number(muscle.value(measure.key)),
    measure,
    NEAR * Math.abs(force),
  );
}

/**
 * Where a function is zero between the ends of a slider: outwards from a value to both sides until its sign changes,
 * then secants that keep it between (Illinois).
 * @param {(value: number) => Promise<number>} of @param {number} from @param {Measure} measure @param {number} near
 */
async function root(
  of,
  from,
  { low = 0, high = 1, around, label, kind },
  near,
) {
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
    const both = await Promise.all(
      ends.map((end) => at(from + share * (end - from))),
    );
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
