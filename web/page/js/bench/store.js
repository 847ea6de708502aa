// What the views of the page Muscle share: what is to be shown, the newest answers, and the
// questions that lead to them.
import { Slot, answerTo } from "../ask.js";
import { keepWords } from "../kept.js";
import { muscle } from "../muscle.js";
import { PRESSURE, point as pointOf } from "../state.js";
import { allowedOf } from "./family.js";
import { reach } from "../view3d.js";
import { niceUp } from "../units.js";
import { batch, rested, signal } from "../watch.js";

/** Keys of the address that are the page's own, with their usual words. */
export const OWN = {
  test: "isobaric",
  show: "max_stretch",
  cut: "",
  over: "",
  held: "",
  x: "p",
  y: "F",
  from: "",
  to: "",
};
/** @typedef {Commands["shape"]["answer"] & { arrays: Record<string, Float32Array> }} Shape */

/** @template T @param {T | undefined} [first] */
const nothing = (first) => signal(/** @type {T | undefined} */ (first));

export class Store {
  wanted = signal({ ...OWN });
  /** What is drawn. @type {ReturnType<typeof nothing<Shape>>} */ shape = nothing();
  /** The same where it is of the present muscle. @type {typeof this.shape} */ point = nothing();
  /**
   * Why the present muscle has none.
   * @type {ReturnType<typeof nothing<{ problem: Problem, state: State }>>}
   */
  problem = nothing();
  /** What the muscle does at this pressure. */
  /** @type {Signal<Partial<Commands["check"]["answer"]>>} */ facts = signal({});
  /**
   * Ends of the colour scales, by field: of the muscle up to its supply.
   * @type {ReturnType<typeof nothing<Record<string, [number, number]>>>}
   */
  ranges = nothing();
  rangesKey = "";
  soon = rested(() => this.follow(), 120);

  /** @param {(on: boolean) => void} busy */
  constructor(busy) {
    this.slots = { state: new Slot({ lane: "state", busy }), fact: new Slot() };
  }

  /** @param {string} key @param {number | string | undefined} value @param {boolean} settled */
  changed(key, value, settled) {
    muscle.set(key, value);
    this.ask();
    this.soon(settled ? 0 : undefined);
  }

  /** @param {Partial<typeof OWN>} wish */
  look(wish) {
    this.wanted.value = { ...this.wanted.peek(), ...wish };
    const own = Object.entries(this.wanted.peek()).filter(
      ([key, word]) => word !== /** @type {Words} */ (OWN)[key],
    );
    keepWords("muscle", Object.fromEntries(own));
  }

  /** The point and its shape. */
  ask() {
    const { state } = muscle;
    this.slots.state.ask(
      "shape",
      { muscle: muscle.fields(), ...pointOf(state) },
      (answer) =>
        batch(() => {
          this.shape.value = this.point.value = /** @type {Shape} */ (answer);
          this.problem.value = undefined;
          if (muscle.state !== state) return;
          muscle.shown = { ...muscle.shown, ...answer.muscle };
          if (state.F !== undefined) muscle.state = { ...state, e: answer.contraction };
        }),
      (problem) =>
        batch(() => {
          this.point.value = undefined;
          this.problem.value = { problem, state };
        }),
    );
  }

  /** What comes after: what the muscle does at this pressure. */
  follow() {
    const { state } = muscle;
    this.slots.fact.ask("check", { muscle: muscle.fields(), pressure_mpa: state.p }, (answer) => {
      batch(() => {
        this.facts.value = answer;
        if (muscle.state.said === state.said) muscle.shown = answer;
      });
      this.range();
    });
  }

  /** The pressure that the colours reach to: the usual one, or the one that the muscle may have. */
  supply() {
    const usual = Math.min(PRESSURE.high, allowedOf(this));
    return muscle.p > usual ? niceUp(muscle.p) : usual;
  }

  /**
   * Between which values the colours run: what the muscle shows anywhere between blocked and free,
   * up to its supply.
   */
  async range() {
    const of = muscle.fields(),
      supply = this.supply(),
      key = JSON.stringify([of, supply]);
    if (key === this.rangesKey) return;
    this.rangesKey = key;
    const states = [
      { pressure_mpa: supply, contraction: 0 },
      { pressure_mpa: supply, force_n: 0 },
      { pressure_mpa: supply / 10, contraction: 0 },
    ];
    const shapes = await Promise.all(
      states.map((at) => answerTo("shape", { muscle: of, ...at }).catch(() => undefined)),
    );
    /** @type {Record<string, [number, number]>} */ const found = {};
    for (const shape of shapes) if (shape) widen(found, /** @type {Shape} */ (shape));
    if (this.rangesKey === key) this.ranges.value = shapes.some(Boolean) ? found : undefined;
  }
}

/** @param {Record<string, [number, number]>} found @param {Shape} shape */
function widen(found, { arrays }) {
  for (const [field, list] of Object.entries(arrays)) {
    const [low, high] = reach(list),
      before = found[field] ?? [Infinity, -Infinity];
    found[field] = [Math.min(low, before[0]), Math.max(high, before[1])];
  }
}
