// Comic shading: seed A, 3.3. Light is computed at the vertices; what is interpolated is the index into a map of tones,
// not a colour, so that the border of two tones runs smoothly through a triangle.
#include "scene.glsl"
#include "step_edges.glsl"
#include "tones.glsl"

between float n_dot_l;         // negative where the other side is lit
flat between vec3 face_color;  // one a triangle (seed A, 3.6.2), which its last vertex holds

#ifdef VERTEX_STAGE
vec4 comic_transform() {
    vec4 position = scene_from_model * vec4(vertex_position, 1.0);
    n_dot_l = dot(vertex_normal, direction_to_light(position.xyz));
    surface_coordinate = vertex_coordinate;
    face_color = material_diffuse * mix(vec3(1.0), vertex_color, vertex_color_share);
    return clip_from_scene * position;
}

// For light at each pixel as well.
vec4 comic_transform_with_normal() {
    vec4 clip_position = comic_transform();
    position_scene = (scene_from_model * vec4(vertex_position, 1.0)).xyz;
    normal_scene = vertex_normal;
    return clip_position;
}
#endif

#ifdef FRAGMENT_STAGE
uniform sampler2D shade_map_sampler;
uniform float color_share;  // 0: the map's colours alone

// N·L of the side that is seen. Its clamping to 0 and 1 is the map's.
float seen_n_dot_l() { return gl_FrontFacing ? n_dot_l : -n_dot_l; }

vec3 surface_color() { return face_color * texture(surface_sampler, surface_coordinate).rgb; }

vec4 unlit() { return vec4(surface_color(), 1.0); }

vec3 painted(vec3 tone) { return toned(mix(vec3(1.0), surface_color(), color_share), tone); }

vec4 comic() { return vec4(painted(covered_tone(shade_map_sampler, seen_n_dot_l())), 1.0); }
#endif
