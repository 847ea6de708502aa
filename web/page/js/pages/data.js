// Measured points: seen over the models, and constants identified from them.
import { Slot } from "../ask.js";
import { pointSeries } from "../bench/points.js";
import { shade } from "../chart.js";
import { columnLine, grid } from "../columns.js";
import { TABLES, fileField } from "../controls.js";
import {
  bench,
  block,
  button,
  capital,
  dim,
  faded,
  folded,
  heading,
  paragraph,
  problemBox,
  remark,
  rowOf,
  table,
  warnings,
} from "../dom.js";
import { Figures } from "../figure.js";
import { fieldsOf, form, job } from "../form.js";
import { GALLERY, gallery, library, muscleButtons } from "../gallery.js";
import { fileOf, keepFile, keepWords, measured } from "../kept.js";
import { muscle } from "../muscle.js";
import { MEASURES } from "../state.js";
import {
  keyed,
  number,
  outside,
  plusMinus,
  ratioAxis,
  showForce,
  showPressure,
  unitName,
  worded,
} from "../units.js";
import { signal, untracked, watch } from "../watch.js";

const CONSTANTS = "constants";

/**
 * Constants with their ±, and what to do with them. @param {Commands["identify"]["answer"]} answer
 */
function identifiedView(answer) {
  const row = (/** @type {typeof answer.parameters[number]} */ p) => {
    const kind = MEASURES.find(({ filed }) => filed === p.name)?.kind,
      half = p.half_width_95,
      scale = kind ? outside(kind, 1) : 1,
      unit = kind ? unitName(kind) : (p.unit ?? "");
    // As many digits as the ± leaves.
    const value = half
      ? plusMinus(p.value * scale, half * scale, unit)
      : `${number(p.value * scale, 5)} ${unit}`;
    return [capital(worded(p.name)), value.trim()];
  };
  const list = (/** @type {boolean} */ told) =>
    answer.parameters.filter((p) => p.identifiable === told).map(row);
  const head = ["constant", "value (95 %)"],
    open = list(false);
  return [
    heading("Identified"),
    table(head, list(true), { label: "constants" }),
    open.length
      ? folded(
          "Not determined by these points",
          table(head, open, { label: "constants that are not determined" }),
        )
      : "",
    paragraph(
      `Residuals ${showForce(answer.rms_n, 3)} rms, ${showForce(answer.rms_before_n, 3)} before.`,
    ),
    warnings(answer.warnings),
    muscleButtons(answer.muscle_file, "See it move", "Download the muscle", "identified"),
  ];
}

/** Errors of the models. @param {Commands["compare"]["answer"]["models"]} models */
const errorTable = (models) => {
  const force = (/** @type {number | null | undefined} */ f) => showForce(f, 3);
  const rows = models.map((m) => [
    m.model,
    force(m.rms_n),
    force(m.max_n),
    force(m.mean_n),
    String(m.points),
  ]);
  return table(["model", "rms", "largest", "mean", "points"], rows, {
    label: "errors of the models",
  });
};

/** What is asked of the table. @type {Field[]} */
export const FIELDS = fieldsOf([
  ["free", "free", "Free constants", { words: true, hint: "shear modulus" }],
  ["models", "models", "Models", { words: true, value: "fe, thick-wall, ideal" }],
]);

/** @type {Mount} */
export const mount = (main) => {
  /** @type {Signal<Commands["compare"]["answer"] | undefined>} */ const compared = signal(),
    /** @type {Signal<Commands["identify"]["answer"] | undefined>} */ known = signal();
  const looking = new Slot(),
    reading = new Slot();
  const what = form(FIELDS, look),
    take = (/** @type {string} */ name, /** @type {string} */ text) => measured.set({ name, text }),
    cells = grid(["pressure [bar]", "contraction [%]", "pull [N]", "branch"], (text) =>
      take(measured.file?.name ?? "typed.csv", text),
    );
  const understood = block(),
    errors = block(),
    found = block(),
    figures = new Figures("data"),
    fitted = new Figures("identified");
  const fail = (/** @type {unknown} */ why) => understood.replaceChildren(problemBox(why));
  /** What is shown of the comparison belongs to an older table. @param {boolean} on */
  const stale = (on) => dim([errors, figures.element], on);
  const identify = job(
    "Identify",
    "identify",
    async () => {
      const read = await what.read(),
        data = measured.file;
      if (data && read)
        return {
          muscle: muscle.fields(),
          data: [data],
          free: (read.free ?? []).map(keyed),
          figure: unitName("pressure"),
        };
      found.replaceChildren(faded("Open a table first."));
    },
    (answer) => {
      known.value = answer;
      keepFile(CONSTANTS, true);
    },
    // What the comparison says of the table is said.
    { fields: { at: () => understood.querySelector(".problem") }, shown: [found, fitted.element] },
  );
  main.replaceChildren(
    bench(
      "Data",
      [
        heading("Measured points"),
        fileField("Open a table (CSV, XLSX, ODS)", TABLES, take),
        remark("Pressures, contractions (or lengths) and pulls, with their units in the heading."),
        cells.element,
        folded("Advanced", what.element, rowOf(button("Compare", look))),
        identify.element,
      ],
      [understood, errors, figures.element, found, fitted.element],
    ),
  );

  async function look() {
    const read = await what.read(),
      data = measured.file;
    if (!data || !read || !understood.isConnected) return;
    keepWords("data", what.texts());
    const of = { muscle: muscle.fields(), data: [data] };
    looking.ask(
      "compare",
      { ...of, models: read.models, extrapolate: true, figure: unitName("pressure") },
      (answer) => {
        compared.value = answer;
        stale(false);
        figures.show(answer.figure);
        reading.ask("identify", { ...of, free: ["modulus"] }, colour);
      },
      (why) => {
        fail(why);
        if (why.kind === "data") cells.element.open = true;
        stale(true);
      },
    );
  }

  /**
   * Pulls over contraction have the colour of their pressure and the sign of their branch.
   * @param {Commands["identify"]["answer"]} answer
   */
  function colour({ points }) {
    const [chart] = figures.charts,
      spec = chart?.spec;
    if (spec?.x !== ratioAxis) return;
    const list = points.filter((q) => q.measured === "force"),
      top = Math.max(...list.map((q) => q.pressure_mpa)),
      lines = spec.series.filter((s) => s.mode !== "markers"),
      colours = new Map(list.map(({ pressure_mpa: p }) => [showPressure(p, 3), shade(p / top)]));
    // The lines that are named have it too, and their bands.
    const named = lines.flatMap(({ end }) => (end ? colours.get(end) : [])),
      ofBands = [...named];
    const tinted = lines.map((s) => ({
      ...s,
      colour: (s.band ? ofBands : s.end ? named : []).shift() ?? s.colour,
    }));
    chart.show({ ...spec, series: [...tinted, ...pointSeries(list, top)] });
  }

  /** The table for which there are constants. @type {TextFile | undefined} */ let of =
    measured.file;
  watch(() => {
    const data = measured.file;
    if (data) cells.show(data.text);
    // What there is to begin with: an example, and muscles that were measured.
    else
      understood.replaceChildren(
        faded("Drop a table of measured points, paste its cells, or type them into Table."),
        gallery(
          fail,
          undefined,
          GALLERY.filter(([, , , entry]) => entry.data),
        ),
        library(fail),
      );
    if (data === of) return;
    of = data;
    compared.value = known.value = undefined;
    untracked(() => keepFile(CONSTANTS, undefined));
    look();
  });
  watch(() => {
    const answer = compared.value,
      data = measured.file;
    if (!answer || !data) return;
    const u = answer.understood?.[0] ?? answer.understood;
    const said = [...(measured.said ? [measured.said] : []), ...(answer.warnings ?? [])];
    const line = `${data.name}: ${answer.points} points. ${columnLine(u?.columns ?? [])}`;
    understood.replaceChildren(paragraph(line), warnings(said));
    errors.replaceChildren(errorTable(answer.models));
  });
  watch(() => {
    const answer = known.value;
    // What matters most then is the muscle.
    identify.element.querySelector("button")?.classList.toggle("main", !answer);
    found.replaceChildren(...(answer ? identifiedView(answer) : []));
    fitted.show(answer?.figure);
  });
  // Figures are drawn by the engine in the units that are asked for.
  watch(() => {
    unitName("pressure");
    if (compared.peek()) look();
  });
  return {
    async load(params) {
      await muscle.read(params, what.keys);
      what.set(params);
      await look();
      // What was identified before is there again.
      if (measured.file && fileOf(CONSTANTS)) identify.run();
    },
  };
};
