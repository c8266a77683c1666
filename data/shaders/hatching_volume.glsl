// Hatching by a volume whose depth is the tone: seed A, 4.6.2, figure 52.
#include "hatching.glsl"

#ifdef FRAGMENT_STAGE
uniform sampler3D strokes_sampler;

vec4 by_volume() {
    vec3 color = surface_color();
    float slices = float(textureSize(strokes_sampler, 0).z);
    float depth = (ink_of_light(color) * (slices - 1.0) + 0.5) / slices;  // 0 and 1 are the middles of the end slices
    return inked(1.0 - texture(strokes_sampler, vec3(projected_coordinate(), depth)).r, color);
}
#endif
