// Model files for tests of the public API, which reads models from files alone.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "croquis/croquis.h"
#include "support/temporary_folder.h"

namespace croquis::test_support {

/// How a shape's vertices are moved and its faces wound.
struct Placement {
    double scale = 1;
    double offset = 0;  ///< on all axes, after scaling
    enum class Winding { right, inside_out, every_third_flipped };
    Winding winding = Winding::right;
};

/// An OBJ text under construction.
class ObjText {
public:
    explicit ObjText(const Placement& placement) : placement_(placement) {}
    void vertex(double x, double y, double z) {
        const auto place = [&](double v) { return placement_.offset + placement_.scale * v; };
        text_ += fmt::format("v {:.17g} {:.17g} {:.17g}\n", place(x), place(y), place(z));
    }
    void triangle(int a, int b, int c) {
        const bool flip = placement_.winding == Placement::Winding::inside_out ||
                          (placement_.winding == Placement::Winding::every_third_flipped && faces_ % 3 == 0);
        ++faces_;
        text_ += flip ? fmt::format("f {} {} {}\n", a, c, b) : fmt::format("f {} {} {}\n", a, b, c);
    }
    [[nodiscard]] Model load() const {
        const TemporaryFolder folder;
        return Model::load(folder.write("shape.obj", text_).string());
    }

private:
    Placement placement_;
    std::string text_;
    int faces_ = 0;
};

inline Model cube_file(const Placement& placement = {}) {
    ObjText text(placement);
    for (int i = 0; i < 8; ++i) text.vertex(i & 1, (i >> 1) & 1, (i >> 2) & 1);
    constexpr int quads[6][4] = {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5}, {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}};
    for (const auto& q : quads) {
        text.triangle(q[0], q[1], q[2]);
        text.triangle(q[0], q[2], q[3]);
    }
    return text.load();
}

/// A ring about the y axis: it has an inside, so that wrong hiding shows.
inline Model torus_file(const Placement& placement = {}) {
    ObjText text(placement);
    constexpr int around = 24, across = 12;
    constexpr double pi = 3.14159265358979323846;
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            const double u = 2 * pi * i / around, v = 2 * pi * j / across, r = 1 + 0.4 * std::cos(v);
            text.vertex(r * std::cos(u), 0.4 * std::sin(v), r * std::sin(u));
        }
    }
    const auto at = [](int i, int j) { return 1 + (i % around) * across + j % across; };
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            text.triangle(at(i, j), at(i, j + 1), at(i + 1, j + 1));
            text.triangle(at(i, j), at(i + 1, j + 1), at(i + 1, j));
        }
    }
    return text.load();
}

/// A small picture with the other options as they come.
inline DrawOptions small(int width = 120, int height = 90) {
    DrawOptions options;
    options.width = width;
    options.height = height;
    return options;
}

}  // namespace croquis::test_support
