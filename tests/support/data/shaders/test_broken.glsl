// Includes a file whose third line does not compile.
#include "test_broken_part.glsl"

#ifdef FRAGMENT_STAGE
vec4 color() { return vec4(half_of(1.0)); }
#endif
