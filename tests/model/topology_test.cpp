// Edges, faces and vertices against numbers counted by hand and Euler's relation.
#include "model/topology.h"

#include <map>
#include <utility>

#include "base/random.h"
#include "fixtures.h"

namespace croquis::model::testing {
namespace {

long euler_number(const Topology& topology) {
    return long(topology.positions.size()) - long(topology.edges.size()) + long(topology.faces.size());
}

TEST(Topology, CubeHasEightVerticesEighteenEdgesTwelveFaces) {
    const auto model = load_text("cube.obj", cube());
    const Topology& topology = model->topology();
    EXPECT_EQ(topology.positions.size(), 8u);
    EXPECT_EQ(topology.edges.size(), 18u);  // 12 sides and a diagonal of each of 6 squares
    EXPECT_EQ(topology.faces.size(), 12u);
    EXPECT_EQ(topology.border_edge_count(), 0u);
    EXPECT_TRUE(topology.crowded_edges.empty());
    EXPECT_TRUE(topology.mesh_is_solid[0]);
    EXPECT_FALSE(topology.mesh_is_inverted[0]);
}

TEST(Topology, EachEdgeStandsOnceWithTheFacesThatHoldIt) {
    const auto model =
        load_text("tetrahedron.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
    const Topology& topology = model->topology();
    ASSERT_EQ(topology.edges.size(), 6u);
    for (const Edge& edge : topology.edges) {
        EXPECT_LT(edge.vertices[0], edge.vertices[1]);
        EXPECT_LT(edge.faces[0], edge.faces[1]);
        for (const std::uint32_t face : edge.faces) {
            for (const std::uint32_t vertex : edge.vertices) {
                const auto& corners = topology.faces[face].vertices;
                EXPECT_NE(std::find(corners.begin(), corners.end(), vertex), corners.end());
            }
        }
    }
}

TEST(Topology, EulersRelationHoldsOnClosedModels) {
    struct Case {
        const char* name;
        std::string text;
        long euler_number;
    };
    std::string torus;
    for (int i = 0; i < 12; ++i) {
        for (int j = 0; j < 7; ++j) {
            const double u = i * 6.283185307179586 / 12, v = j * 6.283185307179586 / 7;
            torus += fmt::format("v {} {} {}\n", (2 + std::cos(v)) * std::cos(u), std::sin(v),
                                 (2 + std::cos(v)) * std::sin(u));
        }
    }
    for (int i = 0; i < 12; ++i) {
        for (int j = 0; j < 7; ++j) {
            const auto at = [](int a, int b) { return 1 + a % 12 * 7 + b % 7; };
            torus += fmt::format("f {} {} {} {}\n", at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
        }
    }
    for (const Case& c : {Case{"sphere.obj", sphere(10, 15, 1), 2}, Case{"torus.obj", torus, 0}}) {
        const auto model = load_text(c.name, c.text);
        EXPECT_EQ(euler_number(model->topology()), c.euler_number) << c.name;
        EXPECT_EQ(model->topology().border_edge_count(), 0u) << c.name;
        EXPECT_TRUE(model->topology().mesh_is_solid[0]) << c.name;
        EXPECT_FALSE(model->topology().mesh_is_inverted[0]) << c.name;
    }
}

TEST(Topology, OpenSurfacesHaveBordersAndAreNotSolid) {
    const auto model =
        load_text("open.obj", std::string(cube_points) + "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\n");
    EXPECT_EQ(model->topology().border_edge_count(), 4u);
    EXPECT_FALSE(model->topology().mesh_is_solid[0]);
}

TEST(Topology, AMeshWoundTwoWaysIsNotSolidAndOneInsideOutIsInverted) {
    const auto mixed = load_text(
        "mixed.obj", std::string(cube_points) + "f 1 2 3 4\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    EXPECT_FALSE(mixed->topology().mesh_is_solid[0]);
    const auto turned = load_text(
        "turned.obj", std::string(cube_points) + "f 1 2 3 4\nf 8 7 6 5\nf 5 6 2 1\nf 6 7 3 2\nf 7 8 4 3\nf 8 5 1 4\n");
    EXPECT_TRUE(turned->topology().mesh_is_solid[0]);
    EXPECT_TRUE(turned->topology().mesh_is_inverted[0]);
}

/// Six quads between points `first` to `first + 7`, placed as in `cube_points`.
std::string faces_of_cube(int first, bool inside_out) {
    std::string text;
    for (const auto& [a, b, c, d] : {std::array{3, 2, 1, 0}, std::array{4, 5, 6, 7}, std::array{0, 1, 5, 4},
                                     std::array{1, 2, 6, 5}, std::array{2, 3, 7, 6}, std::array{3, 0, 4, 7}}) {
        const std::array<int, 4> corners = inside_out ? std::array{d, c, b, a} : std::array{a, b, c, d};
        text += fmt::format("f {} {} {} {}\n", first + corners[0], first + corners[1], first + corners[2],
                            first + corners[3]);
    }
    return text;
}

std::string points_of_cube(double low, double high) {
    std::string text;
    for (const double z : {low, high}) {
        text += fmt::format("v {0} {0} {2}\nv {1} {0} {2}\nv {1} {1} {2}\nv {0} {1} {2}\n", low, high, z);
    }
    return text;
}

TEST(Topology, AMeshOfPartsIsSolidWhenAllAreWoundAlike) {
    struct Case {
        const char* name;
        double low, high;  // of the second cube
        bool first_inside_out, second_inside_out;
        bool is_solid;
    };
    for (const Case& c :
         {Case{"apart", 2, 3, false, false, true}, Case{"apart, second inside out", 2, 3, false, true, false},
          Case{"apart, first inside out", 2, 3, true, false, false},
          Case{"apart, both inside out", 2, 3, true, true, true},
          Case{"tiny and far, inside out", 1000, 1000.001, false, true, false},
          Case{"touching at a corner", 1, 2, false, false, true},
          Case{"touching at a corner, inside out", 1, 2, false, true, false},
          Case{"one inside the other", 0.25, 0.75, false, false, true},
          Case{"a hollow box", 0.25, 0.75, false, true, false}}) {
        const auto model =
            load_text("parts.obj", points_of_cube(0, 1) + points_of_cube(c.low, c.high) +
                                       faces_of_cube(1, c.first_inside_out) + faces_of_cube(9, c.second_inside_out));
        ASSERT_EQ(model->meshes.size(), 1u) << c.name;
        EXPECT_EQ(model->topology().border_edge_count(), 0u) << c.name;
        EXPECT_EQ(model->topology().mesh_is_solid[0], c.is_solid) << c.name;
        EXPECT_EQ(model->topology().mesh_is_inverted[0], c.first_inside_out && c.second_inside_out) << c.name;
    }
}

TEST(Topology, PartsOfOtherMeshesDoNotCount) {
    const auto model = load_text("two.obj", points_of_cube(0, 1) + points_of_cube(1, 2) + "o one\n" +
                                                faces_of_cube(1, false) + "o two\n" + faces_of_cube(9, true));
    ASSERT_EQ(model->meshes.size(), 2u);
    for (std::size_t m = 0; m < 2; ++m) {
        EXPECT_TRUE(model->topology().mesh_is_solid[m]);
        EXPECT_EQ(model->topology().mesh_is_inverted[m], m == 1);
    }
}

TEST(Topology, ThreeFacesOnAnEdgeAreCrowded) {
    const auto model =
        load_text("fin.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 2 5\n");
    const Topology& topology = model->topology();
    ASSERT_EQ(topology.crowded_edges.size(), 1u);
    EXPECT_EQ(topology.edges.size(), 7u);
    EXPECT_EQ(topology.edges[topology.crowded_edges[0]].faces, (std::array<std::uint32_t, 2>{0, 1}));
}

/// What a model's edges are, found the slow way.
struct EdgesByName {
    struct Sides {
        std::vector<std::uint32_t> faces;
        std::vector<bool> forward;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, Sides> sides;
    std::vector<std::vector<std::uint32_t>> stars;

    explicit EdgesByName(const Topology& topology) : stars(topology.positions.size()) {
        for (std::uint32_t f = 0; f < topology.faces.size(); ++f) {
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = topology.faces[f].vertices[k], b = topology.faces[f].vertices[(k + 1) % 3];
                Sides& edge = sides[{std::min(a, b), std::max(a, b)}];
                edge.faces.push_back(f);
                edge.forward.push_back(a < b);
                stars[a].push_back(f);
            }
        }
    }
};

TEST(Topology, EdgesOfAnySoupAreThoseThatItsFacesName) {
    const Random random(7, "soup");
    std::uint64_t drawn = 0;
    const auto below = [&](int count) {
        return static_cast<std::uint32_t>(random.bits(drawn++) % static_cast<std::uint64_t>(count));
    };
    for (const auto& [points, triangles, meshes] : {std::array{12, 80, 1}, std::array{9000, 12000, 3}}) {
        std::vector<Mesh> soup(static_cast<std::size_t>(meshes));
        for (Mesh& mesh : soup) {
            for (std::size_t v = 0; v < static_cast<std::size_t>(points); ++v)
                mesh.positions.emplace_back(v, v * v % 97, v * v % 101);
            for (int t = 0; t < triangles; ++t) {  // neighbours in space, so that edges are shared by 1 to many faces
                const std::uint32_t base = below(points - 6);
                for (int k = 0; k < 3; ++k) mesh.triangles.push_back(base + below(6));
            }
        }
        const Topology topology = weld(soup);
        const EdgesByName wanted(topology);
        ASSERT_EQ(topology.edges.size(), wanted.sides.size());
        std::vector<std::uint32_t> crowded, twisted;
        std::uint32_t e = 0;
        for (const auto& [ends, sides] : wanted.sides) {
            const Edge& edge = topology.edges[e];
            ASSERT_EQ(edge.vertices, (std::array{ends.first, ends.second}));
            ASSERT_EQ(edge.faces[0], sides.faces[0]);
            ASSERT_EQ(edge.faces[1], sides.faces.size() > 1 ? sides.faces[1] : no_face);
            if (sides.faces.size() > 2) crowded.push_back(e);
            if (sides.faces.size() == 2 && sides.forward[0] == sides.forward[1]) twisted.push_back(e);
            ++e;
        }
        EXPECT_EQ(topology.crowded_edges, crowded);
        EXPECT_EQ(topology.twisted_edges, twisted);
        for (std::uint32_t v = 0; v < topology.positions.size(); ++v) {
            const auto star = topology.faces_around(v);
            ASSERT_TRUE(std::equal(star.begin(), star.end(), wanted.stars[v].begin(), wanted.stars[v].end()));
        }
        EXPECT_FALSE(crowded.empty());
        EXPECT_FALSE(twisted.empty());
    }
}

// Large enough for several threads: 2 x 39,600 faces.
TEST(Topology, LargeBodiesAreSolidWhenAllPartsAreWoundAlike) {
    for (const bool inside_out : {false, true}) {
        Mesh both = load_text("sphere.obj", sphere(100, 200, 1))->meshes[0];
        const std::size_t count = both.positions.size(), corners = both.triangles.size();
        for (std::size_t v = 0; v < count; ++v) both.positions.push_back(both.positions[v] * 0.5f);
        for (std::size_t t = 0; t < corners; ++t) {
            const std::size_t from = inside_out ? corners - 1 - t : t;
            both.triangles.push_back(both.triangles[from] + static_cast<std::uint32_t>(count));
        }
        const Topology topology = weld(std::span(&both, 1));
        EXPECT_EQ(topology.faces.size(), 2u * 39600u);
        EXPECT_EQ(euler_number(topology), 4);
        EXPECT_EQ(topology.mesh_is_solid[0], !inside_out);
        EXPECT_FALSE(topology.mesh_is_inverted[0]);
    }
}

TEST(Topology, BodiesThatShareAnEdgeAreSolidEach) {
    // Two boxes of different meshes that touch along an edge: four faces there. The second is inside out.
    const auto model = load_text("touching.obj",
                                 std::string(cube_points) +
                                     "v 1 1 0\nv 2 1 0\nv 2 2 0\nv 1 2 0\nv 1 1 1\nv 2 1 1\nv 2 2 1\nv 1 2 1\no one\n" +
                                     faces_of_cube(1, false) + "o two\n" + faces_of_cube(9, true));
    EXPECT_EQ(model->topology().crowded_edges.size(), 1u);
    for (std::size_t m = 0; m < 2; ++m) {
        EXPECT_TRUE(model->topology().mesh_is_solid[m]);
        EXPECT_EQ(model->topology().mesh_is_inverted[m], m == 1);
    }
}

TEST(Topology, FacesOfNoAreaAreGoneWhereverTheyStand) {
    Mesh mesh = load_text("sphere.obj", sphere(60, 200, 1))->meshes[0];
    std::vector<std::uint32_t> triangles;
    std::size_t flat = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
        for (std::size_t k = 0; k < 3; ++k) triangles.push_back(mesh.triangles[t + k]);
        if (t % 7 != 0) continue;
        for (const std::size_t k : {0u, 1u, 0u}) triangles.push_back(mesh.triangles[t + k]);
        ++flat;
    }
    const Topology wanted = weld(std::span(&mesh, 1));
    mesh.triangles = triangles;
    const Topology topology = weld(std::span(&mesh, 1));
    EXPECT_GT(flat, 1000u);
    ASSERT_EQ(topology.faces.size(), wanted.faces.size());
    for (std::size_t f = 0; f < wanted.faces.size(); ++f)
        ASSERT_EQ(topology.faces[f].vertices, wanted.faces[f].vertices);
    EXPECT_TRUE(topology.mesh_is_solid[0]);
}

TEST(Topology, TaggedEdgesThatAreNoneArePassedOver) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    mesh.triangles = {0, 1, 2, 1, 3, 2};
    const std::vector<TaggedEdge> tagged{{glm::vec3(0, 1, 0), glm::vec3(1, 0, 0)},
                                         {glm::vec3(0, 0, 0), glm::vec3(1, 1, 0)},
                                         {glm::vec3(5, 5, 5), glm::vec3(0, 0, 0)},
                                         {glm::vec3(1, 0, 0), glm::vec3(0, 1, -0.0f)},
                                         {glm::vec3(0, 0, 0), glm::vec3(0, 0, 0)}};
    const Topology topology = weld(std::span(&mesh, 1), tagged);
    EXPECT_EQ(topology.positions.size(), 4u);
    ASSERT_EQ(topology.tagged_edges.size(), 1u);
    EXPECT_EQ(topology.edges[topology.tagged_edges[0]].faces, (std::array<std::uint32_t, 2>{0, 1}));
}

TEST(Topology, WeldsRepeatedVerticesAndNegativeZero) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0f, 0, -0.0f}, {0, 1, 0}, {-1, 0, 0}};
    mesh.triangles = {0, 1, 2, 3, 4, 5};
    const Topology topology = weld(std::span(&mesh, 1));
    EXPECT_EQ(topology.positions.size(), 4u);
    EXPECT_EQ(topology.edges.size(), 5u);
    EXPECT_EQ(topology.border_edge_count(), 4u);
}

TEST(Topology, SolidityIsToldForEachMesh) {
    const auto model = load_text("two.obj", "o closed\n" + cube() + "o open\nv 9 0 0\nv 9 1 0\nv 9 0 1\nf 9 10 11\n");
    ASSERT_EQ(model->meshes.size(), 2u);
    EXPECT_TRUE(model->topology().mesh_is_solid[0]);
    EXPECT_FALSE(model->topology().mesh_is_solid[1]);
}

}  // namespace
}  // namespace croquis::model::testing
