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

/** The engine is not there. @param {string} why */
export const gone = (why) =>
  new Problem({ kind: "engine", message: `The computation engine stopped: ${why}.`,
    hint: "Your muscle is kept; try again." });
