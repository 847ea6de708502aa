// The muscle, alive: its measures as sliders, the deformed body, curves, and numbers with their ±.
import { Slot, engine } from "../ask.js";
import { address, write } from "../address.js";
import { Chart, KINDS, isDark, isobar, pressureColour, viridis } from "../chart.js";
import { choice, fileField, onDrop, quantity } from "../controls.js";
import { capital, download, el, problemBox, say, tabs } from "../dom.js";
import { gauge } from "../gauge.js";
import { muscle } from "../muscle.js";
import { CONTRACTION, ENDS, LOAD, MORE, PRESSURE, QUANTITIES, STIFFNESS, STRANDS, about, point as pointOf } from "../state.js";
import { inside, number, onUnits, outside, show, unitName, withUncertainty } from "../units.js";
import { inWords } from "../words.js";
import { View, reach } from "../view3d.js";

const TESTS = /** @type {[string, string][]} */ ([["isobaric", "Isobaric"], ["isometric", "Isometric"], ["isotonic", "Isotonic"], ["along", "Along the muscle"]]);
/** What colours the muscle: field, name, kind of its unit. */
const SHOWN = /** @type {[string, string, string][]} */ ([
  ["max_stretch", "Largest stretch", ""], ["hoop_stretch", "Hoop stretch", ""], ["stress_hoop_mpa", "Hoop stress", "pressure"], ["stress_axial_mpa", "Axial stress", "pressure"],
  ["strand_tension_n_per_mm", "Tension of the strands per width", "N/mm"], ["strand_tension_n", "Tension of a strand", "force"], ["strand_angle_deg", "Angle of the strands", "angle"],
]);
/** Tables of the muscle file as the page calls them. @type {Record<string, string>} */
const GROUPS = { tube: "Tube", braid: "Braid", terminals: "Ends", friction: "Friction" };
const ORDER = Object.keys(GROUPS);
const OVERLAYS = ["universal", "thick-wall", "ideal", "paper"];
const OWN = ["test", "show", "cut", "over"];

/** @param {HTMLElement} main */
export function mount(main) {
  const wanted = { test: "isobaric", show: "max_stretch", cut: "", over: "" };
  /** @type {any} */ let shape;
  /** @type {any} */ let point;
  /** @type {any} */ let facts;
  let pumping = 0;

  // Controls.
  const controls = /** @type {Record<string, ReturnType<typeof quantity>>} */ ({});
  const make = (/** @type {import("../state.js").Measure} */ spec) => {
    controls[spec.key] = quantity({ ...spec, value: muscle.value(spec.key), clears: Boolean(spec.group), change: (/** @type {number | undefined} */ value, /** @type {boolean} */ settled) => changed(spec.key, value, settled) });
    return controls[spec.key].element;
  };
  const rubber = choice("Rubber", [["", ""]], "", (name) => changed("rubber", name, true));
  const braid = choice("Braid", [["", ""]], "", (name) => changed("braid", name, true));
  const strands = choice("Strands", [["", ""], ["inextensible", "inextensible"], ["paper", "paper's braid"], ["k", "of this stiffness"]], "", (name) => changed("k", name === "k" ? Math.round(facts?.stiffness_n_per_mm ?? 300) : name, true));
  const held = choice("Held", [["e", "contraction"], ["F", "load"]], "e", (what) => changed("F", what === "F" ? Math.max(1, Math.round(point?.force_n ?? 100)) : undefined, true));
  /** What a named sleeve needs is beside it. */
  const needed = el("div", {});
  const groups = [...new Set(MORE.map(({ group = "" }) => group))].sort((a, b) => ORDER.indexOf(a) - ORDER.indexOf(b));
  const more = el("details", {}, el("summary", {}, "More measures"), ...groups.map((group) => el("fieldset", {}, el("legend", {}, GROUPS[group] ?? capital(group)), ...MORE.filter((m) => m.group === group).map((m) => el("div", {}, make(m))))));
  const homes = new Map(STRANDS.map(({ key }) => [key, /** @type {HTMLElement} */ (controls[key].element.parentElement)]));
  const fileName = el("p", { class: "small soft" });
  const built = el("div", { class: "small", "aria-live": "polite" });
  const controlsBox = el("section", { class: "controls", "aria-label": "Muscle" },
    el("fieldset", { class: "state" }, el("legend", {}, "State"), make(PRESSURE), held.element, make(CONTRACTION), make(LOAD)),
    el("fieldset", {}, el("legend", {}, "Tube and braid"), ...QUANTITIES.map(make), rubber.element, braid.element, strands.element, make(STIFFNESS), needed),
    el("details", {}, el("summary", {}, "Ends"), ...ENDS.map(make)),
    more,
    el("details", {}, el("summary", {}, "Muscle file"), fileName, fileField("Open a muscle file (TOML)", ".toml", takeFile),
      el("p", { style: "margin-top:8px" }, el("button", { type: "button", onclick: save }, "Download this muscle"))),
    el("p", { class: "row" }, el("button", { type: "button", onclick: build }, "Build it")), built);

  // The muscle in space.
  const busy = el("div", { class: "busy" });
  const stageSay = el("p", { class: "say" }), scale = el("div", { class: "bar" }), legend = el("div", { class: "legend" });
  const hint = "Drag to turn; drag the right end to contract; Ctrl and wheel to zoom; double-click to reset";
  const stage = el("div", { class: "stage", title: hint }, stageSay, scale, legend, busy);
  let dragged = /** @type {number | undefined} */ (undefined);
  const view = new View(stage, { drawn: paintScale, contract(share, settled) {
    const from = (dragged ??= Number(shape.shape_contraction));
    const to = Math.min(0.9, Math.max(-0.1, Math.round(1000 * (from + share)) / 1000));
    if (settled) dragged = undefined;
    changed("e", to, settled);
  } });
  const dial = gauge(stage, (pressure, settled) => changed("p", pressure, settled));
  const colour = choice("Colour", SHOWN.map(([name, text]) => [name, text]), wanted.show, (name) => { wanted.show = name; paint(); settle(); });
  const cut = el("button", { type: "button", "aria-pressed": false, onclick: () => { wanted.cut = wanted.cut ? "" : "1"; paint(); settle(); } }, "Cut open");
  const pump = el("button", { type: "button", onclick: startPump }, "Pump");
  const stageTools = el("div", { class: "row" }, colour.element, cut, pump);

  // Charts.
  const over = el("div", { class: "row small" }, ...OVERLAYS.map((name, i) => {
    const box = el("input", { type: "checkbox", id: `over-${name}`, onchange: () => { wanted.over = [...over.querySelectorAll("input")].filter((x) => x.checked).map((x) => x.id.slice(5)).join(","); curves(); settle(); } });
    return el("label", { for: `over-${name}` }, box, ` ${name} `, el("i", { style: `display:inline-block;width:16px;border-top:2px dashed ${KINDS[i + 1]};vertical-align:middle` }));
  }));
  const tests = tabs("Curves", TESTS, wanted.test, (name) => { wanted.test = name; drawCurves(); curves(); settle(); });
  const chart = new Chart("muscle-curves", { tools: tests.list, drag(x, _, settled) {
    if (wanted.test === "isobaric") { changed("e", Math.max(0, Math.round(x * 10) / 1000), settled); }
    if (wanted.test === "isometric" || wanted.test === "isotonic") changed("p", Math.max(0, Math.round((x / outside("pressure", 1)) * 1000) / 1000), settled);
  } });

  const numbers = el("section", { class: "numbers", "aria-label": "Numbers" });
  const meterBox = el("div", {}), notes = el("ul", { class: "warnings" }), parts = el("p", { class: "small soft" });
  /** @type {HTMLElement[]} */ const values = [];
  let noted = "";
  const said = el("div", {});
  main.replaceChildren(el("div", { class: "bench" }, controlsBox, el("div", { class: "middle" }, stage, stageTools, chart.element, el("div", { class: "row small" }, el("span", { class: "soft" }, "Other models at this pressure:"), over)), el("div", { class: "side" }, said, numbers)));
  onDrop(main, (file) => { if (file?.name.endsWith(".toml")) file.text().then((text) => takeFile(file.name, text)); });

  // Questions: the state first, then curves, then what is slow.
  const stateSlot = new Slot({ lane: "state", busy: (on) => busy.classList.toggle("on", on) });
  const factSlot = new Slot(), startSlot = new Slot(), curveSlot = new Slot({ lane: "curves" }), overSlot = new Slot({ lane: "curves" });
  const slots = [stateSlot, factSlot, startSlot, curveSlot, overSlot];
  const settleTimer = { id: 0 };
  let curveTimer = 0, startTimer = 0;

  /** @param {string} key @param {any} value @param {boolean} settled */
  function changed(key, value, settled) {
    stopPump();
    built.replaceChildren();
    muscle.set(key, value);
    sync();
    ask();
    if (settled) { settle(); follow(); }
    else { clearTimeout(settleTimer.id); settleTimer.id = window.setTimeout(follow, 120); }
  }

  function settle() {
    write(address("muscle", { ...muscle.params(), test: wanted.test === "isobaric" ? "" : wanted.test, show: wanted.show === "max_stretch" ? "" : wanted.show, cut: wanted.cut, over: wanted.over }));
  }

  /** What is shown belongs to the last muscle that had an answer. @param {boolean} on */
  const stale = (on) => [stage, numbers, chart.element].forEach((part) => part.classList.toggle("stale", on));

  /** The point and its shape. @param {number} [pressure] */
  function ask(pressure) {
    const { state } = muscle, at = pointOf(state);
    stateSlot.ask("shape", { ...muscle.fields(), ...at, pressure_mpa: pressure ?? at.pressure_mpa }, (answer) => {
      shape = point = answer;
      if (muscle.state === state) {
        muscle.shown = { ...muscle.shown, ...answer.muscle };
        if (state.F !== undefined) {
          muscle.state = { ...state, e: answer.contraction };
          clearTimeout(startTimer);
          startTimer = window.setTimeout(starts, 120);
        }
        sync();
      }
      said.replaceChildren();
      stale(false);
      Object.values(controls).forEach((c) => c.mark(""));
      paint();
      paintNumbers();
      if (wanted.test === "along") drawCurves();
      else mark();
      if (pressure === undefined) say(`Pull ${withUncertainty("force", answer.force_n, answer.uncertainty_n)}`);
    }, (problem) => {
      const lacks = muscle.missing().filter((key) => state.said[key] === undefined);
      const key = about(problem);
      Object.values(controls).forEach((c) => c.mark(""));
      if (lacks.length) lacks.forEach((key) => controls[key].mark(`The source of ${state.said.braid} does not state it: measure it, or select a stiffness.`));
      else if (key) { controls[key].mark(problem.message); reveal(key); }
      said.replaceChildren(problemBox(problem), shape ? el("p", { class: "small soft" }, "The page shows the last result, which is for another muscle or state.") : "", problem.kind === "engine" ? el("button", { type: "button", class: "main", onclick: () => ask() }, "Try again") : "");
      stale(true);
      point = undefined;
      mark();
    });
    if (pressure === undefined) soon();
  }

  /** Curves, at most ten times a second, and where drawing them takes most of a frame once the hand rests: the muscle comes first. */
  function soon() {
    if (chart.cost > 6) clearTimeout(curveTimer);
    else if (curveTimer) return;
    curveTimer = window.setTimeout(() => { curveTimer = 0; curves(); }, 100);
  }

  /** What comes after: P′, and what the muscle does at this pressure. */
  function follow() {
    const { state } = muscle;
    factSlot.ask("muscle-show", { ...muscle.fields(), pressure_mpa: state.p }, (answer) => {
      facts = { ...answer, start: facts?.start, said: facts?.said };
      if (muscle.state.said === state.said) { muscle.shown = answer; sync(); }
      paintNumbers();
      const free = answer.characteristics?.free_contraction;
      if (free) controls.e.reach(0, Math.max(0.1, Math.ceil(free * 22) / 20));
      controls.F.reach(0, Math.max(10, niceUp(answer.characteristics?.blocked_force_n ?? 1000)));
    }, () => {});
    // Of a load the contraction is known with its shape.
    if (state.F === undefined) starts();
  }

  /** P′, at the contraction of the state, and what `force` has to say of it: whether it bursts takes more than a shape. */
  function starts() {
    const { state } = muscle;
    startSlot.ask("force", { ...muscle.fields(), pressure_mpa: state.p, contraction: state.e }, (answer) => { facts = { ...facts, start: answer.start_pressure_mpa, said: { state, warnings: answer.warnings, words: answer.uncertainty_words } }; paintNumbers(); }, () => { facts = { ...facts, start: undefined }; });
  }

  // Curves: five pressures up to a round one above this, and the state's own.
  /** @type {{ test: string, answer: any, top: number } | undefined} */ let family;
  let familyKey = "", legendKey = "", scaled = 0;
  /** @type {any[]} */ let overlays = [];

  function curves() {
    const test = /** @type {"isobaric" | "isometric" | "isotonic" | "along"} */ (wanted.test);
    if (test === "along") return drawCurves();
    const shown = outside("pressure", Math.max(muscle.p, 0.02)), step = niceUp(shown / 5), fields = muscle.fields();
    const steps = Math.ceil(shown / step - 1e-9), top = inside("pressure", steps * step);
    const pressures = Array.from({ length: steps }, (_, i) => inside("pressure", Number(((i + 1) * step).toPrecision(12))));
    const along = [...Array(13).keys()].map((i) => (i * top) / 12);
    const request = test === "isobaric" ? { pressures_mpa: pressures, contractions: reachOf() }
      : test === "isometric" ? { contractions: [0, 0.05, 0.1, 0.15, 0.2], pressures_mpa: along }
      : { forces_n: [0.1, 0.3, 0.5, 0.7].map((x) => Math.max(1, roundTo(x * (facts?.characteristics?.blocked_force_n ?? 500)))), pressures_mpa: along.slice(1) };
    // Along a family only the mark moves: nothing is asked or drawn anew.
    const key = JSON.stringify([test, fields, request]);
    if (key !== familyKey) {
      familyKey = key;
      curveSlot.ask("curve", { test, ...fields, ...request }, (answer) => { family = { test, answer, top }; drawCurves(); }, () => { familyKey = ""; });
    }
    const names = wanted.over.split(",").filter(Boolean);
    if (!names.length || test !== "isobaric") { overlays = []; return; }
    const found = /** @type {any[]} */ ([]);
    const next = (/** @type {string[]} */ rest) => {
      if (!rest.length) { overlays = found; return drawCurves(); }
      const done = (/** @type {any} */ answer) => { if (answer) found.push(answer); next(rest.slice(1)); };
      overSlot.ask("curve", { test, ...fields, model: rest[0], extrapolate: true, pressures_mpa: [muscle.p], contractions: reachOf() }, done, () => done(undefined));
    };
    next(names);
  }

  function reachOf() {
    const end = Math.max(0.1, (facts?.characteristics?.free_contraction ?? 0.28) * 1.08);
    return [...Array(13).keys()].map((i) => Math.round((i * end * 1e4) / 12) / 1e4);
  }

  function drawCurves() {
    const { test } = wanted;
    over.hidden = test !== "isobaric";
    if (test === "along") return drawAlong();
    if (!family || family.test !== test) return;
    const { answer, top } = family;
    const count = answer.points.length / answer.fixed.length;
    const isobaric = test === "isobaric", isotonic = test === "isotonic";
    const fu = unitName("force"), pu = unitName("pressure");
    const series = answer.fixed.map((/** @type {number} */ fixed, /** @type {number} */ i) => {
      const points = answer.points.slice(i * count, (i + 1) * count);
      const name = isobaric ? show("pressure", fixed, 3) : isotonic ? show("force", fixed, 3) : show("ratio", fixed, 3);
      return {
        name, end: name, at: isobaric ? "start" : "end",
        colour: isobaric ? pressureColour(fixed, top) : (isDark() ? viridis(0.3 + (0.7 * i) / answer.fixed.length, 1) : viridis(i / answer.fixed.length)),
        ...(isobaric ? isobar(points) : {
          x: points.map((/** @type {any} */ q) => outside("pressure", q.pressure_mpa)),
          y: points.map((/** @type {any} */ q) => (q.status === "ok" ? (isotonic ? 100 * q.contraction : outside("force", q.force_n)) : null)),
        }),
      };
    });
    overlays.forEach((o) => series.push({ name: `${o.model} at ${show("pressure", o.fixed[0], 3)}`, dash: "dash", colour: KINDS[OVERLAYS.indexOf(o.model) + 1] ?? KINDS[6], ...isobar(o.points) }));
    chart.show({ x: isobaric ? "contraction ε [%]" : `pressure p [${pu}]`, y: isotonic ? "contraction ε [%]" : `pull F [${fu}]`, series });
    mark();
  }

  function mark() {
    if (!point || wanted.test === "along") return chart.mark();
    const [pull, pressure, contraction] = [outside("force", point.force_n), outside("pressure", point.pressure_mpa), 100 * point.contraction];
    chart.mark(...(wanted.test === "isobaric" ? /** @type {const} */ ([contraction, pull]) : /** @type {const} */ ([pressure, wanted.test === "isotonic" ? contraction : pull])));
  }

  function drawAlong() {
    if (!shape) return;
    const { arrays, stations, across } = shape;
    const z = mirror((j) => outside("length", arrays.z_mm[j * across + across - 1]), -1);
    const r = mirror((j) => outside("length", arrays.r_mm[j * across + across - 1]), 1);
    const inner = mirror((j) => outside("length", arrays.r_mm[j * across]), 1);
    const angle = mirror((j) => arrays.strand_angle_deg[j], 1);
    function mirror(/** @type {(j: number) => number} */ at, /** @type {number} */ sign) {
      const half = [...Array(stations).keys()].map(at);
      return [...half.slice(1).reverse().map((x) => sign * x), ...half];
    }
    const lu = unitName("length");
    chart.show({ x: `z from the middle [${lu}]`, y: `radius [${lu}], strand angle [°]`, series: [
      { name: "outer radius", end: "outer", x: z, y: r, colour: KINDS[0] }, { name: "inner radius", end: "inner", x: z, y: inner, colour: KINDS[5] }, { name: "strand angle", end: "angle", x: z, y: angle, colour: KINDS[1], dash: "dot" },
    ] });
  }

  function paint() {
    if (!shape) return;
    const [name, words, kind] = SHOWN.find(([f]) => f === wanted.show && shape.arrays[f]) ?? SHOWN[0];
    colour.set(name);
    cut.setAttribute("aria-pressed", String(Boolean(wanted.cut)));
    view.cut = Boolean(wanted.cut);
    const [low, high] = reach(shape.arrays[name]);
    view.set(shape, { field: name, low, high, restLength: shape.muscle.length_mm, restRadius: shape.muscle.outer_diameter_mm / 2 });
    if (!point) return;
    const end = (/** @type {number} */ x) => (kind === "N/mm" ? `${number(x, 3)} N/mm` : kind ? show(kind, x, 3) : number(x, 3));
    const ramp = Array.from({ length: 9 }, (_, i) => viridis(i / 8, 1)).join(",");
    const key = `${words} ${end(low)} ${end(high)}`;
    if (key !== legendKey) legend.replaceChildren(el("span", {}, words), el("i", { style: `background:linear-gradient(90deg,${ramp})` }), el("span", {}, el("b", {}, end(low)), el("b", {}, end(high))));
    legendKey = key;
    const sayIt = point.slack ? [el("b", {}, "Slack"), el("br"), `The muscle is slack: contracted by ${show("ratio", shape.shape_contraction, 3)}, no pull.`]
      : [el("b", {}, withUncertainty("force", point.force_n, point.uncertainty_n)), el("br"), `at ${show("pressure", point.pressure_mpa, 3)} and ${show("ratio", point.contraction, 3)}`];
    stageSay.replaceChildren(...sayIt);
    dial.set(point.pressure_mpa, Math.max(PRESSURE.high, point.pressure_mpa));
  }

  /** As long as it says at every zoom. */
  function paintScale() {
    const perPixel = view.millimetresPerPixel;
    if (!shape || perPixel === scaled) return;
    scaled = perPixel;
    const step = niceUp(80 * perPixel * 0.6);
    scale.replaceChildren(el("span", { style: `display:block;border:1px solid currentColor;border-top:0;height:5px;width:${step / perPixel}px` }), show("length", step, 3));
  }

  function paintNumbers() {
    if (!point) return;
    const c = facts?.characteristics;
    const rows = /** @type {[string, string][]} */ ([
      ["stiffness", point.stiffness_n_per_mm === undefined ? "–" : `${number(point.stiffness_n_per_mm, 3)} N/mm`],
      ["contraction", show("ratio", point.contraction, 3)],
      ["bulged diameter", show("length", point.bulged_diameter_mm)],
      ["cavity", point.volume_mm3 === undefined || point.volume_mm3 === null ? "–" : `${number(point.volume_mm3 / 1e3, 3)} cm³`],
      ["starts at", show("pressure", facts?.start, 3)],
      ["blocked force", show("force", c?.blocked_force_n)],
      ["free contraction", show("ratio", c?.free_contraction, 3)],
      ["bursts at", c?.burst_pressure_mpa ? show("pressure", c.burst_pressure_mpa, 3) : "not known"],
      ["allowed", c?.allowed_pressure_mpa ? show("pressure", c.allowed_pressure_mpa, 3) : "not known"],
      ["work to there", c?.work_j ? `${number(c.work_j, 3)} J` : "–"],
      ["air to there", c?.air_normal_litres ? `${number(c.air_normal_litres, 3)} normal L` : "–"],
    ]);
    rows.unshift(["pull", point.slack ? "slack" : withUncertainty("force", point.force_n, point.uncertainty_n)]);
    if (!values.length) {
      const list = el("dl", {}, ...rows.flatMap(([name], i) => { values.push(el("dd", { class: i ? undefined : "head" })); return [el("dt", { class: i ? undefined : "head" }, name), values[i]]; }));
      numbers.replaceChildren(list, meterBox, notes, parts, el("p", { class: "small soft" }, `Model ${point.model}; ± covers 95 % against a measured muscle. ${engine().about}.`));
    }
    rows.forEach(([, value], i) => { if (values[i].textContent !== value) values[i].textContent = value; });
    const meters = [
      meter("stretch of the rubber", point.max_stretch, facts?.fitted_to_stretch, (x) => number(x, 3), 1),
      meter("pull", point.force_n, c?.blocked_force_n, (x) => show("force", x, 3)),
      meter("contraction", point.contraction, c?.free_contraction, (x) => show("ratio", x, 3)),
    ];
    meterBox.replaceChildren(...meters.filter((m) => m !== null));
    const words = facts?.said?.state === muscle.state ? facts.said.words : undefined;
    parts.textContent = [words?.text, words?.bench].filter(Boolean).map((/** @type {string} */ text) => `${inWords(text)}.`).join(" ");
    const warned = new Set([...(facts?.said?.state === muscle.state ? facts.said.warnings : []), ...(point.warnings ?? [])]);
    const said = [...[...warned].map((/** @type {string} */ w) => capital(inWords(w))), ...muscle.wrong.values(), ...(muscle.unknown.length ? [`Not understood in the address: ${muscle.unknown.map(([k]) => k).join(", ")}`] : [])];
    if (said.join() !== noted) {
      noted = said.join();
      notes.replaceChildren(...said.map((w) => el("li", {}, w)));
    }
  }

  /** A share of a limit as a bar. @param {string} name @param {number | undefined | null} value @param {number | undefined | null} limit @param {(x: number) => string} text */
  function meter(name, value, limit, text, from = 0) {
    if (value === undefined || value === null || limit === undefined || limit === null || limit <= from) return null;
    const share = (value - from) / (limit - from);
    return el("div", { class: share > 1 ? "meter over" : "meter" }, el("span", {}, name, el("span", {}, `${text(value)} of ${text(limit)}`)), el("i", {}, el("b", { style: `width:${Math.min(100, Math.max(0, 100 * share)).toFixed(1)}%` })));
  }

  /** Opens what holds a control. @param {string} key */
  function reveal(key) {
    const box = controls[key]?.element.closest("details");
    if (box) box.open = true;
  }

  /** Opens what holds a measure that the address or the file states. */
  function revealAll() {
    const { file, said } = muscle.state;
    const stated = (/** @type {string} */ key) => said[key] !== undefined || muscle.wrong.has(key) || (file && muscle.value(key) !== undefined);
    [...ENDS, ...MORE].filter(({ key }) => stated(key)).forEach(({ key }) => reveal(key));
  }

  /** @param {string} _name @param {string} text */
  async function takeFile(_name, text) {
    try {
      await muscle.take(text);
      sync();
      revealAll();
      ask();
      follow();
      settle();
    } catch (problem) {
      said.replaceChildren(problemBox(problem));
    }
  }

  async function save() {
    try {
      download("muscle.toml", await muscle.file(), "application/toml");
    } catch (problem) {
      said.replaceChildren(problemBox(problem));
    }
  }

  /** Drawing, plugs, steps and test sheet of this muscle at this pressure, as a list of downloads. */
  async function build() {
    built.replaceChildren(el("p", { class: "soft" }, "…"));
    try {
      const answer = await engine().ask("build", { ...muscle.fields(), ...(muscle.p > 0 ? { pressure_mpa: muscle.p } : {}) }, { lane: "side" });
      const items = answer.files.map((/** @type {any} */ file) => {
        const content = file.text ?? Uint8Array.from(atob(file.base64), (c) => c.charCodeAt(0));
        return el("li", {}, el("button", { type: "button", onclick: () => download(file.name, content, "application/octet-stream") }, file.name), ` ${file.about}`);
      });
      const notes = answer.warnings.map((/** @type {string} */ w) => el("li", {}, capital(inWords(w))));
      built.replaceChildren(el("p", {}, `At ${show("pressure", answer.pressure_mpa, 3)}: cut ${show("length", answer.cut.tube_mm)} of tube. Proof test with water at ${show("pressure", answer.proof_pressure_mpa, 3)}.`),
        el("ul", { class: "warnings" }, ...notes), el("ul", { style: "list-style:none;padding:0" }, ...items));
    } catch (problem) {
      built.replaceChildren(problemBox(problem));
    }
  }

  function startPump() {
    if (pumping) return stopPump();
    const to = muscle.p, began = performance.now();
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    pump.textContent = "Stop";
    const step = () => {
      const share = Math.min(1, (performance.now() - began) / 2000);
      // Three stills where motion is not wanted.
      ask(to * (still ? Math.ceil(share * 3) / 3 : share));
      if (share < 1) pumping = still ? window.setTimeout(step, 660) : requestAnimationFrame(step);
      else stopPump();
    };
    pumping = 1;
    step();
  }

  function stopPump() {
    if (!pumping) return;
    cancelAnimationFrame(pumping);
    clearTimeout(pumping);
    pumping = 0;
    pump.textContent = "Pump";
  }

  /** Every control as file, address and engine have it. */
  function sync() {
    const { file, said, F } = muscle.state, { shown } = muscle;
    for (const key of Object.keys(controls)) controls[key].set(muscle.value(key));
    for (const [key, message] of muscle.wrong) controls[key]?.mark(message);
    const own = file ? "as in the file" : "";
    rubber.first(own || "paper (default)");
    braid.first(own || "its own angle");
    strands.first(said.braid ? "of the sleeve" : STRANDS.some(({ key }) => said[key] !== undefined) || said.strand_area_mm2 !== undefined ? "of its strands" : own || "paper's braid (default)");
    rubber.set(String(said.rubber ?? ""));
    braid.set(String(said.braid ?? ""));
    strands.set(typeof said.k === "number" ? "k" : String(said.k ?? ""));
    fileName.textContent = file ? `Open: D0 ${show("length", shown?.outer_diameter_mm)}, ${shown?.rubber ?? ""}, ${shown?.braid ?? ""}${Object.keys(said).length ? "; changed here" : ""}` : "";
    held.set(F === undefined ? "e" : "F");
    controls.F.element.hidden = F === undefined;
    controls.e.element.hidden = F !== undefined;
    // A named sleeve has its angle, and may need to be said what its strands are.
    controls.angle.enable(!(said.braid ?? shown?.sleeve) || said.angle !== undefined);
    controls.k.element.hidden = typeof said.k !== "number";
    const lacks = muscle.missing();
    for (const [key, home] of homes) {
      const place = lacks.includes(key) ? needed : home;
      if (controls[key].element.parentElement !== place) place.append(controls[key].element);
    }
  }

  engine().ask("rubber-list", {}).then((answer) => rubber.options(answer.rubbers.map((/** @type {any} */ r) => r.name)), () => {});
  const offUnits = onUnits(() => { scaled = 0; paint(); paintScale(); paintNumbers(); drawCurves(); settle(); });

  return {
    /** @param {URLSearchParams} params */
    async load(params) {
      await muscle.read(params, OWN);
      braid.options(muscle.sleeves.map((s) => s.name));
      Object.assign(wanted, { test: params.get("test") ?? "isobaric", show: params.get("show") ?? "max_stretch", cut: params.get("cut") ?? "", over: params.get("over") ?? "" });
      tests.list.querySelectorAll("button").forEach((b) => b.setAttribute("aria-selected", String(b.dataset.name === wanted.test)));
      over.querySelectorAll("input").forEach((box) => { box.checked = wanted.over.split(",").includes(box.id.slice(5)); });
      sync();
      revealAll();
      ask();
      follow();
    },
    unmount() { offUnits(); stopPump(); [curveTimer, startTimer, settleTimer.id].forEach(clearTimeout); slots.forEach((slot) => slot.end()); },
  };
}

/** The next of 1, 2, 2.5, 5 times a power of ten. @param {number} x */
function niceUp(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  return power * ([1, 2, 2.5, 5, 10].find((m) => m * power >= x * 0.999) ?? 10);
}
/** @param {number} x */
const roundTo = (x) => Number(x.toPrecision(2));
