#include "lines/image_edges.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/random.h"

namespace croquis::lines {
namespace {

/// How far ends are moved in the picture, as a share of the frame. Below the noise of single precision positions, far
/// above that of double precision.
constexpr double shift_share = 1e-10;

double shift_of(std::uint32_t vertex, std::uint32_t axis) {
    std::uint64_t bits = (std::uint64_t{vertex} << 1 | axis) * 0x9e3779b97f4a7c15ull;
    bits ^= bits >> 31;
    bits *= 0xbf58476d1ce4e5b9ull;
    bits ^= bits >> 29;
    return static_cast<double>(bits >> 11) * 0x1.0p-52 - 1.0;
}

/// Given where the vertex truly stands.
ImagePoint moved(ImagePoint point, std::uint32_t vertex) {
    point.position += glm::dvec2(shift_of(vertex, 0), shift_of(vertex, 1)) * (shift_share * 1000.0);
    return point;
}

/// 1 for an edge over which the surface bends away from its outer side, -1 where it bends towards it; 0 where single
/// precision planes cannot tell.
std::int8_t bend_of(const Surface& surface, const model::Edge& edge, FacePair pair) {
    const glm::vec4& plane = surface.planes()[pair.first];
    const glm::dvec3 corner = surface.point(corner_opposite(surface.topology().faces[pair.second], edge));
    const double height = glm::dot(glm::dvec3(plane.x, plane.y, plane.z), corner) + plane.w;
    if (std::abs(height) < 1e-6) return 0;
    return height > 0 ? -1 : 1;
}

}  // namespace

ImagePoint image_of(const Surface& surface, const Viewpoint& view, std::uint32_t vertex) {
    return moved(view.project(surface.point(vertex)), vertex);
}

// A face that is turned to the eye and wound along the edge lies to its left as the eye sees it, and y points down in
// the picture.
int side_of(const Surface& surface, const model::Edge& edge, std::uint32_t face, const Viewpoint& view) {
    return winds_along(surface.topology().faces[face], edge) == surface.front_facing(face, view) ? 1 : -1;
}

ImageEdges::ImageEdges(const Surface& surface) : surface_(surface) {}

void ImageEdges::gather(const Viewpoint& view, const Features& features, std::span<const std::uint32_t> silhouettes,
                        LineClasses classes) {
    for (const std::uint32_t number : shared_numbers_) image_vertex_of_[number] = no_vertex;
    shared_numbers_.clear();
    image_vertex_of_.resize(surface_.vertex_count() + features.cuts.nodes.size(), no_vertex);
    vertices_.clear();
    edges_.clear();
    is_whole_ = true;
    cuts_ = &features.cuts;
    const model::Topology& topology = surface_.topology();
    const bool outside = view.projection == model::Projection::parallel || glm::length(view.eye) > 1.0;
    mesh_hides_own_backs_.assign(topology.mesh_is_solid.size(), false);
    for (std::size_t m = 0; m < mesh_hides_own_backs_.size(); ++m) {
        mesh_hides_own_backs_[m] = outside && topology.mesh_is_solid[m] && !topology.mesh_is_inverted[m];
    }
    const bool draws_silhouettes = classes.has(LineClass::silhouette) || classes.has(LineClass::contour);
    add_regular(view, features, silhouettes, draws_silhouettes);
    add_irregular(view, features, draws_silhouettes);
    for (std::uint32_t i = 0; i < cuts_->segments.size(); ++i) {
        ImageEdge edge{0, 0, i};
        edge.line_class = LineClass::intersection;
        edge.is_line = true;
        const auto end = [&](std::uint32_t node) {
            return End{cuts_->nodes[node].point, static_cast<std::uint32_t>(surface_.vertex_count()) + node};
        };
        add(view, edge, {end(cuts_->segments[i].nodes[0]), end(cuts_->segments[i].nodes[1])});
    }
    connect();
}

void ImageEdges::add_regular(const Viewpoint& view, const Features& features,
                             std::span<const std::uint32_t> silhouettes, bool draws_silhouettes) {
    const model::Topology& topology = surface_.topology();
    const auto within_solids = [&](FacePair pair) {
        return mesh_hides_own_backs_[topology.faces[pair.first].mesh] &&
               mesh_hides_own_backs_[topology.faces[pair.second].mesh];
    };
    for (const std::uint32_t e : silhouettes) {
        const FacePair pair = surface_.pairs()[e];
        ImageEdge edge{0, 0, e};
        edge.step = static_cast<std::int8_t>(2 * side_of(surface_, topology.edges[e], pair.first, view));
        edge.bend = bend_of(surface_, topology.edges[e], pair);
        edge.is_line = draws_silhouettes;
        edge.never_seen = edge.bend < 0 && within_solids(pair);
        add(view, edge);
    }
    std::size_t next = 0;
    for (const Feature& feature : features.regular) {
        while (next < silhouettes.size() && silhouettes[next] < feature.edge) ++next;
        const bool is_silhouette = next < silhouettes.size() && silhouettes[next] == feature.edge;
        if (is_silhouette && draws_silhouettes) continue;
        const FacePair pair = surface_.pairs()[feature.edge];
        ImageEdge edge{0, 0, feature.edge};
        edge.line_class = feature.line_class;
        edge.is_line = true;
        edge.never_seen = !is_silhouette && within_solids(pair) && !surface_.front_facing(pair.first, view);
        add(view, edge);
    }
}

void ImageEdges::add_irregular(const Viewpoint& view, const Features& features, bool draws_silhouettes) {
    for (const IrregularEdge& irregular : features.irregular) {
        ImageEdge edge{0, 0, irregular.edge};
        int step = 0;
        for (const std::uint32_t f : features.faces_of(irregular)) {
            step += side_of(surface_, surface_.topology().edges[irregular.edge], f, view);
        }
        edge.step = static_cast<std::int8_t>(std::clamp(step, -127, 127));
        const bool is_silhouette = step != 0 && irregular.face_count > 1 && draws_silhouettes;
        edge.line_class = is_silhouette ? LineClass::silhouette : irregular.line_class;
        edge.is_line = is_silhouette || irregular.is_feature;
        if (edge.is_line || step != 0) add(view, edge);
    }
}

// An edge that a feature's class draws although it is a silhouette too stands twice: once to hide, once as a line.
void ImageEdges::add(const Viewpoint& view, const ImageEdge& edge) {
    const auto& [a, b] = surface_.topology().edges[edge.edge].vertices;
    add(view, edge, {End{surface_.point(a), a}, End{surface_.point(b), b}});
}

void ImageEdges::add(const Viewpoint& view, ImageEdge edge, std::array<End, 2> ends) {
    std::array<bool, 2> is_cut{false, false};
    if (view.projection == model::Projection::perspective) {
        const double distance[2] = {view.eye_distance(ends[0].point), view.eye_distance(ends[1].point)};
        if (distance[0] < view.near_distance && distance[1] < view.near_distance) {
            is_whole_ = false;
            return;
        }
        for (const std::size_t i : {0u, 1u}) {
            if (distance[i] >= view.near_distance) continue;
            const double share = (view.near_distance - distance[1 - i]) / (distance[i] - distance[1 - i]);
            ends[i].point = ends[1 - i].point + share * (ends[i].point - ends[1 - i].point);
            is_cut[i] = true;
            is_whole_ = false;
        }
    }
    const ImagePoint image[2] = {view.project(ends[0].point), view.project(ends[1].point)};
    const glm::dvec2 low = glm::min(image[0].position, image[1].position);
    const glm::dvec2 high = glm::max(image[0].position, image[1].position);
    if (!(high.x >= 0 && high.y >= 0 && low.x <= view.width && low.y <= view.height)) {
        is_whole_ = false;
        return;
    }
    std::uint32_t ids[2];
    for (const std::size_t i : {0u, 1u}) {
        const glm::dvec2& p = image[i].position;
        const bool in_frame = p.x >= 0 && p.y >= 0 && p.x <= view.width && p.y <= view.height;
        if (!in_frame) is_whole_ = false;
        if (in_frame && !is_cut[i]) {
            ids[i] = shared_vertex(ends[i].number, image[i]);
        } else {
            // What joins edges outside of the frame need not be known: there lines may be hidden by what was left out.
            ids[i] = static_cast<std::uint32_t>(vertices_.size());
            const ImagePoint end = is_cut[i] ? image[i] : moved(image[i], ends[i].number);
            vertices_.push_back({end.position, end.nearness, no_vertex});
        }
    }
    edge.a = ids[0];
    edge.b = ids[1];
    edges_.push_back(edge);
}

std::uint32_t ImageEdges::shared_vertex(std::uint32_t number, const ImagePoint& point) {
    std::uint32_t& id = image_vertex_of_[number];
    if (id == no_vertex) {
        id = static_cast<std::uint32_t>(vertices_.size());
        shared_numbers_.push_back(number);
        const ImagePoint end = moved(point, number);
        vertices_.push_back({end.position, end.nearness, number < surface_.vertex_count() ? number : no_vertex});
    }
    return id;
}

void ImageEdges::connect() {
    around_starts_.assign(vertices_.size() + 2, 0);
    for (const ImageEdge& edge : edges_) {
        ++around_starts_[edge.a + 2];
        ++around_starts_[edge.b + 2];
    }
    for (std::size_t v = 2; v < around_starts_.size(); ++v) around_starts_[v] += around_starts_[v - 1];
    around_.resize(edges_.size() * 2);
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
        around_[around_starts_[edges_[e].a + 1]++] = e;
        around_[around_starts_[edges_[e].b + 1]++] = e;
    }
    around_starts_.pop_back();
}

ImagePoint ImageEdges::point_at(const ImageEdge& edge, double share) const {
    const ImageVertex& a = vertices_[edge.a];
    const ImageVertex& b = vertices_[edge.b];
    return {a.position + share * (b.position - a.position), a.nearness + share * (b.nearness - a.nearness)};
}

}  // namespace croquis::lines
