#include "lines/features.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace croquis::lines {
namespace {

bool contains(const model::Face& face, std::uint32_t vertex) {
    return std::find(face.vertices.begin(), face.vertices.end(), vertex) != face.vertices.end();
}

/// Lists that hold each edge once, under the class that comes first.
std::vector<Feature> merged(std::vector<Feature> features) {
    std::sort(features.begin(), features.end(), [](const Feature& a, const Feature& b) {
        return a.edge != b.edge ? a.edge < b.edge : a.line_class < b.line_class;
    });
    const auto same_edge = [](const Feature& a, const Feature& b) { return a.edge == b.edge; };
    features.erase(std::unique(features.begin(), features.end(), same_edge), features.end());
    return features;
}

void append(std::vector<Feature>& features, const std::vector<std::uint32_t>& edges, LineClass line_class) {
    for (const std::uint32_t e : edges) features.push_back({e, line_class});
}

bool is_copy(const model::Face& a, const model::Face& b) {
    return std::all_of(a.vertices.begin(), a.vertices.end(), [&](std::uint32_t v) { return contains(b, v); });
}

/// The sharpest bend among the faces of an edge, as the cosine between normals; faces wound alike along the edge are
/// taken as if one of them were turned over. Faces that stand in the model several times count once.
float smallest_cosine(const Surface& surface, const model::Edge& edge, std::span<const std::uint32_t> faces) {
    float smallest = 1;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        for (std::size_t k = i + 1; k < faces.size(); ++k) {
            if (is_copy(surface.topology().faces[faces[i]], surface.topology().faces[faces[k]])) continue;
            const bool alike = winds_along(surface.topology().faces[faces[i]], edge) ==
                               winds_along(surface.topology().faces[faces[k]], edge);
            const float cosine = surface.bend_cosine({faces[i], faces[k]});
            smallest = std::min(smallest, alike ? -cosine : cosine);
        }
    }
    return smallest;
}

}  // namespace

std::uint32_t corner_opposite(const model::Face& face, const model::Edge& edge) {
    for (const std::uint32_t v : face.vertices) {
        if (v != edge.vertices[0] && v != edge.vertices[1]) return v;
    }
    return face.vertices[0];
}

bool winds_along(const model::Face& face, const model::Edge& edge) {
    const auto& v = face.vertices;
    const auto& [a, b] = edge.vertices;
    return (v[0] == a && v[1] == b) || (v[1] == a && v[2] == b) || (v[2] == a && v[0] == b);
}

Features::Features(const Surface& surface, LineClasses classes, double crease_angle) {
    const model::Topology& topology = surface.topology();
    crease_cosine = static_cast<float>(std::cos(crease_angle));
    std::vector<Feature> found;
    if (classes.has(LineClass::tagged)) append(found, topology.tagged_edges, LineClass::tagged);
    if (classes.has(LineClass::crease)) append(found, surface.creases(crease_angle), LineClass::crease);
    if (classes.has(LineClass::material)) append(found, surface.material_boundaries(), LineClass::material);
    found = merged(std::move(found));

    if (classes.has(LineClass::intersection)) cuts = find_cut_curves(surface);

    std::size_t next = 0;
    for (const Feature& feature : found) {
        const FacePair pair = surface.pairs()[feature.edge];
        if (pair.first != pair.second) regular.push_back(feature);
    }
    for (const std::uint32_t e : surface.irregular_edges()) {
        const model::Edge& edge = topology.edges[e];
        IrregularEdge one{e, static_cast<std::uint32_t>(irregular_faces.size()), 0, LineClass::border, false};
        for (const std::uint32_t f : surface.faces_around(edge.vertices[0])) {
            if (contains(topology.faces[f], edge.vertices[1])) irregular_faces.push_back(f);
        }
        one.face_count = static_cast<std::uint32_t>(irregular_faces.size()) - one.first_face;
        while (next < found.size() && found[next].edge < e) ++next;
        const bool is_tagged =
            next < found.size() && found[next].edge == e && found[next].line_class == LineClass::tagged;
        const float cosine = smallest_cosine(surface, edge, faces_of(one));
        if (one.face_count == 1 && classes.has(LineClass::border)) {
            one.is_feature = true;
        } else if (is_tagged) {
            one.line_class = LineClass::tagged;
            one.is_feature = true;
        } else if (one.face_count > 1 && classes.has(LineClass::crease) && cosine < crease_cosine) {
            one.line_class = LineClass::crease;
            one.is_feature = true;
        }
        irregular.push_back(one);
    }
}

}  // namespace croquis::lines
