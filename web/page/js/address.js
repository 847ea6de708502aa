// The address: `#muscle?D=38&p=2.5bar`. All that can be seen stands in it.
import { pack, packed, unpack } from "./deflate.js";
import { signal } from "./life.js";
import { pageOf } from "./pages.js";

/** @param {string} [of] @returns {{ page: string, params: URLSearchParams }} */
function parse(of = location.hash) {
  const hash = of.replace(/^#/, ""),
    cut = hash.indexOf("?");
  const [page, query] =
    cut < 0 ? [hash, ""] : [hash.slice(0, cut), hash.slice(cut + 1)];
  return { page: page || "start", params: new URLSearchParams(query) };
}

/** Whether a link of this page leads nowhere on another computer. */
export const isLocal = () =>
  /^(localhost|127\.|\[::1\])/.test(location.hostname);

/**
 * The page of the address, with its words; those that a damaged link has lost. Of one that changes meanwhile, the new
 * one: what was typed counts.
 * @returns {Promise<{ page: string, params: URLSearchParams, lost: string[] }>}
 */
export async function read() {
  const of = location.hash,
    { page, params } = parse();
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
  if (location.hash !== of) return read();
  return { page, params, lost };
}

/** Readable: blanks as +, and no escapes where an address needs none. @param {URLSearchParams} params */
const readable = (params) =>
  [
    ["%2C", ","],
    ["%3A", ":"],
    ["%2F", "/"],
    ["%40", "@"],
  ].reduce(
    (all, [escape, sign]) => all.replaceAll(escape, sign),
    params.toString(),
  );

/** Words as the query of an address. @param {Record<string, string | undefined>} params */
export function query(params) {
  const said = Object.entries(params).flatMap(([key, word]) =>
    word ? [[key, packed(word)]] : [],
  );
  return readable(new URLSearchParams(said));
}

/** @param {string} page @param {Record<string, string | undefined>} params */
export function address(page, params) {
  const words = query(params);
  return `#${page}${words ? "?" + words : ""}`;
}

const written = signal();
/** Is told of each change of the address by a page. */
export const onWritten = written.stay;

/**
 * Puts it into the address in place of the present one: entries of the history are pages. A page that is left before
 * its answer came does not write over the address of the next one.
 * @param {string} to
 */
export function write(to) {
  if (pageOf(parse(to).page) !== pageOf(parse().page)) return;
  if (to === location.hash) return;
  history.replaceState(null, "", to);
  written.tell();
}
