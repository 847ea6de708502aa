// The border of what fits, on a grid of muscles: where the margin of the limit is zero between a
// muscle that fits and its neighbour that does not. Pure functions of numbers.

/** Limits whose margin a muscle that fits states too. */
export const OF_PULL = ["force", "points", "contraction"];

/**
 * How far from a muscle that fits the border lies towards a neighbour that does not, as a share of
 * their distance.
 * @param {GridNode} fits @param {GridNode} fails
 * @param {GridNode | undefined} beyond the next one behind
 */
function crossing(fits, fails, beyond) {
  const within = (/** @type {number} */ t) => Math.min(0.98, Math.max(0.02, t));
  // Both sides are known: between them.
  if (OF_PULL.includes(fails.limit) && fails.misses > 0)
    return within(fits.margin / (fits.margin + fails.misses));
  // Two on the far side are known: the line through them.
  if (beyond && !beyond.fits && beyond.limit === fails.limit && beyond.misses > fails.misses)
    return within(1 - fails.misses / (beyond.misses - fails.misses));
  return 0.5;
}

/** @param {{ x: number[], y: number[], nodes: GridNode[][] }} grid @returns {Segment[]} */
export function border({ x, y, nodes }) {
  /** @type {GridNode} */
  const nothing = { fits: false, value: NaN, margin: 0, limit: "", misses: 0 };
  const node = (/** @type {number} */ i, /** @type {number} */ j) => nodes[j]?.[i] ?? nothing;
  // The map ends where its muscles do.
  const place = (/** @type {number[]} */ list, /** @type {number} */ i) =>
    list[Math.min(list.length - 1, Math.max(0, i))];
  /**
   * Where the border crosses an edge of a cell. @param {number[]} edge its beginning, and its way
   */
  const cross = ([i, j, di, dj]) => {
    const [a, b] = [node(i, j), node(i + di, j + dj)];
    const t = a.fits
      ? crossing(a, b, node(i + 2 * di, j + 2 * dj))
      : 1 - crossing(b, a, node(i - di, j - dj));
    const [x0, x1, y0, y1] = [place(x, i), place(x, i + di), place(y, j), place(y, j + dj)];
    return [x0 + t * (x1 - x0), y0 + t * (y1 - y0)];
  };
  const out = /** @type {Segment[]} */ ([]);
  for (let j = -1; j < y.length; j++) {
    for (let i = -1; i < x.length; i++) {
      const corners = [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)].map(
        (n) => n.fits,
      );
      // Edges below, right, above, left.
      const edges = [
        [i, j, 1, 0],
        [i + 1, j, 0, 1],
        [i, j + 1, 1, 0],
        [i, j, 0, 1],
      ];
      const cut = [0, 1, 2, 3].filter((k) => corners[k] !== corners[(k + 1) % 4]);
      // Of two opposite corners that fit, each has its own piece of the border.
      const pairs =
        cut.length < 4
          ? [cut]
          : corners[0]
            ? [
                [0, 3],
                [1, 2],
              ]
            : [
                [0, 1],
                [2, 3],
              ];
      for (const [a, b] of pairs)
        if (a !== undefined)
          out.push(/** @type {Segment} */ ([...cross(edges[a]), ...cross(edges[b])]));
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

/**
 * Values of the nodes; those of neighbours without one by the line through the two before.
 * @param {{ x: number[], y: number[], nodes: GridNode[][] }} grid
 */
export function extended({ x, y, nodes }) {
  const values = nodes.map((row) => row.map((n) => (n.fits ? n.value : NaN)));
  const ways = [-1, 0, 1].flatMap((a) => [-1, 0, 1].map((b) => [a, b])).filter(([a, b]) => a || b);
  for (let ring = 0; ring < 2; ring++) {
    const before = values.map((row) => [...row]);
    const at = (/** @type {number} */ i, /** @type {number} */ j) => before[j]?.[i] ?? NaN;
    for (let j = 0; j < y.length; j++) {
      for (let i = 0; i < x.length; i++) {
        if (Number.isFinite(before[j][i])) continue;
        const near = ways
          .map(([a, b]) => 2 * at(i + a, j + b) - at(i + 2 * a, j + 2 * b))
          .filter(Number.isFinite);
        const any = near.length
          ? near
          : ways.map(([a, b]) => at(i + a, j + b)).filter(Number.isFinite);
        if (any.length) values[j][i] = any.reduce((sum, v) => sum + v, 0) / any.length;
      }
    }
  }
  return values;
}
