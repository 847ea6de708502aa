// Elements in one call, and what every page needs of the document.
import { problemOf } from "./engine/problem.js";
import { inWords, partName } from "./units.js";

/** What may stand in an element. @typedef {Node | string | null | undefined | false} Child */
/**
 * An element: attributes by name, where it has any, those of accessibility as `ariaLabel`,
 * listeners as `onclick` functions; children as nodes or texts.
 * @template {keyof HTMLElementTagNameMap} K @param {K} tag
 * @param {[attributes: Record<string, unknown>, ...Child[]] | Child[]} rest
 * @returns {HTMLElementTagNameMap[K]}
 */
export function el(tag, ...rest) {
  const element = document.createElement(tag),
    attributes = rest[0]?.constructor === Object ? rest.shift() : {};
  for (const [name, value] of Object.entries(/** @type {object} */ (attributes))) {
    if (value == null || value === false) continue;
    if (typeof value === "function")
      element.addEventListener(name.slice(2), /** @type {EventListener} */ (value));
    else if (/^aria\w/.test(name)) Object.assign(element, { [name]: value });
    else if (name === "style") element.style.cssText = String(value);
    else if (name === "value")
      /** @type {HTMLInputElement} */ (element).value = String(value);
    else element.setAttribute(name, value === true ? "" : String(value));
  }
  element.append(
    .../** @type {Child[]} */ (rest).filter((child) => child != null && child !== false),
  );
  return element;
}

/**
 * Elements of a kind with these children.
 * @template {keyof HTMLElementTagNameMap} K @param {K} tag @param {string} [classes]
 */
const part =
  (tag, classes) =>
  (/** @type {Child[]} */ ...children) =>
    el(tag, { class: classes }, ...children);
/** A heading of a part of a page. */
export const heading = part("h2");
export const paragraph = part("p");
/** What is said beside the matter. */
export const remark = part("p", "small soft");
/** What is said where there is nothing yet. */
export const faded = part("p", "soft");
/** Buttons, fields and words in a row. */
export const rowOf = part("p", "row");
/** Things that belong together. @param {string} [classes] @param {Child[]} children */
export const block = (classes, ...children) => el("div", { class: classes }, ...children);
/** Names and what they have. @param {Child[][]} rows */
export const termsOf = (rows) => rows.flatMap(([name, value]) => [el("dt", name), el("dd", value)]);
/** What is shown once somebody opens it. @param {Child} summary @param {Child[]} children */
export const folded = (summary, ...children) => el("details", el("summary", summary), ...children);

/** What is seldom needed, behind one sign; it closes after a click. @param {Child[]} children */
export function menu(...children) {
  const box = el(
    "details",
    { class: "menu" },
    el("summary", { ariaLabel: "More" }, "⋯"),
    el("div", { class: "row", onclick: () => (box.open = false) }, ...children),
  );
  return box;
}

/**
 * A button.
 * @param {string} text @param {(event: MouseEvent) => unknown} act
 * @param {Record<string, unknown>} [more] attributes
 */
export const button = (text, act, more) =>
  el("button", { type: "button", onclick: act, ...more }, text);

/** A field for a line of text. @param {Record<string, unknown>} more attributes */
export const textField = (more) => el("input", { type: "text", autocomplete: "off", ...more });

/** The one that matters most. @param {string} text @param {(event: MouseEvent) => unknown} act */
export const mainButton = (text, act) => button(text, act, { class: "main" });

/**
 * Names to choose from, where they are not there yet.
 * @param {HTMLSelectElement} select @param {string[]} names
 */
export function addOptions(select, names) {
  const there = new Set([...select.options].map((o) => o.value));
  select.append(
    ...names
      .filter((value) => !there.has(value))
      .map((value) => el("option", { value }, partName(value))),
  );
}

/** What a list has to choose from. @param {[string, string][]} list names and texts */
export const optionsOf = (list) => list.map(([name, text]) => el("option", { value: name }, text));

/** @param {string} id @returns {HTMLElement} */
export const byId = (id) => /** @type {HTMLElement} */ (document.getElementById(id));

let spoken = 0;
/** Says something to screen readers once things have settled. @param {string} text */
export function say(text) {
  clearTimeout(spoken);
  spoken = setTimeout(() => (byId("live").textContent = text), 700);
}

/** A problem as people read it. @param {unknown} thrown */
export function problemBox(thrown) {
  const { message, hint } = problemOf(thrown);
  // What stands in a file is named as it is written there.
  const words = /^\S+:\d+:\d+: /.test(message)
    ? message.replaceAll("`", "")
    : capital(inWords(message));
  return el(
    "div",
    { class: "problem", role: "alert" },
    paragraph(words),
    hint && remark(capital(inWords(hint))),
  );
}

/**
 * What belongs to an older question, beside the problem of the newest one.
 * @param {HTMLElement[]} parts @param {boolean} on
 */
export const dim = (parts, on) => parts.forEach((part) => part.classList.toggle("stale", on));

/** @param {string} text */
export const capital = (text) =>
  text.replace(/^\p{Ll}(?!\S*\.\w)/u, (first) => first.toUpperCase());

/** Hands a file to the browser's downloads. @param {string} name @param {BlobPart} content */
export function download(name, content) {
  const url = URL.createObjectURL(new Blob([content]));
  const link = el("a", { href: url, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/**
 * Tabs over one panel.
 * @param {string} label @param {[string, string][]} tabs @param {string} chosen
 * @param {(name: string) => void} choose
 */
export function tabs(label, tabs, chosen, choose) {
  const buttons = tabs.map(([name, text]) =>
    button(
      text,
      () => {
        set(name);
        choose(name);
      },
      { role: "tab", "data-name": name },
    ),
  );
  const onkeydown = (/** @type {KeyboardEvent} */ event) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    const at = buttons.findIndex((one) => one === document.activeElement);
    const next = buttons[(at + step + buttons.length) % buttons.length];
    next.focus();
    next.click();
  };
  const list = el("div", { role: "tablist", ariaLabel: label, onkeydown }, ...buttons);
  function set(/** @type {string} */ name) {
    for (const one of buttons) {
      const on = one.dataset.name === name;
      one.ariaSelected = String(on);
      one.tabIndex = on ? 0 : -1;
    }
  }
  set(chosen);
  return { list, set };
}

// One line above the page: what was done with a file, and what a link has lost.
/** @param {string} text @param {(Node | string)[]} more */
export function notice(text, ...more) {
  const box = byId("notice");
  const close = button("Close", () => (box.hidden = true), {
    class: "bare",
    ariaLabel: "Close this message",
  });
  box.replaceChildren(el("span", text), ...more, close);
  box.hidden = false;
}

/** A problem in the same place. @param {unknown} thrown @param {string} [what] */
export function noticeProblem(thrown, what = "") {
  const { message, hint } = problemOf(thrown);
  notice([what, inWords(message), inWords(hint)].filter(Boolean).join(" "));
}

// A window over the page, as the browser has it: Escape or a click beside it closes it, and the
// focus returns to where it was.
let windows = 0;
/** @param {string} title @param {(close: () => void) => (Node | string | null)[]} inside */
export function dialog(title, inside) {
  const id = `dialog-${++windows}`;
  const close = () => box.close();
  const box = el("dialog", { "aria-labelledby": id, closedby: "any", onclose: () => box.remove() });
  const head = block("row head", el("h2", { id }, title), button("Close", close));
  box.append(block("inside", head, ...inside(close)));
  document.body.append(box);
  box.showModal();
  return box;
}

/**
 * A table.
 * @param {string[]} head @param {(string | Node)[][]} rows
 * @param {{ text?: number[], pick?: (row: number) => void, label?: string }} [options] columns of
 * text are aligned
 *   left
 */
export function table(head, rows, { text = [0], pick, label } = {}) {
  const cell = (
    /** @type {"td" | "th"} */ tag,
    /** @type {string | Node} */ value,
    /** @type {number} */ i,
  ) =>
    el(
      tag,
      { class: text.includes(i) ? "text" : undefined, scope: tag === "th" ? "col" : undefined },
      value,
    );
  const picked = (/** @type {number} */ i) =>
    pick
      ? {
          class: "pick",
          tabindex: 0,
          onclick: () => pick(i),
          onkeydown(/** @type {KeyboardEvent} */ event) {
            if (event.key === "Enter") pick(i);
          },
        }
      : {};
  const body = rows.map((row, i) =>
    el("tr", picked(i), ...row.map((value, k) => cell("td", value, k))),
  );
  return el(
    "div",
    {
      class: "scroll",
      tabindex: pick ? undefined : 0,
      role: "region",
      ariaLabel: label ?? "table",
    },
    el(
      "table",
      el("thead", el("tr", ...head.map((h, i) => cell(h ? "th" : "td", h, i)))),
      el("tbody", ...body),
    ),
  );
}

/**
 * Warnings of an answer, and other sentences.
 * @param {(string | { message: string })[] | undefined} list
 */
export const warnings = (list) =>
  el(
    "ul",
    { class: "warnings" },
    ...(list ?? []).map((w) => el("li", capital(inWords(typeof w === "string" ? w : w.message)))),
  );

/** Inputs in one column. @param {string} label @param {Child[]} children */
export const inputs = (label, ...children) =>
  el("section", { class: "controls", ariaLabel: label }, ...children);

/**
 * A page of controls, and what they lead to beside them.
 * @param {string} label @param {(Node | string | null)[]} controls @param {Node[]} middle
 */
export const bench = (label, controls, middle) =>
  block("bench two", inputs(label, ...controls), block("middle", ...middle));
