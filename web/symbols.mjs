// Drawings of symbols for the glossary of the book: those of the page, as files. `node web/symbols.mjs` writes docs/figures/symbols,
// --check compares, and looks for each drawing in the glossary.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { DRAWINGS } from "./page/js/sketch.js";

const STYLE =
  "text{font:600 13px sans-serif;fill:#0b57a4}.rubber{fill:#e3e6ea;stroke:#8a929c}.plug{fill:#8a929c}" +
  ".axis{stroke:#8a929c;stroke-dasharray:8 3 2 3;fill:none}.plain{fill:none;stroke:#8a929c;stroke-width:1.5}" +
  ".strand{stroke:#8a929c;fill:none}.thick{stroke-width:8}.ghost{fill:none;stroke:#8a929c;stroke-dasharray:3 3}" +
  ".arm{stroke:#222;stroke-width:6;stroke-linecap:round}.measure{stroke:#0b57a4;stroke-width:1.6;fill:none}";
const check = process.argv.includes("--check"),
  docs = new URL("../docs/", import.meta.url);
const glossary = readFileSync(new URL("glossary.md", docs), "utf8"),
  wrong = [];
mkdirSync(new URL("figures/symbols/", docs), { recursive: true });
for (const [key, draw] of Object.entries(DRAWINGS)) {
  // Where K and k are one name to a file system, they are not.
  const name = `figures/symbols/${key.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`)}.svg`;
  const file = new URL(name, docs);
  const text =
    '<svg xmlns="http://www.w3.org/2000/svg" width="240" height="120" viewBox="0 0 240 120">' +
    `<style>${STYLE}</style><rect width="240" height="120" rx="6" fill="#fff"/>${draw()}</svg>\n`;
  if (!glossary.includes(`](${name})`)) wrong.push(`docs/glossary.md does not show ${name}`);
  if (!check) writeFileSync(file, text);
  else if (readFileSync(file, "utf8") !== text)
    wrong.push(`docs/${name} is not what the page draws`);
}
if (wrong.length) throw new Error(wrong.join("\n"));
