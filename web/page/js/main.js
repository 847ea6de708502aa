// The frame around the pages: which one is shown follows from the address.
import { engine } from "./ask.js";
import { address, read } from "./address.js";
import { isDark } from "./chart.js";
import { byId, el, problemBox } from "./dom.js";
import { loadMeasures, muscle } from "./muscle.js";
import { loadUnits } from "./units.js";

/** @type {[string, string][]} */
const PAGES = [["muscle", "Muscle"], ["design", "Design"], ["joint", "Joint"], ["motion", "Motion"], ["data", "Data"], ["formula", "Formula"], ["compare", "Compare"], ["about", "About"]];
const main = byId("main");
/** @type {{ name: string, page: any } | undefined} */ let shown;

const links = PAGES.map(([name, text]) => el("a", { href: `#${name}`, "data-name": name, onclick: (/** @type {MouseEvent} */ event) => {
  // The muscle goes along from page to page.
  if (event.metaKey || event.ctrlKey || event.button) return;
  event.preventDefault();
  history.pushState(null, "", address(name, muscle.params()));
  route();
} }, text));
byId("pages").append(...links);

const share = el("button", { type: "button", onclick: async () => {
  try { await navigator.clipboard.writeText(location.href); share.textContent = "Link copied"; }
  catch { prompt("The link to this view", location.href); }
  setTimeout(() => { share.textContent = "Share"; }, 1500);
} }, "Share");
const theme = el("button", { type: "button", onclick: () => {
  document.documentElement.dataset.theme = isDark() ? "light" : "dark";
  paintTheme();
  document.dispatchEvent(new Event("theme"));
} }, "Dark");
const paintTheme = () => { theme.textContent = isDark() ? "Light" : "Dark"; };
paintTheme();
byId("tools").append(share, theme);

async function route() {
  const { page: name, params } = read();
  const known = PAGES.some(([n]) => n === name) ? name : "muscle";
  for (const link of links) {
    if (link.dataset.name === known) link.setAttribute("aria-current", "page");
    else link.removeAttribute("aria-current");
  }
  document.title = `${PAGES.find(([n]) => n === known)?.[1]} – mckibben workbench`;
  document.body.classList.toggle("first", known === "muscle");
  try {
    if (shown?.name !== known) {
      shown?.page.unmount?.();
      const { mount } = await import(`./pages/${known}.js`);
      shown = { name: known, page: mount(main) };
    }
    await shown.page.load(params);
  } catch (problem) {
    fail(problem);
  }
}

/** @param {any} problem */
function fail(problem) {
  shown = undefined;
  main.replaceChildren(problemBox(problem), el("p", {}, el("button", { type: "button", class: "main", onclick: start }, "Try again")));
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

window.addEventListener("popstate", route);
start();
