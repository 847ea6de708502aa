// Measured points: seen over the models, and constants identified from them.
import { Slot } from "../ask.js";
import { pointSeries } from "../bench/points.js";
import { columnLine, grid } from "../columns.js";
import { TABLES, fileField } from "../controls.js";
import {
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
} from "../dom.js";
import { Figures } from "../figure.js";
import { bench, fieldsOf, form, job, table, warnings } from "../form.js";
import { GALLERY, gallery } from "../gallery.js";
import { fileOf, keepFile } from "../kept.js";
import { library, muscleButtons } from "../library.js";
import { measured } from "../measured.js";
import { muscle } from "../muscle.js";
import { number, onUnits, ratioAxis, showForce, unitName } from "../units.js";
import { keyed, worded } from "../words.js";

const CONSTANTS = "constants";

/** Constants with their ±, and what to do with them. @param {Commands["identify"]["answer"]} answer */
function identifiedView(answer) {
  const rows = answer.parameters.map((p) => {
    const half = p.half_width_95 ? `± ${number(p.half_width_95, 2)}` : "–";
    return [
      capital(worded(p.name)),
      `${number(p.value, 5)} ${p.unit ?? ""}`,
      half,
      p.identifiable ? "" : "not identifiable",
    ];
  });
  return [
    heading("Identified"),
    table(["constant", "value", "95 %", ""], rows, {
      text: [0, 3],
      label: "constants",
    }),
    paragraph(
      `Residuals ${showForce(answer.rms_n, 3)} rms, ${showForce(answer.rms_before_n, 3)} before.`,
    ),
    warnings(answer.warnings),
    muscleButtons(
      answer.muscle_file,
      "See it move",
      "Download the muscle",
      "identified",
    ),
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
  [
    "free",
    "free",
    "Free constants",
    undefined,
    { words: true, hint: "shear modulus" },
  ],
  [
    "models",
    "models",
    "Models",
    undefined,
    { words: true, value: "fe, thick-wall, ideal" },
  ],
]);
class DataPage {
  /** @type {Commands["compare"]["answer"] | undefined} */ #compared;
  /** @type {Commands["identify"]["answer"] | undefined} */ #known;
  #looking = new Slot();
  #reading = new Slot();

  /** @param {HTMLElement} main */
  constructor(main) {
    this.data = measured.file;
    this.what = form(FIELDS, () => this.#look());
    this.table = grid(
      ["pressure [bar]", "contraction [%]", "pull [N]", "branch"],
      (text) => this.#take(this.data?.name ?? "typed.csv", text),
    );
    this.understood = block(
      "",
      ...(this.data
        ? []
        : [
            faded(
              "Drop a table of measured points, paste its cells, or type them into Table.",
            ),
            this.#begins(),
          ]),
    );
    this.errors = block();
    this.found = block();
    this.figures = new Figures("data");
    this.fitted = new Figures("identified");
    this.identify = job(
      "Identify",
      "identify",
      () => this.#request(),
      (answer) => this.#identified(answer),
      { shown: [this.found, this.fitted.element] },
    );
    main.replaceChildren(
      bench("Data", this.#controls(), [
        this.understood,
        this.errors,
        this.figures.element,
        this.found,
        this.fitted.element,
      ]),
    );
    // Figures are drawn by the engine in the units that are asked for.
    onUnits(() => {
      this.#paint();
      this.#place();
      if (this.#compared) this.#look();
    });
  }

  #controls() {
    return [
      heading("Measured points"),
      fileField("Open a table (CSV, XLSX, ODS)", TABLES, (name, text) =>
        this.#take(name, text),
      ),
      remark(
        "Pressures, contractions (or shortenings, or lengths) and pulls, with their units in the heading.",
      ),
      this.table.element,
      folded(
        "Advanced",
        this.what.element,
        rowOf(button("Compare", () => this.#look())),
      ),
      this.identify.element,
    ];
  }

  /** What there is to begin with: an example, and muscles that were measured. */
  #begins() {
    const fail = (/** @type {unknown} */ why) => this.#fail(why);
    return block(
      "",
      gallery(
        fail,
        undefined,
        GALLERY.filter(([, , , { data }]) => data),
      ),
      library(fail, () => {}),
    );
  }

  async #request() {
    const read = await this.what.read();
    if (!this.data || !read) {
      this.found.replaceChildren(faded("Open a table first."));
      return undefined;
    }
    return {
      muscle: muscle.fields(),
      data: [this.data],
      free: (read.free ?? []).map(keyed),
      figure: unitName("pressure"),
    };
  }

  /** @param {Commands["identify"]["answer"]} answer */
  #identified(answer) {
    this.#known = answer;
    keepFile(CONSTANTS, true);
    this.#paint();
    this.fitted.show(answer.figure);
  }

  /** @param {unknown} why */
  #fail(why) {
    this.understood.replaceChildren(problemBox(why));
  }
  #place() {
    muscle.place("data", this.what.texts());
  }

  /** @param {string} name @param {string} text */
  async #take(name, text) {
    measured.set({ name, text });
    this.data = measured.file;
    keepFile(CONSTANTS, undefined);
    [this.#compared, this.#known] = [undefined, undefined];
    this.#begin();
    this.found.replaceChildren();
    this.fitted.show(undefined);
    await this.#look();
  }
  #begin() {
    if (this.data) this.table.show(this.data.text);
  }

  async #look() {
    const read = await this.what.read(),
      { data } = this;
    if (!data || !read || !this.understood.isConnected) return;
    this.#place();
    this.#looking.ask(
      "compare",
      {
        muscle: muscle.fields(),
        data: [data],
        models: read.models,
        extrapolate: true,
        figure: unitName("pressure"),
      },
      (answer) => {
        this.#compared = answer;
        this.#paint();
        dim([this.errors, this.figures.element], false);
        this.figures.show(answer.figure);
        this.#colour(data);
      },
      (why) => {
        this.#fail(why);
        if (why.kind === "data") this.table.element.open = true;
        dim([this.errors, this.figures.element], true);
      },
    );
  }

  /** Pulls over contraction have the colour of their pressure and the sign of their branch. @param {TextFile} data */
  #colour(data) {
    const [chart] = this.figures.charts,
      spec = chart?.spec;
    if (spec?.x !== ratioAxis) return;
    this.#reading.ask(
      "identify",
      { muscle: muscle.fields(), data: [data], free: ["modulus"] },
      ({ points }) => {
        const list = points.filter((q) => q.measured === "force"),
          top = Math.max(...list.map((q) => q.pressure_mpa));
        chart.show({
          ...spec,
          series: [
            ...spec.series.filter((s) => s.mode !== "markers"),
            ...pointSeries(list, top),
          ],
        });
      },
      () => {},
    );
  }

  #paint() {
    const compared = this.#compared,
      known = this.#known;
    if (compared && this.data) {
      const u = compared.understood?.[0] ?? compared.understood;
      const said = [
        ...(measured.said ? [measured.said] : []),
        ...(compared.warnings ?? []),
      ];
      const line = `${this.data.name}: ${compared.points} points. ${columnLine(u?.columns ?? [])}`;
      this.understood.replaceChildren(paragraph(line), warnings(said));
      this.errors.replaceChildren(errorTable(compared.models));
    }
    if (known) this.found.replaceChildren(...identifiedView(known));
  }

  /** @param {URLSearchParams} params */
  async load(params) {
    await muscle.read(params, this.what.keys);
    this.what.set(params);
    this.data = measured.file;
    this.#begin();
    if (this.data) await this.#look();
    // What was identified before is there again.
    if (this.data && fileOf(CONSTANTS)) this.identify.run();
  }
}

/** @type {Mount} */
export const mount = (main) => new DataPage(main);
