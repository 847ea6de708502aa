// Files that the engine made: each as a download, and all of them in one archive.
import { block, button, download, el, mainButton, paragraph } from "./dom.js";
import { number } from "./units.js";
import { zip } from "./zip.js";

/** @typedef {Commands["build"]["answer"]["files"][number]} File */

/** @param {File} file @returns {Uint8Array<ArrayBuffer>} */
const bytesOf = ({ text, base64 }) =>
  typeof text === "string"
    ? new TextEncoder().encode(text)
    : Uint8Array.from(atob(base64 ?? ""), (c) => c.charCodeAt(0));

/** @param {number} bytes */
const size = (bytes) =>
  bytes < 1000
    ? `${bytes} B`
    : bytes < 1e6
      ? `${number(bytes / 1e3, 3)} kB`
      : `${number(bytes / 1e6, 3)} MB`;

/** @param {readonly File[]} files @param {string} archive its name without the ending */
export function filesView(files, archive) {
  const all = files.map((file) => ({
    name: file.name,
    about: file.about,
    bytes: bytesOf(file),
  }));
  const rows = all.map(({ name, about, bytes }) =>
    el(
      "li",
      {},
      button(name, () => download(name, bytes, "application/octet-stream")),
      ` ${about} `,
      el("span", { class: "soft" }, size(bytes.length)),
    ),
  );
  const every = () => download(`${archive}.zip`, zip(all), "application/zip");
  return block(
    "files",
    el("ul", { class: "plain" }, ...rows),
    files.length > 1 &&
      paragraph(mainButton(`All files (${archive}.zip)`, every)),
  );
}
