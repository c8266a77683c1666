// Cel shading: exactly n tones by the light at the vertices, interpolated (seed B, Cell Shading, algorithm 4).
#include "comic.glsl"

#ifdef FRAGMENT_STAGE
uniform sampler2D light_map_sampler;
uniform int levels;
uniform float darkest;
uniform float texture_share;

vec4 cel_color(vec3 tone) {
    vec3 tint = texture(surface_sampler, surface_coordinate).rgb;
    return vec4(light_color * face_color * mix(vec3(1.0), tint, texture_share) * tone, 1.0);
}

// Even levels from the darkest to 1. Light from behind gives the first one.
vec4 cel() {
    float level = covered_level(seen_n_dot_l(), float(levels)) / float(levels - 1);
    return cel_color(vec3(mix(darkest, 1.0, level)));
}

// The tones of a map.
vec4 cel_mapped() { return cel_color(covered_tone(light_map_sampler, seen_n_dot_l())); }
#endif
