// What all hatching shares: how much ink a surface asks for, where strokes lie on the paper, and how ink lies on it.
#include "light.glsl"

uniform float ambient;
uniform vec2 tone_range;
uniform float material_share;
uniform float highlight;
uniform bool draw_light;

// How light a surface is to be, 0 to 1, from the cosine to the light, the specular factor, and the surface's own
// colour.
float tone(float cosine, float specular, vec3 surface_color) {
    float light = ambient + (1.0 - ambient) * max(cosine, 0.0) * color_intensity(light_color);
    float own = mix(1.0, color_intensity(surface_color), material_share);
    float tone = light * own + highlight * specular * color_intensity(material_specular);
    return clamp((tone - tone_range.x) / max(tone_range.y - tone_range.x, 1e-4), 0.0, 1.0);
}

// The share of the paper that strokes are to cover: pencil draws the shadow, chalk the light.
float ink_share(float tone) { return draw_light ? tone : 1.0 - tone; }

#ifdef VERTEX_STAGE
invariant gl_Position;  // strokes are drawn where occluder.glsl has filled the depth

vec4 transform_hatched() { return transform_surface(); }
#endif

#ifdef FRAGMENT_STAGE
uniform vec4 paper;               // what is known to lie under the strokes; alpha 0 where the frame alone knows
uniform vec3 ink_color;
uniform float material_ink;
uniform vec4 strokes_from_pixel;  // a rotation and a scale, column by column: seed A, listing 9

// Where a pixel lies in the repeated image of strokes: projected onto the picture's plane.
vec2 projected_coordinate() { return mat2(strokes_from_pixel.xy, strokes_from_pixel.zw) * gl_FragCoord.xy; }

// The surface's colour without light.
vec3 surface_color() { return material_diffuse * surface_tint(); }

// The ink that the light at this pixel asks for.
float ink_of_light(vec3 surface_color) {
    vec3 normal = facing_normal(), to_light = direction_to_light(position_scene);
    float specular = specular_factor(normal, to_light, direction_to_eye(position_scene));
    return ink_share(tone(dot(normal, to_light), specular, surface_color));
}

// A pencil of the surface's colour: with half of its white taken away, so that strokes of light colours are seen on
// paper and hues stay as they are. Chalk keeps it.
vec3 pencil_color(vec3 surface_color) {
    float white = min(min(surface_color.r, surface_color.g), surface_color.b);
    return draw_light ? surface_color : surface_color - 0.5 * white;
}

// Ink that covers a share of the paper, multiplied by alpha.
vec4 inked(float share, vec3 surface_color) {
    vec3 color = mix(ink_color, pencil_color(surface_color), material_ink);
    float under = (1.0 - share) * paper.a;
    return vec4(color * share + paper.rgb * under, share + under);
}
#endif
