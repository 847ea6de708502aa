// Curves of the page Muscle: a family, the curve of the present state and as built, other models,
// measured points, and one measure over a range.
import { Slot } from "../ask.js";
import { chartOf } from "../chart.js";
import { tabs } from "../dom.js";
import { muscle } from "../muscle.js";
import { forceAxis, outside, ratioAxis, unitName } from "../units.js";
import { rested, signal, untracked, watch } from "../watch.js";
import { allowedOf, along, familyOf, familySeries, ownOf, ownSeries, permitted } from "./family.js";
import { pointsView } from "./points.js";
import { sweepView } from "./sweep.js";

/** @type {[string, string][]} */ const TESTS = [
  ["isobaric", "Isobaric"],
  ["isometric", "Isometric"],
  ["isotonic", "Isotonic"],
  ["along", "Along the muscle"],
  ["sweep", "Sweep"],
];
/** @typedef {{ test: string, top: number, family: CurveAnswer, own?: CurveAnswer }} Curves */

/** @param {Store} store @param {() => Series[]} beside curves that lie over the isobars */
export function curvesView(store, beside) {
  const slot = () => new Slot({ lane: "curves" }),
    slots = { family: slot(), own: slot() };
  /** @type {Signal<Curves | undefined>} */ const curves = signal();
  /** Questions, and when the hand that moves gets curves again. */
  let turn = 0,
    due = 0;
  const tab = tabs("Curves", TESTS, "isobaric", (test) => store.look({ test }));
  const chart = chartOf("muscle-curves", {
    tools: tab.list,
    drag: (x, _, settled) => dragged(x, settled),
  });
  const points = pointsView(store),
    sweep = sweepView(store, chart);

  /** The mark is dragged along its curve. @param {number} x @param {boolean} settled */
  function dragged(x, settled) {
    const { test } = store.wanted.value,
      pressure = Math.round((x / outside("pressure", 1)) * 1000) / 1000;
    if (test === "isobaric") store.changed("e", Math.max(0, Math.round(x * 10) / 1000), settled);
    if (test === "isometric" || test === "isotonic")
      store.changed("p", Math.max(0, pressure), settled);
  }

  function ask() {
    const { test } = store.wanted.value,
      mine = ++turn,
      began = performance.now();
    if (test === "along" || test === "sweep") return;
    const { request, top } = familyOf(store, points.pressures()),
      of = { test: /** @type {"isobaric"} */ (test), muscle: muscle.fields() };
    due = Infinity;
    const both = typeof muscle.shown?.friction_coefficient === "number" || undefined,
      through = { ...of, ...ownOf(store, top), both };
    // Both are drawn at once.
    slots.family.ask("curve", { ...of, ...request }, (family) => {
      const done = (/** @type {CurveAnswer | undefined} */ own) => {
        curves.value = { test, top, family, own };
        if (mine !== turn) return;
        const now = performance.now();
        due = now + 7 * (now - began);
      };
      if (mine !== turn) return done(curves.peek()?.own);
      slots.own.ask("curve", through, done, () => done(undefined));
    });
  }

  const soon = rested(ask, 100);
  /** Curves at rest; while the hand moves they take at most an eighth of the time. */
  watch(() => {
    void [store.facts.value, store.wanted.value, points.pressures()];
    // The muscle comes first.
    if (store.point.value || store.problem.value) soon(performance.now() > due ? 0 : undefined);
  });

  watch(() => {
    const { test } = store.wanted.value;
    tab.set(test);
    points.element.hidden = test !== "isobaric";
    sweep.element.hidden = test !== "sweep";
  });

  watch(() => {
    const { test } = store.wanted.value;
    if (test === "along") {
      if (store.shape.value) chart.show(along(store.shape.value));
      return;
    }
    if (curves.value?.test !== test) return;
    const { family, own, top } = curves.value,
      allowed = allowedOf(store);
    const series = [
      ...familySeries(family, test, top, own, allowed),
      ...(own ? ownSeries(own, test, top) : []),
    ];
    if (test === "isobaric") {
      series.unshift(...permitted(family, allowed, store.facts.value.fitted_to_stretch));
      series.push(...beside(), ...points.series(top));
    }
    chart.show({
      x: test === "isobaric" ? ratioAxis : `pressure p [${unitName("pressure")}]`,
      y: test === "isotonic" ? ratioAxis : forceAxis(),
      series,
      marks: test === "isobaric" ? untracked(required) : [],
    });
  });

  watch(() => {
    const point = store.point.value,
      { test } = store.wanted.value;
    if (!point || test === "along" || test === "sweep") return chart.mark();
    const pull = outside("force", point.force_n),
      contraction = 100 * point.contraction;
    if (test === "isobaric") chart.mark(contraction, pull);
    else
      chart.mark(outside("pressure", point.pressure_mpa), test === "isotonic" ? contraction : pull);
  });
  return [chart.element, sweep.element, points.element];
}

/** The points that the muscle's file says that it must reach. */
const required = () =>
  [...muscle.state.file.matchAll(/force = "([\d.]+) N", contraction = ([\d.]+)/g)].map(
    ([, force, contraction]) => ({
      x: 100 * Number(contraction),
      y: outside("force", Number(force)),
      text: "asked",
    }),
  );
