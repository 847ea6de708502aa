// Curves of the page Muscle: a family, the curve of the present state and as built, other models, and measured points.
import { Slot } from "../ask.js";
import { Chart, builtAt } from "../chart.js";
import { choice } from "../controls.js";
import { folded, tabs } from "../dom.js";
import { atEnd } from "../life.js";
import { muscle } from "../muscle.js";
import { onTheme } from "../theme.js";
import { forceAxis, outside, ratioAxis, unitName } from "../units.js";
import { along } from "./along.js";
import {
  FAMILY,
  OVERLAYS,
  allowedOf,
  builtContraction,
  familyOf,
  familySeries,
  overlay,
  ownOf,
  ownSeries,
  permitted,
  reachOf,
} from "./family.js";
import { Points, pointSeries } from "./points.js";

const TESTS = /** @type {[string, string][]} */ ([
  ["isobaric", "Isobaric"],
  ["isometric", "Isometric"],
  ["isotonic", "Isotonic"],
  ["along", "Along the muscle"],
]);

export class Curves {
  /** @param {Store} store */
  constructor(store) {
    this.store = store;
    const slot = () => new Slot({ lane: "curves" });
    this.slots = { family: slot(), own: slot(), over: slot(), exact: slot() };
    /** @type {{ test: string, answer: CurveAnswer, top: number } | undefined} */ this.family =
      undefined;
    /** @type {{ test: string, answer: CurveAnswer } | undefined} */ this.own =
      undefined;
    /** @type {CurveAnswer[]} */ this.overlays = [];
    /** What was asked last. */
    this.keys = { family: "", own: "", over: "" };
    this.timer = 0;
    /** Questions, and when the hand that moves gets curves again. */
    this.turn = this.due = 0;
    this.over = choice(
      "Another model",
      ["", ...OVERLAYS].map((name) => [name, name || "none"]),
      store.wanted.over,
      (over) => {
        store.wanted.over = over;
        this.ask();
        store.settle();
      },
    );
    this.advanced = folded("Advanced", this.over.element);
    const choose = (/** @type {string} */ test) => {
      store.look({ test });
      this.draw();
      this.ask();
    };
    this.tab = tabs("Curves", TESTS, store.wanted.test, choose);
    /** @type {(x: number, y: number, settled: boolean) => void} */
    const drag = (x, _, settled) => this.dragged(x, settled);
    this.chart = new Chart("muscle-curves", { tools: this.tab.list, drag });
    this.points = new Points(store, () => {
      this.keys.family = "";
      this.ask();
      this.draw();
    });
    store.on("answer", (pumped) => {
      if (store.wanted.test === "along") this.draw();
      else this.mark();
      if (!pumped) this.soon();
    });
    store.on("problem", () => this.mark());
    store.on("facts", () => this.soon());
    onTheme(() => this.draw());
    atEnd(() => clearTimeout(this.timer));
  }

  /** The mark is dragged along its curve. @param {number} x @param {boolean} settled */
  dragged(x, settled) {
    const { test } = this.store.wanted,
      pressure = Math.round((x / outside("pressure", 1)) * 1000) / 1000;
    if (test === "isobaric")
      this.store.changed("e", Math.max(0, Math.round(x * 10) / 1000), settled);
    if (test === "isometric" || test === "isotonic")
      this.store.changed("p", Math.max(0, pressure), settled);
  }

  /** Curves at rest; while the hand moves they take at most an eighth of the time: the muscle comes first. */
  soon() {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(
      () => this.ask(),
      performance.now() > this.due ? 0 : 100,
    );
  }

  ask() {
    const { store } = this,
      { test } = store.wanted,
      turn = ++this.turn,
      began = performance.now();
    if (test === "along") return this.draw();
    const { request, top } = familyOf(store, this.points.pressures());
    const mine = {
      ...ownOf(store, top),
      ...(friction() ? { both: true } : {}),
    };
    this.due = Infinity;
    const done = () => {
      this.draw();
      if (turn !== this.turn) return;
      const now = performance.now();
      this.due = now + 7 * (now - began);
      this.askOver();
      this.points.ask();
    };
    const own = () =>
      this.once(
        "own",
        mine,
        (answer) => {
          this.own = answer && { test, answer };
        },
        done,
      );
    // Along a family only the mark and the own curve move. Both are drawn at once.
    this.once(
      "family",
      request,
      (answer) => {
        if (answer) this.family = { test, answer, top };
      },
      () => (turn === this.turn ? own() : this.draw()),
    );
  }

  /**
   * Asks what was not asked yet.
   * @param {"family" | "own"} what @param {object} request @param {(answer?: CurveAnswer) => void} take
   * @param {() => void} next
   */
  once(what, request, take, next) {
    const test = /** @type {"isobaric" | "isometric" | "isotonic"} */ (
      this.store.wanted.test
    );
    const asked = { test, muscle: muscle.fields(), ...request },
      key = JSON.stringify(asked);
    if (key === this.keys[what]) return next();
    this.keys[what] = key;
    this.slots[what].ask(
      "curve",
      asked,
      (answer) => {
        take(answer);
        next();
      },
      () => {
        this.keys[what] = "";
        take();
        next();
      },
    );
  }

  askOver() {
    const { test, over } = this.store.wanted;
    const asked = {
      test: /** @type {const} */ ("isobaric"),
      muscle: muscle.fields(),
      model: { name: test === "isobaric" ? over : "" },
      extrapolate: true,
      pressures_mpa: [muscle.p],
      contractions: reachOf(this.store, FAMILY),
    };
    const key = JSON.stringify(asked);
    if (key === this.keys.over) return;
    this.keys.over = key;
    const take = (/** @type {CurveAnswer[]} */ ...answers) => {
      this.overlays = answers;
      this.draw();
    };
    if (!asked.model.name) return take();
    this.slots.over.ask("curve", asked, take, () => take());
  }

  draw() {
    const { store, family, chart, points } = this,
      { test } = store.wanted;
    this.advanced.hidden = points.element.hidden = test !== "isobaric";
    if (test === "along") {
      if (store.shape) chart.show(along(store.shape));
      return chart.mark();
    }
    if (family?.test !== test) return;
    const mine = this.own?.test === test ? this.own.answer : undefined,
      { top } = family;
    const series = [
      ...familySeries(family.answer, test, top, mine, allowedOf(store)),
      ...(mine ? ownSeries(mine, test, top) : []),
    ];
    if (test === "isobaric") {
      series.unshift(...permitted(family.answer, store));
      series.push(
        ...this.overlays.map(overlay),
        ...pointSeries(points.list, top),
      );
    }
    const [pressure, force] = [
      `pressure p [${unitName("pressure")}]`,
      forceAxis(),
    ];
    chart.show({
      x: test === "isobaric" ? ratioAxis : pressure,
      y: test === "isotonic" ? ratioAxis : force,
      series,
      marks: test === "isobaric" ? required() : [],
      exact: (s, x, take) => this.exact(s, x, take),
    });
    this.mark();
  }

  /**
   * A curve by finite elements where the pointer rests.
   * @param {Series} s @param {number} x @param {(found: number[]) => void} take
   */
  exact({ fixed, low }, x, take) {
    const { test } = this.store.wanted,
      of = muscle.fields(),
      { exact } = this.slots;
    if (fixed === undefined) return;
    const pressure = x / outside("pressure", 1);
    if (test === "isotonic")
      return exact.ask(
        "contraction",
        { muscle: of, force_n: fixed, pressure_mpa: pressure },
        (a) => take(low ? builtContraction(a) : [100 * a.contraction]),
      );
    const at =
      test === "isobaric"
        ? { pressure_mpa: fixed, contraction: x / 100 }
        : { pressure_mpa: pressure, contraction: fixed };
    exact.ask("force", { muscle: of, ...at }, (a) =>
      take(low ? builtAt(a) : [outside("force", a.force_n)]),
    );
  }

  mark() {
    const {
      store: {
        point,
        wanted: { test },
      },
      chart,
    } = this;
    if (!point || test === "along") return chart.mark();
    const [pull, pressure] = [
      outside("force", point.force_n),
      outside("pressure", point.pressure_mpa),
    ];
    const contraction = 100 * point.contraction;
    if (test === "isobaric") chart.mark(contraction, pull);
    else chart.mark(pressure, test === "isotonic" ? contraction : pull);
  }

  /** What the address says. */
  load() {
    const { test, over } = this.store.wanted;
    this.tab.set(test);
    this.over.set(over);
  }
}

/** The points that the muscle's file says that it must reach. */
const required = () =>
  [
    ...muscle.state.file.matchAll(
      /force = "([\d.]+) N", contraction = ([\d.]+)/g,
    ),
  ].map(([, force, contraction]) => ({
    x: 100 * Number(contraction),
    y: outside("force", Number(force)),
    text: "required",
  }));
/** Whether the muscle states its friction: its loop is known then. */
const friction = () => typeof muscle.shown?.friction_coefficient === "number";
