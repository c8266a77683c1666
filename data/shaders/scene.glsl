// What every surface shader shares: the camera, the light, the material, and what goes from vertex to pixel.
// Scene space has the model's bounding box centred on the origin and half its diagonal long as 1.

uniform mat4 clip_from_scene;
uniform mat4 eye_from_scene;
uniform mat4 scene_from_model;
uniform vec4 eye_scene;      // the eye's position (w = 1), or the direction to it in a parallel projection (w = 0)
uniform vec4 light_scene;    // the light's position (w = 1) or the unit direction to it (w = 0)
uniform vec3 light_color;

uniform vec3 material_ambient;
uniform vec3 material_diffuse;
uniform vec3 material_specular;
uniform float material_shininess;
uniform float vertex_color_share;   // 1: the mesh has colours at its vertices
uniform sampler2D surface_sampler;  // one white pixel where there is no texture
uniform uint region;                // identity of the mesh and its material, from 1

between vec3 position_scene;
between vec3 normal_scene;
between vec2 surface_coordinate;
between vec3 vertex_tint;

#ifdef VERTEX_STAGE
layout(location = 0) in vec3 vertex_position;
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in vec2 vertex_coordinate;
layout(location = 3) in vec3 vertex_color;

// Fills all that goes to the pixels; returns the clip-space position.
vec4 transform_surface() {
    vec4 position = scene_from_model * vec4(vertex_position, 1.0);
    position_scene = position.xyz;
    normal_scene = vertex_normal;  // scene space is scaled alike on all axes and not turned
    surface_coordinate = vertex_coordinate;
    vertex_tint = mix(vec3(1.0), vertex_color, vertex_color_share);
    return clip_from_scene * position;
}
#endif

#ifdef FRAGMENT_STAGE
// The unit normal on the side that is seen: open and inside-out surfaces are lit on both sides.
vec3 facing_normal() {
    vec3 normal = normalize(normal_scene);
    return gl_FrontFacing ? normal : -normal;
}

// What texture and vertex colours make of a material's colours.
vec3 surface_tint() { return texture(surface_sampler, surface_coordinate).rgb * vertex_tint; }
#endif

vec3 direction_to_eye(vec3 position) { return normalize(eye_scene.xyz - eye_scene.w * position); }

vec3 direction_to_light(vec3 position) { return normalize(light_scene.xyz - light_scene.w * position); }
