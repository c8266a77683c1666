// Models as smooth surfaces or in fewer faces: the options that all commands which draw models share.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <optional>
#include <string>

#include "croquis/model.h"

namespace croquis::app {

/// How often, and how, a model's faces are subdivided, and in how many triangles it is drawn then.
struct ShapeOptions {
    int levels = 0;
    std::string scheme = "loop";
    std::optional<std::size_t> triangles;

    void add_subdivision_to(CLI::App& command);
    void add_simplification_to(CLI::App& command);

    /// The model as these options say: subdivided first. Throws Error.
    [[nodiscard]] Model applied_to(Model model) const;
};

}  // namespace croquis::app
