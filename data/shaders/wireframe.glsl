// Edges as quads of any width, built in the vertex shader from one instance an edge.
#include "coverage.glsl"

uniform mat4 clip_from_scene;
uniform mat4 scene_from_model;
uniform vec2 frame_size;
uniform int pixel_scale;
uniform float width;   // pixels of the picture
uniform vec3 color;

between vec2 across;  // pixels from the line's middle, and the half width, both in pixels of the frame

#ifdef VERTEX_STAGE
layout(location = 0) in vec3 edge_start;
layout(location = 1) in vec3 edge_end;

const float smallest_w = 1e-5;

// The part of the edge before the eye: an end behind it is drawn back to where w is still positive.
void clip_behind_eye(inout vec4 start, inout vec4 end) {
    if (start.w < smallest_w && end.w > smallest_w) {
        start = mix(start, end, (smallest_w - start.w) / (end.w - start.w));
    } else if (end.w < smallest_w && start.w > smallest_w) {
        end = mix(end, start, (smallest_w - end.w) / (start.w - end.w));
    }
}

// Corners 0 and 1 lie at the start, 2 and 3 at the end; even ones to the left. Half a pixel more on all sides lets the
// border fade, and the quads of edges that meet at a vertex overlap.
vec4 edge_quad() {
    vec4 start = clip_from_scene * (scene_from_model * vec4(edge_start, 1.0));
    vec4 end = clip_from_scene * (scene_from_model * vec4(edge_end, 1.0));
    clip_behind_eye(start, end);
    vec2 half_frame = 0.5 * frame_size;
    vec2 along = (end.xy / end.w - start.xy / start.w) * half_frame;
    along = dot(along, along) > 1e-12 ? normalize(along) : vec2(1.0, 0.0);
    float half_width = 0.5 * width * float(pixel_scale);
    float reach = half_width + 0.5;
    float side = (gl_VertexID & 1) == 0 ? 1.0 : -1.0;
    bool at_end = gl_VertexID >= 2;
    vec2 offset = vec2(-along.y, along.x) * (side * reach) + along * ((at_end ? 1.0 : -1.0) * 0.5 * half_width);
    vec4 position = at_end ? end : start;
    across = vec2(side * reach, half_width);
    return vec4(position.xy + offset / half_frame * position.w, position.zw);
}
#endif

#ifdef FRAGMENT_STAGE
vec4 line() { return vec4(color, line_coverage(abs(across.x), across.y)); }
#endif
