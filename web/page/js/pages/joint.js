// A joint with two of this muscle against each other: pressures by dragging the arm, torques, and
// what it reaches.
import { Slot } from "../ask.js";
import { chartOf } from "../chart.js";
import { fileField, quantity } from "../controls.js";
import {
  block,
  button,
  dim,
  el,
  folded,
  heading,
  inputs,
  problemBox,
  remark,
  warnings,
} from "../dom.js";
import { job } from "../form.js";
import { angleAt, jointDrawing, numbersView, reachChart, torqueChart } from "../joint-view.js";
import {
  FILES,
  IN_FILE,
  JointWords,
  KEYS,
  kindOf,
  stateAt,
  angles,
  drive,
} from "../joint-words.js";
import { muscle, visit } from "../muscle.js";
import { clamp, evenly } from "../units.js";
import { keepWords } from "../kept.js";
import { signal, watch } from "../watch.js";

/** @typedef {Commands["joint"]["request"]} Request */
/** @typedef {import("../joint-words.js").Key} Key */
/** @typedef {import("../joint-words.js").Values} Values */

/**
 * Groups of controls: key, label, ends of the slider, symbol.
 * @type {[string, [Key, string, number, number, string?][]][]}
 */
const GROUPS = [
  [
    "Required",
    [
      ["phi", "Angle", -60, 60, "φ"],
      ["M", "Torque that it holds", -30, 30, "τ"],
      ["K", "Stiffness (0: lowest pressures)", 0, 30],
    ],
  ],
  [
    "Joint",
    [
      ["r", "Radius of the pulley", 5, 80, "r"],
      ["low", "Range from", -150, 0],
      ["high", "Range to", 0, 150],
      ["e0", "Contraction at the neutral angle", 0, 0.25],
      ["pmax", "Pressure of the supply", 0.05, 1],
    ],
  ],
  [
    "Arm",
    [
      ["mass", "Mass of the arm", 0, 5],
      ["centre", "Centre of mass from the axis", 10, 400],
      ["inertia", "Moment of inertia", 0.001, 0.2],
    ],
  ],
];

/**
 * The controls.
 * @param {Values} v
 * @param {{ changed: (key: Key, settled: boolean) => void, takeSecond: (text: string) => void,
 *   takeJoint: (text: string) => void }} act
 */
function controlsOf(v, { changed, takeSecond, takeJoint }) {
  const controls = /** @type {Record<Key, ReturnType<typeof quantity>>} */ ({});
  const groups = GROUPS.map(([name, list]) =>
    el(
      "fieldset",
      { class: name === "Required" && "state" },
      el("legend", name),
      ...list.map(([key, label, low, high, symbol]) => {
        controls[key] = quantity({
          key,
          label,
          symbol,
          kind: kindOf(key),
          low,
          high,
          value: v[key],
          change(value = v[key], settled) {
            v[key] = value;
            changed(key, settled);
          },
        });
        return controls[key].element;
      }),
    ),
  );
  const element = inputs(
    "Joint",
    ...groups,
    folded(
      "Different second muscle",
      fileField("Open muscle 2 (TOML)", ".toml", (_, text) => takeSecond(text)),
      button("Use the same muscle twice", () => takeSecond("")),
    ),
    folded(
      "Joint file",
      remark("A joint file can state a spring and the weight of the arm."),
      fileField("Open a joint file (TOML)", ".toml", (_, text) => takeJoint(text)),
      button("Close the joint file", () => takeJoint("")),
    ),
  );
  return { element, controls };
}

/**
 * A move from the angle of the page to another one, played on the page Motion.
 * @param {Values} v @param {(angles: number[]) => Request | undefined} question
 */
function moveBox(v, question) {
  const to = { angle: -20, seconds: 1 };
  const field = (
    /** @type {"angle" | "seconds"} */ key,
    /** @type {{ label: string, kind: Kind, low: number, high: number }} */ spec,
  ) =>
    quantity({ ...spec, value: to[key], change: (value = to[key]) => (to[key] = value) }).element;
  const play = job(
    "Play in Motion",
    "joint",
    async () => question(angles(v.phi, to.angle)),
    ({ points }) => {
      visit("motion", { drive: drive(points, to.seconds, v.pmax) });
    },
    { minor: true },
  );
  return {
    element: folded(
      "Move the arm",
      remark("Motion shows how valves and arm follow."),
      field("angle", { label: "Move to", kind: "angle", low: -60, high: 60 }),
      field("seconds", { label: "Within", kind: "time", low: 0.1, high: 5 }),
      play.element,
    ),
  };
}

/**
 * Pressures at angles, with the stiffness that the page asks for.
 * @param {Values} v @param {number[]} list
 */
const wanted = (v, list) => ({
  angles_deg: list,
  ...(v.M ? { torque_nm: v.M } : {}),
  max_pressure_mpa: v.pmax,
  ...(v.K ? { stiffness_nm_per_rad: v.K } : {}),
});

/** Shares of the supply in both muscles along the curves. */
const PAIRS = evenly(1, 0, 5).map((share) => [share, 1 - share]);

/** @type {Mount} */
export const mount = (main) => {
  const joint = new JointWords(),
    { v, files } = joint;
  /** @type {Signal<JointPoint | undefined>} */ const point = signal(),
    /** @type {Signal<Family | undefined>} */ family = signal(),
    /** @type {Signal<JointAnswer["map"]>} */ reached = signal();
  /** The file that says what the muscle of the page Muscle is. */
  let first = "";
  /** The arm follows the pointer that holds it. @param {PointerEvent} event */
  function follow(event) {
    const angle = arm.hasPointerCapture(event.pointerId) ? angleAt(arm, event) : undefined;
    if (angle !== undefined) turned(angle, event.type === "pointerup");
  }
  const arm = el("div", {
      class: "stage",
      role: "img",
      ariaLabel: "The joint",
      onpointermove: follow,
      onpointerup: follow,
      onpointerdown(/** @type {PointerEvent} */ event) {
        arm.setPointerCapture(event.pointerId);
        follow(event);
      },
    }),
    numbers = el("section", { class: "numbers", ariaLabel: "Numbers" }),
    said = block(),
    notes = block();
  const { element, controls } = controlsOf(v, {
    changed(key, settled) {
      joint.over.add(key);
      ask(settled);
    },
    takeSecond(text) {
      files.file2 = text;
      ask(true);
    },
    async takeJoint(text) {
      files.joint = text;
      joint.over = new Set();
      await joint.fromFile();
      set();
      ask(true);
    },
  });
  /**
   * What the page wrote into a joint file is said at its control, where it has one.
   * @param {Problem} problem
   */
  function mark(problem) {
    if (files.joint) return false;
    const message = problem.message.replace(/^joint\.toml[:\d]*: (\S+ = "[^"]*": )?/, ""),
      of = (/** @type {Key} */ key) => stateAt(key) && problem.message.includes(stateAt(key)),
      wrong = problem.field === "max_pressure_mpa" ? "pmax" : IN_FILE.find(of);
    if (wrong) controls[wrong].mark(message);
    problem.message = message;
    return Boolean(wrong);
  }
  const torque = chartOf("joint-torque", {
      tools: heading("Torque over the angle"),
      drag: (x, _, settled) => turned(x, settled),
    }),
    reach = chartOf("joint-map", { tools: heading("Reachable stiffness") });
  const slots = { first: new Slot(), final: new Slot(), curves: new Slot(), map: new Slot() };
  let turn = 0;
  /** @param {JointAnswer} answer */
  function take(answer) {
    stale(false);
    for (const key of KEYS) controls[key].mark("");
    said.replaceChildren();
    notes.replaceChildren(warnings(answer.warnings));
    const { model, uncertainty_text: words } = answer;
    point.value = { ...answer.points[0], model, words };
  }
  /** @param {Problem} problem */
  function fail(problem) {
    said.replaceChildren(mark(problem) ? "" : problemBox(problem));
    stale(Boolean(point.value));
  }
  // A motion is that of the model: so are its pressures.
  const move = moveBox(v, (list) => ({
    ...joint.request(first),
    ...wanted(v, list),
    model: { name: "fe" },
  }));
  element.append(move.element);
  main.replaceChildren(
    block(
      "bench",
      element,
      block("middle", arm, block("charts", torque.element, reach.element)),
      block("side", said, numbers, notes),
    ),
  );

  /** @param {number} angle @param {boolean} settled */
  function turned(angle, settled) {
    v.phi = clamp(Math.round(angle), v.low, v.high);
    controls.phi.set(v.phi);
    ask(settled);
  }
  /** Curves and map are drawn by a formula. */
  const byFormula = () => ({
    ...joint.request(first),
    model: { name: "universal" },
    extrapolate: true,
  });
  /** @param {boolean} settled */
  function ask(settled) {
    controls.phi.reach(v.low, v.high);
    const mine = ++turn,
      at = wanted(v, [v.phi]);
    slots.final.end();
    // What stays is what finite elements say; they may take seconds.
    const last = () => {
      if (settled && mine === turn)
        slots.final.ask("joint", { ...joint.request(first), ...at }, take, fail);
    };
    slots.first.ask(
      "joint",
      { ...byFormula(), ...at },
      (answer) => {
        take(answer);
        last();
      },
      (problem) => {
        fail(problem);
        last();
      },
    );
    const angles = evenly(v.low, v.high, 25),
      pairs = PAIRS.map((pair) => pair.map((share) => share * v.pmax));
    slots.curves.ask(
      "joint",
      { ...byFormula(), pressures_mpa: pairs, angles_deg: angles },
      (answer) => (family.value = { answer, angles, pairs }),
    );
    if (!settled) return;
    keepWords("joint", joint.words());
    const map = { ...byFormula(), map: 25, max_pressure_mpa: v.pmax };
    slots.map.ask("joint", map, (answer) => (reached.value = answer.map));
  }
  const stale = (/** @type {boolean} */ on) => dim([arm, numbers], on);
  watch(() => {
    const found = point.value,
      {
        length_mm: length = 285,
        outer_diameter_mm: diameter = 30,
        angle_deg: angle = 28,
      } = muscle.shown ?? {};
    arm.innerHTML = jointDrawing(found, found?.angle_deg ?? v.phi, v.pmax, {
      ...v,
      length,
      diameter,
      angle,
    });
    const which = files.file2 ? "Muscle 2 is that of its file." : "Both muscles are the one above.";
    numbers.replaceChildren(...(found ? numbersView(found, which) : []));
  });
  watch(() => {
    const asked = v.M ? { angle: v.phi, torque: v.M } : undefined;
    if (family.value) torque.show(torqueChart(family.value, point.value, asked));
  });
  watch(() => {
    if (reached.value) reach.show(reachChart(reached.value));
  });
  function set() {
    for (const key of KEYS) controls[key].set(v[key]);
  }
  return {
    async load(params) {
      await joint.read(params);
      await muscle.read(params, [...KEYS, ...FILES, "range"]);
      set();
      try {
        first = await muscle.file();
      } catch (problem) {
        stale(true);
        return void said.replaceChildren(problemBox(problem));
      }
      ask(true);
    },
  };
};
