// What it includes is nowhere.

#include "imagge.glsl"
vec4 color() { return vec4(1.0); }
