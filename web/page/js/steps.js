// Steps of the muscle, to take back and to do again; each has the name of what changed. Pages are
// apart: they are the browser's history.
import { muscle } from "./muscle.js";
import { measured } from "./state.js";
import { show } from "./units.js";

/**
 * The muscle as words of an address, and what led to it.
 * @typedef {{ words: Record<string, string>, name: string }} Step
 */
/** @type {Step[]} */ let steps = [];
let at = -1;

/**
 * What changed between two muscles.
 * @param {Record<string, string>} before @param {Record<string, string>} now
 */
function nameOf(before, now) {
  const [key, other] = [...new Set([...Object.keys(before), ...Object.keys(now)])].filter(
    (k) => before[k] !== now[k],
  );
  const measure = measured().find((m) => m.key === key),
    value = muscle.value(key);
  if (other || key === "file") return `another muscle: ${muscle.name}`;
  if (!measure) return key === "name" ? "the name" : key;
  return typeof value === "number"
    ? `${measure.label} ${show(measure.kind, value)}`
    : measure.label;
}

/** The muscle as it is now becomes a step, where it is another one. */
export function record() {
  const { u, ...all } = muscle.params(),
    words = Object.fromEntries(
      Object.entries(all).flatMap(([k, word]) => (word ? [[k, word]] : [])),
    );
  const before = steps[at]?.words;
  if (before && JSON.stringify(before) === JSON.stringify(words)) return;
  steps = [...steps.slice(0, at + 1), { words, name: before ? nameOf(before, words) : "" }].slice(
    -200,
  );
  at = steps.length - 1;
}

/** What undo takes back, and what redo does again; empty where there is nothing. */
export const names = () => [at > 0 ? steps[at].name : "", steps[at + 1]?.name ?? ""];

/** The muscle of a step before or after. @param {-1 | 1} by */
export function step(by) {
  const to = steps[at + by];
  if (to) at += by;
  return to?.words;
}
