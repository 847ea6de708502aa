// The engine behind HTTP: `mckibben serve`.
import { unpack } from "./packed.js";
import { Problem, gone } from "./problem.js";

const API = new URL("../../api/v1/", import.meta.url);

const MOST_TRIES = 5;

/** @param {Response} answer */
async function problem(answer) {
  const said = await answer.json().catch(() => ({}));
  return new Problem({ kind: said.kind ?? "engine",
    message: said.detail ?? said.message ?? `${answer.status} ${answer.statusText}`, hint: said.hint,
    field: said.field });
}

/** @param {string} path @param {RequestInit} init */
async function reach(path, init) {
  /** @type {Response} */ let answer;
  for (let tries = 0;; tries++) {
    try {
      answer = await fetch(new URL(path, API), init);
    } catch (error) {
      if (init.signal?.aborted) throw new DOMException("cancelled", "AbortError");
      throw gone("the server cannot be reached");
    }
    // Its queue is full: it says when to come again.
    if (answer.status !== 429 || tries === MOST_TRIES) break;
    await new Promise((resolve) =>
      setTimeout(resolve, 1000 * Math.min(5, Number(answer.headers.get("retry-after") ?? 1)))
    );
  }
  if (!answer.ok) throw await problem(answer);
  return answer;
}

/** @param {unknown} request @param {AbortSignal} [signal] */
const post = (request, signal) => ({ method: "POST", signal, body: JSON.stringify(request),
  headers: { "content-type": "application/json", accept: "application/octet-stream" } });

/** @typedef {import("../../../types/commands").Commands} Commands */

export class Engine {
  get about() {
    return "mckibben serve";
  }
  /** It has no files: without its server there is no answer. */
  get files() {
    return /** @type {string[]} */ ([]);
  }

  /**
   * @template {keyof Commands} K
   * @param {K} command @param {Commands[K]["request"]} request
   * @param {{ lane?: import("./wasm.js").LaneName, signal?: AbortSignal }} [options]
   * @returns {Promise<Commands[K]["answer"]>}
   */
  async ask(command, request, { signal } = {}) {
    const answer = await reach(command, post(request, signal));
    return unpack(await answer.arrayBuffer()).answer;
  }

  /**
   * @template {keyof Commands} K
   * @param {K} command @param {Commands[K]["request"]} request
   * @param {{ signal?: AbortSignal, progress?: (done: number, total: number) => void }} [options]
   * @returns {Promise<Commands[K]["answer"]>}
   */
  async job(command, request, { signal, progress } = {}) {
    const begun =
      await (await reach(`jobs/${command}`, { ...post(request, signal),
        headers: { "content-type": "application/json" } })).json();
    const events = new EventSource(new URL(`jobs/${begun.id}/events`, API));
    return new Promise((resolve, reject) => {
      let ended = false;
      const end = (/** @type {() => void} */ act) => {
        if (!ended) {
          ended = true;
          events.close();
          act();
        }
      };
      signal?.addEventListener("abort", () => {
        fetch(new URL(`jobs/${begun.id}`, API), { method: "DELETE" }).catch(() => {});
        end(() => reject(new DOMException("cancelled", "AbortError")));
      }, { once: true });
      events.addEventListener("progress", ({ data }) => {
        const { done, total } = JSON.parse(data);
        progress?.(done, total);
      });
      events.addEventListener("answer", ({ data }) => end(() => resolve(JSON.parse(data))));
      events.addEventListener("problem", ({ data }) => end(() => reject(new Problem(JSON.parse(data)))));
      // An EventSource tries again for ever: whether the server and the job are still there, the job's own address
      // says.
      events.onerror = async () => {
        const there = events.readyState !== EventSource.CLOSED &&
          await fetch(new URL(`jobs/${begun.id}`, API)).then((answer) => answer.ok, () => false);
        if (!there) end(() => reject(gone("the connection to the server was lost")));
      };
    });
  }
}
