// A step on a valve, with the muscle moving.
import { Slot } from "../ask.js";
import { address, write } from "../address.js";
import { Chart, KINDS } from "../chart.js";
import { el } from "../dom.js";
import { form, job, table, warnings } from "../form.js";
import { muscle } from "../muscle.js";
import { motion } from "../state.js";
import { number, onUnits, outside, show, unitName } from "../units.js";
import { View, reach } from "../view3d.js";

/** @param {HTMLElement} main */
export function mount(main) {
  /** @type {any} */ let run;
  let frame = 0;
  const fields = form([
    { key: "to", field: "pressure_mpa", label: "Step to", kind: "pressure", value: "3 bar" },
    { key: "supply", field: "supply_mpa", label: "Supply", kind: "pressure", value: "6 bar" },
    { key: "valve", field: "valve", label: "Valve", value: "0.5 L/(s bar)" },
    { key: "load", field: "load", label: "Load", value: "mass:10kg" },
    { key: "damping", field: "damping_n_s_per_m", label: "Damping", kind: "damping", value: "200 N s/m" },
    { key: "until", field: "until_s", label: "Until", kind: "time", value: "2 s" },
    { key: "model", field: "model", label: "Model", options: [["fe", "fe"], ["universal", "universal"]], value: "fe" },
  ], () => go.run());
  const stage = el("div", { class: "stage" });
  const clock = el("p", { class: "say" });
  stage.append(clock);
  const view = new View(stage);
  const slot = new Slot({ lane: "state" });
  const slider = el("input", { type: "range", min: 0, max: 1000, value: 0, "aria-label": "Time", oninput: () => { stop(); at(Number(slider.value) / 1000); } });
  const play = el("button", { type: "button", onclick: () => (frame ? stop() : start()) }, "Play");
  const pressure = new Chart("motion-pressure", { tools: el("h3", {}, "Pressure") });
  const way = new Chart("motion-contraction", { tools: el("h3", {}, "Contraction") });
  const numbers = el("div", {});
  const go = job("Run", "motion", request, (answer) => { run = answer; stale(false); paint(); start(); }, (problem) => { fields.at(problem); stale(true); });
  const which = el("p", { class: "small soft" });
  main.replaceChildren(el("div", { class: "bench two" },
    el("section", { class: "controls", "aria-label": "Step" }, el("h2", {}, "A step on a valve"), fields.element, go.element, which, numbers),
    el("div", { class: "middle" }, stage, el("div", { class: "row" }, play, el("span", { style: "flex:1" }, slider)), el("div", { class: "charts" }, pressure.element, way.element))));

  async function request() {
    const read = await fields.read();
    if (!read) return undefined;
    write(address("motion", { ...muscle.params(), ...fields.texts() }));
    which.textContent = `The muscle: ${muscle.line()}. Change it on the page Muscle.`;
    return motion(await muscle.file(), read);
  }

  /** What is shown belongs to the last step that had an answer. @param {boolean} on */
  const stale = (on) => [stage, numbers, pressure.element, way.element].forEach((part) => part.classList.toggle("stale", on));

  function paint() {
    if (!run) return;
    const s = run.series, t = s.time_s;
    pressure.show({ x: "time [s]", y: `pressure [${unitName("pressure")}]`, series: [
      { name: "in the muscle", x: t, y: s.pressure_mpa.map((/** @type {number} */ p) => outside("pressure", p)), colour: KINDS[0], end: "muscle" },
      { name: "command", x: t, y: s.command.map((/** @type {number} */ p) => outside("pressure", p)), colour: KINDS[6], dash: "dot", end: "command" },
    ] });
    way.show({ x: "time [s]", y: "contraction ε [%]", series: [{ name: "contraction", x: t, y: s.contraction.map((/** @type {number} */ e) => 100 * e), colour: KINDS[1] }] });
    const time = (/** @type {number | null} */ x) => (x === null || x === undefined ? "–" : `${number(x, 3)} s`);
    numbers.replaceChildren(warnings(run.warnings), table(["", ""], [
      ["rise time, 10–90 %", time(run.rise_time_s)], ["settling time, 2 %", time(run.settling_time_s)], ["overshoot", run.overshoot === null ? "–" : `${number(100 * run.overshoot, 3)} %`],
      ["filled within 2 % after", time(run.fill_time_s)], ["air from the supply", `${number(run.air_normal_litres, 3)} normal L`], ["largest speed", `${number(largestSpeed(run), 3)} mm/s`], ["largest power", `${number(run.largest_power_w, 3)} W`],
    ], { label: "figures of the step" }));
  }

  /** The state at a share of the time. @param {number} share */
  function at(share) {
    if (!run) return;
    const s = run.series, i = Math.min(s.time_s.length - 1, Math.round(share * (s.time_s.length - 1)));
    slider.value = String(1000 * share);
    clock.replaceChildren(el("b", {}, `${s.time_s[i].toFixed(2)} s`), el("br"), `${show("pressure", s.pressure_mpa[i], 3)}, ${number(100 * s.contraction[i], 3)} %`);
    slot.ask("shape", { ...muscle.fields(), pressure_mpa: Math.max(0, s.pressure_mpa[i]), contraction: s.contraction[i] }, (shape) => {
      view.set(shape, { field: "max_stretch", low: 1, high: Math.max(1.2, reach(shape.arrays.max_stretch)[1]), restLength: shape.muscle.length_mm, restRadius: shape.muscle.outer_diameter_mm / 2 });
    }, () => {});
  }

  function start() {
    if (!run) return;
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) return at(1);
    const began = performance.now(), long = 1000 * run.series.time_s[run.series.time_s.length - 1];
    play.textContent = "Stop";
    const step = () => {
      const share = Math.min(1, (performance.now() - began) / long);
      at(share);
      if (share < 1) frame = requestAnimationFrame(step);
      else stop();
    };
    cancelAnimationFrame(frame);
    frame = requestAnimationFrame(step);
  }

  function stop() {
    cancelAnimationFrame(frame);
    frame = 0;
    play.textContent = "Play";
  }

  const off = onUnits(() => paint());
  return {
    /** @param {URLSearchParams} params */
    async load(params) {
      await muscle.read(params, fields.keys);
      fields.set(params);
      await go.run();
    },
    unmount() { off(); stop(); go.end(); slot.end(); },
  };
}

/** Largest speed in mm/s, of the motion itself; of what was recorded only where nothing else is known. @param {any} run */
const largestSpeed = (run) => run.largest_velocity_mm_per_s ?? run.largest_speed;
