// Where a point of the surface is at rest, for what must stay on a surface that moves. A component draws with it by
// asking for anchored vertices.
#include "scene.glsl"

between vec3 rest_position;  // scene space
between vec3 rest_normal;

#ifdef VERTEX_STAGE
layout(location = 8) in vec3 vertex_rest_position;
layout(location = 9) in vec3 vertex_rest_normal;

void transform_rest() {
    rest_position = (scene_from_model * vec4(vertex_rest_position, 1.0)).xyz;
    rest_normal = vertex_rest_normal;
}
#endif
