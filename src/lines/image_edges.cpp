#include "lines/image_edges.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/parallel.h"

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

struct ImageEdges::Gathering {
    const Viewpoint& view;
    const Features& features;
    std::span<const std::uint32_t> silhouettes;
    bool draws_silhouettes;
    std::vector<bool> hides_own_backs;  // one a mesh

    Gathering(const Surface& surface, const Viewpoint& from, const Features& of, std::span<const std::uint32_t> found,
              LineClasses classes)
        : view(from),
          features(of),
          silhouettes(found),
          draws_silhouettes(classes.has(LineClass::silhouette) || classes.has(LineClass::contour)) {
        const model::Topology& topology = surface.topology();
        const bool outside = view.projection == model::Projection::parallel || glm::length(view.eye) > 1.0;
        for (std::size_t m = 0; m < topology.mesh_is_solid.size(); ++m) {
            hides_own_backs.push_back(outside && topology.mesh_is_solid[m] && !topology.mesh_is_inverted[m]);
        }
    }

    [[nodiscard]] bool is_within_solids(const std::vector<model::Face>& faces, FacePair pair) const {
        return hides_own_backs[faces[pair.first].mesh] && hides_own_backs[faces[pair.second].mesh];
    }
};

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
    const Gathering gathering(surface_, view, features, silhouettes, classes);
    candidates_.resize(silhouettes.size() + features.regular.size() + features.irregular.size() +
                       features.cuts.segments.size());
    parallel_for(candidates_.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) candidates_[i] = candidate(gathering, i);
    });
    for (const Candidate& one : candidates_) place(one);
    connect();
}

ImageEdges::Candidate ImageEdges::candidate(const Gathering& gathering, std::size_t index) const {
    const Features& features = gathering.features;
    if (index < gathering.silhouettes.size()) return of_silhouette(gathering, gathering.silhouettes[index]);
    index -= gathering.silhouettes.size();
    if (index < features.regular.size()) return of_feature(gathering, features.regular[index]);
    index -= features.regular.size();
    if (index < features.irregular.size()) return of_irregular(gathering, features.irregular[index]);
    return of_cut(gathering, static_cast<std::uint32_t>(index - features.irregular.size()));
}

ImageEdges::Candidate ImageEdges::of_silhouette(const Gathering& gathering, std::uint32_t e) const {
    const model::Topology& topology = surface_.topology();
    const FacePair pair = surface_.pairs()[e];
    ImageEdge edge{0, 0, e};
    edge.step = static_cast<std::int8_t>(2 * side_of(surface_, topology.edges[e], pair.first, gathering.view));
    edge.bend = bend_of(surface_, topology.edges[e], pair);
    edge.is_sharp = surface_.bend_cosine(pair) < gathering.features.crease_cosine;
    edge.is_line = gathering.draws_silhouettes;
    edge.never_seen = edge.bend < 0 && gathering.is_within_solids(topology.faces, pair);
    return projected(gathering.view, edge);
}

// An edge that a feature's class draws although it is a silhouette too stands twice: once to hide, once as a line.
ImageEdges::Candidate ImageEdges::of_feature(const Gathering& gathering, const Feature& feature) const {
    const bool is_silhouette =
        std::binary_search(gathering.silhouettes.begin(), gathering.silhouettes.end(), feature.edge);
    if (is_silhouette && gathering.draws_silhouettes) return {};
    const FacePair pair = surface_.pairs()[feature.edge];
    ImageEdge edge{0, 0, feature.edge};
    edge.line_class = feature.line_class;
    edge.is_line = true;
    edge.never_seen = !is_silhouette && gathering.is_within_solids(surface_.topology().faces, pair) &&
                      !surface_.front_facing(pair.first, gathering.view);
    return projected(gathering.view, edge);
}

ImageEdges::Candidate ImageEdges::of_irregular(const Gathering& gathering, const IrregularEdge& irregular) const {
    ImageEdge edge{0, 0, irregular.edge};
    int step = 0;
    for (const std::uint32_t f : gathering.features.faces_of(irregular)) {
        step += side_of(surface_, surface_.topology().edges[irregular.edge], f, gathering.view);
    }
    edge.step = static_cast<std::int8_t>(std::clamp(step, -127, 127));
    const bool is_silhouette = step != 0 && irregular.face_count > 1 && gathering.draws_silhouettes;
    edge.line_class = is_silhouette ? LineClass::silhouette : irregular.line_class;
    edge.is_line = is_silhouette || irregular.is_feature;
    if (!edge.is_line && step == 0) return {};
    return projected(gathering.view, edge);
}

ImageEdges::Candidate ImageEdges::of_cut(const Gathering& gathering, std::uint32_t segment) const {
    ImageEdge edge{0, 0, segment};
    edge.line_class = LineClass::intersection;
    edge.is_line = true;
    const auto end = [&](std::uint32_t node) {
        return End{cuts_->nodes[node].point, static_cast<std::uint32_t>(surface_.vertex_count()) + node};
    };
    const auto& [a, b] = cuts_->segments[segment].nodes;
    return projected(gathering.view, edge, {end(a), end(b)});
}

ImageEdges::Candidate ImageEdges::projected(const Viewpoint& view, ImageEdge edge) const {
    const FacePair pair = surface_.pairs()[edge.edge];
    edge.is_edge_on = surface_.is_edge_on(pair.first, view) || surface_.is_edge_on(pair.second, view);
    const auto& [a, b] = surface_.topology().edges[edge.edge].vertices;
    return projected(view, edge, {End{surface_.point(a), a}, End{surface_.point(b), b}});
}

ImageEdges::Candidate ImageEdges::projected(const Viewpoint& view, const ImageEdge& edge,
                                            std::array<End, 2> ends) const {
    Candidate one;
    one.edge = edge;
    std::array<bool, 2> is_cut{false, false};
    if (view.projection == model::Projection::perspective) {
        const double distance[2] = {view.eye_distance(ends[0].point), view.eye_distance(ends[1].point)};
        one.is_whole = distance[0] >= view.near_distance && distance[1] >= view.near_distance;
        if (distance[0] < view.near_distance && distance[1] < view.near_distance) return one;
        for (const std::size_t i : {0u, 1u}) {
            if (distance[i] >= view.near_distance) continue;
            const double share = (view.near_distance - distance[1 - i]) / (distance[i] - distance[1 - i]);
            ends[i].point = ends[1 - i].point + share * (ends[i].point - ends[1 - i].point);
            is_cut[i] = true;
        }
    }
    one.image = {view.project(ends[0].point), view.project(ends[1].point)};
    const glm::dvec2 low = glm::min(one.image[0].position, one.image[1].position);
    const glm::dvec2 high = glm::max(one.image[0].position, one.image[1].position);
    one.is_in_picture = high.x >= 0 && high.y >= 0 && low.x <= view.width && low.y <= view.height;
    for (const std::size_t i : {0u, 1u}) {
        const glm::dvec2 p = one.image[i].position;
        const bool in_frame = p.x >= 0 && p.y >= 0 && p.x <= view.width && p.y <= view.height;
        one.is_whole = one.is_whole && in_frame;
        // What joins edges outside of the frame need not be known: there lines may be hidden by what was left out.
        if (in_frame && !is_cut[i]) one.numbers[i] = ends[i].number;
        if (!is_cut[i]) one.image[i] = moved(one.image[i], ends[i].number);
    }
    return one;
}

void ImageEdges::place(const Candidate& candidate) {
    is_whole_ = is_whole_ && candidate.is_whole;
    if (!candidate.is_in_picture) return;
    ImageEdge edge = candidate.edge;
    edge.a = placed(candidate.image[0], candidate.numbers[0]);
    edge.b = placed(candidate.image[1], candidate.numbers[1]);
    edges_.push_back(edge);
}

std::uint32_t ImageEdges::placed(const ImagePoint& point, std::uint32_t number) {
    const auto next = static_cast<std::uint32_t>(vertices_.size());
    if (number == no_vertex) {
        vertices_.push_back({point.position, point.nearness, no_vertex});
        return next;
    }
    std::uint32_t& id = image_vertex_of_[number];
    if (id == no_vertex) {
        id = next;
        shared_numbers_.push_back(number);
        vertices_.push_back({point.position, point.nearness, number < surface_.vertex_count() ? number : no_vertex});
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

ImagePoint ImageEdges::point_beside(const ImageEdge& edge, double share, double pixels) const {
    ImagePoint point = point_at(edge, share);
    const glm::dvec2 offset = along(edge) * (pixels / length_of(edge));
    point.position += edge.step > 0 ? glm::dvec2(-offset.y, offset.x) : glm::dvec2(offset.y, -offset.x);
    return point;
}

}  // namespace croquis::lines
