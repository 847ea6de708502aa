// A sheet of a workbook (.xlsx, .ods) as the text of a table: rows are lines, tabs are between
// cells. As on the command line, the first sheet with numbers is read
// (crates/mckibben-io/src/table/workbook.rs).
import { unzipSync } from "./vendor/fflate.js";

/** Most bytes of all parts, and as often a cell is repeated. */
const MOST = 60_000_000,
  REPEATED = 2000;

/** @param {Document | Element} of @param {string} name whatever its prefix is */
const all = (of, name) => [...of.getElementsByTagNameNS("*", name)];

/** The column of a place such as `B3`, from 0. @param {string} place */
const columnOf = (place) =>
  [...place.replace(/\d/g, "")].reduce(
    (column, letter) => 26 * column + letter.charCodeAt(0) - 64,
    0,
  ) - 1;

/**
 * A cell of either kind: a number has its value, a text is in the list of texts or its own.
 * @param {Element} cell @param {string[]} texts
 */
function valueOf(cell, texts) {
  const kind = cell.getAttribute("t"),
    own = ["v", "t", "p"].flatMap((name) => all(cell, name))[0]?.textContent;
  const value = kind === "s" ? texts[Number(own)] : kind === "e" ? "" : own;
  return (cell.getAttribute("office:value") ?? value ?? "")
    .replace(/\s/g, " ")
    .replaceAll('"', "″");
}

/** @param {Element} row @param {string[]} texts */
function lineOf(row, texts) {
  /** @type {string[]} */ const line = [];
  for (const cell of row.children) {
    const place = cell.getAttribute("r"),
      times = Number(cell.getAttribute("table:number-columns-repeated") ?? 1);
    if (place) line.length = columnOf(place);
    line.push(...Array(Math.min(REPEATED, times)).fill(valueOf(cell, texts)));
  }
  return line;
}

/** @param {File} file */
export async function sheetText(file) {
  let left = MOST;
  const parts = unzipSync(new Uint8Array(await file.arrayBuffer()), {
      filter: ({ name, originalSize }) => /\.xml/.test(name) && (left -= originalSize) >= 0,
    }),
    read = (/** @type {string} */ name) =>
      name in parts
        ? new DOMParser().parseFromString(new TextDecoder().decode(parts[name]), "application/xml")
        : undefined;
  const [list, document, book, places] = [
    "xl/sharedStrings.xml",
    "content.xml",
    "xl/workbook.xml",
    "xl/_rels/workbook.xml.rels",
  ].map(read);
  const texts = list
    ? all(list, "si").map((one) =>
        all(one, "t")
          .map((t) => t.textContent)
          .join(""),
      )
    : [];
  // In the order of their tabs; where each is, a list says by its mark.
  const names = (book ? all(book, "sheet") : []).map((sheet) => {
    const mark = [...sheet.attributes].find((a) => a.localName === "id"),
      of = places?.querySelector(`[Id="${mark?.value}"]`);
    return `xl/${of?.getAttribute("Target")}`.replace("xl//", "");
  });
  const sheets = document ? all(document, "table") : names.map(read);
  for (const sheet of sheets) {
    const rows = ["row", "table-row"].flatMap((name) => (sheet ? all(sheet, name) : [])),
      lines = rows.map((row) => lineOf(row, texts));
    if (lines.flat().some((value) => value.trim() && Number(value) >= -Infinity))
      return lines.map((line) => line.join("\t").trimEnd()).join("\n");
  }
  throw new Error("no sheet has a number");
}
