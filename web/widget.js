// The muscle in a notebook (anywidget): the page's own view, and sliders that are linked with Python, which computes. It is used with its imports in one
// piece (crate mckibben-web).
import { el } from "./page/js/dom.js";
import { View, reach } from "./page/js/view3d.js";

/**
 * A slider: the name that Python has for its value, words, unit and ends.
 * @typedef {{ name: string, label: string, unit: string, low: number, high: number }} Slider
 * What Python holds, as anywidget hands it over.
 * @typedef {{ get: (name: string) => any, set: (name: string, value: unknown) => void, save_changes: () => void,
 *   on: (event: string, act: () => void) => void, off: (event: string, act: () => void) => void }} Model
 */

/** @param {{ model: Model, el: HTMLElement }} place */
export function render({ model, el: root }) {
  /** @type {[string, () => void][]} */ const heard = [];
  const listen = (/** @type {string} */ name, /** @type {() => void} */ act) => {
    heard.push([`change:${name}`, act]);
    model.on(`change:${name}`, act);
    act();
  };
  const put = (/** @type {string} */ name, /** @type {number} */ value) => {
    model.set(name, value);
    model.save_changes();
  };
  const said = el("p", { class: "say", role: "status" });
  const hint = el("p", { class: "hint" }, "Drag to turn; drag the right end to contract. Coloured by the largest stretch of the rubber.");
  const stage = el("div", { class: "stage" }, said, hint), sliders = el("div", { class: "sliders" });
  root.append(el("div", { class: "mckibben" }, stage, sliders));
  let from = /** @type {number | undefined} */ (undefined);
  const view = new View(stage, { contract: (share, settled) => {
    from ??= Number(model.get("_shown").contraction);
    put("contraction", Math.min(0.9, Math.max(-0.1, Math.round(1000 * (from + share)) / 1000)));
    if (settled) from = undefined;
  } });
  if (!view.gl) hint.textContent = "The section: this browser shows no pictures in space (WebGL).";
  for (const { name, label, unit, low, high } of /** @type {Slider[]} */ (model.get("_sliders"))) {
    const shown = el("output"), step = 10 ** Math.floor(Math.log10((high - low) / 100));
    const slider = el("input", { type: "range", name, min: low, max: high, step, oninput: () => put(name, Number(slider.value)) });
    sliders.append(el("label", {}, el("span", {}, label), slider, shown));
    listen(name, () => {
      slider.value = model.get(name);
      shown.textContent = `${Number(model.get(name).toPrecision(4))} ${unit}`;
    });
  }
  listen("_shown", () => {
    const { shape, words } = model.get("_shown");
    said.textContent = words;
    if (!shape) return;
    const [low, high] = reach(shape.arrays.max_stretch);
    view.set(shape, { field: "max_stretch", low, high, restLength: shape.rest_length_mm, restRadius: shape.rest_radius_mm });
  });
  return () => {
    heard.forEach(([event, act]) => model.off(event, act));
    view.destroy();
  };
}
