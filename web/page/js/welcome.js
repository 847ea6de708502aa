// The first view: what must it pull? Three candidates answer, and one click leads to the living muscle. Beside it ways
// for who has a muscle or measurements; until somebody hides it.
import { address } from "./address.js";
import { engine } from "./ask.js";
import { candidatesView } from "./candidates.js";
import { block, button, byId, el, heading, rowOf } from "./dom.js";
import { form } from "./form.js";
import { gallery } from "./gallery.js";
import { remembered } from "./kept.js";
import { muscle } from "./muscle.js";
import { noticeProblem } from "./notice.js";
import { openDialog } from "./open.js";
import { drawing } from "./sketch.js";
import { candidate } from "./state.js";

const seen = remembered("welcomed");
/** @type {Field[]} */
const WANTED = [
  {
    key: "F",
    field: "force_n",
    label: "It pulls",
    kind: "force",
    value: "300 N",
  },
  {
    key: "e",
    field: "contraction",
    label: "while it shortens by",
    kind: "ratio",
    value: "15 %",
  },
  {
    key: "stroke",
    field: "stroke_mm",
    label: "or by a stroke of",
    kind: "length",
    hint: "40 mm",
  },
  {
    key: "pmax",
    field: "max_pressure_mpa",
    label: "from a supply of",
    kind: "pressure",
    value: "2.5 bar",
  },
];

/** @param {() => void} hide */
function question(hide) {
  const fields = form(WANTED, () => ask());
  const shown = candidatesView((one, request) => {
    hide();
    location.hash = address(
      "muscle",
      muscle.paramsOf(
        candidate(one, request, {
          p: one.pressure_mpa,
          e: one.points[0].contraction,
        }),
      ),
    );
  });
  let asking = 0;
  async function ask() {
    const mine = ++asking,
      read = await fields.read();
    if (!read || mine !== asking) return;
    if (read.stroke_mm) delete read.contraction;
    shown.ask(/** @type {Design["request"]} */ (read));
  }
  // What each is.
  for (const [key, { row }] of fields.rows) {
    const svg = drawing(WANTED.find((f) => f.key === key)?.field);
    if (svg)
      row.insertAdjacentHTML(
        "afterbegin",
        `<svg class="drawn" viewBox="0 0 240 120" aria-hidden="true">${svg()}</svg>`,
      );
  }
  fields.element.addEventListener("input", () => setTimeout(ask, 300));
  const more = () => {
    const texts = fields.texts(),
      of = Object.fromEntries(
        WANTED.map(({ key, value }) => [key, texts[key] || value]),
      );
    location.hash = address("design", of);
  };
  return {
    ask,
    element: block(
      "question",
      heading("What must it pull?"),
      fields.element,
      shown.element,
      rowOf(button("More wishes, all muscles and the map", more)),
      el(
        "details",
        { class: "small" },
        el("summary", {}, "The narrowest in words"),
        shown.said,
      ),
    ),
  };
}

/** @param {boolean} on the address is bare: somebody has just arrived */
export function welcome(on) {
  const box = byId("welcome");
  box.hidden = !on || Boolean(seen.get());
  if (box.hidden || box.childElementCount) return;
  const hide = () => {
    box.hidden = true;
  };
  const asked = question(hide);
  const go = (/** @type {string} */ page) => () => {
    hide();
    location.hash = `#${page}`;
  };
  box.append(
    button(
      "Hide this",
      () => {
        hide();
        seen.set("1");
      },
      { class: "hide" },
    ),
    asked.element,
    block(
      "ways",
      heading("I have a muscle"),
      rowOf(
        button("Open a file or the library", openDialog),
        button("Build it from parts", go("parts")),
      ),
      gallery(noticeProblem, hide),
      heading("I have measurements"),
      rowOf(
        button("Pulls of a muscle", go("data")),
        button("A test of a rubber", go("rubber")),
      ),
    ),
  );
  // The engine of the search is loaded with the first question, where it is not a server's.
  if (engine().files.length)
    asked.element.addEventListener("focusin", asked.ask, { once: true });
  else setTimeout(asked.ask, 600);
}
