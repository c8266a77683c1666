// Back again.
#include "test_cycle_a.glsl"
