// Strokes: triangles whose ink follows from a pixel's distance to the spine, or from an image along it.
// src/components/stroke_geometry.h says what their corners hold.
#include "coverage.glsl"

uniform vec2 frame_size;

between vec4 place;
between vec4 ink;  // not multiplied

#ifdef VERTEX_STAGE
layout(location = 0) in vec2 position;  // pixels of the frame, from the upper left
layout(location = 1) in vec4 stroke_place;
layout(location = 2) in vec4 stroke_color;

vec4 stroke_corner() {
    place = stroke_place;
    ink = stroke_color;
    return vec4(vec2(2.0, -2.0) * position / frame_size + vec2(-1.0, 1.0), 0.0, 1.0);
}
#endif

#ifdef FRAGMENT_STAGE
uniform sampler2D stroke_sampler;

// How much of the pixel an even stroke covers: all of it inside, none at its reach; ends and joints are round. In
// place: pixels past the segment's start and past its end, pixels beside the spine, reach.
float coverage() {
    float past_end = max(max(place.x, place.y), 0.0);
    float from_spine = sqrt(past_end * past_end + place.z * place.z);
    return line_coverage(from_spine, place.w - 0.5);
}

// The stroke's colour, multiplied by opacity and coverage.
vec4 even_ink() {
    float alpha = ink.a * coverage();
    return vec4(ink.rgb * alpha, alpha);
}

// Black in the image leaves all of the stroke's colour, white none.
vec4 textured_ink() {
    float alpha = ink.a * (1.0 - texture(stroke_sampler, place.xy).r);
    return vec4(ink.rgb * alpha, alpha);
}
#endif
