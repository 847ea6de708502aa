// One engine in a worker of its own: requests in, answers out, one after the other.
import { unpack } from "./packed.js";

/**
 * What the module exports.
 * @type {{ memory: WebAssembly.Memory, reserve: (bytes: number) => number, ask: (command: number)
 * => number,
 *   answer: () => number, answer_length: () => number, start: () => void }}
 */
let engine;
/** @type {Promise<void> | undefined} */ let ready;
const encoder = new TextEncoder(),
  decoder = new TextDecoder();

/** What stands in the memory as the answer. */
const said = () => new Uint8Array(engine.memory.buffer, engine.answer(), engine.answer_length());

/**
 * @param {string} command @param {string} request
 * @returns {{ problem?: object, answer?: unknown, buffers?: ArrayBuffer[] }}
 */
function ask(command, request) {
  const [a, b] = [encoder.encode(command), encoder.encode(request)];
  const at = engine.reserve(a.length + b.length);
  const input = new Uint8Array(engine.memory.buffer, at, a.length + b.length);
  input.set(a);
  input.set(b, a.length);
  const wrong = engine.ask(a.length);
  return wrong ? { problem: JSON.parse(decoder.decode(said())) } : unpack(said().slice().buffer);
}

/** @param {WebAssembly.Module} module */
async function begin(module) {
  const host = {
    progress: (/** @type {number} */ done, /** @type {number} */ total) =>
      self.postMessage({ done, total }),
  };
  engine = /** @type {typeof engine} */ ((await WebAssembly.instantiate(module, { host })).exports);
  engine.start();
}

self.onmessage = async ({ data }) => {
  if (data.module) {
    ready = begin(data.module);
    return;
  }
  // A module that cannot begin ends the worker.
  await ready;
  try {
    const { problem, answer, buffers } = ask(data.command, data.request);
    self.postMessage({ problem, answer }, { transfer: buffers ?? [] });
  } catch (error) {
    // A trap: the instance cannot be used any more; its last words stand where the answer would.
    const words = decoder.decode(said());
    self.postMessage({ dead: words || String(error) });
  }
};
