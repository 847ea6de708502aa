// What stays on the computer, accuracy, sources.
import { engine } from "../ask.js";
import { DOCUMENTATION } from "../kind.js";
import { block, button, el, heading, paragraph, rowOf } from "../dom.js";
import { muscle } from "../muscle.js";
import { isKept, keepAll } from "../offline.js";

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

/** @type {Mount} */
export const mount = (main) => {
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
      heading("Sources and licence"),
      paragraph(
        "mckibben is free software under MIT or Apache 2.0. The documentation lists the sources of all data and their terms. ",
        DOCUMENTATION && el("a", { href: DOCUMENTATION }, "Read it."),
      ),
    ),
  );
  return {
    async load(params) {
      await muscle.read(params);
    },
  };
};
