// Types that several scripts of the page name.
import type { Commands as All } from "./types/commands";

declare global {
  type Commands = All;
  type Problem = import("./page/js/engine/problem.js").Problem;
  type Signal<T> = import("./page/js/vendor/signals.js").Signal<T>;
  type Store = import("./page/js/bench/store.js").Store;
  type View = ReturnType<typeof import("./page/js/view3d.js").viewOf>;

  /** A page: what it shows, by the words of its address. */
  type Mount = (main: HTMLElement) => { load(params: URLSearchParams): Promise<void> };

  /** Kinds of the engine, moduli (pressures that are always in MPa), and plain numbers (ratios that nobody writes in %). */
  type EngineKind = All["units"]["answer"]["kinds"][number]["kind"];
  type Kind = EngineKind | "modulus" | "number";
  /** What waits for what; `state` comes first, `read` is for what takes no time, and `job` for long work, with its progress. */
  type LaneName = "state" | "read" | "side" | "curves" | "job";
  type How = {
    lane?: LaneName;
    signal?: AbortSignal;
    progress?: (done: number, total: number) => void;
  };
  /** What was understood: of each text its number, its numbers, or what is wrong with it. */
  type Readings = {
    value?: number;
    values?: number[];
    interval?: [number, number] | null;
    problem?: { message: string };
  }[];

  /**
   * A quantity: key of the address, field of requests, key and table of muscle files, kind, unit of a plain number, name, symbol, what it
   * is, the values that it may have and the one where nothing is stated, and the ends of its slider, where it has one.
   */
  interface Measure {
    key: string;
    field: string;
    filed?: string;
    group?: string;
    kind: Kind;
    unit?: string;
    label: string;
    symbol?: string;
    about?: string;
    above?: number;
    minimum?: number;
    maximum?: number;
    usual?: number;
    low?: number;
    high?: number;
    around?: boolean;
  }
  type MuscleFields = import("./types/commands").MuscleFields;
  /**
   * `file`: a muscle file, empty for the prototype; `said`: what is said over it, and nothing else; `p`, and `e` or `F`: where it is asked.
   */
  type State = {
    file: string;
    said: Readonly<Record<string, number | string>>;
    p: number;
    e: number;
    F: number | undefined;
  };
  type MuscleMeasures = {
    outer_diameter_mm: number;
    wall_mm: number;
    length_mm: number;
    angle_deg?: number | null;
  };

  /**
   * A field of a form. `pair`: a list of two quantities joined by "at" or @, such as 700 N at 15 %, 300N@20%: kinds and fields of both. `words`: a list
   * of words. `or`: words that may stand in place of a quantity. `factor`: a ratio that nobody writes in %. `hidden`: until it is shown.
   */
  interface Field {
    key: string;
    field: string;
    label: string;
    kind?: Kind;
    list?: boolean;
    pair?: [Kind, string][];
    words?: boolean;
    or?: string[];
    factor?: boolean;
    hidden?: boolean;
    options?: [string, string][];
    value?: string;
    hint?: string;
  }
  /** What a form reads; which fields with which values there are its list of fields decides, and the engine checks. */
  type Read = Record<string, any>;

  /**
   * `low`, `high`: ends of an interval at each point, drawn as a band; `band`: the points are the outline of one; `end`: a label at the curve's
   * end, or at its start; `strong`: the curve of the state among its family; `smooth`: a cubic between its points; `fixed`: what does not change along it.
   */
  interface Series {
    name: string;
    x: number[];
    y: (number | null)[];
    low?: (number | null)[];
    high?: (number | null)[];
    end?: string;
    at?: "start" | "end";
    colour?: string;
    dash?: "solid" | "dash" | "dot";
    /** The sign of its points: the branch that they were measured on. */
    glyph?: "mean" | "contraction" | "elongation";
    mode?: "lines" | "markers";
    legend?: string;
    band?: boolean;
    strong?: boolean;
    smooth?: boolean;
  }
  type Axis = { range?: number[]; rangemode?: string };
  type Place = { x: number; y: number; text: string };
  /** What a chart shows: curves, and rings at places. */
  interface Spec {
    x: string;
    y: string;
    series: Series[];
    marks?: Place[];
    xaxis?: Axis;
    yaxis?: Axis;
  }
  /** What is below a pointer: of which curve, and where. */
  type Found = { which: number; x: number; y: number };
  type Reach = { x: [number, number]; y: [number, number] };

  type Design = All["design"];
  type Candidate = Design["answer"]["candidates"][number];

  type JointAnswer = All["joint"]["answer"];
  /** A point as the page shows it. */
  type JointPoint = JointAnswer["points"][number] & { model: string; words?: string | null };
  type Family = { answer: JointAnswer; angles: number[]; pairs: number[][] };
  type Run = All["motion"]["answer"];
  /** The pull of a muscle that is built. */
  type Built = { predicted_n?: number; predicted_low_n?: number; predicted_high_n?: number };
  type CurveAnswer = All["curve"]["answer"];

  /** The muscle as words of an address, and what led to it. */
  type Step = { words: Words; name: string };
  /**
   * Measured points, and what to say of them; a test of a rubber; a formula among the models; whether constants were identified; steps of
   * the muscle, and the one that is shown.
   */
  interface KeptFiles {
    data?: TextFile;
    "data-said"?: string;
    rubber?: TextFile;
    formula?: TextFile;
    constants?: boolean;
    steps?: { list: Step[]; at: number };
  }
  type TextFile = { name: string; text: string };
  type Words = Record<string, string>;
}
