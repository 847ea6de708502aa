// The engine as WebAssembly: in workers, so that the page never waits for it. A small module
// answers what is asked while somebody drags; the whole one is loaded when it is first needed.
import { SCRIPTS } from "../place.js";
import { Problem, gone } from "./problem.js";

/** Commands of the small module; its one model is `fe`, and it reads no files of loads. */
const LIVE = [
  "force",
  "pressure",
  "contraction",
  "curve",
  "shape",
  "check",
  "measures",
  "quantities",
  "units",
];
/** What it lists. */
const LISTED = ["sleeves", "rubbers", "models"];

const cancelled = () => new DOMException("cancelled", "AbortError");

/**
 * A worker, asked one question after the other: one that is given up costs those behind it nothing.
 */
class Lane {
  /** @type {Worker | undefined} */ worker;
  /** Until the question before has ended. @type {Promise<unknown>} */ before = Promise.resolve();

  /** @param {() => Promise<WebAssembly.Module>} module */
  constructor(module) {
    this.module = module;
  }

  async #start() {
    const module = await this.module(),
      worker = new Worker(new URL("engine/worker.js", SCRIPTS), { type: "module" });
    worker.postMessage({ module });
    return worker;
  }

  /** @param {string} command @param {string} request @param {How} how @returns {Promise<never>} */
  async #answer(command, request, { signal, progress }) {
    signal?.throwIfAborted();
    const worker = (this.worker ??= await this.#start());
    return new Promise((resolve, reject) => {
      /** The worker is given up; the next question starts another. @param {unknown} problem */
      const end = (problem) => {
        worker.terminate();
        this.worker = undefined;
        reject(problem);
      };
      // Work in WebAssembly cannot be asked to stop: it ends with its worker.
      const stop = () => end(cancelled());
      signal?.addEventListener("abort", stop);
      worker.onerror = (event) => end(gone(event.message || "the worker ended"));
      worker.onmessage = ({ data: { dead, answer, problem, done, total } }) => {
        if (dead) return end(gone(dead));
        if (!answer && !problem) return progress?.(done, total);
        signal?.removeEventListener("abort", stop);
        if (problem) reject(new Problem(problem));
        else resolve(/** @type {never} */ (answer));
      };
      worker.postMessage({ command, request });
    });
  }

  /** @param {string} command @param {object} request @param {How} how */
  ask(command, request, how) {
    const text = JSON.stringify(request),
      answer = this.before.then(() => this.#answer(command, text, how)),
      ended = answer.then(
        () => {},
        () => {},
      );
    this.before = ended;
    // One that waits is given up at once.
    const given = new Promise((_, reject) =>
      how.signal?.addEventListener("abort", () => reject(cancelled())),
    );
    return Promise.race([answer, given]);
  }
}

/** @param {string} name */
function loaded(name) {
  /** @type {Promise<WebAssembly.Module> | undefined} */ let module;
  return () => {
    const load = async () => {
      const answer = await fetch(new URL(`../${name}`, SCRIPTS));
      if (!answer.ok) throw new Error(`${name}: ${answer.status} ${answer.statusText}`);
      return answer.headers.get("content-type")?.startsWith("application/wasm")
        ? WebAssembly.compileStreaming(answer)
        : WebAssembly.compile(await answer.arrayBuffer());
    };
    module ??= load().catch((error) => {
      module = undefined;
      throw gone(error.message);
    });
    return module;
  };
}

export class Engine {
  constructor() {
    if (typeof WebAssembly !== "object") throw gone("this browser does not support WebAssembly");
    const live = loaded("live.wasm"),
      whole = loaded("whole.wasm");
    this.lanes = {
      state: new Lane(live),
      read: new Lane(live),
      side: new Lane(live),
      curves: new Lane(live),
      whole: new Lane(whole),
      job: new Lane(whole),
    };
  }

  get about() {
    return "WebAssembly in this browser";
  }
  /** What it needs without a network. */
  get files() {
    return ["live.wasm", "whole.wasm"];
  }

  /**
   * Answers a request; the signal ends it.
   * @template {keyof Commands} K @param {K} command @param {Commands[K]["request"]} request
   * @param {How} [how] @returns {Promise<Commands[K]["answer"]>}
   */
  async ask(command, request, { lane = "side", ...how } = {}) {
    const of = /** @type {{ model?: { name?: string }, load_tables?: object[], kind?: string }} */ (
      request
    );
    const known =
      LIVE.includes(command) || (command === "parts-list" && LISTED.includes(of.kind ?? ""));
    const small = known && (of.model?.name ?? "fe") === "fe" && !of.load_tables?.length;
    const { whole } = this.lanes,
      own = small || lane === "job" ? this.lanes[lane] : whole;
    return own.ask(command, request, how).catch((problem) => {
      // The small module does not say which keys a file may have.
      if (!small || problem.kind !== "file") throw problem;
      return whole.ask(command, request, how);
    });
  }
}
