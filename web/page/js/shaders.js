// Shaders of the muscle in space: a surface turned about its axis, and on it two families of
// strands that are woven.

/** Red, green and blue of viridis at equal distances. */
export const VIRIDIS = [
  [68, 1, 84],
  [71, 44, 122],
  [59, 81, 139],
  [44, 113, 142],
  [33, 144, 141],
  [39, 173, 129],
  [92, 200, 99],
  [170, 220, 50],
  [253, 231, 37],
];
/**
 * A point of the surface. `shape` has in its rows 0 to across − 1 radius, z and value, in the row
 * behind them turn, angle and tension of the strands; `outer` is the row of the outer surface;
 * `station` runs from −1 to 1, from end to end.
 */
export const SURFACE = `#version 300 es
precision highp float;
uniform highp sampler2D shape;
uniform mat4 camera;
uniform float outer, flat_normal, last;
in float station, angle, row;
out vec3 place, normal, strand;
out float value;
vec4 node(int j, float row) { return texelFetch(shape, ivec2(abs(j), int(row + 0.5)), 0); }
float side(int j) { return j < 0 ? -1.0 : 1.0; }
void main() {
  int j = int(round(station * last));
  vec4 n = node(j, row), a = node(j - 1, row), b = node(j + 1, row), t = node(j, outer + 1.0);
  float z = n.y * side(j), dz = b.y * side(j + 1) - a.y * side(j - 1), dr = b.x - a.x;
  vec2 slope = normalize(vec2(-dr, max(dz, 1e-6)));
  float c = cos(angle), s = sin(angle);
  place = vec3(z, n.x * c, n.x * s);
  vec3 round_normal = vec3(slope.x, slope.y * c, slope.y * s) * (row > 0.5 ? 1.0 : -1.0);
  normal = flat_normal > 0.5 ? vec3(0.0, -s, c) : round_normal;
  value = n.z;
  strand = vec3(angle, t.x * side(j), t.z);
  gl_Position = camera * vec4(place, 1.0);
}`;

/**
 * Its colour: that of the map, of which `reach` are the values at the ends, or `plain`. `strand`:
 * angle about the axis, turn of a strand from the middle, and its value. `strands` of a family (0
 * draws none) have so many `filaments` side by side, and cover HALF of the distance between two to
 * each side.
 *
 * `off` is the way from the middle of the nearest strand, in distances between two; `covered` how
 * much of a point a strand covers, its edges as soft as a pixel is wide. A strand goes over every
 * second one of the other family, and under those between: `high` is its height as it waves from
 * one to the next. Strands beside a point shade the rubber, and a strand that dives under another
 * one. Round is the strand, or each of its filaments. What is too `fine` to be seen one by one has
 * the mean of both colours.
 */
export const FRAGMENT = `#version 300 es
precision highp float;
in vec3 place, normal, strand;
in float value;
uniform vec2 reach;
uniform vec3 eye, plain, map[9];
uniform float mapped, cut, shine, strands, filaments;
out vec4 colour;
const float PI = 3.14159265;
#define HALF (filaments > 1.0 ? 0.4 : 0.16)
vec3 shown(float v) {
  float t = 8.0 * clamp((v - reach.x) / max(reach.y - reach.x, 1e-9), 0.0, 1.0);
  int i = min(int(t), 7);
  return mix(map[i], map[i + 1], t - float(i)) / 255.0;
}
float lit(vec3 n) {
  return 0.35 + 0.4 * max(dot(n, eye), 0.0) + 0.3 * max(dot(n, normalize(vec3(-0.3, 0.4, 0.85))), 0.0);
}
float off(float u) { return fract(u + 0.5) - 0.5; }
float covered(float d, float pixel) { return 1.0 - smoothstep(HALF - 0.6 * pixel, HALF + 0.6 * pixel, abs(d)); }
vec3 woven(vec3 rubber, vec3 fibre) {
  vec2 u = vec2(strand.x - strand.y, strand.x + strand.y) * strands / (2.0 * PI);
  vec2 pixel = max(fwidth(u), vec2(1e-4));
  float fine = smoothstep(0.25, 0.5, max(pixel.x, pixel.y));
  vec2 d = vec2(off(u.x), off(u.y)), at = u - d;
  vec2 on = vec2(covered(d.x, pixel.x), covered(d.y, pixel.y));
  vec2 high = vec2(cos(PI * (u.y + at.x)), -cos(PI * (u.x + at.y)));
  bool first = on.x > 0.5 && (on.y < 0.5 || high.x > high.y);
  float across = (first ? d.x : d.y) / HALF, height = first ? high.x : high.y, cover = max(on.x, on.y);
  vec2 near = smoothstep(vec2(2.6 * HALF), vec2(HALF), abs(d));
  float within = filaments > 1.0 ? 2.0 * off(0.5 * filaments * (across + 1.0) + 0.5) : across;
  float rounding = 0.55 + 0.45 * sqrt(max(0.0, 1.0 - within * within));
  float wave = mix(1.0, 0.72 + 0.28 * height, first ? near.y : near.x);
  vec3 seen = mix(rubber * (1.0 - 0.5 * max(near.x, near.y)), fibre * rounding * wave, cover);
  return mix(seen, mix(rubber * 0.75, fibre * 0.8, 0.5), fine);
}
void main() {
  if (cut > 0.5 && place.y > 1e-4 && place.z > 1e-4) discard;
  vec3 n = normalize(normal);
  if (dot(n, eye) < 0.0) n = -n;
  vec3 base = mapped > 0.5 && mapped < 1.5 ? shown(value) : plain;
  vec3 thread = mix(vec3(0.96, 0.95, 0.92), base, filaments > 1.0 ? 0.7 : 0.3);
  if (strands > 0.5) base = woven(base, mapped > 1.5 ? shown(strand.z) : thread);
  float gloss = shine * pow(max(dot(n, normalize(eye + normalize(vec3(-0.3, 0.8, 0.85)))), 0.0), 24.0);
  colour = vec4(base * lit(n) + gloss, 1.0);
}`;
