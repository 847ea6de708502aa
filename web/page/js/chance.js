// The chance that a muscle which is built does what was asked: in words, and as a curve of width.
import { KINDS, chartOf } from "./chart.js";
import { heading } from "./dom.js";
import { outside, unitName } from "./units.js";

/** From here on the answer is a plain yes. */
const CERTAIN = 0.9;
/** Words for less, from the largest chance on. @type {[number, string][]} */
const WORDS = [
  [CERTAIN, "Yes"],
  [0.6, "Likely"],
  [0.4, "Even"],
  [0.1, "Unlikely"],
];
/** Shares are not rounded up; what the engine means by 0.9 is no less. */
const SPARE = 1e-9;

/** `7 in 10`. @param {number} chance */
export function inTen(chance) {
  const of = chance < 0.1 || chance > 0.9 + SPARE ? 100 : 10;
  return `${Math.floor(of * (chance + SPARE))} in ${of}`;
}

/** `Likely (7 in 10)`; empty where the chance is unknown. @param {number | null | undefined} chance */
export function verdict(chance) {
  if (chance == null) return "";
  const [, word] = WORDS.find(([least]) => chance + SPARE >= least) ?? [0, "No"];
  return word === "Even" || word === "No" ? word : `${word} (${inTen(chance)})`;
}

/** @typedef {{ chance: number, width_mm: number, name: string }} Possible */
/** Widths over their chances, to pick from. @param {(one: Possible) => void} pick */
export function chanceCurve(pick) {
  /** @type {Possible[]} */ let all = [];
  const chart = chartOf("chance", {
    tools: heading("Width over chance"),
    drag(x, _, settled) {
      const off = (/** @type {Possible} */ { chance }) => Math.abs(100 * chance - x);
      if (settled) pick(all.reduce((a, b) => (off(b) < off(a) ? b : a)));
    },
  });
  return {
    element: chart.element,
    /** @param {Possible[]} list */
    show(list) {
      all = [...list].sort((a, b) => a.chance - b.chance);
      chart.element.hidden = all.length < 2;
      const x = all.map(({ chance }) => 100 * chance),
        y = all.map(({ width_mm: width }) => outside("length", width)),
        line = { name: "width", x, y, colour: KINDS[0] };
      chart.show({
        x: "chance [%]",
        y: `width [${unitName("length")}]`,
        xaxis: { range: [0, 100] },
        series: [line, { ...line, mode: "markers" }],
      });
    },
  };
}
