// Renews the list of files that the page keeps for use without a network (page/sw.js): node web/offline.mjs
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join, relative } from "node:path";
import { fileURLToPath } from "node:url";

const here = fileURLToPath(new URL(".", import.meta.url)), page = join(here, "page"), worker = join(page, "sw.js");

/** Files of the page, and the examples that its scripts name. */
export function files() {
  const own = readdirSync(page, { recursive: true, withFileTypes: true }).filter((file) => file.isFile()).map((file) =>
    relative(page, join(file.parentPath, file.name))
  );
  const examples = readdirSync(join(here, "../examples"), { withFileTypes: true }).filter((file) => file.isFile()).map((
    file,
  ) => file.name);
  const scripts = own.filter((file) => file.endsWith(".js") && file !== "sw.js").map((file) =>
    readFileSync(join(page, file), "utf8")
  ).join("\n");
  const named = examples.filter((name) => scripts.includes(`"${name}"`)).map((name) => `examples/${name}`);
  return [...own.filter((file) => !["sw.js", "icon-512.png"].includes(file)), ...named].sort();
}

const text = () => readFileSync(worker, "utf8");
const LIST = /const FILES = \[\n([\s\S]*?)\n\];/;
/** The list that the worker has. */
export const listed = () => [...(LIST.exec(text())?.[1] ?? "").matchAll(/"([^"]+)"/g)].map((match) => match[1]);

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const lines = [""];
  for (const file of files()) {
    const word = `"${file}",`;
    if (`${lines[lines.length - 1]} ${word}`.length > 116) lines.push("");
    lines[lines.length - 1] += `${lines[lines.length - 1] ? " " : "  "}${word}`;
  }
  writeFileSync(worker, text().replace(LIST, () => `const FILES = [\n${lines.join("\n")}\n];`));
}
