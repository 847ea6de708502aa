// The muscle in space: one lit surface turned about the axis, its strands, and the terminals. WebGL2; without it an
// SVG.
//
// What the engine knows along the half muscle goes into one small texture; where each point of surface or strand lies
// follows from it on the graphics processor, so that a new shape costs one upload of a few kilobytes.
import { body, pictures } from "./body.js";
import { el } from "./dom.js";
import { atEnd } from "./life.js";
import { FRAGMENT, SURFACE, VIRIDIS } from "./shaders.js";

/** Columns of a mesh about the axis; columns and rows while it moves, where there is no graphics processor. */
const AROUND = 48,
  COARSE = [24, 40];
/** Strands drawn of a family whose number is not known, and most that are drawn: more lie side by side in flat ones. */
const DRAWN = 18,
  MOST = 40;
/** How the muscle is first seen, and how far it may be zoomed. */
const TURN = [0.35, -0.5],
  ZOOM = [0.5, 8];
/** The profile of a crimped fitting, all edges: radius and distance from the tube's end, as shares of the tube's radius. */
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
  Array.from({ length: around + 1 }, (_, k) => [
    (2 * Math.PI * k) / around,
    row,
  ]);

/** Rows of a mesh from one end to the other: so many in each half, as shares. @param {number} half */
const shares = (half) =>
  Array.from({ length: 2 * half + 1 }, (_, i) => i / half - 1);

/** @param {WebGL2RenderingContext} gl @param {string} vertex */
function program(gl, vertex) {
  const made = /** @type {WebGLProgram} */ (gl.createProgram());
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

/** A texture whose texels are read as they are. @param {WebGL2RenderingContext} gl */
function table(gl) {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
    gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
  return texture;
}

/** @type {boolean | undefined} */ let slow;
/** Whether WebGL runs without a graphics processor: smooth edges would then cost more than all the rest. */
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
 * Between which values the colours run: the few nodes at the bonded corner would take the whole map.
 * @param {ArrayLike<number>} list @returns {[number, number]}
 */
export function reach(list) {
  const sorted = Float64Array.from(list).sort();
  return [
    sorted[Math.floor(0.01 * sorted.length)],
    sorted[Math.ceil(0.985 * sorted.length) - 1],
  ];
}

/**
 * What colours the muscle and between which values; its length and radius at rest.
 * @typedef {{ field: string, low: number, high: number, restLength: number, restRadius: number }} Show
 * What is drawn of an answer of `shape`.
 * @typedef {{ stations: number, across: number, arrays: Record<string, number[] | Float32Array>, length_mm: number,
 *   strands?: number | null }} Shape
 * @typedef {{ array: WebGLVertexArrayObject, count: number }} Piece
 */

export class View {
  /**
   * @param {HTMLElement} stage
   * @param {{ contract?: (share: number, settled: boolean) => void, drawn?: () => void }} handlers
   *   share: of the rest length, that the dragged end moves; drawn: after each picture
   */
  constructor(stage, { contract, drawn } = {}) {
    this.stage = stage;
    this.turn = [...TURN];
    this.zoom = 1;
    this.contract = contract;
    this.drawn = drawn;
    this.cut = false;
    /** @type {Shape | undefined} */ this.shape = undefined;
    /** @type {Show} */
    this.show = { field: "", low: 0, high: 1, restLength: 1, restRadius: 1 };
    /** @type {WebGLTexture | null} */ this.plugTexture = null;
    /** Parts of the mesh. @type {Map<string, Piece>} */
    this.pieces = new Map();
    this.canvas = el("canvas", {
      role: "img",
      "aria-label": "The deformed muscle",
    });
    const gl = this.canvas.getContext("webgl2", {
      antialias: !software(),
      alpha: true,
    });
    this.gl = gl;
    if (gl) {
      this.prepare(gl);
      stage.prepend(this.canvas);
      this.listen();
      pictures.set(this.canvas, () => {
        this.draw(true);
        return this.canvas.toDataURL();
      });
      this.canvas.addEventListener("webglcontextlost", (event) =>
        event.preventDefault(),
      );
      this.canvas.addEventListener("webglcontextrestored", () => {
        this.prepare(gl);
        this.upload();
        this.draw();
      });
    }
    /** Of the stage, in pixels of the page; asking for it every time would lay the page out anew. */
    this.width = stage.clientWidth;
    this.height = stage.clientHeight;
    this.rest = 0;
    this.sized = new ResizeObserver(() => {
      // On paper the stage has no place, and its picture is made.
      if (!stage.clientWidth) return;
      this.width = stage.clientWidth;
      this.height = stage.clientHeight;
      this.draw(true);
    });
    this.sized.observe(stage);
    atEnd(() => this.#destroy());
  }

  /** @param {WebGL2RenderingContext} gl */
  prepare(gl) {
    this.surface = program(gl, SURFACE);
    /** Where its uniforms are, once they are asked for. @type {Record<string, WebGLUniformLocation | null>} */
    this.places = {};
    this.texture = table(gl);
    this.plugTexture = table(gl);
    gl.enable(gl.DEPTH_TEST);
    this.pieces = new Map();
  }

  /**
   * Points and triangles of columns of angle and row over shares of the half muscle, whose neighbours are joined; made
   * once for a name.
   * @param {string} name @param {number[]} along @param {number[][]} columns @returns {Piece}
   */
  piece(name, along, columns) {
    const key = `${name} ${along.length}`,
      known = this.pieces.get(key);
    if (known) return known;
    const gl = /** @type {WebGL2RenderingContext} */ (this.gl),
      program = /** @type {WebGLProgram} */ (this.surface);
    const data = columns.flatMap(([angle, row]) =>
        along.flatMap((t) => [t, angle, row]),
      ),
      count = along.length;
    const index = columns.slice(1).flatMap((_, k) =>
      along.slice(1).flatMap((__, i) => {
        const a = k * count + i,
          b = a + count;
        return [a, b, a + 1, b, b + 1, a + 1];
      }),
    );
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(data), gl.STATIC_DRAW);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(
      gl.ELEMENT_ARRAY_BUFFER,
      new Uint32Array(index),
      gl.STATIC_DRAW,
    );
    ["station", "angle", "row"].forEach((name, i) => {
      const at = gl.getAttribLocation(program, name);
      if (at < 0) return;
      gl.enableVertexAttribArray(at);
      gl.vertexAttribPointer(at, 1, gl.FLOAT, false, 12, 4 * i);
    });
    const made = { array, count: index.length };
    this.pieces.set(key, made);
    return made;
  }

  /**
   * A new shape: the answer of `shape`; what colours it and between which values.
   * @param {Shape & { muscle: MuscleMeasures }} shape @param {Omit<Show, "restLength" | "restRadius">} show
   */
  set(shape, show) {
    this.shape = shape;
    const { length_mm: restLength, outer_diameter_mm: diameter } = shape.muscle;
    this.show = { ...show, restLength, restRadius: diameter / 2 };
    if (this.gl) {
      this.upload();
      this.draw();
    } else this.section();
  }

  /**
   * A shape by its largest stretch.
   * @param {Shape & { muscle: MuscleMeasures }} shape
   */
  stretched(shape) {
    this.set(shape, {
      field: "max_stretch",
      low: 1,
      high: Math.max(1.2, reach(shape.arrays.max_stretch)[1]),
    });
  }

  upload() {
    const { gl, shape, show } = this;
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
    gl.bindTexture(gl.TEXTURE_2D, this.texture ?? null);
    gl.texImage2D(
      gl.TEXTURE_2D,
      0,
      gl.RGBA32F,
      stations,
      across + 1,
      0,
      gl.RGBA,
      gl.FLOAT,
      texels,
    );
  }

  /** @param {boolean} [sharp] */
  draw(sharp = false) {
    const { gl, shape, canvas } = this;
    if (!gl || !shape) return;
    // Without a graphics processor a moving muscle is drawn coarser, and sharp when it rests.
    const coarse = software() && !sharp;
    if (coarse) {
      clearTimeout(this.rest);
      this.rest = window.setTimeout(() => this.draw(true), 200);
    }
    const ratio = coarse ? 0.6 : Math.min(2, devicePixelRatio || 1);
    const [w, h] = [
      Math.round(this.width * ratio),
      Math.round(this.height * ratio),
    ];
    if (!w || !h) return;
    if (canvas.width !== w || canvas.height !== h) {
      canvas.width = w;
      canvas.height = h;
    }
    gl.viewport(0, 0, w, h);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const { camera, eye } = this.camera(w / h);
    const strand = this.show.field.startsWith("strand_");
    const program = /** @type {WebGLProgram} */ (this.surface),
      { places = {} } = this;
    gl.useProgram(program);
    const at = (/** @type {string} */ name) =>
      (places[name] ??= gl.getUniformLocation(program, name));
    gl.uniformMatrix4fv(at("camera"), false, camera);
    gl.uniform3fv(at("eye"), eye);
    gl.uniform1f(at("outer"), shape.across - 1);
    gl.uniform1f(at("cut"), this.cut ? 1 : 0);
    gl.uniform2f(at("reach"), this.show.low, this.show.high);
    // A power of two: with the measures of the muscle the number of its stations changes to and fro.
    const { stations, across } = shape,
      sharpest = [AROUND, 2 ** Math.ceil(Math.log2(stations))];
    const [around, half] = coarse ? COARSE : sharpest,
      along = shares(half);
    gl.uniform1f(at("last"), stations - 1);
    const draw = (/** @type {Piece} */ part) => {
      gl.bindVertexArray(part.array);
      gl.drawElements(gl.TRIANGLES, part.count, gl.UNSIGNED_INT, 0);
    };
    const surface = (/** @type {number} */ row) =>
      draw(this.piece(`${row} of ${around}`, along, round(row, around)));
    const family = shape.strands ? shape.strands / 2 : DRAWN,
      each = family > MOST ? Math.ceil(family / DRAWN) : 1;
    gl.uniform1f(at("filaments"), each);
    gl.uniform3fv(at("map[0]"), VIRIDIS.flat());
    /** What colours a part: the field (1), that of the strands (2), or nothing. */
    const paint = (
      /** @type {number} */ mapped,
      /** @type {number[]} */ plain,
      strands = 0,
    ) => {
      gl.uniform1f(at("mapped"), mapped);
      gl.uniform3fv(at("plain"), plain);
      gl.uniform1f(at("strands"), strands);
    };
    gl.uniform1f(at("flat_normal"), 0);
    paint(strand ? 2 : 1, [0.5, 0.48, 0.46], Math.round(family / each));
    // Of a muscle that is whole only the front is seen.
    if (!this.cut) gl.enable(gl.CULL_FACE);
    surface(across - 1);
    gl.disable(gl.CULL_FACE);
    if (this.cut) {
      paint(strand ? 0 : 1, [0.55, 0.52, 0.5]);
      surface(0);
      gl.uniform1f(at("flat_normal"), 1);
      gl.uniform1f(at("cut"), 0);
      for (const angle of [0, Math.PI / 2])
        draw(
          this.piece(
            `${across} wall ${angle}`,
            along,
            Array.from({ length: across }, (_, i) => [angle, i]),
          ),
        );
    }
    paint(0, [0.56, 0.58, 0.61]);
    gl.uniform1f(at("shine"), 0.35);
    this.plugs(at, draw, around);
    gl.uniform1f(at("shine"), 0);
    // It is drawn while the page does the rest.
    gl.flush();
    this.drawn?.();
  }

  /**
   * The fittings at both ends, each with its port.
   * @param {(name: string) => WebGLUniformLocation | null} at @param {(part: Piece) => void} draw
   * @param {number} around
   */
  plugs(at, draw, around) {
    const { gl, shape } = this;
    if (!gl || !shape) return;
    const last = shape.arrays.z_mm.length - 1,
      end = shape.arrays.z_mm[last],
      r = shape.arrays.r_mm[last];
    const profile = FITTING.map(([a, z]) => [a * r, end + z * r]);
    // The first and the last texel only give the others neighbours.
    const all = [profile[0], ...profile, profile[profile.length - 1]];
    gl.bindTexture(gl.TEXTURE_2D, this.plugTexture);
    const texels = new Float32Array(all.flatMap(([a, z]) => [a, z, 0, 0]));
    gl.texImage2D(
      gl.TEXTURE_2D,
      0,
      gl.RGBA32F,
      all.length,
      1,
      0,
      gl.RGBA,
      gl.FLOAT,
      texels,
    );
    gl.uniform1f(at("flat_normal"), 0);
    gl.uniform1f(at("cut"), 0);
    gl.uniform1f(at("last"), profile.length);
    for (const sign of [1, -1])
      draw(
        this.piece(
          `plug ${sign} of ${around}`,
          profile.map((_, j) => (sign * (j + 1)) / profile.length),
          round(0, around),
        ),
      );
    gl.bindTexture(gl.TEXTURE_2D, this.texture ?? null);
  }

  /** The left end stays where it is; the picture is as wide as the muscle at rest. @param {number} aspect */
  camera(aspect) {
    const { restLength, restRadius } = this.show;
    const now = this.shape?.length_mm ?? this.show.restLength;
    const wide = 0.5 * restLength + 2 * restRadius;
    const half =
      Math.max(
        wide,
        Math.max(2.4 * restRadius, 1.15 * this.largest()) * aspect,
      ) / this.zoom;
    this.half = half;
    const [pitch, yaw] = this.turn;
    const [cp, sp, cy, sy] = [
      Math.cos(pitch),
      Math.sin(pitch),
      Math.cos(yaw),
      Math.sin(yaw),
    ];
    // Turned about the vertical, then tilted; x runs along the muscle.
    const rows = [
      [cy, 0, sy],
      [sp * sy, cp, -sp * cy],
      [-cp * sy, sp, cp * cy],
    ];
    const shift = 0.5 * (now - restLength);
    const scale = [1 / half, aspect / half, -1 / (4 * wide)];
    const m = new Float32Array(16);
    for (let c = 0; c < 3; c++)
      for (let r = 0; r < 3; r++) m[4 * c + r] = rows[r][c] * scale[r];
    for (let r = 0; r < 3; r++) m[12 + r] = rows[r][0] * shift * scale[r];
    m[15] = 1;
    this.matrix = m;
    return { camera: m, eye: rows[2] };
  }

  /**
   * Where a point of the muscle is seen, in pixels of the stage: along its axis from its middle, up, and to the front.
   * @param {number} x @param {number} y @param {number} z
   */
  project(x, y, z) {
    const m = this.matrix;
    if (!m) return [0, 0];
    const at = (/** @type {number} */ r) =>
      m[r] * x + m[4 + r] * y + m[8 + r] * z + m[12 + r];
    return [0.5 * (1 + at(0)) * this.width, 0.5 * (1 - at(1)) * this.height];
  }

  /** @param {number} by */
  zoomBy(by) {
    this.zoom = Math.max(ZOOM[0], Math.min(ZOOM[1], this.zoom * by));
    this.draw();
  }

  /** @param {number} pitch @param {number} yaw */
  turnTo(pitch, yaw) {
    this.turn = [Math.max(-1.5, Math.min(1.5, pitch)), yaw];
    this.draw();
  }

  reset() {
    this.zoom = 1;
    this.turnTo(TURN[0], TURN[1]);
  }

  largest() {
    let most = 0;
    for (const r of this.shape?.arrays.r_mm ?? []) most = Math.max(most, r);
    return most;
  }

  /** For a scale bar. */
  get millimetresPerPixel() {
    return (2 * (this.half ?? 1)) / Math.max(1, this.width);
  }

  /** Nothing of it is kept. */
  #destroy() {
    clearTimeout(this.rest);
    this.sized.disconnect();
    this.gl?.getExtension("WEBGL_lose_context")?.loseContext();
    this.canvas.remove();
  }

  listen() {
    this.listenToPointers();
    const { canvas } = this;
    canvas.addEventListener(
      "wheel",
      (event) => {
        if (
          !event.ctrlKey &&
          !event.shiftKey &&
          document.activeElement !== canvas
        )
          return;
        event.preventDefault();
        this.zoomBy(Math.exp(-0.001 * event.deltaY));
      },
      { passive: false },
    );
    canvas.tabIndex = 0;
    canvas.addEventListener("keydown", (event) => {
      const step = {
        ArrowLeft: [0, -0.1],
        ArrowRight: [0, 0.1],
        ArrowUp: [-0.1, 0],
        ArrowDown: [0.1, 0],
      }[event.key];
      if (event.key === "+" || event.key === "-")
        this.zoomBy(event.key === "+" ? 1.2 : 1 / 1.2);
      else if (event.key === "0" || event.key === "Home") this.reset();
      else if (step)
        this.turnTo(this.turn[0] + step[0], this.turn[1] + step[1]);
      else return;
      event.preventDefault();
    });
    canvas.addEventListener("dblclick", () => this.reset());
  }

  /**
   * Whether a place, as a share of the width, is at the right end of the muscle: its last tenth and what lies beyond.
   * @param {number} share
   */
  #isAtEnd(share) {
    const { restLength } = this.show;
    const now = this.shape?.length_mm ?? restLength;
    const place =
      0.5 +
      ((now - 0.5 * restLength) * Math.cos(this.turn[1])) /
        (2 * (this.half ?? 1));
    return (
      Boolean(this.contract) && share > place - 0.06 && share < place + 0.08
    );
  }

  /** One pointer turns, or drags the end; two zoom. */
  listenToPointers() {
    const { canvas } = this;
    /** @type {Map<number, PointerEvent>} */
    const down = new Map();
    /** @type {{ x: number, y: number, turn: number[], end: boolean } | undefined} */ let from;
    let apart = 0;
    const distance = () => {
      const [a, b] = [...down.values()];
      return Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
    };
    const moved = (
      /** @type {PointerEvent} */ event,
      /** @type {boolean} */ settled,
    ) => {
      if (!from) return;
      const [dx, dy] = [event.clientX - from.x, event.clientY - from.y];
      if (!from.end)
        return this.turnTo(
          from.turn[0] + 0.008 * dy,
          from.turn[1] + 0.008 * dx,
        );
      const along =
        (dx * this.millimetresPerPixel) / Math.max(0.3, Math.cos(this.turn[1]));
      this.contract?.(-along / this.show.restLength, settled);
    };
    canvas.addEventListener("pointerdown", (event) => {
      if (!this.shape) return;
      down.set(event.pointerId, event);
      canvas.setPointerCapture(event.pointerId);
      if (down.size > 1) {
        from = undefined;
        apart = distance();
        return;
      }
      const box = canvas.getBoundingClientRect(),
        end = this.#isAtEnd((event.clientX - box.left) / box.width);
      from = { x: event.clientX, y: event.clientY, turn: [...this.turn], end };
      canvas.style.cursor = end ? "ew-resize" : "grabbing";
    });
    canvas.addEventListener("pointermove", (event) => {
      if (!down.has(event.pointerId)) return;
      down.set(event.pointerId, event);
      if (down.size < 2) return moved(event, false);
      const now = distance();
      if (apart > 0 && now > 0) this.zoomBy(now / apart);
      apart = now;
    });
    const up = (/** @type {PointerEvent} */ event) => {
      down.delete(event.pointerId);
      if (event.type === "pointerup") moved(event, true);
      from = undefined;
      canvas.style.cursor = "";
    };
    canvas.addEventListener("pointerup", up);
    canvas.addEventListener("pointercancel", up);
  }

  /** Without WebGL: the muscle from the side. */
  section() {
    const {
      shape,
      show: { restLength, restRadius },
    } = this;
    if (!shape) return;
    const most = Math.max(1.3 * this.largest(), 10),
      angle = shape.arrays.strand_angle_deg[0];
    const muscle = body({
      length: shape.length_mm,
      diameter: 2 * restRadius,
      bulged: 2 * this.largest(),
      angle,
    });
    this.stage.querySelector("svg.section")?.remove();
    const box = `${-0.1 * restLength} ${-most} ${1.2 * restLength} ${2 * most}`;
    this.stage.insertAdjacentHTML(
      "afterbegin",
      `<svg class="section" xmlns="http://www.w3.org/2000/svg" role="img" ` +
        `aria-label="The deformed muscle" viewBox="${box}">${muscle}</svg>`,
    );
    // Of a box that is fitted into the stage whole.
    this.half =
      0.5 *
      Math.max(
        1.2 * restLength,
        (2 * most * this.width) / Math.max(1, this.height),
      );
    this.drawn?.();
  }
}
