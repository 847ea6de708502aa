// The table of measured points that pages share: opened on the page Data, or dropped on the page Muscle.

/** @typedef {{ pressure_mpa: number, contraction: number, force_n: number }} Point */

/** @type {Set<() => void>} */
const listeners = new Set();

export const measured = {
  /** @type {{ name: string, text: string } | undefined} */ file: undefined,
  /** What its headings do not say, as requests have it. @type {Record<string, string>} */ columns: {},

  /** @param {{ name: string, text: string } | undefined} file @param {Record<string, string>} [columns] */
  set(file, columns = {}) {
    this.file = file;
    this.columns = columns;
    listeners.forEach((tell) => tell());
  },
};

/** @param {() => void} tell @returns {() => void} what ends it */
export const onMeasured = (tell) => { listeners.add(tell); return () => { listeners.delete(tell); }; };
