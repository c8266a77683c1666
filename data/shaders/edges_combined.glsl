// All three causes of an edge in one pass over packed attributes: seed C, 3.3.4. The component edge_detect chooses the
// function that does no more than its variables ask for: on a software renderer every colour and choice costs.
#include "packing.glsl"

#ifdef FRAGMENT_STAGE
uniform sampler2D texture_sampler;    // normals …
uniform sampler2D distances_sampler;  // … and distances, as packing.glsl has them

uniform int pixel_scale;  // how far the neighbours are, in texels: more than 1 when the picture is oversampled
uniform float near_plane;
uniform float far_plane;

uniform vec4 edge_color;
uniform vec4 non_edge_color;
uniform float normal_threshold;
uniform float depth_threshold;
uniform float grazing_tolerance;
uniform bool detect_ids;
uniform vec4 normal_edge_color;
uniform vec4 depth_edge_color;
uniform vec4 id_edge_color;

// A texel and its four neighbours.
struct Cross {
    vec4 centre;
    vec4 left;
    vec4 right;
    vec4 below;
    vec4 above;
};

// Held inside the image: the frame's border is no edge.
Cross fetch_cross(sampler2D image) {
    ivec2 here = ivec2(gl_FragCoord.xy);
    ivec2 low = max(here - pixel_scale, ivec2(0));
    ivec2 high = min(here + pixel_scale, textureSize(image, 0) - 1);
    return Cross(texelFetch(image, here, 0), texelFetch(image, ivec2(low.x, here.y), 0),
                 texelFetch(image, ivec2(high.x, here.y), 0), texelFetch(image, ivec2(here.x, low.y), 0),
                 texelFetch(image, ivec2(here.x, high.y), 0));
}

// One less the dot product of two unit normals a and b, as |a - b|² / 2: exactly 0 for equal ones, however they are
// rounded. The texture holds half of a normal plus a half.
float turn(vec4 a, vec4 b) {
    vec3 apart = a.xyz - b.xyz;
    return 2.0 * dot(apart, apart);
}

// Turns towards the left, right, below and above.
vec4 turns(Cross normals) {
    return vec4(turn(normals.centre, normals.left), turn(normals.centre, normals.right),
                turn(normals.centre, normals.below), turn(normals.centre, normals.above));
}

float largest(float a, float b, float c, float d) { return max(max(a, b), max(c, d)); }

// Equation 3.13, in scene units. Summed in steps, whole numbers that a float holds exactly.
float depth_laplacian(Cross distances) {
    vec2 bytes = distances.left.xy + distances.right.xy + distances.below.xy + distances.above.xy -
                 4.0 * distances.centre.xy;
    return abs(round(dot(bytes, depth_weights))) * ((far_plane - near_plane) / depth_steps);
}

// How much more the depth may bend before it is an edge. Where all of the cross lies on surfaces seen at a grazing
// angle, the Laplacian of the depth grows with the square of the slope, and would show the facets of smooth meshes;
// at a silhouette some of the cross lies on what is behind, or on the background.
float grazing_factor(Cross distances) {
    float facing = max(distances.centre.z,
                       largest(distances.left.z, distances.right.z, distances.below.z, distances.above.z));
    return mix(1.0, 1.0 / (facing * facing + 1e-4), grazing_tolerance);
}

struct Causes {
    bool normals;
    bool depth;
    bool ids;
};

bool regions_differ(Cross normals) {
    float id = normals.centre.w;
    return normals.left.w != id || normals.right.w != id || normals.below.w != id || normals.above.w != id;
}

Causes find_causes() {
    Cross normals = fetch_cross(texture_sampler);
    Cross distances = fetch_cross(distances_sampler);
    vec4 turned = turns(normals);
    // Equation 3.7: the least of the dot products is one less the largest turn.
    float sharpest = 1.0 - largest(turned.x, turned.y, turned.z, turned.w);
    return Causes(sharpest < normal_threshold, depth_laplacian(distances) > depth_threshold * grazing_factor(distances),
                  detect_ids && regions_differ(normals));
}

// Edges of one colour, whatever their cause.
vec4 one_color() {
    Causes causes = find_causes();
    return causes.normals || causes.depth || causes.ids ? edge_color : non_edge_color;
}

// Each cause's own colour where it is alone, the common one where there are more.
vec4 color_by_cause() {
    Causes causes = find_causes();
    bool by_surface = causes.normals || causes.depth;
    bool several = (causes.normals && causes.depth) || (causes.ids && by_surface);
    vec4 single = causes.normals ? normal_edge_color : (causes.depth ? depth_edge_color : id_edge_color);
    return by_surface || causes.ids ? (several ? edge_color : single) : non_edge_color;
}

// Gradual intensities in place of a yes or no: equation 3.8, and the Laplacian times its threshold.
vec4 intensity() {
    Cross normals = fetch_cross(texture_sampler);
    float by_normals = normal_threshold * dot(turns(normals), vec4(1.0));
    float by_depth = depth_threshold * depth_laplacian(fetch_cross(distances_sampler));
    vec4 color = mix(non_edge_color, normal_edge_color, clamp(by_normals, 0.0, 1.0));
    color = mix(color, depth_edge_color, clamp(by_depth, 0.0, 1.0));
    return detect_ids && regions_differ(normals) ? id_edge_color : color;
}
#endif
