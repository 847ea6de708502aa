// Curves on the page: crosshair, zoom, and drags in values of the axes. The drawing itself is in
// plot.js.
import { block, button, el, say } from "./dom.js";
import { token } from "./theme.js";
import { colourOf, drawing, frame, nearest, reachOf, smoothed, valueAt } from "./plot.js";
import { between, clamp, number } from "./units.js";

/** Farther away than this in pixels nothing is read off. */
const NEAR = 48;
const colours = () => ({
  ink: token("--ink"),
  line: token("--line"),
  faint: token("--faint"),
  paper: token("--paper"),
});
/** The unit of an axis. @param {string} title */
const unit = (title) => {
  const [, u] = /\[(.+)\]/.exec(title) ?? [];
  return u ? ` ${u}` : "";
};

/** @typedef {{ px: number, py: number, what: "drag" | "x" | "y" | "box" }} From */
/**
 * The plot of a chart.
 * @param {string} name
 * @param {((x: number, y: number, settled: boolean) => unknown) | undefined} drag
 */
export function linesOf(name, drag) {
  /** @type {Spec | undefined} */ let spec;
  /** @type {import("./plot.js").Frame | undefined} */ let at;
  /** @type {Reach | undefined} */ let zoomed;
  /** What the keyboard reads: curve and point. @type {[number, number] | undefined} */ let read;
  /** Where the pointer rests on the plot. @type {number[] | undefined} */ let pointer;
  /** Where the ring is, in values of the axes. @type {[number, number] | undefined} */ let marked;
  /** Where a drag began. @type {From | undefined} */ let from;
  const drawn = block(),
    [ring, dot, hair, box] = ["ring", "dot", "hair", "box"].map((kind) =>
      el("i", { class: kind, hidden: true }),
    ),
    tip = el("div", { class: "tip small", hidden: true });
  const all = button("Show all", () => zoom(undefined), { class: "all small", hidden: true });
  const host = el(
    "div",
    {
      class: "plot",
      tabindex: 0,
      role: "group",
      ariaLabel: `${name.replaceAll("-", " ")}: arrow keys read its points, + and − zoom, 0 shows all`,
      style: "touch-action:pan-y",
      onpointerdown: down,
      onpointermove: moved,
      onpointerup: up,
      onpointercancel() {
        from = undefined;
        clear();
      },
      onpointerleave() {
        pointer = undefined;
        if (!from) clear();
      },
      onblur: clear,
      ondblclick: () => zoom(undefined),
      onkeydown(/** @type {KeyboardEvent} */ event) {
        if (event.target === host && pressed(event.key)) event.preventDefault();
      },
      onwheel(/** @type {WheelEvent} */ event) {
        if (!event.ctrlKey && !event.metaKey) return;
        event.preventDefault();
        const [px, py] = where(event);
        zoomAbout(Math.exp(0.002 * event.deltaY), px, py);
      },
    },
    drawn,
    hair,
    box,
    dot,
    tip,
    all,
    ring,
  );

  function draw() {
    const { clientWidth: width, clientHeight: height } = host;
    if (!spec || !width || !height) return;
    at = frame(spec, width, height, zoomed ?? reachOf(spec));
    drawn.innerHTML = drawing(spec, at, colours());
    all.hidden = !zoomed;
    placeMark();
    // What is below the pointer is read off anew.
    if (pointer) hover(pointer[0], pointer[1]);
    else if (!tip.hidden) clear();
  }

  /** At the edge of the plot where its values lie beyond. */
  function placeMark() {
    ring.hidden = !at || !marked;
    if (!at || !marked) return;
    const x = clamp(at.px(marked[0]), at.left, at.left + at.w),
      y = clamp(at.py(marked[1]), at.top, at.top + at.h);
    ring.style.transform = `translate(${x}px, ${y}px)`;
  }

  /** @param {Reach | undefined} reach nothing for all */
  function zoom(reach) {
    zoomed = reach;
    draw();
  }

  /** About a place, of both axes or of the one whose numbers it is at. @param {number} by @param {number} [px] @param {number} [py] */
  function zoomAbout(by, px, py) {
    if (!at) return;
    const { left, top, w, h, reach } = at,
      about = (/** @type {[number, number]} */ ends, /** @type {number} */ c, on = true) =>
        /** @type {[number, number]} */ (on ? ends.map((v) => c + (v - c) * by) : ends);
    zoom({
      x: about(reach.x, at.x(px ?? left + w / 2), px === undefined || px > left),
      y: about(reach.y, at.y(py ?? top + h / 2), py === undefined || py < top + h),
    });
  }

  /** What lies at a place, in words. @param {Found} found @param {Spec} of */
  function words({ which, x, y }, of) {
    const s = of.series[which];
    const [l, h] = [s.low, s.high].map((list) => list && valueAt({ x: s.x, y: list }, x));
    const value =
      l === undefined || h === undefined
        ? `${number(y)}${unit(of.y)}`
        : between(y, l, h, unit(of.y));
    return `${s.name}: ${number(x)}${unit(of.x)}, ${value}`;
  }

  /** @param {Found} found */
  function point(found) {
    if (!at || !spec) return;
    const [px, py] = [at.px(found.x), at.py(found.y)],
      { clientWidth: width } = host;
    dot.style.cssText = `transform:translate(${px}px,${py}px);border-color:${colourOf(spec.series[found.which], found.which)}`;
    hair.style.cssText = `left:${px}px;top:${at.top}px;height:${at.h}px`;
    tip.textContent = words(found, spec);
    tip.style.cssText = `${px > width / 2 ? `right:${width - px + 12}px` : `left:${px + 12}px`};top:${Math.max(0, py - 34)}px`;
    dot.hidden = hair.hidden = tip.hidden = false;
  }

  function clear() {
    read = undefined;
    for (const part of [dot, hair, tip, box]) part.hidden = true;
  }

  /** @param {number} px @param {number} py */
  function hover(px, py) {
    if (!at || !spec) return;
    host.style.cursor = py > at.top + at.h ? "ew-resize" : px < at.left ? "ns-resize" : "crosshair";
    const within = px >= at.left && py <= at.top + at.h,
      found = within ? nearest(spec, at, px, py) : undefined;
    if (!found || found.far >= NEAR) return clear();
    point(found);
  }

  /** The part that a drag frames; the view of it at the end. @param {From} begun @param {number[]} to */
  function framed({ px: fx, py: fy, what }, [px, py], settled = false) {
    if (!at) return;
    const { left, top, w, h } = at,
      ends = (/** @type {number} */ a, /** @type {number} */ b, low = 0, size = 0) =>
        [a, b].sort((p, q) => p - q).map((v) => clamp(v, low, low + size));
    const [x0, x1] = what === "y" ? [left, left + w] : ends(fx, px, left, w),
      [y0, y1] = what === "x" ? [top, top + h] : ends(fy, py, top, h);
    box.hidden = settled;
    box.style.cssText = `left:${x0}px;top:${y0}px;width:${x1 - x0}px;height:${y1 - y0}px`;
    if (settled && x1 - x0 > 5 && y1 - y0 > 5)
      zoom({ x: [at.x(x0), at.x(x1)], y: [at.y(y1), at.y(y0)] });
  }

  /** @param {string} key @returns whether it means something here */
  function pressed(key) {
    pointer = undefined;
    const step = { ArrowRight: [0, 1], ArrowLeft: [0, -1], ArrowUp: [1, 0], ArrowDown: [-1, 0] }[
      key
    ];
    if (step) walk(step[0], step[1]);
    else if (key === "+" || key === "=") zoomAbout(0.7);
    else if (key === "-") zoomAbout(1 / 0.7);
    else if (key === "0" || key === "Escape") zoom(undefined);
    else return false;
    return true;
  }

  /**
   * To the next point with a value, of this curve or another one.
   * @param {number} curve @param {number} along
   */
  function walk(curve, along) {
    const series = spec?.series ?? [];
    const readable = series.flatMap((s, i) => (!s.band && s.x.length ? [i] : []));
    if (!readable.length) return;
    const [was, i] = read ?? [readable[0], -1];
    const which =
      readable[(Math.max(0, readable.indexOf(was)) + curve + readable.length) % readable.length];
    const s = series[which];
    let next = i < 0 ? 0 : clamp(i + along, 0, s.x.length - 1);
    while (s.y[next] === null && next + (along || 1) in s.x) next += along || 1;
    const y = s.y[next];
    if (!spec || typeof y !== "number") return;
    const found = { which, x: s.x[next], y };
    point(found);
    read = [which, next];
    say(words(found, spec));
  }

  /** The drawing as text of an SVG file. @param {number} width @param {number} height */
  function svg(width, height) {
    const of = /** @type {Spec} */ (spec);
    return drawing(of, frame(of, width, height, zoomed ?? reachOf(of)), colours(), true);
  }

  const where = (/** @type {MouseEvent} */ event) => {
    const { left, top } = host.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  };
  /** @param {number[]} to @param {boolean} settled */
  function dragged([px, py], settled) {
    if (at) drag?.(at.x(px), at.y(py), settled);
  }
  /** @param {PointerEvent} event */
  function down(event) {
    if (event.button !== 0 || !at || event.target === all) return;
    const [px, py] = where(event),
      inner = drag ? "drag" : event.pointerType === "touch" ? undefined : "box",
      what = py > at.top + at.h ? "x" : px < at.left ? "y" : inner;
    if (!what) return;
    from = { px, py, what };
    clear();
    host.setPointerCapture(event.pointerId);
    if (what === "drag") dragged([px, py], false);
  }
  /** @param {PointerEvent} event */
  function moved(event) {
    const to = where(event);
    pointer = from ? undefined : to;
    if (!from) hover(to[0], to[1]);
    else if (from.what === "drag") dragged(to, false);
    else framed(from, to);
  }
  /** @param {PointerEvent} event */
  function up(event) {
    const begun = from;
    from = undefined;
    if (begun?.what === "drag") dragged(where(event), true);
    else if (begun) framed(begun, where(event), true);
  }

  return {
    host,
    draw,
    svg,
    /** @param {Spec} next */
    set spec(next) {
      spec = { ...next, series: next.series.map(smoothed) };
    },

    /**
     * A ring over the curves at values of the axes; none without. Nothing is drawn anew for it.
     * @param {number} [x] @param {number} [y]
     */
    mark(x, y) {
      marked = x === undefined || y === undefined ? undefined : [x, y];
      placeMark();
    },

    /**
     * Its pixels, twice as fine.
     * @param {number} width @param {number} height @returns {Promise<Blob>}
     */
    async png(width, height) {
      const file = URL.createObjectURL(new Blob([svg(width, height)], { type: "image/svg+xml" }));
      const image = el("img", { src: file });
      await image.decode();
      const canvas = el("canvas", { width: 2 * width, height: 2 * height });
      canvas.getContext("2d")?.drawImage(image, 0, 0, 2 * width, 2 * height);
      URL.revokeObjectURL(file);
      return new Promise((resolve) => canvas.toBlob((blob) => blob && resolve(blob)));
    },
  };
}
