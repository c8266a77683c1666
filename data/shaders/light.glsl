// The Phong model of seed C, section 4.2.
#include "scene.glsl"

// Equation 4.2, for unit vectors.
float diffuse_factor(vec3 normal, vec3 to_light) { return max(dot(normal, to_light), 0.0); }

// Equation 4.3, for unit vectors.
float specular_factor(vec3 normal, vec3 to_light, vec3 to_eye) {
    float n_dot_h = dot(normal, normalize(to_light + to_eye));
    if (dot(normal, to_light) < 0.0 || n_dot_h < 0.0) return 0.0;
    return pow(n_dot_h, material_shininess);
}

// Equation 4.5.
float color_intensity(vec3 color) { return dot(color, vec3(0.3, 0.6, 0.1)); }

// Both factors at a point of the surface: diffuse in x, specular in y.
vec2 lighting_factors(vec3 normal, vec3 position) {
    vec3 to_light = direction_to_light(position);
    return vec2(diffuse_factor(normal, to_light), specular_factor(normal, to_light, direction_to_eye(position)));
}

// Equation 4.1. The tint of texture and vertex colours goes with the ambient and diffuse colours.
vec3 phong_color(vec2 factors, vec3 tint) {
    return material_ambient * tint +
           light_color * (factors.x * material_diffuse * tint + factors.y * material_specular);
}
