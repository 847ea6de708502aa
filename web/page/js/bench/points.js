// Measured points over the isobars, with their residuals against the muscle as it is now.
import { Slot } from "../ask.js";
import { pressureColour } from "../chart.js";
import { block, button, el, problemBox } from "../dom.js";
import { job } from "../form.js";
import { measured, onMeasured } from "../measured.js";
import { muscle } from "../muscle.js";
import { evenly, outside, showForce, showPressure } from "../units.js";
import { MOVES } from "./family.js";

/** Isobars of more pressures than these would cover each other. */
const MOST = 7;

export class Points {
  /** @param {Store} store @param {() => void} changed */
  constructor(store, changed) {
    this.store = store;
    this.changed = changed;
    this.slots = { read: new Slot(), compare: new Slot() };
    /** @type {import("../measured.js").Point[]} */ this.list = [];
    this.key = "";
    this.words = el("span");
    this.said = block();
    // The shear modulus that fits them best becomes the muscle's.
    const fit = job(
      "Fit the rubber",
      "identify",
      async () => measured.file && this.request(measured.file),
      async ({ muscle_file: file }) => {
        await muscle.take(file);
        store.tell("sync");
        store.ask();
        store.follow();
        store.settle();
      },
    );
    const remove = button("Remove the points", () => measured.set(undefined));
    this.line = el(
      "div",
      { class: "row small", hidden: true },
      this.words,
      fit.element,
      remove,
    );
    this.element = block("points", this.line, this.said);
    onMeasured(() => this.read());
  }

  /** The question of an identification. @param {{ name: string, text: string }} table */
  request(table) {
    return {
      muscle: muscle.fields(),
      data: [table],
      free: ["modulus"],
    };
  }

  /** The points themselves, once for a table. */
  read() {
    const of = measured.file;
    this.key = "";
    this.said.replaceChildren();
    this.line.hidden = !of;
    const take = (/** @type {import("../measured.js").Point[]} */ list) => {
      this.list = list;
      this.changed();
    };
    if (!of) return take([]);
    this.slots.read.ask(
      "identify",
      this.request(of),
      ({ points }) => {
        take(points.filter((q) => q.measured === "force"));
      },
      (problem) => {
        this.said.replaceChildren(problemBox(problem));
        take([]);
      },
    );
  }

  /** How far the muscle is from them now. */
  ask() {
    const data = measured.file;
    if (!data) return;
    const request = {
      muscle: muscle.fields(),
      data: [data],
      models: ["fe"],
      extrapolate: true,
    };
    const next = JSON.stringify(request);
    if (next === this.key) return;
    this.key = next;
    this.slots.compare.ask(
      "compare",
      request,
      ({ models: [m], points: count }) => {
        if (!m || m.rms_n == null) return;
        const residuals = `${showForce(m.rms_n, 3)} rms, ${showForce(m.max_n, 3)} the largest`;
        this.words.textContent = `${data.name}: ${count} points. Residuals: ${residuals}.`;
      },
      (problem) => {
        this.key = "";
        this.said.replaceChildren(problemBox(problem));
      },
    );
  }

  /** Pressures of the isobars to draw: some of them, where the points have too many. */
  pressures() {
    const all = [...new Set(this.list.map((q) => q.pressure_mpa))]
      .sort((a, b) => a - b)
      .filter((p) => p > 0);
    if (all.length <= MOST) return all;
    return evenly(0, all.length - 1, MOST).map((i) => all[Math.round(i)]);
  }
}

/**
 * Measured points as series: a colour for each pressure, a sign for each branch.
 * @param {import("../measured.js").Point[]} list @param {number} top the pressure that has the last colour @returns {Series[]}
 */
export function pointSeries(list, top) {
  const kinds = [...new Set(list.map((q) => q.branch ?? "mean"))];
  return [...new Set(list.map((q) => q.pressure_mpa))].flatMap((p, first) =>
    kinds.map((glyph) => {
      const at = list.filter(
        (q) => q.pressure_mpa === p && (q.branch ?? "mean") === glyph,
      );
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
