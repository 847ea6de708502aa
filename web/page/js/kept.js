// What pages keep while others are shown, and over a reload: words of the address that are their own, and files. It
// ends with the tab.

const NAME = "mckibben:kept";
/**
 * Muscles of the project; measured points, and what to say of them; a test of a rubber; a plan, and the one that was
 * computed; whether constants were identified, and the verification computed.
 * @typedef {{ muscles?: import("./project.js").Kept[], data?: { name: string, text: string }, "data-said"?: string,
 *   rubber?: { name: string, text: string },
 *   plan?: string, campaign?: string, constants?: boolean, checked?: boolean }} Files
 * @typedef {{ words: Record<string, Record<string, string>>, files: Files }} Kept
 */
/** A word that the browser keeps, where it keeps any. @param {string} name */
export const remembered = (name) => ({
  get() {
    try {
      return localStorage.getItem(`mckibben:${name}`) ?? "";
    } catch {
      return "";
    }
  },
  /** @param {string} word */
  set(word) {
    try {
      localStorage.setItem(`mckibben:${name}`, word);
    } catch { /* Then it is asked again. */ }
  },
});
/** @returns {Kept} */
function before() {
  try {
    return { words: {}, files: {}, ...JSON.parse(sessionStorage.getItem(NAME) ?? "{}") };
  } catch {
    return { words: {}, files: {} };
  }
}
const kept = before();
/** @type {Set<() => void>} */ const listeners = new Set();

function save() {
  // What is too long for the browser stays until a reload.
  try {
    sessionStorage.setItem(NAME, JSON.stringify(kept));
  } catch { /* As said. */ }
  listeners.forEach((tell) => tell());
}

/** @param {() => void} tell */
export const onKept = (tell) => {
  listeners.add(tell);
};
/** A page's own words. @param {string} page */
export const wordsOf = (page) => kept.words[page] ?? {};
/** @param {string} page @param {Record<string, string | undefined>} words */
export function keepWords(page, words) {
  const said = Object.fromEntries(Object.entries(words).filter(([, word]) => word !== undefined && word !== ""));
  if (JSON.stringify(said) === JSON.stringify(wordsOf(page))) return;
  kept.words[page] = /** @type {Record<string, string>} */ (said);
  save();
}
/** A file or a list that a page works with. @template {keyof Files} K @param {K} name @returns {Files[K]} */
export const fileOf = (name) => kept.files[name];
/** @template {keyof Files} K @param {K} name @param {Files[K]} what nothing ends it */
export function keepFile(name, what) {
  if (what === undefined) delete kept.files[name];
  else kept.files[name] = what;
  save();
}
/** All of it, as a project has it. */
export const everything = () => structuredClone(kept);
/** In place of all. @param {Kept} other */
export function replaceAll({ words, files }) {
  Object.assign(kept, structuredClone({ words, files }));
  save();
}
