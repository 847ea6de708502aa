// Muscles to begin with: files of the folder `examples`, with pictures that are drawn from them.
import { address } from "./address.js";
import {
  block,
  button,
  capital,
  dialog,
  download,
  el,
  heading,
  mainButton,
  problemBox,
  rowOf,
} from "./dom.js";
import { takeFiles } from "./drop.js";
import { TABLES, fileInput } from "./controls.js";
import { keepFile, measured } from "./kept.js";
import { SCRIPTS } from "./place.js";
import { card, thumbnail } from "./thumbnail.js";
import { showForce, showLength, showPressure, unitsInAddress } from "./units.js";
import { answerTo } from "./ask.js";
import { muscle, visit } from "./muscle.js";
import { fileName } from "./toml.js";

/**
 * A muscle of the gallery: its file; D0, L0 and the strand angle for
 * its picture; what it is, and the page that it is shown on, with words of the address and files of
 * that page.
 * @typedef {[title: string, about: string, size: number[], of: { file: string, page?: string,
 *   words?: Words, joint?: string, data?: string }]} Entry
 */
/** @type {Entry[]} */
export const GALLERY = [
  [
    "Reference muscle (Antonelli 2018)",
    "30 mm, soft rubber, braid at 28°",
    [30, 285, 28],
    {
      file: "prototype.toml",

      words: { p: "2.5bar", e: "15%" },
    },
  ],
  [
    "Tondu 2012",
    "A slender hand-made muscle with measured friction",
    [14, 300, 20],
    {
      file: "tondu2012.toml",

      words: { p: "3bar", e: "10%" },
    },
  ],
  [
    "From shop parts",
    "Latex hose in an expandable sleeve",
    [9.525, 200, 14],
    {
      file: "shop.toml",

      words: { p: "3bar", e: "10%" },
    },
  ],
  [
    "A thin muscle",
    "2 mm, for fingers and bundles",
    [2, 120, 18],
    {
      file: "thin.toml",

      words: { p: "1bar", e: "2%" },
    },
  ],
  [
    "An elbow",
    "Two muscles on a pulley",
    [20, 220, 24],
    {
      file: "biceps.toml",

      page: "joint",
      joint: "elbow.toml",
      words: { p: "2bar", e: "12%" },
    },
  ],
  [
    "A bench test, identified",
    "Measured points, and the constants that follow from them",
    [20, 200, 25],
    {
      file: "bench.toml",

      page: "data",
      data: "bench.csv",
      words: { p: "2bar", e: "10%", free: "modulus" },
    },
  ],
];

/** @param {string} name */
export async function example(name) {
  const answer = await fetch(new URL(`../examples/${name}`, SCRIPTS));
  if (!answer.ok) throw new Error(`The example ${name} cannot be loaded (${answer.status}).`);
  return answer.text();
}

/** Opens an entry: the address of its page with its muscle. @param {Entry[3]} entry */
async function openEntry({ file, page = "muscle", words = {}, joint, data }) {
  const text = await example(file);
  if (data) {
    measured.set({ name: data, text: await example(data) });
    // Its constants are identified at once.
    keepFile("constants", true);
  }
  const own = joint && { joint: await example(joint) };
  location.hash = address(page, { ...words, ...own, u: unitsInAddress(), file: text });
}

/**
 * Cards of muscles.
 * @param {(problem: unknown) => void} fail @param {() => void} [opened] @param {Entry[]} [list]
 */
export const gallery = (fail, opened, list = GALLERY) =>
  block(
    "gallery",
    ...list.map(([title, about, size, entry]) => {
      const [outer_diameter_mm, length_mm, angle_deg] = size,
        picture = thumbnail({ outer_diameter_mm, length_mm, angle_deg });
      return card(() => openEntry(entry).then(() => opened?.(), fail), picture, title, about);
    }),
  );

// Muscles of the library: identified from measured points, each a button that opens it.
/**
 * @typedef {Commands["parts-list"]["answer"]["muscles"][number]} Identified a muscle of the library
 */

/** Opens one on the page Muscle. @param {string} name */
async function openPart(name) {
  const { muscle: found } = await answerTo("parts-show", { name });
  const called = found?.product ? `${found.product} (${found.title})` : found?.title;
  await muscle.take(found?.muscle_file.text ?? "", name, called);
  visit("muscle", {});
}

/**
 * What to do with a muscle file that was made: it becomes the muscle, or is saved.
 * @param {string} file @param {string} put @param {string} keep labels of the buttons
 * @param {string} name of the file
 */
export const muscleButtons = (file, put, keep, name) =>
  rowOf(
    mainButton(put, async () => {
      await muscle.take(file);
      visit("muscle", {});
    }),
    button(keep, () => download(fileName(name, ".toml"), file)),
  );

/**
 * @param {Identified} entry @param {(() => void) | undefined} opened
 * @param {(problem: unknown) => void} fail
 */
function entryCard(entry, opened, fail) {
  const { name, blocked_force_n: force } = entry;
  const pull = force
    ? `, ${showForce(force)} blocked at ${showPressure(entry.pressure_mpa, 3)}`
    : "";
  const size = `D0 ${showLength(entry.outer_diameter_mm, 3)}, L0 ${showLength(entry.length_mm)}`;
  const box = card(
    () => openPart(name).then(opened, fail),
    thumbnail(entry),
    capital(entry.product ?? entry.title),
    `${size}${pull}`,
  );
  box.title = `${name}: ${entry.source}; ${entry.terms}`;
  return box;
}

/**
 * Buttons of all muscles of the library.
 * @param {(problem: unknown) => void} fail @param {() => void} [opened]
 */
export function library(fail, opened) {
  const box = block("gallery", el("span", { class: "small soft" }, "The library is being read."));
  answerTo("parts-list", { kind: "muscles" }).then(
    ({ muscles }) => box.replaceChildren(...muscles.map((entry) => entryCard(entry, opened, fail))),
    fail,
  );
  return block("", heading("Identified from measured points"), box);
}

/** Open: a file of any kind, a muscle of the gallery or of the library. */
export function openDialog() {
  dialog("Open a muscle", (close) => {
    const said = block();
    const fail = (/** @type {unknown} */ problem) => said.replaceChildren(problemBox(problem));
    const open = (/** @type {File[]} */ files) => {
      close();
      takeFiles(files);
    };
    const input = fileInput("Files", `.toml,.json,${TABLES}`, open, true);
    return [
      rowOf(
        mainButton("Choose files", () => input.click()),
        input,
        el(
          "span",
          { class: "small soft" },
          "A muscle, a joint or a drive (TOML), measured points (CSV, XLSX, ODS), or a formula (JSON). You can also drop files " +
            "anywhere on the page.",
        ),
      ),
      said,
      gallery(fail, close),
      library(fail, close),
    ];
  });
}
