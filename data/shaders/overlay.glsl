// A picture laid over the target, hidden where the target is nearer.
#include "image.glsl"

#ifdef FRAGMENT_STAGE
uniform float opacity;
uniform sampler2D depth_sampler;
uniform bool has_depth;

// The nearest depth at and around the pixel: a line two pixels wide belongs to the surface in front.
float nearest_depth() {
    ivec2 centre = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(depth_sampler, 0) - 1;
    float nearest = 1.0;
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            ivec2 tap = clamp(centre + ivec2(x, y) * pixel_scale, ivec2(0), last);
            nearest = min(nearest, texelFetch(depth_sampler, tap, 0).r);
        }
    }
    return nearest;
}

// The texture over the target, where it is not hidden.
vec4 overlay() {
    vec4 color = texture(texture_sampler, place);
    gl_FragDepth = has_depth ? nearest_depth() : 0.0;
    return vec4(color.rgb, color.a * opacity);
}

// The same for the blends that want colours multiplied by alpha: transparent parts change nothing.
vec4 overlay_multiplied() {
    vec4 color = overlay();
    return vec4(color.rgb * color.a, color.a);
}
#endif
