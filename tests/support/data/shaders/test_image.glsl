// Full-screen functions for tests.
#include "image.glsl"

#ifdef FRAGMENT_STAGE
uniform float amount;

// One grey.
vec4 grey() { return vec4(vec3(amount), 1.0); }

// One level of 255 more than the texture has.
vec4 one_more() {
    vec4 before = texelFetch(texture_sampler, ivec2(gl_FragCoord.xy), 0);
    return vec4(before.rgb + 1.0 / 255.0, before.a);
}

// Columns in red, rows from below in green.
vec4 place_as_color() { return vec4(floor(gl_FragCoord.xy) / 255.0, 0.0, 1.0); }

// A depth buffer's 24 bits as three bytes.
vec4 depth_bytes() {
    uint depth = uint(round(texelFetch(texture_sampler, ivec2(gl_FragCoord.xy), 0).r * 16777215.0));
    return vec4(vec3(uvec3(depth >> 16, depth >> 8, depth) & 255u) / 255.0, 1.0);
}
#endif
