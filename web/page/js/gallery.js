// Muscles to begin with: files of the folder `examples`, with pictures that are drawn from them.
import { engine } from "./ask.js";
import { address } from "./address.js";
import { el } from "./dom.js";
import { pack } from "./deflate.js";
import { keepFile } from "./kept.js";
import { openPart } from "./library.js";
import { measured } from "./measured.js";
import { thumbnail } from "./thumbnail.js";
import { unitsInAddress } from "./units.js";

/**
 * A muscle of the gallery: its file, or its name in the library with its size; what it is, and the page that it is
 * shown on, with words of the address and files of that page.
 * @typedef {{ file?: string, part?: string, size?: number[], title: string, about: string, page?: string,
 *   words?: Record<string, string>, joint?: string, data?: string }} Entry
 */
/** @type {Entry[]} */
export const GALLERY = [
  { file: "prototype.toml", title: "Reference muscle (Antonelli 2018)", about: "30 mm, soft rubber, braid at 28°",
    words: { p: "2.5bar", e: "15%" } },
  { file: "tondu2012.toml", title: "Tondu 2012", about: "A slender hand-made muscle with measured friction",
    words: { p: "3bar", e: "10%" } },
  { part: "lib:dmsp-10-250", title: "Festo DMSP-10", about: "Industrial, 10 mm inside; identified from a test",
    size: [13, 1.25, 250, 26.6], words: { p: "5bar", e: "10%" } },
  { part: "lib:dmsp-20-300", title: "Festo DMSP-20", about: "Industrial, 20 mm inside; identified from a test",
    size: [23, 1.5, 300, 25], words: { p: "5bar", e: "10%" } },
  { file: "shop.toml", title: "From shop parts", about: "Latex hose in an expandable sleeve, made by hand",
    words: { p: "3bar", e: "10%" } },
  { file: "thin.toml", title: "A thin muscle", about: "2 mm, for fingers and bundles", words: { p: "1bar", e: "2%" } },
  { file: "biceps.toml", title: "An elbow", about: "Two muscles against each other on a pulley", page: "joint",
    joint: "elbow.toml", words: { p: "2bar", e: "12%" } },
  { file: "bench.toml", title: "A bench test, identified",
    about: "Measured points, and the constants that follow from them", page: "data", data: "bench.csv",
    words: { p: "2bar", e: "10%", free: "modulus" } },
];

/** @param {string} name */
export async function example(name) {
  const answer = await fetch(new URL(`../examples/${name}`, import.meta.url));
  if (!answer.ok) throw new Error(`The example ${name} cannot be loaded (${answer.status}).`);
  return answer.text();
}

/** Opens an entry: the address of its page with its muscle. @param {Entry} entry */
async function openEntry({ file = "", part, page = "muscle", words = {}, joint, data }) {
  if (part) return openPart(part, words);
  const [text, jointText, dataText] = await Promise.all([example(file), joint ? example(joint) : undefined,
    data ? example(data) : undefined]);
  if (data && dataText) {
    measured.set({ name: data, text: dataText });
    // Its constants are identified at once.
    keepFile("constants", true);
  }
  await Promise.all([text, jointText ?? ""].map(pack));
  location.hash = address(page, { ...words, u: unitsInAddress(), file: text, joint: jointText });
}

/** @typedef {Commands["check"]["answer"]} Shown */
/** What the engine says of the files, once. @type {Map<string, Promise<Shown>>} */ const asked = new Map();
/** @param {Entry} entry @returns {Promise<import("./thumbnail.js").Measures>} */
async function measures({ file = "", size: [D, s, L, angle] = [] }) {
  if (!file) return { outer_diameter_mm: D, wall_mm: s, length_mm: L, angle_deg: angle };
  const known = asked.get(file);
  if (known) return known;
  const answer = example(file).then((text) =>
    engine().ask("check", { muscle: { name: file, text }, only_data: true }, { lane: "read" })
  );
  answer.catch(() => asked.delete(file));
  asked.set(file, answer);
  return answer;
}

/**
 * Cards of all muscles; pictures are drawn after some milliseconds.
 * @param {(problem: unknown) => void} fail @param {() => void} [opened]
 */
export function gallery(fail, opened, wait = 0) {
  return el("div", { class: "gallery" }, ...GALLERY.map((entry) => {
    const picture = el("span", { class: "picture" });
    setTimeout(
      () => measures(entry).then((of) => picture.replaceChildren(thumbnail(of, undefined, entry.page)), () => {}),
      wait,
    );
    const open = () => openEntry(entry).then(() => opened?.(), fail);
    return el("button", { type: "button", class: "card", onclick: open }, picture, el("b", {}, entry.title),
      el("span", { class: "small soft" }, entry.about));
  }));
}
