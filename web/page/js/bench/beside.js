// What stands beside the muscle at its pressure and contraction: one that was held, and another
// model of this one.
import { query } from "../address.js";
import { answerTo } from "../ask.js";
import { KINDS, isobars } from "../chart.js";
import { choice } from "../controls.js";
import { block, button, capital, table } from "../dom.js";
import { fileOf } from "../kept.js";
import { MuscleState, muscle } from "../muscle.js";
import { asBuilt, show, showForce, showPressure, unitsInAddress } from "../units.js";
import { rested, signal, watch } from "../watch.js";
import { RESULTS } from "./sweep.js";

/** @typedef {Commands["force"]["answer"]} Answer */
/** @typedef {{ name: string, point?: Answer, curve?: CurveAnswer }} Other */
const MODELS = [
  "universal",
  "thick-wall",
  "ideal",
  "paper",
  "chou-hannaford",
  "force-balance",
  "tondu-lopez",
];
/** Rows of the numbers. @type {[string, (x: Answer) => string][]} */
const ROWS = [
  ["pull of the model", (x) => (x.slack ? "slack" : showForce(x.force_n))],
  ["as built", asBuilt],
  ["threshold pressure", (x) => showPressure(x.start_pressure_mpa, 3)],
  ...RESULTS.slice(1).map(
    ({ label, kind, of }) =>
      /** @type {typeof ROWS[number]} */ ([label, (x) => show(kind, Number(x[of]), 3)]),
  ),
];
/** After a change it waits so long, in milliseconds. */
const REST = 150;

/** @param {Store} store */
export function besideView(store) {
  /** @type {Signal<MuscleState | undefined>} */ const held = signal(),
    /** @type {Signal<Other[]>} */ others = signal([]),
    formula = fileOf("formula");
  let word = "",
    turn = 0;
  const hold = button(
    "Hold to compare",
    () => store.look({ held: held.value ? "" : query(muscle.params()) }),
    { title: "Keep this muscle beside what is changed next" },
  );
  const model = choice(
    "Another model",
    ["", ...MODELS, ...(formula ? [formula.name] : [])].map((name) => [name, name || "none"]),
    (name) => store.look({ over: name }),
  );
  const numbers = block();

  /** The muscle that is held, as words of an address. */
  async function read() {
    const of = word ? new MuscleState() : undefined;
    await of?.read(new URLSearchParams(`${word}&u=${unitsInAddress()}`));
    held.value = of;
  }
  watch(() => {
    const wanted = store.wanted.value;
    model.set(wanted.over);
    hold.ariaPressed = String(Boolean(wanted.held));
    if (wanted.held === word) return;
    word = wanted.held;
    read();
  });

  /** @param {string} name @param {MuscleState} of @param {string | TextFile} [by] its model */
  async function other(name, of, by) {
    const at = { muscle: of.fields(), model: { name: by }, extrapolate: true },
      { p, e } = muscle,
      nothing = () => undefined;
    const [point, curve] = await Promise.all([
      answerTo("force", { ...at, pressure_mpa: p, contraction: e }).catch(nothing),
      answerTo("curve", { ...at, test: "isobaric", pressures_mpa: [p] }, { lane: "curves" }).catch(
        nothing,
      ),
    ]);
    return { name, point, curve };
  }
  async function ask() {
    const mine = ++turn,
      { over } = store.wanted.value,
      of = held.value;
    const list = await Promise.all([
      ...(of ? [other(`held: ${of.name}`, of)] : []),
      ...(over ? [other(over, muscle, over === formula?.name ? formula : over)] : []),
    ]);
    if (mine === turn) others.value = list;
  }
  const soon = rested(ask, REST);
  watch(() => {
    void [store.wanted.value.over, held.value, muscle.state];
    soon();
  });

  watch(() => {
    const list = others.value,
      /** @type {Answer | undefined} */ now = muscle.assessed,
      points = [now, ...list.map(({ point }) => point)];
    const rows = ROWS.map(([name, of]) => [capital(name), ...points.map((x) => (x ? of(x) : "–"))]);
    const head = ["", "now", ...list.map(({ name }) => name)];
    numbers.replaceChildren(
      list.length ? table(head, rows, { label: "beside it in numbers" }) : "",
    );
  });
  return {
    hold,
    model: model.element,
    numbers,
    /** Their isobars. @returns {Series[]} */
    series: () =>
      others.value.flatMap(({ name, curve }, i) => {
        const look = { name, end: name, colour: KINDS[i + 1], smooth: true };
        return curve ? isobars({ ...look, dash: "dash" }, curve.points) : [];
      }),
  };
}
