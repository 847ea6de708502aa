// Measured points: seen over the models, and constants identified from them.
import { engine } from "../ask.js";
import { address, write } from "../address.js";
import { columnChoice, headings } from "../columns.js";
import { fileField } from "../controls.js";
import { download, el, problemBox } from "../dom.js";
import { Figures } from "../figure.js";
import { form, job, table, warnings } from "../form.js";
import { example } from "../gallery.js";
import { fileOf, keepFile } from "../kept.js";
import { atEnd } from "../life.js";
import { measured } from "../measured.js";
import { muscle } from "../muscle.js";
import { number, onUnits, show, unitName } from "../units.js";

const HEADING = "pressure_bar,contraction,force_n\n", CONSTANTS = "constants";

/** Points of this muscle with errors of 3 %, always the same. */
async function madeUp() {
  const p = [0.1, 0.2, 0.3], e = [0, 0.05, 0.1, 0.15, 0.2];
  const answer = await engine().ask("curve", { ...muscle.fields(), test: "isobaric", pressures_mpa: p, contractions: e });
  const rows = answer.points.flatMap((/** @type {any} */ q, /** @type {number} */ i) => (q.status === "ok" && (q.force_n ?? 0) > 0 ? [`${10 * q.pressure_mpa},${q.contraction},${((q.force_n ?? 0) * (1 + 0.03 * Math.sin(12.9898 * (i + 1)))).toFixed(1)}`] : []));
  return HEADING + rows.join("\n") + "\n";
}

/** Constants with their ±, and what to do with them. @param {any} answer */
function identifiedView(answer) {
  const rows = answer.parameters.map((/** @type {any} */ p) => [p.name, `${number(p.value, 5)} ${p.unit ?? ""}`, p.half_width_95 ? `± ${number(p.half_width_95, 2)}` : "–", p.identifiable ? "" : "not identifiable from these data"]);
  const see = async () => { await muscle.take(answer.muscle_file); location.hash = address("muscle", muscle.params()); };
  return [
    el("h2", {}, "Identified"), table(["constant", "value", "95 %", ""], rows, { text: [0, 3], label: "constants" }),
    el("p", {}, `Residuals ${show("force", answer.rms_n, 3)} rms, ${show("force", answer.rms_before_n, 3)} before.`), warnings(answer.warnings),
    el("p", { class: "row" }, el("button", { type: "button", onclick: () => download("identified.toml", answer.muscle_file, "application/toml") }, "Download the muscle"), el("button", { type: "button", onclick: see }, "See it move")),
  ];
}

/** Errors of the models. @param {any[]} models */
const errorTable = (models) => table(["model", "rms", "largest", "mean", "points"], models.map((m) => [m.model, show("force", m.rms_n, 3), show("force", m.max_n, 3), show("force", m.mean_n, 3), String(m.points)]), { label: "errors of the models" });

/** @param {HTMLElement} main */
export function mount(main) {
  let data = measured.file;
  /** @type {any} */ let compared, /** @type {any} */ known;
  const what = form([
    { key: "free", field: "free", label: "Free constants", words: true, hint: "modulus; or mu, braid.angle" },
    { key: "models", field: "models", label: "Models", words: true, value: "fe, thick-wall, ideal" },
  ], () => look());
  const columns = columnChoice(() => look());
  const understood = el("div", {}), errors = el("div", {}), found = el("div", {}), which = el("p", { class: "small soft" });
  const figures = new Figures("data"), fitted = new Figures("identified");
  const identify = job("Identify", "identify", async () => {
    const read = await what.read();
    if (!data || !read) { found.replaceChildren(el("p", { class: "soft" }, "Open a table first.")); return undefined; }
    return { ...fields(), data: [data], columns: columns.value(), free: read.free ?? [], figure: unitName("pressure") };
  }, (answer) => { known = answer; keepFile(CONSTANTS, true); found.classList.remove("stale"); fitted.element.classList.remove("stale"); paint(); fitted.show(answer.figure); }, () => [found, fitted.element].forEach((part) => part.classList.add("stale")));
  const samples = el("p", { class: "row small" }, "Examples:", el("button", { type: "button", onclick: () => madeUp().then((text) => take("example.csv", text), problem) }, "points of this muscle"),
    el("button", { type: "button", onclick: () => Promise.all([example("bench.csv"), example("bench.toml")]).then(async ([text, file]) => { await muscle.take(file); await take("bench.csv", text); }).catch(problem) }, "a bench with its muscle"));
  main.replaceChildren(el("div", { class: "bench two" },
    el("section", { class: "controls", "aria-label": "Data" }, el("h2", {}, "Measured points"), fileField("Open a table (CSV)", ".csv,.txt,.tsv", take), el("p", { class: "small soft" }, "Pressures, contractions (or shortenings, or lengths) and pulls, with their units in the heading."), samples, which, columns.element, what.element, el("div", { class: "row" }, el("button", { type: "button", onclick: () => look() }, "Compare")), identify.element),
    el("div", { class: "middle" }, understood, errors, figures.element, found, fitted.element)));
  understood.append(el("p", { class: "soft" }, "Drop a table of measured points. The figure compares it with the models of the muscle of the page Muscle. Then you can identify its constants."));

  function fields() {
    which.textContent = `Compared with ${muscle.line()}.`;
    return muscle.fields();
  }
  /** @param {any} why */
  const problem = (why) => understood.replaceChildren(problemBox(why));

  /** @param {string} name @param {string} text */
  async function take(name, text) {
    measured.set({ name, text });
    data = measured.file;
    keepFile(CONSTANTS, undefined);
    [compared, known] = [undefined, undefined];
    begin();
    found.replaceChildren();
    fitted.show(undefined);
    await look();
  }

  /** The table as it is used. */
  function begin() {
    if (data) columns.offer(headings(data.text));
  }

  let looking = new AbortController();
  async function look() {
    const read = await what.read();
    if (!data || !read || !main.contains(understood)) return;
    place();
    looking.abort();
    const { signal } = (looking = new AbortController());
    measured.set(data, columns.value());
    try {
      const request = { ...fields(), data, columns: columns.value(), models: read.models, extrapolate: true, figure: unitName("pressure") };
      compared = await engine().ask("compare", request, { signal });
      paint();
      stale(false);
      figures.show(compared.figure);
    } catch (why) {
      if (signal.aborted) return;
      problem(why);
      if (/** @type {any} */ (why).kind === "data") columns.open();
      stale(true);
    }
  }
  const stale = (/** @type {boolean} */ on) => [errors, figures.element].forEach((part) => part.classList.toggle("stale", on));
  const place = () => write(address("data", { ...muscle.params(), ...what.texts(), columns: columns.text() }), true);

  function paint() {
    if (compared && data) {
      const u = compared.understood?.[0] ?? compared.understood;
      const list = u?.columns?.map((/** @type {any} */ c) => `${c.column} → ${c.quantity}${c.unit ? ` (${c.unit})` : ""}`).join(", ");
      const { said } = measured;
      understood.replaceChildren(el("p", {}, `${data.name}: ${compared.points} points. ${list ?? ""}`), warnings([...(said ? [said] : []), ...(compared.warnings ?? [])]));
      errors.replaceChildren(errorTable(compared.models));
    }
    if (known) found.replaceChildren(...identifiedView(known));
  }

  // Figures are drawn by the engine in the units that are asked for.
  atEnd(onUnits(() => { paint(); place(); if (compared) look(); }));
  return {
    /** @param {URLSearchParams} params */
    async load(params) {
      await muscle.read(params, [...what.keys, "columns"]);
      what.set(params);
      columns.read(params.get("columns") ?? "");
      data = measured.file;
      begin();
      fields();
      if (data) await look();
      // What was identified before is there again.
      if (data && fileOf(CONSTANTS)) identify.run();
    },
    unmount() { identify.end(); looking.abort(); },
  };
}
