// Three candidates for a pull, as pictures to one scale: what the muscles are in use, with width, pressure and pull as built.
import { Slot } from "./ask.js";
import { body, contracted, ground } from "./body.js";
import { decisionView } from "./design-view.js";
import { block, el } from "./dom.js";
import { card } from "./thumbnail.js";
import { asBuilt, show } from "./units.js";
import { inWords } from "./words.js";

/** What each is the best for, and what is asked for it. @type {[string, Design["request"]][]} */
const WISHES = [
  ["Narrowest in use", { objective: "bulged-diameter" }],
  ["Least air", { objective: "air" }],
  ["Guaranteed (95 %)", { objective: "bulged-diameter", guaranteed: 0.95 }],
];

/**
 * A muscle in use as SVG, in a frame of so many millimetres.
 * @param {Candidate} c @param {number} wide @param {number} tall
 */
export function picture(c, wide, tall) {
  const {
      outer_diameter_mm: diameter,
      points: [at],
    } = c,
    e = Number(at?.contraction ?? 0);
  const now = contracted(diameter, c.angle_deg, e),
    length = c.length_mm * (1 - e),
    { angle } = now;
  const bulged = c.bulged_diameter_mm ?? now.bulged;
  return (
    `<svg viewBox="${-0.14 * wide} ${-tall / 2} ${1.24 * wide} ${1.3 * tall}" aria-hidden="true">` +
    `${ground(length, bulged / 2)}${body({ length, diameter, bulged, angle })}</svg>`
  );
}

/** Cards of candidates. @param {(candidate: Candidate, request: Design["request"]) => void} open */
export function candidatesView(open) {
  const element = el("div", { class: "candidates", "aria-live": "polite" });
  const said = el("ul", { class: "decision small" });
  const slots = WISHES.map(() => new Slot({ stays: true }));
  /** @type {(Candidate | string | undefined)[]} */ let found = [];
  /** @type {Design["request"]} */ let of = {};
  function paint() {
    const known = found.filter((one) => typeof one === "object");
    const wide = Math.max(...known.map((c) => c.length_mm));
    const tall = Math.max(
      ...known.map((c) => Number(c.bulged_diameter_mm ?? c.outer_diameter_mm)),
    );
    element.replaceChildren(
      ...WISHES.map(([title, wish], i) => {
        const one = found[i];
        if (typeof one !== "object")
          return block(
            "card",
            el("b", {}, title),
            el("span", { class: "small soft" }, one ?? "Searching …"),
          );
        const box = el("span");
        box.innerHTML = picture(one, wide, tall);
        const [at] = one.points;
        const parts = [
          one.count > 1 ? `${one.count} side by side` : "",
          one.tube,
          one.sleeve,
        ].filter(Boolean);
        return card(
          () => open(one, { ...of, ...wish }),
          box,
          title,
          `${show("length", one.bulged_diameter_mm, 3)} wide at ${show("pressure", one.pressure_mpa, 3)}`,
          `as built ${asBuilt(at)}`,
          parts.join(", "),
        );
      }),
    );
  }
  return {
    element,
    said,
    paint,
    /** @param {Design["request"]} request */
    ask(request) {
      // Enter and a pause in typing ask the same.
      if (JSON.stringify(request) === JSON.stringify(of)) return;
      of = request;
      found = WISHES.map(() => undefined);
      said.replaceChildren();
      paint();
      WISHES.forEach(([, wish], i) => {
        slots[i].ask(
          "design",
          { ...request, ...wish, top: 1 },
          (answer) => {
            found[i] =
              answer.candidates[0] ??
              (answer.closest
                ? `None: ${inWords(answer.closest.reason)}.`
                : "None of the search.");
            if (!i) said.replaceChildren(...decisionView(answer).children);
            paint();
          },
          (problem) => {
            found[i] = inWords(problem.message);
            paint();
          },
        );
      });
    },
  };
}
