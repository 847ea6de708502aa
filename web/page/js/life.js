// What the page that is shown has begun ends with it: questions, listeners and views outlive their
// elements otherwise.

/** @type {(() => unknown)[]} */ let ends = [];

/** Ends with the page that is shown. @param {() => unknown} end */
export const atEnd = (end) => void ends.push(end);

/** The page is left: all that it has begun ends. */
export function endAll() {
  const all = ends;
  ends = [];
  all.forEach((end) => end());
}

/**
 * Does it after so many milliseconds without another wish; never once the page is left, nor after
 * a negative wait.
 * @param {() => unknown} act @param {number} usual
 */
export function rested(act, usual) {
  let timer = 0;
  atEnd(() => clearTimeout(timer));
  return (wait = usual) => {
    clearTimeout(timer);
    if (wait >= 0) timer = window.setTimeout(act, wait);
  };
}

/**
 * Work that ends with the page, or when it begins anew: gives the signal of its newest beginning.
 */
export function renewing() {
  let ends = new AbortController();
  atEnd(() => ends.abort());
  return () => {
    ends.abort();
    return (ends = new AbortController()).signal;
  };
}
