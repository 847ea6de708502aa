// A campaign of finite-element tests and the formula fitted to it: errors, figures, surfaces, and the file.
import {
  block,
  button,
  download,
  el,
  faded,
  folded,
  heading,
  remark,
  smallPrint,
} from "../dom.js";
import { bench, fieldsOf, form, job } from "../form.js";
import {
  PUBLISHED,
  errorsView,
  figuresView,
  surfaces,
} from "../formula-view.js";
import { fileOf, keepFile } from "../kept.js";
import { muscle } from "../muscle.js";
import { onUnits } from "../units.js";

const PLAN = `name = "page"

[tube]
length = "285 mm"
rubber = "paper"

[braid]
angle = "28 deg"
stiffness = "paper"

[sampling]
method = "factorial"

[vary]
tube.outer_diameter = "30,40,45,50 mm"
tube.wall_thickness = "1..5:1 mm"

[test]
contractions = "0..0.20:0.05"
pressures = "0..0.25:0.01 MPa"
`;
/** The plan that was computed before: it is computed again when one comes back. */
const COMPUTED = /** @type {const} */ ("campaign");

/** How a formula is fitted. @type {Field[]} */
export const HOW = fieldsOf([
  [
    "method",
    "method",
    "Method",
    undefined,
    {
      options: [
        ["paper", "seven steps (Antonelli 2018)"],
        ["global", "one least-squares problem"],
      ],
      value: "paper",
    },
  ],
  [
    "hold",
    "hold_out_mm",
    "Diameters kept out",
    "length",
    { list: true, hint: "45 mm" },
  ],
  ["at", "at", "Maps at", "pressure", "2.5 bar"],
]);

/** @type {Mount} */
export const mount = (main) => {
  /** @type {Commands["plan"]["answer"] | undefined} */ let made;
  /** @type {import("../formula-view.js").File | typeof PUBLISHED} */ let formula =
    PUBLISHED;
  const plan = el("textarea", {
    rows: 20,
    style: "width:100%;font:13px ui-monospace,monospace",
    "aria-label": "Plan (TOML)",
  });
  plan.value = fileOf("plan") ?? PLAN;
  plan.addEventListener("input", () =>
    keepFile("plan", plan.value === PLAN ? undefined : plan.value),
  );
  const how = form(HOW, () => (made ? fit.run() : paint()));
  const table1 = smallPrint(),
    errors = block(),
    figures = block(),
    shown = surfaces();
  const about = { fields: how, shown: [errors, shown.element, figures] };
  const campaign = job(
    "Compute the plan",
    "plan",
    async () => ({ plan: { name: "page.toml", text: plan.value } }),
    (answer) => {
      made = answer;
      keepFile(COMPUTED, plan.value);
      table1.replaceChildren(
        `${answer.muscles} muscles, ${answer.points} points, ${answer.failed} without an answer. `,
        button("Download the table", () =>
          download(answer.table.name, answer.table.text, "text/csv"),
        ),
      );
      fit.run();
    },
    about,
  );
  const fit = job(
    "Fit",
    "fit",
    async () => {
      if (!made) {
        errors.replaceChildren(faded("Compute the plan first."));
        return undefined;
      }
      const read = await how.read();
      if (!read) return undefined;
      place();
      return {
        table: made.table,
        method: read.method,
        hold_out_mm: read.hold_out_mm,
        figures: true,
      };
    },
    (answer) => {
      const { figures: drawn, tables, ...file } = answer;
      formula = file;
      errors.replaceChildren(...errorsView(file));
      figures.replaceChildren(...figuresView(drawn));
      paint();
    },
    { ...about, minor: true },
  );
  main.replaceChildren(
    bench(
      "Campaign",
      [
        heading("Campaign"),
        remark(
          "A plan lists the muscles to compute by finite elements. This is the plan of Antonelli (2018).",
        ),
        folded("Advanced", plan),
        campaign.element,
        table1,
        how.element,
        fit.element,
      ],
      [errors, shown.element, figures],
    ),
  );
  errors.append(
    heading(PUBLISHED.name),
    faded("Below is the published formula."),
  );

  const place = () => muscle.place("formula", how.texts());
  async function paint() {
    place();
    const read = await how.read();
    await shown.show(formula, read?.at).catch(() => {
      shown.element.hidden = true;
    });
  }
  onUnits(paint);
  return {
    async load(params) {
      await muscle.read(params, how.keys);
      how.set(params);
      // One that was dropped meanwhile.
      plan.value = fileOf("plan") ?? plan.value;
      if (fileOf(COMPUTED) === plan.value && !made) campaign.run();
      else paint();
    },
  };
};
