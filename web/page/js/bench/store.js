// What the views of the page Muscle share: what is to be shown, the newest answers, and the
// questions that lead to them.
import { Slot } from "../ask.js";
import { atEnd } from "../life.js";
import { muscle } from "../muscle.js";
import { PRESSURE, point as pointOf } from "../state.js";
import { reach } from "../view3d.js";
import { niceUp } from "../units.js";

/** Keys of the address that are the page's own. */
export const OWN = ["test", "show", "cut", "over"];
/** @typedef {Commands["shape"]["answer"] & { arrays: Record<string, Float32Array> }} Shape */
/**
 * What views are told: of an answer whether it belongs to the pump, of a problem the state that it
 * is about.
 * @typedef {{ answer: boolean, problem: { problem: Problem, state: State }, facts: undefined,
 *   sync: undefined, changed: undefined, look: undefined, ranges: undefined }} Told
 * @typedef {keyof Told} Event
 */
/**
 * `start`: P′; `said`: what `force` has to say of a state.
 * @typedef {Partial<Commands["check"]["answer"]> & { start?: number | null,
 * said?: Pick<Commands["contraction"]["answer"], "warnings" | "predicted" | "predicted_low" |
 * "predicted_high"> &
 *   { state: unknown, words?: Commands["force"]["answer"]["uncertainty_words"] } }} Facts
 */

export class Store {
  /** @param {(on: boolean) => void} busy */
  constructor(busy) {
    this.wanted = { test: "isobaric", show: "max_stretch", cut: "", over: "" };
    /** @type {Shape | undefined} */ this.shape = undefined;
    /** The same where it is of the present muscle. @type {Shape | undefined} */ this.point =
      undefined;
    /** @type {Facts} */ this.facts = {};
    /**
     * Ends of the colour scales, by field: of the muscle up to its supply.
     * @type {Record<string, [number, number]> | undefined}
     */
    this.ranges = undefined;
    this.rangesKey = "";
    /** @type {Map<Event, ((more: never) => void)[]>} */ this.listeners = new Map();
    this.slots = {
      state: new Slot({ lane: "state", busy }),
      fact: new Slot(),
      start: new Slot(),
      range: new Slot(),
    };
    this.timers = { follow: 0, start: 0 };
    atEnd(() => Object.values(this.timers).forEach(clearTimeout));
  }

  /** @template {Event} E @param {E} what @param {(more: Told[E]) => void} tell */
  on(what, tell) {
    this.listeners.set(what, [...(this.listeners.get(what) ?? []), tell]);
  }
  /** @template {Event} E @param {E} what @param {Told[E]} [more] */
  tell(what, more) {
    this.listeners.get(what)?.forEach((tell) => tell(/** @type {never} */ (more)));
  }

  /** @param {string} key @param {number | string | undefined} value @param {boolean} settled */
  changed(key, value, settled) {
    this.tell("changed");
    muscle.set(key, value);
    this.tell("sync");
    this.ask();
    clearTimeout(this.timers.follow);
    if (settled) {
      this.settle();
      this.follow();
    } else this.timers.follow = window.setTimeout(() => this.follow(), 120);
  }

  /** @param {Partial<Store["wanted"]>} wish */
  look(wish) {
    Object.assign(this.wanted, wish);
    this.tell("look");
    this.settle();
  }

  settle() {
    const { test, show, cut, over } = this.wanted;
    const own = {
      test: test === "isobaric" ? "" : test,
      show: show === "max_stretch" ? "" : show,
      cut,
      over,
    };
    muscle.place("muscle", own);
  }

  /**
   * The point and its shape.
   * @param {{ pressure_mpa: number, contraction: number }} [shown] in place of the state's
   */
  ask(shown) {
    const { state } = muscle,
      request = { muscle: muscle.fields(), ...(shown ?? pointOf(state)) };
    this.slots.state.ask(
      "shape",
      request,
      (answer) => {
        this.shape = this.point = /** @type {Shape} */ (answer);
        if (muscle.state === state) this.take(state, this.point);
        this.tell("answer", shown !== undefined);
      },
      (problem) => {
        this.point = undefined;
        this.tell("problem", { problem, state });
      },
    );
  }

  /** @param {State} state @param {Shape} answer */
  take(state, answer) {
    muscle.shown = { ...muscle.shown, ...answer.muscle };
    if (state.F !== undefined) {
      muscle.state = { ...state, e: answer.contraction };
      clearTimeout(this.timers.start);
      this.timers.start = window.setTimeout(() => this.starts(), 120);
    }
    this.tell("sync");
  }

  /** What comes after: P′, and what the muscle does at this pressure. */
  follow() {
    const { state } = muscle;
    this.slots.fact.ask("check", { muscle: muscle.fields(), pressure_mpa: state.p }, (answer) => {
      this.facts = { ...answer, start: this.facts.start, said: this.facts.said };
      if (muscle.state.said === state.said) {
        muscle.shown = answer;
        this.tell("sync");
      }
      this.tell("facts");
      this.range();
    });
    // Of a load the contraction is known with its shape.
    if (state.F === undefined) this.starts();
  }

  /**
   * P′ at the contraction of the state, and what `force` has to say: whether it bursts takes more
   * than a shape.
   */
  starts() {
    const { state } = muscle;
    this.slots.start.ask(
      state.F === undefined ? "force" : "contraction",
      { muscle: muscle.fields(), ...pointOf(state) },
      (answer) => {
        this.facts = {
          ...this.facts,
          start: answer.start_pressure_mpa,
          said: { ...answer, state, words: answer.uncertainty_words },
        };
        this.tell("facts");
      },
      () => {
        this.facts = { ...this.facts, start: undefined };
      },
    );
  }

  /**
   * The pressure that the colours reach to: that of the gauge, or the one that the muscle may have.
   */
  supply() {
    const allowed =
      this.facts.characteristics?.allowed_pressure_mpa ?? this.facts.rated_pressure_mpa ?? Infinity;
    const usual = Math.min(PRESSURE.high, allowed);
    return muscle.p > usual ? niceUp(muscle.p) : usual;
  }

  /**
   * Between which values the colours run: what the muscle shows anywhere between blocked and free,
   * up to its supply.
   */
  range() {
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
    const found = /** @type {Record<string, [number, number]>} */ ({});
    const done = () => {
      if (this.rangesKey !== key) return;
      const at = states.shift(),
        take = (/** @type {object} */ answer) => {
          widen(found, /** @type {Shape} */ (answer));
          done();
        };
      if (at) return this.slots.range.ask("shape", { muscle: of, ...at }, take, done);
      this.ranges = Object.keys(found).length ? found : undefined;
      this.tell("ranges");
    };
    done();
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
