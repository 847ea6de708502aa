// The map of a design: what fits over diameter and wall, by `universal`: the pressure that each
// muscle needs, and the limit that others miss.
import { Slot } from "./ask.js";
import { OF_PULL, border, extended, inside } from "./border.js";
import { chartOf, KINDS, viridisAt } from "./chart.js";
import { el, heading } from "./dom.js";
import { corners, levels, picture, pieces, sampled, span, valueBetween, whole } from "./map.js";
import { muscle } from "./muscle.js";
import { token } from "./theme.js";
import { evenly, outside, showLength, showPressure, unitName } from "./units.js";

/**
 * @typedef {Candidate | NonNullable<Design["answer"]["closest"]>} Best
 * @typedef {{ D: number[], S: number[], fits: Map<string, Candidate>, nodes: GridNode[][],
 *   limits: string[] }} Found
 */
/** Diameters and walls; the picture is finer than they are. */
const WHOLE = { across: 29, up: 25, finer: 8 };
/** The same while the target is dragged. */
const LIVE = { across: 15, up: 13, finer: 6 };

/**
 * @param {(candidate: Chosen, at: { p: number, e: number }) => string} linked the address of a
 * muscle
 */
export function designMap(linked) {
  /** @type {Design["answer"] | undefined} */ let answer;
  /** @type {Design["request"]} */ let of = {};
  /** @type {Found | undefined} */ let found;
  let { finer } = WHOLE;
  const slot = new Slot();
  const tools = heading("Feasible region (first estimate: universal, less the losses as built)");
  const feasible = chartOf("design-map", {
    tools,
    tall: true,
    drag: (x, y, settled) => settled && pick(x, y),
  });
  feasible.element.hidden = true;
  const picked = el("p", { class: "small", style: "min-height:1.5em" });
  const best = () => answer?.candidates[0] ?? answer?.closest ?? undefined;

  /**
   * @param {Best} middle @param {typeof WHOLE} size
   * @param {{ force_n: number, contraction: number }} [target] @param {() => void} [fail]
   */
  function find(middle, size, target, fail) {
    const request = asked(of, middle, size, target);
    slot.ask(
      "design",
      request,
      (next) => {
        ({ finer } = size);
        found = read(request, next);
        feasible.element.hidden = false;
        draw();
      },
      fail,
    );
  }

  function draw() {
    const middle = best();
    if (found && middle) feasible.show(spec(found, middle, finer));
  }

  /** @param {number} x @param {number} y */
  function pick(x, y) {
    const middle = best(),
      [d, s] = measures(x, y);
    if (!middle || !answer) return;
    const e = "points" in middle ? Number(middle.points[0]?.contraction ?? 0.1) : 0.1;
    const link = linked(
      { ...middle, outer_diameter_mm: d, wall_mm: s },
      { p: Number(answer.max_pressure_mpa), e },
    );
    picked.replaceChildren(
      `D0 ${showLength(d)}, s ${showLength(s)}: `,
      el("a", { href: link }, "see this muscle"),
    );
  }

  return {
    elements: [picked, feasible.element],
    draw,
    /**
     * @param {Design["answer"]} next answer of the search
     * @param {Design["request"]} request that it was asked by
     */
    show(next, request) {
      [answer, of] = [next, request];
      const middle = best(),
        hide = () => {
          feasible.element.hidden = true;
        };
      // A joint is searched over its pulley too: there is no one map.
      if (!middle || of.torques) {
        slot.end();
        return hide();
      }
      find(middle, WHOLE, undefined, hide);
    },
    /**
     * The map of another target, while it is dragged.
     * @param {{ force_n: number, contraction: number }} target
     */
    preview(target) {
      const middle = best();
      if (middle && !feasible.element.hidden) find(middle, LIVE, target);
    },
  };
}

/** Diameter and wall in mm, rounded. @param {number} x @param {number} y in the shown unit */
function measures(x, y) {
  const scale = outside("length", 1);
  return [Number((x / scale).toPrecision(3)), Number((y / scale).toPrecision(2))];
}

/** The nearest of a list. @param {number[]} list @param {number} v */
const nearest = (list, v) => list.reduce((a, b) => (Math.abs(b - v) < Math.abs(a - v) ? b : a));

/**
 * The muscles of the map.
 * @param {Design["request"]} of the request of the search
 * @param {Best} best its winner, or what came closest
 * @param {typeof WHOLE} size @param {{ force_n: number, contraction: number }} [target]
 * @returns {Design["request"] & { outer_diameter_mm: number[], wall_mm: number[] }}
 */
function asked(of, best, { across, up }, target) {
  const { force_n, contraction, load, stroke_mm, guaranteed, points, ...rest } = of,
    share = target && force_n ? target.force_n / force_n : 1;
  // A model alone must pull what the best muscle pulls by its model; that is less as built.
  const wanted =
    "points" in best
      ? {
          points: best.points.map((p) => ({
            contraction: p.contraction,
            ...target,
            force_n: share * (p.model_force_n ?? p.force_n),
          })),
        }
      : { force_n, contraction, load, stroke_mm, points, ...target };
  const list = (/** @type {number} */ low, /** @type {number} */ high, /** @type {number} */ n) =>
    evenly(low, high, n).map((v) => Number(v.toPrecision(4)));
  // Within the sleeve, where there is one.
  const range = muscle.sleeves.find((s) => s.name === best.sleeve),
    middle = best.outer_diameter_mm;
  const wall = Math.max(best.wall_mm, 1.5),
    S = list(0.2 * wall, 2.6 * wall, up);
  const D = list(
    Math.max(0.5 * middle, range?.least_diameter_mm ?? 0),
    Math.min(1.9 * middle, range?.largest_diameter_mm ?? Infinity),
    across,
  );
  // With a named sleeve the diameter sets the angle; parts are varied as if any size of them were
  // sold.
  const part =
    best.sleeve && !of.braids?.length
      ? { rubbers: best.rubber ? [best.rubber] : undefined, braids: [best.sleeve] }
      : {};
  const angle = of.braids?.length || best.sleeve ? {} : { angle_deg: best.angle_deg };
  return {
    ...rest,
    ...wanted,
    length_mm: best.length_mm,
    ...angle,
    ...part,
    outer_diameter_mm: D,
    wall_mm: S,
    model: { name: "universal" },
    extrapolate: true,
    top: D.length * S.length,
  };
}

/**
 * @param {{ outer_diameter_mm: number[], wall_mm: number[] }} request
 * @param {Design["answer"]} answer @returns {Found}
 */
export function read({ outer_diameter_mm: D, wall_mm: S }, answer) {
  const key = (/** @type {{ outer_diameter_mm: number, wall_mm: number }} */ c) =>
    `${c.outer_diameter_mm},${c.wall_mm}`;
  const fits = new Map(answer.candidates.map((c) => [key(c), c])),
    not = new Map((answer.rejected ?? []).map((c) => [key(c), c]));
  const nodes = S.map((s) =>
    D.map((d) => {
      const yes = fits.get(`${d},${s}`),
        no = not.get(`${d},${s}`);
      return {
        fits: Boolean(yes),
        value: yes?.pressure_mpa ?? NaN,
        margin: Number(yes?.margin ?? 0),
        limit: no?.limit ?? "no answer",
        misses: Number(no?.misses_by ?? 0),
      };
    }),
  );
  const limits = [
    ...new Set(
      nodes
        .flat()
        .filter((n) => !n.fits)
        .map((n) => n.limit),
    ),
  ];
  return { D, S, fits, nodes, limits };
}

/** What a limit that is missed means. @param {string} limit */
const words = (limit) =>
  OF_PULL.includes(limit) ? "pull too low" : `not met: ${limit.replaceAll("_", " ")}`;
const rgb = (/** @type {string} */ hex) =>
  [1, 3, 5].map((i) => Number.parseInt(hex.slice(i, i + 2), 16));

/**
 * @param {Found} found @param {{ outer_diameter_mm: number, wall_mm: number }} best
 * @param {number} finer how much finer the picture is than the muscles @returns {Spec}
 */
function spec({ D, S, fits, nodes, limits }, best, finer) {
  const [x, y] = [D.map((d) => outside("length", d)), S.map((s) => outside("length", s))];
  const shown = nodes.map((row) =>
    row.map((n) => ({ ...n, value: n.fits ? outside("pressure", n.value) : NaN })),
  );
  const edge = border({ x, y, nodes: shown }),
    grid = { x, y, values: extended({ x, y, nodes: shown }) };
  const field = sampled(x, y, finer, (px, py) =>
    inside(edge, px, py + 1e-9) ? valueBetween(grid, px, py) : null,
  );
  const [low, high] = span(field.values),
    tints = limits.map((_, i) => rgb(KINDS[(i + 1) % KINDS.length]));
  /**
   * The limit that most of the cell around a place misses. @param {number} px @param {number} py
   */
  const missed = (px, py) => {
    const shares = limits.map(() => 0);
    for (const [i, j, share] of corners(x, y, px, py))
      if (!nodes[j][i].fits) shares[limits.indexOf(nodes[j][i].limit)] += share + 1e-9;
    return shares.indexOf(Math.max(...shares));
  };
  const image = picture(field, (value, px, py) => {
    if (value === null) return limits.length ? [...tints[missed(px, py)], 90] : [0, 0, 0, 0];
    return [...viridisAt(0.5 + (0.5 * (value - low)) / (high - low || 1), 1), 255];
  });
  const { series, notes } = levels(field, unitName("pressure"));
  const [misses, needs] = [true, false].map((out) =>
    y.flatMap((v, j) =>
      x.flatMap((u, i) => {
        const n = shown[j][i];
        return n.fits === out
          ? []
          : [[out ? "misses" : "needs", u, v, out ? words(n.limit) : n.value]];
      }),
    ),
  );
  return {
    x: `outer diameter D0 [${unitName("length")}]`,
    y: `wall s [${unitName("length")}]`,
    z: `required pressure [${unitName("pressure")}], or missed limit`,
    xaxis: whole(x),
    yaxis: whole(y),
    series: [...series, pieces(edge, { colour: token("--ink"), width: 2.5 })],
    picture: image,
    rows: [...misses, ...needs],
    marks: [
      {
        x: outside("length", best.outer_diameter_mm),
        y: outside("length", best.wall_mm),
        text: "best",
      },
    ],
    notes: [...notes, ...limits.flatMap((limit) => place(limit, nodes, x, y))],
    says(px, py) {
      const [d, s] = measures(px, py),
        one = fits.get(`${nearest(D, d)},${nearest(S, s)}`);
      return one
        ? `D0 ${showLength(one.outer_diameter_mm, 3)}, s ${showLength(one.wall_mm, 2)}: ` +
            `set ${showPressure(one.pressure_mpa, 3)}, ${showLength(one.bulged_diameter_mm, 3)} wide in use`
        : "";
    },
  };
}

/**
 * The name of a limit in the middle of the muscles that miss it.
 * @param {string} limit @param {GridNode[][]} nodes @param {number[]} x @param {number[]} y
 */
function place(limit, nodes, x, y) {
  const hit = nodes.flatMap((row, j) =>
    row.flatMap((n, i) => (!n.fits && n.limit === limit ? [[i, j]] : [])),
  );
  if (hit.length < 8) return [];
  const middle = (/** @type {number} */ k) => hit.reduce((sum, c) => sum + c[k], 0) / hit.length;
  const [ci, cj] = [middle(0), middle(1)],
    far = (/** @type {number[]} */ [i, j]) => Math.hypot(i - ci, j - cj);
  const near = hit.reduce((a, b) => (far(b) < far(a) ? b : a));
  return [{ x: x[near[0]], y: y[near[1]], text: words(limit) }];
}
