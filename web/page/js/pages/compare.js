// Two muscles, or two models, side by side.
import { Slot } from "../ask.js";
import { address, write } from "../address.js";
import { Chart, KINDS } from "../chart.js";
import { capital, el, problemBox } from "../dom.js";
import { form, table } from "../form.js";
import { muscle } from "../muscle.js";
import { number, onUnits, outside, show, unitName, withUncertainty } from "../units.js";
import { View, reach } from "../view3d.js";

const MODELS = /** @type {[string, string][]} */ (["fe", "universal", "thick-wall", "ideal", "paper", "chou-hannaford", "force-balance", "tondu-lopez"].map((m) => [m, m]));

/** @param {HTMLElement} main */
export function mount(main) {
  const sides = ["a", "b"].map((name, i) => {
    const fields = form([
      { key: `${name}D`, field: "outer_diameter_mm", label: "Outer diameter", kind: "length" }, { key: `${name}s`, field: "wall_mm", label: "Wall", kind: "length" },
      { key: `${name}L`, field: "length_mm", label: "Length", kind: "length" }, { key: `${name}angle`, field: "angle_deg", label: "Braid angle", kind: "angle" },
      { key: `${name}rubber`, field: "rubber", label: "Rubber" }, { key: `${name}model`, field: "model", label: "Model", options: MODELS, value: i ? "thick-wall" : "fe" },
      { key: `${name}p`, field: "pressure_mpa", label: "Pressure", kind: "pressure" }, { key: `${name}e`, field: "contraction", label: "Contraction", kind: "ratio" },
    ], () => ask());
    fields.element.addEventListener("change", () => ask());
    const stage = el("div", { class: "stage", style: "height:220px" });
    return { name, fields, stage, view: new View(stage), said: el("div", {}), point: new Slot(), shape: new Slot({ lane: "state" }), curve: new Slot(), answer: /** @type {any} */ (undefined), family: /** @type {any} */ (undefined) };
  });
  const chart = new Chart("compare", { tools: el("h3", {}, "Pull over contraction") });
  const numbers = el("div", {});
  main.replaceChildren(el("div", { class: "pair" }, ...sides.map((s) => el("section", { "aria-label": s.name.toUpperCase() }, el("h2", {}, s.name.toUpperCase()), s.stage, s.said, el("div", { class: "controls", style: "margin-top:8px" }, s.fields.element)))), el("div", { style: "margin-top:16px" }, chart.element), numbers);

  async function ask() {
    write(address("compare", { ...sides[0].fields.texts(), ...sides[1].fields.texts() }), true);
    for (const side of sides) {
      const read = await side.fields.read();
      if (!read) continue;
      const { contraction, pressure_mpa, model, ...of } = read;
      side.point.ask("force", { ...of, model, contraction, pressure_mpa, extrapolate: true }, (answer) => { side.answer = answer; side.said.replaceChildren(); paint(); }, (problem) => { side.answer = undefined; side.said.replaceChildren(problemBox(problem)); paint(); });
      side.shape.ask("shape", { ...of, contraction, pressure_mpa }, (shape) => {
        side.view.set(shape, { field: "max_stretch", low: 1, high: Math.max(1.2, reach(shape.arrays.max_stretch)[1]), restLength: of.length_mm, restRadius: of.outer_diameter_mm / 2 });
      }, () => {});
      side.curve.ask("curve", { ...of, model, test: "isobaric", pressures_mpa: [pressure_mpa], extrapolate: true }, (answer) => { side.family = answer; paint(); }, () => {});
    }
  }

  function paint() {
    const [a, b] = sides.map((s) => s.answer);
    const rows = /** @type {[string, (x: any) => string][]} */ ([
      ["model", (x) => x.model], ["pull", (x) => (x.slack ? "slack" : withUncertainty("force", x.force_n, x.uncertainty_n))], ["stiffness", (x) => `${number(x.stiffness_n_per_mm, 3)} N/mm`],
      ["bulged diameter", (x) => show("length", x.bulged_diameter_mm)], ["cavity", (x) => (x.volume_mm3 ? `${number(x.volume_mm3 / 1e3, 3)} cm³` : "–")], ["starts at", (x) => show("pressure", x.start_pressure_mpa, 3)], ["largest stretch", (x) => number(x.max_stretch, 3)],
    ]);
    numbers.replaceChildren(table(["", "A", "B"], rows.map(([name, of]) => [capital(name), a ? of(a) : "–", b ? of(b) : "–"]), { label: "both in numbers" }));
    chart.show({ x: "contraction ε [%]", y: `pull F [${unitName("force")}]`, series: sides.flatMap((s, i) => (s.family ? [{ name: `${s.name.toUpperCase()}: ${s.family.model}`, end: s.name.toUpperCase(), colour: KINDS[i], dash: /** @type {"dash" | "solid"} */ (i ? "dash" : "solid"), x: s.family.points.map((/** @type {any} */ q) => 100 * q.contraction), y: s.family.points.map((/** @type {any} */ q) => (q.status === "ok" ? outside("force", q.force_n) : null)) }] : [])) });
  }

  const off = onUnits(() => paint());
  return {
    /** @param {URLSearchParams} params */
    async load(params) {
      await muscle.read(params, sides.flatMap((s) => s.fields.keys));
      const v = muscle.values;
      const usual = { D: show("length", v.D), s: show("length", v.s), L: show("length", v.L), angle: `${v.angle} deg`, rubber: v.rubber || "paper", p: show("pressure", v.p), e: show("ratio", v.e) };
      for (const side of sides) {
        side.fields.set(params);
        for (const [key, text] of Object.entries(usual)) if (!params.has(side.name + key)) side.fields.put(side.name + key, text);
      }
      await ask();
    },
    unmount() { off(); },
  };
}
