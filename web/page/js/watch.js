// State of the page: values whose readers run again after each change, and what ends with the page.
import { atEnd } from "./life.js";
import { effect } from "./vendor/signals.js";

export { atEnd, endAll, renewing, rested } from "./life.js";
export { batch, computed, effect, signal, untracked } from "./vendor/signals.js";
/**
 * Runs it at once, and again after each change of what it reads, until the page that is shown ends.
 * @param {() => unknown} act
 */
export const watch = (act) => atEnd(effect(() => void act()));
