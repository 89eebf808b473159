// The programs that run per vertex and per pixel (GLSL 3.30). Lengths are in units of the scene's
// size, the ground is at y = 0. Colours are linear light until to_screen.
#pragma once

// Goes before every shader: definitions that all of them share.
inline constexpr const char* studio_source = R"(#version 330 core
uniform mat4 view_projection;
uniform vec3 eye;
uniform vec3 key;        // towards the main light
uniform vec2 viewport;   // pixels

// sRGB curve, IEC 61966-2-1.
vec3 to_screen(vec3 light) {
  light = clamp(light, 0.0, 1.0);
  vec3 steep = 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055;
  return mix(steep, 12.92 * light, lessThanEqual(light, vec3(0.0031308)));
}
vec3 to_light(vec3 value) {
  vec3 steep = pow((value + 0.055) / 1.055, vec3(2.4));
  return mix(steep, value / 12.92, lessThanEqual(value, vec3(0.04045)));
}

// The wall behind everything: a soft spot of light. It depends on the pixel alone, so floor and
// wall meet without a horizon.
vec3 backdrop(vec2 at) {
  vec2 from_centre = (at / viewport - vec2(0.47, 0.68)) * vec2(1.75, 1.55);
  float r = smoothstep(0.05, 1.25, length(from_centre));
  return mix(vec3(0.875, 0.900, 0.935), vec3(0.430, 0.480, 0.555), r);
}

// Light from everywhere: cool from above, warm and weaker from the floor.
vec3 ambient(vec3 normal) {
  return mix(vec3(0.175, 0.165, 0.160), vec3(0.270, 0.285, 0.315), 0.5 + 0.5 * normal.y);
}
)";

inline constexpr const char* backdrop_vertex_source = R"(
void main() {  // one triangle that covers the picture
  gl_Position = vec4(vec2(gl_VertexID % 2, gl_VertexID / 2) * 4.0 - 1.0, 0.0, 1.0);
}
)";

inline constexpr const char* backdrop_fragment_source = R"(
out vec4 pixel;
void main() { pixel = vec4(to_screen(backdrop(gl_FragCoord.xy)), 1.0); }
)";

// Both shadow passes: the cloth as a light sees it, without colour.
inline constexpr const char* shadow_vertex_source = R"(
layout(location = 0) in vec3 position;
uniform mat4 light_matrix;
void main() { gl_Position = light_matrix * vec4(position, 1.0); }
)";

inline constexpr const char* shadow_fragment_source = R"(
out vec4 pixel;
void main() { pixel = vec4(1.0); }
)";

inline constexpr const char* floor_vertex_source = R"(
uniform float half_side;
out vec2 place;
void main() {
  place = (vec2(gl_VertexID % 2, gl_VertexID / 2) * 2.0 - 1.0) * half_side;
  gl_Position = view_projection * vec4(place.x, 0.0, -place.y, 1.0);
}
)";

inline constexpr const char* floor_fragment_source = R"(
in vec2 place;
uniform sampler2D shadow_mask;
uniform vec2 mask_centre;
uniform float mask_reach;
out vec4 pixel;

// The part of a pixel of width w that a line of width 0.004 covers; one line per 0.5.
float grid(float t, float w) {
  float distance_to_line = abs(fract(t * 2.0 + 0.5) - 0.5) * 0.5;
  return clamp((0.002 + 0.5 * w - distance_to_line) / w, 0.0, min(1.0, 0.004 / w));
}

void main() {
  vec2 w = max(fwidth(place), vec2(1e-6));
  float line = max(grid(place.x, w.x), grid(place.y, w.y));
  vec2 at = (vec2(place.x, -place.y) - mask_centre) / mask_reach;
  float shadow = texture(shadow_mask, 0.5 + 0.5 * at).r;

  vec3 light = vec3(0.640, 0.655, 0.685) * (1.0 - 0.10 * line);
  light *= mix(vec3(1.0), vec3(0.385, 0.415, 0.485), shadow);
  float fade = smoothstep(1.6, 5.5, length(place));
  pixel = vec4(to_screen(mix(light, backdrop(gl_FragCoord.xy), fade)), 1.0);
}
)";

inline constexpr const char* cloth_vertex_source = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 texture_place;  // squares of the checker
layout(location = 3) in float strain;        // 1 at the end of the colour scale
out vec3 place, smooth_normal, corner;
out vec2 squares;
out float scaled_strain;
void main() {
  place = position;
  smooth_normal = normal;
  squares = texture_place;
  scaled_strain = strain;
  corner = vec3(equal(ivec3(gl_VertexID % 3), ivec3(0, 1, 2)));
  gl_Position = view_projection * vec4(position, 1.0);
}
)";

inline constexpr const char* cloth_fragment_source = R"(
in vec3 place, smooth_normal, corner;
in vec2 squares;
in float scaled_strain;
uniform sampler2DShadow shadow_map;
uniform mat4 shadow_matrix;
uniform float shadow_texel;
uniform int show_strain, show_wires;
uniform float pixel_side;        // drawn pixels per final pixel
uniform vec3 scale_colours[18];  // the strain colours, sRGB
out vec4 pixel;

// The mean over a width w of a wave that is +1 and -1 on alternate unit intervals.
vec2 square_wave(vec2 t, vec2 w) {
  vec2 end = abs(fract(0.5 * (t + 0.5 * w)) - 0.5), begin = abs(fract(0.5 * (t - 0.5 * w)) - 0.5);
  return 2.0 * (begin - end) / w;
}

// 0 on one colour of the checker, 1 on the other; in between where a pixel sees both.
float checker(vec2 t, vec2 w) {
  vec2 wave = square_wave(t, w);
  return 0.5 - 0.5 * wave.x * wave.y;
}

// The part of a pixel that the thin seams between the squares cover.
float seam(vec2 t, vec2 w) {
  const float width = 0.022;
  vec2 away = abs(fract(t + 0.5) - 0.5);
  vec2 covered = clamp((0.5 * (width + w) - away) / w, vec2(0.0), min(vec2(1.0), width / w));
  return max(covered.x, covered.y);
}

// The part of the key light that reaches a point: 5 × 5 looks at the shadow map around it, so that
// shadows have soft edges. The point moves off the surface towards the light, or the cloth would
// shadow itself.
float key_visibility(vec3 normal, float toward_key) {
  vec3 off = place + 0.018 * (toward_key < 0.0 ? -normal : normal);
  vec3 at = 0.5 + 0.5 * (shadow_matrix * vec4(off, 1.0)).xyz;
  float sum = 0.0;
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      sum += texture(shadow_map, at + vec3(vec2(i, j) * 2.0 * shadow_texel, 0.0));
  return sum / 25.0;
}

// The part of a pixel that the edges of its triangle cover; nothing where triangles are so small
// that the edges would be all there is to see.
float wires() {
  vec3 w = max(vec3(length(vec2(dFdx(corner.x), dFdy(corner.x))),
                    length(vec2(dFdx(corner.y), dFdy(corner.y))),
                    length(vec2(dFdx(corner.z), dFdy(corner.z)))), vec3(1e-6));
  vec3 away = corner / (w * pixel_side);  // final pixels from each edge
  float line = 1.0 - smoothstep(0.35, 1.05, min(away.x, min(away.y, away.z)));
  float height = 1.0 / (max(w.x, max(w.y, w.z)) * pixel_side);
  return line * smoothstep(3.0, 7.0, height);
}

vec3 strain_colour() {
  float at = clamp(scaled_strain, 0.0, 1.0) * 17.0;
  int i = min(int(at), 16);
  return to_light(mix(scale_colours[i], scale_colours[i + 1], at - float(i)));
}

void main() {
  vec3 view = normalize(eye - place);
  vec3 normal = normalize(gl_FrontFacing ? smooth_normal : -smooth_normal);
  // At silhouettes the smooth normal can turn away from the viewer: it may not.
  normal = normalize(normal - min(dot(normal, view), 0.0) * view);

  vec2 w = max(fwidth(squares), vec2(1e-6));
  float odd = checker(squares, w), line = seam(squares, w);
  vec3 front = mix(vec3(0.830, 0.650, 0.480), vec3(0.610, 0.062, 0.046), odd);
  vec3 back = mix(vec3(0.400, 0.520, 0.660), vec3(0.040, 0.175, 0.370), odd);
  vec3 albedo = (gl_FrontFacing ? front : back) * (1.0 - 0.30 * line);

  float toward_key = dot(normal, key);
  float lit = key_visibility(normal, toward_key);
  float wrapped = max((toward_key + 0.12) / 1.12, 0.0);
  vec3 key_light = vec3(1.0, 0.955, 0.890);
  vec3 light = 1.16 * key_light * wrapped * lit + ambient(normal);
  light += 0.10 * vec3(0.85, 0.92, 1.0) * (0.5 + 0.5 * dot(normal, normalize(vec3(0.8, 0.1, 0.5))));
  light += 0.22 * key_light * max(-toward_key, 0.0) * lit;  // light that shines through
  vec3 lamp = normalize(view + 0.8 * cross(vec3(0.0, 1.0, 0.0), view) + vec3(0.0, 0.3, 0.0));
  float lamp_light = gl_FrontFacing ? 0.0 : max(dot(normal, lamp), 0.0);  // beside the camera
  light += 0.78 * lamp_light * lamp_light;

  float gloss = pow(max(dot(normal, normalize(key + view)), 0.0), 28.0) * lit;
  float rim = pow(1.0 - max(dot(normal, view), 0.0), 4.0);
  float lamp_gloss = pow(max(dot(normal, normalize(lamp + view)), 0.0), 40.0) * lamp_light;
  vec3 shine = vec3(0.055 * gloss + 0.060 * lamp_gloss + 0.050 * rim);

  vec3 colour = albedo * light + shine;
  if (show_strain != 0) {
    float brightness = dot(light, vec3(0.2126, 0.7152, 0.0722)) * (1.0 - 0.08 * odd);
    colour = strain_colour() * mix(1.0, brightness, 0.45);
  }
  if (show_wires != 0) colour = mix(colour, vec3(0.020, 0.016, 0.026), 0.72 * wires());
  pixel = vec4(to_screen(colour), 1.0);
}
)";

// A pin is a square that faces the viewer; each of its pixels is traced to the sphere within.
inline constexpr const char* pin_vertex_source = R"(
layout(location = 0) in vec3 centre;
uniform float radius;
out vec3 place;
flat out vec3 sphere;
void main() {
  vec3 back = normalize(eye - centre);
  vec3 right = normalize(cross(abs(back.y) < 0.99 ? vec3(0, 1, 0) : vec3(1, 0, 0), back));
  vec3 up = cross(back, right);
  vec2 side = (vec2(gl_VertexID % 2, gl_VertexID / 2) * 2.0 - 1.0) * radius;
  sphere = centre;
  place = centre + back * radius + right * side.x + up * side.y;  // the square touches the sphere
  gl_Position = view_projection * vec4(place, 1.0);
}
)";

inline constexpr const char* pin_fragment_source = R"(
in vec3 place;
flat in vec3 sphere;
uniform float radius;
out vec4 pixel;
void main() {
  // |eye + t ray - sphere| = radius, the nearer solution.
  vec3 ray = normalize(place - eye), away = eye - sphere;
  float middle = -dot(away, ray);
  vec3 nearest = away + middle * ray;
  float inside = radius * radius - dot(nearest, nearest);
  if (inside < 0.0) discard;
  vec3 point = eye + (middle - sqrt(inside)) * ray;
  vec4 clip = view_projection * vec4(point, 1.0);
  gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;

  vec3 normal = (point - sphere) / radius;
  vec3 light = 1.05 * max(dot(normal, key), 0.0) + ambient(normal);
  float gloss = pow(max(dot(normal, normalize(key - ray)), 0.0), 42.0);
  float rim = pow(1.0 - max(dot(normal, -ray), 0.0), 3.0);
  vec3 colour = vec3(0.165, 0.175, 0.190) * light + 0.50 * gloss + 0.06 * rim;
  pixel = vec4(to_screen(colour), 1.0);
}
)";
