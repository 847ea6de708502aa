// Help: what a page is for, what the signs mean, the page of the book that says more, and about.
import { engine } from "./ask.js";
import { button, dialog, el, heading, paragraph, remark, rowOf } from "./dom.js";
import { DOCUMENTATION } from "./kind.js";
import { isKept, keepAll } from "./offline.js";
import { pageOf } from "./pages.js";

/** The page of the book, from this one. @param {string} place such as `commands#commands` */
function book(place) {
  const [file, anchor] = place.split("#");
  return `${DOCUMENTATION.replace(/[^/]*$/, "")}${file}.html${anchor ? `#${anchor}` : ""}`;
}

/** What works without a network, and a button for the rest. */
function withoutNetwork() {
  const text = el("span");
  const keep = button("Make all places available offline", async () => {
    keep.disabled = true;
    text.textContent = "Fetching …";
    await keepAll().then(say, (problem) => {
      text.textContent = `That failed: ${problem.message}`;
    });
    keep.disabled = false;
  });
  const element = el("div", { hidden: true }, heading("Without a network"), rowOf(text, keep));
  const say = async () => {
    const all = await isKept();
    keep.hidden = Boolean(all);
    text.textContent = all ? "Every place works." : "The muscle works; the other places need more.";
    // Where the browser keeps nothing there is nothing to say.
    element.hidden = all === undefined;
  };
  say();
  return element;
}

/** The help of the page that is shown. */
export function helpDialog() {
  const { text, about, help } = pageOf(document.body.dataset.page ?? "");
  dialog(`Help: ${text}`, () => [
    paragraph(about),
    el("img", {
      src: "symbols.svg",
      style: "width:100%",
      alt:
        "A muscle at rest with outer diameter D0, wall s, length L0 and braid angle θ0; and under " +
        "pressure p, contracted by ε, with its pull F",
    }),
    remark("The chance: how many of ten that are built reach what was asked."),
    DOCUMENTATION
      ? el("iframe", { class: "book", title: "The book", src: book(help) })
      : remark("The book comes with the program: ", el("code", `docs/${help.split("#")[0]}.md`)),
    heading("About"),
    paragraph(
      `Your data stay on your computer: the engine is ${engine().about}. Your muscle and your ` +
        "settings are in the address; what you typed and opened stays in this tab until you close it.",
    ),
    withoutNetwork(),
    paragraph(
      "mckibben is free software under MIT or Apache 2.0. The documentation lists the sources of " +
        "all data and their terms. ",
      DOCUMENTATION && el("a", { href: DOCUMENTATION }, "Read it."),
    ),
  ]);
}

/** The button of the frame. */
export const helpButton = () => button("Help", helpDialog);
