#include "truth/view_truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace croquis::lines::truth {
namespace {

/// Sine of the angle between a face and the view ray below which rounding may decide how the face is turned.
constexpr double edge_on_doubt = 1e-6;
/// Scene units: what is hit nearer to the point than the first touches it; up to the second it is not certain.
constexpr double touching = 1e-9, touch_doubt = 1e-6;
/// Pixels from an outline to where it is asked what lies outside of it.
constexpr double just_outside = 1e-3;
/// No point of a model in scene space is farther from the origin.
constexpr double scene_reach = 1.5;

bool is_perspective(const Viewpoint& view) { return view.projection == model::Projection::perspective; }

}  // namespace

double SeenEdge::length() const { return glm::distance(begin.position, end.position); }

ImagePoint SeenEdge::at(double share) const {
    return {begin.position + (end.position - begin.position) * share,
            begin.nearness + (end.nearness - begin.nearness) * share};
}

struct ViewTruth::Ray {
    glm::dvec3 origin;
    glm::dvec3 direction;  // unit, towards the eye
    double to_near = 0;    // where it comes nearer to the eye than anything is drawn
};

ViewTruth::ViewTruth(const SurfaceTruth& surface, const Viewpoint& view) : surface_(surface), view_(view) {
    for (std::uint32_t e = 0; e < surface_.edges().size(); ++e) classify(e);
}

// The side of the edge's image on which a face lies, by the plane through the eye and the edge.
ViewTruth::Side ViewTruth::side_of(const KnownEdge& edge, std::uint32_t face) const {
    const std::array<glm::dvec3, 3>& corners = surface_.tree().corners(face);
    const auto apex = std::find_if(corners.begin(), corners.end(), [&](const glm::dvec3& corner) {
        return corner != edge.ends[0] && corner != edge.ends[1];
    });
    const glm::dvec3 along = edge.ends[1] - edge.ends[0];
    const glm::dvec3 plane = glm::cross(along, view_.towards_eye(edge.ends[0]));
    const glm::dvec3 offset = *apex - edge.ends[0];
    const double height = glm::dot(plane, offset) / glm::length(plane);
    const double distance = glm::length(glm::cross(along, offset)) / glm::length(along);
    if (!(std::abs(height) > edge_on_doubt * distance)) return Side::edge_on;
    return height > 0 ? Side::left : Side::right;
}

void ViewTruth::classify(std::uint32_t known) {
    const KnownEdge& edge = surface_.edges()[known];
    Verdict silhouette = Verdict::no, border = Verdict::no;
    if (edge.edge != model::no_face) {
        bool edge_on = false;
        std::array<std::size_t, 2> faces_on{0, 0};
        for (const std::uint32_t face : edge.faces) {
            const Side side = side_of(edge, face);
            if (side == Side::edge_on) edge_on = true;
            if (side != Side::edge_on) ++faces_on[side == Side::left ? 1 : 0];
        }
        changes_layers_.push_back(edge_on || edge.faces.size() != 2 || faces_on[0] != faces_on[1]);
        if (edge.faces.size() == 1) border = Verdict::yes;
        if (edge.faces.size() > 2) silhouette = border = Verdict::doubtful;
        if (edge.faces.size() == 2) {
            const bool folds = faces_on[0] == 2 || faces_on[1] == 2;
            if (folds) silhouette = edge.regular ? Verdict::yes : Verdict::doubtful;
            if (edge_on) silhouette = Verdict::doubtful;
        }
    }
    SeenEdge seen;
    seen.known = known;
    for (const auto& [verdict, line_class] :
         {std::pair{silhouette, LineClass::silhouette}, std::pair{border, LineClass::border},
          std::pair{edge.tagged, LineClass::tagged}, std::pair{edge.crease, LineClass::crease},
          std::pair{edge.intersection, LineClass::intersection}, std::pair{edge.material, LineClass::material}}) {
        if (verdict == Verdict::no) continue;
        seen.classes.add(line_class);
        seen.required = verdict == Verdict::yes;
        if (seen.required) break;
    }
    if (seen.classes == LineClasses{} || !clip(edge, seen)) return;
    if (silhouette != Verdict::no || border != Verdict::no) seen.outward = outward_of(seen, edge.faces[0]);
    edges_.push_back(seen);
}

// Against the near distance and the frame's four sides, as planes of scene space.
bool ViewTruth::clip(const KnownEdge& edge, SeenEdge& seen) const {
    double begin = 0, end = 1;
    const auto heights_over_planes = [&](const glm::dvec3& point) {
        const glm::dvec3 offset = point - view_.eye;
        const double depth = -glm::dot(offset, view_.back);
        const double unit = is_perspective(view_) ? depth : 1.0;
        const double x = view_.scale * glm::dot(offset, view_.right), y = view_.scale * glm::dot(offset, view_.up);
        const double half_width = 0.5 * view_.width * unit, half_height = 0.5 * view_.height * unit;
        return std::array{depth - view_.near_distance, half_width + x, half_width - x, half_height + y,
                          half_height - y};
    };
    const auto from = heights_over_planes(edge.ends[0]), to = heights_over_planes(edge.ends[1]);
    for (std::size_t k = 0; k < from.size(); ++k) {
        if (from[k] < 0 && to[k] < 0) return false;
        if (from[k] < 0) begin = std::max(begin, from[k] / (from[k] - to[k]));
        if (to[k] < 0) end = std::min(end, from[k] / (from[k] - to[k]));
    }
    if (!(begin < end)) return false;
    const glm::dvec3 along = edge.ends[1] - edge.ends[0];
    seen.begin = view_.project(edge.ends[0] + along * begin);
    seen.end = view_.project(edge.ends[0] + along * end);
    return seen.length() > 1e-6;  // seen end-on, it is a point
}

glm::dvec2 ViewTruth::outward_of(const SeenEdge& seen, std::uint32_t face) const {
    const KnownEdge& edge = surface_.edges()[seen.known];
    const Side side = side_of(edge, face);
    if (side == Side::edge_on) return glm::dvec2(0.0);
    // A point beside the edge's image lies left of the edge if its ray does.
    const glm::dvec2 along = glm::normalize(seen.end.position - seen.begin.position);
    const glm::dvec2 across(-along.y, along.x);
    const ImagePoint middle = seen.at(0.5);
    const glm::dvec3 beside = view_.unproject({middle.position + across, middle.nearness});
    const glm::dvec3 plane = glm::cross(edge.ends[1] - edge.ends[0], view_.towards_eye(edge.ends[0]));
    const bool across_is_left = glm::dot(plane, beside - edge.ends[0]) > 0;
    return across_is_left == (side == Side::left) ? -across : across;
}

ViewTruth::Ray ViewTruth::ray_through(const ImagePoint& point) const {
    Ray ray;
    ray.origin = view_.unproject(point);
    const glm::dvec3 way = view_.towards_eye(ray.origin);
    ray.direction = glm::normalize(way);
    const double nearer_each_unit = glm::dot(ray.direction, view_.back);
    ray.to_near = (view_.eye_distance(ray.origin) - view_.near_distance) / nearer_each_unit;
    return ray;
}

Sight ViewTruth::sight(const SeenEdge& edge, const ImagePoint& point) const {
    const Ray ray = ray_through(point);
    return cast(ray, 0, ray.to_near, surface_.edges()[edge.known]);
}

Verdict ViewTruth::is_contour(const SeenEdge& edge, const ImagePoint& point) const {
    if (edge.outward == glm::dvec2(0.0)) return Verdict::doubtful;
    const Ray ray = ray_through({point.position + edge.outward * just_outside, point.nearness});
    const double to_end = scene_reach + glm::length(ray.origin);
    const Sight all = cast(ray, -to_end, ray.to_near, surface_.edges()[edge.known]);
    if (!all.certain) return Verdict::doubtful;
    return all.layers == 0 ? Verdict::yes : Verdict::no;
}

Sight ViewTruth::cast(const Ray& ray, double low, double high, const KnownEdge& own) const {
    const double farthest = is_perspective(view_) ? glm::length(view_.eye) + scene_reach : 1.0;
    const double reach = 2 * doubt * farthest / view_.scale;
    Sight sight;
    surface_.tree().for_each_near_ray(ray.origin, ray.direction, low - touch_doubt, high, reach,
                                      [&](std::uint32_t face) {
                                          if (std::find(own.faces.begin(), own.faces.end(), face) != own.faces.end())
                                              return;
                                          meet(face, ray, low, high, own, sight);
                                      });
    return sight;
}

// Which side of each of the face's edges the ray passes on is decided once for the edge, so that no ray slips between
// two faces.
void ViewTruth::meet(std::uint32_t face, const Ray& ray, double low, double high, const KnownEdge& own,
                     Sight& sight) const {
    const model::Topology& topology = surface_.surface().topology();
    int to_left = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t e = surface_.edges_of(face)[k];
        const KnownEdge& edge = surface_.edges()[e];
        if (changes_layers_[e] && e != own.edge && pixels_to(ray, low - touch_doubt, high, edge) < doubt) {
            sight.certain = false;
        }
        const glm::dvec3 to_one = edge.ends[0] - ray.origin, to_other = edge.ends[1] - ray.origin;
        const bool left = glm::dot(ray.direction, glm::cross(to_one, to_other)) >= 0;
        const bool along_edge = topology.faces[face].vertices[k] == topology.edges[e].vertices[0];
        to_left += left == along_edge ? 1 : 0;
    }
    if (to_left != 0 && to_left != 3) return;
    const auto& [a, b, c] = surface_.tree().corners(face);
    const glm::dvec3 area = glm::cross(b - a, c - a);
    const double along = -glm::dot(area, ray.origin - a) / glm::dot(area, ray.direction);
    if (!(along > low - touch_doubt && along < high)) return;
    if (low < 0 || along > touch_doubt) {
        ++sight.layers;
    } else if (std::abs(along) > touching) {
        sight.certain = false;
    }
}

// From the ray to an edge, where the ray passes it between `low` and `high`.
double ViewTruth::pixels_to(const Ray& ray, double low, double high, const KnownEdge& edge) const {
    const glm::dvec3 along = edge.ends[1] - edge.ends[0], offset = edge.ends[0] - ray.origin;
    const double lean = glm::dot(ray.direction, along), start = glm::dot(ray.direction, offset);
    const double across = glm::dot(along, along) - lean * lean;
    const double share = across > 0 ? std::clamp((lean * start - glm::dot(along, offset)) / across, 0.0, 1.0) : 0.0;
    const double place = start + lean * share;
    if (!(place > low && place < high)) return 1e300;
    const glm::dvec3 nearest = edge.ends[0] + along * share;
    const double distance = glm::length(nearest - ray.origin - ray.direction * place);
    return distance * view_.scale / (is_perspective(view_) ? std::max(view_.eye_distance(nearest), 1e-9) : 1.0);
}

}  // namespace croquis::lines::truth
