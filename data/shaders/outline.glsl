// Outlines: quads along edges of the surface, four vertices an edge that hold the same (src/components/outline_edges.h). Seed A, 3.4; seed B,
// chapter 4; seed E, 10.3.1.
#include "coverage.glsl"

uniform mat4 clip_from_scene;
uniform vec2 frame_size;
uniform int pixel_scale;
uniform bool is_parallel;
uniform float line_width;       // pixels of the picture, or scene units
uniform bool in_model_units;
uniform vec2 frame_reach;       // of half the frame at w = 1, scene units
uniform bool only_outside;      // on the side away from the surface; else half on either side
uniform float towards_eye;         // scene units by which the line is drawn nearer than it is
uniform float widths_towards_eye;  // the same in widths of the line
uniform vec2 depth_terms;       // of the projection: z = depth_terms.x * z_eye + depth_terms.y

between vec2 along;   // pixels of the frame past the edge's start, and past its end
between vec2 across;  // pixels beside the edge, away from the surface; and how wide the line is on that side
between vec3 ink;

#ifdef VERTEX_STAGE
layout(location = 0) in vec3 edge_start;
layout(location = 1) in vec3 edge_end;
layout(location = 2) in vec3 edge_inside;  // on the side of the edge where the surface lies
layout(location = 3) in vec4 start_color;
layout(location = 4) in vec4 end_color;

const float overlap = 1.0;  // pixels that a line on the outside reaches in, for the surface to cover

// Cuts the edge at the near plane. False when all of it lies before that.
bool clip_at_near_plane(inout vec4 start, inout vec4 end) {
    float start_behind = start.z + start.w, end_behind = end.z + end.w;
    if (start_behind <= 0.0 && end_behind <= 0.0) return false;
    if (start_behind < 0.0) start = mix(end, start, end_behind / (end_behind - start_behind));
    if (end_behind < 0.0) end = mix(start, end, start_behind / (start_behind - end_behind));
    return true;
}

// 1 where the surface lies to the left of the edge, -1 to the right. Holds for points behind the eye too.
float side_of_surface(vec4 start, vec4 end, vec4 inside) {
    return determinant(mat3(start.xyw, end.xyw, inside.xyw)) > 0.0 ? 1.0 : -1.0;
}

// Pixels of the frame along a scene unit at w = 1.
float pixels_per_unit() { return 0.5 * frame_size.y / frame_reach.y; }

float width_at(vec4 position) {
    float frame_pixels = in_model_units ? line_width * pixels_per_unit() / position.w : line_width * float(pixel_scale);
    return min(frame_pixels, frame_size.x + frame_size.y);
}

// The depth of a point that was moved along its ray towards the eye.
float moved_depth(vec4 position) {
    float moved = towards_eye + widths_towards_eye * width_at(position) * position.w / pixels_per_unit();
    if (is_parallel) return position.z + depth_terms.x * moved;
    float share = max(1.0 - moved / position.w, 1e-3);
    return (position.z - depth_terms.y + depth_terms.y / share) / position.w;
}

// Corners 0 and 1 lie at the start, 2 and 3 at the end; even ones on the outside. With w = 1 all that varies does so
// along the screen.
vec4 outline_corner() {
    vec4 start = clip_from_scene * vec4(edge_start, 1.0);
    vec4 end = clip_from_scene * vec4(edge_end, 1.0);
    float side = side_of_surface(start, end, clip_from_scene * vec4(edge_inside, 1.0));
    if (!clip_at_near_plane(start, end)) return vec4(0.0, 0.0, 2.0, 1.0);  // outside the frame
    vec2 half_frame = 0.5 * frame_size;
    vec2 from = start.xy / start.w * half_frame, to = end.xy / end.w * half_frame;
    float pixels = distance(from, to);
    vec2 direction = pixels > 1e-6 ? (to - from) / pixels : vec2(1.0, 0.0);
    vec2 outwards = side * vec2(direction.y, -direction.x);

    bool at_end = (gl_VertexID & 2) != 0, is_outer = (gl_VertexID & 1) == 0;
    vec4 position = at_end ? end : start;
    float width = only_outside ? width_at(position) : 0.5 * width_at(position);
    float reach = width + 0.5;
    float beside = is_outer ? reach : (only_outside ? -overlap : -reach);
    vec2 offset = outwards * beside + direction * (at_end ? reach : -reach);
    along = at_end ? vec2(-pixels - reach, reach) : vec2(reach, -pixels - reach);
    across = vec2(beside, width);
    ink = (at_end ? end_color : start_color).rgb;
    return vec4(((at_end ? to : from) + offset) / half_frame, clamp(moved_depth(position), -1.0, 1.0), 1.0);
}
#endif

#ifdef FRAGMENT_STAGE
// How much of the pixel the line covers. Ends are round, so that lines meet at corners without gaps.
float coverage() {
    float past_end = max(max(along.x, along.y), 0.0);
    float from_edge = length(vec2(past_end, across.x));
    // A line on the outside has its other half on the surface, where it does not show.
    return only_outside ? clamp(across.y + 0.5 - from_edge, 0.0, min(across.y, 1.0)) : line_coverage(from_edge, across.y);
}

vec4 outline() { return vec4(ink, coverage()); }

// For marks, which know no half-covered pixels: a pixel whose middle the line covers, or nothing.
vec4 whole_pixels() {
    if (coverage() < 0.5) discard;
    return vec4(ink, 1.0);
}
#endif
