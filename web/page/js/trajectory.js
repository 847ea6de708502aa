// A move of the joint at a stiffness: the pressures along it as commands of a drive, for the page Motion.

/** Points of the move that are computed, and steps of the commands between two of them. */
const POINTS = 20,
  BETWEEN = 3,
  STEPS = POINTS * BETWEEN;
/** So long the last pressures are held, in seconds. */
const HELD = 1;

/**
 * Angles of a move without a jerk at its ends: the position of least squared jerk, 10 τ³ − 15 τ⁴ + 6 τ⁵ of the way at
 * a share τ of the time [flash1985].
 * @param {number} from @param {number} to in degrees
 */
export const angles = (from, to) =>
  Array.from({ length: POINTS + 1 }, (_, i) => {
    const t = i / POINTS;
    return Number(
      (from + (to - from) * t ** 3 * (10 - 15 * t + 6 * t * t)).toFixed(6),
    );
  });

/**
 * A drive file whose pressures follow the points of `joint`, each held until the next.
 * @param {{ pressure_1_mpa: number, pressure_2_mpa?: number | null }[]} points at the angles of the move
 * @param {number} seconds of the move @param {number} supply in MPa
 */
export function drive(points, seconds, supply) {
  const time = (/** @type {number} */ i) =>
    `${Number(((seconds * i) / STEPS).toFixed(6))} s`;
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
    (opposed
      ? `pressure_2 = ${steps(points.map((q) => Number(q.pressure_2_mpa)))}\n`
      : "") +
    `until = "${Number((seconds + HELD).toFixed(6))} s"\n`
  );
}
