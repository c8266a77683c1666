// The model that is drawn where none is named.
#pragma once

#include <string>

#include "commands.h"

namespace croquis::app {

/// Its path in the data folders. Throws Error where none of them has it.
[[nodiscard]] std::string built_in_model_path(const Common& common);

}  // namespace croquis::app
