// Maps and levels with hard steps, looked up over the area of a pixel instead of at its centre, so that the step's edge
// is as smooth on the screen as an antialiased line and no wider. How far an index runs across a pixel comes from its
// derivatives on the screen.

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

// A map is not repeated: its ends reach on.
vec3 map_tone(sampler2D map, vec2 index) {
    vec2 half_texel = 0.5 / vec2(textureSize(map, 0));
    return textureLod(map, clamp(index, half_texel, 1.0 - half_texel), 0.0).rgb;
}

vec3 map_tone(sampler2D map, float index) { return map_tone(map, vec2(index, 0.5)); }

// The mean of a 1-D map over the index's range: eight taps, but two where they agree.
vec3 covered_tone(sampler2D map, float index) {
    if (softness == 0.0) return map_tone(map, index);
    float step_width = index_range(index) / 8.0;
    vec3 low = map_tone(map, index - 3.5 * step_width);
    vec3 high = map_tone(map, index + 3.5 * step_width);
    if (low == high && 8.0 * step_width < narrowest_band) return low;
    vec3 sum = low + high;
    for (float tap = -2.5; tap < 3.0; ++tap) sum += map_tone(map, index + tap * step_width);
    return sum / 8.0;
}

// The mean of a 2-D map over the pixel's image in it: four taps of a turned grid, eight where they differ.
vec3 covered_tone(sampler2D map, vec2 index) {
    if (softness == 0.0) return map_tone(map, index);
    float width = softness * float(pixel_scale);
    vec2 along_x = clamp(width * dFdx(index), -widest_range, widest_range);
    vec2 along_y = clamp(width * dFdy(index), -widest_range, widest_range);
    vec3 first = map_tone(map, index - 0.125 * along_x - 0.375 * along_y);
    vec3 second = map_tone(map, index + 0.375 * along_x - 0.125 * along_y);
    vec3 third = map_tone(map, index + 0.125 * along_x + 0.375 * along_y);
    vec3 fourth = map_tone(map, index - 0.375 * along_x + 0.125 * along_y);
    vec3 sum = first + second + third + fourth;
    if (first == second && second == third && third == fourth) return first;
    sum += map_tone(map, index - 0.3125 * along_x - 0.0625 * along_y);
    sum += map_tone(map, index + 0.0625 * along_x - 0.3125 * along_y);
    sum += map_tone(map, index + 0.3125 * along_x + 0.0625 * along_y);
    sum += map_tone(map, index - 0.0625 * along_x + 0.3125 * along_y);
    return sum / 8.0;
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
