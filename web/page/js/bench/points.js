// Measured points over the isobars, with their residuals against the muscle as it is now.
import { Slot } from "../ask.js";
import { pressureColour } from "../chart.js";
import { block, button, el, problemBox } from "../dom.js";
import { job } from "../form.js";
import { muscle } from "../muscle.js";
import { evenly, outside, showForce, showPressure } from "../units.js";
import { MOVES } from "./family.js";
import { measured } from "../kept.js";
import { signal, untracked, watch } from "../watch.js";

/** Isobars of more pressures than these would cover each other. */
const MOST = 7;

/** @param {Store} store */
export function pointsView(store) {
  const slots = { read: new Slot(), compare: new Slot() },
    list = signal(/** @type {import("../kept.js").Point[]} */ ([]));
  let key = "";
  const words = el("span"),
    said = block();
  /** The question of an identification. @param {TextFile} table */
  const request = (table) => ({ muscle: muscle.fields(), data: [table], free: ["modulus"] });
  // The shear modulus that fits them best becomes the muscle's.
  const fit = job(
    "Fit the rubber",
    "identify",
    async () => measured.file && request(measured.file),
    async ({ muscle_file: file }) => {
      await muscle.take(file);
      store.ask();
      store.follow();
    },
  );
  const remove = button("Remove the points", () => measured.set(undefined));
  const line = el("div", { class: "row small", hidden: true }, words, fit.element, remove);
  const fail = (/** @type {Problem} */ problem) => said.replaceChildren(problemBox(problem));

  /** The points themselves, once for a table. @param {TextFile | undefined} of */
  function read(of) {
    key = "";
    said.replaceChildren();
    line.hidden = !of;
    list.value = [];
    if (of)
      slots.read.ask(
        "identify",
        request(of),
        ({ points }) => (list.value = points.filter((q) => q.measured === "force")),
        fail,
      );
  }
  watch(() => {
    const of = measured.file;
    untracked(() => read(of));
  });
  return {
    element: block("points", line, said),
    /** As series. @param {number} top the pressure that has the last colour */
    series: (top) => pointSeries(list.value, top),

    /** How far the muscle is from them now. */
    ask() {
      const data = measured.file;
      if (!data) return;
      const asked = { muscle: muscle.fields(), data: [data], models: ["fe"], extrapolate: true };
      const next = JSON.stringify(asked);
      if (next === key) return;
      key = next;
      slots.compare.ask(
        "compare",
        asked,
        ({ models: [m], points: count }) => {
          if (!m || m.rms_n == null) return;
          const residuals = `${showForce(m.rms_n, 3)} rms, ${showForce(m.max_n, 3)} the largest`;
          words.textContent = `${data.name}: ${count} points. Residuals: ${residuals}.`;
        },
        (problem) => {
          key = "";
          fail(problem);
        },
      );
    },

    /** Pressures of the isobars to draw: some of them, where the points have too many. */
    pressures() {
      const all = [...new Set(list.value.map((q) => q.pressure_mpa))]
        .sort((a, b) => a - b)
        .filter((p) => p > 0);
      if (all.length <= MOST) return all;
      return evenly(0, all.length - 1, MOST).map((i) => all[Math.round(i)]);
    },
  };
}

/**
 * Measured points as series: a colour for each pressure, a sign for each branch.
 * @param {import("../kept.js").Point[]} list
 * @param {number} top the pressure that has the last colour @returns {Series[]}
 */
export function pointSeries(list, top) {
  const kinds = [...new Set(list.map((q) => q.branch ?? "mean"))];
  return [...new Set(list.map((q) => q.pressure_mpa))].flatMap((p, first) =>
    kinds.map((glyph) => {
      const at = list.filter((q) => q.pressure_mpa === p && (q.branch ?? "mean") === glyph);
      const way = MOVES[glyph] ?? "";
      return {
        name: `measured at ${showPressure(p, 3)}${way}`,
        legend: first ? "" : `measured${way}`,
        mode: "markers",
        glyph,
        colour: pressureColour(p, top),
        x: at.map((q) => 100 * q.contraction),
        y: at.map((q) => outside("force", q.force_n)),
      };
    }),
  );
}
