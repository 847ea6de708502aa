// Curves of the page Muscle: a family, the curve of the present state and as built, other models,
// and measured points.
import { Slot } from "../ask.js";
import { chartOf, builtAt } from "../chart.js";
import { choice } from "../controls.js";
import { folded, tabs } from "../dom.js";
import { atEnd } from "../life.js";
import { muscle } from "../muscle.js";
import { onTheme } from "../theme.js";
import { forceAxis, outside, ratioAxis, unitName } from "../units.js";
import {
  FAMILY,
  OVERLAYS,
  allowedOf,
  along,
  builtContraction,
  familyOf,
  familySeries,
  overlay,
  ownOf,
  ownSeries,
  permitted,
  reachOf,
} from "./family.js";
import { pointsView } from "./points.js";

const TESTS = /** @type {[string, string][]} */ ([
  ["isobaric", "Isobaric"],
  ["isometric", "Isometric"],
  ["isotonic", "Isotonic"],
  ["along", "Along the muscle"],
]);

/** @param {Store} store */
export function curvesView(store) {
  const slot = () => new Slot({ lane: "curves" }),
    slots = { family: slot(), own: slot(), over: slot(), exact: slot() };
  /** @type {{ test: string, answer: CurveAnswer, top: number } | undefined} */ let family;
  /** @type {{ test: string, answer: CurveAnswer } | undefined} */ let own;
  /** @type {CurveAnswer[]} */ let overlays = [];
  /** What was asked last. */
  const keys = { family: "", own: "", over: "" };
  let timer = 0,
    // Questions, and when the hand that moves gets curves again.
    turn = 0,
    due = 0;
  const over = choice(
    "Another model",
    ["", ...OVERLAYS].map((name) => [name, name || "none"]),
    store.wanted.over,
    (name) => {
      store.wanted.over = name;
      ask();
      store.settle();
    },
  );
  const advanced = folded("Advanced", over.element);
  const tab = tabs("Curves", TESTS, store.wanted.test, (test) => {
    store.look({ test });
    draw();
    ask();
  });
  const chart = chartOf("muscle-curves", {
    tools: tab.list,
    drag: (x, _, settled) => dragged(x, settled),
  });
  const points = pointsView(store, () => {
    keys.family = "";
    ask();
    draw();
  });
  store.on("answer", (pumped) => {
    if (store.wanted.test === "along") draw();
    else mark();
    if (!pumped) soon();
  });
  store.on("problem", mark);
  store.on("facts", soon);
  onTheme(draw);
  atEnd(() => clearTimeout(timer));

  /** The mark is dragged along its curve. @param {number} x @param {boolean} settled */
  function dragged(x, settled) {
    const { test } = store.wanted,
      pressure = Math.round((x / outside("pressure", 1)) * 1000) / 1000;
    if (test === "isobaric") store.changed("e", Math.max(0, Math.round(x * 10) / 1000), settled);
    if (test === "isometric" || test === "isotonic")
      store.changed("p", Math.max(0, pressure), settled);
  }

  /**
   * Curves at rest; while the hand moves they take at most an eighth of the time: the muscle comes
   * first.
   */
  function soon() {
    clearTimeout(timer);
    timer = window.setTimeout(ask, performance.now() > due ? 0 : 100);
  }

  function ask() {
    const { test } = store.wanted,
      mine = ++turn,
      began = performance.now();
    if (test === "along") return draw();
    const { request, top } = familyOf(store, points.pressures());
    due = Infinity;
    const done = () => {
      draw();
      if (mine !== turn) return;
      const now = performance.now();
      due = now + 7 * (now - began);
      askOver();
      points.ask();
    };
    const askOwn = () =>
      once(
        "own",
        { ...ownOf(store, top), ...(friction() ? { both: true } : {}) },
        (answer) => {
          own = answer && { test, answer };
        },
        done,
      );
    // Along a family only the mark and the own curve move. Both are drawn at once.
    once(
      "family",
      request,
      (answer) => {
        if (answer) family = { test, answer, top };
      },
      () => (mine === turn ? askOwn() : draw()),
    );
  }

  /**
   * Asks what was not asked yet.
   * @param {"family" | "own"} what @param {object} request
   * @param {(answer?: CurveAnswer) => void} take
   * @param {() => void} next
   */
  function once(what, request, take, next) {
    const test = /** @type {"isobaric" | "isometric" | "isotonic"} */ (store.wanted.test);
    const asked = { test, muscle: muscle.fields(), ...request },
      key = JSON.stringify(asked);
    if (key === keys[what]) return next();
    keys[what] = key;
    slots[what].ask(
      "curve",
      asked,
      (answer) => {
        take(answer);
        next();
      },
      () => {
        keys[what] = "";
        take();
        next();
      },
    );
  }

  function askOver() {
    const { test, over: name } = store.wanted;
    const asked = {
      test: /** @type {const} */ ("isobaric"),
      muscle: muscle.fields(),
      model: { name: test === "isobaric" ? name : "" },
      extrapolate: true,
      pressures_mpa: [muscle.p],
      contractions: reachOf(store, FAMILY),
    };
    const key = JSON.stringify(asked);
    if (key === keys.over) return;
    keys.over = key;
    const take = (/** @type {CurveAnswer[]} */ ...answers) => {
      overlays = answers;
      draw();
    };
    if (!asked.model.name) return take();
    slots.over.ask("curve", asked, take, () => take());
  }

  function draw() {
    const { test } = store.wanted;
    advanced.hidden = points.element.hidden = test !== "isobaric";
    if (test === "along") {
      if (store.shape) chart.show(along(store.shape));
      return chart.mark();
    }
    if (family?.test !== test) return;
    const mine = own?.test === test ? own.answer : undefined,
      { top, answer } = family;
    const series = [
      ...familySeries(answer, test, top, mine, allowedOf(store)),
      ...(mine ? ownSeries(mine, test, top) : []),
    ];
    if (test === "isobaric") {
      series.unshift(...permitted(answer, allowedOf(store), store.facts.fitted_to_stretch));
      series.push(...overlays.map(overlay), ...points.series(top));
    }
    const pressure = `pressure p [${unitName("pressure")}]`;
    chart.show({
      x: test === "isobaric" ? ratioAxis : pressure,
      y: test === "isotonic" ? ratioAxis : forceAxis(),
      series,
      marks: test === "isobaric" ? required() : [],
      exact,
    });
    mark();
  }

  /**
   * A curve by finite elements where the pointer rests.
   * @param {Series} s @param {number} x @param {(found: number[]) => void} take
   */
  function exact({ fixed, low }, x, take) {
    const { test } = store.wanted,
      of = muscle.fields();
    if (fixed === undefined) return;
    const pressure = x / outside("pressure", 1);
    if (test === "isotonic")
      return slots.exact.ask(
        "contraction",
        { muscle: of, force_n: fixed, pressure_mpa: pressure },
        (a) => take(low ? builtContraction(a) : [100 * a.contraction]),
      );
    const at =
      test === "isobaric"
        ? { pressure_mpa: fixed, contraction: x / 100 }
        : { pressure_mpa: pressure, contraction: fixed };
    slots.exact.ask("force", { muscle: of, ...at }, (a) =>
      take(low ? builtAt(a) : [outside("force", a.force_n)]),
    );
  }

  function mark() {
    const {
      point,
      wanted: { test },
    } = store;
    if (!point || test === "along") return chart.mark();
    const pull = outside("force", point.force_n),
      contraction = 100 * point.contraction;
    if (test === "isobaric") chart.mark(contraction, pull);
    else
      chart.mark(outside("pressure", point.pressure_mpa), test === "isotonic" ? contraction : pull);
  }
  return {
    element: chart.element,
    points,
    advanced,
    draw,
    /** What the address says. */
    load() {
      tab.set(store.wanted.test);
      over.set(store.wanted.over);
    },
  };
}

/** The points that the muscle's file says that it must reach. */
const required = () =>
  [...muscle.state.file.matchAll(/force = "([\d.]+) N", contraction = ([\d.]+)/g)].map(
    ([, force, contraction]) => ({
      x: 100 * Number(contraction),
      y: outside("force", Number(force)),
      text: "required",
    }),
  );
/** Whether the muscle states its friction: its loop is known then. */
const friction = () => typeof muscle.shown?.friction_coefficient === "number";
