// Curves on the page: crosshair, zoom, and drags in values of the axes. The drawing itself is in plot.js.
import { block, button, el, say } from "./dom.js";
import { token } from "./theme.js";
import { colourOf, drawing, frame, nearest, reachOf, valueAt } from "./plot.js";
import { between, clamp, number } from "./units.js";

/** Farther away than this in pixels nothing is read off. */
const NEAR = 48;
/** So long the pointer rests before what is below it is computed, in milliseconds. */
const REST = 200;
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

export class Lines {
  /**
   * @param {HTMLElement} host @param {string} name
   * @param {((x: number, y: number, settled: boolean) => unknown) | undefined} drag
   */
  constructor(host, name, drag) {
    this.host = host;
    this.drag = drag;
    /** @type {Spec | undefined} */ this.spec = undefined;
    /** @type {import("./plot.js").Frame | undefined} */ this.at = undefined;
    /** @type {Reach | undefined} */ this.zoomed = undefined;
    /** What the keyboard reads: curve and point. @type {[number, number] | undefined} */ this.read =
      undefined;
    this.resting = 0;
    /** Where the pointer rests on the plot. @type {[number, number] | undefined} */ this.pointer =
      undefined;
    /** Where the ring is, in values of the axes. @type {[number, number] | undefined} */ this.marked =
      undefined;
    this.drawn = block();
    this.ring = el("i", { class: "ring", hidden: true });
    this.dot = el("i", { class: "dot", hidden: true });
    this.tip = el("div", { class: "tip small", hidden: true });
    this.hair = el("i", { class: "hair", hidden: true });
    this.box = el("i", { class: "box", hidden: true });
    this.all = button("Show all", () => this.zoom(undefined), {
      class: "all small",
      hidden: true,
    });
    host.replaceChildren(
      this.drawn,
      this.hair,
      this.box,
      this.dot,
      this.tip,
      this.all,
      this.ring,
    );
    host.tabIndex = 0;
    host.setAttribute("role", "group");
    host.setAttribute(
      "aria-label",
      `${name.replaceAll("-", " ")}: arrow keys read its points, + and − zoom, 0 shows all`,
    );
    this.listen();
  }

  draw() {
    const {
      spec,
      host: { clientWidth: width, clientHeight: height },
    } = this;
    if (!spec || !width || !height) return;
    this.at = frame(spec, width, height, this.zoomed ?? reachOf(spec));
    this.drawn.innerHTML = drawing(spec, this.at, colours());
    this.all.hidden = !this.zoomed;
    this.placeMark();
    // What is below the pointer is read off anew.
    if (this.pointer) this.hover(this.pointer[0], this.pointer[1]);
    else if (!this.tip.hidden) this.clear();
  }

  /**
   * A ring over the curves at values of the axes; none without. Nothing is drawn anew for it.
   * @param {number} [x] @param {number} [y]
   */
  mark(x, y) {
    this.marked = x === undefined || y === undefined ? undefined : [x, y];
    this.placeMark();
  }
  /** At the edge of the plot where its values lie beyond. */
  placeMark() {
    const { at, marked } = this;
    this.ring.hidden = !at || !marked;
    if (!at || !marked) return;
    const within = (
      /** @type {number} */ v,
      /** @type {number} */ low,
      /** @type {number} */ size,
    ) => clamp(v, low, low + size);
    const [x, y] = [
      within(at.px(marked[0]), at.left, at.w),
      within(at.py(marked[1]), at.top, at.h),
    ];
    this.ring.style.transform = `translate(${x}px, ${y}px)`;
  }

  /** @param {Reach | undefined} reach nothing for all */
  zoom(reach) {
    this.zoomed = reach;
    this.draw();
  }

  /** @param {number} by @param {number} [px] @param {number} [py] */
  zoomAbout(by, px, py) {
    const { at } = this;
    if (!at) return;
    const [cx, cy] = [
      at.x(px ?? at.left + at.w / 2),
      at.y(py ?? at.top + at.h / 2),
    ];
    const about = (
      /** @type {[number, number]} */ [low, high],
      /** @type {number} */ c,
      on = true,
    ) =>
      /** @type {[number, number]} */ (
        on ? [c + (low - c) * by, c + (high - c) * by] : [low, high]
      );
    this.zoom({
      x: about(at.reach.x, cx, px === undefined || px > at.left),
      y: about(at.reach.y, cy, py === undefined || py < at.top + at.h),
    });
  }

  /** What lies at a place, in words. @param {Found} found */
  words({ which, x, y, low, high }) {
    const spec = /** @type {Spec} */ (this.spec),
      s = spec.series[which];
    const [l, h] = [low ?? valueAt(s, x, "low"), high ?? valueAt(s, x, "high")];
    const value =
      l === undefined || h === undefined
        ? `${number(y)}${unit(spec.y)}`
        : between(y, l, h, unit(spec.y));
    return `${s.name}: ${number(x)}${unit(spec.x)}, ${value}`;
  }

  /** @param {Found} found */
  point(found) {
    const { at, spec } = this;
    if (!at || !spec) return;
    const [px, py] = [at.px(found.x), at.py(found.y)];
    const colour = colourOf(spec.series[found.which], found.which);
    this.dot.style.cssText = `transform:translate(${px}px,${py}px);border-color:${colour}`;
    this.hair.style.cssText = `left:${px}px;top:${at.top}px;height:${at.h}px`;
    this.say(this.words(found), px, py);
    this.dot.hidden = this.hair.hidden = false;
  }
  /** Words beside a place. @param {string} text @param {number} px @param {number} py */
  say(text, px, py) {
    const { clientWidth: width } = this.host;
    this.tip.textContent = text;
    this.tip.style.cssText = `${px > width / 2 ? `right:${width - px + 12}px` : `left:${px + 12}px`};top:${Math.max(0, py - 34)}px`;
    this.tip.hidden = false;
  }

  clear() {
    clearTimeout(this.resting);
    this.read = undefined;
    [this.dot, this.hair, this.tip, this.box].forEach((part) => {
      part.hidden = true;
    });
  }

  listen() {
    const { host } = this;
    const on = (
      /** @type {string} */ event,
      /** @type {(event: never) => void} */ act,
      options = {},
    ) =>
      host.addEventListener(event, /** @type {EventListener} */ (act), options);
    /** @type {{ px: number, py: number, what: "drag" | "x" | "y" | "box" } | undefined} */ let from;
    const where = (/** @type {PointerEvent | MouseEvent} */ event) => {
      const box = host.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    const drag = (
      /** @type {number} */ px,
      /** @type {number} */ py,
      /** @type {boolean} */ settled,
    ) => this.at && this.drag?.(this.at.x(px), this.at.y(py), settled);
    on("pointerdown", (/** @type {PointerEvent} */ event) => {
      if (event.button !== 0 || !this.at || event.target === this.all) return;
      const [px, py] = where(event),
        { left, top, h } = this.at,
        touch = event.pointerType === "touch";
      const what =
        py > top + h
          ? "x"
          : px < left
            ? "y"
            : this.drag
              ? "drag"
              : touch
                ? undefined
                : "box";
      if (!what) return;
      from = { px, py, what };
      this.clear();
      host.setPointerCapture(event.pointerId);
      if (what === "drag") drag(px, py, false);
    });
    on("pointermove", (/** @type {PointerEvent} */ event) => {
      const [px, py] = where(event);
      this.pointer = from ? undefined : [px, py];
      if (!from) return this.hover(px, py);
      if (from.what === "drag") drag(px, py, false);
      else this.frameOf(from, px, py);
    });
    on("pointerup", (/** @type {PointerEvent} */ event) => {
      const [px, py] = where(event),
        begun = from;
      from = undefined;
      if (begun?.what === "drag") drag(px, py, true);
      else if (begun) this.zoomTo(begun, px, py);
    });
    on("pointercancel", () => {
      from = undefined;
      this.clear();
    });
    on("pointerleave", () => {
      this.pointer = undefined;
      if (!from) this.clear();
    });
    on("blur", () => this.clear());
    on("dblclick", () => this.zoom(undefined));
    on(
      "wheel",
      (/** @type {WheelEvent} */ event) => {
        if (!event.ctrlKey && !event.metaKey) return;
        event.preventDefault();
        const [px, py] = where(event);
        this.zoomAbout(Math.exp(0.002 * event.deltaY), px, py);
      },
      { passive: false },
    );
    on("keydown", (/** @type {KeyboardEvent} */ event) => {
      if (event.target === host && this.key(event.key)) event.preventDefault();
    });
    host.style.touchAction = "pan-y";
  }

  /** @param {number} px @param {number} py */
  hover(px, py) {
    const { at, spec } = this;
    if (!at || !spec) return;
    this.host.style.cursor =
      py > at.top + at.h
        ? "ew-resize"
        : px < at.left
          ? "ns-resize"
          : "crosshair";
    const within = px >= at.left && py <= at.top + at.h,
      said = within && spec.says?.(at.x(px), at.y(py)),
      found = within ? nearest(spec, at, px, py) : undefined;
    if (said) return this.say(said, px, py);
    if (!found || found.far >= NEAR) return this.clear();
    this.point(found);
    clearTimeout(this.resting);
    if (spec.exact)
      this.resting = window.setTimeout(() => this.compute(found), REST);
  }

  /**
   * What is below the pointer that rests, computed.
   * @param {Found} found
   */
  compute(found) {
    const { spec, pointer } = this;
    spec?.exact?.(spec.series[found.which], found.x, ([y, low, high]) => {
      if (this.spec === spec && this.pointer === pointer)
        this.point({ ...found, y, low, high });
    });
  }

  /**
   * The part that a drag selects.
   * @param {{ px: number, py: number, what: string }} from @param {number} px @param {number} py
   */
  selected(from, px, py) {
    const { left, top, w, h } = /** @type {import("./plot.js").Frame} */ (
      this.at
    );
    const sorted = (
      /** @type {number} */ a,
      /** @type {number} */ b,
      /** @type {number} */ low,
      /** @type {number} */ size,
    ) => [Math.max(low, Math.min(a, b)), Math.min(low + size, Math.max(a, b))];
    const [x0, x1] =
      from.what === "y" ? [left, left + w] : sorted(from.px, px, left, w);
    const [y0, y1] =
      from.what === "x" ? [top, top + h] : sorted(from.py, py, top, h);
    return { x0, x1, y0, y1 };
  }

  /** @param {{ px: number, py: number, what: string }} from @param {number} px @param {number} py */
  frameOf(from, px, py) {
    const { x0, x1, y0, y1 } = this.selected(from, px, py);
    this.box.hidden = false;
    const [wide, tall] = [Math.max(0, x1 - x0), Math.max(0, y1 - y0)];
    this.box.style.cssText = `left:${x0}px;top:${y0}px;width:${wide}px;height:${tall}px`;
  }

  /** @param {{ px: number, py: number, what: string }} from @param {number} px @param {number} py */
  zoomTo(from, px, py) {
    this.box.hidden = true;
    const { at } = this,
      { x0, x1, y0, y1 } = this.selected(from, px, py);
    if (!at || x1 - x0 < 6 || y1 - y0 < 6) return;
    this.zoom({
      x: from.what === "y" ? at.reach.x : [at.x(x0), at.x(x1)],
      y: from.what === "x" ? at.reach.y : [at.y(y1), at.y(y0)],
    });
  }

  /** @param {string} key @returns whether it means something here */
  key(key) {
    this.pointer = undefined;
    const step = {
      ArrowRight: [0, 1],
      ArrowLeft: [0, -1],
      ArrowUp: [1, 0],
      ArrowDown: [-1, 0],
    }[key];
    if (step) this.walk(step[0], step[1]);
    else if (key === "+" || key === "=") this.zoomAbout(0.7);
    else if (key === "-") this.zoomAbout(1 / 0.7);
    else if (key === "0" || key === "Escape") this.zoom(undefined);
    else return false;
    return true;
  }

  /** To the next point with a value, of this curve or another one. @param {number} curve @param {number} along */
  walk(curve, along) {
    const series = this.spec?.series ?? [];
    const readable = series
      .map((_, i) => i)
      .filter(
        (i) => !series[i].band && !series[i].silent && series[i].x.length,
      );
    if (!readable.length) return;
    const [was, i] = this.read ?? [readable[0], -1];
    const which =
      readable[
        (Math.max(0, readable.indexOf(was)) + curve + readable.length) %
          readable.length
      ];
    const s = series[which];
    let next = clamp(i + along, 0, s.x.length - 1);
    if (i < 0) next = 0;
    while (s.y[next] === null && next + (along || 1) in s.x) next += along || 1;
    const y = s.y[next];
    if (typeof y !== "number") return;
    const found = { which, x: s.x[next], y };
    this.point(found);
    this.read = [which, next];
    say(this.words(found));
  }

  /** The drawing as text of an SVG file. @param {number} width @param {number} height */
  svg(width, height) {
    const spec = /** @type {Spec} */ (this.spec);
    return drawing(
      spec,
      frame(spec, width, height, this.zoomed ?? reachOf(spec)),
      colours(),
      true,
    );
  }

  /** Its pixels, twice as fine. @param {number} width @param {number} height @returns {Promise<Blob>} */
  async png(width, height) {
    const file = URL.createObjectURL(
      new Blob([this.svg(width, height)], { type: "image/svg+xml" }),
    );
    const image = el("img", { src: file });
    await image.decode();
    const canvas = el("canvas", { width: 2 * width, height: 2 * height });
    canvas.getContext("2d")?.drawImage(image, 0, 0, 2 * width, 2 * height);
    URL.revokeObjectURL(file);
    return new Promise((resolve) =>
      canvas.toBlob((blob) => blob && resolve(blob)),
    );
  }
}
