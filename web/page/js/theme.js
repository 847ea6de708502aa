// Light and dark: as the system has it, or as somebody chose it, which the browser keeps.
import { button } from "./dom.js";
import { remembered } from "./kept.js";
import { signal } from "./life.js";

const chosen = remembered("theme"),
  changed = signal();
const system = () => matchMedia("(prefers-color-scheme: dark)");
/** Is told of another theme. */
export const onTheme = changed.on;
export function isDark() {
  const { theme } = document.documentElement.dataset;
  return theme ? theme === "dark" : system().matches;
}

/** A colour of the theme. @param {string} name */
export function token(name) {
  const [light = "", dark = light] =
    getComputedStyle(document.documentElement).getPropertyValue(name).match(/#\w+/g) ?? [];
  return isDark() ? dark : light;
}

/** Another theme; that of the system without a word. @param {string | undefined} theme */
export function setTheme(theme) {
  const { dataset } = document.documentElement;
  if (theme) dataset.theme = theme;
  else delete dataset.theme;
  changed.tell();
}

export function themeButton() {
  setTheme(chosen.get());
  system().addEventListener("change", changed.tell);
  const other = button("", () => {
    chosen.set(isDark() ? "light" : "dark");
    setTheme(chosen.get());
  });
  const paint = () => {
    other.textContent = isDark() ? "Light" : "Dark";
  };
  paint();
  changed.stay(paint);
  return other;
}
