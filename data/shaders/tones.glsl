// From a tone, a share of light of 0 to 1, to the colour that is painted.
#include "scene.glsl"

uniform int tones;               // 0: hsb, 1: multiply
uniform float darkening;         // of the darkest tone: brightness taken away
uniform float saturation_gain;   // and saturation added
uniform float full_light;        // the tone at which a surface shows its own colour; above it turns white

// How comics shade (seed A, table 5): less brightness and more saturation in the hue-saturation-brightness space, the
// hue kept. With B the largest channel, S = (B - smallest) / B and k = (B - channel) / (B - smallest) a channel is
// B (1 - S k), and k depends on the hue alone. So no hue need be found. Two limits are not the table's, which has no
// such colours: the gain does not exceed the saturation itself, so that a grey stays grey; and below a brightness of a
// half less is taken away, in proportion, so that dark colours do not all become black.
vec3 darkened(vec3 color, float shade) {
    float brightness = max(max(color.r, color.g), color.b);
    float spread = brightness - min(min(color.r, color.g), color.b);
    float saturation = spread / max(brightness, 1e-5);
    vec3 hue = (brightness - color) / max(spread, 1e-5);
    saturation = clamp(saturation + shade * min(saturation_gain, saturation), 0.0, 1.0);
    brightness -= shade * darkening * min(2.0 * brightness, 1.0);
    return max(brightness, 0.0) * (1.0 - saturation * hue);
}

// A surface's colour under a tone.
vec3 toned(vec3 color, vec3 tone) {
    vec3 light = min(tone / full_light, 1.0);
    vec3 shaded = color * light;
    if (tones == 0) shaded = darkened(color, 1.0 - max(max(light.r, light.g), light.b));
    if (full_light < 1.0) shaded = mix(shaded, vec3(1.0), clamp((tone - full_light) / (1.0 - full_light), 0.0, 1.0));
    return light_color * shaded;
}
