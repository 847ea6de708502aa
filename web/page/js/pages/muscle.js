// The muscle, alive: its measures as sliders, the deformed body, curves, and numbers.
import { besideView } from "../bench/beside.js";
import { controlsView } from "../bench/controls.js";
import { curvesView } from "../bench/curves.js";
import { numbersView } from "../bench/numbers.js";
import { stageView } from "../bench/stage.js";
import { OWN, Store } from "../bench/store.js";
import { block, dim, mainButton, problemBox, remark, say } from "../dom.js";
import { muscle } from "../muscle.js";
import { asBuilt, modelPull } from "../units.js";
import { watch } from "../watch.js";

/** @type {Mount} */
export const mount = (main) => {
  const busy = block("busy"),
    said = block();
  const store = new Store((on) => busy.classList.toggle("on", on));
  const controls = controlsView(store);
  const beside = besideView(store),
    stage = stageView(store, busy),
    curves = curvesView(store, beside.series),
    numbers = numbersView(store);
  main.replaceChildren(
    block(
      "bench",
      controls.element,
      block(
        "middle",
        stage.stage,
        block("row", ...stage.tools, beside.hold),
        ...curves,
        beside.model,
        beside.numbers,
      ),
      block("side", said, numbers.element),
    ),
  );

  watch(() => {
    const point = store.point.value;
    if (point) say(`Pulls ${asBuilt(point)} as built, ${modelPull(point)}`);
  });
  watch(() => {
    const problem = store.problem.value?.problem;
    // What is shown belongs to the last muscle that had an answer.
    dim([stage.stage, numbers.element, curves[0]], Boolean(problem));
    said.replaceChildren();
    if (!problem) return;
    said.append(problemBox(problem), store.shape.peek() ? remark("The last result is shown.") : "");
    if (problem.kind === "engine") said.append(mainButton("Try again", () => store.ask()));
  });

  return {
    async load(params) {
      await muscle.read(params, Object.keys(OWN));
      controls.braids();
      const words = Object.entries(OWN).map(([key, usual]) => [key, params.get(key) ?? usual]);
      store.wanted.value = Object.fromEntries(words);
      controls.anchor();
      controls.revealAll();
      store.ask();
      store.follow();
    },
  };
};
