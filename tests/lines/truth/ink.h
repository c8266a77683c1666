// Drawings against each other: the same ink, whichever lines it belongs to.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "lines/drawing.h"
#include "lines/viewpoint.h"

namespace croquis::lines::truth {

/// A straight piece of a line that a test expects, in scene space.
struct Stroke3 {
    glm::dvec3 from, to;
    LineClass line_class = LineClass::silhouette;
    std::uint32_t layers = 0;
    std::uint32_t mesh = 0;
};

/// What must be alike of two lines at a place.
struct Alike {
    bool depth = true;
    bool mesh = false;
    bool line_class = true;
};

/// The drawing of strokes, uncut: they must lie in the frame.
[[nodiscard]] Drawing drawing_of(const Viewpoint& view, const std::vector<Stroke3>& strokes);

/// Ink of one drawing that the other has not, in pixels: (only in `one`) + (only in `other`). `text` gets examples.
[[nodiscard]] double difference(const Viewpoint& view, const Drawing& one, const Drawing& other, std::string& text,
                                const Alike& alike = {}, double reach = 1e-4);

/// Visible ink that lies on visible ink of another line, or of another part of its own, in pixels; at any depth.
[[nodiscard]] double doubled_ink(const Viewpoint& view, const Drawing& drawing, std::string& text);

/// Length in pixels of the lines of a class that `layers` layers hide.
[[nodiscard]] double length_of(const Drawing& drawing, LineClass line_class, std::uint32_t layers = 0);
[[nodiscard]] double length_of(const Drawing& drawing);
[[nodiscard]] std::size_t count_of(const Drawing& drawing, LineClass line_class, std::uint32_t layers = 0);

/// Lines in words, for messages.
[[nodiscard]] std::string text_of(const Drawing& drawing);

}  // namespace croquis::lines::truth
