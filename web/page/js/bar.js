// The muscle of all pages, above them: its picture and name, what it warns of, undo and redo, and
// what is done with it.
import { isLocal } from "./address.js";
import {
  block,
  button,
  byId,
  download,
  el,
  menu,
  notice,
  noticeProblem,
  textField,
  warnings,
} from "./dom.js";
import { inShort, muscle } from "./muscle.js";
import { fileName } from "./toml.js";
import { openDialog } from "./gallery.js";
import { thumbnail } from "./thumbnail.js";
import { names } from "./steps.js";

async function save() {
  try {
    download(fileName(muscle.name, ".toml"), await muscle.toml());
  } catch (problem) {
    noticeProblem(problem, "The muscle cannot be saved.");
  }
}

/** The name as a field: it is part of the link, and of the file that is saved. */
function nameField() {
  const field = textField({
    ariaLabel: "Name of the muscle",
    maxlength: 80,
    onchange: () => muscle.rename(field.value.trim()),
    onkeydown(/** @type {KeyboardEvent} */ event) {
      if (event.key === "Enter") field.blur();
    },
  });
  return field;
}

/** A link of a page on this computer leads nowhere else: the file goes in its place. */
async function share() {
  if (isLocal()) {
    await save();
    return notice(
      "This link works only on your computer. The muscle was saved: send the file instead.",
    );
  }
  // Over plain http a browser has no clipboard.
  await (navigator.clipboard?.writeText(location.href) ?? Promise.reject()).then(
    () => notice("The link to this view is copied."),
    () => prompt("The link to this view", location.href),
  );
}

/** Warnings of the muscle in a line; opened, in whole. */
function flags() {
  const line = el("summary"),
    list = block(),
    element = el("details", { class: "flags", hidden: true }, line, list);
  return {
    element,
    paint() {
      const all = muscle.warnings,
        short = [...new Set(all.map(inShort))].join(", ");
      element.hidden = !short;
      if (line.title === short) return;
      line.title = short;
      line.textContent = `Warnings: ${short}`;
      list.replaceChildren(warnings(all));
    },
  };
}

/**
 * @param {(by: -1 | 1) => void} walk to the step before or after
 * @param {HTMLElement[]} tools of the frame: on a phone they are behind the sign of the bar
 */
export function muscleBar(walk, tools) {
  const picture = el("span"),
    field = nameField(),
    line = el("span", { class: "small soft measures" }),
    warned = flags();
  const undo = button("Undo", () => walk(-1)),
    redo = button("Redo", () => walk(1));
  const more = menu(
      button("Open", openDialog),
      button("Save", save, { title: "Save the muscle as a file (TOML)" }),
      button("Share", share, { title: "Copy the link to this view, or save the file" }),
      button("Parts", async () => (await import("./parts.js")).partsDialog()),
      button("Build & export", async () => (await import("./files.js")).filesDialog()),
    ),
    acts = /** @type {HTMLElement} */ (more.lastElementChild);
  const element = el(
    "div",
    { class: "muscle-bar", role: "group", ariaLabel: "The muscle" },
    picture,
    el("span", { class: "name" }, field, line),
    undo,
    redo,
    more,
    warned.element,
  );
  const narrow = matchMedia("(max-width: 699px)");
  const fold = () => {
    more.open = !narrow.matches;
    (narrow.matches ? acts : byId("tools")).append(...tools);
  };
  narrow.addEventListener("change", fold);
  acts.addEventListener("click", fold);
  fold();
  /** @type {string | undefined} */ let drawn = "";
  return {
    element,
    /** The muscle as it is now. */
    paint() {
      if (document.activeElement !== field) field.value = muscle.name;
      names().forEach((name, i) => {
        const one = [undo, redo][i];
        // A button that is disabled would lose the focus.
        one.ariaDisabled = String(!name);
        one.title = name ? `${one.textContent}: ${name} (${["Ctrl+Z", "Ctrl+Y"][i]})` : "";
      });
      warned.paint();
      const s = muscle.shown;
      line.textContent = muscle.size();
      const of = s && [s.outer_diameter_mm, s.wall_mm, s.length_mm, s.angle_deg].join();
      if (of === drawn) return;
      drawn = of;
      picture.replaceChildren(thumbnail(s));
    },
  };
}
