// The muscle, alive: its measures as sliders, the deformed body, curves, and numbers.
import { controlsView } from "../bench/controls.js";
import { curvesView } from "../bench/curves.js";
import { numbersView } from "../bench/numbers.js";
import { stageView } from "../bench/stage.js";
import { OWN, Store } from "../bench/store.js";
import { block, dim, mainButton, problemBox, remark, say } from "../dom.js";
import { muscle } from "../muscle.js";
import { asBuilt, modelPull, onUnits } from "../units.js";

/** @type {Mount} */
export const mount = (main) => {
  const busy = block("busy"),
    said = block();
  const store = new Store((on) => busy.classList.toggle("on", on));
  const controls = controlsView(store);
  const stage = stageView(store, busy),
    curves = curvesView(store),
    numbers = numbersView(store);
  main.replaceChildren(
    block(
      "bench",
      controls.element,
      block(
        "middle",
        stage.stage,
        stage.tools,
        curves.element,
        curves.points.element,
        curves.advanced,
      ),
      block("side", said, numbers.element),
    ),
  );

  /** What is shown belongs to the last muscle that had an answer. @param {boolean} on */
  const stale = (on) => dim([stage.stage, numbers.element, curves.element], on);
  store.on("answer", (pumped) => {
    said.replaceChildren();
    stale(false);
    const { point } = store;
    if (!pumped && point) say(`Pulls ${asBuilt(point)} as built, ${modelPull(point)}`);
  });
  store.on("problem", ({ problem }) => {
    const again = mainButton("Try again", () => store.ask());
    const old = remark("The last result is shown.");
    said.replaceChildren(
      problemBox(problem),
      store.shape ? old : "",
      problem.kind === "engine" ? again : "",
    );
    stale(true);
  });
  onUnits(() => {
    stage.units();
    numbers.paint();
    curves.draw();
    store.settle();
  });

  return {
    async load(params) {
      await muscle.read(params, OWN);
      controls.braids();
      const word = (/** @type {string} */ key, usual = "") => params.get(key) ?? usual;
      Object.assign(store.wanted, {
        test: word("test", "isobaric"),
        show: word("show", "max_stretch"),
        cut: word("cut"),
        over: word("over").split(",")[0],
      });
      curves.load();
      store.tell("sync");
      controls.anchor();
      controls.revealAll();
      store.ask();
      store.follow();
      curves.points.read();
    },
  };
};
