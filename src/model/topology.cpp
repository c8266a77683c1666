// Edges vertex by vertex: each vertex's faces name the edges from it to later vertices. Vertices do not depend on each
// other, so that pieces of them go to several threads and are put together in order.
#include "model/topology.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "base/error.h"
#include "base/parallel.h"
#include "model/model.h"
#include "model/sewing.h"
#include "model/solidity.h"
#include "model/welding.h"

namespace croquis::model {
namespace {

constexpr std::size_t faces_a_piece = 8192;
constexpr std::size_t vertices_a_piece = 4096;

/// Calls `body(piece, begin, end)` for [0, count) cut into pieces of a fixed size, on all cores.
template <typename Body>
void for_each_piece(std::size_t count, std::size_t size, const Body& body) {
    parallel_for((count + size - 1) / size, 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t piece = first; piece < last; ++piece)
            body(piece, piece * size, std::min(count, (piece + 1) * size));
    });
}

Bounds bounds_of(const std::vector<glm::vec3>& points) {
    std::vector<Bounds> pieces(points.size() / faces_a_piece + 1);
    for_each_piece(points.size(), faces_a_piece, [&](std::size_t piece, std::size_t begin, std::size_t end) {
        Bounds bounds;
        for (std::size_t i = begin; i < end; ++i) bounds.add(points[i]);
        pieces[piece] = bounds;
    });
    Bounds bounds;
    for (const Bounds& piece : pieces) {
        bounds.low = glm::min(bounds.low, piece.low);
        bounds.high = glm::max(bounds.high, piece.high);
    }
    return bounds;
}

/// What a piece of a mesh's triangles comes to.
struct FacePiece {
    std::size_t kept = 0;
    double volume = 0;  // six times over, about the centre of the mesh's box
};

/// Writes the faces of triangles [begin, end) of a mesh, those of no area left out, from `face` on.
FacePiece write_faces(const Mesh& mesh, std::uint32_t mesh_index, std::span<const std::uint32_t> ids, std::size_t begin,
                      std::size_t end, const glm::dvec3& centre, Face* face) {
    FacePiece piece;
    for (std::size_t t = begin; t < end; ++t) {
        const std::uint32_t* const corners = &mesh.triangles[3 * t];
        const glm::dvec3 a(mesh.positions[corners[0]]), b(mesh.positions[corners[1]]), c(mesh.positions[corners[2]]);
        if (!has_area(a, b, c)) continue;
        piece.volume += glm::dot(a - centre, area_vector(a, b, c));
        face[piece.kept++] = {{ids[corners[0]], ids[corners[1]], ids[corners[2]]}, mesh_index};
    }
    return piece;
}

/// Adds a mesh's faces. Returns six times its volume about the centre of its box: for an open mesh the best guess.
double add_faces(Topology& topology, const Mesh& mesh, std::uint32_t mesh_index, std::span<const std::uint32_t> ids) {
    const std::size_t first = topology.faces.size(), count = mesh.triangle_count();
    topology.faces.resize(first + count);
    const Bounds box = bounds_of(mesh.positions);
    const glm::dvec3 centre = 0.5 * (glm::dvec3(box.low) + glm::dvec3(box.high));
    std::vector<FacePiece> pieces(count / faces_a_piece + 1);
    for_each_piece(count, faces_a_piece, [&](std::size_t piece, std::size_t begin, std::size_t end) {
        pieces[piece] = write_faces(mesh, mesh_index, ids, begin, end, centre, &topology.faces[first + begin]);
    });
    std::size_t kept = first;
    double volume = 0;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        const auto written = topology.faces.begin() + static_cast<std::ptrdiff_t>(first + p * faces_a_piece);
        const auto target = topology.faces.begin() + static_cast<std::ptrdiff_t>(kept);
        if (target != written) std::copy_n(written, pieces[p].kept, target);
        kept += pieces[p].kept;
        volume += pieces[p].volume;
    }
    topology.faces.resize(kept);
    return volume;
}

void fill_stars(Topology& topology) {
    std::vector<std::uint32_t>& starts = topology.star_starts;
    starts.assign(topology.positions.size() + 2, 0);
    for (const Face& face : topology.faces) {
        for (const std::uint32_t v : face.vertices) ++starts[v + 2];
    }
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    topology.star_faces.resize(topology.faces.size() * 3);
    for (std::uint32_t f = 0; f < topology.faces.size(); ++f) {
        for (const std::uint32_t v : topology.faces[f].vertices) topology.star_faces[starts[v + 1]++] = f;
    }
    starts.pop_back();
}

/// A side of a face that leads from the vertex at hand to a later one, packed so that sides sort by that vertex and
/// then by face.
struct Side {
    std::uint64_t packed = 0;

    Side() = default;
    Side(std::uint32_t far_end, std::uint32_t face, bool backward)
        : packed(std::uint64_t{far_end} << 32 | face << 1 | (backward ? 1u : 0u)) {}

    [[nodiscard]] std::uint32_t far_end() const { return static_cast<std::uint32_t>(packed >> 32); }
    [[nodiscard]] std::uint32_t face() const { return static_cast<std::uint32_t>(packed) >> 1; }
    [[nodiscard]] bool backward() const { return (packed & 1) != 0; }
};

constexpr std::uint32_t most_faces = 0x7fffffffu;  // what a Side has room for

/// The edges that start at a piece of the vertices. Indices count from the piece's first edge.
struct EdgePiece {
    std::vector<Edge> edges;
    std::vector<std::uint32_t> crowded, twisted;
    std::vector<FacesAlike> alike_on_crowded;
};

/// Finds the edges from one vertex to later ones.
class EdgeCollector {
public:
    EdgeCollector(const Topology& topology, SolidMeshes& solid, EdgePiece& piece)
        : topology_(topology), solid_(solid), piece_(piece) {}

    void collect(std::uint32_t vertex) {
        gather_sides(vertex);
        std::size_t begin = 0;
        while (begin < sides_.size()) {
            std::size_t end = begin + 1;
            while (end < sides_.size() && sides_[end].far_end() == sides_[begin].far_end()) ++end;
            add_edge(vertex, std::span<const Side>(sides_).subspan(begin, end - begin));
            begin = end;
        }
    }

private:
    void gather_sides(std::uint32_t vertex) {
        const std::size_t begin = topology_.star_starts[vertex], end = topology_.star_starts[vertex + 1];
        sides_.resize(2 * (end - begin));
        std::size_t count = 0;  // no branches here: which vertex comes later is as random as can be
        for (std::size_t i = begin; i < end; ++i) {
            fetch_face(i + 32);
            const std::uint32_t f = topology_.star_faces[i];
            const auto& [a, b, c] = topology_.faces[f].vertices;
            const std::uint32_t next = a == vertex ? b : b == vertex ? c : a;
            const std::uint32_t previous = a == vertex ? c : b == vertex ? a : b;
            sides_[count] = Side(next, f, false);
            count += next > vertex ? 1 : 0;
            sides_[count] = Side(previous, f, true);
            count += previous > vertex ? 1 : 0;
        }
        sides_.resize(count);
        sort_sides();
    }

    /// Faces around a vertex lie anywhere: asked for some time before they are needed, they do not have to be waited
    /// for.
    void fetch_face(std::size_t star_index) const {
        if (star_index < topology_.star_faces.size())
            __builtin_prefetch(&topology_.faces[topology_.star_faces[star_index]]);
    }

    /// The few sides of a usual vertex go to their rank, without branches.
    void sort_sides() {
        const std::size_t count = sides_.size();
        if (count > most_ranked) {
            std::sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) { return a.packed < b.packed; });
            return;
        }
        for (std::size_t i = 0; i < count; ++i) {
            std::size_t rank = 0;
            for (std::size_t j = 0; j < count; ++j) rank += sides_[j].packed < sides_[i].packed ? 1 : 0;
            ranked_[rank] = sides_[i];
        }
        std::copy_n(ranked_.begin(), count, sides_.begin());
    }

    void add_edge(std::uint32_t vertex, std::span<const Side> sides) {
        const auto index = static_cast<std::uint32_t>(piece_.edges.size());
        Edge edge{{vertex, sides[0].far_end()}};
        edge.faces[0] = sides[0].face();
        if (sides.size() > 1) edge.faces[1] = sides[1].face();
        if (sides.size() > 2) piece_.crowded.push_back(index);
        if (sides.size() == 2 && sides[0].backward() == sides[1].backward()) piece_.twisted.push_back(index);
        piece_.edges.push_back(edge);
        check_order(sides);
    }

    /// Notes which meshes the faces of one edge leave open, crowd or wind two ways.
    void check_order(std::span<const Side> sides) {
        const auto mesh_of = [&](const Side& side) { return topology_.faces[side.face()].mesh; };
        std::size_t begin = 0;
        while (begin < sides.size()) {  // faces, and with them sides, stand in the order of their meshes
            const std::uint32_t mesh = mesh_of(sides[begin]);
            std::size_t end = begin + 1;
            while (end < sides.size() && mesh_of(sides[end]) == mesh) ++end;
            const bool alike = end - begin == 2 && sides[begin].backward() != sides[begin + 1].backward();
            if (!alike) solid_[mesh].store(false, std::memory_order_relaxed);
            if (alike && sides.size() > 2)
                piece_.alike_on_crowded.emplace_back(sides[begin].face(), sides[begin + 1].face());
            begin = end;
        }
    }

    static constexpr std::size_t most_ranked = 12;

    const Topology& topology_;
    SolidMeshes& solid_;
    EdgePiece& piece_;
    std::vector<Side> sides_;
    std::array<Side, most_ranked> ranked_;
};

std::vector<EdgePiece> collect_edges(const Topology& topology, SolidMeshes& solid) {
    const std::size_t count = topology.positions.size();
    std::vector<EdgePiece> pieces((count + vertices_a_piece - 1) / vertices_a_piece);
    for_each_piece(count, vertices_a_piece, [&](std::size_t piece, std::size_t begin, std::size_t end) {
        const std::size_t corners = topology.star_starts[end] - topology.star_starts[begin];
        pieces[piece].edges.reserve(corners / 2 + corners / 16);  // an edge has four corners, half of them elsewhere
        EdgeCollector collector(topology, solid, pieces[piece]);
        for (std::size_t v = begin; v < end; ++v) collector.collect(static_cast<std::uint32_t>(v));
    });
    return pieces;
}

void fill_edges(Topology& topology, SolidMeshes& solid) {
    std::vector<EdgePiece> pieces = collect_edges(topology, solid);
    std::vector<std::size_t> first(pieces.size() + 1, 0);
    for (std::size_t p = 0; p < pieces.size(); ++p) first[p + 1] = first[p] + pieces[p].edges.size();
    topology.edges.resize(first.back());
    parallel_for(pieces.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
            std::copy(pieces[p].edges.begin(), pieces[p].edges.end(),
                      topology.edges.begin() + static_cast<std::ptrdiff_t>(first[p]));
            pieces[p].edges = {};
        }
    });
    topology.crowded_edges.clear();
    topology.twisted_edges.clear();
    std::vector<FacesAlike> alike;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        const auto base = static_cast<std::uint32_t>(first[p]);
        for (const std::uint32_t e : pieces[p].crowded) topology.crowded_edges.push_back(base + e);
        for (const std::uint32_t e : pieces[p].twisted) topology.twisted_edges.push_back(base + e);
        alike.insert(alike.end(), pieces[p].alike_on_crowded.begin(), pieces[p].alike_on_crowded.end());
    }
    fill_solidity(topology, solid, alike);
}

void connect(Topology& topology, std::size_t mesh_count) {
    fill_stars(topology);
    SolidMeshes in_order(mesh_count);
    for (std::atomic<bool>& mesh : in_order) mesh = true;
    fill_edges(topology, in_order);
}

bool is_closed(const Topology& topology) {
    return std::none_of(topology.edges.begin(), topology.edges.end(),
                        [](const Edge& edge) { return edge.faces[1] == no_face; });
}

/// Joins the vertices of seams. False where there are none.
bool sew(Topology& topology) {
    topology.sewn = sewn_vertices(topology);
    if (topology.sewn.empty()) return false;
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < topology.sewn.size(); ++v) {
        if (topology.sewn[v] == count) topology.positions[count++] = topology.positions[v];
    }
    topology.positions.resize(count);
    for (Face& face : topology.faces) {
        for (std::uint32_t& v : face.vertices) v = topology.sewn[v];
    }
    return true;
}

/// Finds the edges between the ends that the author marked, whose welded vertices `ends` holds in pairs.
void tag_edges(Topology& topology, std::span<const std::uint32_t> ends) {
    const auto before = [](const Edge& a, const Edge& b) { return a.vertices < b.vertices; };
    std::vector<std::uint32_t>& tagged = topology.tagged_edges;
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
        const Edge wanted{{std::min(ends[i], ends[i + 1]), std::max(ends[i], ends[i + 1])}};
        const auto found = std::lower_bound(topology.edges.begin(), topology.edges.end(), wanted, before);
        if (found == topology.edges.end() || found->vertices != wanted.vertices) continue;
        tagged.push_back(static_cast<std::uint32_t>(found - topology.edges.begin()));
    }
    std::sort(tagged.begin(), tagged.end());
    tagged.erase(std::unique(tagged.begin(), tagged.end()), tagged.end());
}

/// Fills positions, faces and `mesh_is_inverted`. Returns the welded vertices of the tagged edges' ends, in pairs;
/// those that are no vertex of a mesh have numbers past the last.
std::vector<std::uint32_t> fill_faces(Topology& topology, std::span<const Mesh> meshes,
                                      std::span<const glm::vec3> tagged_ends) {
    std::vector<std::span<const glm::vec3>> lists;
    std::size_t triangles = 0;
    for (const Mesh& mesh : meshes) {
        lists.emplace_back(mesh.positions);
        triangles += mesh.triangle_count();
    }
    if (triangles > most_faces) fail("expected at most {} triangles, found {}", most_faces, triangles);
    lists.push_back(tagged_ends);
    WeldedPoints welded = weld_points(lists);
    const auto tagged_ids = welded.ids.end() - static_cast<std::ptrdiff_t>(tagged_ends.size());
    topology.positions = std::move(welded.positions);
    if (!tagged_ends.empty()) topology.positions.resize(*std::max_element(welded.ids.begin(), tagged_ids) + 1);
    topology.faces.reserve(triangles);
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        const auto ids = std::span(welded.ids).subspan(welded.first_of_list[m], meshes[m].positions.size());
        const double volume = add_faces(topology, meshes[m], static_cast<std::uint32_t>(m), ids);
        topology.mesh_is_inverted.push_back(volume < 0);
    }
    return {tagged_ids, welded.ids.end()};
}

}  // namespace

Topology weld(std::span<const Mesh> meshes, std::span<const TaggedEdge> tagged) {
    std::vector<glm::vec3> tagged_ends;
    for (const TaggedEdge& edge : tagged) tagged_ends.insert(tagged_ends.end(), edge.begin(), edge.end());
    Topology topology;
    std::vector<std::uint32_t> tagged_ids = fill_faces(topology, meshes, tagged_ends);
    connect(topology, meshes.size());
    if (!is_closed(topology) && sew(topology)) {
        connect(topology, meshes.size());
        for (std::uint32_t& v : tagged_ids) v = v < topology.sewn.size() ? topology.sewn[v] : no_face;
    }
    tag_edges(topology, tagged_ids);
    return topology;
}

std::size_t Topology::border_edge_count() const {
    return static_cast<std::size_t>(
        std::count_if(edges.begin(), edges.end(), [](const Edge& edge) { return edge.faces[1] == no_face; }));
}

}  // namespace croquis::model
