// Tonal art maps: images of strokes by tone and size (Praun and others, Real-Time Hatching, 2001).
// Layer j of the image has its tones 3 j to 3 j + 3 in the channels, from white to black: two neighbours are one fetch.

#ifdef FRAGMENT_STAGE
uniform sampler2DArray strokes_sampler;

const float steps_in_layer = 3.0;

// How much strokes of a tone cover here. Between two tones they are blended, so that the mean cover is `ink`.
float tonal_ink(vec2 coordinate, float ink) {
    float layers = float(textureSize(strokes_sampler, 0).z);
    float step = ink * steps_in_layer * layers;
    float layer = min(floor(step / steps_in_layer), layers - 1.0);
    float within = step - layer * steps_in_layer;
    vec4 weights = max(1.0 - abs(within - vec4(0.0, 1.0, 2.0, 3.0)), 0.0);
    return 1.0 - dot(texture(strokes_sampler, vec3(coordinate, layer)), weights);
}
#endif
