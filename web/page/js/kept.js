// What pages keep while others are shown, and over a reload: words of the address that are their
// own, and files. It ends with the tab.
import { computed, effect, signal } from "./watch.js";

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
/** @type {{ words: Record<string, Words>, files: KeptFiles }} */
const before = { words: {}, files: {}, ...JSON.parse(session.get() || "{}") };
const words = signal(before.words),
  files = signal(before.files);
effect(() => session.set(JSON.stringify({ words: words.value, files: files.value })));

/** A page's own words. @param {string} page */
export const wordsOf = (page) => words.value[page] ?? {};
/** @param {string} page @param {Record<string, string | undefined>} own */
export function keepWords(page, own) {
  const said = /** @type {Words} */ (
    Object.fromEntries(Object.entries(own).filter(([, word]) => word))
  );
  if (JSON.stringify(said) !== JSON.stringify(words.peek()[page] ?? {}))
    words.value = { ...words.peek(), [page]: said };
}
/**
 * A file or a list that a page works with.
 * @template {keyof KeptFiles} K @param {K} name @returns {KeptFiles[K]}
 */
export const fileOf = (name) => files.value[name];
/** @template {keyof KeptFiles} K @param {K} name @param {KeptFiles[K]} what nothing ends it */
export function keepFile(name, what) {
  files.value = { ...files.peek(), [name]: what };
}

// The table of measured points that pages share: opened on the page Data, or dropped anywhere.
/**
 * @typedef {{ pressure_mpa: number, contraction: number, force_n: number, branch?: "contraction" |
 * "mean" | "elongation" | null }} Point
 */
const data = computed(() => files.value.data);

export const measured = {
  /** As it is used: a long one is thinned. @returns {TextFile | undefined} */
  get file() {
    return data.value;
  },
  /** What to say of a table that was thinned. @returns {string} */
  get said() {
    return fileOf("data-said") ?? "";
  },

  /** @param {TextFile | undefined} file */
  set(file) {
    const { text, said } = thinned(file?.text ?? "");
    keepFile("data-said", said || undefined);
    keepFile("data", file && { name: file.name, text });
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
