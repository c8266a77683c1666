// Crosshatching in levels: seed B, chapter 4.
//
// Simple: one level a triangle, of the light at its barycentre.
// Fine: triangles are split where shadow lines cross them, and their parts again, until each has one level. On the way
// from vertex to vertex the cosine is linear (equation 4.5), and so are the values that OpenGL interpolates; the level
// of a pixel by its own cosine is the level of the part that it would lie in. src/model/shade_split.h splits indeed.
#include "facets.glsl"
#include "hatching.glsl"
#include "tonal.glsl"

uniform int levels;
uniform float smallest_split;  // pixels of the picture
uniform vec2 frame_size;
uniform int pixel_scale;

between float cosine;                // to the light, on the normal's side
flat between float whole_cosine;     // the same at the barycentre
flat between vec3 whole_tint;
flat between vec2 whole_coordinate;
flat between float is_whole;         // 1: too small to be split

#ifdef VERTEX_STAGE
vec4 transform_whole() {
    vec4 position = transform_surface();
    // Equation 4.2 with a unit vector to the light: of three summed normals this is three times the cosine.
    whole_cosine = dot(facet_normal, direction_to_light(facet_barycentre())) / 3.0;
    whole_tint = facet_tint();
    whole_coordinate = facet_coordinate;
    return position;
}

vec4 transform_split() {
    vec4 position = transform_whole();
    cosine = dot(vertex_normal, direction_to_light(position_scene));
    is_whole = facet_pixels(frame_size) < smallest_split * float(pixel_scale) ? 1.0 : 0.0;
    return position;
}
#endif

#ifdef FRAGMENT_STAGE
// The strokes of a level, which are the same over a whole region: seen through a screen of them (figure 4.12).
vec4 crosshatched(float front_cosine, vec3 color) {
    float ink = ink_share(tone(gl_FrontFacing ? front_cosine : -front_cosine, 0.0, color));
    float last = float(levels - 1);
    float level = min(floor(ink * float(levels)), last);
    return inked(tonal_ink(projected_coordinate(), level / last), color);
}

vec3 whole_color() { return material_diffuse * texture(surface_sampler, whole_coordinate).rgb * whole_tint; }

vec4 simple() { return crosshatched(whole_cosine, whole_color()); }

vec4 fine() {
    bool whole = is_whole > 0.5;
    vec3 tint = whole ? whole_tint : vertex_tint;
    vec2 coordinate = whole ? whole_coordinate : surface_coordinate;
    vec3 color = material_diffuse * texture(surface_sampler, coordinate).rgb * tint;
    return crosshatched(whole ? whole_cosine : cosine, color);
}
#endif
