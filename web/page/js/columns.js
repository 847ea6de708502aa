// Tables of measured points: their cells, what columns were read as, and a grid to type in.
import { block, el, folded, textField } from "./dom.js";
import { dsvFormat } from "./vendor/dsv.js";

/**
 * Lines that a grid shows at most: those behind them stay as they are; and empty ones to type in.
 */
const SHOWN = 200,
  FREE = 4;

/** Rows as CSV; a gap is no number. @param {readonly (readonly unknown[])[]} rows */
export const csv = (rows) =>
  dsvFormat(",").formatRows(rows.map((row) => row.map((v) => (Number.isNaN(v) ? "" : v)))) + "\n";

/** The cells of a text, by the separator of its first line. @param {string} text */
function cellsOf(text) {
  const [first] = text.split("\n"),
    separator = ["\t", ";", ",", "|"].find((s) => first.includes(s));
  const rows = separator
    ? dsvFormat(separator).parseRows(text)
    : text.split(/\r?\n/).map((line) => line.trim().split(/\s+/));
  return rows
    .map((row) => row.map((cell) => cell.trim()))
    .filter((row) => row.some((cell) => cell));
}

/**
 * The remarks that a table begins with, and its cells; a last remark may be its heading.
 * @param {string} text
 */
function tableOf(text) {
  const [, remarks, rest] = /^((?:#.*\n)*)([^]*)$/.exec(text) ?? [],
    hasHead = /^.*\p{L}/u.test(rest),
    head = /#.*\n$/.exec(remarks)?.[0] ?? "";
  return hasHead || !head
    ? { remarks, rows: cellsOf(rest) }
    : { remarks: "", rows: cellsOf(head.slice(1) + rest) };
}

/** The headings of a table: its first line with letters in several fields. @param {string} text */
export const headings = (text) =>
  tableOf(text.slice(0, 20_000)).rows.find(
    (fields) => fields.length > 1 && fields.some((f) => /\p{L}/u.test(f)),
  ) ?? [];

/**
 * What columns were read as.
 * @param {{ column: string, quantity: string, unit?: string | null }[]} list
 */
export const columnLine = (list) =>
  list
    .map((c) => `${c.column} → ${c.quantity}${c.unit ? ` (${c.unit})` : ""}`)
    .join(", ")
    .replaceAll("_", " ");

/**
 * A table to type in; cells that are pasted fill it from the one that has the focus.
 * @param {string[]} usual headings of an empty one @param {(text: string) => void} changed
 */
export function grid(usual, changed) {
  let table = { remarks: "", rows: [usual] },
    written = "";
  const body = el("tbody"),
    element = folded("Table", block("scroll", el("table", { class: "grid" }, body)));
  const widest = () => Math.max(...table.rows.map((row) => row.length));
  /** @param {number} i @param {number} j @param {string} text */
  const put = (i, j, text) => {
    (table.rows[i] ??= [])[j] = text.trim();
  };
  function tell() {
    const { remarks, rows } = table,
      lines = rows
        .filter((row) => row.some(Boolean))
        .map((row) => Array.from({ length: widest() }, (_, j) => row[j]));
    written = `${remarks}${dsvFormat("\t").formatRows(lines)}\n`;
    changed(written);
  }
  /** @param {number} i @param {number} j */
  function cell(i, j) {
    const field = textField({
      value: table.rows[i]?.[j] ?? "",
      ariaLabel: `line ${i + 1}, column ${j + 1}`,
      onchange() {
        put(i, j, field.value);
        tell();
      },
      onpaste(/** @type {ClipboardEvent} */ event) {
        const text = event.clipboardData?.getData("text/plain") ?? "";
        if (!/[\t\n]/.test(text)) return;
        event.preventDefault();
        cellsOf(text).forEach((row, k) => row.forEach((value, l) => put(i + k, j + l, value)));
        paint();
        tell();
      },
    });
    return el("td", field);
  }
  function paint() {
    const { rows } = table,
      wide = widest();
    body.replaceChildren(
      ...Array.from({ length: Math.min(SHOWN, rows.length + FREE) }, (_, i) =>
        el("tr", ...Array.from({ length: wide }, (__, j) => cell(i, j))),
      ),
    );
  }
  paint();
  return {
    element,
    /** @param {string} text */
    show(text) {
      if (text === written) return;
      table = tableOf(text);
      paint();
    },
  };
}
