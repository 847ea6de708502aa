// What a muscle that is built will pull, the parts of the ±, and what to measure.
import { el, remark } from "../dom.js";
import { muscle } from "../muscle.js";
import { showForce } from "../units.js";
import { inWords } from "../words.js";

/** Names of the parts that are no words yet. @type {Record<string, string>} */
const PARTS = {
  pull_factor: "muscle to muscle",
  take_up: "take-up",
  braid: "stiffness of the braid",
  fit: "own points",
  measured: "model against tests",
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
    const said = [
      words?.built && `As built ${words.built}.`,
      "95 % half-widths; they add as squares.",
      words?.bench && `To measure: ${words.bench}.`,
    ].filter(Boolean);
    const next = JSON.stringify([
      parts.map(([name, value]) => [name, showForce(value, 2)]),
      said,
    ]);
    if (next === key) return;
    key = next;
    const most = Math.max(...parts.map(([, value]) => value));
    list.replaceChildren(
      ...parts.flatMap(([name, value]) => row(name, value, most)),
    );
    note.textContent = inWords(said.join(" "));
  }
  store.on("answer", paint);
  store.on("facts", paint);
  return { element };
}

/** @param {string} name @param {number} value @param {number} most */
function row(name, value, most) {
  const bar = el("i", {
    style: `width:${Math.max(1, (100 * value) / most).toFixed(1)}%`,
  });
  return [
    el("dt", {}, PARTS[name] ?? name),
    el("dd", {}, `± ${showForce(value, 2)}`),
    el("dd", { class: "wide" }, bar),
  ];
}
