// Use without a network. The service worker keeps the page and what was used; what is large and was
// not used yet (the whole engine) is fetched for an installed app, for who comes back, or when one
// asks for it: the first visit does not pay for it. The page of a server is not kept.
import { engine } from "./ask.js";

/** So long after the first page, in milliseconds: its own questions come first. */
const LATER = 2000;
const isInstalled = () => matchMedia("(display-mode: standalone)").matches;
/** Whether the browser asks for as little as possible. */
const saves = () =>
  Boolean(
    /** @type {Navigator & { connection?: { saveData?: boolean } }} */ (navigator).connection
      ?.saveData,
  );
/** The page of a server computes nothing without it. @returns {string[]} */
const large = () => engine().files ?? [];

/** What the worker keeps its files in. */
const shelf = () => caches.open("mckibben-page-1");

/** What is not kept yet. */
async function lacking() {
  const cache = await shelf(),
    there = await Promise.all(large().map((file) => cache.match(file)));
  return large().filter((_, i) => !there[i]);
}

const canKeep = () =>
  large().length > 0 &&
  "serviceWorker" in navigator &&
  window.isSecureContext &&
  "caches" in window;
/** Whether every page is kept; there is no answer where the browser keeps nothing. */
export async function isKept() {
  if (canKeep() && (await navigator.serviceWorker.getRegistration()))
    return !(await lacking()).length;
}

/** Fetches and keeps what is not there yet. */
export async function keepAll() {
  await navigator.serviceWorker.ready;
  const cache = await shelf();
  for (const file of await lacking()) await cache.add(file);
}

/** Begins when the first page is there. */
export function offline() {
  if (!canKeep()) return;
  const returning = Boolean(navigator.serviceWorker.controller);
  const quietly = () => keepAll().catch(() => {});
  window.addEventListener("appinstalled", quietly);
  const begin = async () => {
    try {
      await navigator.serviceWorker.register("sw.js");
    } catch {
      return;
    }
    if (isInstalled() || (returning && !saves())) quietly();
  };
  setTimeout(() => (window.requestIdleCallback ?? setTimeout)(begin), LATER);
}
