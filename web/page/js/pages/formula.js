// A campaign of finite-element tests and the formula fitted to it: errors, figures, surfaces, and the file.
import { engine } from "../ask.js";
import { Chart } from "../chart.js";
import { download, el } from "../dom.js";
import { Figures } from "../figure.js";
import { form, job, table } from "../form.js";
import { number, outside, show, unitName } from "../units.js";

const PLAN = `name = "page"

[tube]
length = "285 mm"
rubber = "paper"

[braid]
angle = "28 deg"
stiffness = "paper"

[sampling]
method = "factorial"

[vary]
tube.outer_diameter = "30,40,45,50 mm"
tube.wall_thickness = "1..5:1 mm"

[test]
contractions = "0..0.20:0.05"
pressures = "0..0.25:0.01 MPa"
`;

/** The paper's formula, with the box that it was fitted in. */
const PUBLISHED = { name: "The formula of the paper", range: { outer_diameter_mm: [30, 50], wall_mm: [1, 5], contraction: [0, 0.2] } };

/** @param {HTMLElement} main */
export function mount(main) {
  /** @type {any} */ let made;
  /** @type {any} */ let formula = PUBLISHED;
  const plan = el("textarea", { rows: 20, style: "width:100%;font:13px ui-monospace,monospace", "aria-label": "Plan (TOML)", spellcheck: "false" });
  plan.value = PLAN;
  const how = form([
    { key: "method", field: "method", label: "Method", options: [["paper", "the paper's seven steps"], ["global", "one least-squares problem"]], value: "paper" },
    { key: "hold", field: "hold_out_mm", label: "Diameters kept out", kind: "length", list: true, hint: "45 mm" },
    { key: "at", field: "at", label: "Surfaces at", kind: "pressure", value: "2.5 bar" },
  ], () => fit.run());
  const table1 = el("p", { class: "small" }), errors = el("div", {}), figures = el("div", {});
  const wallTitle = el("h3", {}), diameterTitle = el("h3", {});
  const overWall = new Chart("surface-wall", { tools: wallTitle, tall: true });
  const overDiameter = new Chart("surface-diameter", { tools: diameterTitle, tall: true });
  const surfaces = el("div", { class: "charts", hidden: true }, overWall.element, overDiameter.element);
  const campaign = job("Compute the plan", "plan", async () => ({ plan: { name: "page.toml", text: plan.value } }), (answer) => {
    made = answer;
    table1.replaceChildren(`${answer.muscles} muscles, ${answer.points} points, ${answer.failed} without an answer. `, el("button", { type: "button", onclick: () => download(answer.table.name, answer.table.text, "text/csv") }, "Download the table"));
    fit.run();
  });
  const fit = job("Fit", "fit", async () => {
    if (!made) { errors.replaceChildren(el("p", { class: "soft" }, "Compute the plan first.")); return undefined; }
    const read = await how.read();
    if (!read) return undefined;
    const { method, hold_out_mm } = read;
    return { table: made.table, method, hold_out_mm: hold_out_mm ?? [], figures: true };
  }, (answer) => {
    const { figures: drawn, tables, ...file } = answer;
    formula = file;
    const e = file.errors, row = (/** @type {string} */ name, /** @type {any} */ x) => [name, String(x.points), `${number(100 * x.rms_of_blocked, 3)} %`, `${number(100 * x.p95_of_blocked, 3)} %`, `${number(100 * x.max_of_blocked, 3)} %`];
    errors.replaceChildren(el("h2", {}, file.name), el("p", { class: "small" }, el("code", {}, file.equation)), table(["against finite elements", "points", "rms", "95 %", "largest"], [row("fitted to", e.fit), ...("held_out" in e && e.held_out ? [row("kept out", e.held_out)] : [])], { label: "errors of the formula, of the blocked force" }), el("p", { class: "small soft" }, "Errors as shares of the blocked force."),
      el("p", {}, el("button", { type: "button", onclick: () => download(`${file.name}.json`, JSON.stringify(file, null, 2) + "\n", "application/json") }, "Download the formula")));
    figures.replaceChildren(...(drawn ?? []).map((/** @type {any} */ f) => {
      const box = el("details", {}, el("summary", {}, f.figure.title || f.name));
      // A figure is drawn when it is opened.
      box.addEventListener("toggle", () => { const one = new Figures(f.name); box.append(one.element); one.show(f.figure); }, { once: true });
      return box;
    }));
    surface().catch(() => { surfaces.hidden = true; });
  });
  main.replaceChildren(el("div", { class: "bench two" },
    el("section", { class: "controls", "aria-label": "Campaign" }, el("h2", {}, "Campaign"), el("p", { class: "small soft" }, "A plan lists the muscles to compute by finite elements. This is the plan of the paper."), plan, campaign.element, table1, how.element, fit.element),
    el("div", { class: "middle" }, errors, surfaces, figures)));
  errors.append(el("h2", {}, PUBLISHED.name), el("p", { class: "soft" }, "Below is the formula that the paper published. Compute a campaign and fit your own formula to it. The paper used a hundred simulations; here they run while you watch."));

  /** The formula as surfaces that turn. */
  async function surface() {
    const read = await how.read();
    const { range } = formula;
    surfaces.hidden = true;
    if (!range?.outer_diameter_mm || !read?.at) return;
    surfaces.hidden = false;
    const steps = (/** @type {[number, number]} */ [low, high], n = 11) => Array.from({ length: n }, (_, i) => low + ((high - low) * i) / (n - 1));
    const [D, S, E] = [steps(range.outer_diameter_mm), steps(range.wall_mm), steps(range.contraction, 21)];
    wallTitle.textContent = `Pull over contraction and wall, D0 ${show("length", D[5])}`;
    diameterTitle.textContent = `Pull over contraction and diameter, s ${show("length", S[5])}`;
    const middle = { outer_diameter_mm: D[5], wall_mm: S[5] };
    const model = formula === PUBLISHED ? { model: "paper" } : { model: formula.name, formulas: [{ name: formula.name, text: JSON.stringify(formula) }] };
    const line = async (/** @type {any} */ at) => (await engine().ask("curve", { ...model, ...middle, ...at, test: "isobaric", pressures_mpa: [read.at], contractions: E, extrapolate: true })).points.map((/** @type {any} */ q) => (q.force_n === undefined ? null : outside("force", q.force_n)));
    const draw = async (/** @type {Chart} */ chart, /** @type {string} */ label, /** @type {number[]} */ list, /** @type {string} */ field) => {
      /** @type {(number | null)[][]} */
      const z = [];
      for (const value of list) z.push(await line({ [field]: value }));
      const axis = (/** @type {string} */ text) => ({ title: { text } });
      chart.show({ x: "contraction ε [%]", y: label, z: `pull F [${unitName("force")}]`, series: [], data: [{ type: "surface", name: "surface", x: E.map((e) => 100 * e), y: list.map((v) => outside("length", v)), z, colorscale: "Viridis", showscale: false }],
        layout: { scene: { xaxis: axis("ε [%]"), yaxis: axis(label), zaxis: axis(`F [${unitName("force")}]`), camera: { eye: { x: 1.5, y: 1.5, z: 1.1 }, center: { x: 0, y: 0, z: -0.15 } } }, margin: { l: 0, r: 0, t: 0, b: 0 }, dragmode: "orbit" } });
    };
    await draw(overWall, `s [${unitName("length")}]`, S, "wall_mm");
    await draw(overDiameter, `D0 [${unitName("length")}]`, D, "outer_diameter_mm");
  }

  return { async load() { surface().catch(() => { surfaces.hidden = true; }); }, unmount() { campaign.end(); fit.end(); } };
}
