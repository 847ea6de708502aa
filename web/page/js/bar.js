// The muscle of all pages, above them: its picture and name, undo and redo, save, open, share, project, print.
import { canRedo, canUndo } from "./address.js";
import { download, el } from "./dom.js";
import { muscle } from "./muscle.js";
import { fileName } from "./name.js";
import { noticeProblem } from "./notice.js";
import { openDialog } from "./open.js";
import { show } from "./units.js";
import { thumbnail } from "./thumbnail.js";
import { write, address } from "./address.js";

/** @param {string} text @param {() => void} act @param {string} [title] */
const button = (text, act, title) => el("button", { type: "button", onclick: act, title }, text);

async function save() {
  try {
    download(fileName(muscle.name, ".toml"), await muscle.toml(), "application/toml");
  } catch (problem) {
    noticeProblem(problem, "The muscle cannot be saved.");
  }
}

/** The name as a field: it is part of the link, and of the file that is saved. */
function nameField() {
  const field = el("input", { type: "text", "aria-label": "Name of the muscle", maxlength: 80, autocomplete: "off",
    spellcheck: "false" });
  field.addEventListener("change", () => {
    muscle.rename(field.value.trim());
    const [page, words = ""] = location.hash.replace(/^#/, "").split("?", 2), params = new URLSearchParams(words);
    if (page === "design") params.delete("m");
    else if (muscle.called) params.set("name", muscle.called);
    else params.delete("name");
    write(address(page || "muscle", Object.fromEntries(params)));
    muscle.tell();
  });
  field.addEventListener("keydown", (event) => {
    if (event.key === "Enter") field.blur();
  });
  return field;
}

function shareButton() {
  const share = button("Share", async () => {
    try {
      await navigator.clipboard.writeText(location.href);
      share.textContent = "Link copied";
    } catch {
      prompt("The link to this view", location.href);
    }
    setTimeout(() => {
      share.textContent = "Share";
    }, 1500);
  }, "Copy the link to this view");
  return share;
}

export function muscleBar() {
  const picture = el("span", {}), field = nameField(), line = el("span", { class: "small soft measures" });
  const undo = button("Undo", () => history.back(), "Take back the last gesture"),
    redo = button("Redo", () => history.forward(), "Do it again");
  const element = el("div", { class: "muscle-bar", role: "group", "aria-label": "The muscle" }, picture,
    el("span", { class: "name" }, field, line), undo, redo, button("Save", save, "Save the muscle as a file (TOML)"),
    button("Open", openDialog, "Open a file, or a muscle of the gallery or the library"), shareButton(),
    button("Project", async () => (await import("./project.js")).projectDialog(), "Several muscles with their data in one file"),
    button("Print", () => print(), "Print one sheet with muscle, inputs and numbers"));
  /** @type {string | undefined} */ let drawn = "";
  return {
    element,
    /** Undo and redo are what the history has. */
    moved() {
      undo.disabled = !canUndo();
      redo.disabled = !canRedo();
    },
    /** The muscle as it is now. */
    paint() {
      if (document.activeElement !== field) field.value = muscle.name;
      const s = muscle.shown;
      line.textContent = s
        ? `D0 ${show("length", s.outer_diameter_mm)}, s ${show("length", s.wall_mm)}, L0 ${show("length", s.length_mm)}`
        : "";
      const of = s && [s.outer_diameter_mm, s.wall_mm, s.length_mm, s.angle_deg].join();
      if (of === drawn) return;
      drawn = of;
      picture.replaceChildren(thumbnail(s));
    },
  };
}
