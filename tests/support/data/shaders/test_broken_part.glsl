// The third line adds what cannot be added.

float half_of(float x) { return x + ivec3(1); }
