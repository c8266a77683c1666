// Edges whose thresholds hold from near to far, and lines of any width along them. What is compared is not the depth
// but how far a neighbour lies from the tangent plane, and not how much the surface bends but how much more than beside
// the edge: neither changes with the distance of the eye.
#include "coverage.glsl"
#include "packing.glsl"

uniform int pixel_scale;

#ifdef FRAGMENT_STAGE
uniform sampler2D texture_sampler;
uniform sampler2D distances_sampler;
uniform mat4 eye_from_scene;
uniform vec2 frame_reach;  // of half the frame at eye distance 1; in a parallel projection at any
uniform vec2 frame_size;
uniform float near_plane;
uniform float far_plane;
uniform bool is_parallel;

uniform float bend_threshold;   // degrees
uniform float plane_threshold;  // scene units
uniform bool detect_ids;
uniform float width;
uniform vec4 color;

// What is seen at a pixel.
struct Sample {
    vec3 position_eye;
    vec3 normal_eye;
    float region;  // 0 behind everything
};

Sample sample_at(ivec2 pixel) {
    pixel = clamp(pixel, ivec2(0), textureSize(texture_sampler, 0) - 1);
    vec4 normal = texelFetch(texture_sampler, pixel, 0);
    float share = dot(texelFetch(distances_sampler, pixel, 0).xy, depth_weights) / depth_steps;
    float distance = mix(near_plane, far_plane, share);
    vec2 place = (2.0 * (vec2(pixel) + 0.5) / frame_size - 1.0) * frame_reach;
    return Sample(vec3(is_parallel ? place : place * distance, -distance),
                  mat3(eye_from_scene) * normalize(normal.xyz - 0.5), normal.w);
}

float degrees_between(vec3 a, vec3 b) { return degrees(2.0 * asin(min(0.5 * distance(a, b), 1.0))); }

// How far two samples lie from each other's tangent plane: the lesser of both, for at a crease each plane goes on
// through the other's face for a while, and at a steep place one normal is uncertain.
float off_plane(Sample a, Sample b) {
    vec3 apart = b.position_eye - a.position_eye;
    return min(abs(dot(a.normal_eye, apart)), abs(dot(b.normal_eye, apart)));
}

// True for an edge between two neighbours; `before` and `after` are the next ones on the same line of pixels.
bool is_edge(Sample before, Sample here, Sample next, Sample after) {
    if ((here.region == 0.0) != (next.region == 0.0)) return true;
    if (here.region == 0.0) return false;
    if (detect_ids && here.region != next.region) return true;
    if (off_plane(here, next) > plane_threshold) return true;
    float bend = degrees_between(here.normal_eye, next.normal_eye);
    float beside = max(before.region == 0.0 ? 0.0 : degrees_between(before.normal_eye, here.normal_eye),
                       after.region == 0.0 ? 0.0 : degrees_between(next.normal_eye, after.normal_eye));
    return bend > bend_threshold && bend > 2.0 * beside;
}

// Whether there is an edge between this pixel and the one to its right (red), and the one above it (green).
vec4 mark() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 right = ivec2(1, 0), above = ivec2(0, 1);
    Sample here = sample_at(pixel);
    bool to_right = is_edge(sample_at(pixel - right), here, sample_at(pixel + right), sample_at(pixel + 2 * right));
    bool to_above = is_edge(sample_at(pixel - above), here, sample_at(pixel + above), sample_at(pixel + 2 * above));
    return vec4(to_right, to_above, 0.0, 1.0);
}

// Half pixels that a byte of the row texture counts.
const float none_in_row = 255.0;

int reach() { return int(ceil(0.5 * width * float(pixel_scale))) + 1; }

// How far the nearest edge of this row lies, in half pixels: in red of those to a pixel's right, whose middles lie half
// a pixel to the right of its middle, in green of those above pixels.
vec4 nearest_in_row() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int last = textureSize(texture_sampler, 0).x - 1;
    vec2 nearest = vec2(none_in_row);
    for (int step = -reach(); step <= reach(); ++step) {
        vec2 marked = texelFetch(texture_sampler, ivec2(clamp(pixel.x + step, 0, last), pixel.y), 0).rg;
        vec2 half_pixels = abs(vec2(2 * step + 1, 2 * step));
        nearest = min(nearest, mix(vec2(none_in_row), half_pixels, marked));
    }
    return vec4(nearest / 255.0, 0.0, 1.0);
}

// The lines: the nearest middle of an edge between two pixels, in this row and those above and below, decides how much
// of the pixel is covered.
vec4 draw() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int last = textureSize(texture_sampler, 0).y - 1;
    float nearest = 1e6;  // squared, pixels
    for (int step = -reach(); step <= reach(); ++step) {
        vec2 beside = texelFetch(texture_sampler, ivec2(pixel.x, clamp(pixel.y + step, 0, last)), 0).rg * 127.5;
        vec2 along = vec2(float(step), float(step) + 0.5);
        vec2 squared = beside * beside + along * along;
        nearest = min(nearest, min(squared.x, squared.y));
    }
    float half_width = 0.5 * width * float(pixel_scale);
    return vec4(color.rgb, color.a * line_coverage(sqrt(nearest), half_width));
}
#endif
