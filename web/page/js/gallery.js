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
 * @typedef {{ file?: string, part?: string, size: number[], title: string, about: string, page?: string, words?: Words,
 *   joint?: string, data?: string }} Entry
 */
/** @type {Entry[]} */
export const GALLERY = [
  {
    file: "prototype.toml",
    size: [30, 3, 285, 28],
    title: "Reference muscle (Antonelli 2018)",
    about: "30 mm, soft rubber, braid at 28°",
    words: { p: "2.5bar", e: "15%" },
  },
  {
    file: "tondu2012.toml",
    size: [14, 0.49, 300, 20],
    title: "Tondu 2012",
    about: "A slender hand-made muscle with measured friction",
    words: { p: "3bar", e: "10%" },
  },
  {
    part: "lib:dmsp-10-250",
    size: [13, 1.25, 250, 26.6],
    title: "Festo DMSP-10",
    about: "Industrial, 10 mm inside; identified from a test",
    words: { p: "5bar", e: "10%" },
  },
  {
    part: "lib:dmsp-20-300",
    size: [23, 1.5, 300, 25],
    title: "Festo DMSP-20",
    about: "Industrial, 20 mm inside; identified from a test",
    words: { p: "5bar", e: "10%" },
  },
  {
    file: "shop.toml",
    size: [9.525, 1.5875, 200, 14],
    title: "From shop parts",
    about: "Latex hose in an expandable sleeve, made by hand",
    words: { p: "3bar", e: "10%" },
  },
  {
    file: "thin.toml",
    size: [2, 0.4, 120, 18],
    title: "A thin muscle",
    about: "2 mm, for fingers and bundles",
    words: { p: "1bar", e: "2%" },
  },
  {
    file: "biceps.toml",
    size: [20, 1.5, 220, 24],
    title: "An elbow",
    about: "Two muscles against each other on a pulley",
    page: "joint",
    joint: "elbow.toml",
    words: { p: "2bar", e: "12%" },
  },
  {
    file: "bench.toml",
    size: [20, 1.5, 200, 25],
    title: "A bench test, identified",
    about: "Measured points, and the constants that follow from them",
    page: "data",
    data: "bench.csv",
    words: { p: "2bar", e: "10%", free: "modulus" },
  },
];

/** @param {string} name */
export async function example(name) {
  const answer = await fetch(new URL(`../examples/${name}`, import.meta.url));
  if (!answer.ok)
    throw new Error(`The example ${name} cannot be loaded (${answer.status}).`);
  return answer.text();
}

/** Opens an entry: the address of its page with its muscle. @param {Entry} entry */
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
    ...list.map((entry) => {
      const {
        title,
        about,
        page,
        size: [outer_diameter_mm, wall_mm, length_mm, angle_deg],
      } = entry;
      const picture = thumbnail(
        { outer_diameter_mm, wall_mm, length_mm, angle_deg },
        undefined,
        page,
      );
      return card(
        () => openEntry(entry).then(() => opened?.(), fail),
        el("span", {}, picture),
        title,
        about,
      );
    }),
  );
