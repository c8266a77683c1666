// Normal, region id and linear eye distance in two words: the first holds the normal as two numbers of 10 bits (an
// octahedron unfolded) above 12 bits of region id; the second is the distance as a float. A region of 0 is background.

const uint region_bits = 12u;
const float octahedron_steps = 1023.0;

vec2 sign_not_zero(vec2 v) { return vec2(v.x < 0.0 ? -1.0 : 1.0, v.y < 0.0 ? -1.0 : 1.0); }

uint pack_normal(vec3 normal) {
    vec2 flat_part = normal.xy / (abs(normal.x) + abs(normal.y) + abs(normal.z));
    if (normal.z < 0.0) flat_part = (1.0 - abs(flat_part.yx)) * sign_not_zero(flat_part);
    uvec2 steps = uvec2(round((flat_part * 0.5 + 0.5) * octahedron_steps));
    return (steps.x << 10) | steps.y;
}

vec3 unpack_normal(uint word) {
    vec2 flat_part = vec2(float(word >> 22), float((word >> 12) & 1023u)) * (2.0 / octahedron_steps) - 1.0;
    vec3 normal = vec3(flat_part, 1.0 - abs(flat_part.x) - abs(flat_part.y));
    float below = max(-normal.z, 0.0);
    normal.xy -= sign_not_zero(normal.xy) * below;
    return normalize(normal);
}

// Region ids past what 12 bits hold start again at 1: neighbours stay apart unless they lie 4,095 regions apart.
uint pack_region(uint region_id) {
    uint most = (1u << region_bits) - 1u;
    return region_id == 0u ? 0u : (region_id - 1u) % most + 1u;
}

uint unpack_region(uint word) { return word & ((1u << region_bits) - 1u); }

uvec2 pack_attributes(vec3 normal, uint region_id, float eye_distance) {
    return uvec2((pack_normal(normal) << region_bits) | pack_region(region_id), floatBitsToUint(eye_distance));
}
