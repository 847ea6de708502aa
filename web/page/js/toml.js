// Files of TOML, line by line: the name of a muscle, what joint and drive files state, and a file
// with other values.

/**
 * @param {string} text
 * @param {(place: string, value: string) => string | void} each is told the value of a table's
 *   key (`joint.radius`; `.name` before the first table); what it returns takes its place
 */
function walk(text, each) {
  let table = "";
  return text
    .split("\n")
    .map((line) => {
      const head = /^\s*\[+\s*([\w.-]+)\s*\]+/.exec(line);
      if (head) table = head[1];
      const [, key, value = ""] = head
        ? []
        : (/^\s*([\w-]+)\s*=\s*("(?:[^"\\]|\\.)*"|'[^']*'|[^#]*)/.exec(line) ?? []);
      const put = key && each(`${table}.${key}`, plain(value.trim()));
      return put ? `${key} = ${JSON.stringify(put)}` : line;
    })
    .join("\n");
}
/** @param {string} value */
function plain(value) {
  try {
    return value.startsWith('"') ? String(JSON.parse(value)) : value.replace(/^'|'$/g, "");
  } catch {
    return value.slice(1, -1);
  }
}
/** What a file states first, by table and key. @param {string} text */
export function stated(text) {
  /** @type {Map<string, string>} */ const found = new Map();
  walk(text, (place, value) => {
    if (!found.has(place)) found.set(place, value);
  });
  return found;
}
/**
 * A file with other values where it states some.
 * @param {string} text @param {Record<string, string | undefined>} put
 */
export const replaced = (text, put) => walk(text, (place) => put[place]);

/** The name that a muscle file states. @param {string} file */
export const nameIn = (file) => stated(file).get(".name") ?? "";
/** The file with another name. @param {string} file @param {string} name */
export function named(file, name) {
  if (!name || nameIn(file) === name) return file;
  if (stated(file).has(".name")) return replaced(file, { ".name": name });
  // Below the remarks that a file begins with.
  const remarks = /^(?:[ \t]*#.*\n)*/.exec(file)?.[0] ?? "",
    rest = file.slice(remarks.length);
  return `${remarks}name = ${JSON.stringify(name)}\n${remarks && !rest.startsWith("\n") ? "\n" : ""}${rest}`;
}

/** The name of a file. @param {string} name @param {string} end such as `.toml` */
export function fileName(name, end) {
  const plain = name
    .normalize("NFKD")
    .replace(/[^\w.-]+/g, "-")
    .replace(/^[-.]+|-+$/g, "")
    .toLowerCase();
  return `${plain.slice(0, 60) || "muscle"}${end}`;
}
