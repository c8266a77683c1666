// Edges where the surface turns: seed C, 3.3.1.
#include "edges.glsl"

#ifdef FRAGMENT_STAGE
uniform sampler2D texture_sampler;  // world-space normals as colours

vec3 normal_at(ivec2 offset, ivec2 last) {
    return normalize(texelFetch(texture_sampler, tap(offset, last), 0).rgb * 2.0 - 1.0);
}

// Dot products with the neighbours' normals: left, right, below, above.
vec4 neighbour_dots() {
    ivec2 last = textureSize(texture_sampler, 0) - 1;
    vec3 centre = normal_at(here, last);
    return vec4(dot(centre, normal_at(left, last)), dot(centre, normal_at(right, last)),
                dot(centre, normal_at(below, last)), dot(centre, normal_at(above, last)));
}

vec4 detect() {
    vec4 dots = neighbour_dots();
    float sharpest = min(min(dots.x, dots.y), min(dots.z, dots.w));        // equation 3.7
    float intensity = threshold * (4.0 - (dots.x + dots.y + dots.z + dots.w));  // equation 3.8
    return edge_output(sharpest < threshold, intensity);
}
#endif
