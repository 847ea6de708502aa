// Muscles to begin with: files of the folder `examples`, with pictures that are drawn from them.
import { address } from "./address.js";
import { block, el } from "./dom.js";
import { pack } from "./deflate.js";
import { keepFile } from "./kept.js";
import { openPart } from "./library.js";
import { measured } from "./measured.js";
import { card, thumbnail } from "./thumbnail.js";
import { unitsInAddress } from "./units.js";

/**
 * A muscle of the gallery: its file, or its name in the library; D0, s, L0 and the strand angle for its picture; what
 * it is, and the page that it is shown on, with words of the address and files of that page.
 * @typedef {[title: string, about: string, size: number[], of: { file?: string, part?: string, page?: string,
 *   words?: Words, joint?: string, data?: string }]} Entry
 */
/** @type {Entry[]} */
export const GALLERY = [
  [
    "Reference muscle (Antonelli 2018)",
    "30 mm, soft rubber, braid at 28°",
    [30, 3, 285, 28],
    {
      file: "prototype.toml",

      words: { p: "2.5bar", e: "15%" },
    },
  ],
  [
    "Tondu 2012",
    "A slender hand-made muscle with measured friction",
    [14, 0.49, 300, 20],
    {
      file: "tondu2012.toml",

      words: { p: "3bar", e: "10%" },
    },
  ],
  [
    "Festo DMSP-10",
    "Industrial, 10 mm inside",
    [13, 1.25, 250, 26.6],
    {
      part: "lib:dmsp-10-250",

      words: { p: "5bar", e: "10%" },
    },
  ],
  [
    "Festo DMSP-20",
    "Industrial, 20 mm inside",
    [23, 1.5, 300, 25],
    {
      part: "lib:dmsp-20-300",

      words: { p: "5bar", e: "10%" },
    },
  ],
  [
    "From shop parts",
    "Latex hose in an expandable sleeve",
    [9.525, 1.5875, 200, 14],
    {
      file: "shop.toml",

      words: { p: "3bar", e: "10%" },
    },
  ],
  [
    "A thin muscle",
    "2 mm, for fingers and bundles",
    [2, 0.4, 120, 18],
    {
      file: "thin.toml",

      words: { p: "1bar", e: "2%" },
    },
  ],
  [
    "An elbow",
    "Two muscles on a pulley",
    [20, 1.5, 220, 24],
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
    [20, 1.5, 200, 25],
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
  const answer = await fetch(new URL(`../examples/${name}`, import.meta.url));
  if (!answer.ok)
    throw new Error(`The example ${name} cannot be loaded (${answer.status}).`);
  return answer.text();
}

/** Opens an entry: the address of its page with its muscle. @param {Entry[3]} entry */
async function openEntry({
  file = "",
  part,
  page = "muscle",
  words = {},
  joint,
  data,
}) {
  if (part) return openPart(part, words);
  const [text, jointText, dataText] = await Promise.all([
    example(file),
    joint ? example(joint) : undefined,
    data ? example(data) : undefined,
  ]);
  if (data && dataText) {
    measured.set({ name: data, text: dataText });
    // Its constants are identified at once.
    keepFile("constants", true);
  }
  await Promise.all([text, jointText ?? ""].map(pack));
  location.hash = address(page, {
    ...words,
    u: unitsInAddress(),
    file: text,
    joint: jointText,
  });
}

/** Cards of muscles. @param {(problem: unknown) => void} fail @param {() => void} [opened] @param {Entry[]} [list] */
export const gallery = (fail, opened, list = GALLERY) =>
  block(
    "gallery",
    ...list.map(([title, about, size, entry]) => {
      const [outer_diameter_mm, wall_mm, length_mm, angle_deg] = size;
      const picture = thumbnail({
        outer_diameter_mm,
        wall_mm,
        length_mm,
        angle_deg,
      });
      return card(
        () => openEntry(entry).then(() => opened?.(), fail),
        el("span", {}, picture),
        title,
        about,
      );
    }),
  );
