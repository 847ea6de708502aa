// Parts that one can buy or cast: tubes, sleeves and rubbers; a button puts one into the muscle.
import { answerTo } from "./ask.js";
import { choice } from "./controls.js";
import { block, button, capital, dialog, el, folded, problemBox, table, textField } from "./dom.js";
import { problemOf } from "./engine/problem.js";
import { muscle, visit } from "./muscle.js";
import { inWords, number, show, showLength, showPressure, showRatio } from "./units.js";

/** @typedef {Commands["parts-list"]["answer"]} Parts */
/** @typedef {"tubes" | "sleeves" | "rubbers"} Kind */
/**
 * What a part says of the muscle: keys of the state. @typedef {Record<string, number | string>}
 * Said
 */
/** A part, and its row of the table. @typedef {{ part: Parts[Kind][number], said: Said, cells: (string | Node)[] }} Row */

const estimate = (/** @type {string} */ text) => el("span", { class: "estimated" }, text);
/**
 * A source that may be long.
 * @param {string | null | undefined} source @param {string | null | undefined} [note]
 */
const source = (source, note) => folded("Source", [source, note].filter(Boolean).join(" "));

/**
 * Headings, columns of text, and what a part says of the muscle with its cells.
 * @type {{ [K in Kind]: { head: string[], text: number[], row: (part: Parts[K][number]) => [Said,
 * ...(string | Node)[]] } }}
 */
const LISTS = {
  tubes: {
    head: ["tube", "", "inside", "outside", "wall", "rubber", "made", "price", "rated", "source"],
    text: [0, 5, 6, 7, 9],
    row: (t) => [
      { D: t.outer_diameter_mm, s: Number(t.wall_mm.toPrecision(12)), rubber: t.rubber },
      showLength(t.inner_diameter_mm),
      showLength(t.outer_diameter_mm),
      showLength(t.wall_mm, 3),
      t.rubber,
      t.is_cast ? "cast" : "sold",
      t.price ?? "–",
      showPressure(t.pressure_mpa, 3),
      source(t.source, t.note),
    ],
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
    row: (s) => [
      { braid: s.name },
      s.title,
      s.material,
      `${showLength(s.least_diameter_mm, 3)} to ${showLength(s.largest_diameter_mm, 3)}`,
      show("angle", s.least_angle_deg, 3),
      s.strands ? String(s.strands) : estimate("estimated"),
      s.missing || s.stiffness_factor ? estimate(estimated(s)) : "nothing",
      source(s.source),
    ],
  },
  rubbers: {
    head: ["rubber", "", "what it is", "law", "shear modulus", "breaks at", "source"],
    text: [0, 2, 3, 6],
    row: (r) => [
      { rubber: r.name },
      r.title,
      r.law,
      show("modulus", r.shear_modulus_mpa, 3),
      r.max_strain ? showRatio(r.max_strain, 3) : estimate("not measured"),
      source(r.source),
    ],
  },
};

const LISTED = /** @type {Kind[]} */ (Object.keys(LISTS));
const KINDS = LISTED.map((kind) => /** @type {[string, string]} */ ([kind, capital(kind)]));

/**
 * What of a sleeve no seller states.
 * @param {{ missing: string, stiffness_factor?: number | null }} s
 */
function estimated({ missing, stiffness_factor: factor }) {
  const what = missing.split(" ").flatMap((word) => (word ? inWords(`\`${word}\``) : []));
  return capital(
    [...what, ...(factor ? [`stiffness within a factor of ${number(factor, 2)}`] : [])].join(", "),
  );
}

/** Whether all words occur. @param {Row} row @param {string} find */
function fitsFilter({ part, cells }, find) {
  const text = [part.name, ...cells.map((c) => (typeof c === "string" ? c : c.textContent))];
  return find
    .toLowerCase()
    .split(/[\s,]+/)
    .every((word) => text.join(" ").toLowerCase().includes(word));
}

/** Whether a sleeve can have the diameter of the muscle. @param {Parts["sleeves"][number]} sleeve */
function isFor({ least_diameter_mm: low, largest_diameter_mm: high }) {
  const d = muscle.shown?.outer_diameter_mm ?? low;
  return d >= low - 1e-9 && d <= high + 1e-9;
}

/** A part in the muscle, where it can be there; else why not. @param {Said} said */
async function putInto(said) {
  const before = muscle.state;
  for (const [key, value] of Object.entries(said)) muscle.set(key, value);
  try {
    await muscle.look();
    return "";
  } catch (problem) {
    muscle.state = before;
    await muscle.look().catch(() => {});
    return inWords(problemOf(problem).message);
  }
}

/** The list that is shown, as it was left. */
/** @type {Kind} */ let shown = "tubes";
/** All parts. */
async function allParts() {
  const ask = (/** @type {Kind} */ kind) => answerTo("parts-list", { kind }),
    [tubes, { sleeves }, { rubbers }] = await Promise.all(LISTED.map(ask));
  return { ...tubes, sleeves, rubbers };
}

/** Parts in a window over the page. */
export function partsDialog() {
  const kind = choice("Show", KINDS, (name) => {
    shown = /** @type {Kind} */ (name);
    paint();
  });
  kind.set(shown);
  const find = textField({
    id: "parts-find",
    placeholder: "latex, sold, 10 mm",
    oninput: () => paint(),
  });
  const fits = el("input", { type: "checkbox", id: "parts-fits", onchange: () => paint() }),
    fitting = el("label", { for: fits.id }, fits, " fits the muscle's diameter");
  const list = block("parts-list"),
    count = el("p", { class: "small soft", role: "status" }),
    filter = el("label", { for: "parts-find" }, "Filter");
  /** @type {Parts | undefined} */ let parts;

  const matches = (/** @type {Row} */ row) =>
    fitsFilter(row, find.value.trim()) &&
    !("material" in row.part && fits.checked && !isFor(row.part));

  function paint() {
    fitting.hidden = shown !== "sleeves";
    if (!parts) return;
    const { head, text, row } = LISTS[shown],
      all = parts[shown].map((part) => {
        const [said, ...cells] = /** @type {(part: any) => ReturnType<typeof row>} */ (row)(part);
        return /** @type {Row} */ ({ part, said, cells });
      }),
      some = all.filter(matches);
    count.textContent = `${some.length} of ${all.length} ${shown}. Values missing from data sheets are marked "estimated".`;
    const use = `Use this ${shown.slice(0, -1)}`;
    const cells = some.map(({ part: { name }, said, cells }) => [
      name,
      button(use, () => take(name, said), { ariaLabel: `${use}: ${name}` }),
      ...cells,
    ]);
    list.replaceChildren(table(head, cells, { text, label: shown }));
  }

  /** @param {string} name @param {Said} said */
  async function take(name, said) {
    const problem = await putInto(said);
    count.textContent = problem
      ? `${name} does not go into this muscle: ${problem}`
      : `${name} is in the muscle now.`;
    if (!problem) visit(document.body.dataset.page ?? "muscle", {});
  }

  const line = block("parts-filter", kind.element, block("choice", filter, find), fitting);
  dialog("Parts", () => [line, count, list]);
  allParts().then(
    (found) => {
      parts = found;
      paint();
    },
    (problem) => list.replaceChildren(problemBox(problem)),
  );
}
