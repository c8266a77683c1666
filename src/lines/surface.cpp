#include "lines/surface.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "base/parallel.h"
#include "model/posed_shape.h"

namespace croquis::lines {
namespace {

constexpr std::size_t faces_a_piece = 8192;

/// True when the face's winding passes from a to b.
bool winds_along(const model::Face& face, std::uint32_t a, std::uint32_t b) {
    const auto& v = face.vertices;
    return (v[0] == a && v[1] == b) || (v[1] == a && v[2] == b) || (v[2] == a && v[0] == b);
}

}  // namespace

Surface::Surface(std::shared_ptr<const model::Model> model, const model::Pose* pose)
    : model_(std::move(model)), topology_(&model_->topology()), positions_(topology_->positions) {
    if (pose != nullptr) {
        posed_positions_ = model::posed_shape(*model_, pose).positions;
        positions_ = posed_positions_;
    }
    const model::SceneSpace space = model::SceneSpace::of(*model_);
    centre_ = space.centre - model_->origin;
    per_unit_ = 1.0 / space.radius;
    make_planes();
    make_pairs();
    make_stars();
}

void Surface::make_planes() {
    planes_.resize(topology_->faces.size());
    parallel_for(planes_.size(), faces_a_piece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            const auto& [a, b, c] = topology_->faces[f].vertices;
            const glm::dvec3 corner = point(a);
            const glm::dvec3 area = glm::cross(point(b) - corner, point(c) - corner);
            const double length = glm::length(area);
            if (!(length > 0)) continue;
            const glm::dvec3 normal = area / length;
            planes_[f] = glm::vec4(normal, -glm::dot(normal, corner));
        }
    });
}

void Surface::make_pairs() {
    const std::vector<model::Edge>& edges = topology_->edges;
    pairs_.resize(edges.size());
    parallel_for(edges.size(), faces_a_piece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t e = begin; e < end; ++e) {
            const auto& [a, b] = edges[e].vertices;
            const auto& [first, second] = edges[e].faces;
            const bool regular = second != model::no_face && winds_along(topology_->faces[first], a, b) !=
                                                                 winds_along(topology_->faces[second], a, b);
            pairs_[e] = {first, regular ? second : first};
        }
    });
    for (const std::uint32_t e : topology_->crowded_edges) pairs_[e].second = pairs_[e].first;
    for (std::uint32_t e = 0; e < pairs_.size(); ++e) {
        if (pairs_[e].first == pairs_[e].second) irregular_edges_.push_back(e);
    }
}

void Surface::make_stars() {
    const std::vector<model::Face>& faces = topology_->faces;
    star_starts_.assign(positions_.size() + 2, 0);
    for (const model::Face& face : faces) {
        for (const std::uint32_t v : face.vertices) ++star_starts_[v + 2];
    }
    for (std::size_t v = 2; v < star_starts_.size(); ++v) star_starts_[v] += star_starts_[v - 1];
    star_faces_.resize(faces.size() * 3);
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        for (const std::uint32_t v : faces[f].vertices) star_faces_[star_starts_[v + 1]++] = f;
    }
    star_starts_.pop_back();
}

bool Surface::exactly_front_facing(std::uint32_t face, const Viewpoint& view) const {
    const auto& [a, b, c] = topology_->faces[face].vertices;
    const glm::dvec3 corner = point(a);
    const glm::dvec3 area = glm::cross(point(b) - corner, point(c) - corner);
    const glm::dvec3 ray = view.towards_eye(corner);
    return glm::dot(area, ray) > edge_on_sine * glm::length(area) * glm::length(ray);
}

std::vector<std::uint32_t> Surface::creases(double angle) const {
    const double cosine = std::cos(angle);
    std::vector<std::uint32_t> found;
    for (std::uint32_t e = 0; e < pairs_.size(); ++e) {
        const auto [first, second] = pairs_[e];
        if (first == second) continue;
        if (glm::dot(glm::vec3(planes_[first]), glm::vec3(planes_[second])) < cosine) found.push_back(e);
    }
    return found;
}

std::vector<std::uint32_t> Surface::material_boundaries() const {
    std::vector<std::uint32_t> found;
    if (model_->meshes.size() < 2) return found;
    for (std::uint32_t e = 0; e < pairs_.size(); ++e) {
        const auto [first, second] = pairs_[e];
        if (topology_->faces[first].mesh != topology_->faces[second].mesh) found.push_back(e);
    }
    return found;
}

}  // namespace croquis::lines
