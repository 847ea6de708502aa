// Light and dark, as the system has it; paper is light.
import { signal } from "./life.js";

const changed = signal();
const system = () => matchMedia("(prefers-color-scheme: dark)");
/** Is told of another theme. */
export const onTheme = changed.on;
export const followSystem = () => system().addEventListener("change", changed.tell);
export const isDark = () =>
  !document.documentElement.hasAttribute("data-paper") && system().matches;

/** A colour of the theme. @param {string} name */
export function token(name) {
  const [light = "", dark = light] =
    getComputedStyle(document.documentElement).getPropertyValue(name).match(/#\w+/g) ?? [];
  return isDark() ? dark : light;
}

/** Black on white, whatever the system has. @param {boolean} on */
export function paper(on) {
  document.documentElement.toggleAttribute("data-paper", on);
  changed.tell();
}
