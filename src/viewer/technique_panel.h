// The list of techniques, each with its name, help and a small picture of the model.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viewer/session.h"
#include "viewer/thumbnails.h"

namespace croquis::viewer {

/// Shows the list at the cursor of the window and says which technique was clicked.
[[nodiscard]] std::optional<std::string> show_techniques(const std::vector<std::string>& names, const Session& session,
                                                         Thumbnails& thumbnails, bool scroll_to_chosen);

}  // namespace croquis::viewer
