// Verification, validation, sources, limits.
import { engine } from "../ask.js";
import { DOCUMENTATION } from "../kind.js";
import { block, button, el, heading, paragraph, rowOf } from "../dom.js";
import { job, table } from "../form.js";
import { fileOf, keepFile } from "../kept.js";
import { muscle } from "../muscle.js";
import { isKept, keepAll } from "../offline.js";
import { number, showForce, showRatio } from "../units.js";

/** The verification was computed here: it is there again when one comes back. */
const CHECKED = "checked";

/** What works without a network, and a button for the rest. */
function withoutNetwork() {
  const text = el("span");
  const keep = button("Make all places available offline", async () => {
    keep.disabled = true;
    text.textContent = "Fetching …";
    const wrong = await keepAll().then(
      () => "",
      (problem) => `That failed: ${problem.message}`,
    );
    await say();
    if (wrong) text.textContent = wrong;
    keep.disabled = false;
  });
  const element = el("div", { hidden: true }, heading("Without a network"), rowOf(text, keep));
  const say = async () => {
    const all = await isKept();
    keep.hidden = all;
    text.textContent = all ? "Every place works." : "The muscle works; the other places need more.";
    element.hidden = false;
  };
  // Where the browser keeps nothing there is nothing to say.
  say().catch(() => {});
  return element;
}

/** @typedef {Commands["validate"]["answer"]["cases"][number]} Case */
const percent = (/** @type {number | null | undefined} */ x) => showRatio(x, 3);
const value = (/** @type {Case} */ c) => [
  number(c.reference, 5),
  number(c.ours, 5),
  number(c.error, 2),
];
/**
 * Tables of the cases, each of one kind of number: kind and measure of its cases, title, headings
 * and cells.
 * @type {[Case["kind"], Case["measure"], string, string[], (c: Case) => string[]][]}
 */
const TABLES = [
  [
    "verification",
    "value",
    "Verification: exact solutions and identities",
    ["exact", "computed", "error"],
    value,
  ],
  [
    "validation",
    "rms",
    "Validation: pull of measured muscles",
    ["rms residual", "blocked force", "rms / blocked force"],
    (c) => [showForce(c.ours, 3), showForce(c.reference, 4), percent(c.error)],
  ],
  [
    "validation",
    "share",
    "Validation: the ± of the pull",
    ["points within the ±", "nominal"],
    (c) => [percent(c.ours), percent(c.reference)],
  ],
  ["validation", "value", "Validation: other quantities", ["measured", "computed", "error"], value],
];

/** @type {Mount} */
export const mount = (main) => {
  const cases = block();
  const check = job(
    "Compute them here",
    "validate",
    async () => ({}),
    (answer) => {
      keepFile(CHECKED, true);
      cases.replaceChildren(
        ...TABLES.flatMap(([kind, measure, title, head, cells]) => {
          const list = answer.cases.filter((c) => c.kind === kind && c.measure === measure);
          const rows = list.map((c) => [
            c.name,
            c.source ?? "",
            ...cells(c),
            c.ok ? "holds" : "fails",
          ]);
          return [
            el("h3", title),
            table(["case", "source", ...head, ""], rows, {
              text: [0, 1, head.length + 2],
              label: title,
            }),
          ];
        }),
      );
    },
  );
  main.replaceChildren(
    block(
      "prose",
      heading("Your data"),
      paragraph(
        "They stay on your computer: ",
        `the engine is ${engine().about}. Your muscle and your settings are in the address; what you ` +
          `typed and opened stays in this tab until you close it.`,
      ),
      heading("Accuracy"),
      paragraph(
        "As built is what a muscle that you build pulls: the median, and the interval that 95 % of measured muscles keep.",
      ),
      withoutNetwork(),
      heading("Verification and validation"),
      check.element,
    ),
    cases,
    block(
      "prose",
      heading("Sources and licence"),
      paragraph(
        "mckibben is free software under MIT or Apache 2.0. The documentation lists the sources of all data and their terms. ",
        DOCUMENTATION && el("a", { href: DOCUMENTATION }, "Read it."),
      ),
    ),
  );
  const ranBefore = () => Boolean(fileOf(CHECKED));
  return {
    async load(params) {
      await muscle.read(params);
      if (ranBefore()) check.run();
    },
  };
};
