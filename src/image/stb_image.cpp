// The body of stb_image, in a file of its own because its warnings are not ours.
#define STB_IMAGE_IMPLEMENTATION
#define STBI_MAX_DIMENSIONS 32768  // image::longest_side
#include <stb/stb_image.h>
