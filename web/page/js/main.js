// The frame around the pages: which one is shown follows from the address.
import { engine, loadUnits } from "./ask.js";
import { address, arrived, onMoved, read, whileLoading } from "./address.js";
import { muscleBar } from "./bar.js";
import { isDark } from "./chart.js";
import { byId, el, problemBox } from "./dom.js";
import { dropAnywhere } from "./drop.js";
import { helpLink } from "./help.js";
import { keepWords, onKept, wordsOf } from "./kept.js";
import { endAll } from "./life.js";
import { loadMeasures, muscle } from "./muscle.js";
import { notice } from "./notice.js";
import { offline } from "./offline.js";
import { PAGES, pageOf } from "./pages.js";
import { printing } from "./print.js";
import { sketches } from "./sketch.js";
import { keys } from "./state.js";
import { welcome } from "./welcome.js";

const main = byId("main");
/** @typedef {{ load: (params: URLSearchParams) => Promise<void>, unmount: () => void }} View */
/** @type {{ name: string, page: View } | undefined} */ let shown;
let routes = 0;

// Words of the muscle mean other things in a specification: it is one word there.
const OWN_WORDS = ["design"];
const here = (/** @type {string} */ name) => location.hash.slice(1).split("?")[0] === name;
// Until the muscle is read, the link to this page is its address.
const links = PAGES.map(({ name, text }) =>
  el("a", { href: here(name) ? location.hash : `#${name}`, "data-name": name }, text)
);
byId("pages").append(...links);

/** A page's address with the muscle and what was typed there. @param {string} name */
function linked(name) {
  const own = wordsOf(name), mine = muscle.params();
  return address(name, OWN_WORDS.includes(name) ? { ...own, m: muscle.word() } : { ...own, ...mine });
}

/** Links lead to the muscle as it is now. */
function link() {
  for (const a of links) {
    const to = linked(a.dataset.name ?? "");
    if (a.getAttribute("href") !== to) a.setAttribute("href", to);
  }
}

/** What a page has put into the address besides the muscle is its own. */
async function keep() {
  const { page, params } = await read();
  if (shown?.name !== page) return;
  const theirs = OWN_WORDS.includes(page) ? ["m"] : [...keys(), "u", "name", ...muscle.unknown.map(([key]) => key)];
  keepWords(page, Object.fromEntries([...params].filter(([key]) => !theirs.includes(key))));
}

const theme = el("button", { type: "button", onclick: () => {
  document.documentElement.dataset.theme = isDark() ? "light" : "dark";
  paintTheme();
  document.dispatchEvent(new Event("theme"));
} }, "Dark");
const paintTheme = () => {
  theme.textContent = isDark() ? "Light" : "Dark";
};
const help = helpLink();
const bar = muscleBar();
byId("tools").append(help.element, theme);
byId("bar").append(bar.element);

/** @param {string} name */
function frame(name) {
  for (const a of links) {
    if (a.dataset.name === name) a.setAttribute("aria-current", "page");
    else a.removeAttribute("aria-current");
  }
  const { text, about } = pageOf(name);
  byId("claim").textContent = about;
  byId("title").textContent = text;
  help.show(name);
  document.title = `${text} – mckibben workbench`;
  document.body.dataset.page = name;
  document.body.classList.toggle("first", name === "muscle");
}

async function route() {
  const mine = ++routes, { page: wanted, params, lost, bare } = await read();
  if (mine !== routes) return;
  const { name } = pageOf(wanted);
  if (name !== wanted) notice(`There is no page "${wanted.slice(0, 40)}". This is the page Muscle.`);
  if (lost.length) notice("The link is damaged: a file in it cannot be read. Ask for the link again, or for the file.");
  frame(name);
  welcome(bare && name === "muscle");
  try {
    if (shown?.name !== name) {
      const { mount } = await import(`./pages/${name}.js`);
      if (mine !== routes) return;
      leave();
      shown = { name, page: mount(main) };
      main.dataset.shown = name;
    }
    const { page } = /** @type {NonNullable<typeof shown>} */ (shown);
    await whileLoading(() => page.load(params));
    if (mine !== routes) return;
    await keep();
    link();
  } catch (problem) {
    fail(problem);
  }
}

/** The page that is shown ends, with all that it has begun. */
function leave() {
  shown?.page.unmount();
  shown = undefined;
  endAll();
}

/** @param {unknown} problem */
function fail(problem) {
  leave();
  main.replaceChildren(problemBox(problem),
    el("p", {}, el("button", { type: "button", class: "main", onclick: start }, "Try again")));
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

paintTheme();
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", paintTheme);
onMoved(() => {
  bar.moved();
  keep().then(link, () => {});
});
onKept(link);
muscle.onChange(() => {
  link();
  bar.paint();
});
// A link that is followed right after a gesture has the muscle of that gesture.
for (const event of ["pointerdown", "focusin"]) byId("pages").addEventListener(event, () => muscle.tell());
window.addEventListener("popstate", () => {
  arrived();
  route();
});
sketches();
printing();
dropAnywhere();
start().then(offline);
