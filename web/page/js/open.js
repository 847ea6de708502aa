// Open: a file of any kind, a muscle of the gallery, of the library, or of the project.
import { dialog } from "./dialog.js";
import { TABLES } from "./controls.js";
import { block, el, mainButton, problemBox, rowOf } from "./dom.js";
import { takeFiles } from "./drop.js";
import { gallery } from "./gallery.js";
import { library } from "./library.js";
import { shelf } from "./project.js";

export function openDialog() {
  dialog("Open a muscle", (close) => {
    const said = block();
    const fail = (/** @type {unknown} */ problem) =>
      said.replaceChildren(problemBox(problem));
    const input = el("input", {
      type: "file",
      multiple: true,
      accept: `.toml,.json,${TABLES}`,
      class: "unseen",
      "aria-label": "Files",
      tabindex: -1,
    });
    input.addEventListener("change", () => {
      const files = [...(input.files ?? [])];
      close();
      takeFiles(files);
    });
    return [
      rowOf(
        mainButton("Choose files", () => input.click()),
        input,
        el(
          "span",
          { class: "small soft" },
          "A muscle, a joint or a drive (TOML), measured points (CSV, XLSX, ODS), or a project (JSON). You can also drop files " +
            "anywhere on the page.",
        ),
      ),
      said,
      gallery(fail, close),
      library(fail, close),
      shelf(fail, close),
    ];
  });
}
