// Surfaces that only fill the depth: what is drawn after them at less or equal depth is what is seen.
#include "scene.glsl"

#ifdef VERTEX_STAGE
invariant gl_Position;  // surfaces may be drawn once more on their own depth

vec4 transform_occluder() { return transform_surface(); }
#endif

#ifdef FRAGMENT_STAGE
vec4 nothing() { return vec4(0.0); }
#endif
