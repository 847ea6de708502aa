// Steps of the muscle, to take back and to do again; each has the name of what changed. Pages are
// apart: they are the browser's history. They live through a reload.
import { fileOf, keepFile } from "./kept.js";
import { muscle } from "./muscle.js";
import { measured } from "./state.js";
import { show } from "./units.js";

const MOST = 200;
const kept = () => fileOf("steps") ?? { list: [], at: -1 };

/**
 * What changed between two muscles.
 * @param {Words} before @param {Words} now
 */
function nameOf(before, now) {
  const [key, other] = Object.keys({ ...before, ...now }).filter((k) => before[k] !== now[k]),
    measure = measured().find((m) => m.key === key),
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
    /** @type {Words} */ words = JSON.parse(JSON.stringify(all)),
    { list, at } = kept(),
    before = list[at]?.words;
  if (before && JSON.stringify(before) === JSON.stringify(words)) return;
  const next = [...list.slice(0, at + 1), { words, name: before ? nameOf(before, words) : "" }];
  keepFile("steps", { list: next.slice(-MOST), at: Math.min(MOST, next.length) - 1 });
}

/** What undo takes back, and what redo does again; empty where there is nothing. */
export function names() {
  const { list, at } = kept();
  return [at > 0 ? list[at].name : "", list[at + 1]?.name ?? ""];
}

/** The muscle of a step before or after. @param {-1 | 1} by */
export function step(by) {
  const { list, at } = kept(),
    to = list[at + by];
  if (to) keepFile("steps", { list, at: at + by });
  return to?.words;
}
