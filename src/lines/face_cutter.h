// Two faces and where they pass through each other.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "lines/general_position.h"
#include "lines/surface.h"

namespace croquis::lines {

/// The place where an edge, named by its vertices, the smaller first, passes through a face; or, with the same vertex
/// twice and no face, a vertex.
struct CutPlace {
    std::uint32_t a = 0, b = 0, face = 0;
    auto operator<=>(const CutPlace&) const = default;
};

/// The segment in which two faces meet.
struct FaceCut {
    std::array<std::uint32_t, 2> faces{};
    std::array<CutPlace, 2> ends{};
    bool is_certain = false;  ///< false if rounding of the faces' corners could part them
};

class FaceCutter {
public:
    FaceCutter(const Surface& surface, const GeneralPosition& points) : surface_(surface), points_(points) {}

    /// Appends the segments in which a face meets others. Faces with a common edge, and faces of which one lies in the
    /// other's plane, do not meet.
    void cut(std::uint32_t face, std::span<const std::uint32_t> others, std::vector<FaceCut>& found) const;

    /// A place in scene space: on the unmoved edge, where it passes the unmoved face if rounding allows.
    [[nodiscard]] glm::dvec3 point_of(const CutPlace& place) const;

private:
    using Triangle = std::array<std::uint32_t, 3>;
    struct Plane;

    [[nodiscard]] const Triangle& corners(std::uint32_t face) const { return surface_.topology().faces[face].vertices; }
    void cut_pair(std::uint32_t f, const Plane& first_plane, std::uint32_t g, std::vector<FaceCut>& found) const;
    [[nodiscard]] bool pierces(std::uint32_t a, std::uint32_t b, const Triangle& face) const;
    [[nodiscard]] bool extends_beyond(std::uint32_t face, const Plane& plane) const;

    const Surface& surface_;
    const GeneralPosition& points_;
};

}  // namespace croquis::lines
