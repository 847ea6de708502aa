// The muscle of a report, to turn: the page's own view. A report has this script with its
// imports in one piece (crate mckibben-web, and report.js of the page).
import { el } from "./dom.js";
import { View, reach } from "./view3d.js";

for (const box of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll(".body"))) {
  const data = box.querySelector("script")?.textContent;
  if (!data) continue;
  const shape = JSON.parse(data);
  box.classList.add("live");
  const view = new View(box);
  if (!view.gl) {
    box.classList.remove("live");
    continue;
  }
  const [low, high] = reach(shape.arrays.max_stretch), { length_mm: restLength, outer_diameter_mm } = shape.muscle;
  view.set(shape, { field: "max_stretch", low, high, restLength, restRadius: outer_diameter_mm / 2 });
  box.append(el("p", { class: "hint" }, "Drag to turn. Coloured by the largest stretch of the rubber."));
}
