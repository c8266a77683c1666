// Full-screen passes: the triangle that covers the target, and what is done to whole pictures.

between vec2 place;  // 0 to 1 over the target, from the lower left

uniform vec2 frame_size;  // pixels
uniform int pixel_scale;  // pixels of the frame along one of the picture

#ifdef VERTEX_STAGE
// One triangle, corners at -1, 3 in both directions, made from the vertex's number alone.
vec4 full_screen() {
    place = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
    return vec4(place * 2.0 - 1.0, 0.0, 1.0);
}
#endif

#ifdef FRAGMENT_STAGE
uniform sampler2D texture_sampler;

// The texture, pixel by pixel.
vec4 copy() { return texelFetch(texture_sampler, ivec2(gl_FragCoord.xy), 0); }

// The texture stretched over the target.
vec4 stretch() { return texture(texture_sampler, place); }

uniform vec2 tile_size;  // pixels of the picture

// The texture repeated from the upper left corner.
vec4 tiled() {
    vec2 from_top_left = vec2(gl_FragCoord.x, gl_FragCoord.y - frame_size.y);
    return vec4(texture(texture_sampler, from_top_left / (tile_size * float(pixel_scale))).rgb, 1.0);
}

// The mean of the pixels that make one of an oversampled picture. Colours are multiplied by their alpha already.
vec4 mean_of_samples() {
    ivec2 corner = ivec2(gl_FragCoord.xy) * pixel_scale;
    vec4 sum = vec4(0.0);
    for (int y = 0; y < pixel_scale; ++y) {
        for (int x = 0; x < pixel_scale; ++x) sum += texelFetch(texture_sampler, corner + ivec2(x, y), 0);
    }
    return sum / float(pixel_scale * pixel_scale);
}
#endif
