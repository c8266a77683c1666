// Edges by a counting sort of half-edges on their smaller vertex: each bucket then holds a handful of them.
#include "model/topology.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "model/model.h"
#include "model/welding.h"

namespace croquis::model {
namespace {

/// Side k of face f is half-edge 3 f + k, from corner k to corner k + 1.
struct Side {
    std::uint32_t from = 0;
    std::uint32_t to = 0;

    [[nodiscard]] std::uint32_t smaller() const { return std::min(from, to); }
    [[nodiscard]] std::uint32_t larger() const { return std::max(from, to); }
    [[nodiscard]] bool forward() const { return from < to; }
};

Side side_of(const std::vector<Face>& faces, std::uint32_t half_edge) {
    const auto& vertices = faces[half_edge / 3].vertices;
    const std::uint32_t corner = half_edge % 3;
    return {vertices[corner], vertices[corner == 2 ? 0 : corner + 1]};
}

void add_faces(Topology& topology, const Mesh& mesh, std::uint32_t mesh_index, std::span<const std::uint32_t> ids) {
    for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
        const Face face{{ids[mesh.triangles[t]], ids[mesh.triangles[t + 1]], ids[mesh.triangles[t + 2]]}, mesh_index};
        const auto& p = topology.positions;
        const glm::dvec3 area = area_vector(p[face.vertices[0]], p[face.vertices[1]], p[face.vertices[2]]);
        const double length = glm::length(area);
        if (!(length > 0)) continue;
        topology.faces.push_back(face);
        topology.face_normals.emplace_back(area / length);
    }
}

/// Half-edges sorted by their smaller vertex; within a vertex, by the larger one and then by face.
std::vector<std::uint32_t> sorted_half_edges(const Topology& topology) {
    const auto& faces = topology.faces;
    const auto count = static_cast<std::uint32_t>(faces.size() * 3);
    std::vector<std::uint32_t> starts(topology.positions.size() + 1, 0);
    for (std::uint32_t h = 0; h < count; ++h) ++starts[side_of(faces, h).smaller() + 1];
    for (std::size_t v = 1; v < starts.size(); ++v) starts[v] += starts[v - 1];
    std::vector<std::uint32_t> sorted(count);
    std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
    for (std::uint32_t h = 0; h < count; ++h) sorted[next[side_of(faces, h).smaller()]++] = h;
    for (std::size_t v = 0; v + 1 < starts.size(); ++v) {
        std::sort(sorted.begin() + starts[v], sorted.begin() + starts[v + 1], [&](std::uint32_t a, std::uint32_t b) {
            const std::uint32_t larger_a = side_of(faces, a).larger(), larger_b = side_of(faces, b).larger();
            return larger_a != larger_b ? larger_a < larger_b : a < b;
        });
    }
    return sorted;
}

/// The connected parts of surfaces: faces joined at their edges (union-find, with path halving).
class Parts {
public:
    explicit Parts(std::size_t face_count) : parent_(face_count), count_(face_count) {
        std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
    }

    void join(std::uint32_t a, std::uint32_t b) {
        a = first_face(a);
        b = first_face(b);
        if (a == b) return;
        parent_[std::max(a, b)] = std::min(a, b);
        --count_;
    }

    /// The first face of the part that holds `face`: what names the part.
    [[nodiscard]] std::uint32_t first_face(std::uint32_t face) {
        while (parent_[face] != face) face = parent_[face] = parent_[parent_[face]];
        return face;
    }

    [[nodiscard]] std::size_t count() const { return count_; }

private:
    std::vector<std::uint32_t> parent_;
    std::size_t count_;
};

/// Notes which meshes the faces of one edge leave open, crowd or wind two ways, and joins the faces of the others.
void check_solid(Topology& topology, std::span<const std::uint32_t> half_edges, Parts& parts) {
    const auto mesh_of = [&](std::uint32_t half_edge) { return topology.faces[half_edge / 3].mesh; };
    std::size_t begin = 0;
    while (begin < half_edges.size()) {  // faces, and with them half-edges, stand in the order of their meshes
        std::size_t end = begin + 1;
        while (end < half_edges.size() && mesh_of(half_edges[end]) == mesh_of(half_edges[begin])) ++end;
        const bool closed = end - begin == 2 && side_of(topology.faces, half_edges[begin]).forward() !=
                                                    side_of(topology.faces, half_edges[begin + 1]).forward();
        if (closed) {
            parts.join(half_edges[begin] / 3, half_edges[begin + 1] / 3);
        } else {
            topology.mesh_is_solid[mesh_of(half_edges[begin])] = false;
        }
        begin = end;
    }
}

void add_edges(Topology& topology, Parts& parts) {
    const std::vector<std::uint32_t> sorted = sorted_half_edges(topology);
    topology.edges.reserve(sorted.size() / 2 + 1);
    std::size_t begin = 0;
    while (begin < sorted.size()) {
        const Side side = side_of(topology.faces, sorted[begin]);
        std::size_t end = begin + 1;
        while (end < sorted.size()) {
            const Side other = side_of(topology.faces, sorted[end]);
            if (other.smaller() != side.smaller() || other.larger() != side.larger()) break;
            ++end;
        }
        Edge edge{{side.smaller(), side.larger()}};
        edge.faces[0] = sorted[begin] / 3;
        if (end - begin > 1) edge.faces[1] = sorted[begin + 1] / 3;
        if (end - begin > 2) topology.crowded_edges.push_back(static_cast<std::uint32_t>(topology.edges.size()));
        topology.edges.push_back(edge);
        check_solid(topology, std::span(sorted).subspan(begin, end - begin), parts);
        begin = end;
    }
}

/// Closed meshes of which one part is wound inside out, and another is not, are not solid: no rule about faces that
/// turn away serves both.
void check_parts(Topology& topology, Parts& parts) {
    const std::vector<Face>& faces = topology.faces;
    if (parts.count() <= 1) return;
    std::vector<double> volume(faces.size());  // of parts, six times over; stands at the part's first face
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        if (!topology.mesh_is_solid[faces[f].mesh]) continue;
        const std::uint32_t first = parts.first_face(f);
        const auto point = [&](std::uint32_t v) { return glm::dvec3(topology.positions[v]); };
        const glm::dvec3 apex = point(faces[first].vertices[0]);
        const auto& [a, b, c] = faces[f].vertices;
        volume[first] += glm::dot(point(a) - apex, glm::cross(point(b) - apex, point(c) - apex));
    }
    std::vector<std::array<bool, 2>> found(topology.mesh_is_solid.size(), {false, false});
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        if (volume[f] != 0) found[faces[f].mesh][volume[f] < 0 ? 1 : 0] = true;
    }
    for (std::size_t m = 0; m < found.size(); ++m) {
        if (found[m][0] && found[m][1]) topology.mesh_is_solid[m] = false;
    }
}

/// The sign of the volume, six times over, about the centre of the mesh's box: for an open mesh that is the best guess.
bool is_inverted(const Mesh& mesh) {
    Bounds bounds;
    for (const glm::vec3& p : mesh.positions) bounds.add(p);
    const glm::dvec3 centre = bounds.centre();
    double volume = 0;
    for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
        const glm::dvec3 a = glm::dvec3(mesh.positions[mesh.triangles[t]]) - centre;
        const glm::dvec3 b = glm::dvec3(mesh.positions[mesh.triangles[t + 1]]) - centre;
        const glm::dvec3 c = glm::dvec3(mesh.positions[mesh.triangles[t + 2]]) - centre;
        volume += glm::dot(a, glm::cross(b, c));
    }
    return volume < 0;
}

using PointNumbers = std::map<std::array<float, 3>, std::uint32_t>;

std::array<float, 3> as_key(const glm::vec3& p) { return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}; }  // no -0

/// Finds the edges between the ends that the author marked. Costs one look at each point and edge, if any is marked.
void tag_edges(Topology& topology, std::span<const TaggedEdge> tagged) {
    if (tagged.empty()) return;
    PointNumbers numbers;
    for (const TaggedEdge& edge : tagged) {
        for (const glm::vec3& end : edge) numbers.try_emplace(as_key(end), no_face);
    }
    for (std::uint32_t v = 0; v < topology.positions.size(); ++v) {
        const auto found = numbers.find(as_key(topology.positions[v]));
        if (found != numbers.end()) found->second = v;
    }
    std::set<std::pair<std::uint32_t, std::uint32_t>> wanted;
    for (const TaggedEdge& edge : tagged) {
        wanted.insert(std::minmax({numbers.at(as_key(edge[0])), numbers.at(as_key(edge[1]))}));
    }
    for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
        const auto& ends = topology.edges[e].vertices;
        if (wanted.contains({ends[0], ends[1]})) topology.tagged_edges.push_back(e);
    }
}

}  // namespace

Topology weld(std::span<const Mesh> meshes, std::span<const TaggedEdge> tagged) {
    std::vector<std::span<const glm::vec3>> lists;
    std::size_t triangles = 0;
    for (const Mesh& mesh : meshes) {
        lists.emplace_back(mesh.positions);
        triangles += mesh.triangle_count();
    }
    WeldedPoints welded = weld_points(lists);
    Topology topology;
    topology.positions = std::move(welded.positions);
    topology.faces.reserve(triangles);
    topology.face_normals.reserve(triangles);
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        const std::size_t faces_before = topology.faces.size();
        add_faces(topology, meshes[m], static_cast<std::uint32_t>(m),
                  std::span(welded.ids).subspan(welded.first_of_list[m], meshes[m].positions.size()));
        topology.mesh_is_solid.push_back(topology.faces.size() > faces_before);
        topology.mesh_is_inverted.push_back(is_inverted(meshes[m]));
    }
    Parts parts(topology.faces.size());
    add_edges(topology, parts);
    check_parts(topology, parts);
    tag_edges(topology, tagged);
    return topology;
}

std::size_t Topology::border_edge_count() const {
    return static_cast<std::size_t>(
        std::count_if(edges.begin(), edges.end(), [](const Edge& edge) { return edge.faces[1] == no_face; }));
}

}  // namespace croquis::model
