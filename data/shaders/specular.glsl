// Specular light (R·V)^n of the extended comic (seed A, 3.6.1).
#include "scene.glsl"
#include "step_edges.glsl"

uniform float shininess;  // the exponent; 0: the material's own
uniform int view_vector;  // 0: from each point, 1: one for all

// Equation 2 of seed A, for unit vectors that point away from the surface: there the light's vector points at it.
float r_dot_v(float l_dot_v, float n_dot_l, float n_dot_v) { return 2.0 * n_dot_l * n_dot_v - l_dot_v; }

// For a unit normal. The approximation looks from the eye to the box's centre, the origin, wherever the point.
float specular_at(vec3 position, vec3 normal, float n_dot_l) {
    vec3 seen_from = view_vector == 1 ? vec3(0.0) : position;
    vec3 to_eye = direction_to_eye(seen_from);
    float reflected = r_dot_v(dot(direction_to_light(seen_from), to_eye), n_dot_l, dot(normal, to_eye));
    return pow(max(reflected, 0.0), shininess > 0.0 ? shininess : max(material_shininess, 1.0));
}

#ifdef FRAGMENT_STAGE
// Equation 2 mirrors light from behind the surface too. It does not shine on the side that is seen.
float shining(float specular, float seen_n_dot_l) { return specular * covered_above(seen_n_dot_l, 0.0); }
#endif
