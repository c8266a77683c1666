// Hatching by tonal art maps, in the picture's plane or on the surface.
#include "anchored.glsl"
#include "hatching.glsl"
#include "tonal.glsl"

uniform float texcoord_scale;  // images a scene unit; 0 where texture coordinates cannot carry strokes
uniform float images_at_one;   // of strokes along a scene unit, at the eye distance 1; in a parallel projection, at any
uniform vec4 strokes_turn;     // a rotation, column by column

#ifdef VERTEX_STAGE
vec4 transform_anchored() {
    vec4 position = transform_surface();
    transform_rest();
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
    return shares / max(shares.x + shares.y + shares.z, 1e-6);
}

// Strokes on the planes that the model's axes stand on. Seen from outside they run in one direction all around the
// upright axis.
float ink_by_axes(float images, float ink) {
    mat2 turn = mat2(strokes_turn.xy, strokes_turn.zw);
    vec3 place = rest_position * images;
    vec3 side = sign(rest_normal);
    vec3 shares = axis_shares(rest_normal);
    return shares.x * tonal_ink(turn * vec2(-side.x * place.z, place.y), ink) +
           shares.y * tonal_ink(turn * vec2(place.x, -side.y * place.z), ink) +
           shares.z * tonal_ink(turn * vec2(side.z * place.x, place.y), ink);
}

// Strokes that follow the texture coordinates. These take whole images along both axes, so that strokes fit together
// where coordinates start again: the rotation and scale have whole numbers, the nearest to those asked for.
float ink_by_texture(float images, float ink) {
    vec2 whole = round(images * strokes_turn.xy);
    return tonal_ink(mat2(whole, -whole.y, whole.x) * surface_coordinate, ink);
}

// Strokes of which 2^octave images lie along a scene unit. Where a texture is repeated more often than that, strokes
// along its coordinates would be too small.
float ink_at(float octave, float ink) {
    float octave_of_texture = texcoord_scale > 0.0 ? round(log2(texcoord_scale)) : 1e3;
    if (octave >= octave_of_texture) return ink_by_texture(exp2(octave - octave_of_texture), ink);
    return ink_by_axes(exp2(octave), ink);
}

// Strokes that lie on the surface, about as large in the picture from near and far: those of the nearest octave, which
// goes over into the next in the middle third between them. Even and odd octaves are drawn apart, so that each of the
// two jumps to another size only where it does not count: hardware finds mip levels from neighbouring pixels.
vec4 on_surface() {
    vec3 color = surface_color();
    float ink = ink_of_light(color);
    float octave = log2(images_at_one * gl_FragCoord.w);
    float odd = 2.0 * floor(0.5 * octave) + 1.0;
    float even = 2.0 * floor(0.5 * (octave + 1.0));
    float odd_share = clamp(2.0 - 3.0 * abs(octave - odd), 0.0, 1.0);
    return inked(mix(ink_at(even, ink), ink_at(odd, ink), odd_share), color);
}
#endif
