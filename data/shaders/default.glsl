// The ordinary renderers: flat colour, Phong, Gouraud, faceted, and Gouraud with a metallic sphere map.
#include "light.glsl"

// Lighting at the vertices, for the side that the normal is on and for the other.
between vec2 factors_front;
between vec2 factors_back;
between vec2 sphere_coordinate;

#ifdef VERTEX_STAGE
vec4 default_transform() { return transform_surface(); }

vec4 gouraud_transform() {
    vec4 position = transform_surface();
    factors_front = lighting_factors(normal_scene, position_scene);
    factors_back = lighting_factors(-normal_scene, position_scene);
    return position;
}

// Where a sphere map, as OpenGL defines it, mirrors the surroundings at this vertex.
vec4 metallic_transform() {
    vec4 position = gouraud_transform();
    vec3 mirrored = mat3(eye_from_scene) * reflect(-direction_to_eye(position_scene), normal_scene);
    sphere_coordinate = 0.5 + mirrored.xy / (2.0 * length(mirrored + vec3(0.0, 0.0, 1.0)) + 1e-6);
    return position;
}
#endif

#ifdef FRAGMENT_STAGE
uniform sampler2D sphere_map_sampler;

// The object's own colour, without light.
vec4 base() { return vec4(material_diffuse * surface_tint(), 1.0); }

vec4 phong() { return vec4(phong_color(lighting_factors(facing_normal(), position_scene), surface_tint()), 1.0); }

vec4 gouraud() { return vec4(phong_color(gl_FrontFacing ? factors_front : factors_back, surface_tint()), 1.0); }

// One normal a triangle, from how the position changes across the screen.
vec4 flat_shaded() {
    vec3 normal = normalize(cross(dFdx(position_scene), dFdy(position_scene)));
    vec3 facing = dot(normal, direction_to_eye(position_scene)) < 0.0 ? -normal : normal;
    return vec4(phong_color(lighting_factors(facing, position_scene), surface_tint()), 1.0);
}

vec4 metallic() {
    vec2 factors = gl_FrontFacing ? factors_front : factors_back;
    vec3 metal = texture(sphere_map_sampler, sphere_coordinate).rgb;
    return vec4(phong_color(factors, surface_tint() * metal * 1.25), 1.0);
}
#endif
