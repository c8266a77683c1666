// Cartoon shading through a toon map: seed C, section 4.2, equations 4.4-4.6.
#include "light.glsl"
#include "step_edges.glsl"

// Equation 4.4.
float lighting_intensity(vec3 normal, vec3 position) {
    vec2 factors = lighting_factors(normal, position);
    return factors.x + factors.y * color_intensity(material_specular);
}

#ifdef FRAGMENT_STAGE
uniform sampler2D toon_map_sampler;

// Equation 4.6, with the intensity brought to a tone.
vec4 toon_color(vec3 tone) {
    vec3 tint = surface_tint();
    return vec4(material_ambient * tint + light_color * tone * material_diffuse * tint, 1.0);
}

float seen_intensity() { return lighting_intensity(facing_normal(), position_scene); }

vec4 toon() { return toon_color(map_tone(toon_map_sampler, seen_intensity())); }

vec4 toon_soft() { return toon_color(covered_tone(toon_map_sampler, seen_intensity())); }
#endif
