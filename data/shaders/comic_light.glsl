// Light as it is drawn, not as it falls: comic shading with highlights that are moved, stretched, split and squared
// (Anjyo and Hiramitsu, Stylized highlights for cartoon rendering and animation, 2003), with rims of light, and with
// shadow sides that are hatched or ramped.
#include "comic.glsl"

#ifdef FRAGMENT_STAGE
uniform float highlight_size;   // degrees
uniform vec2 highlight_shift;
uniform float highlight_turn;   // degrees
uniform vec2 highlight_stretch;
uniform vec2 highlight_split;
uniform float highlight_squareness;
uniform int highlight_sharpness;
uniform float highlight_reach;   // pixels of the picture
uniform float highlight_detail;  // pixels of the picture
uniform vec3 highlight_color;

uniform float rim_strength;
uniform float rim_width;
uniform float rim_reach;  // pixels of the picture
uniform int rim_side;  // 0: lit, 1: all around, 2: in shadow
uniform vec3 rim_color;

uniform int shadow;  // 0: flat, 1: hatched, 2: ramped
uniform float shadow_edge;
uniform float shadow_depth;
uniform float hatching_distance;  // pixels of the picture
uniform float hatching_angle;     // degrees
uniform vec3 shadow_color;

// How far a value runs from one pixel of the picture to the next.
float run(float value) { return float(pixel_scale) * length(vec2(dFdx(value), dFdy(value))); }
float run(vec3 value) { return float(pixel_scale) * max(length(dFdx(value)), length(dFdy(value))); }

// The half vector after all that is done to it. `across` and `along` are the highlight's axes, tangent to the surface:
// the picture's right and up laid on it, where the paper takes the surface's own coordinates, which few models have.
// `detail` says how much of the splitting (x) and the squaring (y) is done.
vec3 styled_half_vector(vec3 half_vector, vec3 normal, vec2 detail) {
    vec3 right = vec3(eye_from_scene[0][0], eye_from_scene[1][0], eye_from_scene[2][0]);
    vec3 across = normalize(right - dot(right, normal) * normal + vec3(1e-5));
    vec3 along = cross(normal, across);
    // Translation.
    vec3 h = normalize(half_vector - highlight_shift.x * across - highlight_shift.y * along);
    // Rotation of the axes.
    float turn = radians(highlight_turn);
    vec3 turned = cos(turn) * across + sin(turn) * along;
    along = cos(turn) * along - sin(turn) * across;
    across = turned;
    // Directional scaling.
    h = normalize(h - highlight_stretch.x * dot(h, across) * across);
    h = normalize(h - highlight_stretch.y * dot(h, along) * along);
    // Split.
    h = normalize(h - detail.x * (highlight_split.x * sign(dot(h, across)) * across +
                                  highlight_split.y * sign(dot(h, along)) * along));
    // Squaring, most where the vector's part in the tangent plane lies between the axes: sin(2 theta) of its angle to
    // one of them. The paper writes the vector's own angle, which is near a right one all over a small highlight.
    vec2 on_axes = vec2(dot(h, across), dot(h, along));
    float sine = 2.0 * abs(on_axes.x * on_axes.y) / max(dot(on_axes, on_axes), 1e-8);
    float squared = pow(sine, float(highlight_sharpness));
    return normalize(h - detail.y * highlight_squareness * squared * (on_axes.x * across + on_axes.y * along));
}

// How much of the pixel the highlight covers. Where normal and half vector draw apart slowly, on flat faces, the angle
// within which the highlight lies is made smaller, so that it does not flood the face; where they draw apart quickly,
// the highlight is too small to be split and squared, and would fall to pieces.
float highlight(vec3 normal) {
    vec3 half_vector = normalize(direction_to_light(position_scene) + direction_to_eye(position_scene));
    float apart = run(half_vector - normal);
    float size = min(radians(highlight_size), highlight_reach * apart);
    float detail = smoothstep(0.75 * highlight_detail, 1.5 * highlight_detail, size / max(apart, 1e-6));
    float split = detail * size / radians(highlight_size);
    return covered_above(dot(normal, styled_half_vector(half_vector, normal, vec2(split, detail))), cos(size));
}

// Not farther from the contour than the rim's reach. On a round surface N·V grows there as the root of the distance,
// which therefore is half of N·V over its slope; on a flat face it comes out far.
float rim(vec3 normal) {
    float n_dot_v = dot(normal, direction_to_eye(position_scene));
    float distance = 0.5 * n_dot_v / max(run(n_dot_v), 1e-6);
    float covered = covered_above(rim_width - n_dot_v, 0.0) * (1.0 - smoothstep(rim_reach, 1.5 * rim_reach, distance));
    float lit = covered_above(seen_n_dot_l(), 0.0);
    return rim_strength * covered * (rim_side == 0 ? lit : rim_side == 1 ? 1.0 : 1.0 - lit);
}

// How dark a line of this half width is at a distance from its middle, pixels. One thinner than its soft edges grows
// paler instead, so that the mean over all distances is still its width.
float line_darkness(float from_middle, float half_width) {
    float edge = max(softness, 1e-3);
    float darkness = clamp((half_width - from_middle) / edge + 0.5, 0.0, 1.0);
    if (half_width >= 0.5 * edge) return darkness;
    float reach = half_width + 0.5 * edge;
    return darkness * 2.0 * edge * half_width / (reach * reach);
}

// Parallel lines fixed to the picture, which cover a share of it; above a half it is the gaps that grow thinner.
float hatching(float share) {
    float angle = radians(hatching_angle);
    vec2 across = vec2(-sin(angle), cos(angle)) / float(pixel_scale);
    float from_middle = abs(fract(dot(gl_FragCoord.xy, across) / hatching_distance) - 0.5) * hatching_distance;
    float half_distance = 0.5 * hatching_distance;
    if (share <= 0.5) return line_darkness(from_middle, share * half_distance);
    return 1.0 - line_darkness(half_distance - from_middle, (1.0 - share) * half_distance);
}

// How much of the shadow's colour is laid on.
float shadow_side() {
    float share = clamp((shadow_edge - seen_n_dot_l()) / shadow_depth, 0.0, 1.0);
    return shadow == 1 ? hatching(share) : share;
}

vec4 comic_light() {
    vec3 normal = facing_normal();
    vec3 color = painted(covered_tone(shade_map_sampler, seen_n_dot_l()));
    if (shadow != 0) color = mix(color, shadow_color, shadow_side());
    if (rim_strength > 0.0) color = mix(color, rim_color, rim(normal));
    if (highlight_size > 0.0) color = mix(color, highlight_color, highlight(normal));
    return vec4(color, 1.0);
}
#endif
