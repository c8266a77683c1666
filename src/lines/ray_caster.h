// Rays through a surface, cast by Embree and checked in double precision.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "lines/surface.h"

namespace croquis::lines {

/// Where a segment passes through a face.
struct Piercing {
    std::uint32_t face = 0;
    double share = 0;  ///< of the segment's length, from its start
};

/// A tree over the faces of a surface. Building takes time and memory in proportion to them; asking does not change it,
/// so threads may share it. The surface must live as long.
class RayCaster {
public:
    explicit RayCaster(const Surface& surface);
    ~RayCaster();
    RayCaster(const RayCaster&) = delete;
    RayCaster& operator=(const RayCaster&) = delete;

    /// How many faces the segment crosses that starts at `from`, not counting `excluded` ones and those that it leaves
    /// within `tolerance` (scene units) of its start. Counting stops at `at_most`.
    [[nodiscard]] std::uint32_t layers(const glm::dvec3& from, const glm::dvec3& to,
                                       std::span<const std::uint32_t> excluded, double tolerance,
                                       std::uint32_t at_most) const;

    /// The faces that a segment passes through, but for `excluded` ones, in the order of their shares. Appends to
    /// `found`.
    void find_piercings(const glm::dvec3& from, const glm::dvec3& to, std::span<const std::uint32_t> excluded,
                        std::vector<Piercing>& found) const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

}  // namespace croquis::lines
