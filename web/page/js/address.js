// The address: `#muscle?D=38&p=2.5bar`. All that can be seen stands in it.
import { deflateSync, inflateSync } from "./vendor/fflate.js";

/** The address that was read or written last. */
const known = { hash: location.hash };

/** Whether a link of this page leads nowhere on another computer. */
export const isLocal = () => /^(localhost|127\.|\[::1\])/.test(location.hostname);

/** The page of the address, with its words; those that a damaged link has lost. */
export function read() {
  known.hash = location.hash;
  const [, page, query] = /^#?([^?]*)\??(.*)$/.exec(known.hash) ?? [],
    params = new URLSearchParams(query),
    /** @type {string[]} */ lost = [];
  for (const [key, word] of [...params]) {
    try {
      params.set(key, unpacked(word));
    } catch {
      params.delete(key);
      lost.push(key);
    }
  }
  return { page: page || "design", params, lost };
}

/**
 * Readable: blanks as +, and no escapes where an address needs none.
 * @param {URLSearchParams} params
 */
const readable = (params) => params.toString().replace(/%(2C|3A|2F|40)/g, decodeURIComponent);

/** Words as the query of an address. @param {Record<string, string | undefined>} params */
export function query(params) {
  const said = Object.entries(params).flatMap(([key, word]) => (word ? [[key, packed(word)]] : []));
  return readable(new URLSearchParams(said));
}

/** @param {string} page @param {Record<string, string | undefined>} params */
export function address(page, params) {
  const words = query(params);
  return `#${page}${words ? "?" + words : ""}`;
}

/**
 * Puts it into the address in place of the present one: entries of the history are pages. An address
 * that was not read yet is somebody's wish, and stays.
 * @param {string} to
 */
export function write(to) {
  if (location.hash !== known.hash || to === known.hash) return;
  history.replaceState(null, "", to);
  known.hash = location.hash;
}

// Long texts, compressed: `z:` and base64url of raw deflate. A text that begins so is no muscle
// file.
const MARK = "z:";
/** So long a word is at most, and a text that stays as it is. */
const MOST = 300_000,
  SHORT = 120;
/** Base64 that an address may hold as it is. */
const ALPHABET = /** @type {const} */ ({ alphabet: "base64url", omitPadding: true });

/** As it stands in an address. @param {string} text */
function packed(text) {
  if (text.length < SHORT) return text;
  const word = MARK + deflateSync(new TextEncoder().encode(text)).toBase64(ALPHABET);
  return word.length < encodeURIComponent(text).length ? word : text;
}

/** What stands in an address, as a text. @param {string} word */
export function unpacked(word) {
  if (!word.startsWith(MARK)) return word;
  if (word.length > MOST) throw new Error("too long");
  const bytes = Uint8Array.fromBase64(word.slice(MARK.length), ALPHABET);
  return new TextDecoder("utf-8", { fatal: true }).decode(inflateSync(bytes));
}
