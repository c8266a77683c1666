// What the tests of src/model share: small files in a folder of their own, shapes with known properties.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "../support/temporary_folder.h"
#include "base/error.h"
#include "model/load.h"

namespace croquis::model::testing {

/// Debian's assimp-testmodels.
inline const std::filesystem::path sample_folder = "/usr/share/assimp/models";

using test_support::TemporaryFolder;

/// The model of a text, as a file of that name.
inline std::shared_ptr<const Model> load_text(const std::string& name, std::string_view text,
                                              const LoadOptions& options = {}) {
    const TemporaryFolder folder;
    return load(folder.write(name, text), options);
}

/// The error that loading a text gives, its folder taken away; nothing where it loads.
inline std::string error_of(const std::string& name, std::string_view text) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.write(name, text);
    try {
        static_cast<void>(load(path));
    } catch (const Error& error) {
        std::string message = error.what();
        const std::string prefix = path.parent_path().string() + "/";
        for (std::size_t at = message.find(prefix); at != std::string::npos; at = message.find(prefix)) {
            message.erase(at, prefix.size());
        }
        return message;
    }
    return {};
}

constexpr std::string_view cube_points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
constexpr std::string_view cube_faces = "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

inline std::string cube() { return std::string(cube_points) + std::string(cube_faces); }

/// A sphere of that radius about a centre: rows of quads, fans at the poles. As OBJ text.
inline std::string sphere(int rows, int columns, double radius, double centre = 0) {
    std::string text;
    const auto add = [&](double x, double y, double z) {
        text +=
            fmt::format("v {:.17g} {:.17g} {:.17g}\n", centre + radius * x, centre + radius * y, centre + radius * z);
    };
    constexpr double pi = 3.14159265358979323846;
    add(0, 1, 0);
    for (int i = 1; i < rows; ++i) {
        for (int j = 0; j < columns; ++j) {
            const double t = pi * i / rows, p = 2 * pi * j / columns;
            add(std::sin(t) * std::sin(p), std::cos(t), std::sin(t) * std::cos(p));
        }
    }
    add(0, -1, 0);
    const auto at = [&](int i, int j) { return 2 + (i - 1) * columns + j % columns; };
    const int last = 2 + (rows - 1) * columns;
    for (int j = 0; j < columns; ++j) {
        text += fmt::format("f 1 {} {}\n", at(1, j), at(1, j + 1));
        for (int i = 1; i + 1 < rows; ++i) {
            text += fmt::format("f {} {} {} {}\n", at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
        }
        text += fmt::format("f {} {} {}\n", at(rows - 1, j), last, at(rows - 1, j + 1));
    }
    return text;
}

}  // namespace croquis::model::testing
