// Comic shading with a highlight: a map of two dimensions, diffuse light across and specular light up (seed A, 3.6.1).
#include "comic.glsl"
#include "specular.glsl"

between float specular_light;

#ifdef VERTEX_STAGE
vec4 extended_transform() {
    vec4 clip_position = comic_transform();
    specular_light = specular_at((scene_from_model * vec4(vertex_position, 1.0)).xyz, vertex_normal, n_dot_l);
    return clip_position;
}
#endif

#ifdef FRAGMENT_STAGE
vec4 comic_extended() {
    float diffuse = seen_n_dot_l();
    return vec4(painted(covered_tone(shade_map_sampler, vec2(diffuse, shining(specular_light, diffuse)))), 1.0);
}
#endif
