#include "sample_models.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <iterator>

#include "base/files.h"

namespace croquis::bench {

std::string write_bumpy_torus(int triangles) {
    constexpr double turn = 6.283185307179586;
    const int around = int(std::lround(std::sqrt(triangles)));
    const int along = triangles / (2 * around);
    std::string text;
    auto out = std::back_inserter(text);
    for (int i = 0; i < around; ++i) {
        for (int k = 0; k < along; ++k) {
            const double u = turn * i / around, v = turn * k / along;
            const double thickness = 0.4 + 0.03 * std::sin(9 * u) * std::sin(5 * v);
            const double from_axis = 1.0 + thickness * std::cos(v);
            fmt::format_to(out, "v {:.6f} {:.6f} {:.6f}\n", from_axis * std::cos(u), thickness * std::sin(v),
                           from_axis * std::sin(u));
        }
    }
    const auto vertex = [&](int i, int k) { return (i % around) * along + k % along + 1; };
    for (int i = 0; i < around; ++i) {
        for (int k = 0; k < along; ++k) {
            fmt::format_to(out, "f {} {} {}\nf {} {} {}\n", vertex(i, k), vertex(i, k + 1), vertex(i + 1, k + 1),
                           vertex(i, k), vertex(i + 1, k + 1), vertex(i + 1, k));
        }
    }
    const auto path =
        std::filesystem::temp_directory_path() / fmt::format("croquis-bench-{}-{}.obj", ::getpid(), triangles);
    write_file_whole(path, text);
    return path.string();
}

}  // namespace croquis::bench
