// The map of a design: what fits over diameter and wall, by `universal`: the pressure that each muscle needs, and the limit that others miss.
import { engine } from "./ask.js";
import { Chart, KINDS, token } from "./chart.js";
import { el } from "./dom.js";
import { muscle } from "./muscle.js";
import { outside, show, unitName } from "./units.js";

/** @param {(candidate: any, at: { p: number, e: number }) => string} linked the address of a muscle */
export function designMap(linked) {
  /** @type {any} */ let found;
  /** @type {any} */ let of;
  let mapping = new AbortController();
  const feasible = new Chart("design-map", { tools: el("h3", {}, "Feasible region over diameter and wall"), tall: true, drag(x, y, settled) { if (settled) pickOnMap(x, y); } });
  feasible.element.hidden = true;
  const picked = el("p", { class: "small", style: "min-height:1.5em" });

  /** Feasible muscles over diameter and wall, by `universal`: the pressure that each needs, and the limit that others miss. */
  async function map() {
    const best = found?.candidates[0] ?? found?.closest;
    // A joint is searched over its pulley too: there is no one map.
    feasible.element.hidden = !best || Boolean(of.torques);
    mapping.abort();
    if (feasible.element.hidden) return;
    const { signal } = (mapping = new AbortController());
    const { figure, tolerance, ...rest } = of;
    const span = (/** @type {number} */ mid, /** @type {number} */ low, /** @type {number} */ high, /** @type {number} */ n) => Array.from({ length: n }, (_, i) => Number((low * mid + ((high - low) * mid * i) / (n - 1)).toPrecision(4)));
    // Within the sleeve, where there is one.
    const range = muscle.sleeves.find((s) => s.name === best.sleeve);
    const [least, most] = [range?.least_diameter_mm ?? 0, range?.largest_diameter_mm ?? Infinity].map((d) => d / best.outer_diameter_mm);
    const D = span(best.outer_diameter_mm, Math.max(0.5, least), Math.min(1.9, most), 29), S = span(Math.max(best.wall_mm, 1.5), 0.2, 2.6, 25);
    // With a named sleeve the diameter sets the angle; parts are varied as if any size of them were sold.
    const part = best.sleeve && !of.braids?.length ? { rubbers: best.rubber ? [best.rubber] : undefined, braids: [best.sleeve] } : {};
    const fixed = { length_mm: of.stroke_mm ? undefined : best.length_mm, ...(of.braids?.length || best.sleeve ? {} : { angle_deg: best.angle_deg }), ...part };
    const answer = await engine().ask("design", { ...rest, ...fixed, outer_diameter_mm: D, wall_mm: S, model: "universal", verify: "none", extrapolate: true, top: D.length * S.length }, { signal });
    const at = new Map(answer.candidates.map((/** @type {any} */ c) => [`${c.outer_diameter_mm},${c.wall_mm}`, c]));
    const not = new Map((answer.rejected ?? []).map((/** @type {any} */ c) => [`${c.outer_diameter_mm},${c.wall_mm}`, c]));
    const limits = [...new Set([...not.values()].map((c) => c.limit ?? "no answer"))];
    const pressures = S.map((s) => D.map((d) => { const c = at.get(`${d},${s}`); return c ? outside("pressure", c.pressure_mpa) : null; }));
    const missed = S.map((s) => D.map((d) => { const c = not.get(`${d},${s}`); return c ? limits.indexOf(c.limit ?? "no answer") : null; }));
    const tints = limits.map((_, i) => /** @type {[number, string]} */ ([limits.length > 1 ? i / (limits.length - 1) : 0, KINDS[(i + 1) % KINDS.length]]));
    const [x, y] = [D.map((d) => outside("length", d)), S.map((s) => outside("length", s))];
    const names = missed.map((row) => row.map((i) => (i === null ? "" : String(limits[i]).replaceAll("_", " "))));
    const ramp = [[0, "rgb(33,144,141)"], [0.5, "rgb(92,200,99)"], [1, "rgb(253,231,37)"]];
    feasible.element.hidden = false;
    feasible.show({
      x: `outer diameter D0 [${unitName("length")}]`, y: `wall s [${unitName("length")}]`, z: `required pressure [${unitName("pressure")}], or missed limit`, yaxis: {}, series: [],
      data: [
        { type: "heatmap", name: "misses", x, y, z: missed, text: names, hovertemplate: "%{x}, %{y}: misses %{text}<extra></extra>", colorscale: tints.length > 1 ? tints : [[0, KINDS[1]], [1, KINDS[1]]], zmin: 0, zmax: Math.max(1, limits.length - 1), showscale: false, opacity: 0.35 },
        { type: "contour", name: "needs", x, y, z: pressures, colorscale: ramp, contours: { showlabels: true, labelfont: { color: "#000" } }, line: { width: 1, color: "#333" }, colorbar: { title: { text: `P [${unitName("pressure")}]` }, tickfont: { color: token("--ink") } }, hovertemplate: `%{x}, %{y}: requires %{z:.3g} ${unitName("pressure")}<extra></extra>`, connectgaps: false },
      ],
      marks: [{ x: outside("length", best.outer_diameter_mm), y: outside("length", best.wall_mm), text: "best" }],
      layout: { annotations: limits.map((limit, i) => place(limit, missed, i, x, y)).filter(Boolean) },
    });
  }

  /** The name of a limit in the middle of the cells that miss it. @param {string} limit @param {(number | null)[][]} cells @param {number} which @param {number[]} x @param {number[]} y */
  function place(limit, cells, which, x, y) {
    const hit = cells.flatMap((row, j) => row.flatMap((v, i) => (v === which ? [[i, j]] : [])));
    if (hit.length < 8) return null;
    const middle = (/** @type {number} */ k) => hit.reduce((sum, c) => sum + c[k], 0) / hit.length;
    const [ci, cj] = [middle(0), middle(1)];
    const near = hit.reduce((a, b) => (Math.hypot(b[0] - ci, b[1] - cj) < Math.hypot(a[0] - ci, a[1] - cj) ? b : a));
    return { x: x[near[0]], y: y[near[1]], text: `misses ${limit.replaceAll("_", " ")}`, showarrow: false, font: { color: token("--ink"), size: 13 }, bgcolor: token("--paper"), opacity: 0.85 };
  }

  /** @param {number} x @param {number} y */
  function pickOnMap(x, y) {
    const best = found?.candidates[0] ?? found?.closest;
    if (!best) return;
    const scale = outside("length", 1);
    const [d, s] = [Number((x / scale).toPrecision(3)), Number((y / scale).toPrecision(2))];
    const link = linked({ ...best, outer_diameter_mm: d, wall_mm: s }, { p: found.max_pressure_mpa, e: best.points?.[0]?.contraction ?? 0.1 });
    picked.replaceChildren(`D0 ${show("length", d)}, s ${show("length", s)}: `, el("a", { href: link }, "see this muscle"));
  }

  return {
    elements: [picked, feasible.element],
    /** @param {any} answer of the search @param {any} request that it was asked by */
    show(answer, request) {
      [found, of] = [answer, request];
      map().catch((problem) => { if (problem.name !== "AbortError") feasible.element.hidden = true; });
    },
    end() { mapping.abort(); },
  };
}
