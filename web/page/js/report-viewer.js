// The muscle of a report, to turn: the page's own view. A report has this script with its
// imports in one piece (crate mckibben-web, and report.js of the page).
import { el } from "./dom.js";
import { viewOf } from "./view3d.js";

for (const box of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll(".body"))) {
  const data = box.querySelector("script")?.textContent;
  if (!data) continue;
  const shape = JSON.parse(data);
  box.classList.add("live");
  const view = viewOf(box);
  if (!view.turns) {
    box.classList.remove("live");
    continue;
  }
  view.stretched(shape);
  box.append(
    el("p", { class: "hint" }, "Drag to turn. Coloured by the largest stretch of the rubber."),
  );
}
