// Measured points over the isobars, with their residuals against the muscle as it is now.
import { Slot, engine } from "../ask.js";
import { pressureColour } from "../chart.js";
import { el, problemBox } from "../dom.js";
import { measured, onMeasured } from "../measured.js";
import { muscle } from "../muscle.js";
import { outside, show } from "../units.js";

/** @typedef {import("./store.js").Store} Store */
/** Isobars of more pressures than these would cover each other. */
const MOST = 7;

/** @param {Store} store @param {() => void} changed */
export function pointsView(store, changed) {
  const slot = new Slot(), reading = new Slot();
  /** @type {import("../measured.js").Point[]} */ let points = [];
  let key = "";
  const words = el("span", {}), said = el("div", {});
  const fit = el("button", { type: "button", onclick: identify }, "Fit the rubber");
  const remove = el("button", { type: "button", onclick: () => measured.set(undefined) }, "Remove the points");
  const inner = el("div", { class: "row small", hidden: true }, words, fit, remove);
  const element = el("div", { class: "points" }, inner, said);
  const table = () => (measured.file ? { data: measured.file, columns: measured.columns } : undefined);

  /** The points themselves, once for a table. */
  function read() {
    const of = measured.file;
    key = "";
    said.replaceChildren();
    inner.hidden = !of;
    if (!of) { points = []; return changed(); }
    reading.ask("identify", { ...muscle.fields(), data: [of], columns: measured.columns, free: ["modulus"] }, (answer) => {
      points = answer.points.filter((q) => q.measured === "force");
      changed();
    }, (problem) => { points = []; said.replaceChildren(problemBox(problem)); changed(); });
  }

  /** How far the muscle is from them now. */
  function ask() {
    const of = table();
    if (!of) return;
    const request = { ...muscle.fields(), ...of, models: ["fe"], extrapolate: true }, next = JSON.stringify(request);
    if (next === key) return;
    key = next;
    slot.ask("compare", request, ({ models: [m], points: count }) => {
      if (!m || m.rms_n === null || m.rms_n === undefined) return;
      words.textContent = `${of.data.name}: ${count} points. Residuals: ${show("force", m.rms_n, 3)} rms, ${show("force", m.max_n, 3)} the largest.`;
    }, (problem) => { key = ""; said.replaceChildren(problemBox(problem)); });
  }

  /** The shear modulus that fits them best becomes the muscle's. */
  async function identify() {
    if (!measured.file) return;
    fit.disabled = true;
    said.replaceChildren();
    try {
      const answer = await engine().ask("identify", { ...muscle.fields(), data: [measured.file], columns: measured.columns, free: ["modulus"] });
      await muscle.take(answer.muscle_file);
      store.tell("sync");
      store.ask();
      store.follow();
      store.settle();
    } catch (problem) {
      said.replaceChildren(problemBox(problem));
    }
    fit.disabled = false;
  }

  const off = onMeasured(read);
  return {
    element, ask,
    load: read,
    /** Those of the isobars to draw: none where the points have too many. */
    pressures() {
      const all = [...new Set(points.map((q) => q.pressure_mpa))].sort((a, b) => a - b).filter((p) => p > 0);
      return all.length > MOST ? Array.from({ length: MOST }, (_, i) => all[Math.round((i * (all.length - 1)) / (MOST - 1))]) : all;
    },
    /** @param {number} top the pressure that has the last colour @returns {import("../chart.js").Series[]} */
    series(top) {
      return [...new Set(points.map((q) => q.pressure_mpa))].map((p) => {
        const at = points.filter((q) => q.pressure_mpa === p);
        return { name: `measured at ${show("pressure", p, 3)}`, mode: "markers", colour: pressureColour(p, top), x: at.map((q) => 100 * q.contraction), y: at.map((q) => outside("force", q.force_n)) };
      });
    },
    end() { off(); slot.end(); reading.end(); },
  };
}
