// The extended comic with its light computed at each pixel, so that highlights are round on coarse meshes.
#include "comic.glsl"
#include "specular.glsl"

#ifdef FRAGMENT_STAGE
vec4 comic_extended_per_pixel() {
    vec3 normal = facing_normal();
    float diffuse = dot(normal, direction_to_light(position_scene));
    float specular = shining(specular_at(position_scene, normal, diffuse), diffuse);
    return vec4(painted(covered_tone(shade_map_sampler, vec2(diffuse, specular))), 1.0);
}
#endif
