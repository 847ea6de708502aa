// What asks the engines, without a browser: workers and the server are stand-ins, so that what never answers can be asked.
import assert from "node:assert/strict";
import { afterEach, test } from "node:test";

const usual = { Worker: globalThis.Worker, fetch: globalThis.fetch, window: globalThis.window };
afterEach(() => {
  Object.assign(globalThis, usual);
});

/** Workers that answer with what they were asked, but for what is slow, which they never answer. */
function workers() {
  /** @type {any[]} */ const made = [];
  Object.assign(globalThis, {
    // The smallest module there is.
    fetch: async () =>
      new Response(new Uint8Array([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0]), {
        headers: { "content-type": "application/octet-stream" },
      }),
    Worker: class {
      constructor() {
        this.alive = true;
        this.asked = [];
        made.push(this);
      }
      terminate() {
        this.alive = false;
      }
      /** @param {any} data */
      postMessage(data) {
        if (data.module) return;
        /** @type {any[]} */ (this.asked).push(data.request);
        if (!data.request.includes("slow"))
          setTimeout(() => {
            if (this.alive)
              /** @type {any} */ (this).onmessage({
                data: { id: data.id, answer: JSON.parse(data.request) },
              });
          }, 1);
      }
    },
  });
  return made;
}

test("a worker whose question is given up is replaced, and the questions behind it are answered", async () => {
  const made = workers();
  const { Engine } = await import("../page/js/engine/wasm.js");
  const engine = /** @type {any} */ (new Engine()),
    ends = new AbortController();
  const slow = engine.ask("curve", { slow: 1 }, { signal: ends.signal });
  const behind = [engine.ask("units", { a: 1 }), engine.ask("units", { a: 2 })];
  // Given up while it waits: nothing ends for it.
  const waits = new AbortController(),
    never = engine.ask("units", { a: 3 }, { signal: waits.signal });
  waits.abort();
  await assert.rejects(never, { name: "AbortError" });
  while (!made[0]?.asked.length) await new Promise((resolve) => setTimeout(resolve, 1));
  ends.abort();
  await assert.rejects(slow, { name: "AbortError" });
  assert.deepEqual(await Promise.all(behind), [{ a: 1 }, { a: 2 }]);
  assert.deepEqual(
    made.map((worker) => [worker.alive, worker.asked.length]),
    [
      [false, 1],
      [true, 2],
    ],
  );
});

test("a question that holds up a newer one of its place is given up, and only the newest is asked", async () => {
  const made = workers();
  globalThis.window = /** @type {any} */ ({ setTimeout });
  const { Slot } = await import("../page/js/ask.js");
  const slot = new Slot({ lane: "side" }),
    said = /** @type {any[]} */ ([]);
  const began = performance.now();
  slot.ask(
    "curve",
    /** @type {any} */ ({ slow: 1 }),
    () => said.push("slow"),
    () => said.push("wrong"),
  );
  slot.ask("units", /** @type {any} */ ({ a: 1 }), () => said.push("old"));
  await new Promise((resolve) => {
    slot.ask("units", /** @type {any} */ ({ a: 2 }), (answer) => {
      said.push(answer);
      resolve(undefined);
    });
  });
  assert.deepEqual(said, [{ a: 2 }]);
  assert.ok(performance.now() - began < 3000);
  assert.equal(made.at(-1).asked.length, 1);
});

test("a server that is gone is said", async () => {
  Object.assign(globalThis, {
    fetch: async () => {
      throw new TypeError("refused");
    },
  });
  const { Engine } = await import("../page/js/engine/http.js");
  await assert.rejects(
    new Engine().ask("plan", /** @type {any} */ ({})),
    /the server cannot be reached/,
  );
});
