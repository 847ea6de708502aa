// Verification, validation, sources, limits.
import { engine } from "../ask.js";
import { DOCUMENTATION } from "../kind.js";
import { el } from "../dom.js";
import { job, table } from "../form.js";
import { fileOf, keepFile } from "../kept.js";
import { muscle } from "../muscle.js";
import { isKept, keepAll } from "../offline.js";
import { number } from "../units.js";

/** The verification was computed here: it is there again when one comes back. */
const CHECKED = "checked";

/** What works without a network, and a button for the rest. */
function withoutNetwork() {
  const text = el("span", {});
  const keep = el("button", { type: "button", onclick: async () => {
    keep.disabled = true;
    text.textContent = "Fetching …";
    const wrong = await keepAll().then(() => "", (problem) => `That failed: ${problem.message}`);
    await say();
    if (wrong) text.textContent = wrong;
    keep.disabled = false;
  } }, "Make all places available offline");
  const element = el("div", { hidden: true }, el("h2", {}, "Without a network"), el("p", { class: "row" }, text, keep));
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

/** @param {HTMLElement} main */
export function mount(main) {
  const cases = el("div", {});
  const models = el("div", {});
  const check = job("Compute them here", "validate", async () => ({}), (answer) => {
    keepFile(CHECKED, true);
    const rows = (/** @type {string} */ kind) =>
      answer.cases.filter((c) => c.kind === kind).map((c) =>
        [c.name, c.source ?? "", number(c.reference, 5), number(c.ours, 5),
        c.error === undefined ? "–" : number(c.error, 2), c.ok ? "holds" : "fails"]
      );
    const head = ["case", "source", "reference", "here", "error", ""];
    cases.replaceChildren(el("h3", {}, "Verification: against exact solutions and identities"),
      table(head, rows("verification"), { text: [0, 1, 5], label: "verification" }),
      el("h3", {}, "Validation: against measured muscles"),
      table(head, rows("validation"), { text: [0, 1, 5], label: "validation" }));
  });
  main.replaceChildren(
    el("div", { class: "prose" }, el("h2", {}, "What this is"),
      el("p", {},
        "A McKibben muscle is a rubber tube in a braided sleeve: pressurised, it bulges, shortens and pulls. This "
          + "page solves its non-linear finite-element model (axisymmetric, incompressible rubber of any law, "
          + "elastic strands, bonded ends) at every step of a slider, and shows the results."),
      el("p", {}, "Your data stay on your computer: ",
        `the engine is ${engine().about}. Your muscle and your settings are in the address of the page; what you `
          + `typed and opened is kept in this tab until you close it.`), el("h2", {}, "Accuracy"),
      el("p", {},
        "The ± covers 95 % of the differences from measured muscles. It is wide because rubbers vary from batch to "
          + "batch and few are known; it becomes smaller when you identify your own rubber in Measurements. The "
          + "model includes the thickness of the braid, the gap before first contact, the slip of the ends, the "
          + "history of the rubber and the friction between strands only if the muscle file states them."),
      withoutNetwork(),
      el("h2", {}, "Verification and validation"), check.element),
    cases,
    el("div", { class: "prose" }, el("h2", {}, "Models")),
    models,
    el("div", { class: "prose" }, el("h2", {}, "Sources and licence"),
      el("p", {},
        "mckibben is free software under MIT or Apache 2.0. The documentation lists the sources and terms of formulas, rubbers and measured muscles. ",
        DOCUMENTATION && el("a", { href: DOCUMENTATION }, "Read it.")),
      el("p", { class: "small soft" },
        "The command line, Rust, Python and HTTP offer the same commands under the same names: `mckibben --help`.")),
  );
  const ranBefore = () => Boolean(fileOf(CHECKED));
  engine().ask("parts-list", { kind: "models" }).then(
    (answer) =>
      models.replaceChildren(
        table(["model", "what it is"], answer.models.map((m) => [m.name, m.description]), {
          text: [0, 1],
          label: "models",
        }),
      ),
    () => {},
  );
  return {
    /** @param {URLSearchParams} params */
    async load(params) {
      await muscle.read(params);
      if (ranBefore()) check.run();
    },
    unmount() {
      check.end();
    },
  };
}
