// The name of a muscle, as its file has it.

/** The line of the name: before the first table. */
const LINE = /^[ \t]*name[ \t]*=[ \t]*(?:"((?:[^"\\\n]|\\.)*)"|'([^'\n]*)')[ \t]*(?:#.*)?$/m;

/** @param {string} file */
const head = (file) => file.slice(0, /^[ \t]*\[/m.exec(file)?.index ?? file.length);

/** The name that a muscle file states. @param {string} file */
export function nameIn(file) {
  const [, quoted, bare] = LINE.exec(head(file)) ?? [];
  if (bare !== undefined) return bare;
  try {
    return quoted === undefined ? "" : /** @type {string} */ (JSON.parse(`"${quoted}"`));
  } catch {
    return quoted ?? "";
  }
}

/** The file with another name. @param {string} file @param {string} name */
export function named(file, name) {
  if (!name || nameIn(file) === name) return file;
  const line = `name = ${JSON.stringify(name)}`, top = head(file);
  if (LINE.test(top)) return top.replace(LINE, () => line) + file.slice(top.length);
  // Below the remarks that a file begins with.
  const remarks = /^(?:[ \t]*#.*\n)*/.exec(file)?.[0] ?? "";
  return `${remarks}${line}\n${remarks && !file.slice(remarks.length).startsWith("\n") ? "\n" : ""}${
    file.slice(remarks.length)
  }`;
}

/** The name of a file. @param {string} name @param {string} end such as `.toml` */
export const fileName = (name, end) =>
  `${
    name.normalize("NFKD").replace(/[^\w.-]+/g, "-").replace(/^[-.]+|-+$/g, "").toLowerCase().slice(0, 60) || "muscle"
  }${end}`;
