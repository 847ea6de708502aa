// Muscles of the library: identified from measured points, each a button that opens it.
import { address } from "./address.js";
import { engine } from "./ask.js";
import { capital, el } from "./dom.js";
import { muscle } from "./muscle.js";
import { thumbnail } from "./thumbnail.js";
import { show, withUncertainty } from "./units.js";

/** @typedef {Commands["parts-list"]["answer"]["muscles"][number]} Entry */

/** Opens one on the page Muscle. @param {string} name @param {Record<string, string>} [at] words of its point */
export async function openPart(name, at = {}) {
  const { muscle: found } = await engine().ask("parts-show", { name });
  const called = found?.product ? `${found.product} (${found.title})` : found?.title;
  await muscle.take(found?.muscle_file.text ?? "", name, called);
  location.hash = address("muscle", { ...muscle.params(), ...at });
}

/** @param {Entry} entry @param {() => void} opened @param {(problem: unknown) => void} fail */
function card(entry, opened, fail) {
  const { name, blocked_force_n: force, uncertainty_n: half } = entry;
  const pull = force && half
    ? `, ${withUncertainty("force", force, half)} blocked at ${show("pressure", entry.pressure_mpa, 3)}`
    : "";
  const size = `D0 ${show("length", entry.outer_diameter_mm, 3)}, L0 ${show("length", entry.length_mm)}`;
  return el("button", { type: "button", class: "card", title: `${entry.source}; ${entry.terms}`,
    onclick: () => openPart(name).then(opened, fail) },
    el("span", { class: "picture" }, thumbnail(entry)), el("b", {}, capital(entry.product ?? entry.title)),
    el("span", { class: "small soft" }, `${name}: ${size}${pull}`));
}

/** Buttons of all muscles of the library. @param {(problem: unknown) => void} fail @param {() => void} opened */
export function library(fail, opened) {
  const box = el("div", { class: "gallery" }, el("span", { class: "small soft" }, "The library is being read."));
  engine().ask("parts-list", { kind: "muscles" }).then(
    ({ muscles }) => box.replaceChildren(...muscles.map((entry) => card(entry, opened, fail))),
    fail,
  );
  return el("div", {}, el("h2", {}, "Identified from measured points"), box);
}
