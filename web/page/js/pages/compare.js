// The muscle beside another one, or beside another model of it: B is the same muscle, or that of a
// file, with what is said over it.
import { Slot } from "../ask.js";
import { chartOf, KINDS, isobars } from "../chart.js";
import { fileField } from "../controls.js";
import { block, button, capital, dim, el, folded, heading, problemBox, remark } from "../dom.js";
import { fieldsOf, form, table, warnings } from "../form.js";
import { muscle } from "../muscle.js";
import {
  QUANTITIES,
  STIFFNESS,
  STIFFNESS_NAMES,
  STRANDS,
  missing,
  shownValue,
  side as asked,
} from "../state.js";
import {
  asBuilt,
  braidName,
  forceAxis,
  number,
  partName,
  ratioAxis,
  show,
  showForce,
  showLength,
  showPressure,
  showRatio,
} from "../units.js";
import { signal, watch } from "../watch.js";
import { keepWords } from "../kept.js";
import { viewOf } from "../view3d.js";
import { pack } from "../address.js";

const MODELS = /** @type {[string, string][]} */ (
  [
    "fe",
    "universal",
    "thick-wall",
    "ideal",
    "paper",
    "chou-hannaford",
    "force-balance",
    "tondu-lopez",
  ].map((m) => [m, m])
);

/**
 * Fields of a side: its model, and of B what it changes.
 * @param {string} name @param {() => void} ask
 */
function sideForm(name, ask) {
  const measure = (/** @type {Measure} */ { key, field, label, kind }, more = {}) => ({
    key: name + key,
    field,
    label,
    kind,
    ...more,
  });
  const [model, rubber, braid, pressure, contraction] = fieldsOf([
    [`${name}model`, "model", "Model", { options: MODELS, value: "fe" }],
    [`${name}rubber`, "rubber", "Rubber"],
    [`${name}braid`, "braid", "Braid"],
    [`${name}p`, "pressure_mpa", "Pressure", "pressure"],
    [`${name}e`, "contraction", "Contraction", "ratio"],
  ]);
  const fields = form(
    name === "a"
      ? [model]
      : [
          model,
          ...QUANTITIES.map((m) => measure(m)),
          rubber,
          braid,
          measure(STIFFNESS, { or: STIFFNESS_NAMES }),
          ...STRANDS.map((m) => measure(m, { hidden: true })),
          pressure,
          contraction,
        ],
    ask,
  );
  fields.element.append(folded("Advanced", fields.rows.get(`${name}model`)?.row));
  fields.element.addEventListener("change", ask);
  return fields;
}

/** One of both. @param {string} name @param {() => void} ask */
function sideOf(name, ask) {
  const fields = sideForm(name, ask),
    stage = el("div", { class: "stage", style: "height:220px" }),
    which = remark(),
    said = block();
  const view = viewOf(stage);
  const point = new Slot(),
    shape = new Slot({ lane: "state" }),
    curve = new Slot({ lane: "curves" });
  const back = button("The same muscle again", () => take(""), { hidden: true });
  const take = async (/** @type {string} */ text) => {
    await pack(text);
    side.file = text;
    ask();
  };
  const box =
    name === "b" &&
    folded(
      "Another muscle",
      fileField("Open a muscle file (TOML)", ".toml", (_, text) => take(text)),
      back,
    );
  const element = el(
    "section",
    { ariaLabel: name.toUpperCase() },
    heading(name === "a" ? "A: the muscle" : "B: with changes"),
    stage,
    said,
    which,
    block("controls", fields.element, box),
  );
  const stale = (/** @type {boolean} */ on) => dim([stage, which], on);
  const side = {
    name,
    fields,
    element,
    file: "",
    answer: signal(/** @type {Commands["force"]["answer"] | undefined} */ (undefined)),
    family: signal(/** @type {Commands["curve"]["answer"] | undefined} */ (undefined)),
    async ask() {
      // What a sleeve needs beside its name has a field.
      const braid = fields.text(`${name}braid`),
        k = fields.text(`${name}k`);
      const lacks = braid ? missing({ said: { braid, ...(k ? { k } : {}) } }, muscle.sleeves) : [];
      for (const { key } of STRANDS) fields.shown(name + key, lacks.includes(key));
      back.hidden = !side.file;
      const read = await fields.read();
      if (!read) return stale(true);
      const { model, ...at } = asked(muscle.state, side.file, read);
      point.ask(
        "force",
        { ...at, model, extrapolate: true },
        (answer) => {
          side.answer.value = answer;
          stale(false);
          said.replaceChildren(warnings(answer.warnings));
        },
        (problem) => {
          side.answer.value = undefined;
          stale(true);
          fields.at(problem);
          said.replaceChildren(problemBox(problem));
        },
      );
      shape.ask("shape", at, (answer) => view.stretched(answer));
      const drawn = (/** @type {Commands["curve"]["answer"] | undefined} */ answer) => {
        side.family.value = answer;
      };
      curve.ask(
        "curve",
        {
          muscle: at.muscle,
          model,
          test: "isobaric",
          pressures_mpa: [at.pressure_mpa],
          extrapolate: true,
        },
        drawn,
        () => drawn(undefined),
      );
    },
    /** Which muscle it is, and what its fields say where nothing is typed into them. */
    usual() {
      which.textContent = side.answer.value ? muscle.line(side.answer.value.muscle) : "";
      const put = (/** @type {string} */ key, /** @type {string | null | undefined} */ text) =>
        fields.usual(name + key, side.file ? "as in its file" : (text ?? ""));
      for (const m of QUANTITIES) {
        const value = shownValue(muscle.state, muscle.shown, m),
          sleeve = m.key === "angle" && fields.text(`${name}braid`);
        put(m.key, sleeve ? "of the sleeve" : value === undefined ? "" : show(m.kind, value));
      }
      put("rubber", partName(muscle.shown?.rubber));
      put("braid", muscle.shown?.sleeve ?? "Custom angle");
      put("k", braidName(muscle.shown?.braid));
      fields.usual(`${name}p`, showPressure(muscle.p));
      fields.usual(`${name}e`, showRatio(muscle.e));
    },
  };
  return side;
}

/** Rows of the numbers. @type {[string, (x: Commands["force"]["answer"]) => string][]} */
const ROWS = [
  ["model", (x) => x.model],
  ["pull", (x) => (x.slack ? "slack" : showForce(x.force_n))],
  ["as built", asBuilt],
  ["stiffness", (x) => show("stiffness", x.stiffness_n_per_mm, 3)],
  ["bulged diameter", (x) => showLength(x.bulged_diameter_mm)],
  ["cavity", (x) => (x.volume_mm3 ? show("volume", x.volume_mm3, 3) : "–")],
  ["threshold pressure", (x) => showPressure(x.start_pressure_mpa, 3)],
  ["largest stretch", (x) => number(x.max_stretch, 3)],
];

/** @type {Mount} */
export const mount = (main) => {
  const sides = ["a", "b"].map((name) => sideOf(name, () => ask())),
    [, b] = sides;
  const chart = chartOf("compare", { tools: heading("Pull over contraction") }),
    numbers = block();
  main.replaceChildren(
    block("pair", block("", sides[0].element, numbers, chart.element), b.element),
  );

  async function ask() {
    keepWords("compare", {
      ...Object.assign({}, ...sides.map((s) => s.fields.texts())),
      bfile: b.file,
    });
    await Promise.all(sides.map((side) => side.ask()));
  }
  watch(() => {
    sides.forEach((side) => side.usual());
    const rows = ROWS.map(([name, of]) => [
      capital(name),
      ...sides.map(({ answer }) => (answer.value ? of(answer.value) : "–")),
    ]);
    numbers.replaceChildren(table(["", "A", "B"], rows, { label: "both in numbers" }));
    const series = sides.flatMap(({ name, family: { value: family } }, i) =>
      family
        ? isobars(
            {
              name: `${name.toUpperCase()}: ${family.model}`,
              end: name.toUpperCase(),
              colour: KINDS[i],
              smooth: true,
            },
            family.points,
          )
        : [],
    );
    chart.show({ x: ratioAxis, y: forceAxis(), series });
  });
  return {
    async load(params) {
      await muscle.read(params, [...sides.flatMap((s) => s.fields.keys), "bfile"]);
      for (const side of sides) side.fields.set(params);
      b.file = params.get("bfile") ?? "";
      b.fields.options(
        "bbraid",
        muscle.sleeves.map((s) => s.name),
      );
      await ask();
    },
  };
};
