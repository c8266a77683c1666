// The triangles and shaders of strokes against the share of each pixel that lies within half a width of the spine.
#include "base/random.h"
#include "components/ink.h"
#include "components/stroke_geometry.h"
#include "support/studio.h"

namespace croquis::components {
namespace {

using namespace test_support;

constexpr int width = 96, height = 72;

class Strokes : public StudioTest {
protected:
    struct Ink {
        glm::vec4 color{0.0f, 0.0f, 0.0f, 1.0f};
        lines::StrokeEnds ends = lines::StrokeEnds::round;
        int pixel_scale = 1;
    };

    static image::Image draw(const std::vector<Spine>& spines, const Ink& ink) {
        return draw(studio().resources(), spines, ink);
    }

    // Draws spines over white.
    static image::Image draw(framework::Resources& resources, const std::vector<Spine>& spines, const Ink& ink) {
        lines::Strokes strokes;
        strokes.brushes = {lines::Brush{ink.ends, ""}};
        for (const Spine& spine : spines) {
            lines::Stroke stroke;
            stroke.closed = spine.closed;
            stroke.first_point = std::uint32_t(strokes.points.size());
            stroke.point_count = std::uint32_t(spine.points.size());
            for (std::size_t i = 0; i < spine.points.size(); ++i) {
                strokes.points.push_back({spine.points[i], 0.0f, float(spine.widths[i]), ink.color, 0.0f});
            }
            strokes.strokes.push_back(stroke);
        }
        const auto geometry = upload(resources.gpu(), triangles_of(strokes, float(ink.pixel_scale)));
        const auto target = [&](gpu::TextureFormat format) {
            return std::make_shared<gpu::Texture>(resources.gpu(), format, width * ink.pixel_scale,
                                                  height * ink.pixel_scale);
        };
        const gpu::Framebuffer frame(resources.gpu(), target(gpu::TextureFormat::rgba8),
                                     target(gpu::TextureFormat::depth));
        frame.clear_color({1, 1, 1, 1});
        const auto program = resources.program("strokes:stroke_corner", "strokes:even_ink");
        frame.bind();
        gpu::apply({.blend = gpu::Blend::over_premultiplied});
        program->use();
        program->set("frame_size", glm::vec2(frame.width(), frame.height()));
        geometry->draw();
        const std::vector<std::uint8_t> bytes = frame.read_pixels();
        image::Image picture(frame.width(), frame.height());
        for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
            picture.pixels()[i] = {bytes[4 * i], bytes[4 * i + 1], bytes[4 * i + 2], bytes[4 * i + 3]};
        }
        return picture;
    }
    static image::Image draw(const std::vector<Spine>& spines) { return draw(spines, Ink{}); }
};

Spine even(std::vector<glm::dvec2> points, double stroke_width, bool closed = false) {
    Spine spine{std::move(points), {}, closed};
    spine.widths.assign(spine.points.size(), stroke_width);
    return spine;
}

Spine enlarged(Spine spine, double factor) {
    for (glm::dvec2& point : spine.points) point *= factor;
    for (double& one : spine.widths) one *= factor;
    return spine;
}

double ink_of(const image::Image& picture) {
    double sum = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) sum += ink_at(picture, x, y);
    }
    return sum;
}

// A walk of so many steps that turns by less than an angle at each point.
Spine random_walk(const Random& random, std::uint64_t& next, double stroke_width, int steps, double step,
                  double largest_turn) {
    glm::dvec2 at(random.between(20, width - 20, next), random.between(20, height - 20, next + 1));
    double angle = random.between(0, 6.28, next + 2);
    next += 3;
    std::vector<glm::dvec2> points{at};
    for (int i = 0; i < steps; ++i) {
        angle += random.between(-largest_turn, largest_turn, next++);
        at += step * glm::dvec2(std::cos(angle), std::sin(angle));
        points.push_back(at);
    }
    return even(std::move(points), stroke_width);
}

TEST_F(Strokes, CoverWhatLiesWithinHalfAWidthOfTheSpine) {
    const Random random(1, "spines");
    std::uint64_t next = 0;
    for (const double stroke_width : {0.5, 1.0, 2.0, 5.0, 12.0}) {
        for (const double largest_turn : {0.0, 0.5, 3.1}) {
            const Spine spine = random_walk(random, next, stroke_width, 6, 11.0, largest_turn);
            const InkDifference apart = difference(draw({spine}), coverage({spine}, width, height));
            // Coverage by distance differs from coverage by area where a border crosses a pixel's diagonal, more so at
            // the ends of lines thinner than a pixel; where a stroke crosses itself, shares of a pixel add up.
            EXPECT_LT(apart.largest, stroke_width < 1 || largest_turn > 1 ? 0.3 : 0.16)
                << "width " << stroke_width << ", turns to " << largest_turn;
            EXPECT_LT(apart.mean, 0.004) << "width " << stroke_width << ", turns to " << largest_turn;
        }
    }
}

TEST_F(Strokes, HoldTheInkOfTheirArea) {
    const Random random(2, "spines");
    std::uint64_t next = 0;
    for (const double stroke_width : {0.25, 0.5, 1.0, 2.0, 5.0}) {
        const double angle = random.between(0, 6.28, next++);
        const glm::dvec2 centre(48, 36), half = 15.0 * glm::dvec2(std::cos(angle), std::sin(angle));
        const Spine spine = even({centre - half, centre + half}, stroke_width);
        const double radius = 0.5 * stroke_width;
        const double disc = std::acos(-1.0) * radius * radius, area = 30.0 * stroke_width + disc;
        EXPECT_NEAR(ink_of(draw({spine})), area, 0.02 * area + 0.3) << "width " << stroke_width;
        const image::Image square = draw({spine}, {.ends = lines::StrokeEnds::butt});
        EXPECT_NEAR(ink_of(square), area - disc, 0.02 * area + 0.1) << "width " << stroke_width;
    }
}

TEST_F(Strokes, AreAsWideOnTheScreenAsAskedAtEverySampleCount) {
    const Spine spine = even({{20, 20}, {70, 30}, {40, 60}}, 3.0);
    for (const int scale : {1, 2, 4}) {
        const Spine large = enlarged(spine, scale);
        const InkDifference apart =
            difference(draw({spine}, {.pixel_scale = scale}), coverage({large}, width * scale, height * scale));
        EXPECT_LT(apart.largest, 0.16) << "scale " << scale;
        EXPECT_LT(apart.mean, 0.004) << "scale " << scale;
    }
}

// Where a stroke covers a pixel wholly, ink of half opacity leaves half of the white: at joints too.
TEST_F(Strokes, OfHalfOpacityAreEvenAtTheirJoints) {
    const Random random(3, "spines");
    std::uint64_t next = 0;
    for (const double stroke_width : {2.0, 5.0, 7.0}) {
        for (const double largest_turn : {0.3, 1.2}) {
            const Spine spine = random_walk(random, next, stroke_width, 3, 17.0, largest_turn);
            const image::Image picture = draw({spine}, {.color = {0, 0, 0, 0.5f}});
            const image::Raster<double> truth = coverage({spine}, width, height);
            int inside = 0, uneven = 0;
            for (int y = 0; y < height; ++y) {
                for (int x = 0; x < width; ++x) {
                    if (depth_in_ink(spine, {x + 0.5, y + 0.5}) < 0.75) continue;
                    ++inside;
                    uneven += std::abs(ink_at(picture, x, y) - 0.5) > 0.01;
                }
            }
            EXPECT_GT(inside, stroke_width > 2 ? 60 : 10);
            EXPECT_EQ(uneven, 0) << "width " << stroke_width << ", turns to " << largest_turn;
        }
    }
}

TEST_F(Strokes, TurnSharplyWithoutGapsAndWithoutDarkening) {
    for (const double degrees : {91.0, 120.0, 150.0, 165.0, -91.0, -120.0, -150.0, -165.0}) {
        const double turn = degrees * std::acos(-1.0) / 180.0;
        const glm::dvec2 corner(48, 36);
        const Spine spine =
            even({corner - glm::dvec2(33, 0), corner, corner + 33.0 * glm::dvec2(std::cos(turn), std::sin(turn))}, 4.0);
        const image::Image picture = draw({spine}, {.color = {0, 0, 0, 0.5f}});
        const image::Raster<double> truth = coverage({spine}, width, height);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                EXPECT_NEAR(ink_at(picture, x, y), 0.5 * truth.at(x, y), 0.08) << degrees << " at " << x << ", " << y;
            }
        }
    }
}

TEST_F(Strokes, CloseWithoutASeam) {
    std::vector<glm::dvec2> ring;
    for (int i = 0; i < 40; ++i) {
        const double angle = i * std::acos(-1.0) / 20;
        ring.push_back(glm::dvec2(48, 36) + 25.0 * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    const Spine spine = even(std::move(ring), 5.0, true);
    const image::Image picture = draw({spine}, {.color = {0, 0, 0, 0.5f}});
    const image::Raster<double> truth = coverage({spine}, width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) ASSERT_NEAR(ink_at(picture, x, y), 0.5 * truth.at(x, y), 0.08);
    }
}

TEST_F(Strokes, ChangeWidthAlongTheSpine) {
    const Spine spine{{{12, 20}, {45, 45}, {80, 30}}, {0, 8, 1}, false};
    const InkDifference apart = difference(draw({spine}), coverage({spine}, width, height));
    EXPECT_LT(apart.largest, 0.25);  // a border that is not parallel to the spine is crossed at an angle
    EXPECT_LT(apart.mean, 0.004);
}

// Curves that turn within less than the half width, that stand still and that turn straight back, are filled.
TEST_F(Strokes, FillTightBends) {
    std::vector<glm::dvec2> points{{48, 10}};
    for (int i = 0; i <= 30; ++i) {
        const double angle = i * std::acos(-1.0) / 30;
        points.push_back(glm::dvec2(50, 40) + 2.0 * glm::dvec2(-std::cos(angle), std::sin(angle)));
    }
    points.insert(points.end(), {{52, 10}, {52, 10}, {52, 30}});
    const Spine spine = even(std::move(points), 9.0);
    const InkDifference apart = difference(draw({spine}), coverage({spine}, width, height));
    EXPECT_LT(apart.largest, 0.3);  // where borders of two pieces overlap, their shares of a pixel add up
    EXPECT_LT(apart.mean, 0.01);
}

TEST_F(Strokes, MixTheirColourWithWhatIsThere) {
    const Spine spine = even({{20, 36}, {70, 36}}, 6.0);
    const image::Image picture = draw({spine}, {.color = {0.2f, 0.4f, 0.6f, 0.5f}});
    EXPECT_LE(glm::distance(glm::vec4(picture.at(45, 36)), glm::vec4(153, 178.5f, 204, 255)), 1.5f);
    EXPECT_EQ(picture.at(45, 20), glm::u8vec4(255));
}

TEST_F(Strokes, AreTheSameOnBothApis) {
    const Spine spine{{{12, 20}, {45, 45}, {80, 30}, {20, 60}}, {1, 8, 2, 3}, true};
    std::vector<image::Image> pictures;
    for (const gpu::Api api : {gpu::Api::gl, gpu::Api::gles}) {
        gpu::ContextOptions options = gpu::ContextOptions::from_environment();
        options.api = api;
        const std::unique_ptr<gpu::Context> context = gpu::Context::headless(options);
        framework::Resources resources(*context, studio().resources().folders());
        pictures.push_back(draw(resources, {spine}, {.color = {0.2f, 0.4f, 0.6f, 0.7f}}));
    }
    studio().context().make_current();
    EXPECT_TRUE(same_pixels(pictures.front(), pictures.back()));
}

TEST_F(Strokes, OfOnePointAreDots) {
    const Spine dot = even({{30.3, 40.6}}, 6.0);
    EXPECT_NEAR(ink_of(draw({dot})), std::acos(-1.0) * 9.0, 0.4);
    EXPECT_NEAR(ink_of(draw({even({{30.3, 40.6}, {30.3, 40.6}}, 6.0)})), std::acos(-1.0) * 9.0, 0.4);
    EXPECT_EQ(ink_of(draw({})), 0);
}

}  // namespace
}  // namespace croquis::components
