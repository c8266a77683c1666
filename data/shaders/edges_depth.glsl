// Edges where the depth jumps, or its slope changes: seed C, 3.3.2.
#include "edges.glsl"

#ifdef FRAGMENT_STAGE
uniform sampler2D texture_sampler;  // a depth buffer
uniform float near_plane;
uniform float far_plane;
uniform bool is_parallel;

// Equation 3.11: the linear eye distance, in scene units, of a depth buffer's value.
float linear_depth(float window_depth) {
    if (is_parallel) return near_plane + window_depth * (far_plane - near_plane);
    return -2.0 * near_plane * far_plane /
           ((2.0 * window_depth - 1.0) * (far_plane - near_plane) - (far_plane + near_plane));
}

float depth_at(ivec2 offset, ivec2 last) {
    return linear_depth(texelFetch(texture_sampler, tap(offset, last), 0).r);
}

// The four neighbours' depths: left, right, below, above.
vec4 neighbour_depths(ivec2 last) {
    return vec4(depth_at(left, last), depth_at(right, last), depth_at(below, last), depth_at(above, last));
}

// Equation 3.12.
vec4 detect_deltas() {
    ivec2 last = textureSize(texture_sampler, 0) - 1;
    vec4 apart = abs(neighbour_depths(last) - depth_at(here, last));
    float largest = max(max(apart.x, apart.y), max(apart.z, apart.w));
    return edge_output(largest > threshold, largest * threshold);
}

// Equation 3.13.
vec4 detect_2nd_derivative() {
    ivec2 last = textureSize(texture_sampler, 0) - 1;
    float laplacian = abs(dot(neighbour_depths(last), vec4(1.0)) - 4.0 * depth_at(here, last));
    return edge_output(laplacian > threshold, laplacian * threshold);
}
#endif
