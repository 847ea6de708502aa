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
  {
    name: "muscle",
    place: "muscle",
    text: "Live",
    help: "workbench",
    about:
      "Drag the muscle, a slider or a curve: finite elements answer at once.",
  },
  {
    name: "design",
    place: "design",
    text: "Design",
    help: "commands#commands",
    about:
      "State the pull that you need: this page finds muscles that give it, and ranks them.",
  },
  {
    name: "joint",
    place: "joint",
    text: "Joint",
    help: "joints",
    about:
      "Two muscles pull against each other on a pulley: torque, stiffness and pressures of a joint.",
  },
  {
    name: "motion",
    place: "joint",
    text: "Motion",
    help: "motion",
    about:
      "Open a valve: how fast the muscle fills, and how it moves its load.",
  },
  {
    name: "sweep",
    place: "muscle",
    text: "Sweep",
    help: "workbench",
    about: "Vary one measure of the muscle, the pressure or the contraction.",
  },
  {
    name: "data",
    place: "data",
    text: "Points",
    help: "identify",
    about:
      "Compare measured points with the models, and identify the constants of your own muscle.",
  },
  {
    name: "rubber",
    place: "data",
    text: "Rubber",
    help: "rubber",
    about: "Fit laws to a test of your own rubber, and put it into the muscle.",
  },
  {
    name: "formula",
    place: "data",
    text: "Formula",
    help: "models",
    about:
      "Compute a campaign of muscles, and fit one formula to it for a controller or a spreadsheet.",
  },
  {
    name: "compare",
    place: "muscle",
    text: "Compare",
    help: "models",
    about: "See two muscles, or two models of one muscle, side by side.",
  },
  {
    name: "parts",
    place: "parts",
    text: "Parts",
    help: "parts",
    about:
      "Tubes, sleeves and rubbers that you can buy or cast, and measured muscles.",
  },
  {
    name: "files",
    place: "files",
    text: "Files",
    help: "workbench",
    about:
      "Report, workshop, controllers, simulators and finite elements: the muscle as files.",
  },
  {
    name: "about",
    place: "",
    text: "About",
    help: "validation",
    about:
      "How accurate the results are, how they were verified, and where the data come from.",
  },
];
/** @param {string} name */
export const pageOf = (name) =>
  PAGES.find((page) => page.name === name) ?? PAGES[0];
/** The views of a place. @param {string} place */
export const viewsOf = (place) => PAGES.filter((page) => page.place === place);
