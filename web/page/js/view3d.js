// The muscle in space: one lit surface turned about the axis, its strands, and the terminals.
// WebGL2; without it an SVG.
//
// What the engine knows along the half muscle goes into one small texture; where each point of
// surface or strand lies follows from it on the graphics processor, so that a new shape costs one
// upload of a few kilobytes.
import { body } from "./body.js";
import { el } from "./dom.js";
import { atEnd, rested } from "./life.js";
import { FRAGMENT, SURFACE, VIRIDIS } from "./shaders.js";

/**
 * Columns of a mesh about the axis; columns and rows while it moves, where there is no graphics
 * processor.
 */
const AROUND = 48,
  COARSE = [24, 40];
/**
 * Strands drawn of a family whose number is not known, and most that are drawn: more lie side by
 * side in flat ones.
 */
const DRAWN = 18,
  MOST = 40;
/** How the muscle is first seen, and how far it may be zoomed. */
const TURN = [0.35, -0.5],
  ZOOM = [0.5, 8];
/**
 * The profile of a crimped fitting, all edges: radius and distance from the tube's end, as shares
 * of the tube's radius.
 */
const FITTING = [
  [1.02, -0.12],
  [1.14, -0.12],
  [1.14, 0.06],
  [1.05, 0.12],
  [1.05, 0.2],
  [1.14, 0.26],
  [1.14, 0.72],
  [0.62, 0.72],
  [0.62, 0.98],
  [0.36, 0.98],
  [0.36, 1.42],
  [0.18, 1.42],
].flatMap((edge) => [edge, edge]);

/** A row of the mesh about the axis: angles and rows. @param {number} row @param {number} around */
const round = (row, around) =>
  Array.from({ length: around + 1 }, (_, k) => [(2 * Math.PI * k) / around, row]);

/**
 * Rows of a mesh from one end to the other: so many in each half, as shares. @param {number} half
 */
const shares = (half) => Array.from({ length: 2 * half + 1 }, (_, i) => i / half - 1);

/** @param {WebGL2RenderingContext} gl @param {string} vertex */
function program(gl, vertex) {
  /** @type {WebGLProgram} */ const made = gl.createProgram();
  for (const [kind, source] of /** @type {[number, string][]} */ ([
    [gl.VERTEX_SHADER, vertex],
    [gl.FRAGMENT_SHADER, FRAGMENT],
  ])) {
    const shader = /** @type {WebGLShader} */ (gl.createShader(kind));
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  }
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS))
    throw new Error(gl.getProgramInfoLog(made) ?? "shader");
  return made;
}

/**
 * Texels of a texture.
 * @param {WebGL2RenderingContext} gl @param {WebGLTexture | null} texture @param {number} width
 * @param {number} height @param {Float32Array} texels
 */
function fill(gl, texture, width, height, texels) {
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, width, height, 0, gl.RGBA, gl.FLOAT, texels);
}

/** A texture whose texels are read as they are. @param {WebGL2RenderingContext} gl */
function lookup(gl) {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
    gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
  return texture;
}

/** @type {boolean | undefined} */ let slow;
/**
 * Whether WebGL runs without a graphics processor: smooth edges would then cost more than all the
 * rest.
 */
function software() {
  if (slow !== undefined) return slow;
  const gl = document.createElement("canvas").getContext("webgl2");
  const info = gl?.getExtension("WEBGL_debug_renderer_info");
  slow = Boolean(
    info &&
    /swiftshader|llvmpipe|software|basic render/i.test(
      String(gl?.getParameter(info.UNMASKED_RENDERER_WEBGL)),
    ),
  );
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return slow;
}

/**
 * Between which values the colours run: the few nodes at the bonded corner would take the whole
 * map.
 * @param {ArrayLike<number>} list @returns {[number, number]}
 */
export function reach(list) {
  const sorted = Float64Array.from(list).sort();
  return [sorted[Math.floor(0.01 * sorted.length)], sorted[Math.ceil(0.985 * sorted.length) - 1]];
}

/**
 * What colours the muscle and between which values, whether it is cut open; its length and radius
 * at rest.
 * @typedef {{ field: string, low: number, high: number, cut?: boolean, restLength: number,
 * restRadius: number }} Show What is drawn of an answer of `shape`.
 * @typedef {{ stations: number, across: number, arrays: Record<string, number[] | Float32Array>,
 * length_mm: number,
 *   strands?: number | null }} Shape
 * @typedef {{ array: WebGLVertexArrayObject, count: number }} Piece
 */

/**
 * @param {HTMLElement} stage
 * @param {{ contract?: (share: number, settled: boolean) => void, drawn?: () => void }} handlers
 *   share: of the rest length, that the dragged end moves; drawn: after each picture
 */
export function viewOf(stage, { contract, drawn } = {}) {
  let turn = [...TURN],
    zoom = 1;
  /** @type {Shape | undefined} */ let shape;
  /** @type {Show} */
  let show = { field: "", low: 0, high: 1, restLength: 1, restRadius: 1 };
  /** @type {WebGLProgram} */ let painter;
  /**
   * Where its uniforms are, once they are asked for.
   * @type {Record<string, WebGLUniformLocation | null>}
   */
  let places = {};
  /** @type {WebGLTexture | null} */ let texture = null;
  /** @type {WebGLTexture | null} */ let plugTexture = null;
  /** Parts of the mesh. @type {Map<string, Piece>} */ let pieces = new Map();
  let matrix = new Float32Array(16);
  /** Half of what is seen, in mm. */
  let half = 1;
  /** Of the stage, in pixels of the page; asking for it every time would lay the page out anew. */
  let { clientWidth: width, clientHeight: height } = stage;
  /** One pointer turns, or drags the end; two zoom. @type {Map<number, PointerEvent>} */
  const down = new Map();
  /** @type {{ x: number, y: number, turn: number[], end: boolean } | undefined} */ let from;
  let apart = 0;
  const distance = () => {
    const [a, b] = [...down.values()];
    return Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
  };
  const moved = (/** @type {PointerEvent} */ event, /** @type {boolean} */ settled) => {
    if (!from) return;
    const [dx, dy] = [event.clientX - from.x, event.clientY - from.y];
    if (!from.end) return turnTo(from.turn[0] + 0.008 * dy, from.turn[1] + 0.008 * dx);
    const along = (dx * perPixel()) / Math.max(0.3, Math.cos(turn[1]));
    contract?.(-along / show.restLength, settled);
  };
  const up = (/** @type {PointerEvent} */ event) => {
    down.delete(event.pointerId);
    if (event.type === "pointerup") moved(event, true);
    from = undefined;
    canvas.style.cursor = "";
  };
  const canvas = el("canvas", {
    role: "img",
    ariaLabel: "The deformed muscle",
    tabindex: 0,
    onpointerup: up,
    onpointercancel: up,
    ondblclick: reset,
    onpointerdown(/** @type {PointerEvent} */ event) {
      if (!shape) return;
      down.set(event.pointerId, event);
      canvas.setPointerCapture(event.pointerId);
      if (down.size > 1) {
        from = undefined;
        apart = distance();
        return;
      }
      const box = canvas.getBoundingClientRect(),
        end = isAtEnd((event.clientX - box.left) / box.width);
      from = { x: event.clientX, y: event.clientY, turn: [...turn], end };
      canvas.style.cursor = end ? "ew-resize" : "grabbing";
    },
    onpointermove(/** @type {PointerEvent} */ event) {
      if (!down.has(event.pointerId)) return;
      down.set(event.pointerId, event);
      if (down.size < 2) return moved(event, false);
      const now = distance();
      if (apart > 0 && now > 0) zoomBy(now / apart);
      apart = now;
    },
    onwheel(/** @type {WheelEvent} */ event) {
      if (!event.ctrlKey && !event.shiftKey && document.activeElement !== canvas) return;
      event.preventDefault();
      zoomBy(Math.exp(-0.001 * event.deltaY));
    },
    onkeydown(/** @type {KeyboardEvent} */ event) {
      const step = {
        ArrowLeft: [0, -0.1],
        ArrowRight: [0, 0.1],
        ArrowUp: [-0.1, 0],
        ArrowDown: [0.1, 0],
      }[event.key];
      if (event.key === "+" || event.key === "-") zoomBy(event.key === "+" ? 1.2 : 1 / 1.2);
      else if (event.key === "0" || event.key === "Home") reset();
      else if (step) turnTo(turn[0] + step[0], turn[1] + step[1]);
      else return;
      event.preventDefault();
    },
    onwebglcontextlost: (/** @type {Event} */ event) => event.preventDefault(),
    onwebglcontextrestored() {
      prepare();
      upload();
      draw();
    },
  });
  const gl = canvas.getContext("webgl2", { antialias: !software(), alpha: true });

  function prepare() {
    if (!gl) return;
    painter = program(gl, SURFACE);
    places = {};
    texture = lookup(gl);
    plugTexture = lookup(gl);
    gl.enable(gl.DEPTH_TEST);
    pieces = new Map();
  }

  /**
   * Points and triangles of columns of angle and row over shares of the half muscle, whose
   * neighbours are joined; made once for a name.
   * @param {string} name @param {number[]} along @param {number[][]} columns @returns {Piece}
   */
  function piece(name, along, columns) {
    const key = `${name} ${along.length}`,
      known = pieces.get(key);
    if (known) return known;
    const of = /** @type {WebGL2RenderingContext} */ (gl);
    const data = columns.flatMap(([angle, row]) => along.flatMap((t) => [t, angle, row])),
      count = along.length;
    const index = columns.slice(1).flatMap((_, k) =>
      along.slice(1).flatMap((__, i) => {
        const a = k * count + i,
          b = a + count;
        return [a, b, a + 1, b, b + 1, a + 1];
      }),
    );
    const array = of.createVertexArray();
    of.bindVertexArray(array);
    of.bindBuffer(of.ARRAY_BUFFER, of.createBuffer());
    of.bufferData(of.ARRAY_BUFFER, new Float32Array(data), of.STATIC_DRAW);
    of.bindBuffer(of.ELEMENT_ARRAY_BUFFER, of.createBuffer());
    of.bufferData(of.ELEMENT_ARRAY_BUFFER, new Uint32Array(index), of.STATIC_DRAW);
    ["station", "angle", "row"].forEach((name, i) => {
      const at = of.getAttribLocation(painter, name);
      if (at < 0) return;
      of.enableVertexAttribArray(at);
      of.vertexAttribPointer(at, 1, of.FLOAT, false, 12, 4 * i);
    });
    const made = { array, count: index.length };
    pieces.set(key, made);
    return made;
  }

  /**
   * A new shape: the answer of `shape`; what colours it and between which values.
   * @param {Shape & { muscle: MuscleMeasures }} next
   * @param {Omit<Show, "restLength" | "restRadius">} look
   */
  function set(next, look) {
    shape = next;
    const { length_mm: restLength, outer_diameter_mm: diameter } = next.muscle;
    show = { ...look, restLength, restRadius: diameter / 2 };
    if (gl) {
      upload();
      draw();
    } else section();
  }

  /**
   * A shape by its largest stretch.
   * @param {Shape & { muscle: MuscleMeasures }} next
   */
  function stretched(next) {
    set(next, {
      field: "max_stretch",
      low: 1,
      high: Math.max(1.2, reach(next.arrays.max_stretch)[1]),
    });
  }

  function upload() {
    if (!gl || !shape) return;
    const { stations, across, arrays } = shape;
    const strand = show.field.startsWith("strand_");
    const field = arrays[show.field];
    const texels = new Float32Array(4 * stations * (across + 1));
    for (let j = 0; j < stations; j++) {
      for (let i = 0; i < across; i++) {
        const [from, to] = [j * across + i, 4 * (i * stations + j)];
        texels[to] = arrays.r_mm[from];
        texels[to + 1] = arrays.z_mm[from];
        texels[to + 2] = field && !strand ? field[from] : 0;
      }
      const to = 4 * (across * stations + j);
      texels[to] = arrays.strand_turn_rad[j];
      texels[to + 1] = arrays.strand_angle_deg[j];
      texels[to + 2] = field && strand ? field[j] : 0;
    }
    fill(gl, texture, stations, across + 1, texels);
  }

  const sharpen = rested(() => draw(true), 200);
  /** @param {boolean} [sharp] */
  function draw(sharp = false) {
    if (!gl || !shape) return;
    // Without a graphics processor a moving muscle is drawn coarser, and sharp when it rests.
    const coarse = software() && !sharp;
    if (coarse) sharpen();
    const ratio = coarse ? 0.6 : Math.min(2, devicePixelRatio || 1);
    const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (!w || !h) return;
    if (canvas.width !== w || canvas.height !== h) {
      canvas.width = w;
      canvas.height = h;
    }
    gl.viewport(0, 0, w, h);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const eye = look(w / h),
      strand = show.field.startsWith("strand_");
    gl.useProgram(painter);
    const at = (/** @type {string} */ name) =>
      (places[name] ??= gl.getUniformLocation(painter, name));
    const put = (/** @type {string} */ name, /** @type {number} */ value) =>
      gl.uniform1f(at(name), value);
    gl.uniformMatrix4fv(at("camera"), false, matrix);
    gl.uniform3fv(at("eye"), eye);
    put("outer", shape.across - 1);
    put("cut", show.cut ? 1 : 0);
    gl.uniform2f(at("reach"), show.low, show.high);
    // A power of two: with the measures of the muscle the number of its stations changes to and
    // fro.
    const { stations, across } = shape,
      sharpest = [AROUND, 2 ** Math.ceil(Math.log2(stations))];
    const [around, rows] = coarse ? COARSE : sharpest,
      along = shares(rows);
    put("last", stations - 1);
    const drawPart = (/** @type {Piece} */ part) => {
      gl.bindVertexArray(part.array);
      gl.drawElements(gl.TRIANGLES, part.count, gl.UNSIGNED_INT, 0);
    };
    const surface = (/** @type {number} */ row) =>
      drawPart(piece(`${row} of ${around}`, along, round(row, around)));
    const family = shape.strands ? shape.strands / 2 : DRAWN,
      each = family > MOST ? Math.ceil(family / DRAWN) : 1;
    put("filaments", each);
    gl.uniform3fv(at("map[0]"), VIRIDIS.flat());
    /** What colours a part: the field (1), that of the strands (2), or nothing. */
    const paint = (/** @type {number} */ mapped, /** @type {number[]} */ plain, strands = 0) => {
      put("mapped", mapped);
      gl.uniform3fv(at("plain"), plain);
      put("strands", strands);
    };
    put("flat_normal", 0);
    paint(strand ? 2 : 1, [0.5, 0.48, 0.46], Math.round(family / each));
    // Of a muscle that is whole only the front is seen.
    if (!show.cut) gl.enable(gl.CULL_FACE);
    surface(across - 1);
    gl.disable(gl.CULL_FACE);
    if (show.cut) {
      paint(strand ? 0 : 1, [0.55, 0.52, 0.5]);
      surface(0);
      put("flat_normal", 1);
      put("cut", 0);
      for (const angle of [0, Math.PI / 2])
        drawPart(
          piece(
            `${across} wall ${angle}`,
            along,
            Array.from({ length: across }, (_, i) => [angle, i]),
          ),
        );
    }
    paint(0, [0.56, 0.58, 0.61]);
    put("shine", 0.35);
    plugs(put, drawPart, around);
    put("shine", 0);
    // It is drawn while the page does the rest.
    gl.flush();
    drawn?.();
  }

  /**
   * The fittings at both ends, each with its port.
   * @param {(name: string, value: number) => void} put @param {(part: Piece) => void} drawPart
   * @param {number} around
   */
  function plugs(put, drawPart, around) {
    if (!gl || !shape) return;
    const last = shape.arrays.z_mm.length - 1,
      end = shape.arrays.z_mm[last],
      r = shape.arrays.r_mm[last];
    const profile = FITTING.map(([a, z]) => [a * r, end + z * r]);
    // The first and the last texel only give the others neighbours.
    const all = [profile[0], ...profile, profile[profile.length - 1]];
    const texels = new Float32Array(all.flatMap(([a, z]) => [a, z, 0, 0]));
    fill(gl, plugTexture, all.length, 1, texels);
    put("flat_normal", 0);
    put("cut", 0);
    put("last", profile.length);
    for (const sign of [1, -1])
      drawPart(
        piece(
          `plug ${sign} of ${around}`,
          profile.map((_, j) => (sign * (j + 1)) / profile.length),
          round(0, around),
        ),
      );
    gl.bindTexture(gl.TEXTURE_2D, texture);
  }

  /**
   * Where one looks from: the left end stays where it is; the picture is as wide as the muscle at
   * rest.
   * @param {number} aspect
   */
  function look(aspect) {
    const { restLength, restRadius } = show;
    const now = shape?.length_mm ?? restLength;
    const wide = 0.5 * restLength + 2 * restRadius;
    half = Math.max(wide, Math.max(2.4 * restRadius, 1.15 * largest()) * aspect) / zoom;
    const [pitch, yaw] = turn;
    const [cp, sp, cy, sy] = [Math.cos(pitch), Math.sin(pitch), Math.cos(yaw), Math.sin(yaw)];
    // Turned about the vertical, then tilted; x runs along the muscle.
    const rows = [
      [cy, 0, sy],
      [sp * sy, cp, -sp * cy],
      [-cp * sy, sp, cp * cy],
    ];
    const shift = 0.5 * (now - restLength);
    const scale = [1 / half, aspect / half, -1 / (4 * wide)];
    const m = new Float32Array(16);
    for (let c = 0; c < 3; c++) for (let r = 0; r < 3; r++) m[4 * c + r] = rows[r][c] * scale[r];
    for (let r = 0; r < 3; r++) m[12 + r] = rows[r][0] * shift * scale[r];
    m[15] = 1;
    matrix = m;
    return rows[2];
  }

  /**
   * Where a point of the axis is seen, in pixels of the stage. @param {number} x from its middle
   */
  function project(x) {
    const m = matrix;
    if (!m[15]) return [0, 0];
    const at = (/** @type {number} */ r) => m[r] * x + m[12 + r];
    return [0.5 * (1 + at(0)) * width, 0.5 * (1 - at(1)) * height];
  }

  /** @param {number} by */
  function zoomBy(by) {
    zoom = Math.max(ZOOM[0], Math.min(ZOOM[1], zoom * by));
    draw();
  }

  /** @param {number} pitch @param {number} yaw */
  function turnTo(pitch, yaw) {
    turn = [Math.max(-1.5, Math.min(1.5, pitch)), yaw];
    draw();
  }

  function reset() {
    zoom = 1;
    turnTo(TURN[0], TURN[1]);
  }

  function largest() {
    return Math.max(0, ...(shape?.arrays.r_mm ?? []));
  }

  const perPixel = () => (2 * half) / Math.max(1, width);

  /**
   * Whether a place, as a share of the width, is at the right end of the muscle: its last tenth and
   * what lies beyond.
   * @param {number} share
   */
  function isAtEnd(share) {
    const { restLength } = show;
    const now = shape?.length_mm ?? restLength;
    const place = 0.5 + ((now - 0.5 * restLength) * Math.cos(turn[1])) / (2 * half);
    return Boolean(contract) && share > place - 0.06 && share < place + 0.08;
  }

  /** Without WebGL: the muscle from the side. */
  function section() {
    const { restLength, restRadius } = show;
    if (!shape) return;
    const most = Math.max(1.3 * largest(), 10),
      angle = shape.arrays.strand_angle_deg[0];
    const muscle = body({
      length: shape.length_mm,
      diameter: 2 * restRadius,
      bulged: 2 * largest(),
      angle,
    });
    stage.querySelector("svg.section")?.remove();
    const box = `${-0.1 * restLength} ${-most} ${1.2 * restLength} ${2 * most}`;
    stage.insertAdjacentHTML(
      "afterbegin",
      `<svg class="section" xmlns="http://www.w3.org/2000/svg" role="img" ` +
        `aria-label="The deformed muscle" viewBox="${box}">${muscle}</svg>`,
    );
    // Of a box that is fitted into the stage whole.
    half = 0.5 * Math.max(1.2 * restLength, (2 * most * width) / Math.max(1, height));
    drawn?.();
  }
  if (gl) {
    prepare();
    stage.prepend(canvas);
  }
  const sized = new ResizeObserver(() => {
    ({ clientWidth: width, clientHeight: height } = stage);
    draw(true);
  });
  sized.observe(stage);
  // Nothing of it is kept.
  atEnd(() => {
    sized.disconnect();
    gl?.getExtension("WEBGL_lose_context")?.loseContext();
    canvas.remove();
  });
  return {
    /** Whether it is in space. */
    turns: Boolean(gl),
    set,
    stretched,
    project,
    largest,
    /** For a scale bar. */
    get millimetresPerPixel() {
      return perPixel();
    },
    get show() {
      return show;
    },
    get width() {
      return width;
    },
    get height() {
      return height;
    },
  };
}
