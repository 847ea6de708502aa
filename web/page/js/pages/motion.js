// A step on a valve, or the commands of a drive file, with the muscle moving.
import { Slot } from "../ask.js";
import { chartOf, KINDS } from "../chart.js";
import { fileField } from "../controls.js";
import {
  bench,
  block,
  button,
  el,
  folded,
  heading,
  problemBox,
  remark,
  table,
  warnings,
} from "../dom.js";
import { fieldsOf, form, job } from "../form.js";
import { example } from "../gallery.js";
import { JointWords } from "../joint-words.js";
import { keepWords, wordsOf } from "../kept.js";
import { muscle } from "../muscle.js";
import { playing } from "../play.js";
import { motion } from "../state.js";
import { stated } from "../toml.js";
import { number, outside, ratioAxis, show, showPressure, showRatio, unitName } from "../units.js";
import { viewOf } from "../view3d.js";
import { signal, watch } from "../watch.js";

/** @type {Field[]} */
export const STEP = fieldsOf([
  ["to", "pressure_mpa", "Step to", "pressure", "3 bar"],
  ["supply", "supply_mpa", "Supply", "pressure", "6 bar"],
  ["valve", "valve", "Valve", { value: "0.5 L/(s bar)" }],
  ["load", "load", "Load", { value: "10 kg" }],
  ["damping", "damping_n_s_per_m", "Damping", "damping", "200 N s/m"],
  ["until", "until_s", "Until", "time", "2 s"],
  [
    "model",
    "model",
    "Model",

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
  const view = viewOf(stage),
    slot = new Slot({ lane: "state" });
  /** @type {Run | undefined} */ let run;
  const slider = el("input", {
    type: "range",
    min: 0,
    max: 1000,
    value: 0,
    ariaLabel: "Time",
    oninput: () => {
      play.stop();
      at(Number(slider.value) / 1000);
    },
  });
  const play = playing("the muscle", at, () => 1000 * (run?.series.time_s.at(-1) ?? 1));

  /** The state at a share of the time. @param {number} share */
  function at(share) {
    if (!run) return;
    const times = run.series.time_s,
      i = Math.min(times.length - 1, Math.round(share * (times.length - 1)));
    slider.value = String(1000 * share);
    slider.ariaValueText = `${times[i].toFixed(2)} s`;
    clock.replaceChildren(el("b", `${times[i].toFixed(2)} s`), el("br"), stateLine(run, i));
    slot.ask("shape", { muscle: muscle.fields(), ...stateAt(run, i) }, (shape) =>
      view.stretched(shape),
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

const EXAMPLES = [
  ["lift 10 kg and lower it", "drive.toml"],
  ["turn the joint", "elbow-drive.toml"],
];

/** Drive files: one that is opened, and examples. @param {(text: string) => void} take */
function driveBox(take) {
  const said = block();
  const fail = (/** @type {unknown} */ problem) => said.replaceChildren(problemBox(problem));
  const leave = button("Close the drive file", () => take(""));
  const samples = EXAMPLES.map(([text, name]) =>
    button(text, () => example(name).then(take).catch(fail)),
  );
  const element = folded(
    "Drive file and examples",
    remark("A drive file states supply, valve, load and commands."),
    el("p", { class: "row small" }, "Examples:", ...samples),
    fileField("Open a drive file (TOML)", ".toml", (_, text) => take(text)),
    leave,
    said,
  );
  return { element, leave };
}

// A motion as people see it: pressures, the way of muscle or joint over time, and its figures.
/**
 * Series of pressures of a muscle or of a joint: what each is called, and its colour; commands are
 * dotted.
 */
const PRESSURES = /** @type {const} */ ([
  ["pressure_mpa", "muscle", 0],
  ["command", "command", 6],
  ["pressure_1_mpa", "muscle 1", 0],
  ["command_1", "command 1", 6],
  ["pressure_2_mpa", "muscle 2", 1],
  ["command_2", "command 2", 6],
]);

/** @param {Run} run @returns {Spec} */
const pressureChart = ({ series: s }) => ({
  x: "time [s]",
  y: `pressure [${unitName("pressure")}]`,
  series: PRESSURES.flatMap(([key, name, colour]) =>
    s[key]
      ? [
          {
            name,
            x: s.time_s,
            y: s[key].map((p) => outside("pressure", p)),
            colour: KINDS[colour],
            end: name,
            dash: colour === 6 ? "dot" : undefined,
          },
        ]
      : [],
  ),
});

/** @param {Run} run @returns {Spec} */
const wayChart = ({ series: { time_s: x, angle_deg: angle, contraction = [] } }) => ({
  x: "time [s]",
  y: angle ? "angle φ [°]" : ratioAxis,
  yaxis: angle ? {} : undefined,
  series: [
    {
      name: angle ? "angle" : "contraction",
      x,
      y: angle ?? (contraction ?? []).map((e) => 100 * e),
      colour: KINDS[1],
    },
  ],
});

/** Largest speed, of the motion itself. @param {Run} run */
const speed = ({ largest_velocity_deg_per_s: turn, largest_velocity_mm_per_s: way }) =>
  turn == null
    ? `${number(outside("length", way ?? 0), 3)} ${unitName("length")}/s`
    : `${number(turn, 3)} °/s`;

/** @param {Run} run */
function figures(run) {
  const time = (/** @type {number | null | undefined} */ x) => show("s", x, 3);
  return table(
    ["", ""],
    [
      ["Rise time, 10–90 %", time(run.rise_time_s)],
      ["Settling time, 2 %", time(run.settling_time_s)],
      ["Overshoot", showRatio(run.overshoot, 3)],
      ["Filled within 2 % after", time(run.fill_time_s)],
      run.liquid_volume_mm3 == null
        ? ["Air from the supply", show("normal L", run.air_normal_litres, 3)]
        : ["Liquid pushed in", show("mL", run.liquid_volume_mm3 / 1000)],
      ["Largest speed", speed(run)],
    ],
    { label: "figures of the step" },
  );
}

/** The state at a place of the record, in a line. @param {Run} run @param {number} i */
function stateLine({ series: s }, i) {
  const both = [s.pressure_1_mpa, s.pressure_2_mpa].flatMap((p) =>
    p ? [showPressure(p[i], 3)] : [],
  );
  return s.angle_deg
    ? `${number(s.angle_deg[i], 3)}°, ${both.join(" and ")}`
    : `${showPressure(s.pressure_mpa?.[i], 3)}, ${showRatio(s.contraction?.[i], 3)}`;
}

/**
 * The muscle at a place of the record: that of the page, or muscle 1 of a joint.
 * @param {Run} run @param {number} i
 */
function stateAt({ series: s }, i) {
  const [p, e] = [s.pressure_mpa ?? s.pressure_1_mpa ?? [], s.contraction ?? s.contraction_1 ?? []];
  return { pressure_mpa: Math.max(0, p[i]), contraction: e[i] };
}

/** @type {Mount} */
export const mount = (main) => {
  /** @type {Signal<Run | undefined>} */ const run = signal();
  let drive = "";
  const fields = form(STEP, () => go.run()),
    shown = player();
  fields.element.append(folded("Advanced", fields.rows.model.row));
  const pressure = chartOf("motion-pressure", { tools: heading("Pressure over time") }),
    way = chartOf("motion-contraction", { tools: heading("Movement over time") }),
    charts = block("charts", pressure.element, way.element),
    numbers = block();
  const box = driveBox((text) => take(text));
  const title = heading("A step on a valve");
  const go = job(
    "Run",
    "motion",
    request,
    (answer) => {
      run.value = answer;
      shown.show(answer);
    },
    { fields, shown: [shown.stage, numbers, charts] },
  );
  main.replaceChildren(
    bench(
      "Step",
      [title, fields.element, go.element, numbers, box.element],
      [shown.stage, shown.row, charts],
    ),
  );

  async function request() {
    const read = await fields.read();
    if (!read) return undefined;
    keepWords("motion", { ...fields.texts(), drive });
    const file = await muscle.file();
    return drive ? driven(drive, file, read.model) : motion(file, read);
  }

  /** @param {string} text a drive file; empty for a step */
  async function take(text) {
    drive = text;
    offer();
    await go.run();
  }

  /** What a drive file states has no field. */
  function offer() {
    for (const { key } of STEP) fields.shown(key, !drive || key === "model");
    box.leave.hidden = !drive;
    title.textContent = drive ? "Commands of a drive file" : "A step on a valve";
  }

  watch(() => {
    const answer = run.value;
    if (!answer) return;
    pressure.show(pressureChart(answer));
    way.show(wayChart(answer));
    numbers.replaceChildren(figures(answer), warnings(answer.warnings));
    shown.again();
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
