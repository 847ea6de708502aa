// A quantity as a slider with a field beside it, and a choice from a list.
import { understood } from "./ask.js";
import { addOptions, block, button, capital, el, optionsOf } from "./dom.js";
import {
  changeUnit,
  clamp,
  expectation,
  hasChoice,
  inside,
  meant,
  number,
  onAnyUnits,
  outside,
  show,
  unitName,
} from "./units.js";
import { sketched } from "./sketch.js";
import { noticeProblem } from "./notice.js";
import { inWords } from "./words.js";

let count = 0;
/** Steps of keys, in steps of a slider. @type {Record<string, number>} */
const STEPS = {
  ArrowRight: 1,
  ArrowUp: 1,
  ArrowLeft: -1,
  ArrowDown: -1,
  PageUp: 10,
  PageDown: -10,
};

/**
 * `change` is called at every step, with `settled` at the end of a gesture. Without a value the field is empty; one
 * that `clears` may be emptied, and then has the usual value.
 * @typedef {{ key?: string, field?: string, label: string, symbol?: string, about?: string,
 *   kind: Kind, unit?: string, value?: number, above?: number, minimum?: number, maximum?: number,
 *   usual?: number, low?: number, high?: number, around?: boolean, clears?: boolean,
 *   change: (value: number | undefined, settled: boolean) => void }} Spec
 */

/** What is said below a field: a note, or what is wrong with it. @param {HTMLElement} field @param {HTMLElement} box */
export const saying =
  (field, box) =>
  (text = "", wrong = false) => {
    box.className = wrong ? "wrong" : "note small soft";
    box.textContent = wrong ? inWords(text) : text;
    box.hidden = !text;
    field.ariaInvalid = wrong && text ? "true" : null;
  };

/** A field with a slider, where that has ends. */
class Quantity {
  /** @type {number | undefined} */ #now;
  /**
   * The value as the page wrote it into the field; nothing where the value changed under a text of somebody.
   * @type {string | undefined}
   */
  #painted = "";
  /** Counts what was typed or dragged. */
  #turn = 0;
  /** @type {number} */ #low;
  /** @type {number} */ #high;

  /** @param {Spec} spec */
  constructor(spec) {
    const {
        key,
        field,
        label,
        symbol,
        about,
        kind,
        low = NaN,
        high = NaN,
      } = spec,
      id = `q${++count}`;
    this.spec = spec;
    this.#now = spec.value;
    [this.#low, this.#high] = [low, high];
    this.slider = el("input", {
      type: "range",
      min: 0,
      max: 1000,
      step: "any",
      "aria-label": label,
    });
    this.field = el("input", {
      type: "text",
      id,
      autocomplete: "off",
      "aria-describedby": `${id}w`,
    });
    this.unit = hasChoice(kind)
      ? button("", () => changeUnit(kind), {
          class: "bare",
          title: "Change the unit everywhere",
        })
      : el("span", { class: "soft" });
    const below = el("p", { id: `${id}w`, hidden: true, role: "status" });
    this.say = saying(this.field, below);
    const name = el(
      "label",
      { for: id },
      label,
      symbol ? " " : "",
      symbol ? el("i", { class: "soft" }, symbol) : null,
    );
    this.element = block(
      "quantity",
      name,
      this.field,
      this.unit,
      Number.isNaN(low) ? null : this.slider,
      below,
    );
    sketched(this.element, key, field);
    if (about) this.element.dataset.about = about;
    this.#listen();
    onAnyUnits(() => this.#paint());
    this.#paint();
  }

  get value() {
    return this.#now;
  }
  /** @param {number | undefined} v */
  set(v) {
    if (v === this.#now) return;
    this.#now = v;
    this.say();
    const fieldToo = !this.#typing();
    if (!fieldToo) this.#painted = undefined;
    this.#paint(fieldToo);
  }
  /** What is wrong with it, said by the engine; empty where nothing is. @param {string} message */
  mark(message) {
    if (message) return this.say(message, true);
    if (!this.field.getAttribute("aria-invalid")) return;
    this.say();
    this.#paint(!this.#typing());
  }
  /** @param {number} low @param {number} high */
  reach(low, high) {
    [this.#low, this.#high] = [low, high];
    this.#paint(!this.#typing());
  }
  /** Ends from 0.3 to 3 times its value, within limits. @param {number} [least] @param {number} [most] */
  anchor(least = 0, most = Infinity) {
    const {
      spec: { around },
      value,
    } = this;
    if (around && value)
      this.reach(Math.max(least, 0.3 * value), Math.min(most, 3 * value));
  }
  /** @param {boolean} on */
  enable(on) {
    this.slider.disabled = !on;
    this.field.disabled = !on;
  }

  /** Whether somebody is typing. */
  #typing() {
    return (
      document.activeElement === this.field &&
      this.field.value !== this.#painted
    );
  }
  /**
   * A value as it stands in the field; with its sign where it is in %, so that it can be read again.
   * @param {number} v
   */
  #asText(v) {
    const { kind } = this.spec;
    return number(outside(kind, v), 6) + (kind === "ratio" ? " %" : "");
  }
  /** A step that suits the shown unit: the power of ten below a hundredth of the reach. */
  #step() {
    const { kind } = this.spec;
    return (
      10 **
      Math.floor(
        Math.log10(
          Math.abs(outside(kind, this.#high) - outside(kind, this.#low)) / 100,
        ),
      )
    );
  }
  /** By its logarithm where its ends are around a value. */
  #fromSlider() {
    const { kind, around } = this.spec,
      share = Number(this.slider.value) / 1000,
      [low, high] = [this.#low, this.#high];
    const v = outside(
      kind,
      around ? low * (high / low) ** share : low + share * (high - low),
    );
    // A round value may lie beyond its ends.
    const within = (/** @type {number} */ round) =>
      clamp(inside(kind, round), low, high);
    if (around)
      return within(
        Number(v.toPrecision(v < 3 * 10 ** Math.floor(Math.log10(v)) ? 3 : 2)),
      );
    const step = this.#step();
    return inside(kind, Number((Math.round(v / step) * step).toPrecision(12)));
  }
  #share(/** @type {number} */ now) {
    const [low, high] = [this.#low, this.#high];
    return this.spec.around
      ? Math.log(Math.max(now, 1e-12) / low) / Math.log(high / low)
      : (now - low) / (high - low);
  }

  #listen() {
    const {
      slider,
      field,
      spec: { kind },
    } = this;
    slider.addEventListener("input", () =>
      this.#take(this.#fromSlider(), false),
    );
    slider.addEventListener("change", () => this.spec.change(this.#now, true));
    slider.addEventListener("keydown", (event) => {
      const by = STEPS[event.key];
      if (by === undefined) return;
      event.preventDefault();
      const now = outside(kind, this.#now ?? this.#low),
        step = this.spec.around
          ? 10 ** Math.floor(Math.log10(now / 20))
          : this.#step();
      const next = Number((now + by * step).toPrecision(12));
      this.#take(clamp(inside(kind, next), this.#low, this.#high), true);
    });
    field.addEventListener("change", () => {
      this.#read().catch((problem) => this.say(problem.message, true));
    });
    field.addEventListener("keydown", (event) => {
      if (event.key !== "Enter") return;
      event.preventDefault();
      this.#read().catch(() => {});
    });
  }

  /**
   * A new value; the field shows it, unless somebody types on.
   * @param {number | undefined} value @param {boolean} settled @param {string} [note]
   */
  #take(value, settled, note, fieldToo = true) {
    this.#turn++;
    this.#now = value;
    this.say(note);
    if (!fieldToo) this.#painted = undefined;
    this.#paint(fieldToo);
    this.spec.change(value, settled);
  }

  /** What was typed. */
  async #read() {
    const {
        field,
        spec: { kind, clears },
      } = this,
      text = field.value.trim();
    // What the page wrote is not read again: it may have fewer digits than the value. What is being read is given up.
    if (
      text === this.#painted &&
      (this.#now === undefined || !field.hasAttribute("aria-invalid"))
    ) {
      this.#turn++;
      return;
    }
    if (!text && clears) return this.#take(undefined, true);
    const { text: asked, value, note } = meant(kind, text),
      turn = ++this.#turn;
    const reading =
      value === undefined
        ? (await understood([{ text: asked, kind }]))[0]
        : { value };
    // A later text or a drag counts, whichever is read first.
    if (turn !== this.#turn) return;
    if (reading.problem) return this.say(reading.problem.message, true);
    this.#take(reading.value, true, note, field.value.trim() === text);
  }

  #paint(fieldToo = true) {
    const {
        slider,
        unit,
        spec: { kind, unit: own },
      } = this,
      now = this.#now;
    // Without a value there is nothing to change a little.
    slider.hidden = now === undefined;
    slider.value = now === undefined ? "0" : String(1000 * this.#share(now));
    if (fieldToo) this.#write(now === undefined ? "" : this.#asText(now));
    unit.textContent = kind === "ratio" ? "" : (own ?? unitName(kind));
    slider.setAttribute(
      "aria-valuetext",
      now === undefined
        ? "not given"
        : `${number(outside(kind, now))} ${unitName(kind)}`,
    );
    this.#hint();
  }

  /** Writes into the field; a selection of all of it stays, so that typing replaces it. @param {string} text */
  #write(text) {
    const { field } = this,
      { selectionStart, selectionEnd, value } = field;
    const whole =
      document.activeElement === field &&
      selectionStart === 0 &&
      selectionEnd === value.length;
    if (value !== text) {
      field.value = text;
      if (whole) field.select();
    }
    this.#painted = text;
  }

  /** What may be typed. */
  #hint() {
    const { about, kind, above, minimum, maximum, usual } = this.spec;
    const bounds = [
      above === undefined ? "" : `above ${show(kind, above)}`,
      minimum === undefined ? "" : `from ${show(kind, minimum)}`,
      maximum === undefined ? "" : `up to ${show(kind, maximum)}`,
    ];
    const words = capital(
      [expectation(kind), ...bounds].filter(Boolean).join(", "),
    );
    this.field.title = [about, words].filter(Boolean).join(" ");
    this.field.placeholder =
      usual !== undefined ? this.#asText(usual) : kind === "ratio" ? "%" : "";
  }
}

/** A field with a slider. @param {Spec} spec */
export const quantity = (spec) => new Quantity(spec);

/**
 * A list to choose from.
 * @param {string} label @param {[string, string][]} options @param {string} value
 * @param {(value: string) => void} change
 */
export function choice(label, options, value, change) {
  const select = el(
    "select",
    { onchange: () => change(select.value) },
    ...optionsOf(options),
  );
  select.value = value;
  const element = el(
    "label",
    { class: "choice" },
    el("span", {}, label),
    select,
  );
  return {
    element,
    /** @param {string} v */
    set(v) {
      addOptions(select, [v]);
      select.value = v;
    },
    /** The name of the first one, which is the usual. @param {string} text */
    first(text) {
      if (select.options[0].textContent !== text)
        select.options[0].textContent = text;
    },
    /** All to choose from, by name and text. @param {[string, string][]} list */
    labels(list) {
      select.replaceChildren(...optionsOf(list));
    },
    /** More to choose from. @param {string[]} names */
    options(names) {
      addOptions(select, names);
    },
  };
}

/** The text of a file; of a workbook that of a sheet. @param {File} file */
export async function textOf(file) {
  const text = await file.text();
  if (!/^(PK\x03|\ufffd)/.test(text)) return text;
  try {
    return await (await import("./workbook.js")).sheetText(file);
  } catch {
    throw new Error(
      `${file.name} cannot be read: save it as .xlsx, .ods or CSV in UTF-8, or copy its cells and paste them here.`,
    );
  }
}

/** Names of tables end so. */
export const TABLES = ".csv,.txt,.tsv,.xlsx,.ods";
/** Boxes that take a file which is dropped on them. @type {WeakMap<Element, (file: File | undefined) => void>} */
export const boxes = new WeakMap();

/**
 * A field for text that the engine reads: a file's text. Drops of files are taken too.
 * @param {string} label @param {string} accept @param {(name: string, text: string) => void} take
 */
export function fileField(label, accept, take) {
  const read = async (/** @type {File | undefined} */ file) => {
    try {
      if (file) take(file.name, await textOf(file));
    } catch (problem) {
      noticeProblem(problem);
    }
  };
  const input = el("input", {
    type: "file",
    accept,
    class: "unseen",
    "aria-label": label,
    tabindex: -1,
    onchange() {
      read(input.files?.[0]);
      input.value = "";
    },
  });
  const box = block(
    "drop",
    button(label, () => input.click()),
    el(
      "p",
      { class: "small soft", style: "margin:4px 0 0" },
      "or drop it here",
    ),
    input,
  );
  boxes.set(box, read);
  return box;
}
