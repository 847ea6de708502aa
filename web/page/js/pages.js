// The pages: names, what each is for, and where the book says more.

/** @typedef {{ name: string, text: string, about: string, help: string }} Page */
/** @type {Page[]} */
export const PAGES = [
  { name: "muscle", text: "Muscle", help: "workbench",
    about: "Change a muscle and see at once how it pulls, bulges and stretches, computed by finite elements while you "
      + "drag." },
  { name: "design", text: "Design", help: "commands#commands",
    about: "State the pull that you need: this page finds muscles that give it, and ranks them." },
  { name: "joint", text: "Joint", help: "joints",
    about:
      "Two muscles pull against each other on a pulley: see the torque, the stiffness and the pressures of a joint." },
  { name: "motion", text: "Motion", help: "motion",
    about: "Open a valve and see how fast the muscle fills, and how it moves its load." },
  { name: "sweep", text: "Sweep", help: "workbench",
    about: "Vary one measure of the muscle, the pressure or the contraction, and see what it does to the pull and "
      + "to the rest." },
  { name: "data", text: "Data", help: "identify",
    about: "Compare points that you measured with the models, and identify the constants of your own muscle." },
  { name: "rubber", text: "Rubber", help: "rubber",
    about: "Fit laws to a test of your own rubber, and put it into the muscle." },
  { name: "formula", text: "Formula", help: "models",
    about: "Compute a campaign of muscles, and fit one formula to it for a controller or a spreadsheet." },
  { name: "compare", text: "Compare", help: "models",
    about: "See two muscles, or two models of one muscle, side by side." },
  { name: "parts", text: "Parts", help: "parts",
    about: "Look for tubes, sleeves and rubbers that you can buy or cast, and put them into the muscle." },
  { name: "files", text: "Files", help: "workbench",
    about: "Take the muscle with you: a report, the build sheet, code for controllers and simulators, and files of "
      + "finite elements." },
  { name: "about", text: "About", help: "validation",
    about: "How accurate the results are, how they were verified, and where the data come from." },
];
/** @param {string} name */
export const pageOf = (name) => PAGES.find((page) => page.name === name) ?? PAGES[0];
