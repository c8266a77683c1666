// Subdivision surfaces against the closed forms of their limits, and what must survive them.
#include "model/subdivision.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fixtures.h"

namespace croquis::model::testing {
namespace {

constexpr SubdivisionScheme both_schemes[] = {SubdivisionScheme::loop, SubdivisionScheme::catmull_clark};
constexpr double pi = 3.14159265358979323846;

std::string octahedron() {
    return "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n"
           "f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n";
}

/// The distance from a point to the model's nearest vertex; that vertex's normal, if wanted.
double distance_to_vertex(const Model& model, const glm::dvec3& wanted, glm::vec3* normal = nullptr) {
    double nearest = std::numeric_limits<double>::max();
    for (const Mesh& mesh : model.meshes) {
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const double distance = glm::distance(glm::dvec3(mesh.positions[v]), wanted);
            if (distance >= nearest) continue;
            nearest = distance;
            if (normal != nullptr) *normal = mesh.normals[v];
        }
    }
    return nearest;
}

long euler_number(const Topology& topology) {
    return long(topology.positions.size()) - long(topology.edges.size()) + long(topology.faces.size());
}

bool all_finite(const Model& model) {
    for (const Mesh& mesh : model.meshes) {
        for (const auto* list : {&mesh.positions, &mesh.normals}) {
            for (const glm::vec3& v : *list) {
                if (!std::isfinite(v.x + v.y + v.z)) return false;
            }
        }
    }
    return true;
}

// Loop's limit of a vertex v of valence n: (1 - n w) v + w (sum of neighbours), w = 1 / (n + 3 / (8 b)), where
// b = (5/8 - (3/8 + cos(2 pi / n) / 4)^2) / n. The octahedron's neighbours of a vertex sum to zero; b = 31/256.
TEST(Subdivision, OctahedronUnderLoopHasItsLimitPoints) {
    const double b = (5.0 / 8 - std::pow(3.0 / 8 + std::cos(2 * pi / 4) / 4, 2)) / 4;
    const double w = 1 / (4 + 3 / (8 * b));
    const double vertex_scale = 1 - 4 * w;  // 24/55
    // An edge's first point is 3/8 (p + q); its six neighbours then are 33/64 p, 33/64 q and four more edge points.
    const double edge_scale = 0.5 * 3 / 8 + (1 - 4 * b + 3.0 / 4) / 12;  // 75/256
    const auto model = load_text("octahedron.obj", octahedron());
    for (int levels = 1; levels <= 4; ++levels) {
        const auto smooth = subdivide(*model, SubdivisionScheme::loop, levels);
        for (int axis = 0; axis < 3; ++axis) {
            for (const double sign : {-1.0, 1.0}) {
                glm::dvec3 direction(0.0);
                direction[axis] = sign;
                glm::vec3 normal;
                EXPECT_LT(distance_to_vertex(*smooth, vertex_scale * direction, &normal), 1e-7) << levels;
                EXPECT_LT(glm::distance(glm::dvec3(normal), direction), 1e-6) << levels;
                direction[(axis + 1) % 3] = 1.0;
                EXPECT_LT(distance_to_vertex(*smooth, edge_scale * direction, &normal), 1e-7) << levels;
                EXPECT_LT(glm::distance(glm::dvec3(normal), glm::normalize(direction)), 1e-6) << levels;
            }
        }
    }
}

// Catmull and Clark's limit of a vertex of valence n among quadrangles: (n^2 v + 4 (sum of edge neighbours) + (sum of
// those across faces)) / (n (n + 5)). After the first level the octahedron's vertex (1, 0, 0) is 7/12 of itself, its
// edge neighbours 5/12 (p + q), its face points (p + q + r) / 3.
TEST(Subdivision, OctahedronUnderCatmullClarkHasItsLimitPoints) {
    const auto model = load_text("octahedron.obj", octahedron());
    for (int levels = 1; levels <= 3; ++levels) {
        const auto smooth = subdivide(*model, SubdivisionScheme::catmull_clark, levels);
        const double scale = (16 * 7.0 / 12 + 4 * 4 * 5.0 / 12 + 4.0 / 3) / 36;
        EXPECT_LT(distance_to_vertex(*smooth, {scale, 0, 0}), 1e-7) << levels;
        EXPECT_LT(distance_to_vertex(*smooth, {0, -scale, 0}), 1e-7) << levels;
    }
}

TEST(Subdivision, EachLevelMakesFourTimesTheTrianglesAndClosedStaysClosed) {
    const auto model = load_text("sphere.obj", sphere(6, 9, 1));
    for (const SubdivisionScheme scheme : both_schemes) {
        std::size_t wanted = model->triangle_count();
        for (int levels = 0; levels <= 3; ++levels) {
            if (levels > 0) wanted *= levels == 1 && scheme == SubdivisionScheme::catmull_clark ? 6 : 4;
            const auto smooth = subdivide(*model, scheme, levels);
            EXPECT_EQ(smooth->triangle_count(), wanted);
            EXPECT_EQ(subdivided_triangle_count(model->triangle_count(), scheme, levels), wanted);
            EXPECT_EQ(euler_number(smooth->topology()), 2);
            EXPECT_TRUE(smooth->topology().mesh_is_solid[0]);
            EXPECT_FALSE(smooth->topology().mesh_is_inverted[0]);
            EXPECT_EQ(smooth->vertex_count(), smooth->topology().positions.size()) << "a smooth model has no seams";
        }
    }
}

/// Triangles around a middle point, its rim not flat.
std::string fan(int count, std::vector<glm::dvec3>& rim) {
    std::string text = "v 0 0 0.5\n";
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * pi * i / count;
        rim.emplace_back((2 + i % 2) * std::cos(angle), (2 + i % 2) * std::sin(angle), 0.3 * (i % 3));
        text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", rim.back().x, rim.back().y, rim.back().z);
    }
    for (int i = 0; i < count; ++i) text += fmt::format("f 1 {} {}\n", 2 + i, 2 + (i + 1) % count);
    return text;
}

TEST(Subdivision, BordersAreCubicBSplines) {
    std::vector<glm::dvec3> rim;
    const auto model = load_text("fan.obj", fan(7, rim));
    for (const SubdivisionScheme scheme : both_schemes) {
        for (const int levels : {1, 3}) {
            const auto smooth = subdivide(*model, scheme, levels);
            EXPECT_EQ(smooth->topology().border_edge_count(), rim.size() << levels);
            for (std::size_t i = 0; i < rim.size(); ++i) {
                const auto p = [&](std::size_t k) { return rim[(i + k) % rim.size()]; };
                EXPECT_LT(distance_to_vertex(*smooth, (p(0) + 4.0 * p(1) + p(2)) / 6.0), 1e-6);
                EXPECT_LT(distance_to_vertex(*smooth, (p(0) + 23.0 * p(1) + 23.0 * p(2) + p(3)) / 48.0), 1e-6);
            }
        }
    }
}

TEST(Subdivision, ACornerOfOneFaceStays) {
    const auto model = load_text("triangle.obj", "v 0 0 0\nv 4 0 0\nv 0 3 0\nf 1 2 3\n");
    const auto smooth = subdivide(*model, SubdivisionScheme::loop, 3);
    for (const glm::dvec3& corner : {glm::dvec3(0, 0, 0), glm::dvec3(4, 0, 0), glm::dvec3(0, 3, 0)}) {
        EXPECT_LT(distance_to_vertex(*smooth, corner), 1e-7);
    }
}

TEST(Subdivision, APlaneStaysAPlane) {
    // In the plane z = x / 2 - y / 4 + 1, its points at random.
    std::string text;
    const int n = 8;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const double x = i + 0.3 * std::sin(12.9 * i + 78.2 * j), y = j + 0.3 * std::cos(4.1 * i + 39.3 * j);
            text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", x, y, x / 2 - y / 4 + 1);
        }
    }
    for (int i = 0; i + 1 < n; ++i) {
        for (int j = 0; j + 1 < n; ++j) {
            const int a = 1 + i * n + j;
            text += fmt::format("f {} {} {}\nf {} {} {}\n", a, a + n, a + n + 1, a, a + n + 1, a + 1);
        }
    }
    const auto model = load_text("plane.obj", text);
    const glm::dvec3 wanted = glm::normalize(glm::dvec3(-0.5, 0.25, 1));
    for (const SubdivisionScheme scheme : both_schemes) {
        const auto smooth = subdivide(*model, scheme, 2);
        for (const glm::vec3& p : smooth->meshes[0].positions) EXPECT_NEAR(p.z, p.x / 2 - p.y / 4 + 1, 2e-6);
        for (const glm::vec3& normal : smooth->meshes[0].normals)
            EXPECT_LT(glm::distance(glm::dvec3(normal), wanted), 1e-5);
    }
}

TEST(Subdivision, NormalsAreThoseOfTheSurface) {
    const auto model = load_text("sphere.obj", sphere(6, 9, 1));
    for (const SubdivisionScheme scheme : both_schemes) {
        const auto smooth = subdivide(*model, scheme, 4);
        const Mesh& mesh = smooth->meshes[0];
        std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0.0));
        for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
            const auto p = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.triangles[t + k]]); };
            for (std::size_t k = 0; k < 3; ++k)
                sums[mesh.triangles[t + k]] += glm::normalize(glm::cross(p(1) - p(0), p(2) - p(0)));
        }
        for (std::size_t v = 0; v < sums.size(); ++v)
            EXPECT_GT(glm::dot(glm::normalize(sums[v]), glm::dvec3(mesh.normals[v])), 0.999);
    }
}

TEST(Subdivision, CreasesKeepACubeACube) {
    const auto model = load_text("cube.obj", cube());
    for (const SubdivisionScheme scheme : both_schemes) {
        const auto sharp = subdivide(*model, scheme, 2, pi / 6);
        EXPECT_EQ(sharp->bounds.low, glm::vec3(0.0f));
        EXPECT_EQ(sharp->bounds.high, glm::vec3(1.0f));
        const Mesh& mesh = sharp->meshes[0];
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const glm::vec3 p = mesh.positions[v], n = glm::abs(mesh.normals[v]);
            const float off = std::min({p.x, p.y, p.z, 1 - p.x, 1 - p.y, 1 - p.z});
            EXPECT_NEAR(off, 0.0f, 1e-6f);
            EXPECT_NEAR(std::max({n.x, n.y, n.z}), 1.0f, 1e-6f) << "each vertex belongs to one side";
        }
        EXPECT_EQ(euler_number(sharp->topology()), 2);
        const auto smooth = subdivide(*model, scheme, 2);
        EXPECT_LT(smooth->bounds.high.x, 0.99f);
    }
}

TEST(Subdivision, MeshesKeepNamesMaterialsAndFaces) {
    std::string text = std::string(cube_points) + "o lid\nusemtl red\nf 5 6 7 8\no box\nusemtl blue\n";
    text += "f 4 3 2 1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    const auto model = load_text("box.obj", text);
    for (const SubdivisionScheme scheme : both_schemes) {
        const auto smooth = subdivide(*model, scheme, 2);
        ASSERT_EQ(smooth->meshes.size(), model->meshes.size());
        for (std::size_t m = 0; m < model->meshes.size(); ++m) {
            const Mesh &before = model->meshes[m], &after = smooth->meshes[m];
            EXPECT_EQ(after.name, before.name);
            EXPECT_EQ(after.region, before.region);
            EXPECT_EQ(smooth->materials[after.material].name, model->materials[before.material].name);
            EXPECT_EQ(after.triangle_count(), subdivided_triangle_count(before.triangle_count(), scheme, 2));
        }
        EXPECT_EQ(smooth->topology().border_edge_count(), 0u) << "the meshes still meet";
        EXPECT_EQ(euler_number(smooth->topology()), 2);
    }
}

TEST(Subdivision, TextureCoordinatesAndColoursAreLinearInEachFace) {
    // A cube whose sides each have the whole texture: seams everywhere.
    std::string text = std::string(cube_points) + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
    for (const char* side : {"4 3 2 1", "5 6 7 8", "1 2 6 5", "2 3 7 6", "3 4 8 7", "4 1 5 8"}) {
        int a, b, c, d;
        std::sscanf(side, "%d %d %d %d", &a, &b, &c, &d);
        text += fmt::format("f {}/1 {}/2 {}/3 {}/4\n", a, b, c, d);
    }
    const auto model = load_text("cube.obj", text);
    const auto smooth = subdivide(*model, SubdivisionScheme::loop, 2);
    const Mesh& mesh = smooth->meshes[0];
    ASSERT_EQ(mesh.texcoords.size(), mesh.positions.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
        const auto uv = [&](std::size_t k) { return glm::dvec2(mesh.texcoords[mesh.triangles[t + k]]); };
        const glm::dvec2 a = uv(1) - uv(0), b = uv(2) - uv(0);
        EXPECT_NEAR(a.x * b.y - a.y * b.x, 1.0 / 16, 1e-6);
    }
    for (const glm::vec2& uv : mesh.texcoords) {
        EXPECT_EQ(4.0f * uv, glm::round(4.0f * uv));
    }
    EXPECT_EQ(euler_number(smooth->topology()), 2);

    const auto colored = load_text("colors.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3\n");
    const auto blended = subdivide(*colored, SubdivisionScheme::loop, 1);
    ASSERT_EQ(blended->meshes[0].colors.size(), 6u);
    for (const glm::u8vec4& color : blended->meshes[0].colors) {
        const bool pure = std::max({color.x, color.y, color.z}) == 255;
        EXPECT_EQ(color.x + color.y + color.z, pure ? 255 : 256) << "halves of 255 round up";
        EXPECT_EQ(color.w, 255);
    }
}

TEST(Subdivision, TaggedEdgesPassOnToTheirParts) {
    const auto plain = load_text("cube.obj", cube());
    RawModel raw;
    for (const Mesh& mesh : plain->meshes) raw.meshes.push_back({mesh, {}});
    raw.tagged_edges = {{glm::vec3(0, 0, 0), glm::vec3(1, 0, 0)}, {glm::vec3(1, 1, 1), glm::vec3(1, 1, 0)}};
    const auto model = finish(std::move(raw), "cube");
    ASSERT_EQ(model->topology().tagged_edges.size(), 2u);
    for (const SubdivisionScheme scheme : both_schemes)
        EXPECT_EQ(subdivide(*model, scheme, 3)->topology().tagged_edges.size(), 2u * 8u);
}

TEST(Subdivision, SurfacesThatAreNoManifoldsStayTogether) {
    const std::string fin = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 2 5\n";
    const std::string mixed =
        std::string(cube_points) + "f 1 2 3 4\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    const std::string point = cube() + "v 2 1 1\nv 2 2 1\nv 1 2 2\nf 7 9 10\nf 7 10 11\nf 7 11 9\nf 9 11 10\n";
    const std::string twice = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 1 2 3\nf 2 4 3\nf 3 4 2\n";
    struct Case {
        const char* name;
        std::string text;
        std::size_t crowded, twisted;  // after one level
    };
    for (const Case& c : {Case{"fin.obj", fin, 2, 0}, Case{"mixed.obj", mixed, 0, 8}, Case{"point.obj", point, 0, 0}}) {
        const auto model = load_text(c.name, c.text);
        const auto smooth = subdivide(*model, SubdivisionScheme::loop, 1);
        const Topology &before = model->topology(), &after = smooth->topology();
        EXPECT_EQ(after.crowded_edges.size(), c.crowded) << c.name;
        EXPECT_EQ(after.twisted_edges.size(), c.twisted) << c.name;
        EXPECT_EQ(after.border_edge_count(), 2 * before.border_edge_count()) << c.name;
        EXPECT_EQ(after.positions.size(), before.positions.size() + before.edges.size()) << c.name;
        EXPECT_TRUE(all_finite(*subdivide(*model, SubdivisionScheme::catmull_clark, 3))) << c.name;
    }
    const auto doubled = load_text("twice.obj", twice);
    for (const SubdivisionScheme scheme : both_schemes) {
        const auto smooth = subdivide(*doubled, scheme, 2);
        EXPECT_TRUE(all_finite(*smooth));
        EXPECT_EQ(smooth->triangle_count(), subdivided_triangle_count(4, scheme, 2));
    }
}

TEST(Subdivision, MovingModelsComeToRest) {
    const auto model = load(sample_folder / "MD2/faerie.md2");
    ASSERT_FALSE(model->clips.empty());
    EXPECT_EQ(subdivide(*model, SubdivisionScheme::loop, 0)->clips.size(), model->clips.size());
    const auto smooth = subdivide(*model, SubdivisionScheme::loop, 1);
    EXPECT_TRUE(smooth->clips.empty());
    EXPECT_EQ(smooth->materials[0].texture, model->materials[0].texture);
}

TEST(Subdivision, SaysWhatItCannotDo) {
    const auto message = [](const auto& call) -> std::string {
        try {
            static_cast<void>(call());
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    };
    const auto model = load_text("sphere.obj", sphere(130, 120, 1));
    const std::string name = model->name;
    EXPECT_EQ(message([&] { return subdivide(*model, SubdivisionScheme::loop, 6); }),
              "expected 0 to 5 levels of subdivision, found 6");
    EXPECT_EQ(message([&] { return subdivide(*model, SubdivisionScheme::loop, -1); }),
              "expected 0 to 5 levels of subdivision, found -1");
    EXPECT_EQ(message([&] { return subdivide(*model, SubdivisionScheme::loop, 5); }),
              name + ": 5 levels of subdivision make 31703040 triangles; at most 20000000 are made");
    EXPECT_EQ(message([&] { return subdivision_scheme("lop"); }),
              "unknown subdivision scheme \"lop\"; did you mean \"loop\"?");
    EXPECT_EQ(subdivision_scheme("catmull-clark"), SubdivisionScheme::catmull_clark);

    std::string star = "v 0 0 1\n";
    for (int i = 0; i < 33000; ++i) {
        star += fmt::format("v {:.9g} {:.9g} 0\n", std::cos(2 * pi * i / 33000), std::sin(2 * pi * i / 33000));
    }
    for (int i = 0; i < 33000; ++i) star += fmt::format("f 1 {} {}\n", 2 + i, 2 + (i + 1) % 33000);
    const auto spiky = load_text("star.obj", star);
    EXPECT_EQ(message([&] { return subdivide(*spiky, SubdivisionScheme::loop, 1); }),
              spiky->name + ": expected at most 32767 faces at a vertex to subdivide, found 33000");
}

}  // namespace
}  // namespace croquis::model::testing
