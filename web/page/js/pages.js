// Places and their views: names, what each is for, and where the book says more.

/**
 * Places, with a short name for a phone; the first view of a place has its name.
 * @type {[name: string, text: string, short: string][]}
 */
export const PLACES = [
  ["design", "Design", "Design"],
  ["muscle", "Muscle", "Muscle"],
  ["joint", "Joint & motion", "Joint"],
  ["data", "Measurements", "Measure"],
  ["parts", "Parts & library", "Parts"],
  ["files", "Build & export", "Build"],
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
  ["start", "", "Start", "workbench", ""],
  [
    "design",
    "design",
    "Design",
    "commands#commands",
    "State the pull that you need: this page finds muscles that give it, and ranks them.",
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
    "sweep",
    "muscle",
    "Sweep",
    "workbench",
    "Vary one measure of the muscle, the pressure or the contraction.",
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
  [
    "formula",
    "data",
    "Formula",
    "models",
    "Compute a campaign of muscles, and fit one formula to it for a controller or a spreadsheet.",
  ],
  [
    "compare",
    "muscle",
    "Compare",
    "models",
    "See two muscles, or two models of one muscle, side by side.",
  ],
  [
    "parts",
    "parts",
    "Parts",
    "parts",
    "Tubes, sleeves and rubbers that you can buy or cast, and measured muscles.",
  ],
  [
    "files",
    "files",
    "Files",
    "workbench",
    "Report, workshop, controllers, simulators and finite elements: the muscle as files.",
  ],
  ["about", "", "About", "verified", "How accurate the results are, and where the data come from."],
].map(([name, place, text, help, about]) => ({ name, place, text, help, about }));
/** @param {string} name */
export const pageOf = (name) => PAGES.find((page) => page.name === name) ?? PAGES[0];
/** The views of a place. @param {string} place */
export const viewsOf = (place) => PAGES.filter((page) => page.place === place);
