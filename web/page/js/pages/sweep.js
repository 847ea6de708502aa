// One measure of the muscle over a range: what it does to the pull and to the rest.
import { engine } from "../ask.js";
import { chartOf, KINDS, withBuilt } from "../chart.js";
import { choice } from "../controls.js";
import { block, capital, el, heading, mainButton, problemBox, rowOf, smallPrint } from "../dom.js";
import { isAbort, problemOf } from "../engine/problem.js";
import { bench, fieldsOf, form } from "../form.js";
import { renewing } from "../life.js";
import { muscle } from "../muscle.js";
import { valueAt } from "../plot.js";
import { CONTRACTION, MEASURES, PRESSURE, question, say } from "../state.js";
import { clamp, evenly, inWords, number, onUnits, outside, show, unitName } from "../units.js";

/** @typedef {Commands["shape"]["answer"]} Answer */
/** @typedef {{ value: number, answer?: Answer, why?: string }} Row */
/** A result: name, kind, its field, and those of a muscle that is built where they are known. */
const RESULTS = /** @type {[string, string, Kind, keyof Answer, (keyof Answer)[]?][]} */ ([
  ["F", "pull", "force", "force_n", ["predicted_n", "predicted_low_n", "predicted_high_n"]],
  ["k", "stiffness", "stiffness", "stiffness_n_per_mm"],
  ["e", "contraction", "ratio", "contraction"],
  ["b", "bulged diameter", "length", "bulged_diameter_mm"],
  ["V", "volume of the cavity", "volume", "volume_mm3"],
  ["l", "largest stretch of the rubber", "number", "max_stretch"],
  ["T", "tension of all strands", "force", "braid_tension_n"],
]).map(([key, label, kind, of, built]) => ({ key, label, kind, of, built }));
const POINTS = 21,
  MOST = 201;

/** @param {Measure} measure @returns {[number, number]} the range where none is typed */
function usualRange({ key, low = 0, high = Infinity, minimum = -Infinity, maximum = Infinity }) {
  if (key === PRESSURE.key || key === CONTRACTION.key) return [low, key === "e" ? 0.3 : high];
  const now = muscle.value(key) ?? (Number.isFinite(high) ? (low + high) / 2 : 1);
  const ends = now === 0 ? [0, 1] : [0.7 * now, 1.3 * now].sort((a, b) => a - b);
  const at = (/** @type {number} */ v) => Number(clamp(v, minimum, maximum).toPrecision(3));
  return [at(ends[0]), at(ends[1])];
}

/** @type {Mount} */
export const mount = (main) => {
  const asked = { x: "p", y: "F" };
  /** @type {Row[]} */ let rows = [];
  /** @type {Measure[]} */ let measures = [PRESSURE, CONTRACTION];
  const begin = renewing();
  let range = form([], () => run());
  const measure = () => measures.find(({ key }) => key === asked.x) ?? PRESSURE;
  const what = choice("Over", [["p", PRESSURE.label]], "p", (key) => {
    asked.x = key;
    ask();
    run();
  });
  const result = choice(
    "Result",
    RESULTS.map(({ key, label }) => [key, capital(label)]),
    "F",
    (key) => {
      asked.y = key;
      place();
      paint();
    },
  );
  const box = block(),
    said = block(),
    title = heading("Sweep");
  const bar = el("progress", { hidden: true, ariaLabel: "Progress of the sweep" });
  const chart = chartOf("sweep", { tools: title, tall: true });
  main.replaceChildren(
    bench(
      "Measure and range",
      [
        what.element,
        box,
        result.element,
        rowOf(
          mainButton("Compute", () => run()),
          bar,
        ),
      ],
      [said, chart.element],
    ),
  );

  /** Fields of the range of this measure. */
  function ask() {
    const { kind } = measure();
    range = form(
      fieldsOf([
        ["from", "from", "From", kind],
        ["to", "to", "To", kind],
        ["points", "points", "Points", "number", { hint: String(POINTS) }],
      ]),
      () => run(),
    );
    box.replaceChildren(range.element);
    usual();
  }
  function usual() {
    const { kind } = measure(),
      at = usualRange(measure());
    ["from", "to"].forEach((key, i) => range.usual(key, show(kind, at[i], 3)));
  }
  const place = () =>
    muscle.place("sweep", {
      ...range.texts(),
      x: asked.x === "p" ? "" : asked.x,
      y: asked.y === "F" ? "" : asked.y,
    });

  /** The values, or nothing where a text cannot be read. */
  async function values() {
    const read = await range.read();
    if (!read) return undefined;
    const [low, high] = usualRange(measure()),
      from = read.from ?? low,
      to = read.to ?? high;
    const count = Math.round(read.points ?? POINTS);
    if (count >= 2 && count <= MOST)
      return evenly(from, to, count).map((v) => Number(v.toPrecision(12)));
    range.mark("points", `Give between 2 and ${MOST} points.`);
  }
  async function run() {
    const signal = begin(),
      list = await values();
    if (!list || signal.aborted || !said.isConnected) return;
    place();
    const { state } = muscle,
      found = /** @type {Row[]} */ ([]);
    Object.assign(bar, { max: list.length, hidden: false });
    try {
      for (const value of list) {
        bar.value = found.length;
        found.push(await at(say(state, asked.x, value), value, signal));
      }
      rows = found;
      paint();
    } catch (problem) {
      if (signal.aborted) return;
      said.replaceChildren(problemBox(problem));
    }
    bar.hidden = true;
  }
  /** @param {State} of @param {number} value @param {AbortSignal} signal @returns {Promise<Row>} */
  async function at(of, value, signal) {
    try {
      return {
        value,
        answer: await engine().ask("shape", question(of), { lane: "curves", signal }),
      };
    } catch (thrown) {
      const { kind, message } = problemOf(thrown);
      // A muscle that cannot be is a gap in the curve; an engine that is gone ends the sweep.
      if (isAbort(thrown) || kind === "engine") throw thrown;
      return { value, why: message };
    }
  }

  function paint() {
    if (!rows.length) return;
    const { kind, label, symbol } = measure(),
      y = RESULTS.find(({ key }) => key === asked.y) ?? RESULTS[0];
    const at = (/** @type {Row} */ { answer }, /** @type {keyof Answer} */ of) =>
      typeof answer?.[of] === "number" ? outside(y.kind, answer[of]) : null;
    const unit = (/** @type {Kind} */ k) => (k === "number" ? "–" : unitName(k));
    const name = `${y.label} over ${label.toLowerCase()}`,
      now = outside(kind, muscle.value(asked.x) ?? NaN);
    const curve = {
      name,
      x: rows.map(({ value }) => outside(kind, value)),
      y: rows.map((row) => at(row, y.of)),
      colour: KINDS[0],
      strong: true,
      smooth: true,
    };
    // The present muscle on the curve.
    const here = valueAt(curve, now);
    chart.show({
      x: `${label.toLowerCase()}${symbol ? ` ${symbol}` : ""} [${unit(kind)}]`,
      y: `${y.label} [${unit(y.kind)}]`,
      yaxis: {},
      marks: here === undefined ? [] : [{ x: now, y: here, text: "now" }],
      series: withBuilt(
        curve,
        curve.x,
        rows.map((row) => (y.built ?? []).flatMap((of) => at(row, of) ?? [])),
      ),
    });
    title.textContent = capital(name);
    const failed = rows.filter(({ why }) => why);
    const [one] = failed,
      such =
        one && `${number(outside(kind, one.value))} ${unitName(kind)}: ${inWords(one.why ?? "")}`;
    said.replaceChildren(
      one
        ? smallPrint(`${failed.length} of ${rows.length} values have no answer, such as ${such}`)
        : "",
    );
  }
  onUnits(() => {
    usual();
    paint();
    place();
  });
  return {
    async load(params) {
      await muscle.read(params, ["x", "y", "from", "to", "points"]);
      measures = [PRESSURE, CONTRACTION, ...MEASURES];
      what.labels(measures.map(({ key, label }) => [key, label]));
      const known = (
        /** @type {{ key: string }[]} */ list,
        /** @type {string} */ key,
        /** @type {string} */ usual,
      ) => (list.some((one) => one.key === params.get(key)) ? (params.get(key) ?? usual) : usual);
      Object.assign(asked, { x: known(measures, "x", "p"), y: known(RESULTS, "y", "F") });
      what.set(asked.x);
      result.set(asked.y);
      ask();
      range.set(params);
      await run();
    },
  };
};
