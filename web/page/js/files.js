// The muscle as files: a report, what the workshop needs, code for controllers and simulators, and
// files of finite-element programs.
import { engine } from "./ask.js";
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
  smallPrint,
} from "./dom.js";
import { fieldsOf, form, job, warnings } from "./form.js";
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

/**
 * One kind of files: a form, and work whose answer it shows.
 * @template {keyof Commands} K @param {string} title @param {string} about @param {Field[]} fields
 * @param {string} writes names of the files
 * @param {[label: string, command: K]} work its button, and what it asks
 * @param {(read: Read) => Commands[K]["request"]} request
 * @param {(answer: Commands[K]["answer"]) => (Node | string)[] | Promise<(Node | string)[]>} shown
 */
function card(title, about, writes, fields, [label, command], request, shown) {
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
    async (answer) => done.replaceChildren(...(await shown(answer))),
    { fields: asked, minor: title !== "Workshop" },
  );
  return {
    form: asked,
    element: el(
      "section",
      { class: "card-of-files", ariaLabel: title },
      heading(title),
      faded(about),
      smallPrint("Writes ", el("b", writes)),
      asked.element,
      go.element,
      done,
    ),
  };
}

/** The units that people read. */
const readUnits = () => ["pressure", "force", "length"].map(unitName).join(",");

/** The muscle at its pressure, where it has one. */
const atPressure = () => ({ pressure_mpa: muscle.p || undefined, muscle: muscle.fields() });

const report = () =>
  card(
    "Report",
    "Title block, state, curves, drawing, margins of safety, and a sheet for the first bench test.",
    "report.html, one file",
    TITLE,
    ["Make the report", "build"],
    (read) => ({
      ...atPressure(),
      contraction: muscle.e,
      name: muscle.name,
      ...read,
      report: true,
      units: readUnits(),
    }),
    async (answer) => {
      const html = await withViewer(
        answer.files.find(({ name }) => name === "report.html")?.text ?? "",
      );
      const name = fileName(muscle.name, "-report.html"),
        save = () => download(name, html);
      return [
        warnings(answer.warnings),
        paragraph(
          button(`Save ${name}`, save),
          " ",
          el(
            "span",
            { class: "soft" },
            `${size(html.length)}; open it in a browser, and print it there.`,
          ),
        ),
      ];
    },
  );

/** Cut list, drawing, plugs, steps and test sheet. */
const workshop = () =>
  card(
    "Workshop",
    "Cut list, plugs to print or turn, drawing, bill of materials, steps, and the sheet of the first test.",
    "build-sheet.pdf, drawing.pdf, plugs (STEP, STL), bom.csv, test-record.pdf, muscle.toml",
    [],
    ["Make the build sheet", "build"],
    () => ({ ...atPressure(), units: readUnits() }),
    (answer) => {
      const [at, proof] = [answer.pressure_mpa, answer.proof_pressure_mpa].map((p) =>
        showPressure(p, 3),
      );
      const cut = `At ${at}: cut ${showLength(answer.cut.tube_mm)} of tube. Proof test with water at ${proof}.`;
      return [
        paragraph(cut),
        warnings(answer.warnings),
        filesView(
          answer.files.map((file) =>
            file.name === "muscle.toml"
              ? { ...file, text: named(file.text ?? "", muscle.given) }
              : file,
          ),
          fileName(muscle.name, "-build"),
        ),
      ];
    },
  );

/**
 * Errors of an export, as shares of the blocked force. @param {Commands["export"]["answer"]} answer
 */
function errorLine(answer) {
  const share = (/** @type {number} */ x) => showRatio(x, 2);
  return (
    `${share(answer.force_rms)} rms and ${share(answer.force_worst_ratio)} at worst of the blocked force ` +
    `${showForce(answer.blocked_force_n)}, up to ` +
    `${showPressure(answer.supply_pressure_mpa, 3)} and ${showRatio(answer.contraction_high, 3)}; volume ` +
    `${share(answer.volume_worst_ratio)} at worst. Against ${answer.model}; as built ± ` +
    `${showForce(answer.uncertainty_n, 2)}.`
  );
}

/** Code. */
const code = () =>
  card(
    "Controllers and simulators",
    "One closed form of pull and volume, fitted to the finite elements, in the language of its host.",
    "a folder of sources for the target, with its README",
    BOX,
    ["Export", "export"],
    (read) => ({
      ...atPressure(),
      ...read,
      target: read.target,
      name: muscle.given ? fileName(muscle.given, "").replace(/\W/g, "_") : undefined,
    }),
    (answer) => [
      paragraph(`Error: ${errorLine(answer)}`),
      warnings(answer.warnings),
      filesView(answer.files, `${answer.name}-${answer.target}`),
    ],
  );

/** The deformed muscle for other programs. */
const elements = () =>
  card(
    "Finite elements",
    "The deformed muscle at the present pressure and contraction for ParaView (VTU). fe3d also writes the input deck of " +
      "the test for CalculiX and Abaqus.",
    "muscle.vtu and muscle.pvd; with fe3d muscle.inp too",
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
    (answer) => {
      const deck = answer.deck
        ? [
            {
              name: "muscle.inp",
              about: "mesh, material, loads and steps for CalculiX and Abaqus",
              text: answer.deck,
            },
          ]
        : [];
      return [
        warnings([...answer.notes, ...answer.warnings]),
        filesView([...(answer.files ?? []), ...deck], fileName(muscle.name, `-${answer.model}`)),
      ];
    },
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
  engine()
    .ask("export-list", {})
    .then(
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

/** @param {number} bytes */
const size = (bytes) => `${number(bytes / 1e3, 3)} kB`;

/** @param {readonly File[]} files @param {string} archive its name without the ending */
export function filesView(files, archive) {
  const all = files.map((file) => ({ name: file.name, about: file.about, bytes: bytesOf(file) }));
  const rows = all.map(({ name, about, bytes }) =>
    el(
      "li",
      button(name, () => download(name, bytes)),
      ` ${about} `,
      el("span", { class: "soft" }, size(bytes.length)),
    ),
  );
  const every = () =>
    download(
      `${archive}.zip`,
      zipSync(Object.fromEntries(all.map(({ name, bytes }) => [name, bytes])), {
        level: 0,
        mtime: "1980-01-02",
      }),
    );
  return block(
    "files",
    el("ul", { class: "plain" }, ...rows),
    files.length > 1 && paragraph(button(`All files (${archive}.zip)`, every)),
  );
}
