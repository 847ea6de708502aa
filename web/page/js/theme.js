// Light and dark, as the system has it.
import { signal } from "./watch.js";

const system = matchMedia("(prefers-color-scheme: dark)"),
  dark = signal(system.matches);
system.addEventListener("change", () => (dark.value = system.matches));
export const isDark = () => dark.value;

/** A colour of the theme. @param {string} name */
export function token(name) {
  const [light = "", dark = light] =
    getComputedStyle(document.documentElement).getPropertyValue(name).match(/#\w+/g) ?? [];
  return isDark() ? dark : light;
}
