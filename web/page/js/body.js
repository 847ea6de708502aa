// A muscle from the side as SVG, in millimetres or any other measure: woven strands over a tube
// that bulges between its ends. The left end of the tube is at 0, its axis too.

let count = 0;
const short = (/** @type {number} */ v) => Number(v.toPrecision(5));

/**
 * What a muscle of these measures has at a contraction, by strands that do not stretch: diameter
 * and strand angle.
 * @param {number} diameter @param {number} angle in degrees @param {number} contraction
 */
export function contracted(diameter, angle, contraction) {
  const a = (angle * Math.PI) / 180,
    c = Math.min(0.999, Math.cos(a) * (1 - contraction));
  return {
    bulged: (diameter * Math.sqrt(1 - c * c)) / Math.sin(a),
    angle: (Math.acos(c) * 180) / Math.PI,
  };
}

/**
 * @param {{ length: number, diameter: number, bulged?: number, angle?: number | null, fill?:
 * string,
 *   thread?: string }} of as it is now; the strand angle is that of its middle
 */
export function body({
  length,
  diameter,
  bulged = diameter,
  angle,
  fill = "var(--rubber, #23706f)",
  thread = "var(--thread, #e4e1d8)",
}) {
  const id = `body${++count}`,
    r = diameter / 2,
    b = Math.max(r, bulged / 2),
    end = Math.min(0.3 * length, 1.6 * b);
  const a = (Math.min(80, Math.max(10, angle ?? 28)) * Math.PI) / 180,
    tan = Math.tan(a);
  const pitch = Math.max(0.42 * b, (length * Math.sin(a)) / 30),
    step = pitch / Math.sin(a),
    across = (2 * b) / tan;
  // Of the upper half the lower one is the mirror.
  const [near, far] = [
    [0.35, 0.5, 1].map((t) => short(t * end)),
    [0.35, 0.5, 1].map((t) => short(length - t * end)),
  ];
  const there = (/** @type {string} */ y, /** @type {string} */ rest) =>
    `C${near[0]} ${rest} ${near[1]} ${y} ${near[2]} ${y}H${far[2]}C${far[1]} ${y} ${far[0]} ${rest} ${length} ${rest}`;
  const back = (/** @type {string} */ y, /** @type {string} */ rest) =>
    `C${far[0]} ${rest} ${far[1]} ${y} ${far[2]} ${y}H${near[2]}C${near[1]} ${y} ${near[0]} ${rest} 0 ${rest}`;
  const [R, B] = [`${short(r)}`, `${short(b)}`],
    outline = `M0 -${R}${there(`-${B}`, `-${R}`)}V${R}${back(B, R)}Z`;
  const family = (/** @type {1 | -1} */ sign) =>
    Array.from(
      { length: Math.ceil((length + across) / step) + 1 },
      (_, k) =>
        `M${short(k * step - across)} ${short(-sign * b)}l${short(across)} ${short(2 * sign * b)}`,
    ).join("");
  // Of every second crossing the first family is above: a dash as long as from one to the next.
  const apart = step / 2 / Math.cos(a),
    first = across / 2 / Math.cos(a);
  const dash = ` stroke-dasharray="${short(apart)}" stroke-dashoffset="${short(apart / 2 - first)}"`;
  const threads = (/** @type {string} */ d, more = "") =>
    `<path d="${d}" stroke="#1a1d21" stroke-opacity=".6" stroke-width="${short(0.74 * pitch)}"${more}/>` +
    `<path d="${d}" stroke="${thread}" stroke-width="${short(0.5 * pitch)}"${more}/>`;
  const [one, other] = [family(1), family(-1)];
  const box = (/** @type {number} */ x, /** @type {number} */ wide, /** @type {number} */ tall) =>
    `M${short(x)} ${short(-tall)}h${short(wide)}v${short(2 * tall)}h${short(-wide)}z`;
  const plug = (/** @type {number} */ x, /** @type {number} */ way) =>
    `<path d="${box(x - 0.3 * way * r, way * r, 1.12 * r)}${box(x + 0.7 * way * r, 0.5 * way * r, 0.5 * r)}" ` +
    `fill="url(#${id}m)"/>`;
  const stops = (/** @type {string[]} */ ...list) => list.map((stop) => `<stop ${stop}/>`).join("");
  const shade = stops(
    'stop-opacity=".28"',
    'offset=".3" stop-opacity="0"',
    'offset="1" stop-opacity=".55"',
  );
  const metal = stops(
    'stop-color="#7d838b"',
    'offset=".3" stop-color="#b9bec5"',
    'offset="1" stop-color="#4b5057"',
  );
  return (
    `<defs><clipPath id="${id}"><path d="${outline}"/></clipPath><linearGradient id="${id}s" x2="0" y2="1">${shade}` +
    `</linearGradient><linearGradient id="${id}m" x2="0" y2="1">${metal}</linearGradient></defs>` +
    `<g clip-path="url(#${id})" fill="none"><path d="${outline}" fill="${fill}"/>${threads(one)}${threads(other)}` +
    `${threads(one, dash)}<path d="${outline}" fill="url(#${id}s)"/></g>${plug(0, -1)}${plug(length, 1)}`
  );
}
