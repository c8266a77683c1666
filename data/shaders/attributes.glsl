// Surface attributes as pictures: normals and region ids as colours, and all that the edge detectors need packed into
// two words a pixel (seed C, 3.3 and its future work, 3.4).
#include "scene.glsl"
#include "packing.glsl"

#ifdef FRAGMENT_STAGE
// World-space normals, their range of -1 to 1 brought to 0 to 1 (seed C, 3.3.1).
vec4 normals() { return vec4(facing_normal() * 0.5 + 0.5, 1.0); }

// A colour of its own for each region: an odd factor maps 24-bit numbers one to one. Black stays for the background.
vec4 ids() {
    uint mixed = (region * 0x9e3779u) & 0xffffffu;
    return vec4(vec3(uvec3(mixed >> 16, mixed >> 8, mixed) & 0xffu) / 255.0, 1.0);
}

uvec4 packed_attributes() {
    float eye_distance = -(eye_from_scene * vec4(position_scene, 1.0)).z;
    return uvec4(pack_attributes(facing_normal(), region, eye_distance), 0u, 0u);
}
#endif
