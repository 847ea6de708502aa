// Print: one sheet with the muscle, what was typed on the page, and its numbers.
import { engine } from "./ask.js";
import { isLocal } from "./address.js";
import { pictures } from "./body.js";
import { block, byId, el, heading, paragraph, smallPrint, termsOf } from "./dom.js";
import { muscle } from "./muscle.js";
import { pageOf } from "./pages.js";
import { paper } from "./theme.js";
import { thumbnail } from "./thumbnail.js";

/** What stands in the fields that are shown: names and values. @returns {[string, string][]} */
function inputs() {
  const rows = [...document.querySelectorAll(".controls .quantity, .controls .choice")];
  return rows
    .filter((row) => !row.closest("[hidden], details:not([open])"))
    .flatMap((row) => {
      const name = row.querySelector("label, span")?.textContent?.trim() ?? "";
      const field = /** @type {HTMLInputElement | null} */ (
        row.querySelector("input[type=text], select")
      );
      const text =
        field instanceof HTMLSelectElement ? field.selectedOptions[0]?.textContent : field?.value;
      const unit =
        row.classList.contains("quantity") && !text?.includes("%")
          ? row.querySelector(":scope > button, :scope > span.soft")?.textContent
          : "";
      return text ? [/** @type {[string, string]} */ ([name, `${text} ${unit}`.trim()])] : [];
    });
}

/** The muscle as it is seen. */
function picture() {
  const canvas = /** @type {HTMLCanvasElement | null} */ (
    document.querySelector("main .stage canvas")
  );
  const src = canvas && pictures.get(canvas)?.();
  return src
    ? el("img", { src, alt: "The muscle in this state" })
    : (document.querySelector("main .stage svg.joint")?.cloneNode(true) ?? null);
}

/** The sheet of the page as it is now. */
function sheet() {
  const numbers = [
    ...document.querySelectorAll(
      "main .numbers dl, main .controls table, main .below > .scroll > table, main .middle > div > .scroll > table",
    ),
  ].map((part) => part.cloneNode(true));
  const notes = document.querySelector("main .warnings")?.cloneNode(true);
  return el(
    "section",
    { class: "sheet", ariaLabel: "Sheet" },
    block(
      "row",
      muscle.shown && thumbnail(muscle.shown, "The muscle"),
      block("grow", el("h1", muscle.name), paragraph(muscle.line())),
      smallPrint(
        `${pageOf(document.body.dataset.page ?? "").text}, ${new Date().toISOString().slice(0, 10)}`,
        el("br"),
        `mckibben workbench, ${engine().about}`,
      ),
    ),
    picture(),
    block(
      "columns",
      block("", heading("Inputs"), el("dl", ...termsOf(inputs()))),
      block("", heading("Numbers"), .../** @type {Node[]} */ (numbers)),
    ),
    notes ?? null,
    el(
      "p",
      { class: "small" },
      location.href.length < 2000 ? (isLocal() ? location.hash : location.href) : "",
    ),
  );
}

export function printing() {
  addEventListener("beforeprint", () => {
    paper(true);
    byId("sheet").replaceChildren(sheet());
  });
  addEventListener("afterprint", () => {
    byId("sheet").replaceChildren();
    paper(false);
  });
}
