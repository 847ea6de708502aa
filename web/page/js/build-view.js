// What the workshop needs of a muscle: lengths to cut, pressures of the proof test, and the files of the build sheet.
import { engine } from "./ask.js";
import { capital, el } from "./dom.js";
import { filesView } from "./files-view.js";
import { muscle } from "./muscle.js";
import { fileName } from "./toml.js";
import { show } from "./units.js";
import { inWords } from "./words.js";

/** Of the muscle of the page, at its pressure. @param {HTMLElement} box */
export async function build(box) {
  box.replaceChildren(el("p", { class: "soft" }, "…"));
  await muscle.ready;
  const request = { ...muscle.fields(), ...(muscle.p > 0 ? { pressure_mpa: muscle.p } : {}) };
  const answer = await engine().ask("build", request, { lane: "side" });
  const [at, proof] = [show("pressure", answer.pressure_mpa, 3), show("pressure", answer.proof_pressure_mpa, 3)];
  const cut = show("length", answer.cut.tube_mm);
  const notes = answer.warnings.map((w) => el("li", {}, capital(inWords(/** @type {string} */ (w)))));
  box.replaceChildren(
    el("p", {}, `At ${at}: cut ${cut} of tube. Proof test with water at ${proof}.`),
    el("ul", { class: "warnings" }, ...notes), filesView(answer.files, fileName(muscle.name, "-build")));
}
