// The parts of the ± of the pull, and what would make each smaller.
import { capital, el, remark } from "../dom.js";
import { muscle } from "../muscle.js";
import { show } from "../units.js";
import { inWords } from "../words.js";

/** Name of each part, and what reduces it. @type {Record<string, [string, string]>} */
const PARTS = {
  friction: [
    "friction, not measured",
    "Pull the muscle at one pressure in both directions, and identify the friction in Measurements.",
  ],
  measured: [
    "model against tests",
    "Identify the rubber from the muscle's own pull in Measurements.",
  ],
  rubber: [
    "rubber",
    "Identify the rubber from the muscle's own pull, or test the rubber in tension.",
  ],
  braid: [
    "stiffness of the braid",
    "Measure the sleeve, or identify the stiffness from the muscle's own pull.",
  ],
  data_sheet: [
    "data sheets",
    "Pull your own muscle, and identify it in Measurements.",
  ],
  formula: ["formula", "Compute by finite elements: the model fe."],
  mesh: ["mesh", "Take a finer mesh; it seldom matters."],
  length_transfer: [
    "another length",
    "Pull your muscle at its own length, and identify it in Measurements.",
  ],
  transfer: [
    "another specimen",
    "Pull your own muscle, and identify it in Measurements.",
  ],
  fit: [
    "fit to the bench",
    "Measure more points, at the pressures and contractions that you need.",
  ],
};

/** @param {Store} store */
export function partsView(store) {
  const list = el("dl", { class: "parts" }),
    note = remark();
  const element = el(
    "div",
    {
      class: "breakdown",
      role: "region",
      "aria-label": "Parts of the ±",
      hidden: true,
    },
    list,
    note,
  );
  let key = "";
  function paint() {
    const { point, facts } = store;
    const parts = Object.entries(point?.uncertainty_parts_n ?? {})
      .filter((pair) => typeof pair[1] === "number")
      .sort((a, b) => b[1] - a[1]);
    const words =
      facts.said?.state === muscle.state ? facts.said.words : undefined;
    const bench = words?.bench ? ` ${capital(inWords(words.bench))}.` : "";
    const next = JSON.stringify([
      parts.map(([name, value]) => [name, show("force", value, 2)]),
      bench,
    ]);
    if (next === key) return;
    key = next;
    const most = Math.max(...parts.map(([, value]) => value));
    list.replaceChildren(
      ...parts.flatMap(([name, value]) => row(name, value, most)),
    );
    note.textContent = `95 % half-widths; they add as squares.${bench}`;
  }
  store.on("answer", paint);
  store.on("facts", paint);
  return { element };
}

/** @param {string} name @param {number} value @param {number} most */
function row(name, value, most) {
  const [words, remedy] = PARTS[name] ?? [name.replaceAll("_", " "), ""];
  const bar = el("i", {
    style: `width:${Math.max(1, (100 * value) / most).toFixed(1)}%`,
  });
  return [
    el("dt", {}, words),
    el("dd", {}, `± ${show("force", value, 2)}`),
    el("dd", { class: "wide" }, bar, value > 0.3 * most ? remedy : ""),
  ];
}
