// Two muscles, or two models, side by side: each side is the muscle of the page Muscle, or that of a file, with what
// the side says over it.
import { Slot } from "../ask.js";
import { address, write } from "../address.js";
import { Chart, KINDS, isobar } from "../chart.js";
import { fileField } from "../controls.js";
import { pack } from "../deflate.js";
import { capital, el, problemBox } from "../dom.js";
import { form, table, warnings } from "../form.js";
import { atEnd, held } from "../life.js";
import { muscle } from "../muscle.js";
import { QUANTITIES, STIFFNESS, STIFFNESS_NAMES, STRANDS, missing, shownValue, side as asked } from "../state.js";
import { number, onUnits, show, unitName, withUncertainty } from "../units.js";
import { View, reach } from "../view3d.js";

const MODELS =
  /** @type {[string, string][]} */ (["fe", "universal", "thick-wall", "ideal", "paper", "chou-hannaford",
    "force-balance", "tondu-lopez"].map((m) => [m, m]));
/** @typedef {import("../../../types/commands").Commands} Commands */

/** Fields of a side. @param {string} name @param {boolean} second @param {() => void} ask */
function sideForm(name, second, ask) {
  const measure = (/** @type {import("../state.js").Measure} */ { key, field, label, kind }, more = {}) => ({
    key: name + key,
    field,
    label,
    kind,
    ...more,
  });
  const fields = form([
    ...QUANTITIES.map((m) => measure(m)),
    { key: `${name}rubber`, field: "rubber", label: "Rubber" },
    { key: `${name}braid`, field: "braid", label: "Braid" },
    measure(STIFFNESS, { or: STIFFNESS_NAMES }),
    ...STRANDS.map((m) => measure(m, { hidden: true })),
    { key: `${name}model`, field: "model", label: "Model", options: MODELS, value: second ? "thick-wall" : "fe" },
    { key: `${name}p`, field: "pressure_mpa", label: "Pressure", kind: "pressure" },
    { key: `${name}e`, field: "contraction", label: "Contraction", kind: "ratio" },
  ], ask);
  fields.element.addEventListener("change", ask);
  return fields;
}

/** Which muscle it is. @param {Commands["force"]["answer"]["muscle"] | undefined} m */
function muscleLine(m) {
  if (!m) return "";
  const size = `D0 ${show("length", m.outer_diameter_mm)}, s ${show("length", m.wall_mm)}`;
  return `${size}, L0 ${show("length", m.length_mm)}, θ0 ${show("angle", m.angle_deg)}, rubber ${m.rubber}, `
    + `braid ${m.braid}`;
}

/**
 * What a field says where nothing is typed into it: that of the muscle.
 * @param {ReturnType<typeof form>} fields @param {string} name of the side @param {string} file of its own
 */
function usualTexts(fields, name, file) {
  const put = (/** @type {string} */ key, /** @type {string | null | undefined} */ text) =>
    fields.usual(name + key, file ? "as in its file" : text ?? "");
  for (const m of QUANTITIES) {
    const value = shownValue(muscle.state, muscle.shown, m), shown = value === undefined ? "" : show(m.kind, value);
    put(m.key, m.key === "angle" && fields.text(`${name}braid`) ? "of the sleeve" : shown);
  }
  put("rubber", muscle.shown?.rubber);
  put("braid", muscle.shown?.sleeve);
  put("k", muscle.shown?.braid);
  fields.usual(`${name}p`, show("pressure", muscle.p));
  fields.usual(`${name}e`, show("ratio", muscle.e));
}

/** One of both. @param {string} name @param {boolean} second @param {{ ask: () => void, paint: () => void }} act */
function sideOf(name, second, { ask, paint }) {
  const fields = sideForm(name, second, ask), stage = el("div", { class: "stage", style: "height:220px" }),
    which = el("p", { class: "small soft" }), said = el("div", {});
  const view = held(/** @type {View & { destroy?: () => void }} */ (new View(stage)));
  const point = new Slot(), shape = new Slot({ lane: "state" }), curve = new Slot({ lane: "curves" });
  const back = el("button", { type: "button", hidden: true, onclick: () => take("") },
    "The muscle of the page Muscle again");
  const take = async (/** @type {string} */ text) => {
    await pack(text);
    side.file = text;
    ask();
  };
  const box = el("details", {}, el("summary", {}, "Another muscle"),
    fileField("Open a muscle file (TOML)", ".toml", (_, text) => take(text)), back);
  const element = el("section", { "aria-label": name.toUpperCase() }, el("h2", {}, name.toUpperCase()), stage, said,
    which, el("div", { class: "controls", style: "margin-top:8px" }, fields.element, box));
  const stale = (/** @type {boolean} */ on) => [stage, which].forEach((part) => part.classList.toggle("stale", on));
  const side = {
    name,
    fields,
    element,
    file: "",
    answer: /** @type {Commands["force"]["answer"] | undefined} */ (undefined),
    family: /** @type {Commands["curve"]["answer"] | undefined} */ (undefined),
    async ask() {
      // What a sleeve needs beside its name has a field.
      const braid = fields.text(`${name}braid`), k = fields.text(`${name}k`);
      const lacks = braid ? missing({ said: { braid, ...(k ? { k } : {}) } }, muscle.sleeves) : [];
      for (const { key } of STRANDS) fields.shown(name + key, lacks.includes(key));
      back.hidden = !side.file;
      const read = await fields.read();
      if (!read) return stale(true);
      const { muscle: of, model, pressure_mpa, contraction } = asked(muscle.state, side.file, read);
      const fail = (/** @type {import("../engine/problem.js").Problem} */ problem) => {
        side.answer = undefined;
        stale(true);
        fields.at(problem);
        said.replaceChildren(problemBox(problem));
        paint();
      };
      point.ask("force", { ...of, model, contraction, pressure_mpa, extrapolate: true }, (answer) => {
        side.answer = answer;
        stale(false);
        said.replaceChildren(warnings(answer.warnings));
        paint();
      }, fail);
      shape.ask("shape", { ...of, contraction, pressure_mpa }, (answer) => {
        const { max_stretch: stretch } = answer.arrays;
        view.set(answer, { field: "max_stretch", low: 1, high: Math.max(1.2, reach(stretch)[1]),
          restLength: answer.muscle.length_mm, restRadius: answer.muscle.outer_diameter_mm / 2 });
      }, () => {});
      curve.ask("curve", { ...of, model, test: "isobaric", pressures_mpa: [pressure_mpa], extrapolate: true },
        (answer) => {
          side.family = answer;
          paint();
        }, () => {
        side.family = undefined;
        paint();
      });
    },
    /** Which muscle it is. */
    line() {
      which.textContent = muscleLine(side.answer?.muscle);
    },
    usual() {
      usualTexts(fields, name, side.file);
    },
    end() {
      [point, shape, curve].forEach((slot) => slot.end());
    },
  };
  return side;
}

/** Rows of the numbers. @type {[string, (x: Commands["force"]["answer"]) => string][]} */
const ROWS = [
  ["model", (x) => x.model],
  ["pull", (x) => (x.slack ? "slack" : withUncertainty("force", x.force_n, x.uncertainty_n))],
  ["stiffness", (x) => show("stiffness", x.stiffness_n_per_mm, 3)],
  ["bulged diameter", (x) => show("length", x.bulged_diameter_mm)],
  ["cavity", (x) => (x.volume_mm3 ? show("volume", x.volume_mm3, 3) : "–")],
  ["starts at", (x) => show("pressure", x.start_pressure_mpa, 3)],
  ["largest stretch", (x) => number(x.max_stretch, 3)],
];

/** @param {HTMLElement} main */
export function mount(main) {
  const sides = ["a", "b"].map((name, i) => sideOf(name, i === 1, { ask: () => ask(), paint: () => paint() }));
  const chart = new Chart("compare", { tools: el("h2", {}, "Pull over contraction") }), numbers = el("div", {});
  main.replaceChildren(el("div", { class: "pair" }, ...sides.map((s) => s.element)),
    el("div", { style: "margin-top:16px" }, chart.element), numbers);
  const files = () => Object.fromEntries(sides.map((s) => [`${s.name}file`, s.file]));

  async function ask() {
    sides.forEach((side) => side.usual());
    write(
      address("compare", { ...muscle.params(), ...sides[0].fields.texts(), ...sides[1].fields.texts(), ...files() }),
    );
    await Promise.all(sides.map((side) => side.ask()));
  }

  function paint() {
    const [a, b] = sides.map((s) => s.answer);
    sides.forEach((side) => side.line());
    numbers.replaceChildren(
      table(["", "A", "B"], ROWS.map(([name, of]) => [capital(name), a ? of(a) : "–", b ? of(b) : "–"]), {
        label: "both in numbers",
      }),
    );
    const series = sides.flatMap((s, i) => {
      const name = s.name.toUpperCase(), dash = /** @type {"dash" | "solid"} */ (i ? "dash" : "solid");
      return s.family
        ? [{ name: `${name}: ${s.family.model}`, end: name, colour: KINDS[i], dash, ...isobar(s.family.points) }]
        : [];
    });
    chart.show({ x: "contraction ε [%]", y: `pull F [${unitName("force")}]`, series });
  }

  atEnd(onUnits(() => {
    sides.forEach((side) => side.usual());
    paint();
  }));
  return {
    /** @param {URLSearchParams} params */
    async load(params) {
      await muscle.read(params, sides.flatMap((s) => [...s.fields.keys, `${s.name}file`]));
      for (const side of sides) {
        side.fields.set(params);
        side.file = params.get(`${side.name}file`) ?? "";
        side.fields.options(`${side.name}braid`, muscle.sleeves.map((s) => s.name));
      }
      await ask();
    },
    unmount() {
      sides.forEach((side) => side.end());
    },
  };
}
