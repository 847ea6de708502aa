// Answers as bytes: the length of the JSON, the JSON, then the numbers of its `arrays` (32 bits
// each), all little-endian.

/**
 * @param {ArrayBuffer} bytes
 * @returns {{ problem?: undefined, answer: never, buffers: ArrayBuffer[] }}
 */
export function unpack(bytes) {
  const length = new DataView(bytes).getUint32(0, true);
  /** @type {{ arrays?: Record<string, number | Float32Array> | unknown[] }} */
  const answer = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, length)));
  let at = 4 + length;
  if (!answer.arrays || Array.isArray(answer.arrays))
    return { answer: /** @type {never} */ (answer), buffers: [] };
  for (const [name, count] of Object.entries(answer.arrays)) {
    answer.arrays[name] = new Float32Array(bytes, at, /** @type {number} */ (count));
    at += 4 * /** @type {number} */ (count);
  }
  return { answer: /** @type {never} */ (answer), buffers: [bytes] };
}
