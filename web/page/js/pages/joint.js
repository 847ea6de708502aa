// A joint with two of this muscle against each other: pressures by dragging the arm, torques, and what it reaches.
import { Slot, understood } from "../ask.js";
import { address, write } from "../address.js";
import { Chart, KINDS, isDark, viridis } from "../chart.js";
import { fileField, quantity } from "../controls.js";
import { el, problemBox } from "../dom.js";
import { job, warnings } from "../form.js";
import { muscle } from "../muscle.js";
import { joint } from "../state.js";
import { number, onUnits, outside, show, typed, unitName } from "../units.js";

/** Words of the address, and what kind of quantity each is; `k` is that of the muscle's strands. */
const KINDS_OF = /** @type {const} */ ({ r: "length", range: "angle", e0: "ratio", phi: "angle", K: "angular-stiffness", pmax: "pressure" });
const SECOND = "file2";

/** @param {HTMLElement} main */
export function mount(main) {
  const v = { r: 25, range: 60, e0: 0.12, phi: 20, K: 5, pmax: 0.5 };
  /** @type {any} */ let point;
  /** @type {any} */ let family;
  const controls = /** @type {Record<string, any>} */ ({});
  const make = (/** @type {string} */ key, /** @type {string} */ label, /** @type {import("../units.js").Kind} */ kind, /** @type {number} */ low, /** @type {number} */ high, symbol = "") => {
    controls[key] = quantity({ label, symbol, kind, low, high, value: /** @type {any} */ (v)[key], change(value, settled) { /** @type {any} */ (v)[key] = value; ask(settled); } });
    return controls[key].element;
  };
  const which = el("p", { class: "small soft" });
  /** The file of muscle 2, where it is another one. */
  let second = "";
  /** The file that says what the muscle of the page Muscle is. */
  let first = "";
  const back = el("button", { type: "button", hidden: true, onclick: () => takeSecond("", "") }, "Use the same muscle twice");
  const controlsBox = el("section", { class: "controls", "aria-label": "Joint" },
    el("fieldset", { class: "state" }, el("legend", {}, "Required"), make("phi", "Angle", "angle", -60, 60, "φ"), make("K", "Stiffness", "angular-stiffness", 0, 30), el("p", { class: "small soft" }, "A stiffness of 0 selects the lowest pressures.")),
    el("fieldset", {}, el("legend", {}, "Joint"), make("r", "Radius of the pulley", "length", 5, 80, "r"), make("range", "Range to either side", "angle", 10, 120), make("e0", "Contraction at the neutral angle", "ratio", 0, 0.25), make("pmax", "Pressure of the supply", "pressure", 0.05, 1)),
    which,
    el("details", {}, el("summary", {}, "Another muscle 2"), el("p", { class: "small soft" }, "Both muscles are that of the page Muscle, unless you open a file."), fileField("Open muscle 2 (TOML)", ".toml", takeSecond), back));
  const arm = el("div", { class: "stage", role: "img", "aria-label": "The joint" });
  const numbers = el("section", { class: "numbers", "aria-label": "Numbers" });
  const said = el("div", {});
  const torque = new Chart("joint-torque", { tools: el("h3", {}, "Torque over the angle"), drag(x, _, settled) { v.phi = clamp(x); controls.phi.set(v.phi); ask(settled); } });
  const reach = new Chart("joint-map", { tools: el("h3", {}, "Reachable stiffness") });
  const map = job("Map of the reachable states", "joint", async () => ({ ...request(), map: 25, max_pressure_mpa: v.pmax }), (answer) => drawMap(answer.map));
  main.replaceChildren(el("div", { class: "bench" }, controlsBox, el("div", { class: "middle" }, arm, el("div", { class: "charts" }, torque.element, reach.element), map.element), el("div", { class: "side" }, said, numbers)));

  const stale = (/** @type {boolean} */ on) => [arm, numbers].forEach((part) => part.classList.toggle("stale", on));
  let settling = 0, asking = 0, decided = 0;
  const pointSlot = new Slot(), elementSlot = new Slot(), familySlot = new Slot();
  const clamp = (/** @type {number} */ phi) => Math.max(-v.range, Math.min(v.range, Math.round(phi)));

  const request = () => ({ ...joint(first, second, v), model: "universal", extrapolate: true });

  /** @param {boolean} settled */
  function ask(settled) {
    controls.phi.reach(-v.range, v.range);
    const wanted = { angles_deg: [v.phi], max_pressure_mpa: v.pmax, ...(v.K > 0 ? { stiffness_nm_per_rad: v.K } : {}) };
    const take = (/** @type {any} */ answer) => {
      stale(false);
      said.replaceChildren(warnings(answer.warnings));
      point = { ...answer.points[0], model: answer.model, words: answer.uncertainty_text };
      paint();
    };
    const fail = (/** @type {any} */ problem) => {
      said.replaceChildren(problemBox(problem));
      if (point) stale(true);
      else drawArm();
    };
    const mine = ++asking;
    pointSlot.ask("joint", { ...request(), ...wanted }, (answer) => { if (decided !== mine) take(answer); }, (problem) => { if (decided !== mine) fail(problem); });
    // What stays is what finite elements say.
    clearTimeout(settling);
    elementSlot.end();
    if (settled) settling = window.setTimeout(() => elementSlot.ask("joint", { ...request(), model: "fe", extrapolate: false, ...wanted }, (answer) => { decided = mine; take(answer); }, (problem) => { decided = mine; fail(problem); }), 50);
    const angles = Array.from({ length: 25 }, (_, i) => -v.range + (2 * v.range * i) / 24);
    const pairs = [[1, 0], [0.75, 0.25], [0.5, 0.5], [0.25, 0.75], [0, 1]].map((pair) => pair.map((x) => x * v.pmax));
    familySlot.ask("joint", { ...request(), pressures_mpa: pairs, angles_deg: angles }, (answer) => { family = { answer, angles, pairs }; drawFamily(); }, () => {});
    if (settled) write(address("joint", { ...muscle.params(), ...own() }));
  }

  /** @param {string} _name @param {string} text */
  function takeSecond(_name, text) {
    second = text;
    back.hidden = !text;
    ask(true);
  }

  const own = () => Object.fromEntries([...Object.entries(KINDS_OF).map(([key, kind]) => [key, typed(kind, /** @type {any} */ (v)[key])]), [SECOND, second]]);

  function paint() {
    drawArm();
    drawFamily();
    if (!point) return numbers.replaceChildren();
    const half = (/** @type {number | undefined} */ u) => (u ? ` ± ${number(u, 2)}` : "");
    const rows = [
      ["pressure of muscle 1", show("pressure", point.pressure_1_mpa, 3)], ["pressure of muscle 2", show("pressure", point.pressure_2_mpa, 3)],
      ["stiffness", `${number(point.stiffness_nm_per_rad, 3)}${half(point.stiffness_uncertainty_nm_per_rad)} N m/rad`], ["pulls", `${show("force", point.force_1_n, 3)}, ${show("force", point.force_2_n, 3)}`],
      ["contractions", `${show("ratio", point.contraction_1, 3)}, ${show("ratio", point.contraction_2, 3)}`],
    ];
    numbers.replaceChildren(el("dl", {}, el("dt", { class: "head" }, "rests at"), el("dd", { class: "head" }, `${number(point.angle_deg, 3)}${half(point.angle_uncertainty_deg)}°`), ...rows.flatMap(([name, value]) => [el("dt", {}, name), el("dd", {}, value)])),
      el("p", { class: "small soft" }, `${second ? "Muscle 2 is that of its file." : "Both muscles are those of the page Muscle."} Pressures by ${point.model}; curves and map by universal.${point.words ? ` The ± of the torque ${point.words}.` : ""}`));
  }

  // The arm: dragged about its axis.
  function drawArm() {
    const phi = ((point?.angle_deg ?? v.phi) * Math.PI) / 180;
    const [cx, cy, R, far] = [0, 0, 26, 120];
    const tip = [cx + far * Math.cos(phi), cy - far * Math.sin(phi)];
    const tube = (/** @type {number} */ y, /** @type {number} */ e, /** @type {number} */ share, /** @type {string} */ text) => {
      const short = 150 * (1 - (e ?? 0)), x0 = -190, fat = 6 + 26 * Math.max(0, e ?? 0) + 3 * share;
      return `<path d="M${x0} ${y - 5}q8 ${-fat} ${short / 2} ${-fat}t${short / 2} ${fat}v10q-8 ${fat} ${-short / 2} ${fat}t${-short / 2} ${-fat}z" fill="${isDark() ? viridis(0.25 + 0.75 * share, 1) : viridis(share)}" stroke="currentColor"/><path d="M${x0 + short} ${y}L0 ${y}" stroke="currentColor" fill="none"/><text x="${x0}" y="${y < 0 ? y - 26 : y + 38}" font-size="11" fill="currentColor">${text}</text>`;
    };
    const p = point;
    const label = (/** @type {number} */ i) => (p ? `${i}: ${show("pressure", i === 1 ? p.pressure_1_mpa : p.pressure_2_mpa, 3)}` : String(i));
    arm.innerHTML = `<svg class="section" viewBox="-210 -140 360 280"><g stroke-width="1.5">${tube(-R, p?.contraction_1, p ? p.pressure_1_mpa / v.pmax : 0, label(1))}${tube(R, p?.contraction_2, p ? p.pressure_2_mpa / v.pmax : 0, label(2))}<circle r="${R}" fill="none" stroke="currentColor"/><path d="M0 0L${tip[0]} ${tip[1]}" stroke="currentColor" stroke-width="7" stroke-linecap="round"/><circle cx="${tip[0]}" cy="${tip[1]}" r="8" fill="${KINDS[1]}"/></g></svg>`;
  }
  let on = false;
  const turn = (/** @type {PointerEvent} */ event, /** @type {boolean} */ settled) => {
    const svg = arm.querySelector("svg");
    const matrix = svg?.getScreenCTM()?.inverse();
    if (!svg || !matrix) return;
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix);
    v.phi = clamp((Math.atan2(-at.y, at.x) * 180) / Math.PI);
    controls.phi.set(v.phi);
    ask(settled);
  };
  arm.addEventListener("pointerdown", (event) => { on = true; arm.setPointerCapture(event.pointerId); turn(event, false); });
  arm.addEventListener("pointermove", (event) => on && turn(event, false));
  arm.addEventListener("pointerup", (event) => { if (on) turn(event, true); on = false; });

  function drawFamily() {
    if (!family) return;
    const { answer, angles, pairs } = family;
    const series = pairs.map((/** @type {number[]} */ pair, /** @type {number} */ i) => {
      const rows = answer.points.slice(i * angles.length, (i + 1) * angles.length);
      const name = pair.map((p) => number(outside("pressure", p), 3)).join(" | ") + " " + unitName("pressure");
      return { name, end: name, colour: KINDS[i], x: angles, y: rows.map((/** @type {any} */ q) => q.torque_nm) };
    });
    torque.show({ x: "angle φ [°]", y: "torque [N m]", yaxis: {}, series, marks: point ? [{ x: point.angle_deg, y: point.torque_nm ?? 0, text: "required" }] : [] });
  }

  /** @param {any} found */
  function drawMap(found) {
    if (!found) return;
    found.points = found.points.filter(Boolean);
    const colour = (/** @type {any} */ q) => q.pressures_mpa.reduce((/** @type {number} */ a, /** @type {number} */ b) => a + b, 0) / 2;
    reach.show({
      x: "rest angle φ [°]", y: "stiffness [N m/rad]", z: `mean pressure [${unitName("pressure")}]`, series: [],
      data: [{ type: "scatter", name: "reached", mode: "markers", showlegend: false, x: found.points.map((/** @type {any} */ q) => q.angle_deg), y: found.points.map((/** @type {any} */ q) => q.stiffness_nm_per_rad), marker: { size: 5, color: found.points.map((/** @type {any} */ q) => outside("pressure", colour(q))), colorscale: "Viridis", colorbar: { title: { text: `mean pressure [${unitName("pressure")}]` } } }, hovertemplate: "%{x:.3g}°, %{y:.3g} N m/rad<extra></extra>" }],
    });
  }

  const off = onUnits(() => paint());
  return {
    /** @param {URLSearchParams} params */
    async load(params) {
      // Links of before have the stiffness of the joint under the name of that of the strands.
      if (/rad/.test(params.get("k") ?? "")) { params.set("K", params.get("k") ?? ""); params.delete("k"); }
      await muscle.read(params, [...Object.keys(KINDS_OF), SECOND]);
      which.textContent = `The muscle: ${muscle.line()}. Change it on the page Muscle.`;
      second = params.get(SECOND) ?? "";
      back.hidden = !second;
      const asked = Object.keys(KINDS_OF).filter((key) => params.has(key));
      const readings = await understood(asked.map((key) => ({ text: params.get(key) ?? "", kind: /** @type {any} */ (KINDS_OF)[key] })));
      asked.forEach((key, i) => { if (!readings[i].problem) /** @type {any} */ (v)[key] = readings[i].value; });
      for (const key of Object.keys(controls)) controls[key].set(/** @type {any} */ (v)[key]);
      try {
        first = await muscle.file();
      } catch (problem) {
        stale(true);
        return void said.replaceChildren(problemBox(problem));
      }
      ask(true);
      map.run();
    },
    unmount() { off(); clearTimeout(settling); map.end(); [pointSlot, elementSlot, familySlot].forEach((slot) => slot.end()); },
  };
}
