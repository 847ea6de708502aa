// Why there is no answer.

export class Problem extends Error {
  /** @param {{ kind: string, message: string, hint?: string, field?: string }} problem */
  constructor({ kind, message, hint, field }) {
    super(message);
    this.kind = kind;
    this.hint = hint ?? "";
    this.field = field ?? "";
  }
}

/** What was thrown, as a problem. @param {unknown} thrown */
export const problemOf = (thrown) =>
  thrown instanceof Problem
    ? thrown
    : new Problem({
        kind: "page",
        message: thrown instanceof Error ? thrown.message : String(thrown),
      });

/** Whether it is only that nobody waits for the answer any more. @param {unknown} thrown */
export const isAbort = (thrown) => thrown instanceof DOMException && thrown.name === "AbortError";

/** The engine is not there. @param {string} why */
export const gone = (why) =>
  new Problem({
    kind: "engine",
    message: `The computation engine stopped: ${why}.`,
    hint: "Your muscle is kept; try again.",
  });
