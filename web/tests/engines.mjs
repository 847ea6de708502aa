// Both engines of the page without a browser: a running server, and the WebAssembly modules in this process.
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { unpack } from "../page/js/engine/packed.js";

/** @typedef {(command: string, request: any) => Promise<any>} Ask throws the engine's problem */

/** @param {string} url of the page that is served @returns {Ask} */
export const overHttp = (url) => async (command, request) => {
  const answer = await fetch(new URL(`api/${command}`, url), {
    method: "POST",
    body: JSON.stringify(request),
    headers: { "content-type": "application/json" },
  });
  const said = await answer.json();
  if (!answer.ok) throw Object.assign(new Error(said.error.message), said.error);
  return said;
};

/** @param {string} folder of `web/build.sh` @returns {Promise<Ask>} */
export async function inWasm(folder) {
  const host = { progress: () => {} };
  const { instance } = await WebAssembly.instantiate(await readFile(join(folder, "whole.wasm")), {
    host,
  });
  const engine = /** @type {any} */ (instance.exports),
    encoder = new TextEncoder(),
    decoder = new TextDecoder();
  engine.start();
  return async (command, request) => {
    const [a, b] = [encoder.encode(command), encoder.encode(JSON.stringify(request))];
    const at = engine.reserve(a.length + b.length);
    const input = new Uint8Array(engine.memory.buffer, at, a.length + b.length);
    input.set(a);
    input.set(b, a.length);
    const wrong = engine.ask(a.length);
    const bytes = new Uint8Array(
      engine.memory.buffer,
      engine.answer(),
      engine.answer_length(),
    ).slice();
    if (wrong) {
      const said = JSON.parse(decoder.decode(bytes));
      throw Object.assign(new Error(said.message), said);
    }
    return unpack(bytes.buffer).answer;
  };
}
