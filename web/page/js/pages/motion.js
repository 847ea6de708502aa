// A step on a valve, or the commands of a drive file, with the muscle moving.
import { Slot } from "../ask.js";
import { Chart } from "../chart.js";
import { fileField } from "../controls.js";
import { pack } from "../deflate.js";
import {
  block,
  button,
  el,
  folded,
  heading,
  problemBox,
  remark,
} from "../dom.js";
import { bench, fieldsOf, form, job, warnings } from "../form.js";
import { example } from "../gallery.js";
import { JointWords } from "../joint-words.js";
import { wordsOf } from "../kept.js";
import {
  figures,
  isJoint,
  pressureChart,
  stateAt,
  stateLine,
  wayChart,
} from "../motion-view.js";
import { muscle } from "../muscle.js";
import { playing } from "../play.js";
import { motion } from "../state.js";
import { stated } from "../toml.js";
import { onUnits } from "../units.js";
import { View } from "../view3d.js";

/** @type {Field[]} */
export const STEP = fieldsOf([
  ["to", "pressure_mpa", "Step to", "pressure", "3 bar"],
  ["supply", "supply_mpa", "Supply", "pressure", "6 bar"],
  ["valve", "valve", "Valve", undefined, "0.5 L/(s bar)"],
  ["load", "load", "Load", undefined, "10 kg"],
  ["damping", "damping_n_s_per_m", "Damping", "damping", "200 N s/m"],
  ["until", "until_s", "Until", "time", "2 s"],
  [
    "model",
    "model",
    "Model",
    undefined,
    {
      options: [
        ["fe", "fe"],
        ["universal", "universal"],
      ],
      value: "fe",
    },
  ],
]);

/**
 * A drive file with the muscle of the page, or with the joint of the page Joint.
 * @param {string} text @param {string} file @param {string | undefined} model
 */
async function driven(text, file, model) {
  const drive = { name: "drive.toml", text },
    of = stated(text);
  if (!of.has(".joint"))
    return {
      drive,
      muscle: { name: of.get(".muscle") ?? "muscle.toml", text: file },
      model: { name: model },
    };
  const joint = new JointWords();
  await joint.read(new URLSearchParams(wordsOf("joint")));
  return { drive, ...joint.request(file), model: { name: model } };
}

/** The muscle in space at every time of a run, and the time that is shown. */
function player() {
  const stage = block("stage"),
    clock = el("p", { class: "say" });
  stage.append(clock);
  const view = new View(stage),
    slot = new Slot({ lane: "state" });
  /** @type {Run | undefined} */ let run;
  const slider = el("input", {
    type: "range",
    min: 0,
    max: 1000,
    value: 0,
    "aria-label": "Time",
    oninput: () => {
      play.stop();
      at(Number(slider.value) / 1000);
    },
  });
  const play = playing(
    "Play",
    at,
    () => 1000 * (run?.series.time_s.at(-1) ?? 1),
  );

  /** The state at a share of the time. @param {number} share */
  function at(share) {
    if (!run) return;
    const times = run.series.time_s,
      i = Math.min(times.length - 1, Math.round(share * (times.length - 1)));
    slider.value = String(1000 * share);
    slider.setAttribute("aria-valuetext", `${times[i].toFixed(2)} s`);
    clock.replaceChildren(
      el("b", {}, `${times[i].toFixed(2)} s`),
      el("br"),
      stateLine(run, i),
    );
    slot.ask(
      "shape",
      { muscle: muscle.fields(), ...stateAt(run, i) },
      (shape) => view.stretched(shape),
      () => {},
    );
  }
  return {
    stage,
    row: block("row", play.button, el("span", { style: "flex:1" }, slider)),
    show(/** @type {Run} */ found) {
      run = found;
      play.start();
    },
    again: () => at(Number(slider.value) / 1000),
  };
}

const CLOSED =
  "A drive file states supply, valve, load and commands over time. One with a joint moves that of Joint.";
const EXAMPLES = [
  ["lift 10 kg and lower it", "drive.toml"],
  ["turn the joint", "elbow-drive.toml"],
];

/** Drive files: one that is opened, and examples. @param {(text: string) => void} take */
function driveBox(take) {
  const words = remark(),
    said = block();
  const fail = (/** @type {unknown} */ problem) =>
    said.replaceChildren(problemBox(problem));
  const leave = button("Close the drive file", () => take(""), {
    hidden: true,
  });
  const samples = EXAMPLES.map(([text, name]) =>
    button(text, () => example(name).then(take).catch(fail)),
  );
  const element = folded(
    "Drive file and examples",
    words,
    el("p", { class: "row small" }, "Examples:", ...samples),
    fileField("Open a drive file (TOML)", ".toml", (_, text) => take(text)),
    leave,
    said,
  );
  return {
    element,
    /** @param {string} drive */
    show(drive) {
      leave.hidden = !drive;
      words.textContent = drive
        ? "A drive file is open: it states supply, valve, load and commands."
        : CLOSED;
    },
  };
}

/** Pressure and way over time. */
function chartsOf() {
  const pressure = new Chart("motion-pressure", {
    tools: heading("Pressure over time"),
  });
  const title = el("h2"),
    way = new Chart("motion-contraction", { tools: title });
  return {
    element: block("charts", pressure.element, way.element),
    /** @param {Run} run */
    show(run) {
      pressure.show(pressureChart(run));
      title.textContent = `${isJoint(run) ? "Angle" : "Contraction"} over time`;
      way.show(wayChart(run));
    },
  };
}

/** @type {Mount} */
export const mount = (main) => {
  /** @type {Run | undefined} */ let run;
  let drive = "";
  const fields = form(STEP, () => go.run()),
    shown = player();
  const charts = chartsOf();
  const numbers = block();
  const box = driveBox((text) => take(text));
  const title = heading("A step on a valve");
  const go = job(
    "Run",
    "motion",
    request,
    (answer) => {
      run = answer;
      paint();
      shown.show(run);
    },
    { fields, shown: [shown.stage, numbers, charts.element] },
  );
  main.replaceChildren(
    bench(
      "Step",
      [title, fields.element, go.element, numbers, box.element],
      [shown.stage, shown.row, charts.element],
    ),
  );
  const place = () => muscle.place("motion", { ...fields.texts(), drive });

  async function request() {
    const read = await fields.read();
    if (!read) return undefined;
    place();
    const file = await muscle.file();
    return drive ? driven(drive, file, read.model) : motion(file, read);
  }

  /** @param {string} text a drive file; empty for a step */
  async function take(text) {
    await pack(text);
    drive = text;
    offer();
    await go.run();
  }

  /** What a drive file states has no field. */
  function offer() {
    for (const { key } of STEP) fields.shown(key, !drive || key === "model");
    box.show(drive);
    title.textContent = drive
      ? "Commands of a drive file"
      : "A step on a valve";
  }

  function paint() {
    if (!run) return;
    charts.show(run);
    numbers.replaceChildren(figures(run), warnings(run.warnings));
  }

  onUnits(() => {
    paint();
    shown.again();
    place();
  });
  return {
    async load(params) {
      await muscle.read(params, [...fields.keys, "drive"]);
      fields.set(params);
      drive = params.get("drive") ?? "";
      offer();
      await go.run();
    },
  };
};
