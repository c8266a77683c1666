// Packed surface attributes, as data/shaders/packing.glsl packs them: the same rule in C++, for clearing and for tests.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace croquis::framework {

struct SurfaceAttributes {
    glm::vec3 normal{0.0f, 0.0f, 1.0f};  ///< unit, in world space
    std::uint32_t region = 0;            ///< 0: background
    float eye_distance = 0;              ///< linear, in scene units
};

using SurfaceWords = std::array<std::uint32_t, 2>;

[[nodiscard]] SurfaceWords pack(const SurfaceAttributes& attributes);
[[nodiscard]] SurfaceAttributes unpack(const SurfaceWords& words);

}  // namespace croquis::framework
