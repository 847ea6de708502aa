// The border of what fits, on a grid of muscles: where the margin of the limit is zero between a muscle that fits and
// its neighbour that
// does not. Pure functions of numbers.

/**
 * A muscle of the grid. `margin`: of the pull, to spare; `limit` and `misses`: the limit that it misses, and by what
 * share.
 * @typedef {{ fits: boolean, value: number, margin: number, limit: string, misses: number }} Node
 * @typedef {{ x: number[], y: number[], nodes: Node[][] }} Grid rows of `nodes` by y
 * @typedef {[number, number, number, number]} Segment from a place to another one
 */

/** Limits whose margin a muscle that fits states too. */
const OF_PULL = ["force", "points", "contraction"];

/**
 * How far from a muscle that fits the border lies towards a neighbour that does not, as a share of their distance.
 * @param {Node} fits @param {Node} fails @param {Node | undefined} beyond the next one behind
 */
export function crossing(fits, fails, beyond) {
  const within = (/** @type {number} */ t) => Math.min(0.98, Math.max(0.02, t));
  // Both sides are known: between them.
  if (OF_PULL.includes(fails.limit) && fails.misses > 0) return within(fits.margin / (fits.margin + fails.misses));
  // Two on the far side are known: the line through them.
  if (beyond && !beyond.fits && beyond.limit === fails.limit && beyond.misses > fails.misses)
    return within(1 - fails.misses / (beyond.misses - fails.misses));
  return 0.5;
}

/** @param {Grid} grid @returns {Segment[]} */
export function border({ x, y, nodes }) {
  /** @type {Node} */
  const nothing = { fits: false, value: NaN, margin: 0, limit: "", misses: 0 };
  const node = (/** @type {number} */ i, /** @type {number} */ j) => nodes[j]?.[i] ?? nothing;
  // The map ends where its muscles do.
  const place = (/** @type {number[]} */ list, /** @type {number} */ i) =>
    list[Math.min(list.length - 1, Math.max(0, i))];
  /**
   * Where the border crosses an edge of a cell.
   * @param {number} i @param {number} j @param {number} di @param {number} dj
   */
  const edge = (i, j, di, dj) => {
    const [a, b] = [node(i, j), node(i + di, j + dj)];
    const t = a.fits ? crossing(a, b, node(i + 2 * di, j + 2 * dj)) : 1 - crossing(b, a, node(i - di, j - dj));
    const [x0, x1, y0, y1] = [place(x, i), place(x, i + di), place(y, j), place(y, j + dj)];
    return [x0 + t * (x1 - x0), y0 + t * (y1 - y0)];
  };
  const out = /** @type {Segment[]} */ ([]);
  for (let j = -1; j < y.length; j++) {
    for (let i = -1; i < x.length; i++) {
      const corners = [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)].map((n) => n.fits);
      /** Edges below, right, above, left. @type {(() => number[])[]} */
      const edges = [
        () => edge(i, j, 1, 0),
        () => edge(i + 1, j, 0, 1),
        () => edge(i, j + 1, 1, 0),
        () => edge(i, j, 0, 1),
      ];
      const cut = [0, 1, 2, 3].filter((k) => corners[k] !== corners[(k + 1) % 4]);
      // Of two opposite corners that fit, each has its own piece of the border.
      const pairs =
        cut.length === 4
          ? corners[0]
            ? [
                [0, 3],
                [1, 2],
              ]
            : [
                [0, 1],
                [2, 3],
              ]
          : cut.length === 2
            ? [cut]
            : [];
      for (const [a, b] of pairs) out.push(/** @type {Segment} */ ([...edges[a](), ...edges[b]()]));
    }
  }
  return out;
}

/**
 * Whether a place fits: a ray from it crosses the border an odd number of times.
 * @param {Segment[]} segments @param {number} x @param {number} y
 */
export function inside(segments, x, y) {
  let odd = false;
  for (const [x0, y0, x1, y1] of segments)
    if (y0 > y !== y1 > y && x < x0 + ((y - y0) * (x1 - x0)) / (y1 - y0)) odd = !odd;
  return odd;
}

/** Values of the nodes; those of neighbours without one by the line through the two before. @param {Grid} grid */
export function extended({ x, y, nodes }) {
  const values = nodes.map((row) => row.map((n) => (n.fits ? n.value : NaN)));
  const at = (/** @type {number[][]} */ from, /** @type {number} */ i, /** @type {number} */ j) => from[j]?.[i] ?? NaN;
  for (let ring = 0; ring < 2; ring++) {
    const before = values.map((row) => [...row]);
    for (let j = 0; j < y.length; j++) {
      for (let i = 0; i < x.length; i++) {
        if (Number.isFinite(before[j][i])) continue;
        const steps = [
          [1, 0],
          [-1, 0],
          [0, 1],
          [0, -1],
          [1, 1],
          [1, -1],
          [-1, 1],
          [-1, -1],
        ];
        const near = steps
          .map(([a, b]) => 2 * at(before, i + a, j + b) - at(before, i + 2 * a, j + 2 * b))
          .filter(Number.isFinite);
        const any = near.length ? near : steps.map(([a, b]) => at(before, i + a, j + b)).filter(Number.isFinite);
        if (any.length) values[j][i] = any.reduce((sum, v) => sum + v, 0) / any.length;
      }
    }
  }
  return values;
}

/**
 * The same on a finer grid: values inside of the border, the limit that is missed outside.
 * @param {Grid} grid @param {Segment[]} segments @param {number} by
 */
export function refined(grid, segments, by) {
  const { x, y, nodes } = grid, values = extended(grid);
  const finer = (/** @type {number[]} */ list) => Array.from({ length: (list.length - 1) * by + 1 }, (_, k) => {
    const i = Math.min(list.length - 2, Math.floor(k / by));
    return list[i] + ((list[i + 1] - list[i]) * (k - i * by)) / by;
  });
  const [fx, fy] = [finer(x), finer(y)];
  const cell = (/** @type {number} */ k, /** @type {number} */ most) => {
    const i = Math.min(most - 2, Math.floor(k / by));
    return { i, t: k / by - i };
  };
  const corners = (/** @type {number} */ i, /** @type {number} */ j) => [
    nodes[j][i],
    nodes[j][i + 1],
    nodes[j + 1][i],
    nodes[j + 1][i + 1],
  ];
  /**
   * Only cells that the border runs through have to be looked at place by place.
   * @param {Node[]} of @param {number} px @param {number} py
   */
  const there = (of, px, py) => of.every((n) => n.fits) || (of.some((n) => n.fits) && inside(segments, px, py + 1e-9));
  const value = fy.map((py, l) =>
    fx.map((px, k) => {
      const { i, t } = cell(k, x.length),
        { i: j, t: s } = cell(l, y.length);
      if (!there(corners(i, j), px, py)) return null;
      const v =
        (1 - s) * ((1 - t) * values[j][i] + t * values[j][i + 1]) +
        s * ((1 - t) * values[j + 1][i] + t * values[j + 1][i + 1]);
      return Number.isFinite(v) ? v : null;
    }),
  );
  const missed = fy.map((_, l) =>
    fx.map((__, k) => {
      const { i, t } = cell(k, x.length),
        { i: j, t: s } = cell(l, y.length),
        of = corners(i, j);
      const shares = [(1 - t) * (1 - s), t * (1 - s), (1 - t) * s, t * s],
        limits = of.filter((n) => !n.fits).map((n) => n.limit);
      const share = (/** @type {string} */ limit) =>
        of.reduce((sum, n, c) => sum + (!n.fits && n.limit === limit ? shares[c] : 0), 0);
      return limits.every((limit) => limit === limits[0])
        ? (limits[0] ?? null)
        : limits.reduce((a, b) => (share(b) > share(a) ? b : a));
    }),
  );
  return { x: fx, y: fy, value, missed };
}

/**
 * Lines of equal value on a grid with gaps.
 * @param {number[]} x @param {number[]} y @param {(number | null)[][]} values @param {number} level
 * @returns {Segment[]}
 */
export function levelLine(x, y, values, level) {
  const out = /** @type {Segment[]} */ ([]);
  for (let j = 0; j + 1 < y.length; j++) {
    for (let i = 0; i + 1 < x.length; i++) {
      const around = /** @type {[number, number][]} */ ([[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]]);
      const v = around.map(([a, b]) => values[b][a]);
      if (v.includes(null)) continue;
      const points = around.flatMap(([a, b], k) => {
        const [c, d] = around[(k + 1) % 4], [from, to] = [Number(v[k]), Number(v[(k + 1) % 4])];
        if (from > level === to > level) return [];
        const t = (level - from) / (to - from);
        return [[x[a] + t * (x[c] - x[a]), y[b] + t * (y[d] - y[b])]];
      });
      for (let k = 0; k + 1 < points.length; k += 2)
        out.push([points[k][0], points[k][1], points[k + 1][0], points[k + 1][1]]);
    }
  }
  return out;
}
