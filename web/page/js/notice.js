// One line above the page: what was done with a file, and what a link has lost.
import { button, byId, el } from "./dom.js";
import { problemOf } from "./engine/problem.js";
import { inWords } from "./words.js";

/** @param {string} text @param {(Node | string)[]} more */
export function notice(text, ...more) {
  const box = byId("notice");
  const close = button(
    "Close",
    () => {
      box.hidden = true;
    },
    { class: "bare", "aria-label": "Close this message" },
  );
  box.replaceChildren(el("span", {}, text), ...more, close);
  box.hidden = false;
}

/** A problem in the same place. @param {unknown} thrown @param {string} [what] */
export function noticeProblem(thrown, what = "") {
  const { message, hint } = problemOf(thrown);
  notice([what, inWords(message), inWords(hint)].filter(Boolean).join(" "));
}
