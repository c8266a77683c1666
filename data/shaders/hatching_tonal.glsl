// Hatching by tonal art maps, in the picture's plane or on the surface.
#include "anchored.glsl"
#include "hatching.glsl"
#include "tonal.glsl"

uniform float texcoord_scale;  // images a scene unit; 0 where texture coordinates cannot carry strokes
uniform vec2 tiles;            // a scene unit: a power of two; and the share of strokes half as large, 0 to 1
uniform vec4 strokes_turn;     // a rotation, column by column

between vec2 surface_strokes;  // by the texture coordinates

#ifdef VERTEX_STAGE
// Texture coordinates take whole images of strokes, so that they fit together where the coordinates start again.
vec4 transform_anchored() {
    vec4 position = transform_surface();
    transform_rest();
    float images = texcoord_scale > 0.0 ? max(exp2(round(log2(tiles.x / texcoord_scale))), 1.0) : 1.0;
    surface_strokes = images * surface_coordinate;
    return position;
}
#endif

#ifdef FRAGMENT_STAGE
vec4 on_screen() {
    vec3 color = surface_color();
    return inked(tonal_ink(projected_coordinate(), ink_of_light(color)), color);
}

// How much of the strokes comes from each axis: of most of the surface from the one it faces, in between from two.
vec3 axis_shares(vec3 normal) {
    vec3 facing = abs(normal);
    vec3 shares = max(facing - 0.8 * max(facing.x, max(facing.y, facing.z)), 0.0);
    return shares / (shares.x + shares.y + shares.z);
}

// Strokes that lie on the surface, `finer` times as many as at rest. Seen from outside they run in one direction all
// around the upright axis.
float surface_ink(mat2 turn, float finer, vec3 shares, float ink) {
    vec3 place = rest_position * tiles.x * finer;
    vec3 side = sign(rest_normal);
    vec2 by_x = turn * vec2(-side.x * place.z, place.y);
    vec2 by_y = turn * vec2(place.x, -side.y * place.z);
    vec2 by_z = turn * vec2(side.z * place.x, place.y);
    vec2 first = texcoord_scale > 0.0 ? surface_strokes * finer : by_x;
    return shares.x * tonal_ink(first, ink) + shares.y * tonal_ink(by_y, ink) + shares.z * tonal_ink(by_z, ink);
}

vec4 on_surface() {
    vec3 color = surface_color();
    float ink = ink_of_light(color);
    mat2 turn = mat2(strokes_turn.xy, strokes_turn.zw);
    vec3 shares = texcoord_scale > 0.0 ? vec3(1.0, 0.0, 0.0) : axis_shares(rest_normal);
    float share = mix(surface_ink(turn, 1.0, shares, ink), surface_ink(turn, 2.0, shares, ink), tiles.y);
    return inked(share, color);
}
#endif
