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

/** @typedef {ConstructorParameters<typeof Problem>[0]} Said */
/** What a worker answers: how far it is, an answer, a problem, or its end. */
/**
 * @typedef {{ id: number, done: number, total?: number, answer?: unknown, problem?: Said, dead?:
 * string }} Told
 */
/**
 * A question, with who waits for it.
 * @typedef {{ id: number, command: string, request: string, posted: boolean, signal?: AbortSignal,
 * stop: () => void,
 *   resolve: (answer: never) => void, reject: (problem: unknown) => void,
 *   progress?: (done: number, total: number) => void }} Asked
 */

/**
 * A worker, asked one question after the other: one that is given up costs those behind it nothing.
 */
class Lane {
  /** @type {Worker | undefined} */ worker;
  /** Questions; the first is the one that the worker has. @type {Asked[]} */ open = [];
  next = 1;

  /** @param {() => Promise<WebAssembly.Module>} module */
  constructor(module) {
    this.module = module;
  }

  async start() {
    if (this.worker) return this.worker;
    const module = await this.module();
    if (this.worker) return this.worker;
    const worker = new Worker(new URL("engine/worker.js", SCRIPTS), { type: "module" });
    worker.postMessage({ module });
    worker.onmessage = ({ data }) => this.take(data);
    worker.onerror = (event) => this.end(event.message || "the worker ended");
    this.worker = worker;
    return worker;
  }

  /** The first question goes to the worker, where it is not there yet. */
  async go() {
    const [first] = this.open;
    if (!first || first.posted) return;
    first.posted = true;
    try {
      const worker = await this.start();
      // It may have been given up meanwhile.
      const { id, command, request } = first;
      if (this.open[0] === first) worker.postMessage({ id, command, request });
    } catch (problem) {
      this.refuse(problem);
    }
  }

  /** No question that is open has an answer. @param {unknown} problem */
  refuse(problem) {
    this.open.splice(0).forEach((asked) => this.close(asked, () => asked.reject(problem)));
  }

  /** @param {Asked} asked @param {() => void} act */
  close(asked, act) {
    asked.signal?.removeEventListener("abort", asked.stop);
    act();
  }

  /** @param {Told} data */
  take(data) {
    if (data.dead) return this.end(data.dead);
    const [asked] = this.open;
    if (!asked || asked.id !== data.id) return;
    if (data.total !== undefined && data.answer === undefined && !data.problem)
      return asked.progress?.(data.done, data.total);
    this.open.shift();
    this.go();
    const { problem, answer } = data;
    this.close(asked, () =>
      problem ? asked.reject(new Problem(problem)) : asked.resolve(/** @type {never} */ (answer)),
    );
  }

  /** The worker is given up; the next question starts another. @param {string} why */
  end(why) {
    this.worker?.terminate();
    this.worker = undefined;
    this.refuse(gone(why));
  }

  /** @param {string} command @param {object} request @param {How} how */
  ask(command, request, { signal, progress } = {}) {
    signal?.throwIfAborted();
    return new Promise((resolve, reject) => {
      /** @type {Asked} */
      const asked = {
        id: this.next++,
        command,
        request: JSON.stringify(request),
        resolve,
        reject,
        signal,
        progress,
        posted: false,
        stop: () => {},
      };
      asked.stop = () => {
        const at = this.open.indexOf(asked);
        if (at < 0) return;
        this.open.splice(at, 1);
        // Work in WebAssembly cannot be asked to stop: it ends with its worker.
        if (asked.posted) {
          this.worker?.terminate();
          this.worker = undefined;
          this.go();
        }
        reject(new DOMException("cancelled", "AbortError"));
      };
      signal?.addEventListener("abort", asked.stop, { once: true });
      this.open.push(asked);
      this.go();
    });
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
