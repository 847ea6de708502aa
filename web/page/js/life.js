// What the page that is shown has begun ends with it: questions, listeners and views outlive their elements otherwise.

/** @type {(() => unknown)[]} */ let ends = [];

/** Ends with the page that is shown. @param {() => unknown} end */
export const atEnd = (end) => void ends.push(end);

/** The page is left: all that it has begun ends. */
export function endAll() {
  const all = ends;
  ends = [];
  all.forEach((end) => end());
}

/** Listeners to one thing: those of the page that is shown (`on`) end with it, others stay. */
export function signal() {
  /** @type {Set<() => void>} */ const listeners = new Set();
  return {
    tell: () => listeners.forEach((tell) => tell()),
    /** @param {() => void} tell */
    stay: (tell) => void listeners.add(tell),
    /** @param {() => void} tell */
    on(tell) {
      listeners.add(tell);
      atEnd(() => listeners.delete(tell));
    },
  };
}
