// Comic shading with a highlight: a map of two dimensions, diffuse light across and specular light up (seed A, 3.6.1).
#include "comic.glsl"

uniform float shininess;  // the exponent; 0: the material's own
uniform int view_vector;  // 0: from each vertex, 1: one for all

between float specular_light;

// Equation 2 of seed A, for unit vectors that point away from the surface: there the light's vector points at it.
float r_dot_v(float l_dot_v, float n_dot_l, float n_dot_v) { return 2.0 * n_dot_l * n_dot_v - l_dot_v; }

// (R·V)^n for a unit normal. The approximation looks from the eye to the box's centre, the origin, wherever the point.
float specular_at(vec3 position, vec3 normal, float normal_dot_light) {
    vec3 seen_from = view_vector == 1 ? vec3(0.0) : position;
    vec3 to_eye = direction_to_eye(seen_from);
    float l_dot_v = dot(direction_to_light(seen_from), to_eye);
    float reflected = r_dot_v(l_dot_v, normal_dot_light, dot(normal, to_eye));
    return pow(max(reflected, 0.0), shininess > 0.0 ? shininess : max(material_shininess, 1.0));
}

#ifdef VERTEX_STAGE
vec4 extended_transform() {
    vec4 clip_position = comic_transform();
    specular_light = specular_at((scene_from_model * vec4(vertex_position, 1.0)).xyz, vertex_normal, n_dot_l);
    return clip_position;
}
#endif

#ifdef FRAGMENT_STAGE
vec4 extended_color(vec2 light) { return vec4(painted(covered_tone(shade_map_sampler, light)), 1.0); }

vec4 comic_extended() { return extended_color(vec2(seen_n_dot_l(), specular_light)); }

vec4 comic_extended_per_pixel() {
    vec3 normal = facing_normal();
    float normal_dot_light = dot(normal, direction_to_light(position_scene));
    return extended_color(vec2(normal_dot_light, specular_at(position_scene, normal, normal_dot_light)));
}
#endif
