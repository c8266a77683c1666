// Surfaces in one colour, whatever their material: the ground of technical drawings.

#ifdef FRAGMENT_STAGE
uniform vec3 color;

vec4 one_color() { return vec4(color, 1.0); }
#endif
