// A project: several muscles, measured points, joint and drive in one file, and in this tab until it is closed.
import { address } from "./address.js";
import { dialog } from "./dialog.js";
import { download, el, problemBox } from "./dom.js";
import { everything, fileOf, keepFile, replaceAll } from "./kept.js";
import { pack } from "./deflate.js";
import { muscle } from "./muscle.js";
import { fileName, nameIn } from "./name.js";
import { notice } from "./notice.js";

const FORMAT = "mckibben-project";
/**
 * A muscle of the project: its file with its name, and where it was looked at.
 * @typedef {{ name: string, file: string, point: Record<string, string> }} Kept
 */
/**
 * @typedef {{ format: string, version: number, muscles: Kept[], shown: string, words: Record<string, Record<string,
 *   string>>, files: Omit<import("./kept.js").Files, "muscles"> }} Project
 */

/** @returns {Kept[]} */
const shelf = () => fileOf("muscles") ?? [];
/** The point of the present muscle, as words of the address. */
function point() {
  const { p, e, F } = muscle.params();
  return /** @type {Record<string, string>} */ (Object.fromEntries(
    Object.entries({ p, e, F }).filter(([, word]) => word),
  ));
}

/** The present muscle goes into the project, in place of one of the same name. */
async function add() {
  const one = { name: muscle.name, file: await muscle.toml(), point: point() };
  keepFile("muscles", [...shelf().filter(({ name }) => name !== one.name), one]);
}

/** @param {Kept} one */
async function show({ file, point }) {
  await pack(file);
  location.hash = address("muscle", { ...point, file });
}

/** The project as a file. */
async function saved() {
  await add();
  const { words, files: { muscles = [], ...files } } = everything();
  /** @type {Project} */
  const project = { format: FORMAT, version: 1, muscles, shown: muscle.name, words, files };
  return JSON.stringify(project, null, 2) + "\n";
}

/** @param {unknown} read @returns {read is Project} */
function isProject(read) {
  const project = /** @type {Partial<Project> | null} */ (read);
  const texts = (/** @type {unknown} */ of) =>
    typeof of === "object" && of !== null && Object.values(of).every((text) => typeof text === "string");
  return project?.format === FORMAT && Array.isArray(project.muscles) &&
    project.muscles.every((m) =>
      typeof m?.name === "string" && typeof m.file === "string" && texts(m.point ?? {})
    )
    && Object.values(project.words ?? {}).every(texts) && typeof (project.files ?? {}) === "object";
}

/** @param {string} text */
export async function openProject(text) {
  /** @type {unknown} */ let read;
  try {
    read = JSON.parse(text);
  } catch (problem) {
    throw new Error(`The project cannot be read: ${/** @type {Error} */ (problem).message}.`);
  }
  if (!isProject(read)) throw new Error("This is no project of the workbench, or one of a newer version.");
  if (read.version > 1) throw new Error(`The project has version ${read.version}; this workbench reads version 1.`);
  const one = read.muscles.find(({ name }) => name === read.shown) ?? read.muscles[0];
  replaceAll({ words: read.words ?? {}, files: { ...read.files, muscles: read.muscles } });
  notice(`Opened a project with ${read.muscles.length} ${read.muscles.length === 1 ? "muscle" : "muscles"}.`);
  if (one) await show(one);
}

export function projectDialog() {
  dialog("Project", (close) => {
    const said = el("div", {}), list = el("ul", { class: "shelf" });
    const act = (/** @type {() => Promise<void> | void} */ work) => async () => {
      try {
        await work();
        paint();
      } catch (problem) {
        said.replaceChildren(problemBox(problem));
      }
    };
    const button = (/** @type {string} */ text, /** @type {() => Promise<void> | void} */ work, title = text) =>
      el("button", { type: "button", onclick: act(work), "aria-label": title }, text);
    function paint() {
      const rows = shelf().map((one) =>
        el("li", { class: "row" }, el("span", { class: "grow" }, one.name || nameIn(one.file)),
          button("Show", async () => {
            await show(one);
            close();
          }, `Show ${one.name}`), button("Remove", () =>
            keepFile("muscles", shelf().filter((other) => other !== one)), `Remove ${one.name}`))
      );
      list.replaceChildren(...(rows.length ? rows : [el("li", { class: "soft" }, "No muscle yet.")]));
      const data = fileOf("data");
      parts.textContent = data
        ? `Measured points: ${data.name}. What was typed on the other pages belongs to the project too.`
        : "What was typed on the other pages belongs to the project too.";
    }
    const parts = el("p", { class: "small soft" });
    paint();
    return [
      el("p", {},
        "A project keeps several muscles with their measured points, joint and drive. It lasts until this tab is "
          + "closed; save it as a file."),
      list,
      parts,
      said,
      el("p", { class: "row" }, button("Add this muscle", add),
        button("Save the project",
          async () => download(fileName(muscle.name, ".mckibben.json"), await saved(), "application/json"))),
      el("p", { class: "small soft" }, "To open a project, choose Open, or drop its file on the page."),
    ];
  });
}
