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
