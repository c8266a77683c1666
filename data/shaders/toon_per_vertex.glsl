// Cartoon shading whose intensity is computed at the vertices and interpolated: seed C, section 4.2.
#include "toon.glsl"

// For the side that the normal is on and for the other.
between float intensity_front;
between float intensity_back;

#ifdef VERTEX_STAGE
vec4 transform() {
    vec4 position = transform_surface();
    intensity_front = lighting_intensity(normal_scene, position_scene);
    intensity_back = lighting_intensity(-normal_scene, position_scene);
    return position;
}
#endif

#ifdef FRAGMENT_STAGE
vec4 toon_per_vertex() {
    return toon_color(map_tone(toon_map_sampler, gl_FrontFacing ? intensity_front : intensity_back));
}
#endif
