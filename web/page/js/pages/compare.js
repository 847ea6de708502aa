// Two muscles, or two models, side by side: each side is the muscle of the page Muscle, or that of a file, with what the side says over it.
import { Slot } from "../ask.js";
import { address, write } from "../address.js";
import { Chart, KINDS, isobar } from "../chart.js";
import { fileField } from "../controls.js";
import { capital, el, problemBox } from "../dom.js";
import { form, table, warnings } from "../form.js";
import { muscle } from "../muscle.js";
import { QUANTITIES, STIFFNESS, STIFFNESS_NAMES, STRANDS, missing, shownValue, side as asked } from "../state.js";
import { number, onUnits, show, unitName, withUncertainty } from "../units.js";
import { View, reach } from "../view3d.js";

const MODELS = /** @type {[string, string][]} */ (["fe", "universal", "thick-wall", "ideal", "paper", "chou-hannaford", "force-balance", "tondu-lopez"].map((m) => [m, m]));

/** @param {HTMLElement} main */
export function mount(main) {
  const sides = ["a", "b"].map((name, i) => {
    const measure = (/** @type {import("../state.js").Measure} */ { key, field, label, kind }, more = {}) => ({ key: name + key, field, label, kind, ...more });
    const fields = form([
      ...QUANTITIES.map((m) => measure(m)), { key: `${name}rubber`, field: "rubber", label: "Rubber" }, { key: `${name}braid`, field: "braid", label: "Braid" },
      measure(STIFFNESS, { or: STIFFNESS_NAMES }), ...STRANDS.map((m) => measure(m, { hidden: true })),
      { key: `${name}model`, field: "model", label: "Model", options: MODELS, value: i ? "thick-wall" : "fe" },
      { key: `${name}p`, field: "pressure_mpa", label: "Pressure", kind: "pressure" }, { key: `${name}e`, field: "contraction", label: "Contraction", kind: "ratio" },
    ], () => ask());
    fields.element.addEventListener("change", () => ask());
    const stage = el("div", { class: "stage", style: "height:220px" });
    const which = el("p", { class: "small soft" });
    const back = el("button", { type: "button", hidden: true, onclick: () => take("") }, "The muscle of the page Muscle again");
    const side = { name, fields, stage, which, back, file: "", view: new View(stage), said: el("div", {}), point: new Slot(), shape: new Slot({ lane: "state" }), curve: new Slot({ lane: "curves" }), answer: /** @type {any} */ (undefined), family: /** @type {any} */ (undefined) };
    const take = (/** @type {string} */ text) => { side.file = text; ask(); };
    const box = el("details", {}, el("summary", {}, "Another muscle"), fileField("Open a muscle file (TOML)", ".toml", (_, text) => take(text)), back);
    const element = el("section", { "aria-label": name.toUpperCase() }, el("h2", {}, name.toUpperCase()), stage, side.said, which, el("div", { class: "controls", style: "margin-top:8px" }, fields.element, box));
    return Object.assign(side, { element });
  });
  const chart = new Chart("compare", { tools: el("h3", {}, "Pull over contraction") });
  const numbers = el("div", {});
  main.replaceChildren(el("div", { class: "pair" }, ...sides.map((s) => s.element)), el("div", { style: "margin-top:16px" }, chart.element), numbers);
  const files = () => Object.fromEntries(sides.map((s) => [`${s.name}file`, s.file]));

  async function ask() {
    usual();
    write(address("compare", { ...muscle.params(), ...sides[0].fields.texts(), ...sides[1].fields.texts(), ...files() }), true);
    for (const side of sides) {
      // What a sleeve needs beside its name has a field.
      const braid = side.fields.text(`${side.name}braid`), k = side.fields.text(`${side.name}k`);
      const lacks = braid ? missing({ said: { braid, ...(k ? { k } : {}) } }, muscle.sleeves) : [];
      for (const { key } of STRANDS) side.fields.shown(side.name + key, lacks.includes(key));
      side.back.hidden = !side.file;
      const read = await side.fields.read();
      if (!read) { stale(side, true); continue; }
      const { muscle: of, model, pressure_mpa, contraction } = asked(muscle.state, side.file, read);
      const fail = (/** @type {any} */ problem) => { side.answer = undefined; stale(side, true); side.said.replaceChildren(problemBox(problem)); paint(); };
      side.point.ask("force", { ...of, model, contraction, pressure_mpa, extrapolate: true }, (answer) => {
        side.answer = answer;
        stale(side, false);
        side.said.replaceChildren(warnings(answer.warnings));
        const m = answer.muscle;
        side.which.textContent = `D0 ${show("length", m.outer_diameter_mm)}, s ${show("length", m.wall_mm)}, L0 ${show("length", m.length_mm)}, θ0 ${show("angle", m.angle_deg)}, rubber ${m.rubber}, braid ${m.braid}`;
        paint();
      }, fail);
      side.shape.ask("shape", { ...of, contraction, pressure_mpa }, (shape) => {
        side.view.set(shape, { field: "max_stretch", low: 1, high: Math.max(1.2, reach(shape.arrays.max_stretch)[1]), restLength: shape.muscle.length_mm, restRadius: shape.muscle.outer_diameter_mm / 2 });
      }, () => {});
      side.curve.ask("curve", { ...of, model, test: "isobaric", pressures_mpa: [pressure_mpa], extrapolate: true }, (answer) => { side.family = answer; paint(); }, () => { side.family = undefined; paint(); });
    }
  }

  /** @param {(typeof sides)[number]} side @param {boolean} on */
  const stale = (side, on) => [side.stage, side.which].forEach((part) => part.classList.toggle("stale", on));

  function paint() {
    const [a, b] = sides.map((s) => s.answer);
    const rows = /** @type {[string, (x: any) => string][]} */ ([
      ["model", (x) => x.model], ["pull", (x) => (x.slack ? "slack" : withUncertainty("force", x.force_n, x.uncertainty_n))], ["stiffness", (x) => `${number(x.stiffness_n_per_mm, 3)} N/mm`],
      ["bulged diameter", (x) => show("length", x.bulged_diameter_mm)], ["cavity", (x) => (x.volume_mm3 ? `${number(x.volume_mm3 / 1e3, 3)} cm³` : "–")], ["starts at", (x) => show("pressure", x.start_pressure_mpa, 3)], ["largest stretch", (x) => number(x.max_stretch, 3)],
    ]);
    numbers.replaceChildren(table(["", "A", "B"], rows.map(([name, of]) => [capital(name), a ? of(a) : "–", b ? of(b) : "–"]), { label: "both in numbers" }));
    chart.show({ x: "contraction ε [%]", y: `pull F [${unitName("force")}]`, series: sides.flatMap((s, i) => (s.family ? [{ name: `${s.name.toUpperCase()}: ${s.family.model}`, end: s.name.toUpperCase(), colour: KINDS[i], dash: /** @type {"dash" | "solid"} */ (i ? "dash" : "solid"), ...isobar(s.family.points) }] : [])) });
  }

  /** What a field says where nothing is typed into it: that of the muscle. */
  function usual() {
    for (const side of sides) {
      const put = (/** @type {string} */ key, /** @type {string | undefined} */ text) => side.fields.usual(side.name + key, side.file ? "as in its file" : text ?? "");
      for (const m of QUANTITIES) {
        const value = shownValue(muscle.state, muscle.shown, m);
        put(m.key, m.key === "angle" && side.fields.text(`${side.name}braid`) ? "of the sleeve" : value === undefined ? "" : show(m.kind, value));
      }
      put("rubber", muscle.shown?.rubber);
      put("braid", muscle.shown?.sleeve);
      put("k", muscle.shown?.braid);
      side.fields.usual(`${side.name}p`, show("pressure", muscle.p));
      side.fields.usual(`${side.name}e`, show("ratio", muscle.e));
    }
  }

  const off = onUnits(() => { usual(); paint(); });
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
    unmount() { off(); sides.forEach((s) => [s.point, s.shape, s.curve].forEach((slot) => slot.end())); },
  };
}
