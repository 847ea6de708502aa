// The muscle as files: a report, what the workshop needs, code for controllers and simulators, and files of
// finite-element programs.
import { engine } from "../ask.js";
import { address, write } from "../address.js";
import { choice } from "../controls.js";
import { download, el } from "../dom.js";
import { filesView } from "../files-view.js";
import { form, job, warnings } from "../form.js";
import { atEnd } from "../life.js";
import { muscle } from "../muscle.js";
import { fileName } from "../toml.js";
import { withViewer } from "../report.js";
import { number, onUnits, show, unitName } from "../units.js";

/** @typedef {Commands["export-list"]["answer"]["targets"][number]} Target */
/** What a report states of itself; the name is that of the muscle. @type {Field[]} */
export const TITLE = [
  { key: "project", field: "project", label: "Project" },
  { key: "number", field: "number", label: "Number" },
  { key: "revision", field: "revision", label: "Revision" },
  { key: "date", field: "date", label: "Date" },
];
/** Where a form for controllers is fitted. @type {Field[]} */
export const BOX = [
  { key: "supply", field: "pressure_mpa", label: "Pressure of the supply", kind: "pressure" },
  { key: "elow", field: "contraction_low", label: "Contraction from", kind: "ratio", hint: "-5 %" },
  { key: "ehigh", field: "contraction_high", label: "Contraction to", kind: "ratio", hint: "free contraction" },
];
const MODELS = /** @type {[string, string][]} */ ([["fe", "fe: axisymmetric, quick"],
  ["fe3d", "fe3d: three-dimensional, with input deck"]]);

const units = () => ["pressure", "force", "length"].map(unitName).join(",");

/** @param {string} title @param {string} about @param {...(Node | string | null)} parts */
const card = (title, about, ...parts) =>
  el("section", { class: "card-of-files", "aria-label": title }, el("h2", {}, title), el("p", { class: "soft" }, about),
    ...parts);

/** The report. @param {() => void} place */
function reportCard(place) {
  const title = form(TITLE, () => go.run()), done = el("div", {});
  const go = job("Make the report", "build", async () => {
    place();
    const read = await title.read();
    if (!read) return undefined;
    done.replaceChildren();
    return { ...muscle.fields(), ...(muscle.p > 0 ? { pressure_mpa: muscle.p } : {}), contraction: muscle.e,
      units: units(), name: muscle.name, ...read, report: true };
  }, async (answer) => {
    const html = await withViewer(answer.files.find(({ name }) => name === "report.html")?.text ?? "");
    const name = fileName(muscle.name, "-report.html"), save = () => download(name, html, "text/html");
    done.replaceChildren(warnings(answer.warnings), el("p", {},
      el("button", { type: "button", class: "main", onclick: save }, `Save ${name}`), " ",
      el("span", { class: "soft" }, `${number(html.length / 1e3, 3)} kB; open it in a browser, and print it there.`)));
  });
  const about = "Title block, state, curves, drawing, margins of safety, and a sheet for the first bench test.";
  return { form: title, job: go, element: card("Report", about, title.element, go.element, done) };
}

/** Errors of an export, as shares of the blocked force. @param {Commands["export"]["answer"]} answer */
function errorLine(answer) {
  const share = (/** @type {number} */ x) => `${number(100 * x, 2)} %`;
  return `${share(answer.force_rms)} rms and ${share(answer.force_worst_ratio)} at worst of the blocked force `
    + `${show("force", answer.blocked_force_n)}, at ${answer.points} points up to `
    + `${show("pressure", answer.supply_pressure_mpa, 3)} and ${show("ratio", answer.contraction_high, 3)}; volume `
    + `${share(answer.volume_worst_ratio)} at worst. Against ${answer.model}, whose own ± is `
    + `${show("force", answer.uncertainty_n, 2)}.`;
}

/** Code. @param {() => void} place */
function exportCard(place) {
  /** @type {readonly Target[]} */ let targets = [];
  const box = form(BOX, () => go.run()), done = el("div", {}), about = el("p", { class: "small soft" });
  const state = { target: "c" };
  const pick = choice("Target", [["c", "c"]], "c", (name) => {
    state.target = name;
    paint();
    place();
  });
  function paint() {
    const one = targets.find(({ name }) => name === state.target);
    pick.set(state.target);
    about.textContent = one ? `${one.about}. Needs ${one.needs}. Loses ${one.loses}.` : "";
    box.usual("supply", muscle.p ? show("pressure", muscle.p) : "");
  }
  const go = job("Export", "export", async () => {
    place();
    const read = await box.read();
    if (!read) return undefined;
    done.replaceChildren();
    return { pressure_mpa: muscle.p || undefined, ...read, ...muscle.fields(), target: state.target,
      name: muscle.called ? fileName(muscle.called, "").replace(/\W/g, "_") : undefined };
  }, (answer) => {
    const lines = [el("p", {}, `Error: ${errorLine(answer)}`), warnings(answer.warnings)];
    done.replaceChildren(...lines, filesView(answer.files, `${answer.name}-${answer.target}`));
  }, (problem) => {
    box.at(problem);
  });
  const text = "One closed form of pull and volume, fitted to the finite elements, in the language of its host.";
  engine().ask("export-list", {}).then((answer) => {
    targets = answer.targets;
    pick.options(targets.map(({ name }) => name));
    paint();
  }, () => {});
  return { form: box, job: go, state, paint,
    element: card("Controllers and simulators", text, pick.element, about, box.element, go.element, done) };
}

/** The deformed muscle for other programs. @param {() => void} place */
function elementsCard(place) {
  const done = el("div", {}), state = { model: "fe" };
  const pick = choice("Model", MODELS, "fe", (name) => {
    state.model = name;
    place();
  });
  const go = job("Compute", "simulate", async () => {
    place();
    done.replaceChildren();
    return { ...muscle.fields(), test: /** @type {const} */ ("isometric"), model: state.model, two_sided: true,
      pressures_mpa: [muscle.p], contractions: [muscle.e], vtu: true, deck: state.model === "fe3d" };
  }, (answer) => {
    const deck = answer.deck
      ? [{ name: "muscle.inp", about: "mesh, material, loads and steps for CalculiX and Abaqus", text: answer.deck }]
      : [];
    done.replaceChildren(warnings([...answer.notes, ...answer.warnings]),
      filesView([...(answer.files ?? []), ...deck], fileName(muscle.name, `-${state.model}`)));
  });
  const about = "The deformed muscle at the present pressure and contraction for ParaView (VTU). fe3d also writes the "
    + "input deck of the test for CalculiX and Abaqus.";
  return { job: go, state, pick, element: card("Finite elements", about, pick.element, go.element, done) };
}

/** Cut list, drawing, plugs, steps and test sheet. */
function workshopCard() {
  const done = el("div", {});
  const go = job("Make the build sheet", "build", async () => ({ ...muscle.fields(),
    pressure_mpa: muscle.p || undefined }),
    (answer) => {
      const [at, proof] = [answer.pressure_mpa, answer.proof_pressure_mpa].map((p) => show("pressure", p, 3));
      const cut = `At ${at}: cut ${show("length", answer.cut.tube_mm)} of tube. Proof test with water at ${proof}.`;
      done.replaceChildren(el("p", {}, cut), warnings(answer.warnings),
        filesView(answer.files, fileName(muscle.name, "-build")));
    });
  const about = "Cut list, plugs to print or turn, drawing, bill of materials, steps, and the sheet of the first test.";
  return { job: go, element: card("Workshop", about, go.element, done) };
}

/** @param {HTMLElement} main */
export function mount(main) {
  const report = reportCard(() => place()), out = exportCard(() => place()), elements = elementsCard(() => place());
  const workshop = workshopCard();
  const forms = [report.form, out.form];
  main.replaceChildren(
    el("div", { class: "cards-of-files" }, report.element, workshop.element, out.element, elements.element));

  const place = () => {
    if (!main.contains(report.element)) return;
    const own = { target: out.state.target === "c" ? "" : out.state.target,
      elements: elements.state.model === "fe" ? "" : elements.state.model };
    const texts = Object.assign({}, ...forms.map((f) => f.texts()));
    write(address("files", { ...muscle.params(), ...texts, ...own }));
  };
  atEnd(onUnits(() => {
    out.paint();
    place();
  }));
  return {
    /** @param {URLSearchParams} params */
    async load(params) {
      // At once: what is chosen while the muscle is read counts.
      forms.forEach((f) => f.set(params));
      out.state.target = params.get("target") ?? "c";
      elements.state.model = params.get("elements") === "fe3d" ? "fe3d" : "fe";
      elements.pick.set(elements.state.model);
      await muscle.read(params, [...forms.flatMap((f) => f.keys), "target", "elements"]);
      out.paint();
    },
    unmount() {
      [report, workshop, out, elements].forEach(({ job }) => job.end());
    },
  };
}
