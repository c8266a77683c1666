// What is the same all over a triangle, for shading that has one value a triangle. A component draws with it by asking
// for facets: then the last vertex of each triangle is its own, and `flat` takes what that one holds.
#include "scene.glsl"

#ifdef VERTEX_STAGE
layout(location = 4) in vec3 facet_normal;      // the sum of the vertices' normals
layout(location = 5) in vec4 facet_place;       // the barycentre, and the longest side
layout(location = 6) in vec2 facet_coordinate;  // of the texture, at the barycentre
layout(location = 7) in vec4 facet_color;       // of two of the vertices, else the mean

uniform vec2 frame_reach;  // of half the frame at w = 1, scene units

vec3 facet_barycentre() { return (scene_from_model * vec4(facet_place.xyz, 1.0)).xyz; }

vec3 facet_tint() { return facet_color.rgb; }

// The longest side in pixels of the frame, as long as it were if it did not run towards the eye.
float facet_pixels(vec2 frame_size) {
    float pixels_at_one = 0.5 * frame_size.y / frame_reach.y;
    float distance = (clip_from_scene * vec4(facet_barycentre(), 1.0)).w;
    return facet_place.w * scene_from_model[0][0] * pixels_at_one / max(distance, 1e-6);
}
#endif
