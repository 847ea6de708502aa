// What the page that is shown has begun, and what ends it: listeners and views outlive their elements otherwise.

/** @type {(() => void)[]} */ let ends = [];

/** Ends with the page that is shown. @template {() => void} F @param {F} end @returns {F} */
export function atEnd(end) {
  ends.push(end);
  return end;
}

/** The page is left: all that it has begun ends. */
export function endAll() {
  const all = ends;
  ends = [];
  all.forEach((end) => end());
}

/**
 * A view or a chart of the page that is shown: destroyed with it.
 * @template T @param {T & { destroy?: () => void }} view @returns {T}
 */
export function held(view) {
  atEnd(() => view.destroy?.());
  return view;
}
