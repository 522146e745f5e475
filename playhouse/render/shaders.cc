#include "playhouse/render/shaders.h"

namespace playhouse::render {
namespace {

constexpr const char* kVersion = "#version 450 core\n";

// Layout as in renderer.cc (ViewBlock).
constexpr const char* kView = R"(
layout(std140, binding = 0) uniform ViewBlock {
  mat4 clip;         // from E
  mat4 sun_clip;     // from E to the shadow map
  vec4 ahead;        // axes of the camera; w: near
  vec4 left;         // times half the width; w: far
  vec4 up;           // times half the height; w: height of the eye above the floor
  vec4 viewport;     // px: left, low, width, height
  vec4 to_sun;       // w: light of the sun
  vec4 sky;          // w: light from everywhere
  vec4 fog;          // w: extinction, 1/m
  vec4 floor_color;  // w: side of a texel of the shadow map, m
  vec4 eye;          // in W, less whole metres of the pattern of the floor; w: seconds
};
)";

// Layout as in renderer.cc (LampBlock). 16 is kMostLamps.
constexpr const char* kLight = R"(
layout(std140, binding = 2) uniform LampBlock {
  vec4 lamp_count;      // x
  vec4 lamp_at[16];     // in E; w: cosine of where a spot ends
  vec4 lamp_way[16];    // w: cosine up to which it shines fully
  vec4 lamp_light[16];  // of a white face at 1 m
};
layout(binding = 0) uniform sampler2DShadow shadow_map;

/// How much of the sun reaches p, of a surface with the normal n.
float sunlit(vec3 p, vec3 n) {
  vec3 q = (sun_clip * vec4(p + 1.5 * floor_color.w * n, 1)).xyz;
  q.xy = vec2(0.5, -0.5) * q.xy + 0.5;  // rows of pictures go down
  if (any(lessThan(q, vec3(0))) || any(greaterThan(q, vec3(1)))) return 1;
  vec2 texel = 0.75 / vec2(textureSize(shadow_map, 0));
  float lit = 0;
  for (int i = 0; i < 4; ++i)
    lit += texture(shadow_map, vec3(q.xy + texel * vec2(i % 2 * 2 - 1, i / 2 * 2 - 1), q.z));
  return 0.25 * lit;
}

/// The light that comes from direction d, blurred.
vec3 light_from(vec3 d) {
  vec3 above = mix(vec3(1), sky.rgb / max(max(sky.r, sky.g), max(sky.b, 0.01)), 0.5);
  return sky.w * mix(floor_color.rgb * 0.6, above, 0.5 + 0.5 * d.z);
}

/// What a white face at p gets from lamp i, and the way d to it; less than nothing of one that is behind it.
float lamplit(int i, vec3 p, vec3 n, out vec3 d) {
  vec3 way = lamp_at[i].xyz - p;
  float square = max(dot(way, way), 1e-4);
  d = way * inversesqrt(square);
  float spot = lamp_at[i].w > -1 ? smoothstep(lamp_at[i].w, max(lamp_way[i].w, lamp_at[i].w + 1e-4), -dot(d, lamp_way[i].xyz)) : 1;
  return spot * dot(n, d) / square;
}

/// What a surface returns to v of light from l, for each share that meets a face square on (Cook and
/// Torrance, 1982, with the terms of Walter et al., 2007, and Schlick, 1994).
vec3 returned(vec3 l, vec3 v, vec3 n, vec3 diffuse, vec3 f0, float roughness) {
  float nl = dot(n, l), nv = max(dot(n, v), 1e-3);
  vec3 h = normalize(v + l);
  float nh = max(dot(n, h), 0), vh = max(dot(v, h), 0);
  float a = max(roughness * roughness, 0.02), a2 = a * a;
  float bump = nh * nh * (a2 - 1) + 1;
  float spread = a2 / (3.14159265 * bump * bump);
  float visible = 0.5 / (nl * sqrt(nv * nv * (1 - a2) + a2) + nv * sqrt(nl * nl * (1 - a2) + a2));
  float aside = 1 - vh, aside2 = aside * aside;
  vec3 fresnel = f0 + (1 - f0) * (aside2 * aside2 * aside);
  return diffuse * (1 - fresnel) + 3.14159265 * fresnel * spread * visible;
}

vec3 shade(vec3 p, vec3 n, vec3 base, float metallic, float roughness) {
  vec3 v = -normalize(p);
  float nv = max(dot(n, v), 1e-3), nl = dot(n, to_sun.xyz);
  vec3 f0 = mix(vec3(0.04), base, metallic), diffuse = base * (1 - metallic);
  float away = 1 - nv, away2 = away * away;
  vec3 mirror = f0 + (max(vec3(1 - roughness), f0) - f0) * (away2 * away2 * away);
  vec3 light = diffuse * light_from(n) + mirror * light_from(reflect(-v, n)) * (1 - 0.6 * roughness);
  if (nl > 0 && to_sun.w > 0)
    light += returned(to_sun.xyz, v, n, diffuse, f0, roughness) * (to_sun.w * nl * sunlit(p, n));
  for (int i = 0; i < int(lamp_count.x); ++i) {
    vec3 d;
    float lit = lamplit(i, p, n, d);
    if (lit > 0) light += returned(d, v, n, diffuse, f0, roughness) * lamp_light[i].rgb * lit;
  }
  return light;
}

/// What fog leaves of light from p.
vec3 through_fog(vec3 light, vec3 p) {
  return fog.w > 0 ? mix(fog.rgb, light, exp(-fog.w * length(p))) : light;
}
)";

constexpr const char* kPlace = R"(
layout(location = 4) in vec4 row0;
layout(location = 5) in vec4 row1;
layout(location = 6) in vec4 row2;
layout(location = 7) in vec4 tint;
layout(location = 8) in uvec2 mark;  // of segments; the first of its bones
layout(location = 9) in float glow;

vec3 placed(vec3 p) { return vec3(dot(row0, vec4(p, 1)), dot(row1, vec4(p, 1)), dot(row2, vec4(p, 1))); }
vec3 turned(vec3 d) { return vec3(dot(row0.xyz, d), dot(row1.xyz, d), dot(row2.xyz, d)); }
)";

constexpr const char* kRigid = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
vec3 body_position() { return position; }
vec3 body_normal() { return normal; }
)";

constexpr const char* kBent = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 paint;  // a: share of the tint
layout(location = 3) in vec4 bones;  // two of them, and the share of the first
layout(std430, binding = 1) readonly buffer Bones { vec4 bone_row[]; };

/// A row of the matrix of a corner.
vec4 bend(uint row) {
  uvec2 at = 3 * (mark.y + uvec2(bones.xy)) + row;
  return mix(bone_row[at.y], bone_row[at.x], bones.z);
}
vec4 bend0 = bend(0), bend1 = bend(1), bend2 = bend(2);
vec3 bent(vec4 p) { return vec3(dot(bend0, p), dot(bend1, p), dot(bend2, p)); }
vec3 body_position() { return bent(vec4(position, 1)); }
vec3 body_normal() { return bent(vec4(normal, 0)); }
)";

/// Varyings for fragments.
std::string passed_on(Bends bends, Paints paints) {
  if (paints == Paints::kSegments) return "  segment = mark.x;\n";
  if (paints == Paints::kDepth) return "";
  return std::string("  p_E = p;\n  n_E = turned(body_normal());\n  glows = glow;\n") +
         (bends == Bends::kYes
              ? "  base = vec4(mix(paint.rgb, tint.rgb, paint.a), tint.a);\n  at = vec2(0);\n"
              : "  base = tint;\n  at = uv;\n");
}

std::string varying(Paints paints, const char* way) {
  const std::string to = way;
  if (paints == Paints::kSegments) return "flat " + to + " uint segment;\n";
  if (paints == Paints::kDepth) return "";
  return to + " vec3 p_E;\n" + to + " vec3 n_E;\n" + to + " vec4 base;\n" + to + " vec2 at;\nflat " + to +
         " float glows;\n";
}

constexpr const char* kSurface = R"(
layout(binding = 1) uniform sampler2D surface_texture;
uniform vec4 material;  // metallic, roughness, 1: has a texture, SurfaceRange::least_opacity
uniform vec4 material_base;
uniform vec3 emission;
layout(location = 0) out vec4 color;
)";

// Layout as in renderer.cc (MirrorPrograms). 4 is kMostMirrors.
constexpr const char* kMirrors = R"(
layout(binding = 2) uniform sampler2DArray mirrored;  // what each shows through all the fog: a layer each
uniform vec4 mirrors[4];     // planes: n, towards the eye, and d; n p + d = 0 in them, in E
uniform vec4 mirror_windows[4];  // px: left, high, right, low of what was drawn of each
uniform vec4 mirrors_shown;  // how many; texels for each pixel, across and down

/// The mirror whose plane p lies in, by its normal, and that was drawn at this pixel: a face beside one that
/// is shown is close to its plane, too. -1: none.
int mirror_at(vec3 p, vec3 n) {
  int at = -1;
  float least = 2e-3;  // m
  vec4 pixel = (gl_FragCoord.xy - viewport.xy).xyxy;
  for (int i = 0; i < int(mirrors_shown.x); ++i) {
    float off = abs(dot(mirrors[i].xyz, p) + mirrors[i].w);
    vec4 window = mirror_windows[i];
    bool drawn = all(greaterThan(pixel.xy, window.xy)) && all(lessThan(pixel.zw, window.zw));
    if (drawn && off < least && dot(mirrors[i].xyz, n) > 0.9999) {
      at = i;
      least = off;
    }
  }
  return at;
}

/// What mirror i shows at this pixel, as a surface of this colour returns it.
vec3 mirrored_by(int i, vec3 p, vec3 n, vec3 base, float metallic, float roughness) {
  vec3 seen = texelFetch(mirrored, ivec3((gl_FragCoord.xy - viewport.xy) * mirrors_shown.yz, i), 0).rgb;
  vec3 f0 = mix(vec3(0.04), base, metallic);
  float away = 1 - clamp(dot(n, -normalize(p)), 0, 1), away2 = away * away;
  vec3 fresnel = f0 + (max(vec3(1 - roughness), f0) - f0) * (away2 * away2 * away);
  // Fog before the mirror reaches the eye without it.
  return fresnel * (seen - through_fog(vec3(0), p)) + through_fog(vec3(0), p);
}
)";

constexpr const char* kPainted = R"(
void main() {
  vec4 own = material_base;
  if (material.z > 0) own *= texture(surface_texture, at);
  if (own.a < material.w) discard;
  if (material.w >= 0) own.a = 1;
  vec4 painted = base * own;
  vec3 n = normalize(n_E);
  if (!gl_FrontFacing) n = -n;
)";

constexpr const char* kShaded =
    R"(  vec3 light = shade(p_E, n, painted.rgb, material.x, material.y) + emission + glows * painted.rgb;
  color = vec4(through_fog(light, p_E), painted.a);
}
)";

constexpr const char* kMirroring = R"(  vec3 own_light = emission + glows * painted.rgb;
  int i = mirror_at(p_E, n);
  vec3 light = i < 0 ? through_fog(shade(p_E, n, painted.rgb, material.x, material.y) + own_light, p_E)
                     : mirrored_by(i, p_E, n, painted.rgb, material.x, material.y) +
                           through_fog(own_light, p_E) - through_fog(vec3(0), p_E);
  color = vec4(light, painted.a);
}
)";

constexpr const char* kFloorColor = R"(
layout(location = 0) out vec4 color;

float hash(vec2 p) {
  vec3 q = fract(p.xyx * 0.1031);
  q += dot(q, q.yzx + 33.33);
  return fract((q.x + q.y) * q.z);
}

/// Slabs of 1 m with joints, each a little lighter or darker, which far away are one colour.
vec3 floor_at(vec2 p, float wide) {
  vec2 within = abs(fract(p) - 0.5);
  float joint = 0.5 - max(within.x, within.y);
  float soft = max(wide, 0.004);
  float line = 1 - smoothstep(0.012 - soft, 0.012 + soft, joint);
  float fades = 1 / (1 + 25 * wide * wide);
  float slab = hash(mod(floor(p), 64)) - 0.5;
  return floor_color.rgb * (1 + fades * (0.05 * slab - 0.22 * line * min(1, 0.024 / (0.012 + soft))));
}

void main() {
  vec3 d = ray();
  float t = depth_of_floor(d);
  vec3 p = t * d;
  float wide = t * 2 * length(left.xyz) / viewport.z * max(1, min(8, length(d) / max(-d.z, 0.05)));
  vec3 up_there = vec3(0, 0, 1);
  vec3 light = light_from(up_there);
  if (to_sun.w > 0) light += to_sun.w * to_sun.z * sunlit(p, up_there);
  for (int i = 0; i < int(lamp_count.x); ++i) {
    vec3 to_lamp;
    light += lamp_light[i].rgb * max(lamplit(i, p, up_there, to_lamp), 0);
  }
  color = vec4(through_fog(floor_at(eye.xy + p.xy, wide) * light, p), 1);
  gl_FragDepth = depth_behind(t);
}
)";

constexpr const char* kSkyColor = R"(
layout(location = 0) out vec4 color;

void main() {
  vec3 d = normalize(ray());
  float high = max(d.z, 0);
  vec3 light = mix(sky.rgb, sky.rgb * vec3(0.55, 0.68, 0.86), smoothstep(0.0, 0.7, high));
  float beside = to_sun.w > 0 ? dot(d, to_sun.xyz) : 0;
  light += vec3(1, 0.95, 0.8) * smoothstep(0.99, 0.9995, beside);
  if (fog.w > 0) light = mix(light, fog.rgb, exp(-5 * high));
  color = vec4(light, 1);
}
)";

constexpr const char* kRay = R"(
vec3 ray() {
  vec2 at = (gl_FragCoord.xy - viewport.xy) / viewport.zw;  // from the corner that is left and high
  return ahead.xyz + left.xyz * (1 - 2 * at.x) + up.xyz * (1 - 2 * at.y);
}
)";

constexpr const char* kFloor = R"(
/// Along the way the camera looks.
float depth_of_floor(vec3 d) { return clamp(up.w / max(-d.z, 1e-9), ahead.w, left.w); }
float depth_value(float t) { return ahead.w * (left.w - t) / (t * (left.w - ahead.w)); }
/// A little farther, as if the floor were lower by 1/2000 of the height of the eye: what lies on it hides it.
float depth_behind(float t) { return depth_value(t * 1.0005); }
)";

// Where along a ray a view begins: at its near plane, or beyond the mirror that it is reflected in.
constexpr const char* kNearest = R"(
float nearest(vec3 d) { return ahead.w; }
)";
constexpr const char* kNearestBeyond = R"(
uniform vec4 cut;  // shown is where n p + d >= 0, in E
float nearest(vec3 d) { return max(ahead.w, -cut.w / max(dot(cut.xyz, d), 1e-6)); }
)";

constexpr const char* kSmoke = R"(
layout(binding = 1) uniform sampler2D scene_depth;
uniform vec4 middle;     // of its box, in E; w: seconds
uniform vec4 side[3];    // its axes; w: half its size along each
uniform vec4 smoke;      // its colour; a: how much one sees of it at most
layout(location = 0) out vec4 color;

float hash(vec3 p) {
  p = fract(p * vec3(0.1031, 0.1030, 0.0973));
  p += dot(p, p.yxz + 33.33);
  return fract((p.x + p.y) * p.z);
}
float noise(vec3 p) {
  vec3 i = floor(p), f = fract(p);
  f = f * f * (3 - 2 * f);
  float along[4];
  for (int k = 0; k < 4; ++k) {
    vec3 from = i + vec3(0, k % 2, k / 2);
    along[k] = mix(hash(from), hash(from + vec3(1, 0, 0)), f.x);
  }
  return mix(mix(along[0], along[1], f.y), mix(along[2], along[3], f.y), f.z);
}
/// From 0 to 1; p in the box, which is 1 from its middle to each side.
float density(vec3 p, vec3 half_size) {
  float inside = 1 - dot(p, p);
  if (inside <= 0) return 0;
  vec3 q = p * half_size * 2.2 - vec3(0, 0, 0.35 * middle.w);
  float grain = 0.55 * noise(q) + 0.3 * noise(2.3 * q) + 0.15 * noise(5.1 * q);
  return clamp(2.5 * (inside + 1.6 * grain - 1.1), 0, 1) * min(1, 3 * inside);
}

void main() {
  vec3 d = ray();
  float z = texelFetch(scene_depth, ivec2(gl_FragCoord.xy), 0).x;
  float last = z > 0 ? ahead.w * left.w / (z * (left.w - ahead.w) + ahead.w) : left.w;
  float first = nearest(d);
  vec3 half_size = vec3(side[0].w, side[1].w, side[2].w);
  vec3 from, along;
  for (int k = 0; k < 3; ++k) {
    from[k] = -dot(side[k].xyz, middle.xyz) / side[k].w;
    along[k] = dot(side[k].xyz, d) / side[k].w;
    float steep = abs(along[k]) < 1e-6 ? 1e-6 : along[k];
    float a = (-1 - from[k]) / steep, b = (1 - from[k]) / steep;
    first = max(first, min(a, b));
    last = min(last, max(a, b));
  }
  if (last <= first) discard;
  const int kSteps = 14;
  float step_size = (last - first) / kSteps, through = 1;
  float jitter = hash(vec3(gl_FragCoord.xy - viewport.xy, 7));
  vec3 light = vec3(0);
  float thickness = -log(max(1 - smoke.a, 0.002)) / max(min(half_size.x, half_size.y), 0.05);
  for (int i = 0; i < kSteps; ++i) {
    vec3 p = from + (first + (i + jitter) * step_size) * along;
    float here = density(p, half_size);
    float kept = exp(-here * thickness * step_size * length(d));
    float bright = 0.75 + 0.35 * p.z;
    light += through * (1 - kept) * smoke.rgb * bright * (sky.w + 0.5 * to_sun.w);
    through *= kept;
  }
  color = vec4(through_fog(light / max(1 - through, 1e-3), first * d), 1 - through);
}
)";

}  // namespace

std::string vertex_shader(Bends bends, Paints paints, Shown shown) {
  const bool is_cut = shown == Shown::kBeyondPlane;
  return std::string(kVersion) + kView + kPlace + (bends == Bends::kYes ? kBent : kRigid) +
         varying(paints, "out") +
         (is_cut ? "uniform vec4 cut;  // shown is where n p + d >= 0, in E\n" : "") +
         "void main() {\n  vec3 p = placed(body_position());\n  gl_Position = clip * vec4(p, 1);\n" +
         (is_cut ? "  gl_ClipDistance[0] = dot(cut, vec4(p, 1));\n" : "") + passed_on(bends, paints) + "}\n";
}

std::string fragment_shader(Paints paints) {
  const std::string begin = std::string(kVersion) + kView + varying(paints, "in");
  if (paints == Paints::kDepth) return begin + "void main() {}\n";
  if (paints == Paints::kSegments)
    return begin + "layout(location = 0) out uint color;\nvoid main() { color = segment; }\n";
  return begin + kLight + kSurface + kPainted + kShaded;
}

std::string mirror_fragment_shader() {
  return std::string(kVersion) + kView + varying(Paints::kColor, "in") + kLight + kSurface + kMirrors +
         kPainted + kMirroring;
}

std::string background_vertex_shader() {
  return std::string(kVersion) + kView + R"(
uniform vec4 lines;  // kept is where x * (the rise of a ray for each metre ahead) + y >= 0; z, w too
void main() {
  vec2 at = vec2(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1);
  gl_Position = vec4(at, 0, 1);
  vec2 rise = vec2(ahead.z - left.z * at.x + up.z * at.y, 1);
  gl_ClipDistance[0] = dot(lines.xy, rise);
  gl_ClipDistance[1] = dot(lines.zw, rise);
}
)";
}

std::string sky_fragment_shader() {
  return std::string(kVersion) + kView + kRay + kSkyColor;
}

std::string floor_fragment_shader(Paints paints) {
  const std::string begin = std::string(kVersion) + kView + kRay + kFloor;
  if (paints == Paints::kColor) return begin + kLight + kFloorColor;
  const bool is_depth = paints == Paints::kDepth;
  return begin + (is_depth ? "" : "layout(location = 0) out uint color;\n") +
         "void main() {\n  gl_FragDepth = " + (is_depth ? "depth_value" : "depth_behind") +
         "(depth_of_floor(ray()));\n" + (is_depth ? "" : "  color = 0u;\n") + "}\n";
}

std::string smoke_vertex_shader() {
  return std::string(kVersion) + kView + R"(
layout(location = 0) in vec3 position;
uniform vec4 middle;
uniform vec4 side[3];
void main() {
  vec3 p = middle.xyz;
  for (int k = 0; k < 3; ++k) p += position[k] * side[k].w * side[k].xyz;
  gl_Position = clip * vec4(p, 1);
}
)";
}

std::string smoke_fragment_shader(Shown shown) {
  return std::string(kVersion) + kView + kRay + kLight +
         (shown == Shown::kBeyondPlane ? kNearestBeyond : kNearest) + kSmoke;
}

}  // namespace playhouse::render
