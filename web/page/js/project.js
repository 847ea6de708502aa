// A project: several muscles, measured points, joint and drive in one file, and in this tab until
// it is closed.
import { address, pack } from "./address.js";
import { block, button, download, el, notice, remark, rowOf } from "./dom.js";
import { everything, fileOf, keepFile, replaceAll } from "./kept.js";
import { muscle } from "./muscle.js";
import { fileName, nameIn } from "./toml.js";

const FORMAT = "mckibben-project";
/**
 * @typedef {{ format: string, version: number, muscles: KeptMuscle[], shown: string, words:
 * Record<string, Words>,
 *   files: Omit<KeptFiles, "muscles"> }} Project
 */

/** @returns {KeptMuscle[]} */
const kept = () => fileOf("muscles") ?? [];
/** The point of the present muscle, as words of the address. */
function point() {
  const { p, e, F } = muscle.params();
  return /** @type {Record<string, string>} */ (
    Object.fromEntries(Object.entries({ p, e, F }).filter(([, word]) => word))
  );
}

/** The present muscle goes into the project, in place of one of the same name. */
async function add() {
  const one = { name: muscle.name, file: await muscle.toml(), point: point() };
  keepFile("muscles", [...kept().filter(({ name }) => name !== one.name), one]);
}

/** @param {KeptMuscle} one */
async function show({ file, point }) {
  await pack(file);
  location.hash = address("muscle", { ...point, file });
}

/** The project as a file. */
async function saved() {
  await add();
  const {
    words,
    files: { muscles = [], ...files },
  } = await everything();
  /** @type {Project} */
  const project = { format: FORMAT, version: 1, muscles, shown: muscle.name, words, files };
  return JSON.stringify(project, null, 2) + "\n";
}

/** @param {unknown} read @returns {read is Project} */
function isProject(read) {
  const project = /** @type {Partial<Project> | null} */ (read);
  const texts = (/** @type {unknown} */ of) =>
    typeof of === "object" &&
    of !== null &&
    Object.values(of).every((text) => typeof text === "string");
  return (
    project?.format === FORMAT &&
    Array.isArray(project.muscles) &&
    project.muscles.every(
      (m) => typeof m?.name === "string" && typeof m.file === "string" && texts(m.point ?? {}),
    ) &&
    Object.values(project.words ?? {}).every(texts) &&
    typeof (project.files ?? {}) === "object"
  );
}

/** @param {string} text */
export async function openProject(text) {
  /** @type {unknown} */ let read;
  try {
    read = JSON.parse(text);
  } catch (problem) {
    throw new Error(`The project cannot be read: ${/** @type {Error} */ (problem).message}.`);
  }
  if (!isProject(read))
    throw new Error("This is no project of the workbench, or one of a newer version.");
  if (read.version > 1)
    throw new Error(`The project has version ${read.version}; this workbench reads version 1.`);
  const one = read.muscles.find(({ name }) => name === read.shown) ?? read.muscles[0];
  replaceAll({ words: read.words ?? {}, files: { ...read.files, muscles: read.muscles } });
  notice(
    `Opened a project with ${read.muscles.length} ${read.muscles.length === 1 ? "muscle" : "muscles"}.`,
  );
  if (one) await show(one);
}

/**
 * The muscles of the project, in the window Open.
 * @param {(problem: unknown) => void} fail @param {() => void} close
 */
export function shelf(fail, close) {
  const list = el("ul", { class: "shelf" });
  const act = (
    /** @type {string} */ text,
    /** @type {() => Promise<void> | void} */ work,
    title = text,
  ) =>
    button(
      text,
      async () => {
        try {
          await work();
          paint();
        } catch (problem) {
          fail(problem);
        }
      },
      { ariaLabel: title },
    );
  const open = async (/** @type {KeptMuscle} */ one) => {
    await show(one);
    close();
  };
  function paint() {
    list.replaceChildren(
      ...kept().map((one) =>
        el(
          "li",
          { class: "row" },
          el("span", { class: "grow" }, one.name || nameIn(one.file)),
          act("Show", () => open(one), `Show ${one.name}`),
          act(
            "Remove",
            () =>
              keepFile(
                "muscles",
                kept().filter((other) => other !== one),
              ),
            `Remove ${one.name}`,
          ),
        ),
      ),
    );
  }
  paint();
  return block(
    "",
    el("h3", "Project"),
    remark(
      "Several muscles with their measured points, joint and drive. It lasts until this tab is closed; save it as a file.",
    ),
    list,
    rowOf(
      act("Add this muscle", add),
      act("Save the project", async () =>
        download(fileName(muscle.name, ".mckibben.json"), await saved()),
      ),
    ),
  );
}
