// Three passes: corners are sorted into smooth fans around each welded vertex; render vertices on several fans are
// split; then each vertex sums over its fan. Normals are never stored a corner: at a million triangles that counts.
#include "model/normals.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "base/parallel.h"
#include "model/vertices.h"
#include "model/welding.h"

namespace croquis::model {
namespace {

constexpr std::uint32_t none = 0xffffffffu;

/// The arc cosine within 2e-8 (Abramowitz and Stegun, 4.4.46): three times as fast as the library's, and exact enough
/// for a weight.
double arc_cosine(double x) {
    const double a = std::min(std::abs(x), 1.0);
    double series = -0.0012624911;
    for (const double term :
         {0.0066700901, -0.0170881256, 0.0308918810, -0.0501743046, 0.0889789874, -0.2145988016, 1.5707963050}) {
        series = series * a + term;
    }
    const double angle = std::sqrt(1.0 - a) * series;
    return x < 0 ? std::numbers::pi - angle : angle;
}

/// The angle at `corner` times the unit normal of the triangle; zero for one of no area.
glm::dvec3 weighted_normal(const glm::dvec3& corner, const glm::dvec3& next, const glm::dvec3& previous) {
    const glm::dvec3 a = next - corner, b = previous - corner;
    const glm::dvec3 area = glm::cross(a, b);
    const double length = glm::length(area);
    if (!(length > 0)) return glm::dvec3(0.0);
    const double cosine = glm::dot(a, b) / std::sqrt(glm::dot(a, a) * glm::dot(b, b));
    return area * (arc_cosine(cosine) / length);
}

std::uint32_t next_corner(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
std::uint32_t previous_corner(std::uint32_t corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }

bool is_missing(const glm::vec3& normal) { return normal == glm::vec3(0.0f); }

/// All corners of all meshes, numbered through, around their welded vertices.
struct Corners {
    WeldedPoints points;
    std::vector<std::uint32_t> vertex;        ///< the welded vertex of each corner
    std::vector<std::size_t> first_of_mesh;   ///< the first corner of each mesh, and the count of all
    std::vector<std::uint32_t> around;        ///< corners, sorted by their welded vertex
    std::vector<std::uint32_t> first_around;  ///< where each welded vertex starts in `around`
    std::vector<glm::vec3> face_normal;       ///< one a face
    std::vector<std::uint32_t> fan;           ///< the fan of each corner, named by its first corner

    [[nodiscard]] std::span<const std::uint32_t> at(std::uint32_t v) const {
        return std::span(around).subspan(first_around[v], first_around[v + 1] - first_around[v]);
    }
};

void sort_around_vertices(Corners& corners, const Progress& progress) {
    corners.first_around.assign(corners.points.positions.size() + 1, 0);
    for (const std::uint32_t v : corners.vertex) ++corners.first_around[v + 1];
    for (std::size_t v = 1; v < corners.first_around.size(); ++v)
        corners.first_around[v] += corners.first_around[v - 1];
    std::vector<std::uint32_t> next(corners.first_around.begin(), corners.first_around.end() - 1);
    corners.around.resize(corners.vertex.size());
    for (std::uint32_t c = 0; c < corners.vertex.size(); ++c) {
        reach_now_and_then(progress, c, corners.vertex.size());
        corners.around[next[corners.vertex[c]]++] = c;
    }
}

Corners gather_corners(const std::vector<RawMesh>& meshes, const Progress& progress) {
    Corners corners;
    std::vector<std::span<const glm::vec3>> lists;
    std::size_t count = 0;
    for (const RawMesh& raw : meshes) {
        lists.emplace_back(raw.mesh.positions);
        count += raw.mesh.triangles.size();
    }
    corners.points = weld_points(lists, progress.part(0, 0.5));
    corners.vertex.reserve(count);
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        corners.first_of_mesh.push_back(corners.vertex.size());
        const std::uint32_t* const ids = corners.points.ids.data() + corners.points.first_of_list[m];
        for (const std::uint32_t v : meshes[m].mesh.triangles) corners.vertex.push_back(ids[v]);
    }
    corners.first_of_mesh.push_back(corners.vertex.size());
    corners.points.ids = {};
    sort_around_vertices(corners, progress.part(0.6, 0.9));
    corners.face_normal.resize(count / 3);
    parallel_for(count / 3, 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            const auto point = [&](std::size_t k) {
                return glm::dvec3(corners.points.positions[corners.vertex[3 * f + k]]);
            };
            const glm::dvec3 area = area_vector(point(0), point(1), point(2));
            const double length = glm::length(area);
            if (length > 0) corners.face_normal[f] = glm::vec3(area / length);
        }
    });
    return corners;
}

/// Whether two faces at an edge are one smooth surface.
class SmoothEdges {
public:
    SmoothEdges(const std::vector<RawMesh>& meshes, const Corners& corners, float crease_angle)
        : corners_(corners), smallest_dot_(std::cos(crease_angle)) {
        bool any = false;
        for (const RawMesh& raw : meshes) any = any || !raw.smoothing_groups.empty();
        if (!any) return;
        for (const RawMesh& raw : meshes) {
            const bool given = raw.smoothing_groups.size() == raw.mesh.triangle_count();
            for (std::size_t t = 0; t < raw.mesh.triangle_count(); ++t) {
                groups_.push_back(given ? raw.smoothing_groups[t] : no_group);
            }
        }
    }

    [[nodiscard]] bool operator()(std::uint32_t face_a, std::uint32_t face_b) const {
        const float dot = glm::dot(corners_.face_normal[face_a], corners_.face_normal[face_b]);
        if (dot > coplanar_dot) return true;  // a flat polygon's triangles share their vertices
        if (!groups_.empty() && (groups_[face_a] != no_group || groups_[face_b] != no_group)) {
            return (groups_[face_a] & groups_[face_b]) != 0;
        }
        return dot >= smallest_dot_;
    }

private:
    static constexpr std::uint32_t no_group = 0xffffffffu;  // of a mesh without groups
    static constexpr float coplanar_dot = 0.99999f;

    const Corners& corners_;
    float smallest_dot_;
    std::vector<std::uint32_t> groups_;
};

/// Sorts the corners around one vertex into fans.
class Fans {
public:
    void find(Corners& corners, const SmoothEdges& is_smooth, std::uint32_t vertex) {
        const auto around = corners.at(vertex);
        parent_.resize(around.size());
        sides_.clear();
        for (std::uint32_t i = 0; i < around.size(); ++i) {
            parent_[i] = i;
            sides_.push_back({corners.vertex[next_corner(around[i])], i});
            sides_.push_back({corners.vertex[previous_corner(around[i])], i});
        }
        std::sort(sides_.begin(), sides_.end());
        for (std::size_t begin = 0, end = 0; begin < sides_.size(); begin = end) {
            end = begin + 1;
            while (end < sides_.size() && sides_[end].first == sides_[begin].first) ++end;
            join_smooth(around, is_smooth, begin, end);
        }
        for (std::uint32_t i = 0; i < around.size(); ++i) corners.fan[around[i]] = around[root(i)];
    }

private:
    void join_smooth(std::span<const std::uint32_t> around, const SmoothEdges& is_smooth, std::size_t begin,
                     std::size_t end) {
        constexpr std::size_t most_compared = 16;  // of the faces on a crowded edge: keeps hostile files linear
        for (std::size_t a = begin; a < end; ++a) {
            for (std::size_t b = a + 1; b < std::min(end, a + most_compared); ++b) {
                const std::uint32_t i = sides_[a].second, j = sides_[b].second;
                if (is_smooth(around[i] / 3, around[j] / 3)) join(root(i), root(j));
            }
        }
    }

    [[nodiscard]] std::uint32_t root(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    void join(std::uint32_t a, std::uint32_t b) { parent_[std::max(a, b)] = std::min(a, b); }

    std::vector<std::uint32_t> parent_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> sides_;  // the vertex at the far end, and whose side it is
};

/// Gives each vertex of a mesh one fan, splitting those that miss a normal and stand on several. Returns the fans.
std::vector<std::uint32_t> split_by_fans(RawMesh& raw, MeshRig* rig, const Corners& corners, std::size_t first_corner) {
    Mesh& mesh = raw.mesh;
    std::vector<std::uint32_t> fan(mesh.positions.size(), none);
    std::vector<std::uint32_t> next_copy(mesh.positions.size(), none);
    std::vector<std::uint32_t> sources;
    for (std::size_t c = 0; c < mesh.triangles.size(); ++c) {
        const std::uint32_t wanted = corners.fan[first_corner + c];
        const std::uint32_t original = mesh.triangles[c];
        std::uint32_t v = original;
        if (fan[v] == none) fan[v] = wanted;
        if (!is_missing(mesh.normals[original])) continue;
        while (fan[v] != wanted && next_copy[v] != none) v = next_copy[v];
        if (fan[v] != wanted) {
            next_copy[v] = static_cast<std::uint32_t>(fan.size());
            v = next_copy[v];
            fan.push_back(wanted);
            next_copy.push_back(none);
            sources.push_back(original);
        }
        mesh.triangles[c] = v;
    }
    append_copies(mesh, rig, sources);
    return fan;
}

/// Fills the zero normals of one list. `point_of(corner)` is the position of a corner, in double.
template <typename PointOf>
void sum_over_fans(const Corners& corners, std::span<const std::uint32_t> fan, std::size_t first_corner,
                   std::size_t last_corner, const PointOf& point_of, std::vector<glm::vec3>& normals) {
    parallel_for(normals.size(), 2048, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            if (fan[v] == none || !is_missing(normals[v])) continue;
            glm::dvec3 sum(0.0);
            for (const std::uint32_t c : corners.at(corners.vertex[fan[v]])) {
                if (corners.fan[c] != fan[v] || c < first_corner || c >= last_corner) continue;
                sum += weighted_normal(point_of(c), point_of(next_corner(c)), point_of(previous_corner(c)));
            }
            const double length = glm::length(sum);
            normals[v] = length > 0 ? glm::vec3(sum / length) : glm::vec3(0.0f, 1.0f, 0.0f);
        }
    });
}

bool any_missing(const std::vector<glm::vec3>& normals) {
    return std::any_of(normals.begin(), normals.end(), is_missing);
}

bool any_missing(const RawMesh& raw, const MeshRig* rig) {
    if (any_missing(raw.mesh.normals)) return true;
    if (rig == nullptr) return false;
    return any_missing(rig->normals) || std::any_of(rig->shapes.begin(), rig->shapes.end(),
                                                    [](const Shape& shape) { return any_missing(shape.normals); });
}

/// The normals of a rig's own positions and shapes, over the same fans but within the mesh.
void complete_rig(MeshRig& rig, const Mesh& mesh, const Corners& corners, std::span<const std::uint32_t> fan,
                  std::size_t first_corner) {
    const auto complete = [&](const std::vector<glm::vec3>& positions, std::vector<glm::vec3>& normals) {
        const auto point_of = [&](std::uint32_t c) { return glm::dvec3(positions[mesh.triangles[c - first_corner]]); };
        sum_over_fans(corners, fan, first_corner, first_corner + mesh.triangles.size(), point_of, normals);
    };
    complete(rig.positions, rig.normals);
    for (Shape& shape : rig.shapes) complete(shape.positions, shape.normals);
}

}  // namespace

void complete_normals(std::vector<RawMesh>& meshes, Rig& rig, float crease_angle, const Progress& progress) {
    const auto rig_of = [&](std::size_t m) { return rig.meshes.empty() ? nullptr : &rig.meshes[m]; };
    bool any = false;
    for (std::size_t m = 0; m < meshes.size(); ++m) any = any || any_missing(meshes[m], rig_of(m));
    if (!any) return;
    Corners corners = gather_corners(meshes, progress.part(0, 0.4));
    corners.fan.resize(corners.vertex.size());
    {
        const SmoothEdges is_smooth(meshes, corners, crease_angle);
        const auto find_fans = [&](std::size_t begin, std::size_t end) {
            Fans fans;
            for (std::size_t v = begin; v < end; ++v) fans.find(corners, is_smooth, static_cast<std::uint32_t>(v));
        };
        parallel_for_in_slices(corners.points.positions.size(), 2048, progress.part(0.4, 0.7), find_fans);
    }
    corners.face_normal = {};
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        if (!any_missing(meshes[m], rig_of(m))) continue;
        const double share = double(m) / double(meshes.size());
        const Progress filling = progress.part(0.7 + 0.3 * share, 1);
        filling.reach(0);
        const std::size_t first = corners.first_of_mesh[m];
        const std::vector<std::uint32_t> fan = split_by_fans(meshes[m], rig_of(m), corners, first);
        const auto point_of = [&](std::uint32_t c) { return glm::dvec3(corners.points.positions[corners.vertex[c]]); };
        sum_over_fans(corners, fan, 0, corners.vertex.size(), point_of, meshes[m].mesh.normals);
        if (rig_of(m) != nullptr) complete_rig(*rig_of(m), meshes[m].mesh, corners, fan, first);
    }
}

}  // namespace croquis::model
