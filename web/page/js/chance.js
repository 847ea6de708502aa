// The chance that a muscle which is built does what was asked: in words, and as a curve of width.
import { KINDS, chartOf } from "./chart.js";
import { heading } from "./dom.js";
import { outside, unitName } from "./units.js";

/** Words for a chance, from the largest on; from the first one the answer is a plain yes. @type {[number, string][]} */
const WORDS = [
  [0.9, "Yes"],
  [0.6, "Likely"],
  [0.4, "Even"],
  [0.1, "Unlikely"],
];
/** Shares are not rounded up; what the engine means by 0.9 is no less. */
const SPARE = 1e-6;

/** `7 in 10`, in the words of the engine. @param {number} chance */
export function inTen(chance) {
  if (chance >= 0.995) return "more than 99 in 100";
  const of = chance >= 0.95 ? 100 : 10;
  return chance < 0.1 ? "less than 1 in 10" : `${Math.floor(of * chance + SPARE)} in ${of}`;
}

/** `Likely (7 in 10)`; empty where the chance is unknown. @param {number | null | undefined} chance */
export function verdict(chance) {
  if (chance == null) return "";
  const [, word] = WORDS.find(([least]) => chance + SPARE >= least) ?? [0, "No"];
  return word === "Even" || word === "No" ? word : `${word} (${inTen(chance)})`;
}

/** @typedef {NonNullable<Design["answer"]["choices"]>[number]} Choice */
/** The certainty that led to a choice: the engine looks for these. @param {Choice} choice */
export const certaintyOf = ({ chance }) =>
  [0.99, 0.9].find((one) => Number(chance) + SPARE >= one) ?? 0.5;

/** Widths over their chances. */
export function chanceCurve() {
  const chart = chartOf("chance", { tools: heading("Width over chance") });
  return {
    element: chart.element,
    /** @param {Choice[]} list */
    show(list) {
      const all = list
        .filter(({ kind, chance }) => /take|chance/.test(kind) && chance != null)
        .sort((a, b) => Number(a.chance) - Number(b.chance));
      chart.element.hidden = all.length < 2;
      const x = all.map(({ chance }) => 100 * Number(chance)),
        y = all.map((one) => outside("length", one.envelope_mm)),
        line = { name: "width", x, y, colour: KINDS[0] };
      chart.show({
        x: "chance [%]",
        y: `width of all [${unitName("length")}]`,
        xaxis: { range: [0, 100] },
        series: [line, { ...line, mode: "markers" }],
      });
    },
  };
}
