// The lenses: the sphere map of seed B's sphere against its closed form, and what they draw.
#include "viewer/magnifier.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "gpu/context.h"
#include "viewer/appearance.h"
#include "viewer/sphere_lens.h"

namespace croquis::viewer {
namespace {

// r = (2 n_x n_z, 2 n_y n_z, 2 n_z² - 1), m = 4 n_z, s = n_x / 2 + 1/2.
TEST(SphereMapTest, FromFarAwayItIsLinear) {
    for (const double x : {-0.9, -0.3, 0.0, 0.5, 0.8}) {
        for (const double y : {-0.4, 0.0, 0.1}) {
            const glm::dvec2 found = sphere_map({x, y, std::sqrt(1 - x * x - y * y)}, {0, 0, -1});
            EXPECT_NEAR(found.x, 0.5 * x + 0.5, 1e-12);
            EXPECT_NEAR(found.y, 0.5 * y + 0.5, 1e-12);
        }
    }
}

// At ρ of the lens's radius the line of sight meets the axis at α, tan α = ρ tan α₁ with sin α₁ = 1 / e, and by the law
// of sines the sphere at θ = arcsin(e sin α) - α from the axis. There s = sin(θ + α / 2) / 2 + 1/2.
TEST(SphereLensTest, IsTheClosedForm) {
    constexpr double e = 5;
    for (int i = 0; i <= 50; ++i) {
        const LensPoint found = sphere_lens(i / 50.0);
        const double alpha = std::atan(found.radius * std::tan(std::asin(1 / e)));
        const double theta = std::asin(std::min(1.0, e * std::sin(alpha))) - alpha;
        EXPECT_NEAR(found.reach, std::sin(theta + 0.5 * alpha), 1e-7) << i;  // arcsin is steep near 1
    }
    EXPECT_NEAR(sphere_lens(1).radius, 1, 1e-12);
    EXPECT_NEAR(sphere_lens(1).reach, std::cos(0.5 * std::asin(1 / e)), 1e-12);
}

TEST(SphereLensTest, IsLinearInTheMiddleAndSteeperTowardsTheRim) {
    const LensPoint near = sphere_lens(1e-5);
    EXPECT_NEAR(near.reach / near.radius, middle_reach(), 1e-8);
    double last = 0;
    for (int i = 0; i < 50; ++i) {
        const LensPoint from = sphere_lens(i / 50.0), to = sphere_lens((i + 1) / 50.0);
        const double steepness = (to.reach - from.reach) / (to.radius - from.radius);
        EXPECT_GT(steepness, last) << i;
        last = steepness;
    }
    EXPECT_GT(last, 1.5);
}

class MagnifierTest : public ::testing::Test {
protected:
    MagnifierTest() : context_(gpu::Context::headless(gpu::ContextOptions::from_environment())) {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = ImVec2(800, 600);
        set_appearance(1);
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
        io.MousePos = mouse;
        (void)canvas_.begin({400, 300});
        canvas_.keep();
    }
    ~MagnifierTest() override { ImGui::DestroyContext(); }

    // What the lens draws with the canvas's texture, in places of the picture's pixels.
    struct Corner {
        glm::dvec2 from_mouse;
        glm::dvec2 pixel;
    };
    std::vector<Corner> corners(const Magnifier& magnifier) {
        ImGui::NewFrame();
        magnifier.show(canvas_, 1);
        const ImDrawList& list = *ImGui::GetForegroundDrawList();
        std::vector<Corner> found;
        for (const ImDrawCmd& command : list.CmdBuffer) {
            if (command.GetTexID() == ImGui::GetIO().Fonts->TexID) continue;
            for (unsigned i = 0; i < command.ElemCount; ++i) {
                const ImDrawVert& vertex =
                    list.VtxBuffer[int(command.VtxOffset) + list.IdxBuffer[int(command.IdxOffset + i)]];
                found.push_back({{vertex.pos.x - mouse.x, vertex.pos.y - mouse.y},
                                 {vertex.uv.x * 400.0, (1 - vertex.uv.y) * 300.0}});
            }
        }
        ImGui::EndFrame();
        return found;
    }

    const ImVec2 mouse{150, 120};
    std::unique_ptr<gpu::Context> context_;
    Canvas canvas_;
};

constexpr glm::dvec2 middle(150.5, 120.5);  // of the pixel under the mouse

TEST_F(MagnifierTest, FlatLensesMagnifyEvenly) {
    Magnifier magnifier;
    magnifier.hold();
    for (int shape = 0; shape < 2; ++shape) {
        const auto found = corners(magnifier);
        ASSERT_FALSE(found.empty());
        const double half = 8 * double(ImGui::GetFontSize());
        for (const Corner& corner : found) {
            const glm::dvec2 place = glm::clamp(corner.from_mouse, -half, half);  // beyond it only fades out
            EXPECT_LT(glm::length(middle + place / magnifier.factor() - corner.pixel), 0.01);
        }
        magnifier.take_next_shape();
    }
}

TEST_F(MagnifierTest, TheSphereMagnifiesByTheFactorInItsMiddle) {
    Magnifier magnifier;
    magnifier.hold();
    magnifier.take_next_shape();
    magnifier.take_next_shape();
    ASSERT_EQ(magnifier.shape(), Magnifier::Shape::sphere);
    for (const double notches : {-20.0, 3.0, 20.0}) {
        magnifier.zoom(notches);
        const auto found = corners(magnifier);
        ASSERT_FALSE(found.empty());
        double rim = 0, reach = 0;
        for (const Corner& corner : found) {
            const double away = glm::length(corner.from_mouse), shown = glm::length(corner.pixel - middle);
            rim = std::max(rim, away);
            reach = std::max(reach, shown);
            EXPECT_GE(shown, away / magnifier.factor() - 0.01);
            if (away < 0.1 * 120) {
                EXPECT_NEAR(shown, away / magnifier.factor(), 0.01 * away / magnifier.factor() + 0.01);
            }
        }
        EXPECT_NEAR(rim, 8 * ImGui::GetFontSize(), 0.01);
        // At the rim s = cos(α₁ / 2) / 2 + 1/2, and the half side of the square is the rim's by factor and middle.
        EXPECT_NEAR(reach, rim / magnifier.factor() * std::cos(0.5 * std::asin(0.2)) * std::sqrt(24.0) / 4.5, 0.01);
    }
    magnifier.take_next_shape();
    EXPECT_EQ(magnifier.shape(), Magnifier::Shape::round);
}

}  // namespace
}  // namespace croquis::viewer
