// Files that are dropped anywhere, or chosen: what each is follows from what it holds, and each
// goes to the page that it belongs to.
import { textOf } from "./controls.js";
import { headings } from "./columns.js";
import { ofFile } from "./joint-words.js";
import { keepFile, measured } from "./kept.js";
import { muscle, visit } from "./muscle.js";
import { stated } from "./toml.js";
import { notice, noticeProblem } from "./dom.js";

/**
 * @typedef {"muscle" | "joint" | "drive" | "data" | "rubber" | "project" | "formula" | "other"} Kind
 */
/** @typedef {{ name: string, text: string, kind: Kind }} Read */
const MOST = 60_000_000;
/** Tables that tell a file of TOML from a muscle's. @type {[string, Kind][]} */
const TABLES = [
  ["joint", "joint"],
  ["vary", "other"],
  ["sampling", "other"],
  ["command", "drive"],
  ["valve", "drive"],
];

/**
 * Whether a table is a test of a rubber: stretches or strains with stresses, and no contraction.
 * @param {string} text
 */
function isRubberTest(text) {
  const head = headings(text).join(" ").toLowerCase();
  return (
    /stretch|strain|dehnung|lambda/.test(head) &&
    /stress|spannung|mpa/.test(head) &&
    !/contraction|pressure|druck/.test(head)
  );
}

/** What a file is. @param {string} name @param {string} text @returns {Kind} */
function kindOfFile(name, text) {
  if (/\.json$/i.test(name))
    return text.includes('"mckibben-project"')
      ? "project"
      : text.includes('"equation"')
        ? "formula"
        : "other";
  if (/\.(csv|tsv|txt|dat|xlsx|ods)$/i.test(name)) return isRubberTest(text) ? "rubber" : "data";
  const tables = [...stated(text).keys()].map((place) => place.split(".")[0]);
  return (
    TABLES.find(([table]) => tables.includes(table))?.[1] ??
    (/\.toml$/i.test(name) ? "muscle" : "other")
  );
}

/** The muscle files that a joint or drive names, without their folders. @param {string} text */
const namedIn = (text) =>
  [...stated(text)].flatMap(([place, file]) =>
    /\.(file|muscle)$/.test(place) ? [file.split("/").pop() ?? ""] : [],
  );

/** @param {Read[]} files */
async function take(files) {
  const [project, formula, joint, drive, data, rubber] = /** @type {const} */ ([
    "project",
    "formula",
    "joint",
    "drive",
    "data",
    "rubber",
  ]).map((kind) => files.find((file) => file.kind === kind));
  if (project) return openProject(project.text);
  if (formula) {
    keepFile("formula", { name: formula.name, text: formula.text });
    notice(`${formula.name} is among the models of the isobaric curves, under Another model.`);
    return visit("muscle", { over: formula.name });
  }
  const muscles = files.filter((file) => file.kind === "muscle"),
    wanted = namedIn(joint?.text ?? drive?.text ?? "");
  const own = muscles.find((file) => file.name === wanted[0]) ?? muscles[0];
  const second = muscles.find((file) => file.name === wanted[1] && file !== own);
  if (own) await muscle.take(own.text, own.name);
  if (data) measured.set({ name: data.name, text: data.text });
  if (rubber) keepFile("rubber", { name: rubber.name, text: rubber.text });
  const lacks = (joint || drive) && !own && wanted[0];
  const what = files.map((file) => file.name).join(", ");
  notice(
    `Opened ${what}.`,
    lacks
      ? ` It names ${wanted[0]}, which was not among the files: the muscle of this page ` +
          "takes its place."
      : "",
  );
  if (drive) return visit("motion", { drive: drive.text });
  if (joint) return visit("joint", { ...ofFile, joint: joint.text, file2: second?.text });
  // Over the curves of the page Muscle they are at their place too.
  const isElsewhere = data && document.body.dataset.page !== "muscle";
  return visit(isElsewhere ? "data" : rubber ? "rubber" : "muscle", {});
}

/** A project of before: the muscle of it that was shown. @param {string} text */
async function openProject(text) {
  const { muscles = [], shown } = JSON.parse(text),
    one = muscles.find((/** @type {{ name: string }} */ m) => m.name === shown) ?? muscles[0];
  if (!one) throw new Error("The project has no muscle.");
  await muscle.take(one.file);
  notice(
    `Opened ${one.name}. Projects are gone: of ${muscles.length} muscles this is the one that was shown; ` +
      "a muscle file and a table keep the others.",
  );
  return visit("muscle", {});
}

/** @param {readonly File[]} files */
export async function takeFiles(files) {
  try {
    /** @type {Read[]} */ const read = [];
    for (const file of files) {
      if (file.size > MOST) throw new Error(`${file.name} is larger than 60 MB.`);
      const text = await textOf(file);
      if (!text.trim()) throw new Error(`${file.name} is empty.`);
      read.push({ name: file.name, text, kind: kindOfFile(file.name, text) });
    }
    const other = read.find(({ kind }) => kind === "other");
    if (other)
      throw new Error(
        `${other.name} is no file of this page: muscles, joints and drives end in .toml, measured points in .csv, ` +
          ".xlsx or .ods, formulas in .json; plans are for the command campaign.",
      );
    if (read.length) await take(read);
  } catch (problem) {
    noticeProblem(problem);
  }
}

/**
 * The whole window takes files, and cells that are pasted; boxes for one kind of file come first.
 */
export function dropAnywhere() {
  addEventListener("paste", (event) => {
    const at = /** @type {Element} */ (event.target);
    if (at.closest("input, textarea, [contenteditable]")) return;
    const files = [...(event.clipboardData?.files ?? [])],
      text = event.clipboardData?.getData("text/plain") ?? "";
    if (!files.length && /[\t,;].*\n/.test(text)) files.push(new File([text], "pasted.csv"));
    if (files.length) takeFiles(files);
  });
  const { classList } = document.body;
  addEventListener("dragover", (event) => {
    if (!event.dataTransfer?.types.includes("Files")) return;
    event.preventDefault();
    classList.toggle("dropping", !(/** @type {Element} */ (event.target).closest(".drop")));
  });
  addEventListener("dragleave", (event) => {
    if (!event.relatedTarget) classList.remove("dropping");
  });
  addEventListener("drop", (event) => {
    classList.remove("dropping");
    const files = [...(event.dataTransfer?.files ?? [])];
    // A box for one kind of file has taken it.
    if (!files.length || event.defaultPrevented) return;
    event.preventDefault();
    takeFiles(files);
  });
}
