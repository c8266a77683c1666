// The virtual trackball against seed B's equations, worked out by hand.
#include "viewer/trackball.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace croquis::viewer {
namespace {

constexpr VirtualSphere sphere{.centre = {300, 200}, .radius = 100};

void expect_near(const glm::dvec3& found, const glm::dvec3& expected) {
    EXPECT_LT(glm::length(found - expected), 1e-12) << found.x << ' ' << found.y << ' ' << found.z << ", expected "
                                                    << expected.x << ' ' << expected.y << ' ' << expected.z;
}

TEST(Trackball, TheMouseLiesOnTheSphere) {
    expect_near(sphere.point_under({300, 200}), {0, 0, 1});
    expect_near(sphere.point_under({360, 200}), {0.6, 0, 0.8});
    expect_near(sphere.point_under({300, 120}), {0, 0.8, 0.6});  // y points down in the window
}

TEST(Trackball, BeyondTheRimItLiesOnTheRim) {
    expect_near(sphere.point_under({400, 200}), {1, 0, 0});
    expect_near(sphere.point_under({900, 200}), {1, 0, 0});
    expect_near(sphere.point_under({600, -100}), {std::sqrt(0.5), std::sqrt(0.5), 0});
}

// cos θ = x₁ · x₂ / (|x₁| |x₂|), about x₁ × x₂: the rotation carries the first point to the second and keeps the axis.
TEST(Trackball, RotatesByTheAngleBetweenItsPoints) {
    for (const glm::dvec2 from : {glm::dvec2(310, 215), {260, 160}, {390, 200}}) {
        for (const glm::dvec2 to : {glm::dvec2(300, 200), {350, 260}, {700, 50}, from}) {
            const glm::dvec3 a = sphere.point_under(from), b = sphere.point_under(to);
            const glm::dquat rotation = rotation_between(a, b);
            expect_near(rotation * a, b);
            expect_near(rotation * glm::cross(a, b), glm::cross(a, b));
            const double cosine = glm::dot(a, b) / (glm::length(a) * glm::length(b));
            EXPECT_NEAR(std::cos(2 * std::acos(std::abs(rotation.w))), cosine, 1e-12);
        }
    }
}

TEST(Trackball, OppositePointsOfTheRimAreHalfATurn) {
    const glm::dquat rotation = rotation_between({1, 0, 0}, {-1, 0, 0});
    expect_near(rotation * glm::dvec3(1, 0, 0), {-1, 0, 0});
    expect_near(rotation * glm::dvec3(0, 0, 1), {0, 0, 1});
}

}  // namespace
}  // namespace croquis::viewer
