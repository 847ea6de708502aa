// Places and their views: names, what each is for, and where the book says more.

/** Places; the first view of a place has its name. @type {[name: string, text: string][]} */
export const PLACES = [
  ["design", "Ask"],
  ["muscle", "Muscle"],
  ["joint", "Joint & motion"],
  ["data", "Measure"],
];

/** @typedef {{ name: string, place: string, text: string, about: string, help: string }} Page */
/** @type {Page[]} */
export const PAGES = [
  [
    "muscle",
    "muscle",
    "Live",
    "workbench",
    "Drag the muscle, a slider or a curve: finite elements answer at once.",
  ],
  [
    "design",
    "design",
    "Ask",
    "commands#commands",
    "State the pull that you need: the answer is a muscle to build, with its chance.",
  ],
  [
    "joint",
    "joint",
    "Joint",
    "joints",
    "Two muscles pull against each other on a pulley: torque, stiffness and pressures of a joint.",
  ],
  [
    "motion",
    "joint",
    "Motion",
    "motion",
    "Open a valve: how fast the muscle fills, and how it moves its load.",
  ],
  [
    "data",
    "data",
    "Points",
    "identify",
    "Compare measured points with the models, and identify the constants of your own muscle.",
  ],
  [
    "rubber",
    "data",
    "Rubber",
    "rubber",
    "Fit laws to a test of your own rubber, and put it into the muscle.",
  ],
].map(([name, place, text, help, about]) => ({ name, place, text, help, about }));
/** Pages of old links, and where they are now; of all others the first. @type {Record<string, string>} */
export const MOVED = { start: "design", sweep: "muscle", compare: "muscle" };
/** @param {string} name */
export const pageOf = (name) =>
  PAGES.find((page) => page.name === (MOVED[name] ?? name)) ?? PAGES[0];
/** The views of a place. @param {string} place */
export const viewsOf = (place) => PAGES.filter((page) => page.place === place);
