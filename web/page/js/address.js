// The address: `#muscle?D=38&p=2.5bar`. All that can be seen stands in it; an entry of the history is a gesture, not a
// frame.
import { pack, packed, unpack } from "./deflate.js";
import { pageOf } from "./pages.js";

/** @param {string} [of] @returns {{ page: string, params: URLSearchParams }} */
function parse(of = location.hash) {
  const hash = of.replace(/^#/, ""), cut = hash.indexOf("?");
  const [page, query] = cut < 0 ? [hash, ""] : [hash.slice(0, cut), hash.slice(cut + 1)];
  return { page: page || "muscle", params: new URLSearchParams(query) };
}

/** The page of the address, with its words; those that a damaged link has lost. */
export async function read() {
  const { page, params } = parse();
  /** @type {string[]} */ const lost = [];
  for (const [key, word] of [...params]) {
    try {
      params.set(key, await unpack(word));
    } catch {
      params.delete(key);
      lost.push(key);
    }
  }
  await Promise.all([...params.values()].map(pack));
  return { page, params, lost, bare: !location.hash.includes("?") };
}

/** Readable: blanks as +, and no escapes where an address needs none. @param {URLSearchParams} params */
const readable = (params) => {
  const text = params.toString();
  return [["%2C", ","], ["%3A", ":"], ["%2F", "/"], ["%40", "@"]].reduce(
    (all, [escape, sign]) => all.replaceAll(escape, sign),
    text,
  );
};

/** Words as the query of an address. @param {Record<string, string | undefined>} params */
export function query(params) {
  const said = Object.entries(params).flatMap((
    [key, word],
  ) => (word === undefined || word === "" ? [] : [[key, packed(word)]]));
  return readable(new URLSearchParams(said));
}

/** @param {string} page @param {Record<string, string | undefined>} params */
export function address(page, params) {
  const words = query(params);
  return `#${page}${words ? "?" + words : ""}`;
}

/** While a page is loaded it only completes its own entry of the history. */
let loading = 0;
/** @template T @param {() => Promise<T>} load */
export async function whileLoading(load) {
  loading++;
  try {
    return await load();
  } finally {
    loading--;
  }
}

// Places in the history: how many gestures can be taken back, and done again.
const place = { now: 0, last: 0 };
/** @type {() => void} */ let moved = () => {};
const LAST = "mckibben:last";
const remember = () => {
  try {
    sessionStorage.setItem(LAST, String(place.last));
  } catch { /* It is only for a button. */ }
};

/** @param {() => void} tell is called whenever it changes what can be undone */
export function onMoved(tell) {
  place.now = Number(history.state?.at ?? 0);
  let last = 0;
  try {
    last = Number(sessionStorage.getItem(LAST) ?? 0);
  } catch { /* As above. */ }
  place.last = Math.max(place.now, history.state ? last : 0);
  if (!history.state) history.replaceState({ at: place.now }, "");
  moved = tell;
  tell();
}
export const canUndo = () => place.now > 0;
export const canRedo = () => place.now < place.last;

/** The browser went elsewhere: to an entry of before, or by a link to a new one. */
export function arrived() {
  const at = history.state?.at;
  if (typeof at === "number") place.now = at;
  else {
    place.last = ++place.now;
    history.replaceState({ at: place.now }, "");
    remember();
  }
  moved();
}

/**
 * Puts it into the address: a new entry of the history, or in place of the present one. A page that is left before its answer came
 * does not write over the address of the next one.
 * @param {string} to
 */
export function write(to, replace = false) {
  if (pageOf(parse(to).page) !== pageOf(parse().page)) return;
  if (to === location.hash || (to === "#muscle" && !location.hash)) return;
  if (replace || loading) history.replaceState({ at: place.now }, "", to);
  else {
    place.last = ++place.now;
    history.pushState({ at: place.now }, "", to);
    remember();
  }
  moved();
}
