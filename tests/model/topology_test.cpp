// Edges, faces and vertices against numbers counted by hand and Euler's relation.
#include "model/topology.h"

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
