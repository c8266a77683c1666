#include "framework/surface_words.h"

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace croquis::framework {
namespace {

constexpr unsigned region_bits = 12;
constexpr std::uint32_t most_regions = (1u << region_bits) - 1u;
constexpr float octahedron_steps = 1023.0f;

float sign_not_zero(float v) { return v < 0.0f ? -1.0f : 1.0f; }

std::uint32_t pack_normal(const glm::vec3& normal) {
    const float sum = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
    glm::vec2 flat(normal.x / sum, normal.y / sum);
    if (normal.z < 0.0f) {
        flat = {(1.0f - std::abs(flat.y)) * sign_not_zero(flat.x), (1.0f - std::abs(flat.x)) * sign_not_zero(flat.y)};
    }
    const auto step = [](float v) { return std::uint32_t(std::lround((v * 0.5f + 0.5f) * octahedron_steps)); };
    return (step(flat.x) << 10) | step(flat.y);
}

glm::vec3 unpack_normal(std::uint32_t word) {
    const glm::vec2 flat(float(word >> 22) * (2.0f / octahedron_steps) - 1.0f,
                         float((word >> 12) & 1023u) * (2.0f / octahedron_steps) - 1.0f);
    glm::vec3 normal(flat, 1.0f - std::abs(flat.x) - std::abs(flat.y));
    const float below = std::max(-normal.z, 0.0f);
    normal.x -= sign_not_zero(normal.x) * below;
    normal.y -= sign_not_zero(normal.y) * below;
    return glm::normalize(normal);
}

}  // namespace

SurfaceWords pack(const SurfaceAttributes& attributes) {
    const std::uint32_t region = attributes.region == 0 ? 0 : (attributes.region - 1) % most_regions + 1;
    SurfaceWords words{(pack_normal(attributes.normal) << region_bits) | region, 0};
    std::memcpy(&words[1], &attributes.eye_distance, sizeof(float));
    return words;
}

SurfaceAttributes unpack(const SurfaceWords& words) {
    SurfaceAttributes attributes;
    attributes.normal = unpack_normal(words[0]);
    attributes.region = words[0] & most_regions;
    std::memcpy(&attributes.eye_distance, &words[1], sizeof(float));
    return attributes;
}

}  // namespace croquis::framework
