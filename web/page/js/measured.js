// The table of measured points that pages share: opened on the page Data, or dropped anywhere. It is kept over a
// reload.
import { fileOf, keepFile } from "./kept.js";
import { signal } from "./life.js";
import { thinned, thinnedWords } from "./thin.js";

/** @typedef {{ pressure_mpa: number, contraction: number, force_n: number, branch?: "contraction" | "mean" | "elongation" | null }} Point */

const changed = signal();
export const onMeasured = changed.on;

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
      const of = thinned(file?.text ?? "");
      keepFile("data-said", thinnedWords(of) || undefined);
      keepFile("data", file && { name: file.name, text: of.text });
    }
    changed.tell();
  },
};
