// Every link of the site's own pages leads somewhere: files, folders with an index, and places within pages.
// node tests/links.mjs FOLDER
import { existsSync, readFileSync, readdirSync, statSync } from "node:fs";
import { dirname, extname, join, normalize, relative, sep } from "node:path";

const folder = process.argv[2];
const pages = readdirSync(folder, { recursive: true })
  .map(String)
  .filter((f) => f.endsWith(".html") && !f.startsWith(`api${sep}`));
/** @type {Map<string, Set<string>>} */ const places = new Map();
/** @param {string} file */
function ids(file) {
  if (!places.has(file))
    places.set(
      file,
      new Set([...readFileSync(file, "utf8").matchAll(/\bid="([^"]*)"/g)].map((m) => m[1])),
    );
  return /** @type {Set<string>} */ (places.get(file));
}
let count = 0;
/** @type {string[]} */ const broken = [];
for (const page of pages) {
  const text = readFileSync(join(folder, page), "utf8");
  for (const [, link] of text.matchAll(/\b(?:href|src)="([^"]+)"/g)) {
    // Pages of the workbench live behind #; of the book and others behind a path.
    if (/^([a-z]+:|\/\/)/.test(link) || (page === "index.html" && link.startsWith("#"))) continue;
    count++;
    const [path, place] = decodeURI(link.replaceAll("&amp;", "&")).split("#");
    let file = path
      ? normalize(join(folder, path.startsWith("/") ? path : join(dirname(page), path)))
      : join(folder, page);
    if (existsSync(file) && statSync(file).isDirectory()) file = join(file, "index.html");
    if (!existsSync(file)) broken.push(`${page}: ${link}`);
    else if (
      place &&
      extname(file) === ".html" &&
      !file.includes(`${sep}api${sep}`) &&
      relative(folder, file) !== "index.html" &&
      !ids(file).has(place)
    )
      broken.push(`${page}: ${link} (no such place)`);
  }
}
console.log(`${pages.length} pages, ${count} links, ${broken.length} broken`);
broken.forEach((b) => console.log(b));
process.exit(broken.length ? 1 : 0);
