// Families of curves of the page Muscle: what is asked for them, and their answers as series.
import { KINDS, builtAt, isobar, isobars, shade, withBuilt } from "../chart.js";
import { muscle } from "../muscle.js";
import { evenly, inside, niceUp, outside, show, unitName } from "../units.js";

/** @typedef {CurveAnswer["points"][number]} Point */
/** Which way a muscle moves, behind a name. @type {Record<string, string>} */
export const MOVES = { contraction: " while it shortens", elongation: " while it lengthens" };
/** Points of a curve of the family, and of that of the state. */
const FAMILY = 13,
  FINE = 21;
/** Closer where curves bend: at the beginning. @param {number} count @param {number} end */
const steps = (count, end) => evenly(0, 1, count).map((t) => end * t * (0.4 + 0.6 * t));

/** Contractions up to a little beyond the free one. @param {Store} store @param {number} count */
export function reachOf(store, count) {
  const end = Math.max(0.1, (store.facts.value.characteristics?.free_contraction ?? 0.28) * 1.08);
  return steps(count, end).map((e) => Math.round(1e4 * e) / 1e4);
}

/**
 * Five pressures up to a round one above the state's, or those of the measured points.
 * @param {Store} store @param {number[]} measured
 */
export function familyOf(store, measured) {
  const { test } = store.wanted.value,
    contractions = reachOf(store, FAMILY);
  const shown = outside("pressure", Math.max(muscle.p, 0.02)),
    step = niceUp(shown / 5);
  const count = Math.ceil(shown / step - 1e-9),
    round = (/** @type {number} */ i) => Number((i * step).toPrecision(12));
  const pressures = Array.from({ length: count }, (_, i) => inside("pressure", round(i + 1)));
  const top = inside("pressure", count * step),
    over = steps(FAMILY, top);
  if (test === "isobaric") {
    const list = measured.length ? measured : pressures,
      allowed = allowedOf(store);
    return {
      top: Math.max(top, ...measured),
      request: { pressures_mpa: allowed < 1.5 * top ? [...list, allowed] : list, contractions },
    };
  }
  if (test === "isometric")
    return { top, request: { contractions: [0, 0.05, 0.1, 0.15, 0.2], pressures_mpa: over } };
  const blocked = store.facts.value.characteristics?.blocked_force_n ?? 500;
  const forces = [0.1, 0.3, 0.5, 0.7].map((x) => Math.max(1, Number((x * blocked).toPrecision(2))));
  return { top, request: { forces_n: forces, pressures_mpa: over.slice(1) } };
}

/** The pressure that the muscle may have. @param {Store} store */
export const allowedOf = ({ facts }) =>
  facts.value.characteristics?.allowed_pressure_mpa ?? Infinity;

/**
 * What is permitted: up to the allowed pressure, and to the stretch that the law was fitted to.
 * @param {CurveAnswer} answer @param {number} allowed in MPa @param {number | null} [most] stretch
 * @returns {Series[]}
 */
export function permitted({ fixed, points }, allowed, most) {
  const count = points.length / fixed.length,
    i = fixed.indexOf(allowed);
  const list = points
    .slice(i * count, (i + 1) * count)
    .filter((q) => "force_n" in q && Number(q.max_stretch) <= (most ?? Infinity));
  if (i < 0 || !list.length) return [];
  const { x, y } = isobar(list);
  return [
    {
      name: "",
      legend: "permitted",
      band: true,
      colour: "#009E73",
      x: [0, ...x, x[x.length - 1]],
      y: [0, ...y, 0],
    },
  ];
}

/** The curve through the present state. @param {Store} store @param {number} top */
export function ownOf(store, top) {
  const { test } = store.wanted.value,
    over = steps(FINE, top);
  if (test === "isobaric") return { pressures_mpa: [muscle.p], contractions: reachOf(store, FINE) };
  if (test === "isometric") return { contractions: [muscle.e], pressures_mpa: over };
  return {
    forces_n: [Math.max(1e-3, store.point.value?.force_n ?? muscle.state.F ?? 1)],
    pressures_mpa: over.slice(1),
  };
}

/** @param {number} fixed @param {string} test */
const named = (fixed, test) =>
  show(test === "isobaric" ? "pressure" : test === "isotonic" ? "force" : "ratio", fixed, 3);

/** Points of one curve as a series. @param {Point[]} list @param {string} test */
function line(list, test) {
  if (test === "isobaric") return isobar(list);
  const ok = (/** @type {Point} */ q) => q.status === "ok";
  const x = list.map((q) => outside("pressure", q.pressure_mpa));
  const y = list.map((q) =>
    test === "isotonic"
      ? ok(q)
        ? 100 * Number(q.contraction)
        : null
      : "force_n" in q
        ? outside("force", q.force_n)
        : null,
  );
  return { x, y };
}

/** The same of its contraction in %. @param {Point | Commands["contraction"]["answer"]} q */
const builtContraction = (q) =>
  "force_n" in q && typeof q.predicted === "number"
    ? [q.predicted, q.predicted_low, q.predicted_high].map((e) => 100 * Number(e))
    : [];

/**
 * @param {CurveAnswer} answer @param {string} test @param {number} top
 * @param {CurveAnswer | undefined} own a curve that is drawn besides
 * @param {number} most the border of what is permitted, no curve
 */
export function familySeries(answer, test, top, own, most) {
  const count = answer.points.length / answer.fixed.length;
  return answer.fixed.flatMap((fixed, i) => {
    if (
      (own && Math.abs(own.fixed[0] - fixed) < 1e-9) ||
      (fixed === most && i === answer.fixed.length - 1)
    )
      return [];
    const name = named(fixed, test),
      colour = shade(test === "isobaric" ? fixed / top : i / answer.fixed.length);
    return [
      /** @type {Series} */ ({
        name,
        end: name,
        at: test === "isobaric" ? "start" : "end",
        colour,
        smooth: true,
        ...line(answer.points.slice(i * count, (i + 1) * count), test),
      }),
    ];
  });
}

/**
 * The curve of the state; both branches of its loop, where the friction is known.
 * @param {CurveAnswer} answer @param {string} test @param {number} top
 */
export function ownSeries(answer, test, top) {
  const name = named(answer.fixed[0], test),
    colour = test === "isobaric" ? shade(answer.fixed[0] / top) : "#0072B2";
  const of = (/** @type {Point} */ q) => ("force_n" in q ? q.direction : undefined);
  const branches = [...new Set(answer.points.map(of))];
  return branches.flatMap((branch, i) => {
    const list = answer.points.filter((q) => of(q) === branch);
    const label = i
      ? {}
      : { end: name, at: /** @type {"start" | "end"} */ (test === "isobaric" ? "start" : "end") };
    const model = /** @type {Series} */ ({
      name: name + (MOVES[branch ?? ""] ?? ""),
      ...label,
      colour,
      strong: true,
      smooth: true,
      dash: branch === "elongation" ? "dot" : "solid",
    });
    if (test === "isobaric") return isobars(model, list);
    const curve = line(list, test);
    const built = test === "isotonic" ? builtContraction : builtAt;
    return withBuilt({ ...model, ...curve }, curve.x, list.map(built));
  });
}

// Radii and strand angle along the muscle.
/** @param {NonNullable<Store["shape"]["value"]>} shape @returns {Spec} */
export function along({ arrays, stations, across }) {
  /**
   * Of the half muscle, that of the whole. @param {(j: number) => number} at @param {number} sign
   */
  const mirror = (at, sign) => {
    const half = Array.from({ length: stations }, (_, j) => at(j));
    return [
      ...half
        .slice(1)
        .reverse()
        .map((x) => sign * x),
      ...half,
    ];
  };
  const radius = (/** @type {number} */ i) =>
    mirror((j) => outside("length", arrays.r_mm[j * across + i]), 1);
  const x = mirror((j) => outside("length", arrays.z_mm[j * across + across - 1]), -1),
    unit = unitName("length");
  return {
    x: `z from the middle [${unit}]`,
    y: `radius [${unit}], strand angle [°]`,
    series: [
      { name: "outer radius", end: "outer", x, y: radius(across - 1), colour: KINDS[0] },
      { name: "inner radius", end: "inner", x, y: radius(0), colour: KINDS[4] },
      {
        name: "strand angle",
        end: "angle",
        x,
        y: mirror((j) => arrays.strand_angle_deg[j], 1),
        colour: KINDS[1],
        dash: "dot",
      },
    ],
  };
}
