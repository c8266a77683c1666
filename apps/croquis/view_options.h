// How a model is looked at: the options that all commands which draw models share.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "croquis/view.h"

namespace croquis::app {

/// Where the eye stands, and the moment of an animation, as a person types them.
struct ViewOptions {
    std::string direction = "1,0.7,1";
    double fit = 0.9;
    std::string eye, target;
    std::string up = "0,1,0";
    double field_of_view = 40;
    std::string projection = "perspective";
    std::string animation;
    double time = 0;

    void add_to(CLI::App& command);

    /// Throws Error for what is no view.
    [[nodiscard]] View view() const;
};

}  // namespace croquis::app
