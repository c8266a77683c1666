// Texture coordinates that can carry strokes, and those that cannot.
#include "model/texcoord_scale.h"

#include <gtest/gtest.h>

#include <cmath>

namespace croquis::model {
namespace {

// A square of side 2, its texture coordinates so many images wide and high.
Mesh square(glm::vec2 images) {
    Mesh mesh;
    mesh.positions = {{0, 0, 5}, {2, 0, 5}, {2, 2, 5}, {0, 2, 5}};
    mesh.texcoords = {{0, 0}, {images.x, 0}, images, {0, images.y}};
    mesh.triangles = {0, 1, 2, 0, 2, 3};
    return mesh;
}

TEST(TexcoordScale, IsImagesAUnit) {
    EXPECT_NEAR(texcoord_scale(square({1, 1})), 0.5, 1e-9);
    EXPECT_NEAR(texcoord_scale(square({6, 6})), 3, 1e-9);
    EXPECT_NEAR(texcoord_scale(square({1, 2.9f})), 0.5 * std::sqrt(2.9), 1e-6) << "stretched, but not too much";
}

TEST(TexcoordScale, IsZeroWhereStrokesWouldBeDrawnOut) {
    EXPECT_EQ(texcoord_scale(square({1, 3.2f})), 0);
    EXPECT_EQ(texcoord_scale(square({1, 0})), 0);
    Mesh sheared = square({1, 1});
    for (glm::vec2& coordinate : sheared.texcoords) coordinate.x += 3 * coordinate.y;
    EXPECT_EQ(texcoord_scale(sheared), 0);
    Mesh none = square({1, 1});
    none.texcoords.clear();
    EXPECT_EQ(texcoord_scale(none), 0);
    Mesh two_scales = square({1, 1});
    for (std::uint32_t i = 0; i < 4; ++i) {
        two_scales.positions.push_back(two_scales.positions[i]);
        two_scales.texcoords.push_back(10.0f * two_scales.texcoords[i]);
    }
    for (const std::uint32_t v : {4u, 5u, 6u, 4u, 6u, 7u}) two_scales.triangles.push_back(v);
    EXPECT_EQ(texcoord_scale(two_scales), 0);
}

}  // namespace
}  // namespace croquis::model
