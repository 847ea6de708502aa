// The first view: muscles to begin with; until somebody hides it.
import { byId, el } from "./dom.js";
import { gallery } from "./gallery.js";
import { remembered } from "./kept.js";
import { noticeProblem } from "./notice.js";

const seen = remembered("welcomed");

/** @param {boolean} on the address is bare: somebody has just arrived */
export function welcome(on) {
  const box = byId("welcome");
  if (!on || seen.get()) {
    box.hidden = true;
    return;
  }
  const hide = () => {
    box.hidden = true;
    seen.set("1");
  };
  if (!box.childElementCount) {
    box.append(
      el("div", { class: "row" }, el("h2", { class: "grow" }, "Begin with a muscle"),
        el("button", { type: "button", onclick: hide }, "Hide this")),
      gallery(noticeProblem, () => {
        box.hidden = true;
      }, 1500),
    );
  }
  box.hidden = false;
}
