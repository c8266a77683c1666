// All three causes of an edge in one pass over packed attributes: seed C, 3.3.4.
#include "edges.glsl"

#ifdef FRAGMENT_STAGE
uniform usampler2D texture_sampler;  // as packing.glsl packs them

uniform float normal_threshold;
uniform float depth_threshold;
uniform float grazing_tolerance;
uniform vec3 ray_centre;  // from the surface towards the eye, through the frame's middle …
uniform vec3 ray_right;   // … and how it changes to the frame's right border …
uniform vec3 ray_top;     // … and to its top
uniform vec2 frame_size;
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

// A cross of unit normals.
struct Normals {
    vec3 centre;
    vec3 left;
    vec3 right;
    vec3 below;
    vec3 above;
};

Normals unpack_normals(Cross words) {
    return Normals(unpack_normal(words.centre.x), unpack_normal(words.left.x), unpack_normal(words.right.x),
                   unpack_normal(words.below.x), unpack_normal(words.above.x));
}

// Dot products of the normals with the neighbours': left, right, below, above.
vec4 neighbour_dots(Normals normals) {
    return vec4(dot(normals.centre, normals.left), dot(normals.centre, normals.right),
                dot(normals.centre, normals.below), dot(normals.centre, normals.above));
}

// How much more the depth may bend before it is an edge. Where all of the cross lies on surfaces seen at a grazing
// angle, the Laplacian of the depth grows with the square of the slope, and would show the facets of smooth meshes;
// at a silhouette some of the cross lies on what is behind, or on the background.
float grazing_factor(Normals normals) {
    vec2 place = gl_FragCoord.xy / frame_size * 2.0 - 1.0;
    vec3 to_eye = normalize(ray_centre + place.x * ray_right + place.y * ray_top);
    vec4 around = abs(vec4(dot(normals.left, to_eye), dot(normals.right, to_eye), dot(normals.below, to_eye),
                           dot(normals.above, to_eye)));
    float facing = max(abs(dot(normals.centre, to_eye)), max(max(around.x, around.y), max(around.z, around.w)));
    return mix(1.0, 1.0 / (facing * facing + 1e-4), grazing_tolerance);
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
    Normals normals = unpack_normals(words);
    vec4 dots = neighbour_dots(normals);
    float laplacian = depth_laplacian(words) / grazing_factor(normals);
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
