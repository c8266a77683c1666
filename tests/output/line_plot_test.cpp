// Plots: labels as near to their lines as can be, and files of the promised kind.
#include "output/line_plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "base/error.h"
#include "base/random.h"
#include "image/image.h"

namespace croquis::output {
namespace {

double cost(const std::vector<double>& places, const std::vector<double>& wanted) {
    double sum = 0;
    for (std::size_t i = 0; i < places.size(); ++i) sum += std::pow(places[i] - wanted[i], 2);
    return sum;
}

bool are_apart(const std::vector<double>& places, double spacing) {
    for (std::size_t i = 1; i < places.size(); ++i) {
        if (places[i] - places[i - 1] < spacing - 1e-9) return false;
    }
    return true;
}

// Nearest places under these bounds are a convex problem: no small allowed move may come nearer.
TEST(LinePlot, LabelsAreApartAndAsNearAsCanBe) {
    const Random random(1, "labels");
    std::uint64_t next = 0;
    for (int trial = 0; trial < 50; ++trial) {
        std::vector<double> wanted;
        for (int i = 0; i < 20; ++i) wanted.push_back(200 * random.unit(next++));
        std::sort(wanted.begin(), wanted.end());
        const std::vector<double> places = spread_labels(wanted, 14);
        ASSERT_EQ(places.size(), wanted.size());
        ASSERT_TRUE(are_apart(places, 14));
        for (int move = 0; move < 200; ++move) {
            std::vector<double> moved = places;
            const auto from = std::size_t(20 * random.unit(next++)), to = std::size_t(20 * random.unit(next++));
            const double step = 2 * random.unit(next++) - 1;
            for (std::size_t i = std::min(from, to); i <= std::max(from, to); ++i) moved[i] += step;
            if (are_apart(moved, 14)) {
                EXPECT_GE(cost(moved, wanted), cost(places, wanted) - 1e-6);
            }
        }
    }
    EXPECT_EQ(spread_labels({1, 20, 40}, 10), (std::vector<double>{1, 20, 40}));
    EXPECT_EQ(spread_labels({5, 5}, 10), (std::vector<double>{0, 10}));
}

LinePlot two_lines() {
    return {.title = "a & b < c",
            .x_label = "x",
            .y_label = "y",
            .lines = {{"one", {{100, 1}, {1000, 1}}}, {"two", {{100, 2}, {1000, 7}}}}};
}

TEST(LinePlot, MakesTheKindOfFileThatIsAsked) {
    const std::string png = line_plot_bytes(two_lines(), "png");
    const image::Image picture = image::decode(std::as_bytes(std::span(png)), "plot.png");
    EXPECT_EQ(picture.width(), 960);
    EXPECT_EQ(picture.height(), 640);
    EXPECT_EQ(picture.at(0, 0), glm::u8vec4(255));
    EXPECT_EQ(line_plot_bytes(two_lines(), "svg").substr(0, 5), "<?xml");
    EXPECT_THROW((void)line_plot_bytes(two_lines(), "gif"), Error);
}

// The ends of the lines lie where both logarithms put them: the second line's at the right, above the first's by
// log 7 of what the axis spans.
TEST(LinePlot, LinesLieWhereTheirLogarithmsSay) {
    const std::string png = line_plot_bytes(two_lines(), "png");
    const image::Image picture = image::decode(std::as_bytes(std::span(png)), "plot.png");
    const double x_span = std::log(1000 * 1.05) - std::log(100 / 1.05),
                 y_span = std::log(7 * 1.15) - std::log(1 / 1.15);
    const int x = int(80 + 650 * (std::log(1000) - std::log(100 / 1.05)) / x_span);
    const int y = int(572 - 516 * (std::log(7) - std::log(1 / 1.15)) / y_span);
    EXPECT_NE(picture.at(x, y), glm::u8vec4(255)) << x << ',' << y;
    EXPECT_EQ(picture.at(x - 20, y + 20), glm::u8vec4(255));
}

}  // namespace
}  // namespace croquis::output
