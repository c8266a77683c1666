// Fonts and colours of the user interface.
#pragma once

#include <imgui.h>

namespace croquis::viewer {

/// Loads fonts and sets sizes for a display `scale` times as fine as an ordinary one.
void set_appearance(float scale);

/// Letters of one width, for what stands below each other.
[[nodiscard]] ImFont* fixed_width_font();

/// How bright what was changed is shown.
inline const ImVec4 changed_color{1.0f, 0.82f, 0.45f, 1.0f};
inline const ImVec4 mistake_color{1.0f, 0.6f, 0.5f, 1.0f};

}  // namespace croquis::viewer
