#include "framework/surface_attributes.h"

#include <algorithm>
#include <cmath>

namespace croquis::framework {
namespace {

constexpr float byte_steps = 255.0f;
constexpr float depth_steps = 65535.0f;
constexpr std::uint32_t most_regions = 255;

std::uint32_t in_steps(float share, float steps) {
    return std::uint32_t(std::lround(std::clamp(share, 0.0f, 1.0f) * steps));
}

std::uint8_t as_byte(float share) { return std::uint8_t(in_steps(share, byte_steps)); }

}  // namespace

PackedAttributes pack(const SurfaceAttributes& attributes) {
    const std::uint32_t id = attributes.region == 0 ? 0 : (attributes.region - 1) % most_regions + 1;
    const std::uint32_t depth = in_steps(attributes.depth, depth_steps);
    const glm::vec3 normal = attributes.normal * 0.5f + 0.5f;
    return {{as_byte(normal.x), as_byte(normal.y), as_byte(normal.z), std::uint8_t(id)},
            {std::uint8_t(depth >> 8), std::uint8_t(depth & 255u), as_byte(attributes.facing), 255}};
}

SurfaceAttributes unpack(const PackedAttributes& packed) {
    const auto& [normals, distances] = packed;
    return {glm::vec3(normals[0], normals[1], normals[2]) * (2.0f / byte_steps) - 1.0f, normals[3],
            float(distances[0] << 8 | distances[1]) / depth_steps, float(distances[2]) / byte_steps};
}

}  // namespace croquis::framework
