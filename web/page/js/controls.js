// A quantity as a slider with a field beside it, and a choice from a list.
import { understood } from "./ask.js";
import { capital, el } from "./dom.js";
import { changeUnit, expectation, hasChoice, inside, meant, number, onAnyUnits, outside, show, unitName } from "./units.js";
import { atEnd } from "./life.js";
import { sketched } from "./sketch.js";
import { inWords } from "./words.js";

let count = 0;

/**
 * A field with a slider, where that has ends. `change` is called at every step, with `settled` at the end of a gesture. Without a value the field
 * is empty; one that `clears` may be emptied, and then has the usual value.
 * @param {{ key?: string, field?: string, label: string, symbol?: string, about?: string, kind: import("./units.js").Kind, unit?: string, value?: number, above?: number, minimum?: number, maximum?: number, usual?: number,
 *   low?: number, high?: number, clears?: boolean, change: (value: number | undefined, settled: boolean) => void }} spec
 */
export function quantity({ key, field: of, label, symbol = "", about, kind, unit: own, value, above, minimum, maximum, usual, low = NaN, high = NaN, clears, change }) {
  const id = `q${++count}`;
  let now = /** @type {number} */ (value), painted = "";
  /** Whether somebody is typing. */
  const typing = () => document.activeElement === field && field.value !== painted;
  const slider = el("input", { type: "range", min: 0, max: 1000, step: "any", "aria-label": label });
  const field = el("input", { type: "text", id, autocomplete: "off", spellcheck: "false", "aria-describedby": `${id}w` });
  const unit = hasChoice(kind)
    ? el("button", { type: "button", class: "bare", title: "Change the unit everywhere", onclick: () => changeUnit(kind) })
    : el("span", { class: "soft" });
  const wrong = el("p", { class: "wrong", id: `${id}w`, hidden: true, role: "status" });
  const element = el("div", { class: "quantity" }, el("label", { for: id }, label, symbol ? " " : "", symbol ? el("i", { class: "soft" }, symbol) : null), field, unit, Number.isNaN(low) ? null : slider, wrong);

  sketched(element, key, of);
  if (about) element.dataset.about = about;
  const bounds = { low, high };
  const toSlider = (/** @type {number} */ v) => String((1000 * (v - bounds.low)) / (bounds.high - bounds.low));
  /** A value as it stands in the field; with its sign where it is in %, so that it can be read again. @param {number} v */
  const asText = (v) => number(outside(kind, v), 6).replace("−", "-") + (kind === "ratio" ? " %" : "");
  const fromSlider = () => tidy(bounds.low + (Number(slider.value) / 1000) * (bounds.high - bounds.low));
  /** A step that suits the shown unit: the power of ten below a hundredth of the reach. */
  const stepOf = () => 10 ** Math.floor(Math.log10(Math.abs(outside(kind, bounds.high) - outside(kind, bounds.low)) / 100));
  /** @param {number} v */
  function tidy(v) {
    const step = stepOf();
    return inside(kind, Number((Math.round(outside(kind, v) / step) * step).toPrecision(12)));
  }
  function paint(fieldToo = true) {
    slider.value = now === undefined ? "0" : toSlider(now);
    if (fieldToo) field.value = painted = now === undefined ? "" : asText(now);
    unit.textContent = kind === "ratio" ? "" : own ?? unitName(kind);
    slider.setAttribute("aria-valuetext", now === undefined ? "not given" : `${number(outside(kind, now))} ${unitName(kind)}`);
    const bounds = [above === undefined ? "" : `above ${show(kind, above)}`, minimum === undefined ? "" : `from ${show(kind, minimum)}`, maximum === undefined ? "" : `up to ${show(kind, maximum)}`];
    field.title = [about, capital([expectation(kind), ...bounds].filter(Boolean).join(", "))].filter(Boolean).join(" ");
    field.placeholder = usual !== undefined ? asText(usual) : kind === "ratio" ? "%" : "";
  }
  function good(note = "") {
    field.removeAttribute("aria-invalid");
    wrong.className = "note small soft";
    wrong.textContent = note;
    wrong.hidden = !note;
  }
  slider.addEventListener("input", () => { now = fromSlider(); good(); paint(); change(now, false); });
  slider.addEventListener("change", () => change(now, true));
  slider.addEventListener("keydown", (event) => {
    const step = stepOf();
    const by = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    const next = inside(kind, Number((outside(kind, now ?? bounds.low) + by * step).toPrecision(12)));
    now = Math.min(bounds.high, Math.max(bounds.low, next));
    good();
    paint();
    change(now, true);
  });
  async function read() {
    const text = field.value.trim();
    // What stands there is not read again: it may have fewer digits than the value.
    if (text === painted && (now === undefined || !field.hasAttribute("aria-invalid"))) return;
    if (!text && clears) {
      now = /** @type {any} */ (undefined);
      good();
      paint();
      return change(undefined, true);
    }
    const { text: asked, value, note } = meant(kind, text);
    const reading = value === undefined ? (await understood([{ text: asked, kind }]))[0] : { value };
    if (reading.problem) return wrongly(reading.problem.message);
    now = /** @type {number} */ (/** @type {any} */ (reading).value);
    good(note);
    paint();
    change(now, true);
  }
  function wrongly(/** @type {string} */ message) {
    field.setAttribute("aria-invalid", "true");
    wrong.className = "wrong";
    wrong.textContent = inWords(message);
    wrong.hidden = false;
  }
  field.addEventListener("change", () => { read().catch((problem) => wrongly(problem.message)); });
  field.addEventListener("keydown", (event) => { if (event.key === "Enter") { event.preventDefault(); read().catch(() => {}); } });
  atEnd(onAnyUnits(() => paint()));
  paint();
  return {
    element,
    get value() { return now; },
    /** @param {number | undefined} v */
    set(v) { if (v !== now) { now = /** @type {number} */ (v); good(); paint(!typing()); } },
    /** What is wrong with it, said by the engine; empty where nothing is. @param {string} message */
    mark(message) { if (message) wrongly(message); else if (field.getAttribute("aria-invalid")) { good(); paint(!typing()); } },
    /** @param {number} newLow @param {number} newHigh */
    reach(newLow, newHigh) { bounds.low = newLow; bounds.high = newHigh; paint(!typing()); },
    /** @param {boolean} on */
    enable(on) { slider.disabled = !on; field.disabled = !on; },
  };
}

/**
 * A list to choose from. @param {string} label @param {[string, string][]} options @param {string} value @param {(value: string) => void} change
 */
export function choice(label, options, value, change) {
  const select = el("select", { onchange: () => change(select.value) }, ...options.map(([name, text]) => el("option", { value: name }, text)));
  select.value = value;
  const element = el("label", { class: "choice" }, el("span", {}, label), select);
  return {
    element,
    /** @param {string} v */
    set(v) {
      if (![...select.options].some((o) => o.value === v)) select.append(el("option", { value: v }, v));
      select.value = v;
    },
    /** The name of the first one, which is the usual. @param {string} text */
    first(text) { if (select.options[0].textContent !== text) select.options[0].textContent = text; },
    /** More to choose from, where they are not there yet. @param {string[]} names */
    options(names) {
      const there = new Set([...select.options].map((o) => o.value));
      select.append(...names.filter((n) => !there.has(n)).map((n) => el("option", { value: n }, n)));
    },
  };
}

/**
 * A field for text that the engine reads: a file's text, or words. Drops of files are taken too.
 * @param {string} label @param {string} accept @param {(name: string, text: string) => void} take
 */
export function fileField(label, accept, take) {
  const input = el("input", { type: "file", accept, class: "unseen" });
  const box = el("div", { class: "drop" }, el("button", { type: "button", onclick: () => input.click() }, label), el("p", { class: "small soft", style: "margin:4px 0 0" }, "or drop it here"), input);
  input.setAttribute("aria-label", label);
  input.tabIndex = -1;
  const read = async (/** @type {File | undefined} */ file) => { if (file) take(file.name, await file.text()); };
  input.addEventListener("change", () => { read(input.files?.[0]); input.value = ""; });
  onDrop(box, read);
  return box;
}

/** @param {HTMLElement} box @param {(file: File | undefined) => void} read */
export function onDrop(box, read) {
  box.addEventListener("dragover", (event) => { event.preventDefault(); box.classList.add("over"); });
  box.addEventListener("dragleave", () => box.classList.remove("over"));
  box.addEventListener("drop", (event) => { event.preventDefault(); event.stopPropagation(); box.classList.remove("over"); read(event.dataTransfer?.files[0]); });
}
