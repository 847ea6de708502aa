/** The files of an archive by their names. */
type Files = Record<string, Uint8Array<ArrayBuffer>>;
export function zipSync(files: Files, options?: { level?: 0; mtime?: string }): Uint8Array<ArrayBuffer>;
export function unzipSync(
  bytes: Uint8Array,
  options?: { filter?: (file: { name: string; originalSize: number }) => boolean },
): Files;
export function deflateSync(bytes: Uint8Array): Uint8Array<ArrayBuffer>;
export function inflateSync(bytes: Uint8Array): Uint8Array<ArrayBuffer>;
