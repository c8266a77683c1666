// A grid over the picture, each cell with the faces that may be seen in it.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "output/vector_regions.h"

namespace croquis::output {

using lines::Surface;
using lines::Viewpoint;

MeshPicker::MeshPicker(const Surface& surface, const Viewpoint& view) : surface_(surface), view_(view) {
    constexpr double smallest_cell = 2;
    const double faces = double(std::max<std::size_t>(surface.face_count(), 1));
    cell_ = std::max(smallest_cell, std::sqrt(view.width * view.height / faces));
    columns_ = std::max(1, int(std::ceil(view.width / cell_)));
    rows_ = std::max(1, int(std::ceil(view.height / cell_)));
    starts_.assign(std::size_t(columns_) * std::size_t(rows_) + 2, 0);
    const auto count = std::uint32_t(surface.face_count());
    const auto for_cells = [&](const auto& use) {
        for (std::uint32_t f = 0; f < count; ++f) {
            const Span span = cells_of(f);
            for (int y = span.low_y; y <= span.high_y; ++y) {
                for (int x = span.low_x; x <= span.high_x; ++x)
                    use(f, std::size_t(y) * std::size_t(columns_) + std::size_t(x));
            }
        }
    };
    for_cells([&](std::uint32_t, std::size_t cell) { ++starts_[cell + 2]; });
    for (std::size_t cell = 2; cell < starts_.size(); ++cell) starts_[cell] += starts_[cell - 1];
    faces_.resize(starts_.back());
    for_cells([&](std::uint32_t face, std::size_t cell) { faces_[starts_[cell + 1]++] = face; });
    starts_.pop_back();
}

// The box of cells around a face; all cells for one that comes nearer to the eye than can be projected.
MeshPicker::Span MeshPicker::cells_of(std::uint32_t face) const {
    glm::dvec2 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
    int before_eye = 0;
    for (const std::uint32_t vertex : surface_.topology().faces[face].vertices) {
        const glm::dvec3 point = surface_.point(vertex);
        if (view_.projection == model::Projection::perspective && view_.eye_distance(point) < view_.near_distance)
            continue;
        ++before_eye;
        const glm::dvec2 place = view_.project(point).position;
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    if (before_eye == 0) return {0, 0, -1, -1};
    if (before_eye < 3) return {0, 0, columns_ - 1, rows_ - 1};
    if (high.x < 0 || high.y < 0 || low.x > view_.width || low.y > view_.height) return {0, 0, -1, -1};
    const auto index = [&](double place, int cells) {
        return int(std::clamp(std::floor(place / cell_), 0.0, double(cells - 1)));
    };
    return {index(low.x, columns_), index(low.y, rows_), index(high.x, columns_), index(high.y, rows_)};
}

// How near the face is along the ray eye + t · ray, as 1 / t in perspective and -t else; the lowest number where the
// ray misses it. After Möller and Trumbore.
double MeshPicker::nearness_at(std::uint32_t face, const glm::dvec3& eye, const glm::dvec3& ray) const {
    constexpr double miss = std::numeric_limits<double>::lowest();
    const auto& corners = surface_.topology().faces[face].vertices;
    const glm::dvec3 a = surface_.point(corners[0]);
    const glm::dvec3 ab = surface_.point(corners[1]) - a, ac = surface_.point(corners[2]) - a;
    const glm::dvec3 across = glm::cross(ray, ac);
    const double volume = glm::dot(ab, across);
    if (volume == 0) return miss;
    const glm::dvec3 from_a = eye - a;
    const double u = glm::dot(from_a, across) / volume;
    const glm::dvec3 turn = glm::cross(from_a, ab);
    const double v = glm::dot(ray, turn) / volume;
    if (!(u >= 0 && v >= 0 && u + v <= 1)) return miss;
    const double distance = glm::dot(ac, turn) / volume;
    if (view_.projection == model::Projection::parallel) return -distance;
    return distance > view_.near_distance ? 1.0 / distance : miss;
}

std::uint32_t MeshPicker::mesh_at(const glm::dvec2& pixel) const {
    const int column = int(std::floor(pixel.x / cell_)), row = int(std::floor(pixel.y / cell_));
    if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return no_region;
    const bool is_perspective = view_.projection == model::Projection::perspective;
    // The point at eye distance 1 for the direction; a parallel ray starts there.
    const glm::dvec3 ahead = view_.unproject({pixel, is_perspective ? 1.0 : -1.0});
    const glm::dvec3 eye = is_perspective ? view_.eye : ahead;
    const glm::dvec3 ray = is_perspective ? ahead - view_.eye : -view_.back;
    double nearest = std::numeric_limits<double>::lowest();
    std::uint32_t mesh = no_region;
    const std::size_t cell = std::size_t(row) * std::size_t(columns_) + std::size_t(column);
    for (std::uint32_t i = starts_[cell]; i < starts_[cell + 1]; ++i) {
        const double nearness = nearness_at(faces_[i], eye, ray);
        if (nearness <= nearest) continue;
        nearest = nearness;
        mesh = surface_.topology().faces[faces_[i]].mesh;
    }
    return mesh;
}

}  // namespace croquis::output
