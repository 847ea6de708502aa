// The engine as WebAssembly: in workers, so that the page never waits for it. A small module answers what is asked while somebody
// drags; the whole one is loaded when it is first needed.
import { Problem, gone } from "./problem.js";

/** @typedef {import("../../../types/commands").Commands} Commands */

/** Commands of the small module; it has no `fe3d`. */
const LIVE = ["force", "pressure", "contraction", "curve", "shape", "muscle-show", "braid-list", "braid-show", "rubber-list", "rubber-show", "models", "quantities", "units"];

class Lane {
  /** @param {() => Promise<WebAssembly.Module>} module */
  constructor(module) {
    this.module = module;
    /** @type {Worker | undefined} */ this.worker = undefined;
    /** @type {Map<number, any>} */ this.open = new Map();
    this.next = 1;
  }

  async start() {
    if (this.worker) return this.worker;
    const module = await this.module();
    if (this.worker) return this.worker;
    const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
    worker.postMessage({ module });
    worker.onmessage = ({ data }) => this.take(data);
    worker.onerror = (event) => this.end(event.message || "the worker ended");
    this.worker = worker;
    return worker;
  }

  /** @param {any} data */
  take(data) {
    if (data.dead) return this.end(data.dead);
    const asked = this.open.get(data.id);
    if (!asked) return;
    if (data.total !== undefined && data.answer === undefined && !data.problem) return asked.progress?.(data.done, data.total);
    this.open.delete(data.id);
    asked.signal?.removeEventListener("abort", asked.stop);
    if (data.problem) asked.reject(new Problem(data.problem));
    else asked.resolve(data.answer);
  }

  /** The worker is given up; the next question starts another. @param {string} why */
  end(why) {
    this.worker?.terminate();
    this.worker = undefined;
    const open = [...this.open.values()];
    this.open.clear();
    open.forEach((asked) => asked.reject(asked.signal?.aborted ? new DOMException("cancelled", "AbortError") : gone(why)));
  }

  /** @param {string} command @param {any} request @param {{ signal?: AbortSignal, progress?: (done: number, total: number) => void }} options */
  async ask(command, request, { signal, progress } = {}) {
    const worker = await this.start();
    signal?.throwIfAborted();
    return new Promise((resolve, reject) => {
      const id = this.next++;
      // Work in WebAssembly cannot be asked to stop: it ends with its worker.
      const stop = () => this.end("cancelled");
      this.open.set(id, { resolve, reject, signal, progress, stop });
      signal?.addEventListener("abort", stop, { once: true });
      worker.postMessage({ id, command, request: JSON.stringify(request) });
    });
  }
}

/** @param {string} name */
function loaded(name) {
  /** @type {Promise<WebAssembly.Module> | undefined} */ let module;
  return () => {
    const load = async () => {
      const answer = await fetch(new URL(`../../${name}`, import.meta.url));
      if (!answer.ok) throw gone(`${name}: ${answer.status} ${answer.statusText}`);
      return answer.headers.get("content-type")?.startsWith("application/wasm")
        ? WebAssembly.compileStreaming(answer)
        : WebAssembly.compile(await answer.arrayBuffer());
    };
    module ??= load().catch((error) => {
      module = undefined;
      throw error instanceof Problem ? error : gone(String(error.message ?? error));
    });
    return module;
  };
}

export class Engine {
  constructor() {
    if (typeof WebAssembly !== "object") throw gone("this browser has no WebAssembly");
    const live = loaded("live.wasm"), whole = loaded("whole.wasm");
    this.lanes = { state: new Lane(live), side: new Lane(live), whole: new Lane(whole), job: new Lane(whole) };
  }

  get about() { return "WebAssembly in this browser"; }

  /**
   * Answers a request. `lane`: `state` for what must come first.
   * @template {keyof Commands} K
   * @param {K} command @param {Commands[K]["request"]} request
   * @param {{ lane?: "state" | "side", signal?: AbortSignal }} [options]
   * @returns {Promise<Commands[K]["answer"]>}
   */
  ask(command, request, { lane = "side", signal } = {}) {
    const { model, formulas } = /** @type {any} */ (request);
    const small = LIVE.includes(command) && model !== "fe3d" && !formulas?.length;
    return this.lanes[small ? lane : "whole"].ask(command, request, { signal });
  }

  /**
   * Long work with progress; the signal ends it.
   * @template {keyof Commands} K
   * @param {K} command @param {Commands[K]["request"]} request
   * @param {{ signal?: AbortSignal, progress?: (done: number, total: number) => void }} [options]
   * @returns {Promise<Commands[K]["answer"]>}
   */
  job(command, request, options) {
    return this.lanes.job.ask(command, request, options);
  }
}
