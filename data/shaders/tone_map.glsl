// Looking up a map of tones by an index of 0 to 1, or by two. A map is not repeated: its ends reach on.

#ifdef FRAGMENT_STAGE
vec3 map_tone(sampler2D map, vec2 index) {
    vec2 half_texel = 0.5 / vec2(textureSize(map, 0));
    return textureLod(map, clamp(index, half_texel, 1.0 - half_texel), 0.0).rgb;
}

vec3 map_tone(sampler2D map, float index) { return map_tone(map, vec2(index, 0.5)); }
#endif
