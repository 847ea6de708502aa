// The address: `#muscle?D=38&p=2.5bar`. All that can be seen stands in it.
/** The address that was read or written last. */
const known = { hash: location.hash };

/** @returns {{ page: string, params: URLSearchParams }} */
function parse() {
  const hash = location.hash.replace(/^#/, ""),
    cut = hash.indexOf("?");
  const [page, query] = cut < 0 ? [hash, ""] : [hash.slice(0, cut), hash.slice(cut + 1)];
  return { page: page || "design", params: new URLSearchParams(query) };
}

/** Whether a link of this page leads nowhere on another computer. */
export const isLocal = () => /^(localhost|127\.|\[::1\])/.test(location.hostname);

/**
 * The page of the address, with its words; those that a damaged link has lost. Of one that changes
 * meanwhile, the new one: what was typed counts.
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
  known.hash = of;
  return { page, params, lost };
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
/** So long a text is at most that a link may hold, in bytes. */
const MOST = 4_000_000;
/** Texts as they stand in an address. @type {Map<string, string>} */ const packs = new Map();

/** Base64 that an address may hold as it is. */
const ALPHABET = /** @type {const} */ ({ alphabet: "base64url", omitPadding: true });

/** @typedef {ReadableWritablePair<Uint8Array<ArrayBuffer>, Uint8Array<ArrayBuffer>>} Pair */
/**
 * @param {Uint8Array<ArrayBuffer>} bytes @param {GenericTransformStream} through
 * @param {number} [most]
 * @returns {Promise<Uint8Array>}
 */
export async function piped(bytes, through, most = MOST) {
  const reader = new Blob([bytes])
    .stream()
    .pipeThrough(/** @type {Pair} */ (through))
    .getReader();
  /** @type {Uint8Array<ArrayBuffer>[]} */ const parts = [];
  for (let size = 0; ;) {
    const { done, value } = await reader.read();
    if (done) break;
    size += value.length;
    if (size > most) {
      reader.cancel().catch(() => {});
      throw new Error("too long");
    }
    parts.push(value);
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

/** Makes a text ready for an address; a short one stays as it is. @param {string} text */
export async function pack(text) {
  if (packs.has(text) || text.length < 120) return;
  const packed =
    MARK +
    (await piped(new TextEncoder().encode(text), new CompressionStream("deflate-raw"))).toBase64(
      ALPHABET,
    );
  if (packed.length < encodeURIComponent(text).length) packs.set(text, packed);
}

/** As it stands in an address. @param {string} text */
export const packed = (text) => packs.get(text) ?? text;

/** What stands in an address, as a text. @param {string} word @returns {Promise<string>} */
export async function unpack(word) {
  if (!word.startsWith(MARK)) return word;
  const bytes = await piped(
    Uint8Array.fromBase64(word.slice(MARK.length), ALPHABET),
    new DecompressionStream("deflate-raw"),
  );
  const text = new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  packs.set(text, word);
  return text;
}
