// Seams that differ in their last digits: what is sewn, and above all what is not.
#include "model/sewing.h"

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "fixtures.h"
#include "model/posed_shape.h"
#include "model/subdivision.h"

namespace croquis::model::testing {
namespace {

long euler_number(const Topology& topology) {
    return long(topology.positions.size()) - long(topology.edges.size()) + long(topology.faces.size());
}

/// The sphere of unit radius cut into as many meshes as it has rows, each of whose points are moved at random by up to
/// `noise` along each axis.
std::vector<Mesh> sphere_in_bands(int rows, int columns, double noise) {
    const Mesh whole = load_text("sphere.obj", sphere(rows, columns, 1))->meshes[0];
    std::vector<Mesh> bands(static_cast<std::size_t>(rows));
    const Random random(3, "bands");
    std::uint64_t drawn = 0;
    for (Mesh& band : bands) {
        for (const glm::vec3& p : whole.positions) {
            glm::dvec3 moved(p);
            for (int axis = 0; axis < 3; ++axis) moved[axis] += random.between(-noise, noise, drawn++);
            band.positions.emplace_back(moved);
        }
    }
    for (std::size_t t = 0; t < whole.triangles.size(); t += 3) {
        double height = 0;
        for (std::size_t k = 0; k < 3; ++k) height += whole.positions[whole.triangles[t + k]].y / 3.0;
        const double row = std::acos(height) / 3.14159265358979 * rows;
        Mesh& band = bands[std::min(bands.size() - 1, static_cast<std::size_t>(row))];
        for (std::size_t k = 0; k < 3; ++k) band.triangles.push_back(whole.triangles[t + k]);
    }
    return bands;
}

std::shared_ptr<const Model> model_of(const std::vector<Mesh>& meshes, std::vector<TaggedEdge> tagged = {}) {
    RawModel raw;
    for (const Mesh& mesh : meshes) raw.meshes.push_back({mesh, {}});
    raw.tagged_edges = std::move(tagged);
    return finish(std::move(raw), "sewn");
}

TEST(Sewing, SeamsThatDifferInTheLastDigitsClose) {
    const int rows = 12, columns = 20;
    for (const double noise : {0.0, 1e-7, 5e-7}) {
        const auto model = model_of(sphere_in_bands(rows, columns, noise));
        const Topology& topology = model->topology();
        EXPECT_EQ(topology.positions.size(), 2u + 11u * 20u) << noise;
        EXPECT_EQ(topology.border_edge_count(), 0u) << noise;
        EXPECT_TRUE(topology.crowded_edges.empty() && topology.twisted_edges.empty()) << noise;
        EXPECT_EQ(euler_number(topology), 2) << noise;
        EXPECT_EQ(topology.sewn.empty(), noise == 0) << noise;
    }
}

TEST(Sewing, GapsStayOpen) {
    const auto open = model_of(sphere_in_bands(12, 20, 1e-4));
    EXPECT_TRUE(open->topology().sewn.empty());
    EXPECT_EQ(open->topology().border_edge_count(), 11u * 20u * 2u);
}

TEST(Sewing, DoesNotDependOnOrder) {
    std::vector<Mesh> bands = sphere_in_bands(12, 20, 1.5e-6);  // half of the seam: some edges close, others do not
    const auto counts = [](const Topology& topology) {
        return std::array{topology.positions.size(), topology.edges.size(), topology.border_edge_count()};
    };
    const auto wanted = counts(model_of(bands)->topology());
    EXPECT_GT(wanted[2], 0u);
    EXPECT_LT(wanted[2], 11u * 20u * 2u);
    std::reverse(bands.begin(), bands.end());
    EXPECT_EQ(counts(model_of(bands)->topology()), wanted);
    for (Mesh& band : bands) {
        std::reverse(band.triangles.begin(), band.triangles.end());
        for (std::size_t t = 0; t < band.triangles.size(); t += 3) std::swap(band.triangles[t], band.triangles[t + 1]);
    }
    EXPECT_EQ(counts(model_of(bands)->topology()), wanted);
}

/// Two triangles beside the edge from the origin to (1, 0, 0): below it, and above it, `gap` away.
std::string two_sheets(double gap, const char* second_face) {
    return fmt::format("v 0 0 0\nv 1 0 0\nv 0.5 -1 0\nv 0 {0} 0\nv 1 {0} 0\nv 0.5 1 0\nf 2 1 3\n{1}", gap, second_face);
}

TEST(Sewing, OnlyBordersThatAreWoundAlikeAndHaveOnePartnerAreSewn) {
    struct Case {
        const char* name;
        std::string text;
        std::size_t border_edges;
    };
    for (const Case& c :
         {Case{"wound alike", two_sheets(1e-7, "f 4 5 6\n"), 4},
          Case{"wound two ways", two_sheets(1e-7, "f 5 4 6\n"), 6}, Case{"too far", two_sheets(1e-5, "f 4 5 6\n"), 6},
          Case{"three sheets", two_sheets(1e-7, "f 4 5 6\n") + "v 0 0 1e-7\nv 1 0 1e-7\nv 0.5 0 1\nf 7 8 9\n", 9}}) {
        EXPECT_EQ(load_text("sheets.obj", c.text)->topology().border_edge_count(), c.border_edges) << c.name;
    }
}

TEST(Sewing, ClosedBodiesAndTinyFacesStayAsTheyAre) {
    // Two cubes a hair apart.
    const std::string faces = "f 12 11 10 9\nf 13 14 15 16\nf 9 10 14 13\nf 10 11 15 14\nf 11 12 16 15\nf 12 9 13 16\n";
    std::string text = cube();
    for (const double z : {0.0, 1.0}) {
        for (const auto& [x, y] : {std::array{0, 0}, std::array{1, 0}, std::array{1, 1}, std::array{0, 1}})
            text += fmt::format("v {:.9g} {} {}\n", x + 1.0000002, y, z);
    }
    const auto cubes = load_text("cubes.obj", text + faces);
    EXPECT_EQ(cubes->topology().positions.size(), 16u);
    EXPECT_TRUE(cubes->topology().mesh_is_solid[0]);

    // A strip of 200 triangles, smaller each than the width of a seam, beside one that makes the box large.
    std::string strip = "v 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\n";
    for (int i = 0; i < 101; ++i) strip += fmt::format("v {0} 1e-6 1e-3\nv {0} 2e-6 1e-3\n", i * 1e-6);
    for (int i = 0; i < 100; ++i) {
        const int a = 4 + 2 * i;
        strip += fmt::format("f {} {} {}\nf {} {} {}\n", a, a + 2, a + 1, a + 2, a + 3, a + 1);
    }
    const auto tiny = load_text("strip.obj", strip);
    EXPECT_EQ(tiny->topology().positions.size(), 3u + 202u);
    EXPECT_TRUE(tiny->topology().sewn.empty());
}

TEST(Sewing, PosesTagsAndSubdivisionFollow) {
    const std::vector<Mesh> bands = sphere_in_bands(12, 20, 3e-7);
    std::vector<glm::vec3> equator;  // ends of an edge where two bands meet
    for (std::size_t t = 0; equator.size() < 2; t += 3) {
        equator.clear();
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3 p = bands[6].positions[bands[6].triangles.at(t + k)];
            if (std::abs(p.y) < 1e-3f) equator.push_back(p);
        }
    }
    ASSERT_EQ(equator.size(), 2u);
    const auto model = model_of(bands, {{equator[0], equator[1]}});
    const Topology& topology = model->topology();
    ASSERT_FALSE(topology.sewn.empty());
    EXPECT_EQ(topology.tagged_edges.size(), 1u);

    Pose pose;
    for (const Mesh& mesh : model->meshes) {
        pose.push_back({mesh.positions, mesh.normals});
        for (glm::vec3& p : pose.back().positions) p += glm::vec3(3, 0, 0);
    }
    const PosedShape posed = posed_shape(*model, &pose);
    ASSERT_EQ(posed.positions.size(), topology.positions.size());
    for (std::size_t v = 0; v < posed.positions.size(); ++v)
        EXPECT_LT(glm::distance(posed.positions[v], topology.positions[v] + glm::vec3(3, 0, 0)), 3e-6f);

    const auto smooth = subdivide(*model, SubdivisionScheme::loop, 2);
    EXPECT_EQ(euler_number(smooth->topology()), 2);
    EXPECT_EQ(smooth->topology().border_edge_count(), 0u);
    EXPECT_TRUE(smooth->topology().sewn.empty()) << "its seams are exact";
    EXPECT_EQ(smooth->topology().tagged_edges.size(), 4u);
}

}  // namespace
}  // namespace croquis::model::testing
