// A joint with two of this muscle against each other: pressures by dragging the arm, torques, and what it reaches.
import { Slot } from "../ask.js";
import { Chart } from "../chart.js";
import { fileField, quantity } from "../controls.js";
import { pack } from "../deflate.js";
import {
  block,
  button,
  dim,
  dragging,
  el,
  folded,
  heading,
  problemBox,
  remark,
} from "../dom.js";
import { job, warnings } from "../form.js";
import { jointDrawing } from "../joint-drawing.js";
import {
  angleAt,
  numbersView,
  reachChart,
  torqueChart,
} from "../joint-view.js";
import { FILES, JointWords, KEYS, KINDS_OF } from "../joint-words.js";
import { atEnd } from "../life.js";
import { muscle } from "../muscle.js";
import { angles, drive } from "../trajectory.js";
import { clamp, evenly, onUnits } from "../units.js";
import { visit } from "../visit.js";

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
      el("legend", {}, name),
      ...list.map(([key, label, low, high, symbol]) => {
        controls[key] = quantity({
          key,
          label,
          symbol,
          kind: KINDS_OF[key],
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
  const ofFile = remark();
  const back = button("Use the same muscle twice", () => takeSecond(""), {
    hidden: true,
  });
  const leave = button("Close the joint file", () => takeJoint(""), {
    hidden: true,
  });
  const element = el(
    "section",
    { class: "controls", "aria-label": "Joint" },
    ...groups,
    folded(
      "Different second muscle",
      fileField("Open muscle 2 (TOML)", ".toml", (_, text) => takeSecond(text)),
      back,
    ),
    folded(
      "Joint file",
      ofFile,
      fileField("Open a joint file (TOML)", ".toml", (_, text) =>
        takeJoint(text),
      ),
      leave,
    ),
  );
  return {
    element,
    controls,
    /** @param {{ joint: string, file2: string }} files */
    show({ joint: file, file2 }) {
      back.hidden = !file2;
      leave.hidden = !file;
      ofFile.textContent = file
        ? "A joint file is open: its spring, weight and friction count; pulley, range and neutral contraction can " +
          "be changed above."
        : "A joint file can state a spring, the weight of the arm, and more.";
    },
  };
}

/**
 * A move from the angle of the page to another one, played on the page Motion.
 * @param {Values} v @param {(angles: number[]) => Request | undefined} question
 */
function moveBox(v, question) {
  const to = { angle: -20, seconds: 1 };
  const field = (
    /** @type {"angle" | "seconds"} */ key,
    /** @type {string} */ label,
    /** @type {Kind} */ kind,
    /** @type {number} */ low,
    /** @type {number} */ high,
  ) =>
    quantity({
      label,
      kind,
      low,
      high,
      value: to[key],
      change(value) {
        if (value !== undefined) to[key] = value;
      },
    }).element;
  const play = job(
    "Play in Motion",
    "joint",
    async () => question(angles(v.phi, to.angle)),
    ({ points }) => {
      visit("motion", { drive: drive(points, to.seconds, v.pmax) });
    },
  );
  const about =
    "From the angle above at the required stiffness. Motion shows how valves and arm follow.";
  return {
    element: folded(
      "Move the arm",
      remark(about),
      field("angle", "Move to", "angle", -60, 60),
      field("seconds", "Within", "time", 0.1, 5),
      play.element,
    ),
  };
}

/** Pressures at angles, with the stiffness that the page asks for. @param {Values} v @param {number[]} list */
const wanted = (v, list) => ({
  angles_deg: list,
  max_pressure_mpa: v.pmax,
  ...(v.K > 0 ? { stiffness_nm_per_rad: v.K } : {}),
});

/**
 * Questions about a joint: a point, by formulas while one drags and by finite elements at rest, and its family of
 * torques.
 * @param {{ take: (answer: JointAnswer) => void, fail: (problem: Problem) => void, family: (family: Family) => void }} act
 */
function questions({ take, fail, family }) {
  let settling = 0,
    asking = 0,
    decided = 0;
  atEnd(() => clearTimeout(settling));
  const point = new Slot(),
    elements = new Slot(),
    curves = new Slot();
  return {
    /** @param {Request} request @param {Values} v @param {boolean} settled */
    ask(request, v, settled) {
      const mine = ++asking,
        at = wanted(v, [v.phi]);
      point.ask(
        "joint",
        { ...request, ...at },
        (answer) => {
          if (decided !== mine) take(answer);
        },
        (problem) => {
          if (decided !== mine) fail(problem);
        },
      );
      // What stays is what finite elements say.
      clearTimeout(settling);
      elements.end();
      const last = () =>
        elements.ask(
          "joint",
          { ...request, model: { name: "fe" }, extrapolate: false, ...at },
          (answer) => {
            decided = mine;
            take(answer);
          },
          (problem) => {
            decided = mine;
            fail(problem);
          },
        );
      if (settled) settling = window.setTimeout(last, 50);
      const angles = evenly(v.low, v.high, 25);
      const pairs = [
        [1, 0],
        [0.75, 0.25],
        [0.5, 0.5],
        [0.25, 0.75],
        [0, 1],
      ].map((pair) => pair.map((x) => x * v.pmax));
      curves.ask(
        "joint",
        { ...request, pressures_mpa: pairs, angles_deg: angles },
        (answer) => family({ answer, angles, pairs }),
        () => {},
      );
    },
  };
}

class JointPage {
  joint = new JointWords();
  /** @type {JointPoint | undefined} */ #point;
  /** @type {Family | undefined} */ #family;
  /** @type {JointAnswer["map"]} */ #reached;
  /** The file that says what the muscle of the page Muscle is. */
  #first = "";

  /** @param {HTMLElement} main */
  constructor(main) {
    this.arm = el("div", {
      class: "stage",
      role: "img",
      "aria-label": "The joint",
    });
    this.numbers = el("section", { class: "numbers", "aria-label": "Numbers" });
    this.said = block();
    this.notes = block();
    this.bench = controlsOf(this.joint.v, {
      changed: (key, settled) => {
        this.joint.over.add(key);
        this.#ask(settled);
      },
      takeSecond: (text) => this.#takeSecond(text),
      takeJoint: (text) => this.#takeJoint(text),
    });
    this.torque = new Chart("joint-torque", {
      tools: heading("Torque over the angle"),
      drag: (x, _, settled) => this.#turned(x, settled),
    });
    this.reach = new Chart("joint-map", {
      tools: heading("Reachable stiffness"),
    });
    const question = async () => ({
      ...this.#request(),
      map: 25,
      max_pressure_mpa: this.joint.v.pmax,
    });
    this.map = job(
      "Map of the reachable states",
      "joint",
      question,
      ({ map }) => this.#mapped(map),
    );
    this.asks = questions({
      take: (answer) => this.#take(answer),
      fail: (problem) => this.#fail(problem),
      family: (family) => {
        this.#family = family;
        this.torque.show(torqueChart(family, this.#point));
      },
    });
    const { v } = this.joint;
    this.move = moveBox(v, (list) => ({
      ...this.joint.request(this.#first),
      ...wanted(v, list),
    }));
    this.bench.element.append(this.move.element);
    const charts = block("charts", this.torque.element, this.reach.element);
    main.replaceChildren(
      block(
        "bench",
        this.bench.element,
        block("middle", this.arm, charts, this.map.element),
        block("side", this.said, this.numbers, this.notes),
      ),
    );
    dragging(this.arm, (event, settled) => {
      const angle = angleAt(this.arm, event);
      if (angle !== undefined) this.#turned(angle, settled);
    });
    onUnits(() => {
      this.#paint();
      this.#mapped(this.#reached);
      this.#place();
    });
  }

  /** @param {string} text a muscle file */
  async #takeSecond(text) {
    await pack(text);
    this.joint.files.file2 = text;
    this.bench.show(this.joint.files);
    this.#ask(true);
  }
  /** @param {string} text a joint file */
  async #takeJoint(text) {
    await pack(text);
    this.joint.files.joint = text;
    this.joint.over = new Set();
    await this.joint.fromFile();
    this.#set();
    this.bench.show(this.joint.files);
    this.#ask(true);
    this.map.run();
  }
  /** @param {number} angle @param {boolean} settled */
  #turned(angle, settled) {
    const { v } = this.joint;
    v.phi = clamp(Math.round(angle), v.low, v.high);
    this.bench.controls.phi.set(v.phi);
    this.#ask(settled);
  }

  #request() {
    return {
      ...this.joint.request(this.#first),
      model: { name: "universal" },
      extrapolate: true,
    };
  }
  /** @param {boolean} settled */
  #ask(settled) {
    const { v } = this.joint;
    this.bench.controls.phi.reach(v.low, v.high);
    this.asks.ask(this.#request(), v, settled);
    if (settled) this.#place();
  }
  #place() {
    muscle.place("joint", this.joint.words());
  }

  /** @param {JointAnswer} answer */
  #take(answer) {
    this.#stale(false);
    this.said.replaceChildren();
    this.notes.replaceChildren(warnings(answer.warnings));
    this.#point = {
      ...answer.points[0],
      model: answer.model,
      words: answer.uncertainty_text,
    };
    this.#paint();
  }
  /** @param {Problem} problem */
  #fail(problem) {
    this.said.replaceChildren(problemBox(problem));
    if (this.#point) this.#stale(true);
    else this.#drawArm();
  }
  /** @param {JointAnswer["map"]} map */
  #mapped(map) {
    this.#reached = map;
    if (map) this.reach.show(reachChart(map));
  }
  /** @param {boolean} on */
  #stale(on) {
    dim([this.arm, this.numbers], on);
  }
  #drawArm() {
    const {
      length_mm: length = 285,
      outer_diameter_mm: diameter = 30,
      angle_deg: angle = 28,
    } = muscle.shown ?? {};
    const { v } = this.joint,
      point = this.#point;
    const drawing = jointDrawing(point, point?.angle_deg ?? v.phi, v.pmax, {
      ...v,
      length,
      diameter,
      angle,
    });
    this.arm.innerHTML = drawing;
  }
  #paint() {
    const point = this.#point;
    const which = this.joint.files.file2
      ? "Muscle 2 is that of its file."
      : "Both muscles are the one above.";
    this.#drawArm();
    if (this.#family) this.torque.show(torqueChart(this.#family, point));
    this.numbers.replaceChildren(...(point ? numbersView(point, which) : []));
  }

  #set() {
    for (const key of KEYS) this.bench.controls[key].set(this.joint.v[key]);
  }

  /** @param {URLSearchParams} params */
  async load(params) {
    await this.joint.read(params);
    await muscle.read(params, [...KEYS, ...FILES, "range"]);
    this.#set();
    this.bench.show(this.joint.files);
    try {
      this.#first = await muscle.file();
    } catch (problem) {
      this.#stale(true);
      return void this.said.replaceChildren(problemBox(problem));
    }
    this.#ask(true);
    this.map.run();
  }
}

/** @type {Mount} */
export const mount = (main) => new JointPage(main);
