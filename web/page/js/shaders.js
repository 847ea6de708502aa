// Shaders of the muscle in space: a surface turned about its axis, and on it two families of strands that are woven.

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
const SHARED = `#version 300 es
precision highp float;
uniform highp sampler2D shape;   // row 0..across-1: r, z, value; row across: turn, strand angle, tension
uniform mat4 camera;
uniform float outer;             // row of the outer surface
vec4 node(int j, float row) { return texelFetch(shape, ivec2(abs(j), int(row + 0.5)), 0); }
float side(int j) { return j < 0 ? -1.0 : 1.0; }
`;
export const SURFACE =
  SHARED +
  `
in float station; in float angle; in float row;   // station: −1 to 1, from end to end
uniform float flat_normal; uniform float last;
out vec3 place; out vec3 normal; out float value; out vec3 strand;
void main() {
  int j = int(round(station * last));
  vec4 n = node(j, row);
  vec4 a = node(j - 1, row), b = node(j + 1, row), t = node(j, outer + 1.0);
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
export const FRAGMENT = `#version 300 es
precision highp float;
in vec3 place; in vec3 normal; in float value;
in vec3 strand;                  // angle about the axis, turn of a strand from the middle, value of the strands
uniform vec2 reach;              // values at the ends of the colour map
uniform vec3 eye; uniform vec3 plain; uniform float mapped; uniform float cut; uniform float shine;
uniform float strands;           // of a family; 0 draws none
uniform float filaments;         // side by side in a strand
uniform vec3 map[9];             // colours of the map
out vec4 colour;
const float PI = 3.14159265;
// Half the width of a strand, of the distance between two.
#define HALF (filaments > 1.0 ? 0.4 : 0.16)
vec3 viridis(float t) {
  int i = min(int(8.0 * t), 7);
  return mix(map[i], map[i + 1], 8.0 * t - float(i)) / 255.0;
}
vec3 shown(float v) { return viridis(clamp((v - reach.x) / max(reach.y - reach.x, 1e-9), 0.0, 1.0)); }
float lit(vec3 n) {
  return 0.35 + 0.4 * max(dot(n, eye), 0.0) + 0.3 * max(dot(n, normalize(vec3(-0.3, 0.4, 0.85))), 0.0);
}
// Off the middle of the nearest strand, in distances between two.
float off(float u) { return fract(u + 0.5) - 0.5; }
// How much of a point a strand covers, its edges as soft as a pixel is wide.
float covered(float d, float pixel) { return 1.0 - smoothstep(HALF - 0.6 * pixel, HALF + 0.6 * pixel, abs(d)); }
vec3 woven(vec3 rubber, vec3 fibre) {
  vec2 u = vec2(strand.x - strand.y, strand.x + strand.y) * strands / (2.0 * PI);
  vec2 pixel = max(fwidth(u), vec2(1e-4));
  // Too fine to be seen one by one.
  float fine = smoothstep(0.25, 0.5, max(pixel.x, pixel.y));
  vec2 d = vec2(off(u.x), off(u.y)), at = u - d;
  vec2 on = vec2(covered(d.x, pixel.x), covered(d.y, pixel.y));
  // A strand goes over every second one of the other family, and under those between: its height as it waves from one
  // to the next.
  vec2 high = vec2(cos(PI * (u.y + at.x)), -cos(PI * (u.x + at.y)));
  bool first = on.x > 0.5 && (on.y < 0.5 || high.x > high.y);
  float across = (first ? d.x : d.y) / HALF, height = first ? high.x : high.y, cover = max(on.x, on.y);
  // The shadow of strands beside a point: on the rubber, and on a strand that dives under another one.
  vec2 near = smoothstep(vec2(2.6 * HALF), vec2(HALF), abs(d));
  float other = first ? near.y : near.x;
  float shade = 1.0 - 0.5 * max(near.x, near.y);
  // Round across the strand, or across each of its filaments.
  float within = filaments > 1.0 ? 2.0 * off(0.5 * filaments * (across + 1.0) + 0.5) : across;
  float rounding = 0.55 + 0.45 * sqrt(max(0.0, 1.0 - within * within));
  float wave = mix(1.0, 0.72 + 0.28 * height, other);
  vec3 thread = fibre * rounding * wave;
  vec3 seen = mix(rubber * shade, thread, cover);
  return mix(seen, mix(rubber * 0.75, fibre * 0.8, 0.5), fine);
}
void main() {
  if (cut > 0.5 && place.y > 1e-4 && place.z > 1e-4) discard;
  vec3 n = normalize(normal);
  if (dot(n, eye) < 0.0) n = -n;
  vec3 base = mapped > 0.5 && mapped < 1.5 ? shown(value) : plain;
  if (strands > 0.5) base = woven(base, mapped > 1.5 ? shown(strand.z) : mix(vec3(0.96, 0.95, 0.92), base, filaments > 1.0 ? 0.7 : 0.3));
  float gloss = shine * pow(max(dot(n, normalize(eye + normalize(vec3(-0.3, 0.8, 0.85)))), 0.0), 24.0);
  colour = vec4(base * lit(n) + gloss, 1.0);
}`;
