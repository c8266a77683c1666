// Perlin's gradient noise over the picture (K. Perlin: An image synthesizer, 1985; Improving noise, 2002), as vectors.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <string_view>

#include "base/random.h"

namespace croquis::lines {

/// A smooth random vector field over the plane, with one wiggle or so a unit of length. A function of seed, purpose and
/// place alone.
class PerlinNoise {
public:
    PerlinNoise(std::uint64_t seed, std::string_view purpose) : random_(seed, purpose) {}

    /// The vector at a place. Never longer than 1; at lattice points, that is whole coordinates, it is zero.
    [[nodiscard]] glm::dvec2 at(const glm::dvec2& place) const;

private:
    Random random_;
};

}  // namespace croquis::lines
