// Joint files as the page has them: what a file states of pulley, range and neutral angle, and the file with what was
// typed over it.

/** Values of the lines of a TOML file, by table and key. @param {string} text @returns {Map<string, string>} */
function lines(text) {
  /** @type {Map<string, string>} */ const found = new Map();
  walk(text, (place, value) => {
    if (!found.has(place)) found.set(place, value);
  });
  return found;
}

/**
 * @param {string} text
 * @param {(place: string, value: string) => string | void} each what it returns takes the place of the value
 * @returns {string}
 */
function walk(text, each) {
  let table = "";
  return text.split("\n").map((line) => {
    const head = /^\s*\[+\s*([\w.-]+)\s*\]+/.exec(line);
    if (head) {
      table = head[1];
      return line;
    }
    const [, key, value] = /^\s*([\w-]+)\s*=\s*("[^"]*"|'[^']*'|[^#]*)/.exec(line) ?? [];
    if (!key) return line;
    const bare = value.trim().replace(/^["']|["']$/g, ""), put = each(`${table}.${key}`, bare);
    return put === undefined ? line : `${key} = ${JSON.stringify(put)}`;
  }).join("\n");
}

/**
 * Texts of what a joint file states, by the page's keys.
 * @param {string} text
 * @returns {{ r?: string, range?: string, e0?: string, mass?: string, centre?: string, inertia?: string }}
 */
export function stated(text) {
  const of = lines(text);
  return { r: of.get("joint.radius"), range: of.get("joint.range"), e0: of.get("muscle_1.contraction_at_neutral"),
    mass: of.get("link.mass"), centre: of.get("link.centre"), inertia: of.get("joint.inertia") };
}

/** Whether it has a second muscle. @param {string} text */
export const isOpposed = (text) => /^\s*\[\s*muscle_2\s*\]/m.test(text);

/**
 * A request for the joint of a file with this muscle and another one, and with what was typed over the file.
 * @param {string} text the joint file
 * @param {string} file the muscle's
 * @param {string} second the other's; empty where it is the same
 * @param {{ r?: number, low?: number, high?: number, e0?: number, mass?: number, centre?: number,
 *   inertia?: number }} over in mm, degrees, ratio, kg, kg m²; of what the file states
 */
export function jointOfFile(text, file, second, { r, low, high, e0, mass, centre, inertia }) {
  const other = second ? "muscle-2.toml" : "muscle.toml";
  const said = (/** @type {number | undefined} */ value, /** @type {string} */ unit) =>
    value === undefined ? undefined : `${value} ${unit}`;
  /** @type {Record<string, string | undefined>} */
  const put = {
    "muscle_1.file": "muscle.toml",
    "muscle_2.file": other,
    "joint.radius": said(r, "mm"),
    "joint.inertia": said(inertia, "kg m2"),
    "link.mass": said(mass, "kg"),
    "link.centre": said(centre, "mm"),
    "joint.range": low === undefined || high === undefined ? undefined : `${low}..${high} deg`,
    "muscle_1.contraction_at_neutral": e0 === undefined ? undefined : String(e0),
    "muscle_2.contraction_at_neutral": e0 === undefined ? undefined : String(e0),
  };
  const written = walk(text, (place) => put[place]);
  return { joint: { name: "joint.toml", text: written },
    muscles: [{ name: "muscle.toml", text: file }, ...(second ? [{ name: other, text: second }] : [])] };
}
