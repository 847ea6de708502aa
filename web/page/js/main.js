// The frame around the pages: which one is shown follows from the address.
import { engine, loadUnits } from "./ask.js";
import { address, onWritten, read, write } from "./address.js";
import { muscleBar } from "./bar.js";
import { byId, dim, el, mainButton, notice, paragraph, problemBox } from "./dom.js";
import { dropAnywhere } from "./drop.js";
import { helpButton } from "./help.js";
import { keepWords, keeping, onKept, wordsOf } from "./kept.js";
import { endAll } from "./life.js";
import { loadMeasures, muscle } from "./muscle.js";
import { offline } from "./offline.js";
import { SCRIPTS } from "./place.js";
import { PLACES, pageOf, viewsOf } from "./pages.js";
// The first screen comes with the frame.
import "./pages/start.js";
import { printing } from "./print.js";
import { sketches } from "./sketch.js";
import { keys } from "./state.js";
import { record, step } from "./steps.js";
import { followSystem } from "./theme.js";

const main = byId("main");
/** @typedef {{ load: (params: URLSearchParams) => Promise<void> }} View */
/** @type {{ name: string, page: View } | undefined} */ let shown;
let routes = 0;

// Words of the muscle mean other things in a specification: it is one word there.
const OWN_WORDS = ["design"];
/** The view of a place that was shown last. @type {Map<string, string>} */ const last = new Map();

/**
 * A page's address with a muscle and what was typed there.
 * @param {string} name @param {Record<string, string | undefined>} mine
 */
function linked(name, mine = muscle.params()) {
  const own = wordsOf(name);
  return address(
    name,
    OWN_WORDS.includes(name) ? { ...own, m: muscle.word() } : { ...own, ...mine },
  );
}
const places = PLACES.map(([place, text, short]) =>
  el(
    "a",
    { href: `#${place}`, "data-place": place },
    el("span", text),
    el("span", { class: "short", ariaHidden: true }, short),
  ),
);
byId("pages").append(...places);
const views = byId("views");

/** Links lead to the muscle as it is now. */
function link() {
  const put = (/** @type {HTMLAnchorElement} */ a, /** @type {string} */ name) => {
    const to = linked(name);
    if (a.getAttribute("href") !== to) a.setAttribute("href", to);
  };
  for (const a of places) put(a, last.get(a.dataset.place ?? "") ?? a.dataset.place ?? "");
  for (const a of views.querySelectorAll("a")) put(a, a.dataset.name ?? "");
}

/** What a page has put into the address besides the muscle is its own. */
async function keep() {
  const { page, params } = await read();
  if (shown?.name !== page) return;
  const theirs = OWN_WORDS.includes(page)
    ? ["m"]
    : [...keys(), "u", "name", ...muscle.unknown.map(([key]) => key)];
  keepWords(page, Object.fromEntries([...params].filter(([key]) => !theirs.includes(key))));
}

const bar = muscleBar(walk, () => {
  write(linked(shown?.name ?? "muscle"));
  muscle.tell();
}, [helpButton()]);
byId("bar").append(bar.element);
followSystem();
// What is typed makes a problem an older one, until the next answer.
addEventListener("input", () =>
  dim(/** @type {HTMLElement[]} */ ([...document.querySelectorAll(".problem")]), true),
);

/** Steps that are being gone back to: the muscle on the way there is none. */
let walking = 0;
/** Undo and redo of the muscle, on the page that is shown. @param {-1 | 1} by */
async function walk(by) {
  const words = step(by),
    { name } = pageOf(location.hash.slice(1).split("?")[0]);
  if (!words) return;
  const query = { ...words, u: muscle.params().u };
  history.replaceState(
    null,
    "",
    OWN_WORDS.includes(name)
      ? address(name, { ...wordsOf(name), m: address("", query).slice(2) })
      : linked(name, query),
  );
  walking++;
  await route();
  walking--;
  bar.paint();
}

/** @param {string} name */
function frame(name) {
  const { text, about, place } = pageOf(name),
    list = viewsOf(place);
  last.set(place, name);
  for (const a of places) a.ariaCurrent = a.dataset.place === place ? "page" : null;
  const links =
    place && list.length > 1
      ? list.map((view) =>
          el(
            "a",
            {
              "data-name": view.name,
              href: `#${view.name}`,
              ariaCurrent: view.name === name && "page",
            },
            view.text,
          ),
        )
      : [];
  views.replaceChildren(...links);
  views.hidden = !links.length;
  byId("claim").textContent = about;
  byId("title").textContent = text;
  document.title = `${text} – mckibben workbench`;
  document.body.dataset.page = name;
}

/**
 * How often a page could not be loaded: browsers keep a failure with its address.
 * @type {Record<string, number>}
 */
const failures = {};
/** @param {string} name */
async function pageOfServer(name) {
  const again = failures[name] ? `?again=${failures[name]}` : "";
  try {
    return await import(new URL(`pages/${name}.js${again}`, SCRIPTS).href);
  } catch (problem) {
    failures[name] = (failures[name] ?? 0) + 1;
    throw problem;
  }
}

async function route() {
  const mine = ++routes,
    { page: wanted, params, lost } = await read();
  if (mine !== routes) return;
  const { name } = pageOf(wanted);
  if (name !== wanted) notice(`There is no page "${wanted.slice(0, 40)}". This is the muscle.`);
  if (lost.length)
    notice(
      "The link is damaged: a file in it cannot be read. Ask for the link again, or for the file.",
    );
  frame(name);
  try {
    if (shown?.name !== name) {
      const { mount } = await pageOfServer(name);
      if (mine !== routes) return;
      leave();
      shown = { name, page: mount(main) };
      main.dataset.shown = name;
    }
    const { page } = /** @type {NonNullable<typeof shown>} */ (shown);
    await page.load(params);
    if (mine !== routes) return;
    await keep();
    link();
  } catch (problem) {
    fail(problem);
  }
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
    await Promise.all([loadUnits(), loadMeasures()]);
    await route();
  } catch (problem) {
    fail(problem);
  }
}

/** The muscle after a gesture is a step; not while a pointer is down. */
let down = false;
function changed() {
  // Before the muscle of the address is read there is none.
  if (!down && !walking && muscle.shown) record();
  link();
  bar.paint();
}
for (const event of ["pointerdown", "pointerup", "pointercancel"]) {
  addEventListener(
    event,
    () => {
      down = event === "pointerdown";
      if (!down) muscle.touch();
    },
    true,
  );
}
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
// A page writes at the end of a gesture.
onWritten(() => {
  changed();
  keeping(keep().then(link));
});
onKept(link);
muscle.onChange(changed);
// A link that is followed right after a gesture has the muscle of that gesture.
for (const box of [byId("pages"), views])
  for (const event of ["pointerdown", "focusin"]) box.addEventListener(event, () => muscle.tell());
addEventListener("popstate", route);
sketches();
printing();
dropAnywhere();
start().then(offline);
