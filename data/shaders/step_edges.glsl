// Maps and levels with hard steps, looked up over the area of a pixel instead of at its centre, so that the step's edge
// is as smooth on the screen as an antialiased line and no wider. How far an index runs across a pixel comes from its
// derivatives on the screen.
#include "tone_map.glsl"

#ifdef FRAGMENT_STAGE
uniform float softness;   // width of a step's edge, pixels of the picture; 0: hard
uniform int pixel_scale;  // pixels of the frame along one of the picture

// At a silhouette an index may run through the whole map within a pixel; more than this would only grey it.
const float widest_range = 0.25;
// Above this range both of its ends may show one tone though another lies between them.
const float narrowest_band = 0.02;

// The range of an index across the edge's width.
float index_range(float index) {
    return min(softness * float(pixel_scale) * length(vec2(dFdx(index), dFdy(index))), widest_range);
}

// The mean of a 1-D map over the index's range: two taps, or eight where they differ. A number of rounds decides, not an
// `if`: software renderers follow both ways of an `if`, but leave a loop when no pixel goes on.
vec3 covered_tone(sampler2D map, float index) {
    float tap_width = index_range(index) / 8.0;
    vec3 low = map_tone(map, index - 3.5 * tap_width);
    vec3 high = map_tone(map, index + 3.5 * tap_width);
    int more = low != high || 8.0 * tap_width > narrowest_band ? 6 : 0;
    vec3 sum = low + high;
    for (int tap = 0; tap < more; ++tap) sum += map_tone(map, index + (float(tap) - 2.5) * tap_width);
    return sum / float(2 + more);
}

// The mean of a 2-D map over the pixel's image in it: four taps of a turned square, four more of another where they
// differ.
vec3 covered_tone(sampler2D map, vec2 index) {
    float width = softness * float(pixel_scale);
    mat2 from_pixel = mat2(clamp(width * dFdx(index), -widest_range, widest_range),
                           clamp(width * dFdy(index), -widest_range, widest_range));
    vec2 offset = vec2(-0.125, -0.375);
    vec3 first = map_tone(map, index + from_pixel * offset);
    vec3 sum = first;
    bool differ = false;
    for (int tap = 1; tap < 4; ++tap) {
        offset = vec2(-offset.y, offset.x);
        vec3 tone = map_tone(map, index + from_pixel * offset);
        differ = differ || tone != first;
        sum += tone;
    }
    int more = differ ? 4 : 0;
    offset = vec2(-0.3125, -0.0625);
    for (int tap = 0; tap < more; ++tap) {
        sum += map_tone(map, index + from_pixel * offset);
        offset = vec2(-offset.y, offset.x);
    }
    return sum / float(4 + more);
}

// The integral of floor from 0 to x.
float floor_integral(float x) {
    float whole = floor(x);
    return whole * (x - 0.5 * (whole + 1.0));
}

// Which of n even levels an index of 0 to 1 lies on, 0 to n - 1, as a mean over its range: exact, without taps.
float covered_level(float index, float levels) {
    float range = levels * index_range(index);
    float low = clamp(levels * index - 0.5 * range, 0.0, levels);
    float high = clamp(levels * index + 0.5 * range, 0.0, levels);
    float level = floor(low);
    if (level != floor(high)) level = (floor_integral(high) - floor_integral(low)) / (high - low);
    return min(level, levels - 1.0);
}

// How much of a pixel lies above a threshold.
float covered_above(float value, float threshold) {
    float range = index_range(value);
    return clamp((value - threshold) / max(range, 1e-6) + 0.5, 0.0, 1.0);
}
#endif
