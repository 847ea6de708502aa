// A tour of half a minute over the page Muscle: six places, one sentence each. It can be left at any time.
import { el } from "./dom.js";

/** Places, by what finds them, and what is said there. @type {[string, string][]} */
const STOPS = [
  [".muscle-bar", "This is your muscle. It goes with you to every page. Undo, save, open and share it here."],
  [".stage", "It moves as you change it. Drag its right end to contract it, and the gauge to pressurise it."],
  [".controls .state", "Pressure and contraction. Type any unit, such as 36psi or 2.5 bar, or drag the sliders."],
  [".numbers", "The pull with its ±, which covers 95 % of the differences from measured muscles."],
  [".bench .chart, .bench .charts", "How the muscle pulls over its whole stroke. Drag along a curve."],
  ["#pages", "Next: Design finds a muscle for a pull that you need, and Data fits the model to your own bench."],
];
const SECONDS = 5;
/** @type {(() => void) | undefined} */ let end;

export function startTour() {
  end?.();
  if (document.body.dataset.page === "muscle") return run();
  location.hash = "#muscle";
  const seen = new MutationObserver(() => {
    if (document.querySelector(".bench .numbers")) {
      seen.disconnect();
      run();
    }
  });
  seen.observe(document.body, { childList: true, subtree: true });
}

/** Puts a box below a place, or above it where there is no room. @param {HTMLElement} box @param {DOMRect} at */
function place(box, at) {
  const { width, height } = box.getBoundingClientRect(), margin = 8;
  const below = at.bottom + margin + height < innerHeight,
    y = below
      ? at.bottom + margin
      : Math.max(margin, Math.min(innerHeight - height - margin, at.top - height - margin));
  box.style.left = `${Math.max(margin, Math.min(innerWidth - width - margin, at.left))}px`;
  box.style.top = `${y}px`;
}

function run() {
  let stop = -1, timer = 0;
  const text = el("p", { "aria-live": "polite" }), count = el("span", { class: "small soft grow" });
  const ring = el("div", { class: "tour-ring", "aria-hidden": "true" });
  const skip = el("button", { type: "button", onclick: () => end?.() }, "Skip"),
    next = el("button", { type: "button", class: "main", onclick: () => go() }, "Next");
  const box = el("div", { class: "tour", role: "dialog", "aria-label": "Tour" }, text,
    el("div", { class: "row" }, count, skip, next));
  const keys = (/** @type {KeyboardEvent} */ event) => {
    if (event.key === "Escape") end?.();
  };
  const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
  const follow = () => {
    const target = document.querySelector(STOPS[stop]?.[0] ?? "body");
    if (!target) return;
    const at = target.getBoundingClientRect();
    Object.assign(ring.style, { left: `${at.left - 3}px`, top: `${at.top - 3}px`, width: `${at.width + 6}px`,
      height: `${at.height + 6}px` });
    place(box, at);
  };
  function go() {
    clearTimeout(timer);
    do stop++; while (stop < STOPS.length && !document.querySelector(STOPS[stop][0]));
    if (stop >= STOPS.length) return end?.();
    document.querySelector(STOPS[stop][0])?.scrollIntoView({ block: "nearest" });
    text.textContent = STOPS[stop][1];
    count.textContent = `${stop + 1} of ${STOPS.length}`;
    next.textContent = stop === STOPS.length - 1 ? "Done" : "Next";
    follow();
    // Who reads with the keyboard or a screen reader goes on by themselves.
    if (!box.contains(document.activeElement) && !still) timer = window.setTimeout(go, 1000 * SECONDS);
  }
  end = () => {
    clearTimeout(timer);
    box.remove();
    ring.remove();
    removeEventListener("keydown", keys);
    removeEventListener("scroll", follow, true);
    removeEventListener("resize", follow);
    removeEventListener("popstate", leave);
    end = undefined;
  };
  const leave = () => end?.();
  addEventListener("keydown", keys);
  addEventListener("scroll", follow, true);
  addEventListener("resize", follow);
  addEventListener("popstate", leave);
  document.body.append(ring, box);
  go();
}
