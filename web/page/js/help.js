// Help: what a page is for, how it is used, and the page of the book that says more.
import { address } from "./address.js";
import { button, dialog, el, paragraph, remark } from "./dom.js";
import { DOCUMENTATION } from "./kind.js";
import { muscle } from "./muscle.js";
import { pageOf } from "./pages.js";

/** The page of the book, from this one. @param {string} place such as `commands#commands` */
function book(place) {
  const [file, anchor] = place.split("#");
  return `${DOCUMENTATION.replace(/[^/]*$/, "")}${file}.html${anchor ? `#${anchor}` : ""}`;
}

/** The button of the frame; it shows the help of the page that is shown. */
export const helpButton = () =>
  button("Help", () => {
    const { text, about, help } = pageOf(document.body.dataset.page ?? "");
    dialog(`Help: ${text}`, (close) => [
      paragraph(about),
      paragraph("Point at a quantity, or focus its field, to see it in a drawing."),
      paragraph(
        el("a", { href: address("about", muscle.params()), onclick: close }, "About"),
        ": your data, accuracy, sources.",
      ),
      DOCUMENTATION
        ? el("iframe", { class: "book", title: "The book", src: book(help) })
        : remark("The book comes with the program: ", el("code", `docs/${help.split("#")[0]}.md`)),
    ]);
  });
