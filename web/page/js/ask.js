// The one engine of the page, and questions of which only the newest counts.
import { Engine } from "./kind.js";

/** @type {Engine | undefined} */ let one;
/** The engine; throws where there can be none. */
export const engine = () => (one ??= new Engine());

/**
 * What was typed, as numbers: each with `value`, `values` of a list, or `problem`.
 * @param {import("../../types/commands").Commands["quantities"]["request"]["texts"]} texts @returns {Promise<any[]>}
 */
export const understood = async (texts) => (texts?.length ? (await engine().ask("quantities", { texts }, { lane: "state" })).readings : []);

/** A place for questions: one is on its way at most, and of those that wait only the newest is asked. */
export class Slot {
  /** @param {{ lane?: "state" | "side", busy?: (on: boolean) => void }} [options] */
  constructor({ lane = "side", busy } = {}) {
    this.lane = lane;
    this.busy = busy;
    this.flying = false;
    /** @type {(() => void) | undefined} */ this.waiting = undefined;
    this.timer = 0;
  }

  /**
   * Asks, or waits for the question before.
   * @template {keyof import("../../types/commands").Commands} K
   * @param {K} command @param {import("../../types/commands").Commands[K]["request"]} request
   * @param {(answer: import("../../types/commands").Commands[K]["answer"]) => void} take @param {(problem: any) => void} [fail]
   */
  ask(command, request, take, fail) {
    const go = async () => {
      this.flying = true;
      this.timer ||= window.setTimeout(() => this.busy?.(true), 150);
      try {
        take(await engine().ask(command, request, { lane: this.lane }));
      } catch (problem) {
        fail?.(problem);
      }
      this.flying = false;
      const next = this.waiting;
      this.waiting = undefined;
      if (next) return next();
      clearTimeout(this.timer);
      this.timer = 0;
      this.busy?.(false);
    };
    if (this.flying) this.waiting = go;
    else go();
  }

  /** The question that waits is not asked any more. */
  forget() {
    this.waiting = undefined;
  }
}
