// Facets: every triangle is there as it was, its last vertex its own; what it carries against plain sums.
#include "model/facets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <set>

#include "base/random.h"

namespace croquis::model {
namespace {

Mesh grid(std::uint32_t side) {
    Mesh mesh;
    const Random random(1, "grid");
    for (std::uint32_t y = 0; y <= side; ++y) {
        for (std::uint32_t x = 0; x <= side; ++x) {
            const std::uint64_t i = mesh.positions.size();
            mesh.positions.emplace_back(float(x), float(y), float(random.unit(i)));
            mesh.normals.push_back(glm::normalize(glm::vec3(float(random.unit(i + 10000)), 0.5f, 1.0f)));
            mesh.texcoords.emplace_back(float(x) / float(side), float(y) / float(side));
            mesh.colors.emplace_back(std::uint8_t(x * 7), std::uint8_t(y * 5), 9, 255);
        }
    }
    const std::uint32_t row = side + 1;
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const std::uint32_t a = y * row + x, b = a + 1, c = a + row, d = c + 1;
            for (const std::uint32_t v : {a, b, d, a, d, c}) mesh.triangles.push_back(v);
        }
    }
    return mesh;
}

TEST(Facets, EachTriangleHasALastVertexOfItsOwn) {
    const Mesh mesh = grid(30);
    const FacetLayout layout = facet_layout(mesh);
    ASSERT_EQ(layout.triangles.size(), mesh.triangles.size());
    std::set<std::uint32_t> last_vertices;
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        std::array<std::uint32_t, 3> was{}, is{};
        for (std::size_t i = 0; i < 3; ++i) {
            was[i] = mesh.triangles[3 * t + i];
            is[i] = layout.vertices[layout.triangles[3 * t + i]];
        }
        const std::uint32_t last = layout.triangles[3 * t + 2];
        EXPECT_TRUE(last_vertices.insert(last).second) << "vertex " << last << " is the last of two triangles";
        EXPECT_EQ(layout.spoken_for[last], t);
        std::rotate(is.begin(), std::find(is.begin(), is.end(), was[0]), is.end());
        EXPECT_EQ(is, was) << "triangle " << t << " is another, or turned over";
    }
}

TEST(Facets, HardlyMoreVerticesThanTriangles) {
    const Mesh mesh = grid(30);
    const FacetLayout layout = facet_layout(mesh);
    EXPECT_GE(layout.vertices.size(), mesh.triangle_count());
    EXPECT_LE(layout.vertices.size(), mesh.triangle_count() * 102 / 100);
}

TEST(Facets, CarrySumsAndMeans) {
    const Mesh mesh = grid(4);
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        const std::uint32_t* v = &mesh.triangles[3 * t];
        const Facet facet = facet_of(mesh, mesh.positions, mesh.normals, t);
        const auto& p = mesh.positions;
        EXPECT_LT(glm::distance(facet.normal, mesh.normals[v[0]] + mesh.normals[v[1]] + mesh.normals[v[2]]), 1e-6f);
        EXPECT_LT(glm::distance(facet.barycentre, (p[v[0]] + p[v[1]] + p[v[2]]) / 3.0f), 1e-5f);
        EXPECT_FLOAT_EQ(facet.size, std::max({glm::distance(p[v[0]], p[v[1]]), glm::distance(p[v[1]], p[v[2]]),
                                              glm::distance(p[v[2]], p[v[0]])}));
        const float red = float(mesh.colors[v[0]].x + mesh.colors[v[1]].x + mesh.colors[v[2]].x) / 765.0f;
        EXPECT_NEAR(facet.color.x, red, 1e-6);
        EXPECT_NEAR(facet.texcoord.y, (mesh.texcoords[v[0]].y + mesh.texcoords[v[1]].y + mesh.texcoords[v[2]].y) / 3,
                    1e-6);
    }
    Mesh plain = mesh;
    plain.colors.clear();
    EXPECT_EQ(facet_of(plain, plain.positions, plain.normals, 0).color, glm::vec4(1.0f));
}

TEST(Facets, TwoVerticesOfOneColourDecide) {
    const glm::u8vec4 red(255, 0, 0, 255), blue(0, 0, 255, 255);
    Mesh mesh = grid(1);
    for (std::size_t odd = 0; odd < 3; ++odd) {
        for (std::size_t i = 0; i < 3; ++i) mesh.colors[mesh.triangles[i]] = i == odd ? blue : red;
        EXPECT_EQ(facet_color(mesh, 0), glm::vec4(1, 0, 0, 1)) << odd;
    }
}

}  // namespace
}  // namespace croquis::model
