// The muscle that all pages share: its state, what the engine read of it, and the address.
import { answerTo, understood } from "./ask.js";
import { address, query, unpacked } from "./address.js";
import {
  canonical,
  fields,
  fromWords,
  keys,
  missing,
  opened,
  prototype,
  say,
  shownValue,
  takeMeasures,
  question,
  texts,
  words,
  MEASURES,
} from "./state.js";
import { nameIn, named, stated } from "./toml.js";
import { batch, signal } from "./watch.js";
import { learn, showLength, typed, unitsFromAddress, unitsInAddress } from "./units.js";
import { keepWords, wordsOf } from "./kept.js";

const measure = (/** @type {string} */ key) => MEASURES.find((m) => m.key === key);

/** The measures that the program has; before a page asks for one. */
export async function loadMeasures() {
  const answer = await answerTo("measures", {}, { lane: "read" });
  takeMeasures(answer);
  learn(MEASURES);
}

/**
 * What the engine read: all of `check`, or the measures of another answer.
 * @typedef {Commands["force"]["answer"]["muscle"] & Partial<Commands["check"]["answer"]>} Shown
 */
/** What the engine says of a muscle at its point. */
/** @typedef {Commands["force"]["answer"] & Partial<Commands["contraction"]["answer"]>} Assessed */
/** Warnings in short, by their kinds. @type {Record<string, string>} */
const SHORT = {
  not_measured: "outside of the measured muscles",
  burst: "may burst",
  burst_not_checked: "burst pressure unknown",
  above_allowed: "above the allowed pressure",
  strand_strain: "strands stretch too far",
  rubber_stretch: "rubber beyond its test",
  extrapolated: "outside of the model's range",
};
/** @param {{ kind: string, message: string }} warning */
export const inShort = ({ kind, message }) =>
  SHORT[kind] ?? (kind === "general" ? message : kind.replaceAll("_", " "));

export class MuscleState {
  #state = signal(prototype());
  #shown = signal(/** @type {Shown | undefined} */ (undefined));
  #called = signal("");
  #assessed = signal(
    /** @type {{ of: State, answer: Assessed | undefined } | undefined} */ (undefined),
  );
  /**
   * Named sleeves, with what their sources do not state.
   * @type {{ name: string, missing: string, least_diameter_mm: number, largest_diameter_mm: number
   * }[]}
   */
  sleeves = [];
  /** @type {[string, string][]} */ unknown = [];
  /** @type {Map<string, string>} */ wrong = new Map();
  /** @type {{ of: string, file: Promise<string> } | undefined} */ written;
  /**
   * Until the address is read: a question before that would be about another muscle.
   * @type {Promise<unknown>}
   */
  ready = Promise.resolve();

  get state() {
    return this.#state.value;
  }
  set state(next) {
    this.#state.value = next;
  }
  /** What the engine read of file and fields, the last time that it could. */
  get shown() {
    return this.#shown.value;
  }
  set shown(next) {
    this.#shown.value = next;
  }
  /** The name that somebody gave it here; without one that of its file. */
  get called() {
    return this.#called.value;
  }
  set called(name) {
    this.#called.value = name;
  }
  /** What the engine says of it as it is now. */
  get assessed() {
    const said = this.#assessed.value;
    return said?.of === this.state ? said.answer : undefined;
  }
  /** What it warns of. */
  get warnings() {
    return this.assessed?.warnings ?? [];
  }

  /** Asks what the engine says of it at its point. */
  async assess() {
    const of = this.state,
      command = of.F === undefined ? "force" : "contraction";
    if (this.#assessed.peek()?.of === of) return;
    const answer = await answerTo(command, question(of)).catch(() => undefined);
    if (this.state === of)
      this.#assessed.value = { of, answer: /** @type {Assessed | undefined} */ (answer) };
  }

  /** The name that it was given, here or in its file. */
  get given() {
    return this.called || nameIn(this.state.file);
  }
  /** Its name. */
  get name() {
    const { file, said } = this.state;
    return (
      this.given ||
      (file || Object.keys(said).length ? "My muscle" : "Reference muscle (Antonelli 2018)")
    );
  }
  /** @param {string} text empty for that of its file */
  rename(text) {
    this.called = text === nameIn(this.state.file) ? "" : text;
  }

  get p() {
    return this.state.p;
  }
  get e() {
    return this.state.e;
  }

  /** The muscle of a request. */
  fields() {
    return fields(this.state);
  }

  /** @param {string} key @param {number | string | undefined} value */
  set(key, value) {
    this.state = say(this.state, key, value);
    // What is taken back is read again.
    const field = value === undefined && measure(key)?.field;
    if (field && this.shown) this.shown = { ...this.shown, [field]: undefined };
    this.wrong.delete(key);
  }

  /** A measure as a control shows it. @param {string} key @returns {number | undefined} */
  value(key) {
    const of = measure(key);
    if (of) return shownValue(this.state, this.shown, of);
    return key === "p" || key === "e" || key === "F" ? this.state[key] : undefined;
  }

  /** The muscle file that says the same; what engines without a file are asked by. */
  file() {
    const of = JSON.stringify(fields(this.state, this.p));
    if (this.written?.of !== of) {
      const file = canonical(this.state, answerTo);
      this.written = { of, file };
      file.catch(() => {
        this.written = undefined;
      });
    }
    return this.written.file;
  }

  /** What its sleeve needs beside its name, and is not said yet. */
  missing() {
    return missing(this.state, this.sleeves);
  }

  /** The muscle file with its name, for people to keep. */
  async toml() {
    await this.ready;
    return named(await this.file(), this.name);
  }

  /** Diameter, wall and length. */
  size() {
    const s = this.shown;
    return s
      ? `D0 ${showLength(s.outer_diameter_mm)}, s ${showLength(s.wall_mm)}, L0 ${showLength(s.length_mm)}`
      : "";
  }

  /**
   * A page's address with the muscle and what was typed there.
   * @param {string} page @param {Record<string, string | undefined>} mine
   */
  linked(page, mine = this.params()) {
    const word = query(mine),
      // Words of the muscle mean other things in a specification: it is one word there.
      m = word === query(words(prototype(), typed)) ? "" : word;
    return address(page, { ...wordsOf(page), ...(page === "design" ? { m } : mine) });
  }

  /** Words of the address. */
  params() {
    return {
      ...words(this.state, typed),
      ...Object.fromEntries(this.unknown),
      u: unitsInAddress() || undefined,
      name: this.called || undefined,
    };
  }

  /**
   * From an address; keys that the page `own`s are not unknown.
   * @param {URLSearchParams} params @param {string[]} own
   */
  read(params, own = []) {
    const read = this.#read(params, own);
    this.ready = read.catch(() => {});
    return read;
  }
  /** @param {URLSearchParams} params @param {string[]} own */
  async #read(params, own) {
    unitsFromAddress(params.get("u") ?? "");
    // In a word of another address it is compressed still.
    params.set("file", unpacked(params.get("file") ?? ""));
    const readings = await understood(texts(params).map(({ text, kind }) => ({ text, kind })));
    const known = new Set([...keys(), "u", "name", ...own]);
    this.unknown = [...params].filter(([key]) => !known.has(key));
    this.#put(fromWords(params, readings), (params.get("name") ?? "").slice(0, 80));
    // What cannot be read the page says when it asks for more.
    const looked = this.look().catch(() => {
      this.shown = undefined;
    });
    await Promise.all([looked, this.known()]);
  }

  /** The sleeves of the library, once. */
  async known() {
    if (!this.sleeves.length)
      this.sleeves = (await answerTo("parts-list", { kind: "sleeves" }, { lane: "read" })).sleeves;
  }

  /** What the engine reads of file and fields. */
  async look() {
    this.shown = await answerTo(
      "check",
      { muscle: this.fields(), only_data: true },
      { lane: "read" },
    );
    return this.shown;
  }

  /**
   * A muscle file in place of everything else; refused as a whole where it is none.
   * @param {string} text @param {string} [name] of the file
   * @param {string} [called] what people call the muscle
   */
  async take(text, name = "muscle.toml", called = "") {
    const next = opened(this.state, text),
      set = stated(text).get("job.pressure"),
      [, at] = /^points = .*?contraction = ([\d.]+)/m.exec(text) ?? [],
      request = { muscle: { file: { name, text } }, only_data: true };
    const shown = await answerTo("check", request, { lane: "read" });
    // At what it was designed for.
    const [job] = await understood(set ? [{ text: set, kind: "pressure" }] : []);
    next.p = job?.value ?? next.p;
    next.e = Number(at ?? next.e);
    this.#put({ state: next, shown, wrong: new Map() }, called === nameIn(text) ? "" : called);
    return shown;
  }

  /** @param {object} parts @param {string} called */
  #put(parts, called) {
    batch(() => Object.assign(this, parts, { called }));
  }
}
export const muscle = new MuscleState();

/**
 * Goes to a page with words over the kept ones; the muscle goes along.
 * @param {string} page @param {Record<string, string | undefined>} words
 */
export function visit(page, words) {
  keepWords(page, { ...wordsOf(page), ...words });
  const to = muscle.linked(page);
  if (to === location.hash)
    window.dispatchEvent(new PopStateEvent("popstate", { state: history.state }));
  else location.hash = to;
}
