// Comic shading with a highlight: a map of two dimensions, diffuse light across and specular light up (seed A, 3.6.1).
#include "comic.glsl"

uniform float shininess;  // the exponent; 0: the material's own
uniform int view_vector;  // 0: from each vertex, 1: one for all

between float specular_light;

// Equation 2 of seed A, for unit vectors that point away from the surface: there the light's vector points at it.
float r_dot_v(float l_dot_v, float n_dot_l, float n_dot_v) { return 2.0 * n_dot_l * n_dot_v - l_dot_v; }

#ifdef VERTEX_STAGE
vec4 extended_transform() {
    vec4 clip_position = comic_transform();
    vec3 position = (scene_from_model * vec4(vertex_position, 1.0)).xyz;
    // The approximation looks from the eye to the box's centre, the origin, and is the same everywhere.
    vec3 to_eye = direction_to_eye(view_vector == 1 ? vec3(0.0) : position);
    vec3 to_light = direction_to_light(view_vector == 1 ? vec3(0.0) : position);
    float reflected = r_dot_v(dot(to_light, to_eye), n_dot_l, dot(vertex_normal, to_eye));
    specular_light = pow(max(reflected, 0.0), shininess > 0.0 ? shininess : max(material_shininess, 1.0));
    return clip_position;
}
#endif

#ifdef FRAGMENT_STAGE
vec4 comic_extended() {
    return vec4(painted(covered_tone(shade_map_sampler, vec2(seen_n_dot_l(), specular_light))), 1.0);
}
#endif
