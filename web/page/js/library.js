// Muscles of the library: identified from measured points, each a button that opens it.
import { address } from "./address.js";
import { engine } from "./ask.js";
import {
  block,
  button,
  capital,
  download,
  el,
  heading,
  mainButton,
  rowOf,
} from "./dom.js";
import { muscle } from "./muscle.js";
import { fileName } from "./toml.js";
import { card, thumbnail } from "./thumbnail.js";
import { showForce, showLength, showPressure } from "./units.js";

/** @typedef {Commands["parts-list"]["answer"]["muscles"][number]} Entry */

/** Opens one on the page Muscle. @param {string} name @param {Record<string, string>} [at] words of its point */
export async function openPart(name, at = {}) {
  const { muscle: found } = await engine().ask("parts-show", { name });
  const called = found?.product
    ? `${found.product} (${found.title})`
    : found?.title;
  await muscle.take(found?.muscle_file.text ?? "", name, called);
  location.hash = address("muscle", { ...muscle.params(), ...at });
}

/**
 * What to do with a muscle file that was made: it becomes the muscle, or is saved.
 * @param {string} file @param {string} put @param {string} keep labels of the buttons @param {string} name of the file
 */
export const muscleButtons = (file, put, keep, name) =>
  rowOf(
    mainButton(put, async () => {
      await muscle.take(file);
      location.hash = address("muscle", muscle.params());
    }),
    button(keep, () =>
      download(fileName(name, ".toml"), file, "application/toml"),
    ),
  );

/** @param {Entry} entry @param {() => void} opened @param {(problem: unknown) => void} fail */
function entryCard(entry, opened, fail) {
  const { name, blocked_force_n: force } = entry;
  const pull = force
    ? `, ${showForce(force)} blocked at ${showPressure(entry.pressure_mpa, 3)}`
    : "";
  const size = `D0 ${showLength(entry.outer_diameter_mm, 3)}, L0 ${showLength(entry.length_mm)}`;
  const box = card(
    () => openPart(name).then(opened, fail),
    el("span", {}, thumbnail(entry)),
    capital(entry.product ?? entry.title),
    `${size}${pull}`,
  );
  box.title = `${name}: ${entry.source}; ${entry.terms}`;
  return box;
}

/** Buttons of all muscles of the library. @param {(problem: unknown) => void} fail @param {() => void} opened */
export function library(fail, opened) {
  const box = block(
    "gallery",
    el("span", { class: "small soft" }, "The library is being read."),
  );
  engine()
    .ask("parts-list", { kind: "muscles" })
    .then(
      ({ muscles }) =>
        box.replaceChildren(
          ...muscles.map((entry) => entryCard(entry, opened, fail)),
        ),
      fail,
    );
  return block("", heading("Identified from measured points"), box);
}
