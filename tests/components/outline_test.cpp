// Outlines: where the lines lie, how wide they are, that corners have no gaps, and what each method leaves out (row
// C8).
#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "components/cross.h"
#include "components/outline_edges.h"
#include "components/outline_vertices.h"
#include "support/studio.h"

namespace croquis::components {
namespace {

using namespace test_support;

constexpr const char* fill = "pass render_base surfaces { clear_color 1 1 1 ; } ;";

std::string outlined(const std::string& settings, const std::string& filled = fill) {
    return fmt::format("{}\npass outline lines {{ color 0 0 0 ; shortest 0 ; {} }} ;", filled, settings);
}

bool is_white(const glm::u8vec4& color) { return color == white; }
bool is_black(const glm::u8vec4& color) { return color == black; }

// The pixels of a picture that are not white, and how far any pixel lies from the nearest of them: by brute force over
// those at the rim.
class Mask {
public:
    explicit Mask(const image::Image& picture) : picture_(picture) {
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const auto around = cross_at(picture, x, y);
                if (!is_white(around[0]) && std::any_of(around.begin(), around.end(), is_white))
                    rim_.emplace_back(x, y);
            }
        }
    }
    [[nodiscard]] double distance(int x, int y) const {
        if (!is_white(picture_.at(x, y))) return 0;
        int nearest = 1 << 30;
        for (const glm::ivec2& pixel : rim_) {
            const glm::ivec2 apart = pixel - glm::ivec2(x, y);
            nearest = std::min(nearest, apart.x * apart.x + apart.y * apart.y);
        }
        return std::sqrt(double(nearest));
    }

private:
    image::Image picture_;
    std::vector<glm::ivec2> rim_;
};

class Outlines : public StudioTest {
protected:
    // All around the shape the line covers what lies within its width, corners too, and nothing farther off. The mask
    // knows the shape to half a pixel.
    static void expect_band(Stage& stage, const std::string& settings, double width, const std::string& filled = fill) {
        const image::Image plain = stage.picture(filled), picture = stage.picture(outlined(settings, filled));
        const int scale = plain.width() / stage.width();
        const Mask mask(plain);
        int unsure = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const double distance = mask.distance(x, y);
                if (distance == 0) continue;
                const bool within = distance <= width * scale - 1.0, beyond = distance > width * scale + 1.6;
                EXPECT_TRUE(!within || is_black(picture.at(x, y))) << settings << ": a gap at " << x << ", " << y;
                EXPECT_TRUE(!beyond || is_white(picture.at(x, y))) << settings << ": ink at " << x << ", " << y;
                unsure += !within && !beyond;
            }
        }
        EXPECT_GT(unsure, 0);
    }
};

TEST_F(Outlines, StencilSurroundsTheShapeAndLeavesItAlone) {
    for (const auto projection : {model::Projection::perspective, model::Projection::parallel}) {
        for (const int scale : {1, 2}) {
            Stage stage(studio(), {.view = seen_from({1, 0.7, 1.5}, projection), .pixel_scale = scale});
            for (const double width : {2.0, 5.0}) {
                expect_band(stage, fmt::format("method \"stencil\" ; width {} ;", width), width);
            }
            const image::Image plain = stage.picture(fill);
            const image::Image picture = stage.picture(outlined("method \"stencil\" ; width 5 ;"));
            expect_pixels(picture, [&](int x, int y) -> std::optional<glm::vec4> {
                if (is_white(plain.at(x, y))) return glm::vec4(picture.at(x, y)) / 255.0f;
                return glm::vec4(plain.at(x, y)) / 255.0f;
            });
        }
    }
}

TEST_F(Outlines, FrontFaceSurroundsTheShapeAsWideAsAsked) {
    for (const glm::dvec3& direction : {glm::dvec3(1, 0.7, 1.5), glm::dvec3(0, 0, 1), glm::dvec3(0.01, 0.3, 1)}) {
        Stage stage(studio(), {.view = seen_from(direction)});
        expect_band(stage, "method \"front_face\" ; width 3 ;", 3);
    }
}

TEST_F(Outlines, APartAloneIsSurroundedWhereItMeetsTheRestToo) {
    const ModelPointer model = model_of({{"left", quad_corners({-1, -1, 0}, {0, -1, 0}, {0, 1, 0}, {-1, 1, 0})},
                                         {"right", quad_corners({0, -1, 0}, {1, -1, 0}, {1, 1, 0}, {0, 1, 0})}});
    Stage stage(studio(), {.model = model, .view = seen_from({0.3, 0.2, 1})});
    expect_band(stage, "width 3 ; objects \"left\" ;", 3,
                "pass render_base surfaces { clear_color 1 1 1 ; objects \"left\" ; } ;");
}

TEST_F(Outlines, LinesEndAtTheNearPlane) {
    const ModelPointer floor = model_of({{"floor", quad_corners({-1, 0, 9}, {1, 0, 9}, {1, 0, -9}, {-1, 0, -9})}});
    model::ViewRequest view;
    view.eye = glm::dvec3(0.2, 0.4, 2);
    view.target = glm::dvec3(0, 0.3, -9);
    Stage stage(studio(), {.model = floor, .view = view});
    expect_band(stage, "width 3 ;", 3);
}

TEST_F(Outlines, SpecksAreLeftOut) {
    const auto board = [](float x, float side) {
        return quad_corners({x, 0, 0}, {x + side, 0, 0}, {x + side, side, 0}, {x, side, 0});
    };
    const ModelPointer model = model_of({{"large", board(0, 1)}, {"small", board(1.5f, 0.05f)}});
    Stage stage(studio(), {.model = model, .view = seen_from({0, 0, 1})});
    const auto ink = [&](const std::string& objects, double shortest) {
        const image::Image picture = stage.picture(
            fmt::format("pass outline lines {{ keep_color false ; width 2 ; shortest {} ; objects \"{}\" ; }} ;",
                        shortest, objects));
        return std::count(picture.pixels().begin(), picture.pixels().end(), black);
    };
    EXPECT_GT(ink("small", 0), 5);
    EXPECT_EQ(ink("small", 30), 0);
    EXPECT_EQ(ink("large", 30), ink("large", 0));
}

// A little cube before a large board.
ModelPointer cube_before_board(float gap) {
    return model_of({{"board", quad_corners({-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0})},
                     {"cube", box_corners({-0.5f, -0.5f, gap}, {0.5f, 0.5f, gap + 1})}});
}

// The middle of the picture, left of the cube: on the board, beside the cube's outline.
glm::u8vec4 beside_cube(const image::Image& picture, const Mask& cube, double width) {
    const int y = picture.height() / 2;
    for (int x = picture.width() / 2; x > 0; --x) {
        if (cube.distance(x, y) >= 0.5 * width) return picture.at(x, y);
    }
    return white;
}

TEST_F(Outlines, InnerLinesBelongToFrontFaceAlone) {
    Stage stage(studio(), {.model = cube_before_board(1), .view = seen_from({0, 0, 1}), .width = 100, .height = 100});
    const Mask cube(stage.picture("pass render_base surfaces { clear_color 1 1 1 ; objects \"cube\" ; } ;"));
    EXPECT_TRUE(is_black(beside_cube(stage.picture(outlined("method \"front_face\" ; width 4 ;")), cube, 4)));
    EXPECT_FALSE(is_black(beside_cube(stage.picture(outlined("method \"stencil\" ; width 4 ;")), cube, 4)));
    EXPECT_FALSE(is_black(
        beside_cube(stage.picture(outlined("objects \"board\" ; method \"front_face\" ; width 4 ;")), cube, 4)));
}

TEST_F(Outlines, BoundaryIsDrawnWiderThanInnerLines) {
    Stage stage(studio(), {.view = seen_from({1, 0.7, 1.5})});
    expect_band(stage, "width 1 ; boundary_width 4 ;", 4);
}

// The gap is 0.2 of the file's units; half the diagonal of the box is the unit of halo_depth.
TEST_F(Outlines, HaloShowsWhereTheDepthJumpsByMore) {
    const ModelPointer model = cube_before_board(0.2f);
    const double radius = model::SceneSpace::of(*model).radius;
    // The line stands at the depth of the cube's front, 1.2 before the board: the eye sees that edge as the outline.
    for (const auto projection : {model::Projection::perspective, model::Projection::parallel}) {
        Stage stage(studio(), {.model = model, .view = seen_from({0, 0, 1}, projection), .width = 100, .height = 100});
        const Mask cube(stage.picture("pass render_base surfaces { clear_color 1 1 1 ; objects \"cube\" ; } ;"));
        for (const double share : {0.9, 1.1}) {
            const auto settings = fmt::format("method \"halo\" ; width 4 ; halo_depth {} ;", share * 1.2 / radius);
            EXPECT_EQ(is_black(beside_cube(stage.picture(outlined(settings)), cube, 4)), share < 1) << share;
        }
    }
}

// Where a point of the cube stands in the picture.
glm::ivec2 pixel_of(const Stage& stage, const glm::dvec3& point) {
    const auto view = lines::Viewpoint::of(stage.camera(), stage.width(), stage.height());
    return view.project(model::SceneSpace::of(stage.model()).from_file(point)).position;
}

TEST_F(Outlines, StencilLinesAreTheEdgesThatFrontAndBackFacesShare) {
    Stage stage(studio(), {.view = seen_from({1, 0.7, 1.5}), .width = 160, .height = 120});
    const image::Image picture = stage.picture(outlined("method \"stencil_lines\" ; width 3 ;"));
    int drawn = 0;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double a : {-1.0, 1.0}) {
            for (const double b : {-1.0, 1.0}) {
                glm::dvec3 middle;
                middle[axis] = 0;
                middle[(axis + 1) % 3] = a;
                middle[(axis + 2) % 3] = b;
                // The eye sees the three faces towards +x, +y and +z: an edge is shared when one of its two is.
                const bool shared = a != b;
                const glm::ivec2 at = pixel_of(stage, middle);
                int black_pixels = 0;
                for (int dy = -2; dy <= 2; ++dy) {
                    for (int dx = -2; dx <= 2; ++dx) black_pixels += is_black(picture.at(at.x + dx, at.y + dy));
                }
                EXPECT_EQ(black_pixels >= 5, shared) << "axis " << axis << " at " << a << ", " << b;
                drawn += shared;
            }
        }
    }
    EXPECT_EQ(drawn, 6);
}

TEST_F(Outlines, MarksOfLinesDoNotOutliveTheirPass) {
    Stage stage(studio(), {.view = seen_from({1, 0.7, 1.5})});
    const std::string once = outlined("method \"stencil_lines\" ; width 3 ;");
    const std::string again = once + "\npass outline more { method \"stencil_lines\" ; width 3 ; color 0 0 0 ; } ;";
    EXPECT_EQ(stage.picture(once), stage.picture(again));
}

TEST_F(Outlines, WidthsInModelUnitsShrinkWithDistance) {
    Stage stage(studio(), {.model = icosphere(3), .view = seen_from({0, 0, 1}, model::Projection::parallel)});
    // A sphere of radius 1 in a box whose half diagonal is the square root of 3, and 90 % of the frame.
    const double pixels_per_radius = 0.9 * 48 / 2 * std::sqrt(3.0);
    expect_band(stage, "method \"stencil\" ; width_unit \"model\" ; width 10 ;", 0.1 * pixels_per_radius);
}

TEST_F(Outlines, OwnColorsAreTheSurfacesDarkened) {
    Stage stage(studio(), {.model = icosphere(2, plain("red", {0.8f, 0.2f, 0.1f})), .view = seen_from({0, 0, 1})});
    const image::Image plain_picture = stage.picture(fill);
    const image::Image picture = stage.picture(outlined("width 6 ; colors \"own\" ; darkening 0.5 ;"));
    int lines = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            if (!is_white(plain_picture.at(x, y)) || picture.at(x, y).y > 27) continue;
            EXPECT_NEAR(picture.at(x, y).x, 102, 1);
            EXPECT_NEAR(picture.at(x, y).y, 26, 1);
            ++lines;
        }
    }
    EXPECT_GT(lines, 200);
}

TEST_F(Outlines, InkStaysWithinItsOffsetsAndFollowsTheSeed) {
    Stage stage(studio(), {.view = seen_from({1, 0.7, 1.5}), .seed = 1});
    const std::string ink =
        "pass outline lines { method \"ink\" ; width 1 ; grain 0 ; occlude true ; offset 0.03 ; color 0 0 0 ; } ;";
    const image::Image first = stage.picture(ink);
    EXPECT_EQ(first, stage.picture(ink));
    stage.set_seed(2);
    EXPECT_NE(first, stage.picture(ink));
    // Beyond offset and width there is no ink.
    const Mask mask(stage.picture(fill));
    const double reach = 0.03 * std::sqrt(3.0) * 0.9 * 48 + 1.5;
    int inked = 0;
    for (int y = 0; y < first.height(); ++y) {
        for (int x = 0; x < first.width(); ++x) {
            if (is_white(first.at(x, y))) continue;
            ++inked;
            EXPECT_LE(mask.distance(x, y), reach);
        }
    }
    EXPECT_GT(inked, 100);
}

TEST(InkOffsets, StayWithinTheirAmountAndChangeSmoothly) {
    const ModelPointer sphere = icosphere(4);
    const model::Topology& topology = sphere->topology();
    const auto offsets = ink_offsets(*sphere, 0.5f, 0.4f, 3);
    float largest = 0;
    for (const glm::vec3& offset : offsets) largest = std::max(largest, glm::length(offset));
    EXPECT_LE(largest, 0.5f * std::sqrt(3.0f));
    EXPECT_GT(largest, 0.2f);
    // The smooth step's slope is at most 1.5, its ends at most 2 apart, on each of three axes.
    for (const model::Edge& edge : topology.edges) {
        const auto& [a, b] = edge.vertices;
        const float apart = glm::distance(topology.positions[a], topology.positions[b]) / std::sqrt(3.0f);
        EXPECT_LE(glm::distance(offsets[a], offsets[b]), 0.5f * 3.0f * 3.0f * apart / 0.4f);
    }
}

// Three sheets on one edge: two to the left of it and one to the right, or all to one side, as the eye moves round.
TEST(OutlineEdges, SharedEdgesOfManySheetsAreLinesWhereAllLieOnOneSide) {
    const auto sheet = [](const glm::vec3& outwards) {
        return std::vector<glm::vec3>{{0, 0, 0}, {0, 1, 0}, outwards + glm::vec3(0, 0.5f, 0)};
    };
    std::vector<glm::vec3> corners;
    for (const glm::vec3& outwards : {glm::vec3(1, 0, 0), glm::vec3(1, 0, 0.8f), glm::vec3(0.7f, 0, -1)}) {
        const auto more = sheet(outwards);
        corners.insert(corners.end(), more.begin(), more.end());
    }
    const ModelPointer model = model_of({{"fan", corners}});
    OutlineEdges edges(std::make_shared<const lines::Surface>(model));
    const auto spine_is_line = [&](const glm::dvec3& direction) {
        model::ViewRequest view = seen_from(direction, model::Projection::parallel);
        const auto camera = model::place_camera(*model, nullptr, view, 1);
        const auto found = edges.contours(lines::Viewpoint::of(camera, 100, 100), {true});
        const auto& topology = model->topology();
        return std::any_of(found.begin(), found.end(), [&](const EdgeWithFace& edge) {
            const auto& [a, b] = topology.edges[edge.edge].vertices;
            return topology.positions[a].x == 0 && topology.positions[b].x == 0;
        });
    };
    EXPECT_TRUE(spine_is_line({0, 0, 1}));     // all to the right
    EXPECT_TRUE(spine_is_line({0, 0, -1}));    // all to the left
    EXPECT_FALSE(spine_is_line({1, 0, 0.2}));  // the second to one side, the third to the other
}

TEST_F(Outlines, NothingIsUploadedWhileNothingChanges) {
    Stage stage(studio(), {.view = seen_from({1, 0.7, 1.5})});
    const auto technique = studio().open(outlined("method \"front_face\" ; width 3 ;"));
    stage.draw(*technique);
    const long long uploads = studio().counters().geometry_uploads;
    stage.draw(*technique);
    EXPECT_EQ(studio().counters().geometry_uploads, uploads);
}

}  // namespace
}  // namespace croquis::components
