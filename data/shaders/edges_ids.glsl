// Edges where one region meets another: seed C, 3.3.3.
#include "edges.glsl"

#ifdef FRAGMENT_STAGE
uniform sampler2D texture_sampler;  // region ids as colours

vec4 detect() {
    ivec2 last = textureSize(texture_sampler, 0) - 1;
    vec3 centre = texelFetch(texture_sampler, tap(here, last), 0).rgb;
    bool differs = texelFetch(texture_sampler, tap(left, last), 0).rgb != centre ||
                   texelFetch(texture_sampler, tap(right, last), 0).rgb != centre ||
                   texelFetch(texture_sampler, tap(below, last), 0).rgb != centre ||
                   texelFetch(texture_sampler, tap(above, last), 0).rgb != centre;
    return edge_output(differs, differs ? threshold : 0.0);
}
#endif
