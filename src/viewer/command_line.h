// Pictures as text: the command that draws one, and its camera and light alone, to be copied and pasted.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "croquis/view.h"
#include "viewer/arrangement.h"

namespace croquis::viewer {

/// A word as a shell takes it: in quotes where it needs them.
[[nodiscard]] std::string shell_word(const std::string& word);

/// Camera and light as options of `croquis render`: `--eye X,Y,Z --target … --light …`.
[[nodiscard]] std::string camera_and_light(const View& view, const Light& light);

/// What such a text says; what it does not name stays as it is in `view` and `light`. Other words, a whole command for
/// one, are passed over. Throws Error for an option whose value is wrong, and where there is none of them.
void read_camera_and_light(const std::string& text, View& view, Light& light);

/// The command that draws a picture. `values` are those of variables, by `pass.variable`, `data_folders` the user's
/// own.
[[nodiscard]] std::string render_command(const std::string& model, const std::string& texture,
                                         const std::string& technique, const std::map<std::string, std::string>& values,
                                         const DrawOptions& options, const std::vector<std::string>& data_folders = {});

}  // namespace croquis::viewer
