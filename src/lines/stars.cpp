#include "lines/stars.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "base/parallel.h"

namespace croquis::lines {
namespace {

/// Directions at a vertex as the eye sees them: x and y across the ray, z towards the eye.
class Lookout {
public:
    Lookout(const glm::dvec3& vertex, const glm::dvec3& towards_eye)
        : vertex_(vertex), towards_eye_(glm::normalize(towards_eye)) {
        const glm::dvec3 axis = std::abs(towards_eye_.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        across_ = glm::normalize(glm::cross(towards_eye_, axis));
        along_ = glm::cross(towards_eye_, across_);
    }

    [[nodiscard]] glm::dvec3 towards(const glm::dvec3& point) const {
        const glm::dvec3 offset = point - vertex_;
        return {glm::dot(offset, across_), glm::dot(offset, along_), glm::dot(offset, towards_eye_)};
    }

private:
    glm::dvec3 vertex_, towards_eye_, across_, along_;
};

double turn(const glm::dvec3& a, const glm::dvec3& b) { return a.x * b.y - a.y * b.x; }

/// The turn from a corner's direction to the edge's; where they line up, as if the edge were turned a little further.
bool turns_left(const glm::dvec3& corner, const glm::dvec3& edge) {
    const double value = turn(corner, edge);
    return value != 0 ? value > 0 : corner.x * edge.x + corner.y * edge.y > 0;
}

/// True when the face with corners in these directions covers the edge's direction and lies in front of it.
bool hides(const glm::dvec3& first, const glm::dvec3& second, const glm::dvec3& edge) {
    const double whole = turn(first, second);
    if (whole == 0) return false;
    const bool counter_clockwise = whole > 0;
    if (turns_left(first, edge) != counter_clockwise || turns_left(second, edge) == counter_clockwise) return false;
    const double depth = (turn(edge, second) * first.z + turn(first, edge) * second.z) / whole;
    return depth > edge.z;
}

/// A vertex that joins just two silhouettes, both convex or both concave, is no cusp: both are as much hidden there.
bool may_be_cusp(const ImageEdges& edges, std::uint32_t vertex) {
    const auto around = edges.edges_at(vertex);
    if (around.size() != 2) return around.size() > 2;
    const std::int8_t first = edges.edges()[around[0]].bend, second = edges.edges()[around[1]].bend;
    return first == 0 || first != second;
}

}  // namespace

std::vector<std::array<std::int16_t, 2>> layers_at_ends(const Surface& surface, const Viewpoint& view,
                                                        const ImageEdges& edges) {
    std::vector<std::array<std::int16_t, 2>> layers(edges.edges().size(), {0, 0});
    const model::Topology& topology = surface.topology();
    parallel_for(edges.vertices().size(), 256, [&](std::size_t begin, std::size_t end) {
        struct Ending {
            std::uint32_t image_edge, other_vertex;
            glm::dvec3 direction;
            std::int16_t count = 0;
        };
        std::vector<Ending> endings;
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t vertex = edges.vertices()[i].vertex;
            if (vertex == no_vertex || !may_be_cusp(edges, static_cast<std::uint32_t>(i))) continue;
            const glm::dvec3 here = surface.point(vertex);
            const Lookout lookout(here, view.towards_eye(here));
            endings.clear();
            for (const std::uint32_t e : edges.edges_at(static_cast<std::uint32_t>(i))) {
                const auto& ends = topology.edges[edges.edges()[e].edge].vertices;
                const std::uint32_t other = ends[0] == vertex ? ends[1] : ends[0];
                endings.push_back({e, other, lookout.towards(surface.point(other))});
            }
            for (const std::uint32_t f : surface.faces_around(vertex)) {
                const auto& v = topology.faces[f].vertices;
                const std::size_t corner = v[0] == vertex ? 0 : v[1] == vertex ? 1 : 2;
                const std::uint32_t next = v[(corner + 1) % 3], last = v[(corner + 2) % 3];
                const glm::dvec3 first = lookout.towards(surface.point(next));
                const glm::dvec3 second = lookout.towards(surface.point(last));
                for (Ending& ending : endings) {
                    if (ending.other_vertex == next || ending.other_vertex == last) continue;
                    if (hides(first, second, ending.direction)) ++ending.count;
                }
            }
            for (const Ending& ending : endings) {
                const bool at_a = edges.edges()[ending.image_edge].a == i;
                layers[ending.image_edge][at_a ? 0 : 1] = ending.count;
            }
        }
    });
    return layers;
}

}  // namespace croquis::lines
