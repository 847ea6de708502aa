// Elements in one call, and what every page needs of the document.
import { problemOf } from "./engine/problem.js";
import { inWords } from "./words.js";

/**
 * An element: attributes by name, listeners as `onclick` functions, children as nodes or texts.
 * @template {keyof HTMLElementTagNameMap} K @param {K} tag @param {Record<string, unknown>} [attributes]
 * @param {...(Node | string | null | undefined | false)} children @returns {HTMLElementTagNameMap[K]}
 */
export function el(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value == null || value === false) continue;
    if (typeof value === "function")
      element.addEventListener(
        name.slice(2),
        /** @type {EventListener} */ (value),
      );
    else if (name === "style") element.style.cssText = String(value);
    else if (name === "value")
      /** @type {HTMLInputElement} */ (element).value = String(value);
    else element.setAttribute(name, value === true ? "" : String(value));
  }
  element.append(
    ...children.filter((child) => child != null && child !== false),
  );
  return element;
}

/** What may stand in an element. @typedef {Node | string | null | undefined | false} Child */
/** A heading of a part of a page. @param {Child[]} children */
export const heading = (...children) => el("h2", {}, ...children);
/** @param {Child[]} children */
export const paragraph = (...children) => el("p", {}, ...children);
/** What is said beside the matter. @param {Child[]} children */
export const remark = (...children) =>
  el("p", { class: "small soft" }, ...children);
/** @param {Child[]} children */
export const smallPrint = (...children) =>
  el("p", { class: "small" }, ...children);
/** What is said where there is nothing yet. @param {Child[]} children */
export const faded = (...children) => el("p", { class: "soft" }, ...children);
/** Things that belong together. @param {string} [classes] @param {Child[]} children */
export const block = (classes, ...children) =>
  el("div", { class: classes }, ...children);
/** Buttons, fields and words in a row. @param {Child[]} children */
export const rowOf = (...children) => el("p", { class: "row" }, ...children);
/** Names and what they have. @param {Child[][]} rows */
export const termsOf = (rows) =>
  rows.flatMap(([name, value]) => [el("dt", {}, name), el("dd", {}, value)]);
/** What is shown once somebody opens it. @param {Child} summary @param {Child[]} children */
export const folded = (summary, ...children) =>
  el("details", {}, el("summary", {}, summary), ...children);

/** What is seldom needed, behind one sign; it closes after a click. @param {Child[]} children */
export function menu(...children) {
  const box = el(
    "details",
    { class: "menu" },
    el("summary", { "aria-label": "More" }, "⋯"),
    el("div", { class: "row", onclick: () => (box.open = false) }, ...children),
  );
  return box;
}

/**
 * A button.
 * @param {string} text @param {(event: MouseEvent) => unknown} act @param {Record<string, unknown>} [more] attributes
 */
export const button = (text, act, more) =>
  el("button", { type: "button", onclick: act, ...more }, text);

/** The one that matters most. @param {string} text @param {(event: MouseEvent) => unknown} act */
export const mainButton = (text, act) => button(text, act, { class: "main" });

/** Names to choose from, where they are not there yet. @param {HTMLSelectElement} select @param {string[]} names */
export function addOptions(select, names) {
  const there = new Set([...select.options].map((o) => o.value));
  select.append(
    ...names
      .filter((value) => !there.has(value))
      .map((value) => el("option", { value }, value)),
  );
}

/** What a list has to choose from. @param {[string, string][]} list names and texts */
export const optionsOf = (list) =>
  list.map(([name, text]) => el("option", { value: name }, text));

/** @param {string} id @returns {HTMLElement} */
export const byId = (id) =>
  /** @type {HTMLElement} */ (document.getElementById(id));

let spoken = 0;
/** Says something to screen readers once things have settled. @param {string} text */
export function say(text) {
  clearTimeout(spoken);
  spoken = setTimeout(() => {
    byId("live").textContent = text;
  }, 700);
}

/** A problem as people read it. @param {unknown} thrown */
export function problemBox(thrown) {
  const problem = problemOf(thrown);
  const hint = problem.hint
    ? el("p", { class: "small" }, capital(inWords(problem.hint)))
    : null;
  return el(
    "div",
    { class: "problem", role: "alert" },
    el("p", {}, capital(inWords(problem.message))),
    hint,
  );
}

/**
 * What belongs to an older question, beside the problem of the newest one.
 * @param {HTMLElement[]} parts @param {boolean} on
 */
export const dim = (parts, on) =>
  parts.forEach((part) => part.classList.toggle("stale", on));

/** @param {string} text */
export const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);

/** Hands a file to the browser's downloads. @param {string} name @param {BlobPart} content @param {string} [type] */
export function download(name, content, type) {
  const url = URL.createObjectURL(new Blob([content], { type }));
  const link = el("a", { href: url, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/**
 * An element that is dragged: told where, and whether it is the end or the beginning of the gesture.
 * @param {HTMLElement | SVGElement} element
 * @param {(event: PointerEvent, settled: boolean, begins: boolean) => void} act
 */
export function dragging(element, act) {
  let on = false;
  for (const type of /** @type {const} */ ([
    "pointerdown",
    "pointermove",
    "pointerup",
    "pointercancel",
  ])) {
    element.addEventListener(type, (/** @type {any} */ event) => {
      if (type === "pointerdown") {
        on = true;
        element.setPointerCapture(event.pointerId);
      }
      if (on && type !== "pointercancel")
        act(event, type === "pointerup", type === "pointerdown");
      on &&= type === "pointerdown" || type === "pointermove";
    });
  }
}

/** Rows as CSV. @param {readonly (readonly (string | number | null | undefined)[])[]} rows */
export function csv(rows) {
  const quoted = (/** @type {string | number | null | undefined} */ v) => {
    if (typeof v === "string")
      return /[",\n]/.test(v) ? `"${v.replaceAll('"', '""')}"` : v;
    // A gap is no number.
    return Number.isFinite(v) ? v : "";
  };
  return rows.map((row) => row.map(quoted).join(",")).join("\n") + "\n";
}

/**
 * Tabs over one panel.
 * @param {string} label @param {[string, string][]} tabs @param {string} chosen @param {(name: string) => void} choose
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
  const list = el("div", { role: "tablist", "aria-label": label }, ...buttons);
  function set(/** @type {string} */ name) {
    for (const one of buttons) {
      const on = one.dataset.name === name;
      one.ariaSelected = String(on);
      one.tabIndex = on ? 0 : -1;
    }
  }
  set(chosen);
  list.addEventListener("keydown", (event) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    const at = buttons.findIndex((one) => one === document.activeElement);
    const next = buttons[(at + step + buttons.length) % buttons.length];
    next.focus();
    next.click();
  });
  return { list, set };
}
