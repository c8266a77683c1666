// Surface attributes as pictures: normals and region ids as colours, and all that the edge detectors need in two
// textures (seed C, 3.3 and its future work, 3.4).
#include "scene.glsl"
#include "packing.glsl"

#ifdef FRAGMENT_STAGE
uniform float near_plane;
uniform float far_plane;

// World-space normals, their range of -1 to 1 brought to 0 to 1 (seed C, 3.3.1).
vec4 normals() { return vec4(facing_normal() * 0.5 + 0.5, 1.0); }

// A colour of its own for each region: an odd factor maps 24-bit numbers one to one. Black stays for the background.
vec4 ids() {
    uint mixed = (region * 0x9e3779u) & 0xffffffu;
    return vec4(vec3(uvec3(mixed >> 16, mixed >> 8, mixed) & 0xffu) / 255.0, 1.0);
}

// All that edge_detect needs, in two outputs: normals and distances, as packing.glsl has them.
vec4 packed_attributes() {
    vec3 normal = facing_normal();
    float eye_distance = -(eye_from_scene * vec4(position_scene, 1.0)).z;
    float depth = (eye_distance - near_plane) / (far_plane - near_plane);
    second_output = vec4(pack_depth(depth), clamp(dot(normal, direction_to_eye(position_scene)), 0.0, 1.0), 1.0);
    return vec4(normal * 0.5 + 0.5, pack_region(region));
}
#endif
