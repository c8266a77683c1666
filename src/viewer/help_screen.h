// All commands with their keys and what they do, made from the registry of commands.
#pragma once

#include "viewer/commands.h"

namespace croquis::viewer {

/// Shows the help over the middle of the window. `is_open` becomes false when it is closed.
void show_help_screen(const Commands& commands, bool& is_open);

}  // namespace croquis::viewer
