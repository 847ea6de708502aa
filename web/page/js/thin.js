// Tables of measured points that are longer than what models are computed at: every n-th row, and a sentence that says
// so.

export const MOST_ROWS = 20_000;

/** @param {string} text @returns {{ text: string, rows: number, kept: number, step: number }} */
export function thinned(text, most = MOST_ROWS) {
  const lines = text.split(/\r?\n/);
  const isRow = (/** @type {string} */ line) => /^[\s"]*[-+.\d]/.test(line);
  const rows = lines.reduce((count, line) => count + Number(isRow(line)), 0);
  if (rows <= most) return { text, rows, kept: rows, step: 1 };
  const step = Math.ceil(rows / most);
  let at = 0;
  const kept = lines.filter((line) => !isRow(line) || at++ % step === 0);
  return { text: kept.join("\n"), rows, kept: Math.ceil(rows / step), step };
}

/** @param {{ rows: number, kept: number, step: number }} of */
export function thinnedWords({ rows, kept, step }) {
  const [all, most, used] = [rows, MOST_ROWS, kept].map((n) =>
    n.toLocaleString("en"),
  );
  const which = step === 2 ? "second" : step === 3 ? "third" : `${step}th`;
  return step === 1
    ? ""
    : `The table has ${all} rows, more than ${most}: every ${which} one is used, ${used} points.`;
}
