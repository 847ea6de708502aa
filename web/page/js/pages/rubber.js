// Laws of rubber from a test of it: constants, curves with the points, and the muscle with that
// rubber.
import { columnLine, grid } from "../columns.js";
import { TABLES, fileField } from "../controls.js";
import { bench, block, folded, heading, paragraph, remark, table, warnings } from "../dom.js";
import { Figures } from "../figure.js";
import { fieldsOf, form, job } from "../form.js";
import { example, muscleButtons } from "../gallery.js";
import { fileOf, keepFile, keepWords } from "../kept.js";
import { muscle } from "../muscle.js";
import { number, show } from "../units.js";
import { signal, watch } from "../watch.js";

/** @typedef {Commands["rubber"]["answer"]} Answer */
/** @typedef {Answer["laws"][number]} Law */
/** @type {Field[]} */
export const FIELDS = fieldsOf([
  ["laws", "laws", "Laws", { words: true, hint: "all" }],
  ["set", "set", "Constants of the table", { words: true, hint: "area 8 mm², gauge length 25 mm" }],
  ["upto", "up_to_stretch", "Up to a stretch of", "number", { hint: "all points" }],
  [
    "stable",
    "stable",
    "In a muscle",

    {
      value: "",
      options: [
        ["", "fit as the points are"],
        ["yes", "only what stays stable"],
      ],
    },
  ],
  ["called", "name", "Name of the rubber", { hint: "that of the table" }],
]);
const EXAMPLE = "treloar.csv";
/** A constant as the engine reads it: `gauge length 25 mm`. @param {string} text */
const keyed = (text) => text.replace(/\s+(?=[\d.])/, "=").replace(/^(\w+) (?=\w+=)/, "$1_");

/** A law in a row. @param {Law} law @param {Answer} answer */
function row(law, answer) {
  const best = law.stable && law.name === answer.recommended;
  const constant = (/** @type {Law["parameters"][number]} */ p) => {
    const half = p.standard_error ? ` ± ${number(1.96 * p.standard_error, 2)}` : "",
      what = best ? `${p.meaning.split(":")[0]} ` : "";
    return `${what}${p.name} ${number(p.value, 4)}${half} ${p.unit}`.trim();
  };
  const fitted = law.constrained ? "kept stable" : law.stable ? "" : "unstable in a muscle";
  return [
    law.name,
    law.parameters.map(constant).join(", "),
    show("modulus", law.shear_modulus_mpa, 3),
    show("modulus", law.rms_mpa, 2),
    number(law.r_squared, 5),
    best ? "recommended" : fitted,
  ];
}

/** @type {Mount} */
export const mount = (main) => {
  /** @type {Signal<Answer | undefined>} */ const found = signal();
  let data = fileOf("rubber");
  const fields = form(FIELDS, () => fit.run()),
    figures = new Figures("rubber");
  const cells = grid(["stretch", "stress [MPa]"], (text) => take(data?.name ?? "typed.csv", text));
  const understood = paragraph(),
    laws = block();
  const fit = job(
    "Fit",
    "rubber",
    async () => {
      const read = await fields.read();
      if (!read) return;
      keepWords("rubber", fields.texts());
      // Until there is a table of one's own the page shows what it does.
      data ??= { name: EXAMPLE, text: await example(EXAMPLE) };
      cells.show(data.text);
      const { stable, set, ...rest } = read,
        file = { name: "muscle.toml", text: await muscle.file() };
      return {
        ...rest,
        set: set?.map(keyed),
        stable: stable === "yes",
        data: [data],
        muscle: file,
        figure: true,
      };
    },
    (answer) => {
      found.value = answer;
      figures.show(answer.figure);
    },
    { fields, shown: [laws, figures.element], minor: true },
  );
  main.replaceChildren(
    bench(
      "Rubber test",
      [
        heading("Rubber test"),
        fileField("Open a table (CSV, XLSX, ODS)", TABLES, (name, text) => take(name, text)),
        remark(
          "A test of rubber: stretches or strains with stresses, or extensions with forces of a specimen.",
        ),
        cells.element,
        folded("Advanced", fields.element),
        fit.element,
      ],
      [understood, laws, figures.element],
    ),
  );

  /** @param {string} name @param {string} text */
  function take(name, text) {
    data = { name, text };
    keepFile("rubber", data);
    return fit.run();
  }
  watch(() => {
    const answer = found.value;
    if (!answer) return;
    const file = answer.muscle_file;
    understood.textContent =
      `${fileOf("rubber") ? "" : "An example, Treloar (1944): "}${answer.understood.map(({ data }) => data).join(", ")}: ${answer.points} points up to a ` +
      `stretch of ${number(answer.fitted_to_stretch, 3)}. ${columnLine(answer.understood[0].columns)}`;
    const head = ["law", "constants (± 95 %)", "shear modulus", "rms", "R²", ""];
    laws.replaceChildren(
      heading(answer.recommended ? `Recommended: ${answer.recommended}` : "No law is stable"),
      table(
        head,
        answer.laws.map((law) => row(law, answer)),
        { text: [0, 1, 5], label: "laws of the rubber" },
      ),
      warnings([...answer.warnings, ...answer.failed]),
      file
        ? muscleButtons(
            file,
            "Put the rubber into the muscle",
            "Save the muscle with it",
            muscle.name,
          )
        : "",
    );
  });
  return {
    async load(params) {
      await muscle.read(params, fields.keys);
      fields.set(params);
      data = fileOf("rubber");
      await fit.run();
    },
  };
};
