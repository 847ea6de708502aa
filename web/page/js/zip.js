// Several files in one: a ZIP archive whose entries are stored as they are.

/** @typedef {{ name: string, bytes: Uint8Array<ArrayBuffer> }} Entry */
const TABLE = Uint32Array.from({ length: 256 }, (_, n) => {
  let c = n;
  for (let k = 0; k < 8; k++) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
  return c;
});

/** @param {Uint8Array} bytes */
export function crc32(bytes) {
  let c = 0xffffffff;
  for (const b of bytes) c = TABLE[(c ^ b) & 0xff] ^ (c >>> 8);
  return (c ^ 0xffffffff) >>> 0;
}

/** Numbers of 2 or 4 bytes, little-endian. @param {[size: 2 | 4, value: number][]} fields */
function packed(fields) {
  const out = new DataView(new ArrayBuffer(fields.reduce((sum, [size]) => sum + size, 0)));
  let at = 0;
  for (const [size, value] of fields) {
    if (size === 2) out.setUint16(at, value, true);
    else out.setUint32(at, value, true);
    at += size;
  }
  return out.buffer;
}

/** What both headers of an entry say; names are UTF-8, and the date is the first that ZIP has. */
const common = (/** @type {Entry} */ { bytes }, /** @type {number} */ name) =>
  /** @type {[2 | 4, number][]} */ ([
    [2, 20],
    [2, 0x0800],
    [2, 0],
    [2, 0],
    [2, 0x21],
    [4, crc32(bytes)],
    [4, bytes.length],
    [4, bytes.length],
    [2, name],
    [2, 0],
  ]);

/** @param {Entry[]} entries */
export function zip(entries) {
  /** @type {BlobPart[]} */ const parts = [],
    /** @type {BlobPart[]} */ list = [];
  let at = 0,
    listed = 0;
  for (const entry of entries) {
    const name = new TextEncoder().encode(entry.name),
      of = common(entry, name.length);
    const local = packed([[4, 0x04034b50], ...of]);
    const central = packed([
      [4, 0x02014b50],
      [2, 20],
      ...of,
      [2, 0],
      [2, 0],
      [2, 0],
      [4, 0],
      [4, at],
    ]);
    parts.push(local, name, entry.bytes);
    list.push(central, name);
    at += local.byteLength + name.length + entry.bytes.length;
    listed += central.byteLength + name.length;
  }
  const count = entries.length;
  const end = packed([
    [4, 0x06054b50],
    [2, 0],
    [2, 0],
    [2, count],
    [2, count],
    [4, listed],
    [4, at],
    [2, 0],
  ]);
  return new Blob([...parts, ...list, end], { type: "application/zip" });
}
