// Open: a file of any kind, a muscle of the gallery or of the library.
import { TABLES, fileInput } from "./controls.js";
import { block, dialog, el, mainButton, problemBox, rowOf } from "./dom.js";
import { takeFiles } from "./drop.js";
import { gallery, library } from "./gallery.js";

export function openDialog() {
  dialog("Open a muscle", (close) => {
    const said = block();
    const fail = (/** @type {unknown} */ problem) => said.replaceChildren(problemBox(problem));
    const open = (/** @type {File[]} */ files) => {
      close();
      takeFiles(files);
    };
    const input = fileInput("Files", `.toml,.json,${TABLES}`, open, true);
    return [
      rowOf(
        mainButton("Choose files", () => input.click()),
        input,
        el(
          "span",
          { class: "small soft" },
          "A muscle, a joint or a drive (TOML), measured points (CSV, XLSX, ODS), or a formula (JSON). You can also drop files " +
            "anywhere on the page.",
        ),
      ),
      said,
      gallery(fail, close),
      library(fail, close),
    ];
  });
}
