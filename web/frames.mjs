// Drawings of docs/how-it-pulls.md: the muscle of examples/prototype.toml at five pressures, as the workbench draws it, with the
// numbers of the program; and one strand, unrolled. `MCKIBBEN=PROGRAM node web/frames.mjs` writes them, --check compares.
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { body, contracted } from "./page/js/body.js";

const root = new URL("../", import.meta.url).pathname,
  check = process.argv.includes("--check"),
  program = process.env.MCKIBBEN ?? `${root}target/debug/mckibben`;
const muscle = { length: 285, diameter: 30, angle: 28 };
const free = (/** @type {number} */ bar) =>
  JSON.parse(
    execFileSync(
      program,
      `contraction examples/prototype.toml -p ${bar}bar -F 0N --format json`.split(" "),
      { cwd: root, encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] },
    ),
  );
const text = (
  /** @type {number} */ x,
  /** @type {number} */ y,
  /** @type {string} */ words,
  more = "",
) => `<text x="${x}" y="${y}"${more}>${words}</text>`;
const drawing = (
  /** @type {string} */ name,
  /** @type {number} */ wide,
  /** @type {number} */ tall,
  /** @type {string} */ inside,
) => {
  const file = `${root}docs/figures/${name}.svg`,
    made =
      `<svg xmlns="http://www.w3.org/2000/svg" width="${2 * wide}" height="${2 * tall}" viewBox="0 0 ${wide} ${tall}">` +
      `<style>text{font:7.5px sans-serif;fill:#222}.line{stroke:#0b57a4;stroke-width:1.6;fill:none}` +
      `.thin{stroke:#8a929c;stroke-width:.8;fill:none;stroke-dasharray:3 2}</style>` +
      `<rect width="${wide}" height="${tall}" fill="#fff"/>${inside}</svg>\n`;
  if (!check) writeFileSync(file, made);
  else if (readFileSync(file, "utf8") !== made) throw new Error(`${file} is not what is drawn`);
};

const frames = [0, 0.5, 1, 1.5, 2.5].map((bar, k) => {
  const at = bar ? free(bar) : { contraction: 0, bulged_diameter_mm: muscle.diameter };
  const { angle } = contracted(muscle.diameter, muscle.angle, at.contraction);
  const length = muscle.length * (1 - at.contraction),
    y = 44 + 62 * k;
  const shape = body({
    length,
    diameter: muscle.diameter,
    bulged: at.bulged_diameter_mm,
    angle,
    fill: "#23706f",
    thread: "#e4e1d8",
  });
  const words =
    `${bar} bar · length ${length.toFixed(0)} mm (${(100 * at.contraction).toFixed(0)} % shorter) · ` +
    `diameter ${at.bulged_diameter_mm.toFixed(0)} mm · strands ${angle.toFixed(0)}°`;
  return `<g transform="translate(28 ${y})">${shape}</g>${text(28, y - 31, words)}`;
});
drawing("how-it-pulls-frames", 350, 330, frames.join(""));

// One turn of a strand of length 90 on the unrolled tube: along the axis upwards, around it to the right.
const strand = 90,
  turns = [28, 45, 54.7].map((angle, k) => {
    const a = (angle * Math.PI) / 180,
      x = 24 + 108 * k,
      wide = strand * Math.sin(a),
      tall = strand * Math.cos(a),
      foot = 112;
    return (
      `<path class="thin" d="M${x} ${foot}h${wide.toFixed(1)}v${(-tall).toFixed(1)}h${(-wide).toFixed(1)}z"/>` +
      `<path class="line" d="M${x} ${foot}l${wide.toFixed(1)} ${(-tall).toFixed(1)}"/>` +
      `<path class="thin" d="M${x} ${foot - 22}A22 22 0 0 1 ${(x + 22 * Math.sin(a)).toFixed(1)} ${(foot - 22 * Math.cos(a)).toFixed(1)}"/>` +
      text(x + 3, foot - 26, "θ") +
      text(x + wide / 2 + 4, foot - tall / 2 + 6, "B/n") +
      text(x, foot + 10, "around: π D") +
      text(
        x - 5,
        foot,
        k ? "along: L/n" : "along: L0/n",
        ` transform="rotate(-90 ${x - 5} ${foot})"`,
      ) +
      text(x, 14, `θ = ${angle}°${k ? "" : ", at rest: θ0"}`)
    );
  });
drawing("how-it-pulls-strand", 345, 130, turns.join(""));
