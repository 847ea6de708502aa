// What pages keep while others are shown, and over a reload: words of the address that are their own, and files. It
// ends with the tab.
import { signal } from "./life.js";

/** @typedef {{ words: Record<string, Words>, files: KeptFiles }} Kept */
/** A text that the browser keeps, where it keeps any. @param {() => Storage} storage @param {string} name */
const stored = (storage, name) => ({
  get() {
    try {
      return storage().getItem(name) ?? "";
    } catch {
      return "";
    }
  },
  /** @param {string} text */
  set(text) {
    try {
      storage().setItem(name, text);
    } catch {
      /* Then it is asked again, or lost with a reload. */
    }
  },
});
/** A word for later visits. @param {string} name */
export const remembered = (name) =>
  stored(() => localStorage, `mckibben:${name}`);
const session = stored(() => sessionStorage, "mckibben:kept");
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
  const said = Object.fromEntries(
    Object.entries(words).filter(
      ([, word]) => word !== undefined && word !== "",
    ),
  );
  if (JSON.stringify(said) === JSON.stringify(wordsOf(page))) return;
  kept.words[page] = /** @type {Words} */ (said);
  save();
}
/** A file or a list that a page works with. @template {keyof KeptFiles} K @param {K} name @returns {KeptFiles[K]} */
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
