// Long texts of an address, compressed: `z:` and base64url of raw deflate. A text that begins so is no muscle file.

const MARK = "z:";
/** So long a text is at most that a link may hold, in bytes. */
const MOST = 4_000_000;
/** Texts as they stand in an address. @type {Map<string, string>} */ const known =
  new Map();

/** Base64 that an address may hold as it is. */
const ALPHABET = /** @type {const} */ ({
  alphabet: "base64url",
  omitPadding: true,
});

/** @typedef {ReadableWritablePair<Uint8Array<ArrayBuffer>, Uint8Array<ArrayBuffer>>} Pair */
/**
 * @param {Uint8Array<ArrayBuffer>} bytes @param {GenericTransformStream} through @param {number} [most]
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
  if (known.has(text) || text.length < 120) return;
  const packed =
    MARK +
    (
      await piped(
        new TextEncoder().encode(text),
        new CompressionStream("deflate-raw"),
      )
    ).toBase64(ALPHABET);
  if (packed.length < encodeURIComponent(text).length) known.set(text, packed);
}

/** As it stands in an address. @param {string} text */
export const packed = (text) => known.get(text) ?? text;

/** What stands in an address, as a text. @param {string} word @returns {Promise<string>} */
export async function unpack(word) {
  if (!word.startsWith(MARK)) return word;
  const bytes = await piped(
    Uint8Array.fromBase64(word.slice(MARK.length), ALPHABET),
    new DecompressionStream("deflate-raw"),
  );
  const text = new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  known.set(text, word);
  return text;
}
