// Surface attributes in two textures of four bytes a pixel, which every renderer reads fast (the same rule in C++:
// framework/surface_attributes.h):
//   normals:   the world-space normal in red, green and blue, 0 to 1 for -1 to 1; the region id in alpha
//   distances: linear depth of 16 bits in red (high byte) and green; in blue how far the surface faces the eye:
//              1 straight, 0 edge on
// A region of 0 is background.

// Depth in steps of 1/65535 of the way from the near to the far plane, from the two bytes in 0 to 1.
const float depth_steps = 65535.0;
const vec2 depth_weights = vec2(256.0, 1.0) * 255.0;

// A linear depth of 0 to 1 as two bytes in 0 to 1, the high one first.
vec2 pack_depth(float depth) {
    float number = round(clamp(depth, 0.0, 1.0) * depth_steps);
    float high = floor(number / 256.0);
    return vec2(high, number - 256.0 * high) / 255.0;
}

// Region ids past 255 start again at 1: neighbours stay apart unless they lie a multiple of 255 apart.
float pack_region(uint region_id) { return region_id == 0u ? 0.0 : float((region_id - 1u) % 255u + 1u) / 255.0; }
