// Columns of a table whose headings do not say what they are: asked for by lists of its headings and of units.
import { choice } from "./controls.js";
import { el, folded } from "./dom.js";
import { unitsOf } from "./units.js";

/**
 * Quantities of a table of measured points: the word of requests, what people call it, and kinds whose units it may
 * have.
 * @type {[string, string, string[]][]}
 */
const QUANTITIES = [
  ["pressure", "Pressure", ["pressure"]],
  ["contraction", "Contraction or shortening", ["ratio", "length"]],
  ["length", "Length", ["length"]],
  ["force", "Pull", ["force"]],
];

/** The headings of a table: its first line with letters in several fields. @param {string} text */
export function headings(text) {
  for (const line of text.split(/\r?\n/, 200)) {
    const separator = ["\t", ";", ",", "|"].find((s) => line.includes(s));
    const fields = (
      separator
        ? line.replace(/^#/, "").split(separator)
        : line.trim().split(/\s+/)
    ).map((f) => f.trim().replace(/^"|"$/g, ""));
    if (fields.length > 1 && fields.some((f) => /\p{L}/u.test(f)))
      return fields;
  }
  return [];
}

/** What columns were read as. @param {{ column: string, quantity: string, unit?: string | null }[]} list */
export const columnLine = (list) =>
  list
    .map((c) => `${c.column} → ${c.quantity}${c.unit ? ` (${c.unit})` : ""}`)
    .join(", ");

/** @param {() => void} changed */
export function columnChoice(changed) {
  /** Quantity to heading and unit. @type {Map<string, [string, string]>} */
  const chosen = new Map();
  const rows = QUANTITIES.map(([quantity, label, kinds]) => {
    const now = () => chosen.get(quantity) ?? ["", ""];
    const put = (/** @type {string} */ heading, /** @type {string} */ unit) => {
      if (heading) chosen.set(quantity, [heading, unit]);
      else chosen.delete(quantity);
      changed();
    };
    const column = choice(label, [["", "Automatic"]], "", (heading) =>
      put(heading, now()[1]),
    );
    const unit = choice(
      "Unit",
      [
        ["", "From the heading"],
        ...kinds
          .flatMap(unitsOf)
          .map((u) => /** @type {[string, string]} */ ([u, u])),
      ],
      "",
      (u) => put(now()[0], u),
    );
    return {
      quantity,
      column,
      unit,
      element: el(
        "div",
        { style: "border-top:1px solid var(--faint);padding-top:6px" },
        column.element,
        unit.element,
      ),
    };
  });
  const paint = () =>
    rows.forEach(({ quantity, column, unit }) => {
      const [heading, of] = chosen.get(quantity) ?? ["", ""];
      column.set(heading);
      unit.set(of);
    });
  const element = folded("Columns", ...rows.map((r) => r.element));
  return {
    element,
    /** Another table. @param {string[]} list */
    offer(list) {
      rows.forEach(({ column }) => column.options(list));
    },
    /** Where the engine has to ask. */
    open() {
      element.open = true;
    },
    /** As requests have it. */
    value: () =>
      Object.fromEntries(
        [...chosen].map(([quantity, [heading, unit]]) => [
          quantity,
          unit ? `${heading}:${unit}` : heading,
        ]),
      ),
    /** As it stands in an address. */
    text: () =>
      [...chosen]
        .map(
          ([quantity, [heading, unit]]) =>
            `${quantity}=${heading}${unit ? `:${unit}` : ""}`,
        )
        .join(","),
    /** @param {string} text */
    read(text) {
      chosen.clear();
      for (const one of text.split(",")) {
        const [, quantity, heading, unit] =
          /^([a-z_]+)=(.+?)(?::([^:]*))?$/.exec(one.trim()) ?? [];
        if (quantity && heading) chosen.set(quantity, [heading, unit ?? ""]);
      }
      paint();
    },
  };
}
