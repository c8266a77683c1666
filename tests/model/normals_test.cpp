// Normals against the analytic sphere and cube, at all sizes.
#include <cstdio>
#include <utility>

#include "fixtures.h"
#include "model/posed_shape.h"

namespace croquis::model::testing {
namespace {

/// The largest angle between a vertex's normal and the direction from the centre, in degrees.
double worst_angle(const Model& model) {
    double worst = 0;
    for (const Mesh& mesh : model.meshes) {
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const glm::dvec3 wanted = glm::normalize(glm::dvec3(mesh.positions[v]) + model.origin);
            worst = std::max(worst, glm::length(glm::dvec3(mesh.normals[v]) - wanted));
        }
    }
    return worst * 180 / 3.14159265;
}

TEST(Normals, SphereOfAnySizePointsOutwards) {
    for (const double radius : {1e-6, 1.0, 1e6}) {
        const auto model = load_text("sphere.obj", sphere(40, 60, radius));
        EXPECT_LT(worst_angle(*model), 0.5) << radius;
        EXPECT_EQ(model->vertex_count(), 2u + 39u * 60u) << radius;
    }
}

TEST(Normals, SphereWhoseVerticesAreRepeatedIsSmoothToo) {
    // An STL file holds each triangle for itself.
    const auto source = load_text("sphere.obj", sphere(20, 30, 1));
    std::string stl = "solid sphere\n", ply = "ply\nformat ascii 1.0\n";
    std::string points, faces;
    const Mesh& mesh = source->meshes[0];
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
        stl += "facet normal 0 0 0\nouter loop\n";
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3& p = mesh.positions[mesh.triangles[t + k]];
            stl += fmt::format("vertex {} {} {}\n", p.x, p.y, p.z);
            points += fmt::format("{} {} {}\n", p.x, p.y, p.z);
        }
        stl += "endloop\nendfacet\n";
        faces += fmt::format("3 {} {} {}\n", t, t + 1, t + 2);
    }
    stl += "endsolid sphere\n";
    ply +=
        fmt::format("element vertex {}\nproperty float x\nproperty float y\nproperty float z\n", mesh.triangles.size());
    ply += fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n", mesh.triangle_count());
    for (const auto& model : {load_text("sphere.stl", stl), load_text("sphere.ply", ply + points + faces)}) {
        EXPECT_EQ(model->triangle_count(), mesh.triangle_count()) << model->name;
        EXPECT_EQ(model->vertex_count(), mesh.positions.size()) << model->name;
        EXPECT_LT(worst_angle(*model), 1.5) << model->name;
    }
}

TEST(Normals, CubeHasCreasesUnlessTheAngleIsWide) {
    const auto creased = load_text("cube.obj", cube());
    EXPECT_EQ(creased->vertex_count(), 24u);
    for (const glm::vec3& normal : creased->meshes[0].normals) {
        EXPECT_FLOAT_EQ(std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z), 1.0f);
    }
    LoadOptions wide;
    wide.crease_angle = 1.6f;  // more than a right angle
    const auto smooth = load_text("cube.obj", cube(), wide);
    EXPECT_EQ(smooth->vertex_count(), 8u);
    for (std::size_t v = 0; v < 8; ++v) {  // weighted by angle, the two triangles of a square count as one
        const glm::vec3 wanted = glm::normalize(smooth->meshes[0].positions[v] - glm::vec3(0.5f));
        EXPECT_LT(glm::length(smooth->meshes[0].normals[v] - wanted), 1e-6f);
    }
}

TEST(Normals, SmoothingGroupsOverruleTheCreaseAngle) {
    EXPECT_EQ(load_text("cube.obj", std::string(cube_points) + "s 1\n" + std::string(cube_faces))->vertex_count(), 8u);
    EXPECT_EQ(load_text("cube.obj", std::string(cube_points) + "s off\n" + std::string(cube_faces))->vertex_count(),
              24u);
    const auto pair = load_text("pair.obj", std::string(cube_points) + "s 1\nf 4 3 2 1\nf 1 2 6 5\ns 2\nf 2 3 7 6\n");
    EXPECT_EQ(pair->vertex_count(), 6u + 4u);  // two smooth squares, and one apart
    const auto flat = load_text("flat.obj", "s 0\n" + sphere(8, 8, 1));
    EXPECT_EQ(flat->vertex_count(), 16u * 3u + 48u * 4u);
}

TEST(Normals, SmoothAcrossMaterials) {
    const std::string text = sphere(20, 20, 1);
    const std::size_t middle = text.find("\nf", text.find("\nf") + 500) + 1;
    const auto model = load_text("two.obj", text.substr(0, middle) + "usemtl other\n" + text.substr(middle));
    ASSERT_EQ(model->meshes.size(), 2u);
    EXPECT_LT(worst_angle(*model), 1.5);
}

TEST(Normals, GivenOnesAreKeptAndMadeUnit) {
    const auto model = load_text("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 5\nvn 0 3 4\nf 1//1 2//1 3//2\n");
    ASSERT_EQ(model->vertex_count(), 3u);
    EXPECT_EQ(model->meshes[0].normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(model->meshes[0].normals[2], glm::vec3(0, 0.6f, 0.8f));
}

TEST(Normals, MissingOnesAreComputed) {
    const auto model = load_text("zero.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nvn nan 0 0\nf 1//1 2//2 3\n");
    for (const glm::vec3& normal : model->meshes[0].normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
}

TEST(Normals, FacesAreTurnedToAgreeWithGivenNormals) {
    const auto model = load_text("turned.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 -1\nf 1//1 2//1 3//1\n");
    EXPECT_EQ(posed_shape(*model, nullptr).face_normals[0], glm::vec3(0, 0, -1));
    EXPECT_EQ(model->meshes[0].normals[0], glm::vec3(0, 0, -1));
}

TEST(Normals, FacesThatAreWoundAlikeAreTurnedTogether) {
    // A cube all of whose sides have the normals of a ball: wound outwards, inwards, and half and half.
    std::string normals;
    for (int v = 0; v < 8; ++v)
        normals += fmt::format("vn {} {} {}\n", (v + 1) / 2 % 2 * 2 - 1, v / 2 % 2 * 2 - 1, v / 4 * 2 - 1);
    const std::string outwards[] = {"4 3 2 1", "5 6 7 8", "1 2 6 5", "2 3 7 6", "3 4 8 7", "4 1 5 8"};
    for (const int turned : {0, 2, 6}) {
        std::string text = std::string(cube_points) + normals;
        for (int side = 0; side < 6; ++side) {
            int a, b, c, d;
            std::sscanf(outwards[side].c_str(), "%d %d %d %d", &a, &b, &c, &d);
            if (side < turned) std::swap(a, d), std::swap(b, c);
            text += fmt::format("f {0}//{0} {1}//{1} {2}//{2} {3}//{3}\n", a, b, c, d);
        }
        const auto model = load_text("ball.obj", text);
        EXPECT_TRUE(model->topology().mesh_is_solid[0]) << turned;
        EXPECT_FALSE(model->topology().mesh_is_inverted[0]) << turned;
    }
    // The same with one corner's normal turned inside: the faces there disagree with it, but not their neighbours.
    const std::string dented = std::string(cube_points) + normals + "vn 9 9 9\n" +
                               "f 4 3 2 1\nf 5//9 6//6 7//7 8//8\nf 1//1 2//2 6//6 5//9\nf 2 3 7 6\nf 3 4 8 7\n" +
                               "f 4//9 1//9 5//9 8//9\n";
    const auto model = load_text("dented.obj", dented);
    EXPECT_TRUE(model->topology().twisted_edges.empty());
    EXPECT_FALSE(model->topology().mesh_is_inverted[0]);
}

}  // namespace
}  // namespace croquis::model::testing
