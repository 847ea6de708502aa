// What pages keep while others are shown, and over a reload: words of the address that are their
// own, and files. It ends with the tab.
import { signal } from "./life.js";

/** @typedef {{ words: Record<string, Words>, files: KeptFiles }} Kept */
/** A text that the browser keeps, where it keeps any. */
const session = {
  get() {
    try {
      return sessionStorage.getItem("mckibben:kept") ?? "";
    } catch {
      return "";
    }
  },
  /** @param {string} text */
  set(text) {
    try {
      sessionStorage.setItem("mckibben:kept", text);
    } catch {
      /* Then it is lost with a reload. */
    }
  },
};
/** @type {Kept} */
const kept = { words: {}, files: {}, ...JSON.parse(session.get() || "{}") };
const changed = signal();
export const onKept = changed.stay;

function save() {
  session.set(JSON.stringify(kept));
  changed.tell();
}

/** A page's own words. @param {string} page */
export const wordsOf = (page) => kept.words[page] ?? {};
/** @param {string} page @param {Record<string, string | undefined>} words */
export function keepWords(page, words) {
  const said = Object.fromEntries(Object.entries(words).filter(([, word]) => word));
  if (JSON.stringify(said) === JSON.stringify(wordsOf(page))) return;
  kept.words[page] = /** @type {Words} */ (said);
  save();
}
/**
 * A file or a list that a page works with.
 * @template {keyof KeptFiles} K @param {K} name @returns {KeptFiles[K]}
 */
export const fileOf = (name) => kept.files[name];
/** @template {keyof KeptFiles} K @param {K} name @param {KeptFiles[K]} what nothing ends it */
export function keepFile(name, what) {
  if (what === undefined) delete kept.files[name];
  else kept.files[name] = what;
  save();
}
/** What was typed and is still being read. @type {Set<Promise<unknown>>} */ const typing =
  new Set();
/** @param {Promise<unknown>} reading */
export function keeping(reading) {
  const ended = reading
    .catch(() => {})
    .finally(() => {
      typing.delete(ended);
    });
  typing.add(ended);
}
/** All of it, as a project has it, with what was typed last. */
export async function everything() {
  while (typing.size) await Promise.all(typing);
  return structuredClone(kept);
}
/** In place of all. @param {Kept} other */
export function replaceAll({ words, files }) {
  Object.assign(kept, structuredClone({ words, files }));
  save();
}

// The table of measured points that pages share: opened on the page Data, or dropped anywhere.
/**
 * @typedef {{ pressure_mpa: number, contraction: number, force_n: number, branch?: "contraction" |
 * "mean" | "elongation" | null }} Point
 */

const newPoints = signal();
export const onMeasured = newPoints.on;

export const measured = {
  /** As it is used: a long one is thinned. @returns {TextFile | undefined} */
  get file() {
    return fileOf("data");
  },
  /** What to say of a table that was thinned. @returns {string} */
  get said() {
    return fileOf("data-said") ?? "";
  },

  /** @param {TextFile | undefined} file */
  set(file) {
    if (file !== this.file) {
      const { text, said } = thinned(file?.text ?? "");
      keepFile("data-said", said || undefined);
      keepFile("data", file && { name: file.name, text });
    }
    newPoints.tell();
  },
};

// Tables that are longer than what models are computed at: every n-th row, and a sentence that says
// so.
const MOST_ROWS = 20_000;

/** @param {string} text */
export function thinned(text, most = MOST_ROWS) {
  const lines = text.split(/\r?\n/);
  const isRow = (/** @type {string} */ line) => /^[\s"]*[-+.\d]/.test(line);
  const rows = lines.filter(isRow).length,
    step = Math.ceil(rows / most);
  if (step < 2) return { text, said: "" };
  let at = 0;
  const some = lines.filter((line) => !isRow(line) || !(at++ % step));
  const [all, few, used] = [rows, most, Math.ceil(rows / step)].map((n) => n.toLocaleString("en"));
  const which = ["second", "third"][step - 2] ?? `${step}th`;
  return {
    text: some.join("\n"),
    said: `The table has ${all} rows, more than ${few}: every ${which} one is used, ${used} points.`,
  };
}
