// The joint of an address: its values, its files and what was typed over them. The pages Joint and
// Motion ask about it.
import { understood } from "./ask.js";
import { joint } from "./state.js";
import { stated } from "./toml.js";
import { typed } from "./units.js";

/**
 * Words of the address: kind of quantity, usual value (in mm, degrees, ratio, N m, N m/rad, MPa, kg,
 * kg m²), and where a joint file states it too; both limits are its range. `k` is that of the
 * muscle's strands.
 */
const TABLE = /** @type {const} */ ({
  r: ["length", 25, "joint.radius"],
  low: ["angle", -60, ""],
  high: ["angle", 60, ""],
  e0: ["ratio", 0.12, "muscle_1.contraction_at_neutral"],
  phi: ["angle", 20],
  M: ["torque", 0],
  K: ["angular-stiffness", 8],
  pmax: ["pressure", 0.5],
  mass: ["mass", 0, "link.mass"],
  centre: ["length", 150, "link.centre"],
  inertia: ["inertia", 0.03, "joint.inertia"],
});
/** @typedef {keyof typeof TABLE} Key */
/** @typedef {Record<Key, number>} Values */
export const KEYS = /** @type {Key[]} */ (Object.keys(TABLE));
/** @param {Key} key */
export const kindOf = (key) => TABLE[key][0];
/** Where a joint file states it. @param {Key} key */
export const stateAt = (key) => TABLE[key][2] ?? "";
const usual = (/** @type {Key[]} */ keys) =>
  /** @type {Values} */ (Object.fromEntries(keys.map((key) => [key, TABLE[key][1]])));
/** Files of the address: of the joint, and of muscle 2 where it is another one. */
export const FILES = /** @type {const} */ (["joint", "file2"]);
/** What a joint file states too. */
export const IN_FILE = KEYS.filter((key) => TABLE[key].length > 2);
/** No words beside a joint file: it states them. */
export const ofFile = Object.fromEntries([...IN_FILE, "range"].map((key) => [key, undefined]));

export class JointWords {
  files = { joint: "", file2: "" };
  v = usual(KEYS);
  /** What was typed over the joint file. @type {Set<string>} */ over = new Set();

  /** @param {URLSearchParams} params */
  async read(params) {
    for (const key of FILES) this.files[key] = params.get(key) ?? "";
    this.over = new Set(KEYS.filter((key) => params.has(key)));
    Object.assign(this.v, usual(KEYS));
    await this.fromFile();
    // Both limits in one word, as links of before have them.
    if (params.has("range")) {
      await this.#limits(params.get("range"));
      this.over.add("low").add("high");
    }
    await this.#take(
      KEYS.filter((key) => params.has(key)).map((key) => [key, params.get(key) ?? ""]),
    );
  }

  /** Values that the joint file states. */
  async fromFile() {
    const own = IN_FILE.filter((key) => !this.over.has(key));
    Object.assign(this.v, usual(own));
    const of = stated(this.files.joint);
    await this.#limits(of.get("joint.range"));
    await this.#take(
      own.flatMap((key) => {
        const text = of.get(stateAt(key));
        return text ? [/** @type {[Key, string]} */ ([key, text])] : [];
      }),
    );
  }

  /** Both limits, where neither is typed. @param {string | null | undefined} text */
  async #limits(text) {
    if (!text || this.over.has("low") || this.over.has("high")) return;
    const [{ values = [], value }] = await understood([
      { text, kind: "angle", list: text.includes("..") },
    ]);
    const ends = value === undefined ? values : [-value, value];
    if (ends.length) [this.v.low, this.v.high] = [Math.min(...ends), Math.max(...ends)];
  }

  /** @param {[Key, string][]} texts */
  async #take(texts) {
    const readings = await understood(texts.map(([key, text]) => ({ text, kind: kindOf(key) })));
    texts.forEach(([key], i) => {
      const { value } = readings[i];
      if (value !== undefined) this.v[key] = value;
    });
  }

  /** A request for the joint with this muscle. @param {string} first file of muscle 1 */
  request(first) {
    const { files, over, v } = this;
    // One limit alone is no range.
    const ends = over.has("low") || over.has("high") ? [v.low, v.high] : [undefined, undefined];
    const own = (/** @type {Key} */ key) => (over.has(key) ? v[key] : undefined);
    const put = {
      ...Object.fromEntries(IN_FILE.map((key) => [key, own(key)])),
      low: ends[0],
      high: ends[1],
    };
    const arm = v.mass ? v : { ...v, mass: undefined, centre: undefined };
    return files.joint
      ? joint(first, files.file2, put, files.joint)
      : joint(first, files.file2, arm);
  }

  /**
   * Its words of the address; what a joint file states is not there twice.
   * @returns {Record<string, string>}
   */
  words() {
    const { files, over, v } = this;
    const said = KEYS.filter((key) => !files.joint || !IN_FILE.includes(key) || over.has(key));
    return {
      ...Object.fromEntries(said.map((key) => [key, typed(kindOf(key), v[key])])),
      ...files,
    };
  }
}

// A move of the joint at a stiffness: the pressures along it as commands of a drive, for the page
// Motion.
/** Points of the move that are computed, and steps of the commands between two of them. */
const POINTS = 20,
  BETWEEN = 3,
  STEPS = POINTS * BETWEEN;
/** So long the last pressures are held, in seconds. */
const HELD = 1;

/**
 * Angles of a move without a jerk at its ends: the position of least squared jerk, 10 τ³ − 15 τ⁴ +
 * 6 τ⁵ of the way at a share τ of the time [flash1985].
 * @param {number} from @param {number} to in degrees
 */
export const angles = (from, to) =>
  Array.from({ length: POINTS + 1 }, (_, i) => {
    const t = i / POINTS;
    return Number((from + (to - from) * t ** 3 * (10 - 15 * t + 6 * t * t)).toFixed(6));
  });

/**
 * A drive file whose pressures follow the points of `joint`, each held until the next.
 * @param {{ pressure_1_mpa: number, pressure_2_mpa?: number | null }[]} points at the angles of the
 * move
 * @param {number} seconds of the move @param {number} supply in MPa
 */
export function drive(points, seconds, supply) {
  const time = (/** @type {number} */ i) => `${Number(((seconds * i) / STEPS).toFixed(6))} s`;
  const between = (/** @type {number[]} */ list, /** @type {number} */ i) => {
    const k = Math.min(POINTS - 1, Math.floor(i / BETWEEN)),
      share = i / BETWEEN - k;
    return (1 - share) * list[k] + share * list[k + 1];
  };
  const steps = (/** @type {number[]} */ list) => {
    const bar = Array.from({ length: STEPS + 1 }, (_, i) =>
      Number((10 * between(list, i)).toPrecision(6)),
    );
    return `[${bar.map((p, i) => `["${time(i)}", "${p} bar"]`).join(", ")}]`;
  };
  const opposed = points.every((q) => typeof q.pressure_2_mpa === "number");
  return (
    `# A move of the joint: pressures along it, each held until the next.\n#:schema drive.schema.json\njoint = "joint.toml"\n\n` +
    `[supply]\npressure = "${supply} MPa"\n\n[valve]\nsonic_conductance = "0.5 L/(s bar)"\n\n[command]\n` +
    `${opposed ? "pressure_1" : "pressure"} = ${steps(points.map((q) => q.pressure_1_mpa))}\n` +
    (opposed ? `pressure_2 = ${steps(points.map((q) => Number(q.pressure_2_mpa)))}\n` : "") +
    `until = "${Number((seconds + HELD).toFixed(6))} s"\n`
  );
}
