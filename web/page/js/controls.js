// A quantity as a slider with a field beside it, and a choice from a list.
import { understood } from "./ask.js";
import {
  addOptions,
  block,
  button,
  capital,
  el,
  noticeProblem,
  optionsOf,
  textField,
} from "./dom.js";
import {
  changeUnit,
  clamp,
  expectation,
  hasChoice,
  inWords,
  inside,
  meant,
  number,
  outside,
  show,
  unitName,
} from "./units.js";
import { watch } from "./watch.js";

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
 * `change` is called at every step, with `settled` at the end of a gesture. Without a value the
 * field is empty; one that `clears` may be emptied, and then has the usual value.
 * @typedef {{ key?: string, field?: string, label: string, symbol?: string, about?: string,
 *   kind: Kind, unit?: string, value?: number, above?: number, minimum?: number, maximum?: number,
 *   usual?: number, low?: number, high?: number, around?: boolean, clears?: boolean,
 *   change: (value: number | undefined, settled: boolean) => void }} Spec
 */

/**
 * What is said below a field: a note, or what is wrong with it.
 * @param {HTMLElement} field @param {HTMLElement} box
 */
export const saying =
  (field, box) =>
  (text = "", wrong = false) => {
    box.className = wrong ? "wrong" : "note small soft";
    box.textContent = wrong ? capital(inWords(text)) : text;
    box.hidden = !text;
    field.ariaInvalid = wrong && text ? "true" : null;
  };

/** A field with a slider, where that has ends. @param {Spec} spec */
export function quantity(spec) {
  const { label, symbol, about, kind, around } = spec,
    id = `q${++count}`;
  let { value: now, low = NaN, high = NaN } = spec;
  /**
   * The value as the page wrote it into the field; nothing where the value changed under a text of
   * somebody.
   * @type {string | undefined}
   */
  let painted = "";
  /** Counts what was typed or dragged. */
  let turn = 0;
  const slider = el("input", {
    type: "range",
    min: 0,
    max: 1000,
    step: "any",
    ariaLabel: label,
    oninput: () => take(fromSlider(), false),
    onchange: () => spec.change(now, true),
    onkeydown(/** @type {KeyboardEvent} */ event) {
      const by = STEPS[event.key];
      if (by === undefined) return;
      event.preventDefault();
      const at = outside(kind, now ?? low),
        one = around ? 10 ** Math.floor(Math.log10(at / 20)) : step();
      const next = Number((at + by * one).toPrecision(12));
      take(clamp(inside(kind, next), low, high), true);
    },
  });
  const field = textField({
    id,
    "aria-describedby": `${id}w`,
    onchange: () => read().catch((problem) => tell(problem.message, true)),
    onkeydown(/** @type {KeyboardEvent} */ event) {
      if (event.key !== "Enter") return;
      event.preventDefault();
      read().catch(() => {});
    },
  });
  const unit = hasChoice(kind)
    ? button("", () => changeUnit(kind), { class: "bare", title: "Change the unit everywhere" })
    : el("span", { class: "soft" });
  const below = el("p", { id: `${id}w`, hidden: true, role: "status" });
  const tell = saying(field, below);
  const element = block(
    "quantity",
    el("label", { for: id }, label, ...(symbol ? [" ", el("i", { class: "soft" }, symbol)] : [])),
    field,
    unit,
    Number.isNaN(low) ? null : slider,
    below,
  );

  /** Whether somebody is typing. */
  const typing = () => document.activeElement === field && field.value !== painted;
  /**
   * A value as it stands in the field; with its sign where it is in %, so that it can be read
   * again.
   * @param {number} v
   */
  const asText = (v) =>
    kind === "ratio" ? `${number(outside(kind, v), 5)} %` : number(outside(kind, v), 6);
  /** A step that suits the shown unit: the power of ten below a hundredth of the reach. */
  const step = () =>
    10 ** Math.floor(Math.log10(Math.abs(outside(kind, high) - outside(kind, low)) / 100));
  /** By its logarithm where its ends are around a value. */
  function fromSlider() {
    const share = Number(slider.value) / 1000;
    const v = outside(kind, around ? low * (high / low) ** share : low + share * (high - low));
    // A round value may lie beyond its ends.
    if (around)
      return clamp(
        inside(kind, Number(v.toPrecision(v < 3 * 10 ** Math.floor(Math.log10(v)) ? 3 : 2))),
        low,
        high,
      );
    return inside(kind, Number((Math.round(v / step()) * step()).toPrecision(12)));
  }
  const share = (/** @type {number} */ v) =>
    around ? Math.log(Math.max(v, 1e-12) / low) / Math.log(high / low) : (v - low) / (high - low);

  /**
   * A new value; the field shows it, unless somebody types on.
   * @param {number | undefined} value @param {boolean} settled @param {string} [note]
   */
  function take(value, settled, note, fieldToo = true) {
    turn++;
    now = value;
    tell(note);
    if (!fieldToo) painted = undefined;
    paint(fieldToo);
    spec.change(value, settled);
  }

  /** What was typed. */
  async function read() {
    const text = field.value.trim();
    // What the page wrote is not read again: it may have fewer digits than the value. What is being
    // read is given up.
    if (text === painted && (now === undefined || !field.ariaInvalid)) {
      turn++;
      return;
    }
    if (!text && spec.clears) return take(undefined, true);
    const { text: asked, value, note } = meant(kind, text),
      mine = ++turn;
    const reading =
      value === undefined ? (await understood([{ text: asked, kind }]))[0] : { value };
    // A later text or a drag counts, whichever is read first.
    if (mine !== turn) return;
    if (reading.problem) return tell(reading.problem.message, true);
    take(reading.value, true, note, field.value.trim() === text);
  }

  function paint(fieldToo = true) {
    // Without a value there is nothing to change a little.
    slider.hidden = now === undefined;
    slider.value = now === undefined ? "0" : String(1000 * share(now));
    if (fieldToo) write(now === undefined ? "" : asText(now));
    unit.textContent = kind === "ratio" ? "" : (spec.unit ?? unitName(kind));
    slider.ariaValueText = now === undefined ? "not given" : show(kind, now);
    hint();
  }

  /**
   * Writes into the field; a selection of all of it stays, so that typing replaces it.
   * @param {string} text
   */
  function write(text) {
    const { selectionStart, selectionEnd, value } = field;
    const whole =
      document.activeElement === field && selectionStart === 0 && selectionEnd === value.length;
    if (value !== text) {
      field.value = text;
      if (whole) field.select();
    }
    painted = text;
  }

  /** What may be typed. */
  function hint() {
    const { above, minimum, maximum, usual } = spec;
    const bound = (/** @type {string} */ word, /** @type {number | undefined} */ v) =>
      v === undefined ? "" : `${word} ${show(kind, v)}`;
    const bounds = [bound("above", above), bound("from", minimum), bound("up to", maximum)];
    const words = capital([expectation(kind), ...bounds].filter(Boolean).join(", "));
    field.title = [about, words].filter(Boolean).join(" ");
    field.placeholder = usual !== undefined ? asText(usual) : kind === "ratio" ? "%" : "";
  }

  /** @param {number} least @param {number} most */
  const reach = (least, most) => {
    [low, high] = [least, most];
    paint(!typing());
  };
  watch(() => paint());
  return {
    element,
    reach,
    /** @param {number | undefined} v */
    set(v) {
      if (v === now) return;
      now = v;
      tell();
      const fieldToo = !typing();
      if (!fieldToo) painted = undefined;
      paint(fieldToo);
    },
    /**
     * What is wrong with it, said by the engine; empty where nothing is. @param {string} message
     */
    mark(message) {
      if (message) return tell(message, true);
      if (!field.ariaInvalid) return;
      tell();
      paint(!typing());
    },
    /**
     * Ends from 0.3 to 3 times its value, within limits.
     * @param {number} [least] @param {number} [most]
     */
    anchor(least = 0, most = Infinity) {
      if (around && now) reach(Math.max(least, 0.3 * now), Math.min(most, 3 * now));
    },
    /** @param {boolean} on */
    enable(on) {
      slider.disabled = field.disabled = !on;
    },
  };
}

/**
 * A list to choose from.
 * @param {string} label @param {[string, string][]} options @param {(value: string) => void} change
 */
export function choice(label, options, change) {
  const select = el("select", { onchange: () => change(select.value) }, ...optionsOf(options));
  const element = el("label", { class: "choice" }, el("span", label), select);
  /** The usual one stands once. */
  const once = () => {
    const [usual, ...others] = select.options;
    for (const one of others) one.hidden = one.text === usual.text;
  };
  return {
    element,
    /** @param {string} v */
    set(v) {
      addOptions(select, [v]);
      select.value = v;
    },
    /** The name of the first one, which is the usual. @param {string} text */
    first(text) {
      select.options[0].textContent = text;
      once();
    },
    /** More to choose from. @param {string[]} names */
    options(names) {
      addOptions(select, names);
      once();
    },
  };
}

/** The text of a file; of a workbook that of a sheet. @param {File} file */
export async function textOf(file) {
  const text = await file.text();
  if (!/^(PK\x03|\ufffd)|\0/.test(text)) return text;
  try {
    return await (await import("./workbook.js")).sheetText(file);
  } catch {
    throw new Error(
      `${file.name} cannot be read: save it as .xlsx, .ods or CSV in UTF-8, or paste its cells here.`,
    );
  }
}

/** Names of tables end so. */
export const TABLES = ".csv,.txt,.tsv,.xlsx,.ods";
/**
 * What opens the browser's window of files; a button stands for it.
 * @param {string} label @param {string} accept @param {(files: File[]) => void} take
 */
export function fileInput(label, accept, take, multiple = false) {
  const input = el("input", {
    type: "file",
    accept,
    multiple,
    class: "unseen",
    ariaLabel: label,
    tabindex: -1,
    onchange() {
      take([...(input.files ?? [])]);
      input.value = "";
    },
  });
  return input;
}

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
  const input = fileInput(label, accept, ([file]) => read(file));
  const ondrop = (/** @type {DragEvent} */ event) => {
    event.preventDefault();
    read(event.dataTransfer?.files[0]);
  };
  return el(
    "div",
    { class: "drop", ondrop },
    button(label, () => input.click()),
    el("p", { class: "small soft", style: "margin:4px 0 0" }, "or drop it here"),
    input,
  );
}
