// The muscle as files: a report, what the workshop needs, code for controllers and simulators, and
// files of finite-element programs.
import { answerTo } from "./ask.js";
import {
  block,
  button,
  dialog,
  download,
  el,
  faded,
  heading,
  paragraph,
  remark,
  warnings,
} from "./dom.js";
import { fieldsOf, form, job } from "./form.js";
import { keepWords, wordsOf } from "./kept.js";
import { muscle } from "./muscle.js";
import { fileName, named } from "./toml.js";
import { withViewer } from "./report.js";
import { number, showForce, showLength, showPressure, showRatio, unitName } from "./units.js";
import { zipSync } from "./vendor/fflate.js";

/** @typedef {Commands["export-list"]["answer"]["targets"][number]} Target */
/** What a report states of itself; the name is that of the muscle. @type {Field[]} */
export const TITLE = fieldsOf([
  ["project", "project", "Project"],
  ["number", "number", "Number"],
  ["revision", "revision", "Revision"],
  ["date", "date", "Date"],
]);
/** Where a form for controllers is fitted. @type {Field[]} */
export const BOX = fieldsOf([
  ["target", "target", "Target", { value: "c", options: [["c", "c"]] }],
  ["supply", "pressure_mpa", "Pressure of the supply", "pressure"],
  ["elow", "contraction_low", "Contraction from", "ratio", { hint: "−5 %" }],
  ["ehigh", "contraction_high", "Contraction to", "ratio", { hint: "free contraction" }],
]);
/** @type {Field[]} */
export const ELEMENTS = fieldsOf([
  [
    "elements",
    "model",
    "Model",

    {
      value: "fe",
      options: [
        ["fe", "fe: axisymmetric, quick"],
        ["fe3d", "fe3d: three-dimensional, with input deck"],
      ],
    },
  ],
]);

/** What an answer leads to: sentences, files, and the name of an archive of them. */
/** @typedef {{ said?: string, warned: Parameters<typeof warnings>[0], files: readonly File[], name: string }} Made */
/**
 * One kind of files: what it writes, a form, and work whose files it offers.
 * @template {keyof Commands} K @param {string} title @param {string} writes @param {Field[]} fields
 * @param {[label: string, command: K]} work its button, and what it asks
 * @param {(read: Read) => Commands[K]["request"]} request
 * @param {(answer: Commands[K]["answer"]) => Made | Promise<Made>} made
 */
function card(title, writes, fields, [label, command], request, made) {
  const asked = form(fields, () => go.run()),
    done = block();
  const go = job(
    label,
    command,
    async () => {
      const read = await asked.read();
      done.replaceChildren();
      return read && request(read);
    },
    async (answer) => {
      const { said = "", warned, files, name } = await made(answer);
      done.replaceChildren(paragraph(said), warnings(warned), filesView(files, name));
    },
    { fields: asked, minor: title !== "Workshop" },
  );
  const parts = [heading(title), faded(`Writes ${writes}.`), asked.element, go.element, done];
  return {
    form: asked,
    element: el("section", { class: "card-of-files", ariaLabel: title }, ...parts),
  };
}

/** The muscle at its pressure, where it has one, in the units that people read. */
const atPressure = () => ({ pressure_mpa: muscle.p || undefined, muscle: muscle.fields() });
const units = () => ["pressure", "force", "length"].map(unitName).join(",");

const report = () =>
  card(
    "Report",
    "one HTML file: title block, state, curves, drawing, margins of safety, a first bench test",
    TITLE,
    ["Make the report", "build"],
    (read) => ({
      ...atPressure(),
      contraction: muscle.e,
      name: muscle.name,
      ...read,
      report: true,
      units: units(),
    }),
    async ({ files, warnings: warned }) => {
      const [html] = files.filter(({ name }) => name === "report.html"),
        text = await withViewer(html.text ?? ""),
        name = fileName(muscle.name, "-report.html");
      return { warned, files: [{ name, about: "to read and print in a browser", text }], name };
    },
  );

const workshop = () =>
  card(
    "Workshop",
    "order, drawings, steps and record (HTML), plugs (STEP, STL), test sheet, muscle file",
    [],
    ["Make the build sheet", "build"],
    () => ({ ...atPressure(), units: units() }),
    (answer) => ({
      said: `At ${showPressure(answer.pressure_mpa, 3)}: cut ${showLength(answer.cut.tube_mm)} of tube.`,
      warned: answer.warnings,
      files: answer.files.map((file) =>
        file.name === "muscle.toml"
          ? { ...file, text: named(file.text ?? "", muscle.given) }
          : file,
      ),
      name: fileName(muscle.name, "-build"),
    }),
  );

/**
 * Errors of an export, as shares of the blocked force. @param {Commands["export"]["answer"]} answer
 */
function errorLine(answer) {
  const share = (/** @type {number} */ x) => showRatio(x, 2);
  return (
    `Error: ${share(answer.force_rms)} rms, ${share(answer.force_worst_ratio)} at worst of the blocked ` +
    `force ${showForce(answer.blocked_force_n)}, up to ${showPressure(answer.supply_pressure_mpa, 3)} ` +
    `and ${showRatio(answer.contraction_high, 3)}; volume ${share(answer.volume_worst_ratio)} at ` +
    `worst. Allowed up to ${showPressure(answer.allowed_pressure_mpa, 3)}.`
  );
}

const code = () =>
  card(
    "Controllers and simulators",
    "sources: one closed form of pull and volume, fitted to the finite elements",
    BOX,
    ["Export", "export"],
    (read) => ({
      ...atPressure(),
      ...read,
      target: read.target,
      name: muscle.given ? fileName(muscle.given, "").replace(/\W/g, "_") : undefined,
    }),
    (answer) => ({
      said: errorLine(answer),
      warned: answer.warnings,
      files: answer.files,
      name: `${answer.name}-${answer.target}`,
    }),
  );

const elements = () =>
  card(
    "Finite elements",
    "the deformed muscle of this state for ParaView (VTU); fe3d also the deck for CalculiX and Abaqus",
    ELEMENTS,
    ["Compute", "simulate"],
    ({ model }) => ({
      muscle: muscle.fields(),
      test: "isometric",
      model: { name: model },
      two_sided: true,
      pressures_mpa: [muscle.p],
      contractions: [muscle.e],
      vtu: true,
      deck: model === "fe3d",
    }),
    ({ deck, files = [], notes, warnings: warned, model }) => ({
      warned: [...notes, ...warned],
      files: [
        ...(files ?? []),
        ...(deck
          ? [{ name: "muscle.inp", about: "mesh, material, loads and steps", text: deck }]
          : []),
      ],
      name: fileName(muscle.name, `-${model}`),
    }),
  );

/** All kinds of files in a window over the page. */
export function filesDialog() {
  const cards = [workshop(), report(), code(), elements()],
    forms = cards.map((c) => c.form),
    box = cards[2].form,
    about = remark();
  /** @type {readonly Target[]} */ let targets = [];
  box.element.prepend(about);
  function paint() {
    const one = targets.find(({ name }) => name === box.text("target"));
    about.textContent = one ? `${one.about}. Needs ${one.needs}. Loses ${one.loses}.` : "";
    box.usual("supply", muscle.p ? showPressure(muscle.p) : "");
  }
  const element = block("cards-of-files", ...cards.map((c) => c.element));
  forms.forEach((f) => f.set(new URLSearchParams(wordsOf("files"))));
  element.addEventListener("change", () => {
    keepWords("files", Object.assign({}, ...forms.map((f) => f.texts())));
    paint();
  });
  dialog("Build & export", () => [element]);
  answerTo("export-list", {}).then(
    (answer) => {
      targets = answer.targets;
      box.options(
        "target",
        targets.map(({ name }) => name),
      );
      box.put("target", wordsOf("files").target || "c");
      paint();
    },
    () => {},
  );
  paint();
}

// Files that the engine made: each as a download, and all of them in one archive.
/** @typedef {Commands["build"]["answer"]["files"][number]} File */

/** @param {File} file @returns {Uint8Array<ArrayBuffer>} */
const bytesOf = ({ text, base64 }) =>
  typeof text === "string"
    ? new TextEncoder().encode(text)
    : Uint8Array.from(atob(base64 ?? ""), (c) => c.charCodeAt(0));

/** @param {readonly File[]} files @param {string} archive its name without the ending */
function filesView(files, archive) {
  const all = files.map((file) => [file.name, bytesOf(file)]);
  const rows = files.map(({ name, about }, i) =>
    el(
      "li",
      button(name, () => download(name, all[i][1])),
      ` ${about}, ${number(all[i][1].length / 1e3, 3)} kB`,
    ),
  );
  const every = () =>
    download(`${archive}.zip`, zipSync(Object.fromEntries(all), { level: 0, mtime: "1980-01-02" }));
  return block(
    "files",
    el("ul", { class: "plain" }, ...rows),
    files.length > 1 && paragraph(button(`All files (${archive}.zip)`, every)),
  );
}
