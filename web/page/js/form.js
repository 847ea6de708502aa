// A form of quantities as people type them, read by the engine in one question; and long work with progress and a way to end it.
import { longWork, understood } from "./ask.js";
import { capital, el, problemBox } from "./dom.js";
import { expectation, meant, withUnit } from "./units.js";
import { sketched } from "./sketch.js";
import { inWords } from "./words.js";

/**
 * `pair`: a list of two quantities joined by @, such as 700N@15%, 300N@20%: kinds and fields of both. `words`: a list of words.
 * `or`: words that may stand in place of a quantity. `factor`: a ratio that nobody writes in %. `hidden`: until it is shown.
 * @typedef {import("./units.js").Kind} Kind
 * @typedef {{ key: string, field: string, label: string, kind?: Kind, list?: boolean, pair?: [Kind, string][], words?: boolean, or?: string[], factor?: boolean, hidden?: boolean, options?: [string, string][], value?: string, hint?: string }} Field
 * @param {Field[]} fields @param {() => void} submit
 */
export function form(fields, submit) {
  /** @type {Map<string, { input: HTMLInputElement | HTMLSelectElement, wrong: HTMLElement, row: HTMLElement }>} */
  const inputs = new Map();
  const rows = fields.map((f, i) => {
    const id = `${f.key}-${i}-${Math.random().toString(36).slice(2, 7)}`;
    const input = f.options
      ? el("select", { id }, ...f.options.map(([name, text]) => el("option", { value: name }, text)))
      : el("input", { type: "text", id, autocomplete: "off", spellcheck: "false", placeholder: f.hint ?? "", "aria-describedby": `${id}w` });
    input.value = f.value ?? "";
    // What a number alone means follows the unit that is shown.
    if (f.kind) for (const event of ["pointerenter", "focus"]) input.addEventListener(event, () => { input.title = expectation(/** @type {Kind} */ (f.kind)); });
    const wrong = el("p", { class: "wrong", id: `${id}w`, hidden: true });
    // A form of several fields without a button of its own is not submitted by Enter.
    input.addEventListener("keydown", (event) => { if (/** @type {KeyboardEvent} */ (event).key === "Enter" && !f.options) { event.preventDefault(); submit(); } });
    const row = el("div", { style: "margin-bottom:8px", hidden: f.hidden }, el("div", { class: "choice", style: "margin:0;grid-template-columns:minmax(0,5fr) minmax(0,6fr)" }, el("label", { for: id }, f.label), input), wrong);
    sketched(row, f.field, f.key);
    inputs.set(f.key, { input, wrong, row });
    return row;
  });
  const element = el("form", { onsubmit: (/** @type {Event} */ event) => { event.preventDefault(); submit(); } }, ...rows);
  const mark = (/** @type {string} */ key, /** @type {string} */ message) => {
    const of = inputs.get(key);
    if (!of) return;
    of.wrong.className = "wrong";
    of.wrong.textContent = inWords(message);
    of.wrong.hidden = !message;
    if (message) of.input.setAttribute("aria-invalid", "true");
    else of.input.removeAttribute("aria-invalid");
  };
  return {
    element, mark,
    /** Fields of a request, or nothing where a text cannot be understood: it is marked. An interval without a step is its two ends where those are
     * wanted, else a list. @param {{ intervals?: boolean }} [options] @returns {Promise<Record<string, any> | undefined>} */
    async read({ intervals = false } = {}) {
      fields.forEach((f) => mark(f.key, ""));
      /** @type {Record<string, any>} */
      const values = {};
      /** @type {{ key: string, text: string, kind: Kind, list: boolean, take: (value: any) => void }[]} */
      const asked = [];
      /** @type {Map<string, string>} */
      const notes = new Map();
      /** As the engine shall read it; what was read of a bare ratio is said. @param {Field} f @param {Kind} kind @param {string} text */
      const clear = (f, kind, text) => {
        if (f.list) return withUnit(kind, text);
        if (kind === "ratio" && f.factor) return text;
        const { text: clearer, note } = meant(kind, text), whole = withUnit(kind, clearer);
        if (note) notes.set(f.key, note);
        else if (whole !== clearer && f.kind) notes.set(f.key, `${text} without a unit was read as ${whole}.`);
        return whole;
      };
      for (const f of fields) {
        const { input, row } = inputs.get(f.key) ?? {};
        const text = row?.hidden ? "" : input?.value.trim();
        if (!text) continue;
        if (f.kind && f.or?.includes(text)) values[f.field] = text;
        else if (f.kind) asked.push({ key: f.key, text: clear(f, f.kind, text), kind: f.kind, list: f.list ?? false, take: (v) => { values[f.field] = v; } });
        else if (f.pair) {
          values[f.field] = text.split(",").map((one) => {
            const parts = one.split("@"), item = /** @type {Record<string, number>} */ ({});
            f.pair?.forEach(([kind, field], i) => asked.push({ key: f.key, text: clear(f, kind, (parts[i] ?? "").trim()), kind, list: false, take: (v) => { item[field] = v; } }));
            return item;
          });
        } else values[f.field] = f.words ? text.split(",").map((w) => w.trim()).filter(Boolean) : text;
      }
      const readings = await understood(asked.map(({ text, kind, list }) => ({ text, kind, list })));
      let good = true;
      asked.forEach(({ key, list, take }, i) => {
        const reading = readings[i];
        if (reading.problem) { mark(key, reading.problem.message); good = false; }
        else take(list ? (intervals && ends(asked[i].text, reading)) || reading.values : reading.value);
      });
      for (const [key, note] of notes) {
        const wrong = inputs.get(key)?.wrong;
        if (wrong?.hidden) Object.assign(wrong, { className: "note small soft", textContent: note, hidden: false });
      }
      return good ? values : undefined;
    },
    /** The texts, for an address. */
    texts: () => Object.fromEntries(fields.map((f) => [f.key, inputs.get(f.key)?.input.value === (f.value ?? "") ? "" : inputs.get(f.key)?.input.value])),
    /** @param {URLSearchParams} params */
    set(params) { for (const f of fields) { const of = inputs.get(f.key); if (of) of.input.value = params.get(f.key) ?? f.value ?? ""; } },
    /** What stands there where nothing is typed. @param {string} key @param {string} text */
    usual(key, text) { const input = inputs.get(key)?.input; if (input instanceof HTMLInputElement) input.placeholder = text; },
    /** @param {string} key @param {boolean} on */
    shown(key, on) { const of = inputs.get(key); if (of) of.row.hidden = !on; },
    /** What is typed. @param {string} key */
    text: (key) => inputs.get(key)?.input.value.trim() ?? "",
    /** @param {string} key @param {string} text */
    put(key, text) { const of = inputs.get(key); if (of) of.input.value = text; },
    /** @param {string} key @param {string[]} names */
    options(key, names) {
      const input = inputs.get(key)?.input;
      if (input instanceof HTMLSelectElement) input.append(...names.filter((n) => ![...input.options].some((o) => o.value === n)).map((n) => el("option", { value: n }, n)));
      else if (input && !input.hasAttribute("list")) {
        const list = el("datalist", { id: `${input.id}l` }, ...names.map((n) => el("option", { value: n })));
        input.setAttribute("list", list.id);
        input.after(list);
      }
    },
    /** Shows a problem at its field, or says that it has none. @param {any} problem */
    at(problem) {
      const f = fields.find((x) => x.field === problem.field);
      if (f) mark(f.key, problem.message);
      return Boolean(f);
    },
    keys: fields.map((f) => f.key),
  };
}

/** The ends of an interval without a step, which a search takes as a whole. @param {string} text @param {any} reading @returns {{ low: number, high: number } | undefined} */
function ends(text, { values, interval }) {
  // Programs of before do not say it.
  const [low, high] = interval ?? (/^[^:,]+\.\.[^:,]+$/.test(text) ? [values[0], values[values.length - 1]] : []);
  return high === undefined ? undefined : { low, high };
}

/**
 * A button that starts long work, with progress, a way to end it, and its problems below.
 * @template {keyof import("../../types/commands").Commands} K
 * @param {string} label @param {K} command
 * @param {() => Promise<import("../../types/commands").Commands[K]["request"] | undefined>} request nothing where there is none to ask
 * @param {(answer: import("../../types/commands").Commands[K]["answer"]) => void} take
 * @param {(problem: any) => void} [fail]
 */
export function job(label, command, request, take, fail) {
  const start = el("button", { type: "button", class: "main", onclick: () => run() }, label);
  const stop = el("button", { type: "button", hidden: true, onclick: () => ends?.abort() }, "Cancel");
  const bar = el("progress", { hidden: true, "aria-label": `${label}: progress` });
  const words = el("span", { class: "small soft" });
  const said = el("div", {});
  /** @type {AbortController | undefined} */ let ends;
  async function run() {
    ends?.abort();
    const asked = await request().catch((problem) => { said.replaceChildren(problemBox(problem)); });
    if (!asked) return;
    const mine = (ends = new AbortController());
    said.replaceChildren();
    words.textContent = "";
    bar.removeAttribute("value");
    const late = setTimeout(() => { bar.hidden = false; stop.hidden = false; }, 150);
    try {
      take(await longWork(command, asked, { signal: mine.signal, progress(done, total) { bar.max = total; bar.value = done; words.textContent = `${done} of ${total}`; } }));
      words.textContent = "";
    } catch (problem) {
      if (/** @type {any} */ (problem).name === "AbortError") words.textContent = ends === mine ? "Cancelled." : "";
      else { said.replaceChildren(problemBox(problem)); words.textContent = ""; fail?.(problem); }
    }
    clearTimeout(late);
    if (ends === mine) { bar.hidden = true; stop.hidden = true; }
  }
  return { element: el("div", {}, el("div", { class: "row" }, start, stop, bar, words), said), run, end: () => ends?.abort() };
}

/** A table. @param {string[]} head @param {(string | Node)[][]} rows @param {{ text?: number[], pick?: (row: number) => void, label?: string }} [options] columns of text are aligned left */
export function table(head, rows, { text = [0], pick, label } = {}) {
  const cell = (/** @type {"td" | "th"} */ tag, /** @type {any} */ value, /** @type {number} */ i) => el(tag, { class: text.includes(i) ? "text" : undefined, scope: tag === "th" ? "col" : undefined }, value);
  const body = rows.map((row, i) => el("tr", {
    class: pick ? "pick" : undefined, tabindex: pick ? 0 : undefined, onclick: pick ? () => pick(i) : undefined,
    onkeydown: pick ? (/** @type {KeyboardEvent} */ event) => { if (event.key === "Enter") pick(i); } : undefined,
  }, ...row.map((value, k) => cell("td", value, k))));
  return el("div", { class: "scroll", tabindex: pick ? undefined : 0, role: "region", "aria-label": label ?? "table" }, el("table", {}, el("thead", {}, el("tr", {}, ...head.map((h, i) => cell("th", h, i)))), el("tbody", {}, ...body)));
}

/** Warnings of an answer. @param {string[] | undefined} list */
export const warnings = (list) => el("ul", { class: "warnings" }, ...(list ?? []).map((w) => el("li", {}, capital(inWords(w)))));
