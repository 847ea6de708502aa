// A form of quantities as people type them, read by the engine in one question; and long work with
// progress and a way to end it.
import { longWork, understood } from "./ask.js";
import { saying } from "./controls.js";
import {
  addOptions,
  block,
  button,
  dim,
  el,
  mainButton,
  problemBox,
  optionsOf,
  textField,
} from "./dom.js";
import { isAbort, problemOf } from "./engine/problem.js";
import { atEnd } from "./life.js";
import { muscle } from "./muscle.js";
import { expectation, meant, pointed, show, withUnit } from "./units.js";

/**
 * @typedef {number | number[] | { low: number, high: number } | undefined} Value
 * @typedef {{ input: HTMLInputElement | HTMLSelectElement, say: (text?: string, wrong?: boolean) =>
 * void,
 *   row: HTMLElement }} Row
 * @typedef {{ f: Field, text: string, kind: Kind, list: boolean, take: (value: Value) => void }}
 * Asked
 */

let count = 0;
/** A field with its label. @param {Field} f @returns {Row} */
function fieldRow(f) {
  const id = `f${++count}`,
    { kind } = f;
  const input = f.options
    ? el("select", { id }, ...optionsOf(f.options))
    : textField({ id, placeholder: f.hint ?? "", "aria-describedby": `${id}w` });
  input.value = f.value ?? "";
  // What a number alone means follows the unit that is shown.
  const hint = () => {
    if (kind) input.title = expectation(kind);
  };
  for (const event of ["pointerenter", "focus"]) input.addEventListener(event, hint);
  const below = el("p", { id: `${id}w`, hidden: true });
  const line = el("div", { class: "choice" }, el("label", { for: id }, f.label), input);
  const row = el("div", { hidden: f.hidden }, line, below);
  return { input, say: saying(input, below), row };
}

/**
 * What a mass that stands in the place of a force weighs, as a sentence; empty for other texts.
 * @param {Asked[]} asked @param {Readings} readings
 */
async function weights(asked, readings) {
  const wrong = asked.map(({ kind, text }, i) => ({
    text: kind === "force" && readings[i].problem ? text : "",
    kind: /** @type {const} */ ("mass"),
  }));
  if (!wrong.some(({ text }) => text)) return [];
  return (await understood(wrong)).map(({ value }, i) =>
    value ? `${wrong[i].text} weigh ${show("force", 9.80665 * value, 2)}: type that` : "",
  );
}

class Form {
  /** @param {Field[]} fields @param {() => void} submit */
  constructor(fields, submit) {
    this.fields = fields;
    this.keys = fields.map((f) => f.key);
    this.rows = Object.fromEntries(fields.map((f) => [f.key, fieldRow(f)]));
    const send = (/** @type {Event} */ event) => {
      event.preventDefault();
      submit();
    };
    this.element = el(
      "form",
      { onsubmit: send },
      ...Object.values(this.rows).map(({ row }) => row),
      // Enter in any field is as a click on it.
      el("button", { hidden: true }),
    );
  }

  /** @param {string} key @param {string} message */
  mark(key, message) {
    const { row, say } = this.rows[key],
      box = row.closest("details");
    say(message, true);
    if (message && box) box.open = true;
  }

  /**
   * Fields of a request, or nothing where a text cannot be understood: it is marked. An interval
   * without a step is its two ends where those are wanted, else a list.
   * @param {{ intervals?: boolean }} [options] @returns {Promise<Read | undefined>}
   */
  async read({ intervals = false } = {}) {
    /** @type {Read} */ const values = {},
      /** @type {Asked[]} */ asked = [],
      /** @type {Map<string, string>} */ notes = new Map();
    /** A text as the engine shall read it. @param {Field} f @param {Kind} kind @param {string} text */
    const clear = (f, kind, text) => {
      if (f.list) return withUnit(kind, text);
      if (kind === "ratio" && f.factor) return text;
      const { text: clearer, value, note } = meant(kind, text),
        whole = withUnit(kind, clearer);
      if (note) notes.set(f.key, note);
      else if (value && whole !== clearer && f.kind)
        notes.set(f.key, `${text} without a unit was read as ${show(kind, value, 6)}.`);
      return whole;
    };
    /** @param {Field} f @param {Kind} kind @param {string} text @param {(value: Value) => void} take */
    const ask = (f, kind, text, take) =>
      asked.push({ f, text: clear(f, kind, text), kind, list: f.list ?? false, take });
    for (const f of this.fields) {
      const { kind, key, field, pair } = f,
        text = this.rows[key].row.hidden ? "" : this.text(key);
      this.mark(key, "");
      if (!text) continue;
      if (pair)
        values[field] = text.split(",").map((one) => {
          const parts = one.split(/@| at /),
            /** @type {Record<string, number>} */ item = {};
          pair.forEach(([of, name], i) =>
            ask(f, of, (parts[i] ?? "").trim(), (v) => (item[name] = Number(v))),
          );
          return item;
        });
      else if (f.words) values[field] = text.split(",").flatMap((word) => word.trim() || []);
      else if (!kind || f.or?.includes(text))
        values[field] = field === "load" ? pointed(text) : text;
      else ask(f, kind, text, (value) => (values[field] = value));
    }
    const readings = await understood(asked.map(({ text, kind, list }) => ({ text, kind, list })));
    const weighed = await weights(asked, readings);
    asked.forEach(({ f, text, list, take }, i) => {
      const { problem, value, values, interval } = readings[i];
      if (problem)
        this.mark(
          f.key,
          text ? weighed[i] || problem.message : `a value is missing, as in ${f.hint}`,
        );
      // Without a step a search takes it as a whole.
      else if (intervals && interval) take({ low: interval[0], high: interval[1] });
      else take(list ? values : value);
    });
    const bad = new Set(asked.flatMap(({ f }, i) => (readings[i].problem ? [f.key] : [])));
    for (const [key, note] of notes) if (!bad.has(key)) this.rows[key].say(note);
    return bad.size ? undefined : values;
  }

  /** The texts, for an address: those that are not the usual ones. */
  texts() {
    const own = (/** @type {string} */ key, usual = "") =>
      this.rows[key].input.value === usual ? "" : this.rows[key].input.value;
    return Object.fromEntries(this.fields.map(({ key, value }) => [key, own(key, value)]));
  }
  /** @param {URLSearchParams} params */
  set(params) {
    for (const f of this.fields) this.put(f.key, params.get(f.key) ?? f.value ?? "");
  }
  /** What stands there where nothing is typed. @param {string} key @param {string} text */
  usual(key, text) {
    Object.assign(this.rows[key].input, { placeholder: text });
  }
  /** @param {string} key @param {boolean} on */
  shown(key, on) {
    this.rows[key].row.hidden = !on;
  }
  /** What is typed. @param {string} key */
  text(key) {
    return this.rows[key].input.value.trim();
  }
  /** @param {string} key @param {string} text */
  put(key, text) {
    this.rows[key].input.value = text;
  }
  /**
   * Names to choose from, where they are not there yet. @param {string} key @param {string[]} names
   */
  options(key, names) {
    const { input } = this.rows[key];
    if (input instanceof HTMLSelectElement) return addOptions(input, names);
    const id = `${input.id}l`;
    if (input.hasAttribute("list")) return;
    input.setAttribute("list", id);
    input.after(el("datalist", { id }, ...names.map((value) => el("option", { value }))));
  }
  /**
   * Shows a problem at its field, or says that it has none to be seen.
   * @param {Problem} problem
   */
  at({ field, message, hint }) {
    const f = this.fields.find((x) => x.field === field && !this.rows[x.key].row.hidden);
    if (f) this.mark(f.key, hint ? `${message}; ${hint}` : message);
    return Boolean(f);
  }
}

/**
 * Fields: key, name in the request, label, kind where it is a quantity, and the usual text or all
 * else.
 * @param {[key: string, field: string, label: string, kind?: Kind | Partial<Field>, more?: string |
 * Partial<Field>][]} rows
 * @returns {Field[]}
 */
export const fieldsOf = (rows) =>
  rows.map(([key, field, label, kind, more]) => ({
    key,
    field,
    label,
    ...(typeof kind === "object" ? kind : { kind }),
    ...(typeof more === "string" ? { value: more } : more),
  }));

/** A form of quantities. @param {Field[]} fields @param {() => void} submit */
export const form = (fields, submit) => new Form(fields, submit);

/**
 * A button that starts long work, with progress, a way to end it, and its problems below.
 * @template {keyof Commands} K @param {string} label @param {K} command
 * @param {() => Promise<Commands[K]["request"] | undefined>} request nothing where
 *   there is none to ask
 * @param {(answer: Commands[K]["answer"]) => void} take
 * @param {{ fields?: { at: (problem: Problem) => unknown }, shown?: HTMLElement[], minor?: boolean
 * }} [about] fields that
 * a problem is marked at, what is shown of an answer: dimmed beside the problem of a later
 * question; and whether another
 *   button of the place matters most
 */
export function job(label, command, request, take, { fields, shown = [], minor = false } = {}) {
  const start = (minor ? button : mainButton)(label, () => run());
  const stop = button("Cancel", () => ends?.abort(), { hidden: true });
  const bar = el("progress", { hidden: true, ariaLabel: `${label}: progress` });
  const words = el("span", { class: "small soft" });
  const said = block();
  /** @type {AbortController | undefined} */ let ends;
  let runs = 0;
  async function run() {
    const newest = ++runs;
    ends?.abort();
    await muscle.ready;
    const asked = await request().catch((problem) => {
      said.replaceChildren(problemBox(problem));
    });
    if (newest !== runs) return;
    if (!asked) return dim(shown, true);
    const mine = (ends = new AbortController());
    said.replaceChildren();
    words.textContent = "";
    bar.removeAttribute("value");
    const late = setTimeout(() => {
      bar.hidden = stop.hidden = false;
    }, 150);
    try {
      await take(
        await longWork(command, asked, {
          signal: mine.signal,
          progress(done, total) {
            bar.max = total;
            bar.value = done;
            words.textContent = `${done} of ${total}`;
          },
        }),
      );
      words.textContent = "";
      dim(shown, false);
    } catch (problem) {
      words.textContent = isAbort(problem) && ends === mine ? "Cancelled." : "";
      if (!isAbort(problem)) {
        if (!fields?.at(problemOf(problem))) said.replaceChildren(problemBox(problem));
        dim(shown, true);
      }
    }
    clearTimeout(late);
    if (ends === mine) bar.hidden = stop.hidden = true;
  }
  atEnd(() => ends?.abort());
  return { element: block("", block("row", start, stop, bar, words), said), run };
}
