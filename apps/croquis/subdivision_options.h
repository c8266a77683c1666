// Models as smooth surfaces: the options that all commands which draw models share.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "croquis/model.h"

namespace croquis::app {

/// How often, and how, a model's faces are subdivided.
struct SubdivisionOptions {
    int levels = 0;
    std::string scheme = "loop";

    void add_to(CLI::App& command);

    /// The model as these options say. Throws Error.
    [[nodiscard]] Model applied_to(Model model) const;
};

}  // namespace croquis::app
