// Curves of the page Muscle: a family, the curve of the present state with its ±, other models, and measured points.
import { Slot } from "../ask.js";
import { Chart, KINDS, isDark, isobar, pressureColour, viridis } from "../chart.js";
import { el, tabs } from "../dom.js";
import { muscle } from "../muscle.js";
import { inside, outside, show, unitName } from "../units.js";
import { along } from "./along.js";
import { pointsView } from "./points.js";
import { niceUp, twoDigits } from "./round.js";

/** @typedef {import("./store.js").Store} Store */
/** @typedef {import("../../../types/commands").Commands["curve"]["answer"]} Answer */
/** @typedef {Answer["points"][number] & Record<string, any>} Point */
const TESTS = /** @type {[string, string][]} */ ([["isobaric", "Isobaric"], ["isometric", "Isometric"], ["isotonic", "Isotonic"], ["along", "Along the muscle"]]);
const OVERLAYS = ["universal", "thick-wall", "ideal", "paper"];
/** Points of a curve. */
const FAMILY = 13, FINE = 21;
const steps = (/** @type {number} */ count, /** @type {number} */ end) => Array.from({ length: count }, (_, i) => (i * end) / (count - 1));

/** @param {Store} store */
export function curvesView(store) {
  const slots = { family: new Slot({ lane: "curves" }), own: new Slot({ lane: "curves" }), over: new Slot({ lane: "curves" }) };
  /** @type {{ test: string, answer: Answer, top: number } | undefined} */ let family;
  /** @type {{ test: string, answer: Answer } | undefined} */ let own;
  /** @type {Answer[]} */ let overlays = [];
  const keys = { family: "", own: "", over: "" };
  let timer = 0;
  const over = overlayChoice(store, () => { ask(); store.settle(); });
  const tab = tabs("Curves", TESTS, store.wanted.test, (name) => { store.look({ test: name }); draw(); ask(); });
  const chart = new Chart("muscle-curves", { tools: tab.list, drag(x, _, settled) {
    const { test } = store.wanted, pressure = Math.round((x / outside("pressure", 1)) * 1000) / 1000;
    if (test === "isobaric") store.changed("e", Math.max(0, Math.round(x * 10) / 1000), settled);
    if (test === "isometric" || test === "isotonic") store.changed("p", Math.max(0, pressure), settled);
  } });
  const points = pointsView(store, () => { keys.family = ""; ask(); draw(); });

  /** Curves, at most ten times a second, and where drawing them takes most of a frame once the hand rests: the muscle comes first. */
  function soon() {
    if (chart.cost > 8) clearTimeout(timer);
    else if (timer) return;
    timer = window.setTimeout(() => { timer = 0; ask(); }, 100);
  }

  function ask() {
    const { test } = store.wanted;
    if (test === "along") return draw();
    const { request, top } = familyOf(store, points.pressures()), fields = muscle.fields();
    // Along a family only the mark and the own curve move.
    once("family", JSON.stringify([test, fields, request]), request, (answer) => { family = { test, answer, top }; });
    const mine = { ...ownOf(store, top), ...(friction() ? { both: true } : {}) };
    once("own", JSON.stringify([test, fields, mine]), mine, (answer) => { own = { test, answer }; });
    askOver(fields);
    points.ask();
  }

  /** Asks what was not asked yet. @param {"family" | "own"} what @param {string} key @param {object} request @param {(answer: Answer) => void} take */
  function once(what, key, request, take) {
    if (key === keys[what]) return;
    keys[what] = key;
    const test = /** @type {"isobaric" | "isometric" | "isotonic"} */ (store.wanted.test);
    const fail = () => { keys[what] = ""; if (what === "own") { own = undefined; draw(); } };
    slots[what].ask("curve", { test, ...muscle.fields(), ...request }, (answer) => { take(answer); draw(); }, fail);
  }

  /** @param {Record<string, unknown>} fields */
  function askOver(fields) {
    const names = store.wanted.over.split(",").filter(Boolean), contractions = reachOf(store, FAMILY);
    const key = JSON.stringify([store.wanted.test, names, fields, muscle.p, contractions]);
    if (key === keys.over) return;
    keys.over = key;
    if (!names.length || store.wanted.test !== "isobaric") { overlays = []; return draw(); }
    const found = /** @type {Answer[]} */ ([]);
    const next = (/** @type {string[]} */ [model, ...rest]) => {
      if (keys.over !== key) return;
      if (!model) { overlays = found; return draw(); }
      const request = { test: /** @type {const} */ ("isobaric"), ...fields, model, extrapolate: true, pressures_mpa: [muscle.p], contractions };
      slots.over.ask("curve", request, (answer) => { found.push(answer); next(rest); }, () => next(rest));
    };
    next(names);
  }

  function draw() {
    const { test } = store.wanted;
    over.element.hidden = points.element.hidden = test !== "isobaric";
    if (test === "along") { if (store.shape) chart.show(along(store.shape)); return chart.mark(); }
    if (family?.test !== test) return;
    const mine = own?.test === test ? own.answer : undefined, { top } = family;
    const series = [...familySeries(family.answer, test, top, mine), ...(mine ? ownSeries(mine, test, top) : [])];
    if (test === "isobaric") series.push(...overlays.map(overlay), ...points.series(top));
    const [pressure, force] = [`pressure p [${unitName("pressure")}]`, `pull F [${unitName("force")}]`];
    chart.show({ x: test === "isobaric" ? "contraction ε [%]" : pressure, y: test === "isotonic" ? "contraction ε [%]" : force, series });
    mark();
  }

  function mark() {
    const { point } = store, { test } = store.wanted;
    if (!point || test === "along") return chart.mark();
    const [pull, pressure, contraction] = [outside("force", point.force_n), outside("pressure", point.pressure_mpa), 100 * point.contraction];
    chart.mark(...(test === "isobaric" ? /** @type {const} */ ([contraction, pull]) : /** @type {const} */ ([pressure, test === "isotonic" ? contraction : pull])));
  }

  store.on("answer", (pumped) => {
    if (store.wanted.test === "along") draw();
    else mark();
    if (!pumped) soon();
  });
  store.on("problem", mark);
  store.on("facts", soon);
  const redraw = () => draw();
  document.addEventListener("theme", redraw);
  return {
    chart, over: over.element, points, draw,
    /** What the address says. */
    load() {
      tab.list.querySelectorAll("button").forEach((b) => b.setAttribute("aria-selected", String(b.dataset.name === store.wanted.test)));
      over.set(store.wanted.over.split(","));
    },
    end() {
      clearTimeout(timer);
      document.removeEventListener("theme", redraw);
      Object.values(slots).forEach((slot) => slot.end());
      points.end();
      chart.destroy();
    },
  };
}

/** Whether the muscle states its friction: its loop is known then. */
const friction = () => typeof muscle.shown?.friction_coefficient === "number";

/** @param {Store} store @param {() => void} changed */
function overlayChoice(store, changed) {
  const boxes = OVERLAYS.map((name) => el("input", { type: "checkbox", id: `over-${name}`, onchange: () => {
    store.wanted.over = OVERLAYS.filter((_, i) => boxes[i].checked).join(",");
    changed();
  } }));
  const dash = (/** @type {number} */ i) => el("i", { style: `display:inline-block;width:16px;border-top:2px dashed ${KINDS[i + 1]};vertical-align:middle` });
  const labels = OVERLAYS.map((name, i) => el("label", { for: `over-${name}` }, boxes[i], ` ${name} `, dash(i)));
  return {
    element: el("div", { class: "row small" }, el("span", { class: "soft" }, "Other models at this pressure:"), ...labels),
    /** @param {string[]} names */
    set(names) { OVERLAYS.forEach((name, i) => { boxes[i].checked = names.includes(name); }); },
  };
}

/** Contractions up to a little beyond the free one. @param {Store} store @param {number} count */
function reachOf(store, count) {
  const end = Math.max(0.1, (store.facts.characteristics?.free_contraction ?? 0.28) * 1.08);
  return steps(count, end).map((e) => Math.round(1e4 * e) / 1e4);
}

/** Five pressures up to a round one above the state's, or those of the measured points. @param {Store} store @param {number[]} measured */
function familyOf(store, measured) {
  const { test } = store.wanted;
  const shown = outside("pressure", Math.max(muscle.p, 0.02)), step = niceUp(shown / 5), count = Math.ceil(shown / step - 1e-9);
  let top = inside("pressure", count * step);
  if (test === "isobaric" && measured.length) {
    top = Math.max(top, ...measured);
    return { top, request: { pressures_mpa: measured, contractions: reachOf(store, FAMILY) } };
  }
  const pressures = Array.from({ length: count }, (_, i) => inside("pressure", Number(((i + 1) * step).toPrecision(12))));
  if (test === "isobaric") return { top, request: { pressures_mpa: pressures, contractions: reachOf(store, FAMILY) } };
  const over = steps(FAMILY, top), blocked = store.facts.characteristics?.blocked_force_n ?? 500;
  if (test === "isometric") return { top, request: { contractions: [0, 0.05, 0.1, 0.15, 0.2], pressures_mpa: over } };
  return { top, request: { forces_n: [0.1, 0.3, 0.5, 0.7].map((x) => Math.max(1, twoDigits(x * blocked))), pressures_mpa: over.slice(1) } };
}

/** The curve through the present state. @param {Store} store @param {number} top */
function ownOf(store, top) {
  const { test } = store.wanted;
  if (test === "isobaric") return { pressures_mpa: [muscle.p], contractions: reachOf(store, FINE) };
  const over = steps(FINE, top);
  if (test === "isometric") return { contractions: [muscle.e], pressures_mpa: over };
  return { forces_n: [Math.max(1e-3, store.point?.force_n ?? muscle.F ?? 1)], pressures_mpa: over.slice(1) };
}

/** @param {number} fixed @param {string} test */
const named = (fixed, test) => (test === "isobaric" ? show("pressure", fixed, 3) : test === "isotonic" ? show("force", fixed, 3) : show("ratio", fixed, 3));

/** Points of one curve as a series. @param {Point[]} list @param {string} test */
function line(list, test) {
  if (test === "isobaric") return isobar(list);
  const ok = (/** @type {Point} */ q) => q.status === "ok";
  const x = list.map((q) => outside("pressure", q.pressure_mpa));
  if (test === "isotonic") {
    const half = list.map((q) => (q.contraction_uncertainty ? 100 * q.contraction_uncertainty : null));
    return { x, y: list.map((q) => (ok(q) ? 100 * Number(q.contraction) : null)), half };
  }
  return { x, y: list.map((q) => (ok(q) ? outside("force", q.force_n) : null)), half: list.map((q) => (q.uncertainty_n ? outside("force", q.uncertainty_n) : null)) };
}

/** @param {Answer} answer @param {string} test @param {number} top @param {Answer | undefined} own a curve that is drawn besides */
function familySeries(answer, test, top, own) {
  const count = answer.points.length / answer.fixed.length;
  const hue = (/** @type {number} */ i) => (isDark() ? viridis(0.3 + (0.7 * i) / answer.fixed.length, 1) : viridis(i / answer.fixed.length));
  return answer.fixed.flatMap((fixed, i) => {
    if (own && Math.abs(own.fixed[0] - fixed) < 1e-9) return [];
    const name = named(fixed, test), colour = test === "isobaric" ? pressureColour(fixed, top) : hue(i);
    return [/** @type {import("../chart.js").Series} */ ({ name, end: name, at: test === "isobaric" ? "start" : "end", colour, ...line(answer.points.slice(i * count, (i + 1) * count), test) })];
  });
}

/** The curve of the state; both branches of its loop, where the friction is known. @param {Answer} answer @param {string} test @param {number} top */
function ownSeries(answer, test, top) {
  const name = named(answer.fixed[0], test), colour = test === "isobaric" ? pressureColour(answer.fixed[0], top) : "#0072B2";
  const branches = [...new Set(answer.points.map((/** @type {Point} */ q) => q.direction))];
  return branches.map((branch, i) => {
    const list = answer.points.filter((/** @type {Point} */ q) => q.direction === branch);
    const words = branch === "contraction" ? " while it shortens" : branch === "elongation" ? " while it lengthens" : "";
    const label = i ? {} : { end: name, at: /** @type {"start" | "end"} */ (test === "isobaric" ? "start" : "end") };
    const curve = line(list, test);
    return /** @type {import("../chart.js").Series} */ ({ name: name + words, ...label, colour, strong: true, dash: branch === "elongation" ? "dash" : "solid", ...curve });
  });
}

/** @param {Answer} answer of another model */
function overlay(answer) {
  const colour = KINDS[OVERLAYS.indexOf(answer.model) + 1] ?? KINDS[6];
  const { half, ...curve } = isobar(answer.points);
  return /** @type {import("../chart.js").Series} */ ({ name: `${answer.model} at ${show("pressure", answer.fixed[0], 3)}`, dash: "dash", colour, ...curve });
}
