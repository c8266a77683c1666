// Hatching by one image of strokes in the picture's plane, more or less transparent by the light: seed A, 4.6.2.
#include "hatching.glsl"
#include "tone_map.glsl"

uniform vec2 thresholds;

between vec2 vertex_ink;  // seen from the front and from the back

#ifdef VERTEX_STAGE
float ink_at_vertex(float cosine) {
    float ink = ink_share(tone(cosine, 0.0, material_diffuse * vertex_tint));
    return clamp((ink - thresholds.x) / max(thresholds.y - thresholds.x, 1e-4), 0.0, 1.0);
}

// Transparency at the vertices, with more contrast than the light has.
vec4 transform_inked() {
    vec4 position = transform_surface();
    float cosine = dot(vertex_normal, direction_to_light(position_scene));
    vertex_ink = vec2(ink_at_vertex(cosine), ink_at_vertex(-cosine));
    return position;
}
#endif

#ifdef FRAGMENT_STAGE
uniform sampler2D strokes_sampler;
uniform sampler2D transparency_sampler;

float stroke_ink() { return 1.0 - texture(strokes_sampler, projected_coordinate()).r; }

vec4 by_vertex() { return inked((gl_FrontFacing ? vertex_ink.x : vertex_ink.y) * stroke_ink(), surface_color()); }

// A one-dimensional map, found by the light and not repeated, says how transparent the strokes are (figure 51).
vec4 by_map() {
    vec3 color = surface_color();
    float opacity = 1.0 - map_tone(transparency_sampler, 1.0 - ink_of_light(color)).r;
    return inked(opacity * stroke_ink(), color);
}
#endif
