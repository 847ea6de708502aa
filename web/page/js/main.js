// The frame around the pages: which one is shown follows from the address.
import { engine, loadUnits } from "./ask.js";
import { read, write } from "./address.js";
import { muscleBar } from "./bar.js";
import { byId, dim, el, mainButton, notice, paragraph, problemBox } from "./dom.js";
import { dropAnywhere } from "./drop.js";
import { helpButton, helpDialog } from "./help.js";
import { keepWords, wordsOf } from "./kept.js";
import { loadMeasures, muscle } from "./muscle.js";
import { offline } from "./offline.js";
import { SCRIPTS } from "./place.js";
import { MOVED, PAGES, PLACES, pageOf, viewsOf } from "./pages.js";
// The first screen comes with the frame.
import "./pages/design.js";
import { keys } from "./state.js";
import { record, step } from "./steps.js";
import { effect, endAll, signal } from "./watch.js";

const main = byId("main");
/** @typedef {{ load: (params: URLSearchParams) => Promise<void> }} View */
/** @type {{ name: string, page: View } | undefined} */ let shown;
let routes = 0,
  /** Until the address is read its muscle is not there. */
  routing = true,
  /** What the address says, as the page would write it. */
  same = "";

/** The view of a place that was shown last. @type {Map<string, string>} */ const last = new Map();
const places = PLACES.map(([place, text]) =>
  el("a", { href: `#${place}`, "data-place": place }, text),
);
byId("pages").append(...places);
const views = byId("views");

/** Links lead to the muscle as it is now. */
function link() {
  for (const a of [...places, ...views.querySelectorAll("a")]) {
    const { name, place = "" } = a.dataset;
    a.href = muscle.linked(name ?? last.get(place) ?? place);
  }
}

const bar = muscleBar(walk, [helpButton()]);
byId("bar").append(bar.element);
// What is typed makes a problem an older one, until the next answer.
addEventListener("input", () =>
  dim(/** @type {HTMLElement[]} */ ([...document.querySelectorAll(".problem")]), true),
);

/** Undo and redo of the muscle, on the page that is shown. @param {-1 | 1} by */
async function walk(by) {
  const words = step(by);
  if (!words || !shown) return;
  history.replaceState(null, "", muscle.linked(shown.name, { ...words, u: muscle.params().u }));
  await route();
}

/** @param {string} name */
function frame(name) {
  const { text, about, place } = pageOf(name),
    list = viewsOf(place);
  last.set(place, name);
  for (const a of places) a.ariaCurrent = a.dataset.place === place ? "page" : null;
  views.hidden = list.length < 2;
  views.replaceChildren(
    ...(views.hidden ? [] : list).map(({ name: view, text }) =>
      el("a", { "data-name": view, href: `#${view}`, ariaCurrent: view === name && "page" }, text),
    ),
  );
  byId("claim").textContent = about;
  byId("title").textContent = text;
  document.title = `${text} – mckibben workbench`;
  document.body.dataset.page = name;
}

/** How often a page could not be loaded: browsers keep a failure with its address. */
let failures = 0;
/** @param {string} name */
async function pageOfServer(name) {
  try {
    const again = failures ? `?again=${failures}` : "";
    return await import(new URL(`pages/${name}.js${again}`, SCRIPTS).href);
  } catch (problem) {
    failures++;
    throw problem;
  }
}

/** What old links open, in windows now. @type {Record<string, () => unknown>} */
const WINDOWS = {
  about: helpDialog,
  parts: async () => (await import("./parts.js")).partsDialog(),
  files: async () => (await import("./files.js")).filesDialog(),
};
/** B of an old comparison is the muscle now, and A is held beside it. @param {URLSearchParams} params */
function compared(params) {
  const b = [...keys(), "model"].flatMap((key) => {
    const word = params.get(`b${key}`);
    params.delete(`b${key}`);
    return word ? [[key === "model" ? "over" : key, word]] : [];
  });
  params.delete("amodel");
  params.set("held", params.toString());
  for (const [key, word] of b) params.set(key, word);
}

/** The page of an address of today. @param {string} wanted @param {URLSearchParams} params */
function moved(wanted, params) {
  const { name } = pageOf(wanted);
  if (wanted === "sweep") params.set("test", "sweep");
  if (wanted === "compare") compared(params);
  if (wanted === "formula")
    notice("The place Formula is gone: `campaign` and `fit` make a formula; drop its file here.");
  else if (!(wanted in MOVED || wanted in WINDOWS) && name !== wanted)
    notice(`There is no page "${wanted.slice(0, 40)}". This is the muscle.`);
  return name;
}

async function route() {
  const mine = ++routes;
  routing = true;
  const { page: wanted, params, lost } = read(),
    name = moved(wanted, params);
  if (lost.length) notice("The link is damaged: ask for it again, or for its file.");
  frame(name);
  try {
    if (shown?.name !== name) {
      const { mount } = await pageOfServer(name);
      if (mine !== routes) return;
      leave();
      shown = { name, page: mount(main) };
      main.dataset.shown = name;
    }
    // What a page has put into the address besides the muscle is its own.
    const theirs = name === "design" ? ["m"] : [...keys(), "u", "name"];
    keepWords(name, Object.fromEntries([...params].filter(([key]) => !theirs.includes(key))));
    const { page } = /** @type {NonNullable<typeof shown>} */ (shown);
    await page.load(params);
    if (mine !== routes) return;
    WINDOWS[wanted]?.();
  } catch (problem) {
    fail(problem);
  }
  same = muscle.linked(name);
  routing = false;
  changed();
}

/** The page that is shown ends, with all that it has begun. */
function leave() {
  shown = undefined;
  endAll();
}

/** @param {unknown} problem */
function fail(problem) {
  leave();
  main.replaceChildren(problemBox(problem), paragraph(mainButton("Try again", start)));
}

async function start() {
  try {
    engine();
    await Promise.all([loadUnits(), loadMeasures(), pageOfServer(pageOf(read().page).name)]);
    await route();
  } catch (problem) {
    fail(problem);
  }
}

const down = signal(false);
for (const event of ["pointerdown", "pointerup", "pointercancel"])
  addEventListener(event, () => (down.value = event === "pointerdown"), true);

/** After a gesture: a step, and what stands above every place. */
function changed() {
  if (routing) return;
  muscle.assess();
  if (!down.value && muscle.shown) record();
  bar.paint();
}
/** What stands above every place waits until the muscle rests: it does not hold up a drag. */
let resting = 0;
effect(() => {
  // All that it shows.
  void [muscle.params(), muscle.shown, muscle.warnings, PAGES.map(({ name }) => wordsOf(name))];
  // A reload has the last change.
  const to = shown ? muscle.linked(shown.name) : same;
  if (!down.value && !routing && to !== same) write((same = to));
  clearTimeout(resting);
  resting = window.setTimeout(changed, 120);
});
/** A field in which somebody types has an undo of its own. @type {EventTarget | null} */ let typing =
  null;
for (const event of ["input", "change"])
  addEventListener(
    event,
    ({ target, type }) => {
      typing = type === "input" ? target : null;
    },
    true,
  );
addEventListener(
  "keydown",
  (event) => {
    if (event.key === "Enter") typing = null;
    const key = event.ctrlKey || event.metaKey ? event.key.toLowerCase() : "";
    if (
      (key !== "z" && key !== "y") ||
      event.target === typing ||
      document.querySelector("dialog[open]")
    )
      return;
    event.preventDefault();
    walk(key === "y" || event.shiftKey ? 1 : -1);
  },
  true,
);
// A link that is followed right after a gesture has the muscle of that gesture.
for (const box of [byId("pages"), views])
  for (const event of ["pointerdown", "focusin"]) box.addEventListener(event, link);
addEventListener("popstate", route);
dropAnywhere();
start().then(offline);
