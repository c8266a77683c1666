// Packed surface attributes, as data/shaders/packing.glsl packs them: the same rule in C++, for clearing and for tests.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace croquis::framework {

struct SurfaceAttributes {
    glm::vec3 normal{0.0f, 0.0f, 1.0f};  ///< unit, in world space
    std::uint32_t region = 0;            ///< 0: background
    float depth = 0;                     ///< linear: 0 at the near plane, 1 at the far plane
    float facing = 1;                    ///< cosine between the normal and the direction to the eye, 0 to 1
};

/// A pixel of the textures `normals` and `distances`, four bytes each.
struct PackedAttributes {
    std::array<std::uint8_t, 4> normals;
    std::array<std::uint8_t, 4> distances;
};

[[nodiscard]] PackedAttributes pack(const SurfaceAttributes& attributes);

/// The attributes as far as the bytes hold them; the normal's length may differ from 1 by a hundredth.
[[nodiscard]] SurfaceAttributes unpack(const PackedAttributes& packed);

}  // namespace croquis::framework
