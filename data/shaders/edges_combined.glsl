// All three causes of an edge in one pass over packed attributes: seed C, 3.3.4.
#include "edges.glsl"

#ifdef FRAGMENT_STAGE
uniform usampler2D texture_sampler;  // as packing.glsl packs them

uniform float normal_threshold;
uniform float depth_threshold;
uniform bool detect_ids;
uniform vec4 normal_edge_color;
uniform vec4 depth_edge_color;
uniform vec4 id_edge_color;

// A texel and its neighbours, packed.
struct Cross {
    uvec2 centre;
    uvec2 left;
    uvec2 right;
    uvec2 below;
    uvec2 above;
};

Cross fetch_cross() {
    ivec2 last = textureSize(texture_sampler, 0) - 1;
    return Cross(texelFetch(texture_sampler, tap(here, last), 0).rg, texelFetch(texture_sampler, tap(left, last), 0).rg,
                 texelFetch(texture_sampler, tap(right, last), 0).rg,
                 texelFetch(texture_sampler, tap(below, last), 0).rg,
                 texelFetch(texture_sampler, tap(above, last), 0).rg);
}

// Dot products of the normals with the neighbours': left, right, below, above.
vec4 neighbour_dots(Cross words) {
    vec3 centre = unpack_normal(words.centre.x);
    return vec4(dot(centre, unpack_normal(words.left.x)), dot(centre, unpack_normal(words.right.x)),
                dot(centre, unpack_normal(words.below.x)), dot(centre, unpack_normal(words.above.x)));
}

// Equation 3.13.
float depth_laplacian(Cross words) {
    return abs(uintBitsToFloat(words.left.y) + uintBitsToFloat(words.right.y) + uintBitsToFloat(words.below.y) +
               uintBitsToFloat(words.above.y) - 4.0 * uintBitsToFloat(words.centre.y));
}

bool regions_differ(Cross words) {
    uint centre = unpack_region(words.centre.x);
    return unpack_region(words.left.x) != centre || unpack_region(words.right.x) != centre ||
           unpack_region(words.below.x) != centre || unpack_region(words.above.x) != centre;
}

// The colour of the causes found: each cause's own where it is alone, the common one where there are more.
vec4 cause_color(bool by_normals, bool by_depth, bool by_ids) {
    int causes = int(by_normals) + int(by_depth) + int(by_ids);
    if (causes == 0) return non_edge_color;
    if (causes > 1) return edge_color;
    return by_normals ? normal_edge_color : (by_depth ? depth_edge_color : id_edge_color);
}

vec4 detect() {
    Cross words = fetch_cross();
    vec4 dots = neighbour_dots(words);
    float laplacian = depth_laplacian(words);
    bool by_ids = detect_ids && regions_differ(words);
    if (apply_threshold) {
        float sharpest = min(min(dots.x, dots.y), min(dots.z, dots.w));  // equation 3.7
        return cause_color(sharpest < normal_threshold, laplacian > depth_threshold, by_ids);
    }
    float turn = 4.0 - (dots.x + dots.y + dots.z + dots.w);  // equation 3.8
    vec4 color = mix(non_edge_color, normal_edge_color, clamp(normal_threshold * turn, 0.0, 1.0));
    color = mix(color, depth_edge_color, clamp(depth_threshold * laplacian, 0.0, 1.0));
    return by_ids ? id_edge_color : color;
}
#endif
