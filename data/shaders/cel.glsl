// Cel shading: exactly n tones by the light at the vertices, interpolated (seed B, Cell Shading, algorithm 4).
#include "comic.glsl"

#ifdef FRAGMENT_STAGE
uniform sampler2D light_map_sampler;
uniform int levels;
uniform float darkest;
uniform float texture_share;

// Even levels from the darkest to 1, or a map's. Light from behind gives the first one.
vec3 light_tone(float cosine) {
    if (textureSize(light_map_sampler, 0).x > 1) return covered_tone(light_map_sampler, cosine);
    float level = covered_level(cosine, float(levels)) / float(levels - 1);
    return vec3(mix(darkest, 1.0, level));
}

vec4 cel() {
    vec3 tint = texture(surface_sampler, surface_coordinate).rgb;
    vec3 color = face_color * mix(vec3(1.0), tint, texture_share);
    return vec4(light_color * color * light_tone(seen_n_dot_l()), 1.0);
}
#endif
