// The target of a design, to drag: a pull at a contraction, over what the best muscle gives at the
// pressure that it is set to, and what is permitted.
import { Slot } from "./ask.js";
import { chartOf, KINDS, isobars } from "./chart.js";
import { permitted } from "./bench/family.js";
import { el, heading, remark } from "./dom.js";
import { candidate, fields } from "./state.js";
import { forceAxis, outside, ratioAxis, showForce, showPressure, showRatio } from "./units.js";

/** @typedef {{ force_n: number, contraction: number }} Target */
const digits = (/** @type {number} */ v, /** @type {number} */ n) => Number(v.toPrecision(n));

/**
 * @param {{ moved: (target: Target) => void, settled: (target: Target) => void }} act while it is
 * dragged, and when it
 *   is released
 */
export function designTarget(act) {
  const words = el("span", { class: "small soft" });
  const chart = chartOf("design-target", {
    tools: heading("Target"),
    drag: (x, y, settled) => drag(x, y, settled),
  });
  const slot = new Slot({ lane: "curves" });
  const element = el("div", { hidden: true }, chart.element, remark("Drag the target: ", words));
  /** @type {Target | undefined} */ let target;
  /** @type {Series[]} */ let series = [];

  function draw() {
    if (!target) return;
    // Without a muscle the target has room.
    const room = (/** @type {number} */ v) => (series.length ? {} : { range: [0, 1.5 * v] });
    chart.show({
      x: ratioAxis,
      y: forceAxis(),
      series,
      xaxis: room(100 * target.contraction || 10),
      yaxis: series.length ? undefined : room(outside("force", target.force_n)),
    });
    mark();
  }
  function mark() {
    if (!target) return;
    chart.mark(100 * target.contraction, outside("force", target.force_n));
    words.textContent = `${showForce(target.force_n)} at ${showRatio(target.contraction, 3)}.`;
  }
  /** @param {number} x @param {number} y @param {boolean} settled */
  function drag(x, y, settled) {
    if (!target) return;
    // In the shown unit to three digits: a value that one would type.
    const force = digits(Math.max(y, 1e-3), 3) / outside("force", 1);
    target = { force_n: digits(force, 12), contraction: Math.max(0, Math.round(2 * x) / 200) };
    mark();
    if (settled) act.settled(target);
    else act.moved(target);
  }

  return {
    element,
    draw,
    /** @param {Design["answer"]} answer @param {Design["request"]} of what it was asked by */
    show(answer, of) {
      const one =
        typeof of.force_n === "number" &&
        typeof of.contraction === "number" &&
        !of.points?.length &&
        !of.torques?.length &&
        !of.load;
      element.hidden = !one;
      if (!one) return;
      target = { force_n: Number(of.force_n), contraction: Number(of.contraction) };
      const [best] = answer.candidates,
        file = answer.muscle_files?.[0];
      series = [];
      draw();
      if (!best) return;
      const most = best.highest_pressure_mpa ?? answer.max_pressure_mpa,
        muscle = file ? { file } : fields(candidate(best, of, { p: 0, e: 0 }));
      slot.ask(
        "curve",
        { muscle, test: "isobaric", pressures_mpa: [best.pressure_mpa, most] },
        (curves) => {
          const end = showPressure(best.pressure_mpa, 3),
            line = { name: "best muscle", end, colour: KINDS[0], strong: true };
          const all = (/** @type {(number | null)[]} */ list = []) =>
            list.map((v) => v && v * best.count);
          series = [
            ...permitted(curves, most),
            ...isobars(line, curves.points.slice(0, curves.points.length / 2)),
          ].map((s) => ({ ...s, y: all(s.y), low: all(s.low), high: all(s.high) }));
          draw();
        },
      );
    },
  };
}
