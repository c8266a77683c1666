// Surfaces that only fill the depth: what is drawn after them at less or equal depth is what is seen.
#include "scene.glsl"

#ifdef VERTEX_STAGE
invariant gl_Position;  // surfaces may be drawn once more on their own depth

uniform float occluder_inset;  // scene units by which the surface is drawn in, along its normals

vec4 transform_occluder() {
    vec4 position = transform_surface();
    if (occluder_inset == 0.0) return position;
    return clip_from_scene * vec4(position_scene - occluder_inset * normal_scene, 1.0);
}
#endif

#ifdef FRAGMENT_STAGE
vec4 nothing() { return vec4(0.0); }
#endif
