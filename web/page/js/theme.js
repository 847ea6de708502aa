// Light and dark: as the system has it, or as somebody chose it, which the browser keeps.
import { isDark } from "./chart.js";
import { el } from "./dom.js";
import { remembered } from "./kept.js";

const chosen = remembered("theme");
const { dataset } = document.documentElement;
if (chosen.get()) dataset.theme = chosen.get();

export function themeButton() {
  const button = el("button", { type: "button", onclick: () => {
    dataset.theme = isDark() ? "light" : "dark";
    chosen.set(dataset.theme);
    paint();
    document.dispatchEvent(new Event("theme"));
  } });
  const paint = () => { button.textContent = isDark() ? "Light" : "Dark"; };
  paint();
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", paint);
  return button;
}
