// The engine behind HTTP: `mckibben serve`.
import { SCRIPTS } from "../place.js";
import { unpack } from "./packed.js";
import { Problem, gone } from "./problem.js";

const API = new URL("../api/", SCRIPTS);

export class Engine {
  get about() {
    return "mckibben serve";
  }

  /**
   * Without progress of long work; the signal ends it.
   * @template {keyof Commands} K @param {K} command @param {Commands[K]["request"]} request
   * @param {How} [how]
   * @returns {Promise<Commands[K]["answer"]>}
   */
  async ask(command, request, { signal } = {}) {
    const headers = { "content-type": "application/json", accept: "application/octet-stream" };
    try {
      const answer = await fetch(new URL(command, API), {
        method: "POST",
        signal,
        body: JSON.stringify(request),
        headers,
      });
      if (answer.ok) return unpack(await answer.arrayBuffer()).answer;
      throw new Problem((await answer.json()).error);
    } catch (error) {
      if (signal?.aborted) throw new DOMException("cancelled", "AbortError");
      throw error instanceof Problem ? error : gone("the server cannot be reached");
    }
  }
}
