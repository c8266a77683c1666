// What the viewer remembers from one day to the next, in the user's configuration folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "viewer/arrangement.h"

namespace croquis::viewer {

struct Settings {
    std::vector<std::string> recent_models;  ///< the newest first
    std::string technique = "cartoon";
    int window_width = 1280;
    int window_height = 720;
    double ui_scale = 0;           ///< of texts and panels; 0: what the display asks for
    int samples = 4;               ///< of a pixel while nothing moves
    double least_frame_rate = 30;  ///< to hold while something moves, at the cost of detail; 0: always full detail
    bool shows_panels = true;
    bool shows_overlay = false;
    bool has_inertia = false;
    std::string video = ".mp4";  ///< ending of recorded videos, one of video_endings
    Moves moves = Moves::object;
    LightStaysWith light_stays_with = LightStaysWith::viewer;

    static constexpr std::size_t most_recent = 12;
    void remember_model(const std::string& path);

    /// croquis/viewer.toml in XDG_CONFIG_HOME, or in .config of the home folder; empty where there is neither.
    [[nodiscard]] static std::filesystem::path default_path();

    /// Reads a file. What it does not say, or says wrongly, stays as it comes, with a warning: old settings must not
    /// keep the viewer from starting. A file that is not there is no mistake.
    [[nodiscard]] static Settings load(const std::filesystem::path& path);

    /// Writes a file, and the folder that it stands in. Throws Error.
    void save(const std::filesystem::path& path) const;
};

}  // namespace croquis::viewer
