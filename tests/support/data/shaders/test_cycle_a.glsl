#include "test_cycle_b.glsl"
vec4 color() { return vec4(1.0); }
