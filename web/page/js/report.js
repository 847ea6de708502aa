// The report as one HTML file that turns the muscle: the engine's page with the page's own view in
// it.
import { SCRIPTS } from "./place.js";

/**
 * Modules of the view, in the order in which they need each other (crate mckibben-web has the same
 * list).
 */
const MODULES = ["body.js", "dom.js", "life.js", "shaders.js", "view3d.js", "report-viewer.js"];

/** The modules as one script without imports. */
async function script() {
  const load = async (/** @type {string} */ name) => {
    const answer = await fetch(new URL(`../js/${name}`, SCRIPTS));
    if (!answer.ok) throw new Error(`${name} cannot be loaded (${answer.status}).`);
    const text = (await answer.text()).replaceAll("\nexport ", "\n");
    return text
      .split("\n")
      .filter((line) => !line.startsWith("import "))
      .join("\n");
  };
  return (await Promise.all(MODULES.map(load))).join("\n").replaceAll("</", "<\\/");
}

/** @param {string} html as the engine has it: its script is empty */
export async function withViewer(html) {
  const open = '<script type="module">\n',
    at = html.lastIndexOf(open);
  if (at < 0) return html;
  const behind = at + open.length;
  return html.slice(0, behind) + (await script()) + html.slice(behind);
}
