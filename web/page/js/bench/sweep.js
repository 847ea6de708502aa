// One measure of the muscle over a range: what it does to the pull and to the rest.
import { answerTo } from "../ask.js";
import { KINDS, withBuilt } from "../chart.js";
import { choice } from "../controls.js";
import { block, capital, remark } from "../dom.js";
import { isAbort, problemOf } from "../engine/problem.js";
import { fieldsOf, form } from "../form.js";
import { muscle } from "../muscle.js";
import { valueAt } from "../plot.js";
import { CONTRACTION, MEASURES, PRESSURE, question, say } from "../state.js";
import { clamp, evenly, inWords, outside, show, unitName } from "../units.js";
import { renewing, rested, signal, watch } from "../watch.js";

/** @typedef {Commands["shape"]["answer"]} Answer */
/** @typedef {{ value: number, answer?: Answer, why?: string }} Row */
/** A result: name, kind, its field, and those of a muscle that is built where they are known. */
export const RESULTS =
  /** @type {[string, string, Kind, keyof Answer & keyof Commands["force"]["answer"], (keyof Answer)[]?][]} */ ([
    ["F", "pull", "force", "force_n", ["predicted_n", "predicted_low_n", "predicted_high_n"]],
    ["k", "stiffness", "stiffness", "stiffness_n_per_mm"],
    ["e", "contraction", "ratio", "contraction"],
    ["b", "bulged diameter", "length", "bulged_diameter_mm"],
    ["V", "volume of the cavity", "volume", "volume_mm3"],
    ["l", "largest stretch of the rubber", "number", "max_stretch"],
    ["T", "tension of all strands", "force", "braid_tension_n"],
  ]).map(([key, label, kind, of, built = []]) => ({ key, label, kind, of, built }));
const POINTS = 21,
  /** After a change it waits so long, in milliseconds. */
  REST = 250;

/** @param {Measure} measure @returns {[number, number]} the range where none is typed */
function usualRange({ key, low = 0, high = Infinity, minimum = -Infinity, maximum = Infinity }) {
  if (key === PRESSURE.key || key === CONTRACTION.key) return [low, key === "e" ? 0.3 : high];
  const now = muscle.value(key) ?? (Number.isFinite(high) ? (low + high) / 2 : 1);
  const ends = now === 0 ? [0, 1] : [0.7 * now, 1.3 * now].sort((a, b) => a - b);
  const at = (/** @type {number} */ v) => Number(clamp(v, minimum, maximum).toPrecision(3));
  return [at(ends[0]), at(ends[1])];
}

/** @param {Store} store @param {import("../chart.js").Chart} chart */
export function sweepView(store, chart) {
  /** @type {Signal<Row[]>} */ const rows = signal([]),
    begin = renewing(),
    /** @type {Measure[]} */ measures = [PRESSURE, CONTRACTION, ...MEASURES];
  const measure = () => measures.find(({ key }) => key === store.wanted.value.x) ?? PRESSURE,
    result = () => RESULTS.find(({ key }) => key === store.wanted.value.y) ?? RESULTS[0];
  let fields = form([], () => {}),
    of = "";
  const x = choice(
    "Over",
    measures.map(({ key, label }) => [key, label]),
    (key) => store.look({ x: key, from: "", to: "" }),
  );
  const y = choice(
    "Result",
    RESULTS.map(({ key, label }) => [key, capital(label)]),
    (key) => store.look({ y: key }),
  );
  const range = block(),
    said = block(),
    element = block("sweep", x.element, y.element, range, said);

  /** Fields of the range of this measure. */
  function ask() {
    const { kind, key } = measure();
    if (key === of) return;
    of = key;
    fields = form(
      fieldsOf([
        ["from", "from", "From", kind],
        ["to", "to", "To", kind],
      ]),
      () => store.look(fields.texts()),
    );
    fields.element.addEventListener("change", () => store.look(fields.texts()));
    range.replaceChildren(fields.element);
  }

  async function run() {
    const signal = begin(),
      read = await fields.read(),
      [low, high] = usualRange(measure());
    if (!read || signal.aborted) return;
    const { state } = muscle,
      { key } = measure(),
      values = evenly(read.from ?? low, read.to ?? high, POINTS).map((v) =>
        Number(v.toPrecision(12)),
      );
    const found = await Promise.all(values.map((v) => at(say(state, key, v), v, signal)));
    if (!signal.aborted) rows.value = found;
  }
  /** @param {State} state @param {number} value @param {AbortSignal} signal @returns {Promise<Row>} */
  async function at(state, value, signal) {
    try {
      const how = /** @type {const} */ ({ lane: "curves", signal });
      return { value, answer: await answerTo("shape", question(state), how) };
    } catch (thrown) {
      // A muscle that cannot be is a gap in the curve.
      return { value, why: isAbort(thrown) ? "" : problemOf(thrown).message };
    }
  }

  const soon = rested(run, REST);
  watch(() => {
    const { test, ...wanted } = store.wanted.value;
    void muscle.state;
    soon(-1);
    if (test !== "sweep") return begin();
    ask();
    x.set(wanted.x);
    y.set(wanted.y);
    const [low, high] = usualRange(measure()).map((v) => show(measure().kind, v, 3));
    fields.usual("from", low);
    fields.usual("to", high);
    fields.set(new URLSearchParams({ from: wanted.from, to: wanted.to }));
    soon();
  });

  watch(() => {
    const list = rows.value;
    if (store.wanted.value.test !== "sweep" || !list.length) return;
    const { kind, label, symbol, key } = measure(),
      { label: name, kind: of, of: field, built } = result();
    const value = (/** @type {Row} */ { answer }, /** @type {keyof Answer} */ what) =>
      typeof answer?.[what] === "number" ? outside(of, answer[what]) : null;
    const unit = (/** @type {Kind} */ k) => (k === "number" ? "–" : unitName(k));
    const now = outside(kind, muscle.value(key) ?? NaN),
      curve = {
        name: `${name} over ${label.toLowerCase()}`,
        x: list.map((row) => outside(kind, row.value)),
        y: list.map((row) => value(row, field)),
        colour: KINDS[0],
        strong: true,
        smooth: true,
      };
    // The present muscle on the curve.
    const here = valueAt(curve, now);
    chart.show({
      x: `${label.toLowerCase()}${symbol ? ` ${symbol}` : ""} [${unit(kind)}]`,
      y: `${name} [${unit(of)}]`,
      yaxis: {},
      marks: here === undefined ? [] : [{ x: now, y: here, text: "now" }],
      series: withBuilt(
        curve,
        curve.x,
        list.map((row) => built.flatMap((what) => value(row, what) ?? [])),
      ),
    });
    const failed = list.filter(({ why }) => why),
      [one] = failed;
    said.replaceChildren(
      one
        ? remark(
            `${failed.length} of ${list.length} values have no answer, such as ` +
              `${show(kind, one.value)}: ${inWords(one.why ?? "")}`,
          )
        : "",
    );
  });
  return { element };
}
