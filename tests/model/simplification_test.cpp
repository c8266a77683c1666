// Levels of detail against what seed A's table 3 keeps: half the faces each, the screen coverage within 13 %.
#include "model/simplification.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <vector>

#include "fixtures.h"

namespace croquis::model::testing {
namespace {

using ModelPointer = std::shared_ptr<const Model>;

ModelPointer shipped(const std::string& name) {
    return load(std::filesystem::path(std::getenv("CROQUIS_DATA")) / "models" / name);
}

/// The share of a frame that a model covers, by brute force: parallel rays against every triangle's outline.
double coverage(const Model& model, const Bounds& frame, const glm::dvec3& direction) {
    constexpr int side = 160;
    const glm::dvec3 back = glm::normalize(direction);
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), back)), up = glm::cross(back, right);
    const auto on_screen = [&](const glm::vec3& point) {
        const glm::dvec3 p = glm::dvec3(point - frame.centre()) / double(frame.radius());
        return side * 0.5 * (glm::dvec2(glm::dot(p, right), glm::dot(p, up)) + 1.0);
    };
    const auto turn = [](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    };
    std::vector<bool> is_covered(side * side, false);
    for (const Mesh& mesh : model.meshes) {
        for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
            const glm::dvec2 a = on_screen(mesh.positions[mesh.triangles[t]]);
            const glm::dvec2 b = on_screen(mesh.positions[mesh.triangles[t + 1]]);
            const glm::dvec2 c = on_screen(mesh.positions[mesh.triangles[t + 2]]);
            const glm::ivec2 low(glm::floor(glm::min(a, glm::min(b, c))));
            const glm::ivec2 high(glm::ceil(glm::max(a, glm::max(b, c))));
            for (int y = std::max(low.y, 0); y < std::min(high.y, side); ++y) {
                for (int x = std::max(low.x, 0); x < std::min(high.x, side); ++x) {
                    const glm::dvec2 p(x + 0.5, y + 0.5);
                    const double u = turn(a, b, p), v = turn(b, c, p), w = turn(c, a, p);
                    if ((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0))
                        is_covered[std::size_t(y * side + x)] = true;
                }
            }
        }
    }
    return double(std::count(is_covered.begin(), is_covered.end(), true)) / (side * side);
}

void expect_within(const Bounds& inner, const Bounds& outer) {
    EXPECT_EQ(glm::min(inner.low, outer.low), outer.low);
    EXPECT_EQ(glm::max(inner.high, outer.high), outer.high);
}

// Seed A's series: five times half the faces, from its table 2's direction and the opposite one.
TEST(Simplification, LevelsHalveTheFacesAndKeepTheCoverage) {
    for (const char* name : {"torus_knot.obj", "sphere.obj", "teapot.obj"}) {
        const ModelPointer model = shipped(name);
        for (int level = 1; level <= 4; ++level) {
            SCOPED_TRACE(fmt::format("{}, level {}", name, level));
            const double wanted = double(model->triangle_count()) / std::pow(2, level);
            const ModelPointer coarse = simplified(model, std::size_t(std::lround(wanted)));
            EXPECT_NEAR(double(coarse->triangle_count()) / wanted, 1.0, 0.03);
            expect_within(coarse->bounds, model->bounds);
            for (const double sign : {1.0, -1.0}) {
                const glm::dvec3 direction = sign * glm::dvec3(12.73, 17.85, 12.52);
                const double full = coverage(*model, model->bounds, direction);
                EXPECT_NEAR(coverage(*coarse, model->bounds, direction) / full, 1.0, 0.13);
            }
        }
    }
}

TEST(Simplification, AClosedSurfaceStaysClosed) {
    for (const ModelPointer& model :
         {shipped("torus_knot.obj"), shipped("sphere.obj"), load_text("ball.obj", sphere(24, 48, 2))}) {
        ASSERT_EQ(model->topology().border_edge_count(), 0u);
        const ModelPointer coarse = simplified(model, model->triangle_count() / 8);
        const Topology& topology = coarse->topology();
        EXPECT_EQ(topology.border_edge_count(), 0u) << model->name;
        EXPECT_EQ(topology.twisted_edges.size(), 0u) << model->name;
        const auto euler = [](const Topology& t) {
            return long(t.positions.size()) - long(t.edges.size()) + long(t.faces.size());
        };
        EXPECT_EQ(euler(topology), euler(model->topology())) << model->name;
    }
}

// A sphere of two halves, one mesh each: along the equator they must still meet.
TEST(Simplification, MeshesStayTogetherWhereTheyTouch) {
    std::string text = sphere(24, 48, 1);
    const std::size_t faces = text.find("f ");
    std::string upper, lower;
    int face = 0;
    for (std::size_t at = faces; at < text.size(); ++face) {
        const std::size_t end = text.find('\n', at) + 1;
        (face % 24 < 12 ? upper : lower) += text.substr(at, end - at);
        at = end;
    }
    const ModelPointer model =
        load_text("halves.obj", text.substr(0, faces) + "o upper\nusemtl a\n" + upper + "o lower\nusemtl b\n" + lower);
    ASSERT_EQ(model->meshes.size(), 2u);
    const ModelPointer coarse = simplified(model, model->triangle_count() / 8);
    EXPECT_EQ(coarse->topology().border_edge_count(), 0u);
    ASSERT_EQ(coarse->meshes.size(), 2u);
    EXPECT_EQ(coarse->meshes[0].name, "upper");
    EXPECT_NE(coarse->meshes[0].material, coarse->meshes[1].material);
    for (const Mesh& mesh : coarse->meshes) {
        for (const glm::vec3& p : mesh.positions) {
            EXPECT_TRUE(mesh.name == "upper" ? p.y > -1e-6f : p.y < 1e-6f) << mesh.name << " at " << p.y;
        }
    }
}

// A wavy sheet of n by n squares, its colour and texture coordinate read off its place.
ModelPointer colored_sheet(int n) {
    RawModel raw;
    Mesh& mesh = raw.meshes.emplace_back().mesh;
    for (int y = 0; y <= n; ++y) {
        for (int x = 0; x <= n; ++x) {
            mesh.positions.emplace_back(x, y, 0.2 * std::sin(x) * std::cos(y));
            mesh.texcoords.emplace_back(float(x) / float(n), float(y) / float(n));
            mesh.colors.emplace_back(x, y, 7, 255);
        }
    }
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const auto a = std::uint32_t(y * (n + 1) + x), b = a + std::uint32_t(n) + 1;
            for (const std::uint32_t v : {a, a + 1, b + 1, a, b + 1, b}) mesh.triangles.push_back(v);
        }
    }
    return finish(std::move(raw), "sheet");
}

TEST(Simplification, VerticesKeepTheirLooksAndBordersStayBorders) {
    constexpr int n = 32;
    const ModelPointer coarse = simplified(colored_sheet(n), 400);
    ASSERT_EQ(coarse->meshes.size(), 1u);
    const Mesh& mesh = coarse->meshes[0];
    ASSERT_EQ(mesh.texcoords.size(), mesh.positions.size());
    ASSERT_EQ(mesh.colors.size(), mesh.positions.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const glm::vec3& p = mesh.positions[v];
        EXPECT_EQ(mesh.texcoords[v], glm::vec2(p.x / n, p.y / n));
        EXPECT_EQ(mesh.colors[v], glm::u8vec4(p.x, p.y, 7, 255));
    }
    for (const Edge& edge : coarse->topology().edges) {
        if (edge.faces[1] != no_face) continue;
        const glm::vec3 a = coarse->topology().positions[edge.vertices[0]];
        const glm::vec3 b = coarse->topology().positions[edge.vertices[1]];
        const bool on_side = (a.x == b.x && (a.x == 0 || a.x == n)) || (a.y == b.y && (a.y == 0 || a.y == n));
        EXPECT_TRUE(on_side) << a.x << ',' << a.y << " to " << b.x << ',' << b.y;
    }
}

// A cut cube keeps its creases: each face of the coarse one takes the normals of the side that it lies on.
TEST(Simplification, CreasesStaySharp) {
    const ModelPointer fine = load_text("box.obj", [] {
        std::string text;
        constexpr int n = 12;
        int count = 0;
        for (int axis = 0; axis < 3; ++axis) {
            for (const int end : {0, n}) {
                for (int i = 0; i < n; ++i) {
                    for (int k = 0; k < n; ++k) {
                        int corners[4][2] = {{i, k}, {i + 1, k}, {i + 1, k + 1}, {i, k + 1}};
                        if (end == 0) std::swap(corners[1], corners[3]);
                        for (const auto& corner : corners) {
                            int p[3];
                            p[axis] = end;
                            p[(axis + 1) % 3] = corner[0];
                            p[(axis + 2) % 3] = corner[1];
                            text += fmt::format("v {} {} {}\n", p[0], p[1], p[2]);
                        }
                        text += fmt::format("f {} {} {} {}\n", count + 1, count + 2, count + 3, count + 4);
                        count += 4;
                    }
                }
            }
        }
        return text;
    }());
    ASSERT_EQ(fine->triangle_count(), 1728u);
    const ModelPointer coarse = simplified(fine, 12);
    EXPECT_EQ(coarse->triangle_count(), 12u);
    const Mesh& mesh = coarse->meshes[0];
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
        const std::uint32_t* const v = &mesh.triangles[t];
        const glm::vec3 normal = glm::normalize(
            glm::cross(mesh.positions[v[1]] - mesh.positions[v[0]], mesh.positions[v[2]] - mesh.positions[v[0]]));
        for (int k = 0; k < 3; ++k) EXPECT_GT(glm::dot(mesh.normals[v[k]], normal), 0.999f);
    }
}

TEST(Simplification, AnimationsGoOn) {
    const ModelPointer model = load(sample_folder / "MD2/faerie.md2");
    ASSERT_FALSE(model->clips.empty());
    const ModelPointer coarse = simplified(model, model->triangle_count() / 2);
    ASSERT_EQ(coarse->clips.size(), model->clips.size());
    const AnimationClip& clip = coarse->clips.front();
    const Pose pose = pose_at(*coarse, clip, 0.3 * clip.seconds);
    const Pose full = pose_at(*model, model->clips.front(), 0.3 * clip.seconds);
    std::set<std::array<float, 3>> places;
    for (const glm::vec3& p : full[0].positions) places.insert({p.x, p.y, p.z});
    for (const glm::vec3& p : pose[0].positions) EXPECT_TRUE(places.contains({p.x, p.y, p.z}));
}

/// The model with a colour of its own for each face: every edge is a seam.
ModelPointer patchwork(const Model& model) {
    RawModel raw;
    Mesh& mesh = raw.meshes.emplace_back().mesh;
    for (const std::uint32_t corner : model.meshes[0].triangles) {
        const auto face = mesh.triangles.size() / 3;
        mesh.triangles.push_back(std::uint32_t(mesh.positions.size()));
        mesh.positions.push_back(model.meshes[0].positions[corner]);
        mesh.normals.push_back(model.meshes[0].normals[corner]);
        mesh.colors.emplace_back(face % 256, face / 256, 0, 255);
    }
    return finish(std::move(raw), "patchwork");
}

TEST(Simplification, SaysWhatItCannotDo) {
    const auto message = [](const ModelPointer& model, std::size_t triangles) -> std::string {
        try {
            static_cast<void>(simplified(model, triangles));
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    };
    const ModelPointer ball = load_text("ball.obj", sphere(8, 16, 1));
    EXPECT_EQ(message(ball, 0), "expected at least 1 triangle to simplify to, found 0");
    const std::string nothing = message(ball, 1);
    EXPECT_NE(nothing.find("ball.obj: expected more triangles to simplify to, found 1: nothing would be left"),
              std::string::npos)
        << nothing;
    const std::string held = message(patchwork(*ball), 20);
    EXPECT_NE(held.find(fmt::format("found that its shape, borders and seams need {}", ball->triangle_count())),
              std::string::npos)
        << held;
    EXPECT_EQ(simplified(ball, ball->triangle_count()), ball);
    EXPECT_EQ(simplified(ball, 1'000'000), ball);
}

// Every vertex of the rough copy is one of the model's, with its normal; the outline stays to within a cell.
TEST(Clustering, ARoughCopyKeepsVerticesAndShape) {
    const ModelPointer model = load_text("ball.obj", sphere(160, 320, 2));
    const ModelPointer rough = clustered(model, 6000);
    EXPECT_GT(rough->triangle_count(), 3000u);
    EXPECT_LT(rough->triangle_count(), 6600u);
    std::map<std::array<float, 3>, glm::vec3> normals;  // by place: the sphere has one vertex at each
    for (std::size_t v = 0; v < model->meshes[0].positions.size(); ++v) {
        const glm::vec3& p = model->meshes[0].positions[v];
        normals[{p.x, p.y, p.z}] = model->meshes[0].normals[v];
    }
    for (std::size_t v = 0; v < rough->meshes[0].positions.size(); ++v) {
        const glm::vec3& p = rough->meshes[0].positions[v];
        const auto found = normals.find({p.x, p.y, p.z});
        ASSERT_NE(found, normals.end());
        EXPECT_LT(glm::distance(found->second, rough->meshes[0].normals[v]), 1e-6f);
    }
    expect_within(rough->bounds, model->bounds);
    const glm::dvec3 direction(1, 2, 3);
    EXPECT_NEAR(coverage(*rough, model->bounds, direction) / coverage(*model, model->bounds, direction), 1.0, 0.03);
}

TEST(Clustering, FewTrianglesStayAsTheyAre) {
    const ModelPointer model = load_text("cube.obj", cube());
    EXPECT_EQ(clustered(model, 12), model);
    EXPECT_EQ(clustered(model, 3)->triangle_count(), 12u);
    EXPECT_THROW(static_cast<void>(clustered(model, 0)), Error);
}

}  // namespace
}  // namespace croquis::model::testing
