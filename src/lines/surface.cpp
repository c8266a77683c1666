#include "lines/surface.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "base/parallel.h"
#include "model/posed_shape.h"

namespace croquis::lines {
namespace {

constexpr std::size_t faces_a_piece = 8192;

}  // namespace

Surface::Surface(std::shared_ptr<const model::Model> model, const model::Pose* pose)
    : model_(std::move(model)), topology_(&model_->topology()), positions_(topology_->positions) {
    if (pose != nullptr) {
        posed_positions_ = model::posed_positions(*model_, *pose);
        positions_ = posed_positions_;
    }
    const model::SceneSpace space = model::SceneSpace::of(*model_);
    centre_ = space.centre - model_->origin;
    per_unit_ = 1.0 / space.radius;
    make_planes();
    make_pairs();
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
            const auto& [first, second] = edges[e].faces;
            pairs_[e] = {first, second == model::no_face ? first : second};
        }
    });
    for (const std::uint32_t e : topology_->crowded_edges) pairs_[e].second = pairs_[e].first;
    for (const std::uint32_t e : topology_->twisted_edges) pairs_[e].second = pairs_[e].first;
    for (std::uint32_t e = 0; e < pairs_.size(); ++e) {
        if (pairs_[e].first == pairs_[e].second) irregular_edges_.push_back(e);
    }
}

double Surface::eye_sine(std::uint32_t face, const Viewpoint& view) const {
    const auto& [a, b, c] = topology_->faces[face].vertices;
    const glm::dvec3 corner = point(a);
    const glm::dvec3 area = glm::cross(point(b) - corner, point(c) - corner);
    const glm::dvec3 ray = view.towards_eye(corner);
    const double size = glm::length(area) * glm::length(ray);
    return size > 0 ? glm::dot(area, ray) / size : 0.0;
}

std::vector<std::uint32_t> Surface::creases(double angle) const {
    const auto cosine = static_cast<float>(std::cos(angle));
    std::vector<std::uint32_t> found;
    for (std::uint32_t e = 0; e < pairs_.size(); ++e) {
        if (pairs_[e].first != pairs_[e].second && bend_cosine(pairs_[e]) < cosine) found.push_back(e);
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
