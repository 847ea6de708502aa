// From a specification to ranked muscles, with a map of what is feasible and why the rest is not.
import { address, write } from "../address.js";
import { designMap } from "../design-map.js";
import { capital, el, problemBox } from "../dom.js";
import { Figures } from "../figure.js";
import { form, job, table, warnings } from "../form.js";
import { muscle } from "../muscle.js";
import { STIFFNESS_NAMES, candidate, missing } from "../state.js";
import { number, onUnits, show, unitName, withUncertainty } from "../units.js";
import { inWords } from "../words.js";

const OBJECTIVES = /** @type {[string, string][]} */ ([["diameter", "smallest diameter"], ["pressure", "lowest pressure"], ["air", "least air"], ["margin", "largest margin of pull"], ["bulged-diameter", "smallest bulged diameter"], ["length", "shortest"]]);

/** @param {HTMLElement} main */
export function mount(main) {
  /** @type {any} */ let found;
  /** @type {any} */ let asked;
  /** What the answer that is shown was asked by. @type {any} */ let of;
  const fields = form([
    { key: "F", field: "force_n", label: "Pull", kind: "force", value: "700 N" },
    { key: "e", field: "contraction", label: "at a contraction of", kind: "ratio", value: "15 %" },
    { key: "at", field: "points", label: "or several pulls", pair: [["force", "force_n"], ["ratio", "contraction"]], hint: "700N@15%, 1200N@5%" },
    { key: "joint", field: "torques", label: "or torques of a joint", pair: [["torque", "torque_nm"], ["angle", "angle_deg"]], hint: "8Nm@45deg" },
    { key: "load", field: "load", label: "or a load to lift", hint: "mass:20kg" },
    { key: "stroke", field: "stroke_mm", label: "Stroke", kind: "length", hint: "40 mm" },
    { key: "pmax", field: "max_pressure_mpa", label: "Pressure of the supply", kind: "pressure", value: "2.5 bar" },
    { key: "bulge", field: "max_bulged_diameter_mm", label: "Largest bulged diameter", kind: "length", hint: "60 mm" },
    { key: "sure", field: "guaranteed", label: "Guaranteed share", kind: "ratio", hint: "95 %" },
    { key: "for", field: "objective", label: "Rank by", options: OBJECTIVES, value: "diameter" },
  ], () => search.run());
  const choices = form([
    { key: "D", field: "outer_diameter_mm", label: "Outer diameters", kind: "length", list: true, hint: "10..60 mm" },
    { key: "s", field: "wall_mm", label: "Walls", kind: "length", list: true, hint: "1..4:0.5 mm" },
    { key: "L", field: "length_mm", label: "Length", kind: "length", list: true, hint: "285 mm" },
    { key: "angle", field: "angle_deg", label: "Braid angles", kind: "angle", list: true, hint: "28 deg" },
    { key: "rubber", field: "rubbers", label: "Rubbers", words: true, hint: "paper, ecoflex-0030" },
    { key: "braid", field: "braids", label: "Sleeves as sold", words: true, hint: "names of the list" },
    { key: "sd", field: "strand_diameter_mm", label: "Diameter of a strand", kind: "length", hint: "0.25 mm", hidden: true },
    { key: "sE", field: "strand_modulus_mpa", label: "Young's modulus of a strand", kind: "modulus", hint: "2500 MPa", hidden: true },
    { key: "k", field: "stiffness", label: "Stiffness of a strand family", kind: "stiffness", or: STIFFNESS_NAMES, hint: "500 N/mm; inextensible" },
    { key: "r", field: "radius_mm", label: "Pulley of a joint", kind: "length", list: true, hint: "20..40 mm" },
    { key: "burst", field: "min_burst_margin", label: "Burst over supply, at least", kind: "ratio", factor: true, hint: "4" },
  ], () => search.run());
  const spreads = form([
    { key: "ts", field: "wall_mm", label: "Wall ±", kind: "length", hint: "0.1 mm" },
    { key: "tD", field: "outer_diameter_mm", label: "Outer diameter ±", kind: "length", hint: "0.3 mm" },
    { key: "tL", field: "length_mm", label: "Length ±", kind: "length", hint: "2 mm" },
    { key: "ta", field: "angle_deg", label: "Braid angle ±", kind: "angle", hint: "1 deg" },
    { key: "tp", field: "pressure_mpa", label: "Pressure ±", kind: "pressure", hint: "0.1 bar" },
    { key: "tm", field: "modulus", label: "Modulus of the rubber ±", kind: "ratio", hint: "10 %" },
  ], () => search.run());
  const forms = [fields, choices, spreads];
  /** What the sleeves need beside their names has a field. */
  const lacking = () => {
    const k = choices.text("k");
    const names = choices.text("braid").split(",").map((name) => name.trim()).filter(Boolean);
    return [...new Set(names.flatMap((braid) => missing({ said: k ? { braid, k } : { braid } }, muscle.sleeves)))];
  };
  const offer = () => {
    const lacks = lacking();
    for (const key of ["sd", "sE"]) choices.shown(key, lacks.includes(key));
    if (lacks.length) vary.open = true;
  };
  choices.element.addEventListener("input", offer);
  const results = el("div", {});
  const figures = new Figures("design");
  const map = designMap((c, at) => linked(c, at));
  const vary = el("details", {}, el("summary", {}, "Search space"), choices.element);
  const search = job("Design", "design", request, take, (problem) => {
    forms.some((f) => f.at(problem));
    for (const key of lacking()) if (!choices.text(key)) choices.mark(key, "The source of the sleeve does not state it: measure it, or give a stiffness.");
    if (!found) results.replaceChildren(problemBox(problem));
    stale(true);
  });
  /** What is shown belongs to the last specification that had an answer. @param {boolean} on */
  const stale = (on) => [results, ...map.elements, figures.element].forEach((part) => part.classList.toggle("stale", on && Boolean(found)));
  main.replaceChildren(el("div", { class: "bench two" },
    el("section", { class: "controls", "aria-label": "Specification" }, el("h2", {}, "Specification"), fields.element, vary, el("details", {}, el("summary", {}, "Tolerances of the workshop"), spreads.element), search.element),
    el("div", { class: "middle" }, results, ...map.elements, figures.element)));
  results.append(el("p", { class: "soft" }, "State the requirement. The search ranks tubes and sleeves that you can buy or cast, or free diameters and walls where you give them; finite elements compute the final values."));

  async function request() {
    const [wanted, choice, tolerance] = await Promise.all(forms.map((f) => f.read()));
    if (!wanted || !choice || !tolerance) return undefined;
    // An interval without a step is searched as a whole, as on the command line.
    for (const [key, field] of [["D", "outer_diameter_mm"], ["s", "wall_mm"], ["L", "length_mm"], ["angle", "angle_deg"], ["r", "radius_mm"]]) {
      const read = choice[field];
      if (Array.isArray(read) && /^[^:,]+\.\.[^:,]+$/.test(choices.text(key))) choice[field] = { low: read[0], high: read[read.length - 1] };
    }
    // Several points or torques stand in place of the one pull; a load in place of its force.
    if (wanted.points || wanted.torques || wanted.load) delete wanted.force_n;
    if (wanted.points || wanted.torques || (wanted.load && wanted.stroke_mm)) delete wanted.contraction;
    asked = { ...wanted, ...choice, figure: unitName("pressure") };
    if (Object.keys(tolerance).length) asked.tolerance = tolerance;
    write(address("design", Object.assign({}, ...forms.map((f) => f.texts()))));
    return asked;
  }

  /** @param {any} answer */
  function take(answer) {
    found = answer;
    of = asked;
    stale(false);
    paint();
    figures.show(answer.figure);
    map.show(found, of);
  }

  function paint() {
    if (!found) return;
    const best = found.candidates[0];
    const out = [];
    if (best) {
      out.push(el("h2", {}, `Outer diameter ${show("length", best.outer_diameter_mm, 4)}, wall ${show("length", best.wall_mm)}, length ${show("length", best.length_mm)}, braid ${show("angle", best.angle_deg)}`));
      out.push(el("p", {}, `Rubber ${best.rubber}. Required pressure ${show("pressure", best.pressure_mpa, 3)}; pull ${withUncertainty("force", best.points[0].force_n, best.points[0].uncertainty_n)} at ${show("ratio", best.points[0].contraction, 3)}, blocked force ${show("force", best.blocked_force_n)}. ${best.binds ? `Limited by: ${String(best.binds).replaceAll("_", " ")}.` : ""}`));
      out.push(warnings(found.warnings));
      const rows = found.candidates.map((/** @type {any} */ c) => [c.tube ?? "", c.sleeve ?? "", show("length", c.outer_diameter_mm), show("length", c.wall_mm), show("length", c.length_mm), show("angle", c.angle_deg), c.rubber, show("pressure", c.pressure_mpa, 3), `${number(100 * c.margin, 2)} %`, show("length", c.bulged_diameter_mm), c.air_normal_litres ? `${number(c.air_normal_litres, 3)} L` : "–"]);
      out.push(table(["tube", "sleeve", "D0", "s", "L0", "θ0", "rubber", "needs", "to spare", "bulged", "air per stroke"], rows, { text: [0, 1, 6], pick: (i) => open(found.candidates[i]), label: "Muscles that fit, best first" }));
      if (best.joint) out.push(el("p", {}, `Pulley of radius ${show("length", best.joint.radius_mm, 3)}, ${show("ratio", best.joint.contraction_at_neutral, 3)} contracted at the neutral angle.`));
      if (best.points.length > 1) out.push(table(["pull", "at", "needs"], best.points.map((/** @type {any} */ p) => [withUncertainty("force", p.force_n, p.uncertainty_n), show("ratio", p.contraction, 3), show("pressure", p.pressure_mpa, 3)]), { text: [], label: "the operating points" }));
      if (found.tolerance?.length) out.push(table(["within the tolerances, at", "and", "least pull", "largest pull", "likely"], found.tolerance.map((/** @type {any} */ t) => [show("ratio", t.contraction, 3), show("pressure", t.pressure_mpa, 3), show("force", t.low_n), show("force", t.high_n), `± ${show("force", t.likely_n, 2)}`]), { text: [], label: "spread of the pull" }));
      out.push(el("p", { class: "small soft" }, `${found.fitting} of ${found.looked_at} muscles fit; searched with ${found.searched_with}, computed by ${found.model}. Click one to show it.`));
    } else if (found.closest) {
      const c = found.closest;
      out.push(el("h2", {}, "Nothing fits."), el("p", {}, `Closest: D0 ${show("length", c.outer_diameter_mm)}, s ${show("length", c.wall_mm)}${c.sleeve ? ` in ${c.sleeve}` : ""}: ${inWords(c.reason)}.`));
      out.push(warnings(found.warnings));
      if (found.excluded_by_burst) out.push(el("p", {}, `Of ${found.looked_at} muscles ${found.excluded_by_burst} burst too early; ${found.excluded_by_burst_alone} of them meet every other limit.`));
      if (c.hint) out.push(el("p", {}, capital(inWords(c.hint))));
      out.push(el("ul", {}, ...c.relaxations.map((/** @type {any} */ r) => el("li", {}, relaxation(r)))));
    }
    if (found.rejected?.length) out.push(el("details", {}, el("summary", {}, "Why others fail"), table(["D0", "s", "L0", "reason"], found.rejected.map((/** @type {any} */ r) => [show("length", r.outer_diameter_mm), show("length", r.wall_mm), show("length", r.length_mm), inWords(r.reason)]), { text: [3] })));
    results.replaceChildren(...out);
  }

  /** @param {any} r */
  function relaxation(r) {
    const points = (r.points ?? []).map((/** @type {any} */ p) => `${show("force", p.force_n)} at ${show("ratio", p.contraction, 3)}`).join(", ");
    switch (r.relax) {
      case "max_pressure": return `Supply ${show("pressure", r.pressure_mpa, 3)}.`;
      case "force": return `Reduce the pull to ${points}.`;
      case "contraction": return `Reduce the requirement to ${points}.`;
      case "outer_diameter": return `Take a tube of ${show("length", r.outer_diameter_mm)}.`;
      default: return capital(Object.entries(r).map(([k, v]) => (k === "relax" ? String(v).replaceAll("_", " ") : `${k.replaceAll("_", " ")} ${typeof v === "number" ? number(v) : v}`)).join(": ")) + ".";
    }
  }

  /** The address of a muscle of the search: that muscle, and nothing of the one on the page Muscle. @param {any} c @param {{ p: number, e: number }} at */
  function linked(c, at) {
    const before = muscle.state;
    muscle.state = candidate(c, of, at);
    const link = address("muscle", muscle.params());
    muscle.state = before;
    return link;
  }

  /** @param {any} c */
  function open(c) {
    location.hash = linked(c, { p: c.pressure_mpa, e: c.points[0].contraction });
  }

  const off = onUnits(() => { paint(); map.draw(); });
  return {
    /** @param {URLSearchParams} params */
    async load(params) {
      // The muscle's own words mean other things here: a link to a specification has none of its pressure.
      if (params.has("p")) params = new URLSearchParams();
      forms.forEach((f) => f.set(params));
      await muscle.known();
      choices.options("braid", muscle.sleeves.map((s) => s.name));
      offer();
      await search.run();
    },
    unmount() { off(); search.end(); map.end(); },
  };
}
