#include "truth/surface_truth.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <utility>

namespace croquis::lines::truth {
namespace {

/// Radians about the crease angle within which single precision may decide.
constexpr double crease_doubt = 2e-6;
/// Scene units within which a corner may lie in another face's plane: then faces touch rather than pass through.
constexpr double touch_doubt = 1e-7;

glm::dvec3 area_of(const std::array<glm::dvec3, 3>& face) { return glm::cross(face[1] - face[0], face[2] - face[0]); }

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

bool winds_along(const model::Face& face, const std::array<std::uint32_t, 2>& ends) {
    for (std::size_t k = 0; k < 3; ++k) {
        if (face.vertices[k] == ends[0] && face.vertices[(k + 1) % 3] == ends[1]) return true;
    }
    return false;
}

/// Where a face meets another's plane: from `begin` to `end` along the line that both planes share.
struct Stretch {
    double begin = 0, end = 0;
};

std::optional<Stretch> stretch_on(const std::array<glm::dvec3, 3>& face, const std::array<double, 3>& heights,
                                  const glm::dvec3& from, const glm::dvec3& along) {
    std::vector<double> found;
    for (std::size_t k = 0; k < 3; ++k) {
        const double a = heights[k], b = heights[(k + 1) % 3];
        if ((a > 0) == (b > 0)) continue;
        const glm::dvec3 point = face[k] + (face[(k + 1) % 3] - face[k]) * (a / (a - b));
        found.push_back(glm::dot(point - from, along));
    }
    if (found.size() != 2) return std::nullopt;
    return Stretch{std::min(found[0], found[1]), std::max(found[0], found[1])};
}

}  // namespace

SurfaceTruth::SurfaceTruth(std::shared_ptr<const Surface> surface, double crease_angle)
    : surface_(std::move(surface)), tree_(*surface_) {
    gather_edges();
    for (KnownEdge& edge : edges_) classify(edge, crease_angle);
    for (const std::uint32_t e : surface_->topology().tagged_edges) edges_[e].tagged = Verdict::yes;
    intersect_faces();
}

void SurfaceTruth::gather_edges() {
    const model::Topology& topology = surface_->topology();
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
    for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
        const auto& [a, b] = topology.edges[e].vertices;
        numbers.emplace(std::minmax(a, b), e);
        KnownEdge edge;
        edge.ends = {surface_->point(a), surface_->point(b)};
        edge.edge = e;
        edges_.push_back(std::move(edge));
    }
    for (std::uint32_t f = 0; f < topology.faces.size(); ++f) {
        const auto& corners = topology.faces[f].vertices;
        std::array<std::uint32_t, 3>& sides = edges_of_.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            sides[k] = numbers.at(std::minmax(corners[k], corners[(k + 1) % 3]));
            edges_[sides[k]].faces.push_back(f);
        }
    }
}

void SurfaceTruth::classify(KnownEdge& edge, double crease_angle) const {
    if (edge.faces.size() < 2) return;
    const model::Topology& topology = surface_->topology();
    const auto& ends = topology.edges[edge.edge].vertices;
    const std::uint32_t first = edge.faces[0], second = edge.faces[1];
    edge.regular =
        edge.faces.size() == 2 && winds_along(topology.faces[first], ends) != winds_along(topology.faces[second], ends);
    const auto if_regular = [&](bool holds) {
        return !edge.regular ? Verdict::doubtful : holds ? Verdict::yes : Verdict::no;
    };
    const double angle = angle_between(area_of(tree_.corners(first)), area_of(tree_.corners(second)));
    edge.crease = std::abs(angle - crease_angle) < crease_doubt ? Verdict::doubtful : if_regular(angle > crease_angle);
    const bool meshes_meet = std::any_of(edge.faces.begin(), edge.faces.end(),
                                         [&](std::uint32_t f) { return mesh_of(f) != mesh_of(first); });
    if (meshes_meet) edge.material = if_regular(true);
}

bool SurfaceTruth::share_vertex(std::uint32_t one, std::uint32_t other) const {
    const auto& a = surface_->topology().faces[one].vertices;
    const auto& b = surface_->topology().faces[other].vertices;
    return std::any_of(a.begin(), a.end(),
                       [&](std::uint32_t v) { return std::find(b.begin(), b.end(), v) != b.end(); });
}

void SurfaceTruth::intersect_faces() {
    for (std::uint32_t one = 0; one < tree_.face_count(); ++one) {
        Box box;
        for (const glm::dvec3& corner : tree_.corners(one)) box.add(corner);
        std::vector<std::uint32_t> others;
        tree_.for_each_in(box, [&](std::uint32_t other) {
            if (other > one) others.push_back(other);
        });
        for (const std::uint32_t other : others) intersect(one, other);
    }
}

void SurfaceTruth::intersect(std::uint32_t one, std::uint32_t other) {
    const std::array<glm::dvec3, 3>&a = tree_.corners(one), &b = tree_.corners(other);
    const glm::dvec3 normal_a = glm::normalize(area_of(a)), normal_b = glm::normalize(area_of(b));
    std::array<double, 3> heights_a{}, heights_b{};  // over the other's plane
    double least = 1;
    for (std::size_t k = 0; k < 3; ++k) {
        heights_a[k] = glm::dot(normal_b, a[k] - b[0]);
        heights_b[k] = glm::dot(normal_a, b[k] - a[0]);
        least = std::min({least, std::abs(heights_a[k]), std::abs(heights_b[k])});
    }
    const glm::dvec3 crossing = glm::cross(normal_a, normal_b);
    if (glm::length(crossing) < 1e-9) return;  // parallel: they overlap or do not meet
    const glm::dvec3 along = glm::normalize(crossing);
    const std::optional<Stretch> of_a = stretch_on(a, heights_a, a[0], along);
    const std::optional<Stretch> of_b = stretch_on(b, heights_b, a[0], along);
    if (!of_a || !of_b) return;
    const double begin = std::max(of_a->begin, of_b->begin), end = std::min(of_a->end, of_b->end);
    if (!(end - begin > 1e-12)) return;
    // A point of both planes on the line, found from where an edge of `a` meets b's plane.
    glm::dvec3 base(0.0);
    for (std::size_t k = 0; k < 3; ++k) {
        const double low = heights_a[k], high = heights_a[(k + 1) % 3];
        if ((low > 0) != (high > 0)) base = a[k] + (a[(k + 1) % 3] - a[k]) * (low / (low - high));
    }
    const double at = glm::dot(base - a[0], along);
    KnownEdge edge;
    edge.ends = {base + along * (begin - at), base + along * (end - at)};
    edge.faces = {one, other};
    edge.intersection = least < touch_doubt || share_vertex(one, other) ? Verdict::doubtful : Verdict::yes;
    edges_.push_back(std::move(edge));
}

}  // namespace croquis::lines::truth
