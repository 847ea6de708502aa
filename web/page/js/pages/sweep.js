// One measure of the muscle over a range: what it does to the pull and to the rest.
import { engine } from "../ask.js";
import { address, write } from "../address.js";
import { Chart, KINDS } from "../chart.js";
import { choice } from "../controls.js";
import { capital, el, problemBox } from "../dom.js";
import { isAbort } from "../engine/problem.js";
import { form } from "../form.js";
import { atEnd } from "../life.js";
import { muscle } from "../muscle.js";
import { CONTRACTION, MEASURES, PRESSURE, fields, point, say } from "../state.js";
import { number, onUnits, outside, show, unitName } from "../units.js";
import { inWords } from "../words.js";

/** @typedef {import("../../../types/commands").Commands["shape"]["answer"]} Answer */
/** @typedef {import("../state.js").Measure} Measure */
/**
 * A result: name, kind, value, and half of its ± where it is known.
 * @typedef {{ key: string, label: string, kind: import("../units.js").Kind, of: (a: Answer) => number | null |
 *   undefined, half?: (a: Answer) => number | null | undefined }} Result
 */
/** @type {Result[]} */
const RESULTS = [
  { key: "F", label: "pull", kind: "force", of: (a) => a.force_n, half: (a) => a.uncertainty_n },
  { key: "k", label: "stiffness", kind: "stiffness", of: (a) => a.stiffness_n_per_mm },
  { key: "e", label: "contraction", kind: "ratio", of: (a) => a.contraction, half: (a) => a.contraction_uncertainty },
  { key: "b", label: "bulged diameter", kind: "length", of: (a) => a.bulged_diameter_mm },
  { key: "V", label: "volume of the cavity", kind: "volume", of: (a) => a.volume_mm3 },
  { key: "l", label: "largest stretch of the rubber", kind: "number", of: (a) => a.max_stretch },
  { key: "T", label: "tension of all strands", kind: "force", of: (a) => a.braid_tension_n },
];
const POINTS = 21, MOST = 201;

/** @param {Measure} measure @returns {[number, number]} the range where none is typed */
function usualRange({ key, low = 0, high = Infinity, minimum = -Infinity, maximum = Infinity }) {
  if (key === PRESSURE.key || key === CONTRACTION.key) return [low, key === "e" ? 0.3 : high];
  const now = muscle.value(key) ?? (Number.isFinite(high) ? (low + high) / 2 : 1);
  const ends = now === 0 ? [0, 1] : [0.7 * now, 1.3 * now].sort((a, b) => a - b);
  const at = (/** @type {number} */ v) => Number(Math.min(maximum, Math.max(minimum, v)).toPrecision(3));
  return [at(ends[0]), at(ends[1])];
}

class SweepPage {
  state = { x: "p", y: "F" };
  /** @type {{ value: number, answer?: Answer, why?: string }[]} */ #rows = [];
  #ends = new AbortController();
  /** @type {Measure[]} */ #measures = [PRESSURE, CONTRACTION];
  /** @type {ReturnType<typeof form> | undefined} */ #range;

  /** @param {HTMLElement} main */
  constructor(main) {
    this.what = choice("Over", [["p", PRESSURE.label]], "p", (key) => this.#over(key));
    this.result = choice("Result", RESULTS.map(({ key, label }) => [key, capital(label)]), "F", (key) => {
      this.state.y = key;
      this.#place();
      this.#paint();
    });
    this.ends = el("div", {});
    this.said = el("div", {});
    this.bar = el("progress", { hidden: true, "aria-label": "Progress of the sweep" });
    this.title = el("h2", {}, "Sweep");
    this.chart = new Chart("sweep", { tools: this.title, tall: true });
    const run = el("button", { type: "button", class: "main", onclick: () => this.#run() }, "Compute");
    main.replaceChildren(el("div", { class: "bench two" },
      el("section", { class: "controls", "aria-label": "Measure and range" }, el("h2", {}, "Sweep"), this.what.element,
        this.ends,
        this.result.element, el("p", { class: "row" }, run, this.bar)),
      el("div", { class: "middle" }, this.said, this.chart.element)));
    atEnd(onUnits(() => {
      this.#usual();
      this.#paint();
      this.#place();
    }));
  }

  get #measure() { return this.#measures.find(({ key }) => key === this.state.x) ?? PRESSURE; }

  /** Fields of the range of this measure. */
  #fields() {
    const { kind } = this.#measure;
    this.#range = form([
      { key: "from", field: "from", label: "From", kind },
      { key: "to", field: "to", label: "To", kind },
      { key: "points", field: "points", label: "Points", kind: "number", hint: String(POINTS) },
    ], () => this.#run());
    this.ends.replaceChildren(this.#range.element);
    this.#usual();
  }
  #usual() {
    const { kind } = this.#measure, ends = usualRange(this.#measure);
    ["from", "to"].forEach((key, i) => this.#range?.usual(key, show(kind, ends[i], 3)));
  }
  /** @param {string} key */
  #over(key) {
    this.state.x = key;
    this.#fields();
    this.#run();
  }
  #place() {
    const own = { x: this.state.x === "p" ? "" : this.state.x, y: this.state.y === "F" ? "" : this.state.y };
    write(address("sweep", { ...muscle.params(), ...this.#range?.texts(), ...own }));
  }

  /** The values, or nothing where a text cannot be read. */
  async #values() {
    const read = await this.#range?.read();
    if (!read) return undefined;
    const usual = usualRange(this.#measure), from = read.from ?? usual[0], to = read.to ?? usual[1];
    const count = Math.round(read.points ?? POINTS);
    if (count < 2 || count > MOST) {
      this.#range?.mark("points", `Give between 2 and ${MOST} points.`);
      return undefined;
    }
    return Array.from({ length: count }, (_, i) => Number((from + ((to - from) * i) / (count - 1)).toPrecision(12)));
  }

  async #run() {
    this.#ends.abort();
    const { signal } = (this.#ends = new AbortController()), values = await this.#values();
    if (!values || signal.aborted || !this.said.isConnected) return;
    this.#place();
    const rows = /** @type {{ value: number, answer?: Answer, why?: string }[]} */ ([]), { state } = muscle;
    this.bar.max = values.length;
    this.bar.hidden = false;
    try {
      for (const value of values) {
        this.bar.value = rows.length;
        rows.push(await this.#at(say(state, this.state.x, value), value, signal));
      }
    } catch (problem) {
      if (!isAbort(problem) && !signal.aborted) this.said.replaceChildren(problemBox(problem));
      return;
    }
    this.bar.hidden = true;
    this.#rows = rows;
    this.#paint();
  }
  /** @param {import("../state.js").State} at @param {number} value @param {AbortSignal} signal */
  async #at(at, value, signal) {
    try {
      const request = { ...fields(at), ...point(at) };
      return { value, answer: await engine().ask("shape", request, { lane: "curves", signal }) };
    } catch (problem) {
      const { kind, message } = /** @type {import("../engine/problem.js").Problem} */ (problem);
      // A muscle that cannot be is a gap in the curve; an engine that is gone ends the sweep.
      if (isAbort(problem) || kind === "engine") throw problem;
      return { value, why: message };
    }
  }

  #paint() {
    const rows = this.#rows, { kind, label, symbol } = this.#measure;
    if (!rows.length) return;
    const y = RESULTS.find(({ key }) => key === this.state.y) ?? RESULTS[0];
    const at = (/** @type {(a: Answer) => number | null | undefined} */ of) => rows.map(({ answer }) => {
      const value = answer && of(answer);
      return value === undefined || value === null ? null : outside(y.kind, value);
    });
    const unit = (/** @type {import("../units.js").Kind} */ k) => (k === "number" ? "–" : unitName(k));
    const name = `${y.label} over ${label.toLowerCase()}`, x = rows.map(({ value }) => outside(kind, value));
    const marks = this.#now(y);
    this.chart.show({ x: `${label.toLowerCase()}${symbol ? ` ${symbol}` : ""} [${unit(kind)}]`,
      y: `${y.label} [${unit(y.kind)}]`, yaxis: {}, marks,
      series: [{ name, x, y: at(y.of), half: y.half && at(y.half), colour: KINDS[0], strong: true }] });
    this.title.textContent = capital(name);
    const failed = rows.filter(({ why }) => why);
    this.said.replaceChildren(failed.length
      ? el("p", { class: "small" }, `${failed.length} of ${rows.length} values have no answer, such as `
        + `${number(outside(kind, failed[0].value))} ${unitName(kind)}: ${inWords(failed[0].why ?? "")}`)
      : "");
  }
  /** The present muscle on the curve. @param {Result} y */
  #now({ of, kind: k }) {
    const { kind } = this.#measure, now = muscle.value(this.state.x);
    const near = this.#rows.findLastIndex(({ value }) => value <= (now ?? NaN));
    const [a, b] = this.#rows.slice(near, near + 2);
    const [u, v] = [a, b].map((row) => row?.answer && of(row.answer));
    if (now === undefined || near < 0 || typeof u !== "number") return [];
    const share = b && typeof v === "number" ? (now - a.value) / (b.value - a.value) : 0;
    const value = u + share * ((typeof v === "number" ? v : u) - u);
    return [{ x: outside(kind, now), y: outside(k, value), text: "now" }];
  }

  /** @param {URLSearchParams} params */
  async load(params) {
    await muscle.read(params, ["x", "y", "from", "to", "points"]);
    this.#measures = [PRESSURE, CONTRACTION, ...MEASURES];
    this.what.labels(this.#measures.map(({ key, label }) => [key, label]));
    const [x, y] = [params.get("x") ?? "p", params.get("y") ?? "F"];
    this.state = { x: this.#measures.some(({ key }) => key === x) ? x : "p",
      y: RESULTS.some(({ key }) => key === y) ? y : "F" };
    this.what.set(this.state.x);
    this.result.set(this.state.y);
    this.#fields();
    this.#range?.set(params);
    await this.#run();
  }
  unmount() {
    this.#ends.abort();
  }
}

/** @param {HTMLElement} main */
export const mount = (main) => new SweepPage(main);
