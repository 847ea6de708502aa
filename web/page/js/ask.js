// The one engine of the page, and questions of which only the newest counts.
import { Engine } from "./kind.js";
import { problemOf } from "./engine/problem.js";
import { atEnd } from "./life.js";
import { bareIn, kindOf, takeUnits } from "./units.js";

/** @type {Engine | undefined} */ let one;
/** The engine; throws where there can be none. */
export const engine = () => (one ??= new Engine());
/** An answer of it. @type {Engine["ask"]} */
export const answerTo = (command, request, how) => engine().ask(command, request, how);
export async function loadUnits() {
  takeUnits(await answerTo("units", {}, { lane: "state" }));
}

/**
 * What was typed, as numbers: each with `value`, `values` of a list, or `problem`.
 * @param {{ text: string, kind: Kind, list?: boolean }[]} texts @returns {Promise<Readings>}
 */
export async function understood(texts) {
  if (!texts.length) return [];
  const asked = texts.map(({ kind, ...rest }) => ({ ...rest, kind: kindOf(kind) }));
  const { readings } = await answerTo("quantities", { texts: asked }, { lane: "read" });
  // A number alone is in the unit that is shown, which the engine does not know.
  return /** @type {Readings} */ (readings).map(({ problem, ...rest }, i) => ({
    ...rest,
    problem: problem && { message: bareIn(problem.message, texts[i].kind) },
  }));
}

/**
 * Answers of long work, the newest last: who comes back to a page has them at once. The engine is
 * deterministic.
 * @type {Map<string, unknown>}
 */
const answers = new Map();
const MOST_ANSWERS = 16;
/**
 * Long work with progress; what was asked before is answered at once.
 * @template {keyof Commands} K @param {K} command @param {Commands[K]["request"]} request
 * @param {{ signal?: AbortSignal, progress?: (done: number, total: number) => void }} options
 * @returns {Promise<Commands[K]["answer"]>}
 */
export async function longWork(command, request, options) {
  const key = `${command} ${JSON.stringify(request)}`;
  const known = /** @type {Commands[K]["answer"] | undefined} */ (answers.get(key));
  const answer = known ?? (await answerTo(command, request, { lane: "job", ...options }));
  answers.delete(key);
  answers.set(key, answer);
  if (answers.size > MOST_ANSWERS) answers.delete(answers.keys().next().value ?? "");
  return answer;
}

/**
 * So long a question may hold up a newer one of its place, in milliseconds; then it is given up.
 */
const PATIENCE = 1500;

/**
 * A place for questions of a page: one is on its way at most, and of those that wait only the
 * newest is asked.
 */
export class Slot {
  /** @type {AbortController | undefined} */ flying;
  /** @type {(() => void) | undefined} */ waiting;
  /** What was answered last. */
  known = { key: "", answer: /** @type {unknown} */ (undefined) };
  since = 0;
  timer = 0;
  patience = 0;

  /** @param {{ lane?: LaneName, busy?: (on: boolean) => void }} [options] */
  constructor({ lane = "side", busy } = {}) {
    this.lane = lane;
    this.busy = busy;
    atEnd(() => this.end());
  }

  /**
   * Asks, or waits for the question before; what was answered last is answered again at once.
   * @template {keyof Commands} K @param {K} command @param {Commands[K]["request"]} request
   * @param {(answer: Commands[K]["answer"]) => void} take
   * @param {(problem: Problem) => void} [fail]
   */
  ask(command, request, take, fail) {
    const key = command + JSON.stringify(request);
    const go = async () => {
      const { signal } = (this.flying = new AbortController());
      this.since = performance.now();
      this.timer ||= window.setTimeout(() => this.busy?.(true), 150);
      try {
        if (this.known.key !== key)
          this.known = {
            key,
            answer: await answerTo(command, request, { lane: this.lane, signal }),
          };
        take(/** @type {Commands[K]["answer"]} */ (this.known.answer));
      } catch (problem) {
        if (!signal.aborted) fail?.(problemOf(problem));
      }
      clearTimeout(this.patience);
      this.flying = undefined;
      const next = this.waiting;
      this.waiting = undefined;
      if (next) return next();
      clearTimeout(this.timer);
      this.timer = 0;
      this.busy?.(false);
    };
    if (!this.flying) return void go();
    this.waiting = go;
    const { flying } = this;
    clearTimeout(this.patience);
    this.patience = window.setTimeout(
      () => flying.abort(),
      Math.max(0, PATIENCE - (performance.now() - this.since)),
    );
  }

  /** Nothing is asked any more, and what is on its way is given up. */
  end() {
    this.waiting = undefined;
    this.flying?.abort();
  }
}
