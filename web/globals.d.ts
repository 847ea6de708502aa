// Types that many scripts of the page name.
import type { Commands as All } from "./types/commands";

declare global {
  type Commands = All;
  type Kind = import("./page/js/units.js").Kind;
  type State = import("./page/js/state.js").State;
  type Measure = import("./page/js/state.js").Measure;
  type Problem = import("./page/js/engine/problem.js").Problem;
  type Field = import("./page/js/form.js").Field;
  type Read = import("./page/js/form.js").Read;
  type Store = import("./page/js/bench/store.js").Store;
  type View = import("./page/js/view3d.js").View;
  type Series = import("./page/js/plot.js").Series;
  type Spec = import("./page/js/plot.js").Curves;
}
