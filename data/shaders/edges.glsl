// Edge detectors on images of surface attributes: seed C, section 3.3. Each looks at a texel and its four neighbours,
// and marks the texels on both sides of an edge, so that lines are two pixels wide.

#ifdef FRAGMENT_STAGE
uniform int pixel_scale;  // how far the neighbours are, in texels: more than 1 when the picture is oversampled

uniform float threshold;
uniform bool apply_threshold;
uniform vec4 edge_color;
uniform vec4 non_edge_color;

// The texel at an offset, held inside the image: the frame's border is no edge.
ivec2 tap(ivec2 offset, ivec2 last) { return clamp(ivec2(gl_FragCoord.xy) + offset * pixel_scale, ivec2(0), last); }

const ivec2 here = ivec2(0, 0);
const ivec2 left = ivec2(-1, 0);
const ivec2 right = ivec2(1, 0);
const ivec2 below = ivec2(0, -1);
const ivec2 above = ivec2(0, 1);

// A yes or no, or an intensity, as a colour.
vec4 edge_output(bool is_edge, float intensity) {
    float share = apply_threshold ? (is_edge ? 1.0 : 0.0) : clamp(intensity, 0.0, 1.0);
    return mix(non_edge_color, edge_color, share);
}
#endif
