// Measured points over the isobars, with their residuals against the muscle as it is now.
import { Slot } from "../ask.js";
import { shade } from "../chart.js";
import { block, button, el, problemBox } from "../dom.js";
import { muscle } from "../muscle.js";
import { evenly, outside, showForce, showPressure } from "../units.js";
import { MOVES } from "./family.js";
import { measured } from "../kept.js";
import { rested, signal, watch } from "../watch.js";

/** Isobars of more pressures than these would cover each other. */
const MOST = 7;

/** After a change it waits so long, in milliseconds. */
const REST = 250;

/** @param {Store} store */
export function pointsView(store) {
  const slot = new Slot(),
    /** @type {Signal<Commands["identify"]["answer"] | undefined>} */ found = signal();
  const words = el("span"),
    said = block();
  // The shear modulus that fits them best becomes the muscle's.
  const fit = button("Fit the rubber", async () => {
    await muscle.take(found.value?.muscle_file ?? "");
    store.ask();
    store.follow();
  });
  const remove = button("Remove the points", () => measured.set(undefined));
  const line = el("div", { class: "row small", hidden: true }, words, fit, remove);
  const list = () => found.value?.points.filter((q) => q.measured === "force") ?? [];

  const soon = rested(() => {
    const of = measured.file;
    if (of)
      slot.ask(
        "identify",
        { muscle: muscle.fields(), data: [of], free: ["modulus"] },
        (answer) => (found.value = answer),
        (problem) => said.replaceChildren(problemBox(problem)),
      );
  }, REST);
  watch(() => {
    const of = measured.file,
      { said: over, file } = muscle.state;
    void [over, file];
    soon();
    said.replaceChildren();
    line.hidden = !of;
    if (!of) found.value = undefined;
  });
  watch(() => {
    const answer = found.value;
    if (answer)
      words.textContent =
        `${measured.file?.name}: ${list().length} points. Residuals: ${showForce(answer.rms_before_n, 3)} ` +
        `rms; ${showForce(answer.rms_n, 3)} with the rubber that fits best.`;
  });
  return {
    element: block("points", line, said),
    /** As series. @param {number} top the pressure that has the last colour */
    series: (top) => pointSeries(list(), top),
    /** Pressures of the isobars to draw: some of them, where the points have too many. */
    pressures() {
      const all = [...new Set(list().map((q) => q.pressure_mpa))]
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
        colour: shade(p / top),
        x: at.map((q) => 100 * q.contraction),
        y: at.map((q) => outside("force", q.force_n)),
      };
    }),
  );
}
