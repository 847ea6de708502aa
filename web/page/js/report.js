// The report as one HTML file that turns the muscle: the engine's page with the page's own view in it.

import { el } from "./dom.js";
import { View, reach } from "./view3d.js";

/** Modules of the view, in the order in which they need each other (crate mckibben-web has the same list). */
const MODULES = ["dom.js", "shaders.js", "view3d.js", "report-viewer.js"];
/** @type {Promise<string> | undefined} */ let viewer;

/** The modules as one script without imports. */
function script() {
  const load = async (/** @type {string} */ name) => {
    const answer = await fetch(new URL(name, import.meta.url));
    if (!answer.ok) throw new Error(`${name} cannot be loaded (${answer.status}).`);
    const text = (await answer.text()).replaceAll("\nexport ", "\n");
    return text.split("\n").filter((line) => !line.startsWith("import ")).join("\n");
  };
  viewer ??= Promise.all(MODULES.map(load)).then((all) => all.join("\n").replaceAll("</", "<\\/"));
  viewer.catch(() => {
    viewer = undefined;
  });
  return viewer;
}

/** @param {string} html as the engine has it: its script is empty */
export async function withViewer(html) {
  const open = '<script type="module">\n', at = html.lastIndexOf(open);
  if (at < 0) return html;
  const behind = at + open.length;
  return html.slice(0, behind) + await script() + html.slice(behind);
}

const STILL = /<div class="still">([\s\S]*?)<\/div><script type="application\/json">([\s\S]*?)<\/script>/;
/** So long a picture of lines is at most, in characters. */
const MOST = 200_000;

/**
 * With the picture of the muscle as pixels, where the engine has drawn it of many thousand lines.
 * @param {string} html
 */
export function withPixels(html) {
  const [, still = "", data = ""] = STILL.exec(html) ?? [];
  if (still.length < MOST) return html;
  const stage = el("div", { style: "position:fixed;left:-2000px;top:0;width:960px;height:420px" });
  document.body.append(stage);
  const view = new View(stage);
  try {
    if (!view.gl) return html;
    const shape = JSON.parse(data), [low, high] = reach(shape.arrays.max_stretch);
    view.set(shape, { field: "max_stretch", low, high, restLength: shape.muscle.length_mm,
      restRadius: shape.muscle.outer_diameter_mm / 2 });
    view.draw(true);
    // What was drawn is there until this task ends.
    const pixels = view.canvas.toDataURL("image/webp", 0.8);
    const picture = `<img alt="The deformed muscle" style="width:100%" src="${pixels}">`;
    return html.replace(still, () => picture);
  } finally {
    view.destroy();
    stage.remove();
  }
}
