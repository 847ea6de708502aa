// A joint with two of this muscle against each other: pressures by dragging the arm, torques, and what it reaches.
import { Slot, understood } from "../ask.js";
import { address, write } from "../address.js";
import { Chart } from "../chart.js";
import { fileField, quantity } from "../controls.js";
import { pack } from "../deflate.js";
import { el, problemBox } from "../dom.js";
import { job, warnings } from "../form.js";
import { jointOfFile, stated } from "../joint-file.js";
import { angleAt, armDrawing, numbersView, reachChart, torqueChart } from "../joint-view.js";
import { atEnd } from "../life.js";
import { muscle } from "../muscle.js";
import { joint } from "../state.js";
import { onUnits, typed } from "../units.js";

/** Words of the address, and what kind of quantity each is; `k` is that of the muscle's strands. */
const KINDS_OF = /** @type {const} */ ({ r: "length", range: "angle", e0: "ratio", phi: "angle", K: "angular-stiffness", pmax: "pressure" });
const USUAL = { r: 25, range: 60, e0: 0.12, phi: 20, K: 5, pmax: 0.5 };
/** @typedef {keyof typeof KINDS_OF} Key */
const KEYS = /** @type {Key[]} */ (Object.keys(KINDS_OF));
/** Files of the address: of the joint, and of muscle 2 where it is another one. */
const FILES = /** @type {const} */ (["joint", "file2"]);
/** What a joint file states too. */
const IN_FILE = /** @type {const} */ (["r", "range", "e0"]);

/** The controls. @param {typeof USUAL} v @param {{ changed: (key: Key, settled: boolean) => void, takeSecond: (text: string) => void, takeJoint: (text: string) => void }} act */
function controlsOf(v, { changed, takeSecond, takeJoint }) {
  const controls = /** @type {Record<Key, ReturnType<typeof quantity>>} */ ({});
  const make = (/** @type {Key} */ key, /** @type {string} */ label, /** @type {number} */ low, /** @type {number} */ high, symbol = "") => {
    controls[key] = quantity({ key, label, symbol, kind: KINDS_OF[key], low, high, value: v[key], change(value, settled) { if (value !== undefined) { v[key] = value; changed(key, settled); } } });
    return controls[key].element;
  };
  const which = el("p", { class: "small soft" }), ofFile = el("p", { class: "small soft" });
  const back = el("button", { type: "button", hidden: true, onclick: () => takeSecond("") }, "Use the same muscle twice");
  const leave = el("button", { type: "button", hidden: true, onclick: () => takeJoint("") }, "Close the joint file");
  const element = el("section", { class: "controls", "aria-label": "Joint" },
    el("fieldset", { class: "state" }, el("legend", {}, "Required"), make("phi", "Angle", -60, 60, "φ"), make("K", "Stiffness", 0, 30), el("p", { class: "small soft" }, "A stiffness of 0 selects the lowest pressures.")),
    el("fieldset", {}, el("legend", {}, "Joint"), make("r", "Radius of the pulley", 5, 80, "r"), make("range", "Range to either side", 10, 120), make("e0", "Contraction at the neutral angle", 0, 0.25), make("pmax", "Pressure of the supply", 0.05, 1)),
    which,
    el("details", {}, el("summary", {}, "Another muscle 2"), el("p", { class: "small soft" }, "Both muscles are that of the page Muscle, unless you open a file."), fileField("Open muscle 2 (TOML)", ".toml", (_, text) => takeSecond(text)), back),
    el("details", {}, el("summary", {}, "Joint file"), ofFile, fileField("Open a joint file (TOML)", ".toml", (_, text) => takeJoint(text)), leave));
  return {
    element, controls,
    /** @param {{ joint: string, file2: string }} files */
    show({ joint: file, file2 }) {
      back.hidden = !file2;
      leave.hidden = !file;
      ofFile.textContent = file ? "A joint file is open: its spring, weight and friction count; pulley, range and neutral contraction can be changed above." : "A joint file can state a spring, the weight of the arm, and more.";
      which.textContent = `The muscle: ${muscle.line()}. Change it on the page Muscle.`;
    },
  };
}

/** The arm is dragged about its axis. @param {HTMLElement} arm @param {(angle: number, settled: boolean) => void} turned */
function turning(arm, turned) {
  let on = false;
  const turn = (/** @type {PointerEvent} */ event, /** @type {boolean} */ settled) => { const angle = angleAt(arm, event); if (angle !== undefined) turned(angle, settled); };
  arm.addEventListener("pointerdown", (event) => { on = true; arm.setPointerCapture(event.pointerId); turn(event, false); });
  arm.addEventListener("pointermove", (event) => on && turn(event, false));
  arm.addEventListener("pointerup", (event) => { if (on) turn(event, true); on = false; });
}

/** Questions about a joint: a point, by formulas while one drags and by finite elements at rest, and its family of torques. @param {{ take: (answer: any) => void, fail: (problem: any) => void, family: (family: any) => void }} act */
function questions({ take, fail, family }) {
  let settling = 0, asking = 0, decided = 0;
  const point = new Slot(), elements = new Slot(), curves = new Slot();
  return {
    /** @param {any} request @param {typeof USUAL} v @param {boolean} settled */
    ask(request, v, settled) {
      const mine = ++asking, wanted = { angles_deg: [v.phi], max_pressure_mpa: v.pmax, ...(v.K > 0 ? { stiffness_nm_per_rad: v.K } : {}) };
      point.ask("joint", { ...request, ...wanted }, (answer) => { if (decided !== mine) take(answer); }, (problem) => { if (decided !== mine) fail(problem); });
      // What stays is what finite elements say.
      clearTimeout(settling);
      elements.end();
      const last = () => elements.ask("joint", { ...request, model: "fe", extrapolate: false, ...wanted }, (answer) => { decided = mine; take(answer); }, (problem) => { decided = mine; fail(problem); });
      if (settled) settling = window.setTimeout(last, 50);
      const angles = Array.from({ length: 25 }, (_, i) => -v.range + (2 * v.range * i) / 24);
      const pairs = [[1, 0], [0.75, 0.25], [0.5, 0.5], [0.25, 0.75], [0, 1]].map((pair) => pair.map((x) => x * v.pmax));
      curves.ask("joint", { ...request, pressures_mpa: pairs, angles_deg: angles }, (answer) => family({ answer, angles, pairs }), () => {});
    },
    end() { clearTimeout(settling); [point, elements, curves].forEach((slot) => slot.end()); },
  };
}

/** @param {HTMLElement} main */
export function mount(main) {
  const v = { ...USUAL }, files = { joint: "", file2: "" };
  /** What was typed over the joint file. @type {Set<string>} */ let over = new Set();
  /** @type {any} */ let point, /** @type {any} */ family, /** @type {any} */ reached;
  /** The file that says what the muscle of the page Muscle is. */
  let first = "";
  const arm = el("div", { class: "stage", role: "img", "aria-label": "The joint" });
  const numbers = el("section", { class: "numbers", "aria-label": "Numbers" }), said = el("div", {});
  const bench = controlsOf(v, {
    changed(key, settled) { over.add(key); ask(settled); },
    async takeSecond(text) { await pack(text); files.file2 = text; bench.show(files); ask(true); },
    async takeJoint(text) { await pack(text); files.joint = text; over = new Set(); await fromFile(); bench.show(files); ask(true); map.run(); },
  });
  const { controls } = bench;
  const turned = (/** @type {number} */ angle, /** @type {boolean} */ settled) => { v.phi = Math.max(-v.range, Math.min(v.range, Math.round(angle))); controls.phi.set(v.phi); ask(settled); };
  const torque = new Chart("joint-torque", { tools: el("h3", {}, "Torque over the angle"), drag: (x, _, settled) => turned(x, settled) });
  const reach = new Chart("joint-map", { tools: el("h3", {}, "Reachable stiffness") });
  const map = job("Map of the reachable states", "joint", async () => ({ ...request(), map: 25, max_pressure_mpa: v.pmax }), (answer) => { reached = answer.map; if (reached) reach.show(reachChart(reached)); });
  main.replaceChildren(el("div", { class: "bench" }, bench.element, el("div", { class: "middle" }, arm, el("div", { class: "charts" }, torque.element, reach.element), map.element), el("div", { class: "side" }, said, numbers)));
  turning(arm, turned);

  const stale = (/** @type {boolean} */ on) => [arm, numbers].forEach((part) => part.classList.toggle("stale", on));
  const which = () => (files.file2 ? "Muscle 2 is that of its file." : "Both muscles are those of the page Muscle.");
  const drawArm = () => { arm.innerHTML = armDrawing(point, point?.angle_deg ?? v.phi, v.pmax); };
  const asks = questions({
    take(answer) {
      stale(false);
      said.replaceChildren(warnings(answer.warnings));
      point = { ...answer.points[0], model: answer.model, words: answer.uncertainty_text };
      paint();
    },
    fail(problem) {
      said.replaceChildren(problemBox(problem));
      if (point) stale(true);
      else drawArm();
    },
    family(found) { family = found; torque.show(torqueChart(family, point)); },
  });

  function request() {
    const put = Object.fromEntries(IN_FILE.filter((key) => over.has(key)).map((key) => [key, v[key]]));
    return { ...(files.joint ? jointOfFile(files.joint, first, files.file2, put) : joint(first, files.file2, v)), model: "universal", extrapolate: true };
  }

  /** @param {boolean} settled */
  function ask(settled) {
    controls.phi.reach(-v.range, v.range);
    asks.ask(request(), v, settled);
    if (settled) write(address("joint", { ...muscle.params(), ...words() }));
  }

  /** What a joint file states is not in the address twice. */
  const words = () => ({ ...Object.fromEntries(KEYS.filter((key) => !files.joint || !(/** @type {readonly string[]} */ (IN_FILE)).includes(key) || over.has(key)).map((key) => [key, typed(KINDS_OF[key], v[key])])), ...files });

  function paint() {
    drawArm();
    if (family) torque.show(torqueChart(family, point));
    numbers.replaceChildren(...(point ? numbersView(point, which()) : []));
  }

  /** Values that the joint file states. */
  async function fromFile() {
    Object.assign(v, Object.fromEntries(IN_FILE.filter((key) => !over.has(key)).map((key) => [key, USUAL[key]])));
    const of = files.joint ? stated(files.joint) : {};
    await readInto(IN_FILE.filter((key) => of[key] && !over.has(key)).map((key) => [key, of[key] ?? ""]));
  }

  /** @param {[Key, string][]} texts */
  async function readInto(texts) {
    const readings = await understood(texts.map(([key, text]) => ({ text, kind: KINDS_OF[key], list: text.includes("..") })));
    texts.forEach(([key], i) => {
      const { problem, value, values } = readings[i];
      if (!problem) v[key] = values ? Math.max(...values.map(Math.abs)) : value;
    });
    for (const key of KEYS) controls[key].set(v[key]);
  }

  atEnd(onUnits(() => { paint(); if (reached) reach.show(reachChart(reached)); write(address("joint", { ...muscle.params(), ...words() }), true); }));
  return {
    /** @param {URLSearchParams} params */
    async load(params) {
      // Links of before have the stiffness of the joint under the name of that of the strands.
      if (/rad/.test(params.get("k") ?? "")) { params.set("K", params.get("k") ?? ""); params.delete("k"); }
      await muscle.read(params, [...KEYS, ...FILES]);
      for (const key of FILES) files[key] = params.get(key) ?? "";
      over = new Set(KEYS.filter((key) => params.has(key)));
      Object.assign(v, USUAL);
      await fromFile();
      await readInto(KEYS.filter((key) => params.has(key)).map((key) => [key, params.get(key) ?? ""]));
      bench.show(files);
      try {
        first = await muscle.file();
      } catch (problem) {
        stale(true);
        return void said.replaceChildren(problemBox(problem));
      }
      ask(true);
      map.run();
    },
    unmount() { asks.end(); map.end(); },
  };
}
