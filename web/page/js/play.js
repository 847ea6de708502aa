// Something that is played over time by a button.
import { button } from "./dom.js";
import { atEnd } from "./life.js";

/** Whether motion is not wanted. */
export const isStill = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

/**
 * `at` is told the share of the time; only three of them where motion is not wanted.
 * @param {string} what moves @param {(share: number) => void} at
 * @param {() => number} long in milliseconds
 */
export function playing(what, at, long) {
  let running = 0;
  const text = `Move ${what}`,
    one = button(text, () => (running ? stop() : start()));
  function start() {
    const began = performance.now(),
      still = isStill();
    const step = () => {
      const share = Math.min(1, (performance.now() - began) / long());
      at(still ? Math.ceil(3 * share) / 3 : share);
      if (share === 1) return stop();
      running = still ? window.setTimeout(step, long() / 3) : requestAnimationFrame(step);
    };
    stop();
    running = 1;
    one.textContent = `Stop ${what}`;
    step();
  }
  function stop() {
    cancelAnimationFrame(running);
    clearTimeout(running);
    running = 0;
    one.textContent = text;
  }
  atEnd(stop);
  return { button: one, start, stop };
}
