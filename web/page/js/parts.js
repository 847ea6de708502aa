// Parts that one can buy or cast: tubes, sleeves and rubbers; a button puts one into the muscle.
import { answerTo } from "./ask.js";
import { choice } from "./controls.js";
import { block, button, capital, dialog, el, folded, problemBox, textField } from "./dom.js";
import { problemOf } from "./engine/problem.js";
import { table } from "./form.js";
import { muscle, visit } from "./muscle.js";
import { inWords, number, show, showLength, showPressure, showRatio } from "./units.js";

/** @typedef {Commands["parts-list"]["answer"]} Parts */
/** @typedef {"tubes" | "sleeves" | "rubbers"} Kind */
/**
 * What a part says of the muscle: keys of the state. @typedef {Record<string, number | string>}
 * Said
 */
/**
 * A row: the name, cells, the diameters that a sleeve is for, and what it says of the muscle.
 * @typedef {{ name: string, cells: (string | Node)[], low?: number, high?: number, said: Said }} Row
 */

const estimate = (/** @type {string} */ text) => el("span", { class: "estimated" }, text);
/**
 * A source that may be long.
 * @param {string | null | undefined} source @param {string | null | undefined} [note]
 */
const source = (source, note) => folded("Source", [source, note].filter(Boolean).join(" "));

/** @type {{ [K in Kind]: { head: string[], text: number[], rows: (parts: Parts) => Row[] } }} */
const LISTS = {
  tubes: {
    head: ["tube", "", "inside", "outside", "wall", "rubber", "made", "price", "rated", "source"],
    text: [0, 5, 6, 7, 9],
    rows: ({ tubes }) =>
      tubes.map((t) => ({
        name: t.name,
        said: { D: t.outer_diameter_mm, s: Number(t.wall_mm.toPrecision(12)), rubber: t.rubber },
        cells: [
          showLength(t.inner_diameter_mm),
          showLength(t.outer_diameter_mm),
          showLength(t.wall_mm, 3),
          t.rubber,
          t.is_cast ? "cast" : "sold",
          t.price ?? "–",
          t.pressure_mpa ? showPressure(t.pressure_mpa, 3) : "–",
          source(t.source, t.note),
        ],
      })),
  },
  sleeves: {
    head: [
      "sleeve",
      "",
      "what it is",
      "material",
      "for diameters",
      "angle from",
      "strands",
      "estimated",
      "source",
    ],
    text: [0, 2, 3, 7, 8],
    rows: ({ sleeves }) =>
      sleeves.map((s) => ({
        name: s.name,
        low: s.least_diameter_mm,
        high: s.largest_diameter_mm,
        said: { braid: s.name },
        cells: [
          s.title,
          s.material,
          `${showLength(s.least_diameter_mm, 3)} to ${showLength(s.largest_diameter_mm, 3)}`,
          show("angle", s.least_angle_deg, 3),
          s.strands ? String(s.strands) : estimate("estimated"),
          s.missing || s.stiffness_factor ? estimate(estimated(s)) : "nothing",
          source(s.source),
        ],
      })),
  },
  rubbers: {
    head: ["rubber", "", "what it is", "law", "shear modulus", "breaks at", "source"],
    text: [0, 2, 3, 6],
    rows: ({ rubbers }) =>
      rubbers.map((r) => ({
        name: r.name,
        said: { rubber: r.name },
        cells: [
          r.title,
          r.law,
          show("modulus", r.shear_modulus_mpa, 3),
          r.max_strain ? showRatio(r.max_strain, 3) : estimate("not measured"),
          source(r.source),
        ],
      })),
  },
};

const LISTED = /** @type {Kind[]} */ (Object.keys(LISTS));
const KINDS = LISTED.map((kind) => /** @type {[string, string]} */ ([kind, capital(kind)]));

/**
 * What of a sleeve no seller states.
 * @param {{ missing: string, stiffness_factor?: number | null }} s
 */
function estimated({ missing, stiffness_factor: factor }) {
  const what = missing
    .split(" ")
    .filter(Boolean)
    .map((word) => inWords(`\`${word}\``))
    .join(", ");
  return capital(
    [what, factor ? `stiffness within a factor of ${number(factor, 2)}` : ""]
      .filter(Boolean)
      .join("; "),
  );
}

/** Whether all words occur. @param {Row} row @param {string} find */
function fitsFilter({ name, cells }, find) {
  const text = [name, ...cells.map((cell) => (typeof cell === "string" ? cell : cell.textContent))];
  return find
    .toLowerCase()
    .split(/[\s,]+/)
    .every((word) => text.join(" ").toLowerCase().includes(word));
}

/** Whether a sleeve can have the diameter of the muscle. @param {Row} row */
function isFor({ low = 0, high = Infinity }) {
  const d = muscle.shown?.outer_diameter_mm ?? low;
  return d >= low - 1e-9 && d <= high + 1e-9;
}

/** A part in the muscle, where it can be there; else why not. @param {Row} row */
async function putInto(row) {
  const before = muscle.state;
  for (const [key, value] of Object.entries(row.said)) muscle.set(key, value);
  try {
    await muscle.look();
    return "";
  } catch (problem) {
    muscle.state = before;
    await muscle.look().catch(() => {});
    return inWords(problemOf(problem).message);
  }
}

/** @param {string} id @param {string} text @param {() => void} changed */
function check(id, text, changed) {
  const box = el("input", { type: "checkbox", id, onchange: changed });
  return { box, row: el("label", { for: id }, box, ` ${text}`) };
}

/** Which list is shown, and what is looked for: as it was left. */
const wanted = { kind: "tubes", find: "" };
/** @type {Promise<Parts> | undefined} */ let asked;
/** All parts, once. */
async function allParts() {
  const ask = (/** @type {Kind} */ kind) => answerTo("parts-list", { kind }),
    [tubes, { sleeves }, { rubbers }] = await Promise.all(LISTED.map(ask));
  return { ...tubes, sleeves, rubbers };
}

/** Parts in a window over the page. */
export function partsDialog() {
  const kind = choice("Show", KINDS, (name) => {
    wanted.kind = name;
    paint();
  });
  kind.set(wanted.kind);
  const find = textField({
    id: "parts-find",
    placeholder: "latex, silicone, 10 mm",
    value: wanted.find,
    oninput: () => {
      wanted.find = find.value.trim();
      paint();
    },
  });
  const fits = check("parts-fits", "fits the muscle's diameter", () => paint()),
    sold = check("parts-sold", "sold only", () => paint());
  const list = block("parts-list"),
    count = el("p", { class: "small soft", role: "status" }),
    filter = el("label", { for: "parts-find" }, "Filter");
  const fail = (/** @type {unknown} */ problem) => list.replaceChildren(problemBox(problem));
  /** @type {Parts | undefined} */ let parts;

  const matches = (/** @type {Row} */ row) =>
    fitsFilter(row, wanted.find) &&
    (!fits.box.checked || isFor(row)) &&
    !(sold.box.checked && wanted.kind === "tubes" && row.cells.includes("cast"));

  function paint() {
    sold.row.hidden = wanted.kind !== "tubes";
    fits.row.hidden = wanted.kind !== "sleeves";
    if (!parts) return;
    const { head, text, rows } = LISTS[/** @type {Kind} */ (wanted.kind)],
      all = rows(parts),
      shown = all.filter(matches);
    count.textContent = `${shown.length} of ${all.length} ${wanted.kind}. Values missing from data sheets are marked "estimated".`;
    const use = `Use this ${wanted.kind.slice(0, -1)}`;
    const put = (/** @type {Row} */ row) =>
      button(use, () => take(row), { ariaLabel: `${use}: ${row.name}` });
    const cells = shown.map((row) => [row.name, put(row), ...row.cells]);
    list.replaceChildren(table(head, cells, { text, label: wanted.kind }));
  }

  /** @param {Row} row */
  async function take(row) {
    const problem = await putInto(row);
    count.textContent = problem
      ? `${row.name} does not go into this muscle: ${problem}`
      : `${row.name} is in the muscle now.`;
    if (!problem) visit(document.body.dataset.page ?? "muscle", {});
  }

  const line = block(
    "parts-filter",
    kind.element,
    block("choice", filter, find),
    fits.row,
    sold.row,
  );
  dialog("Parts", () => [line, count, list]);
  asked ??= allParts();
  asked.then(
    (found) => {
      parts = found;
      paint();
    },
    (problem) => {
      asked = undefined;
      fail(problem);
    },
  );
}
