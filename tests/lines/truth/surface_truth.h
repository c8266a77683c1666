// What the tests know of a surface without looking at a view: which classes each edge has, and where faces pass through
// each other. From the definitions of lines/line_class.h, by brute force.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "lines/drafter.h"
#include "truth/face_tree.h"

namespace croquis::lines::truth {

/// Whether something holds, where the definition leaves doubt within rounding.
enum class Verdict : std::uint8_t { no, doubtful, yes };

/// An edge of the topology, or a piece of a line along which two faces pass through each other.
struct KnownEdge {
    std::array<glm::dvec3, 2> ends;
    std::vector<std::uint32_t> faces;  ///< all faces that hold it, ascending
    std::uint32_t edge = model::no_face;
    bool regular = false;  ///< two faces, wound against each other
    Verdict tagged = Verdict::no;
    Verdict crease = Verdict::no;
    Verdict intersection = Verdict::no;
    Verdict material = Verdict::no;
};

class SurfaceTruth {
public:
    SurfaceTruth(std::shared_ptr<const Surface> surface, double crease_angle);

    [[nodiscard]] const Surface& surface() const { return *surface_; }
    [[nodiscard]] const FaceTree& tree() const { return tree_; }
    /// The topology's edges in their order, then the intersections.
    [[nodiscard]] const std::vector<KnownEdge>& edges() const { return edges_; }
    /// The three edges of each face, as indices into `edges`: between corners 0 and 1, 1 and 2, 2 and 0.
    [[nodiscard]] const std::array<std::uint32_t, 3>& edges_of(std::uint32_t face) const { return edges_of_[face]; }
    [[nodiscard]] std::uint32_t mesh_of(std::uint32_t face) const { return surface_->topology().faces[face].mesh; }

private:
    void gather_edges();
    void classify(KnownEdge& edge, double crease_angle) const;
    void intersect_faces();
    void intersect(std::uint32_t one, std::uint32_t other);
    [[nodiscard]] bool share_vertex(std::uint32_t one, std::uint32_t other) const;

    std::shared_ptr<const Surface> surface_;
    FaceTree tree_;
    std::vector<KnownEdge> edges_;
    std::vector<std::array<std::uint32_t, 3>> edges_of_;
};

}  // namespace croquis::lines::truth
