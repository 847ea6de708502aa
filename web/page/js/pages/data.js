// Measured points: seen over the models, and constants identified from them.
import { engine } from "../ask.js";
import { address, write } from "../address.js";
import { columnChoice, headings } from "../columns.js";
import { fileField, onDrop } from "../controls.js";
import { download, el, problemBox } from "../dom.js";
import { Figures } from "../figure.js";
import { form, job, table, warnings } from "../form.js";
import { measured } from "../measured.js";
import { muscle } from "../muscle.js";
import { number, show, unitName } from "../units.js";

const EXAMPLE = "pressure_bar,contraction,force_n\n";

/** @param {HTMLElement} main */
export function mount(main) {
  /** @type {{ name: string, text: string } | undefined} */ let data;
  const what = form([
    { key: "free", field: "free", label: "Free constants", words: true, hint: "modulus; or mu, braid.angle" },
    { key: "models", field: "models", label: "Models", words: true, value: "fe, thick-wall, ideal" },
  ], () => look());
  const columns = columnChoice(() => look());
  const understood = el("div", {}), errors = el("div", {}), found = el("div", {});
  const figures = new Figures("data"), fitted = new Figures("identified");
  const which = el("p", { class: "small soft" });
  const identify = job("Identify", "identify", async () => {
    const read = await what.read();
    if (!data || !read) { found.replaceChildren(el("p", { class: "soft" }, "Open a table first.")); return undefined; }
    return { ...fields(), data: [data], columns: columns.value(), free: read.free ?? [], figure: unitName("pressure") };
  }, (answer) => {
    const rows = answer.parameters.map((/** @type {any} */ p) => [p.name, `${number(p.value, 5)} ${p.unit ?? ""}`, p.half_width_95 ? `± ${number(p.half_width_95, 2)}` : "–", p.identifiable ? "" : "not identifiable from these data"]);
    found.replaceChildren(el("h2", {}, "Identified"), table(["constant", "value", "95 %", ""], rows, { text: [0, 3], label: "constants" }), el("p", {}, `Residuals ${number(answer.rms_n, 3)} N rms, ${number(answer.rms_before_n, 3)} N before.`), warnings(answer.warnings),
      el("p", { class: "row" }, el("button", { type: "button", onclick: () => download("identified.toml", answer.muscle_file, "application/toml") }, "Download the muscle"), el("button", { type: "button", onclick: async () => { await muscle.take(answer.muscle_file); location.hash = address("muscle", muscle.params()); } }, "See it move")));
    fitted.show(answer.figure);
  });
  main.replaceChildren(el("div", { class: "bench two" },
    el("section", { class: "controls", "aria-label": "Data" }, el("h2", {}, "Measured points"), fileField("Open a table (CSV)", ".csv,.txt,.tsv", take), el("p", { class: "small soft" }, "Pressures, contractions (or shortenings, or lengths) and pulls, with their units in the heading. ", el("button", { type: "button", class: "bare", onclick: example }, "Make an example")), which, columns.element, what.element, el("div", { class: "row" }, el("button", { type: "button", onclick: () => look() }, "Compare")), identify.element),
    el("div", { class: "middle" }, understood, errors, figures.element, found, fitted.element)));
  onDrop(main, (file) => { if (file) file.text().then((text) => take(file.name, text)); });
  understood.append(el("p", { class: "soft" }, "Drop a table of measured points. The figure compares it with the models of the muscle of the page Muscle. Then you can identify its constants."));

  function fields() {
    const of = muscle.fields();
    which.textContent = `Compared with ${muscle.line()}.`;
    return of;
  }

  /** @param {string} name @param {string} text */
  function take(name, text) {
    data = { name, text };
    columns.offer(headings(text));
    found.replaceChildren();
    fitted.show(undefined);
    look();
  }

  let looking = new AbortController();
  async function look() {
    const read = await what.read();
    if (!data || !read) return;
    write(address("data", { ...muscle.params(), ...what.texts(), columns: columns.text() }), true);
    looking.abort();
    const { signal } = (looking = new AbortController());
    measured.set(data, columns.value());
    try {
      const answer = await engine().ask("compare", { ...fields(), data, columns: columns.value(), models: read.models, extrapolate: true, figure: unitName("pressure") }, { signal });
      const u = answer.understood?.[0] ?? answer.understood;
      const list = u?.columns?.map((/** @type {any} */ c) => `${c.column} → ${c.quantity}${c.unit ? ` (${c.unit})` : ""}`).join(", ");
      understood.replaceChildren(el("p", {}, `${data.name}: ${answer.points} points. ${list ?? ""}`), warnings(answer.warnings));
      errors.replaceChildren(table(["model", "rms", "largest", "mean", "points"], answer.models.map((/** @type {any} */ m) => [m.model, show("force", m.rms_n, 3), show("force", m.max_n, 3), show("force", m.mean_n, 3), String(m.points)]), { label: "errors of the models" }));
      figures.show(answer.figure);
    } catch (problem) {
      if (signal.aborted) return;
      understood.replaceChildren(problemBox(problem));
      if (/** @type {any} */ (problem).kind === "data") columns.open();
      errors.replaceChildren();
      figures.show(undefined);
    }
  }

  /** Points of this muscle with errors of 3 %, always the same. */
  async function example() {
    const p = [0.1, 0.2, 0.3], e = [0, 0.05, 0.1, 0.15, 0.2];
    const answer = await engine().ask("curve", { ...muscle.fields(), test: "isobaric", pressures_mpa: p, contractions: e });
    const rows = answer.points.filter((/** @type {any} */ q) => q.status === "ok" && q.force_n > 0).map((/** @type {any} */ q, /** @type {number} */ i) => `${10 * q.pressure_mpa},${q.contraction},${(q.force_n * (1 + 0.03 * Math.sin(12.9898 * (i + 1)))).toFixed(1)}`);
    take("example.csv", EXAMPLE + rows.join("\n") + "\n");
  }

  return {
    /** @param {URLSearchParams} params */
    async load(params) {
      await muscle.read(params, [...what.keys, "columns"]);
      what.set(params);
      columns.read(params.get("columns") ?? "");
      fields();
      // A table that was dropped on the page Muscle.
      data ??= measured.file;
      if (data) { columns.offer(headings(data.text)); await look(); }
    },
    unmount() { identify.end(); looking.abort(); },
  };
}
