// The fixed-function state of a draw, said in one place instead of left over from the last one.
#pragma once

#include <memory>
#include <optional>

namespace croquis::gpu {

/// Pixels of a target, from its lower left.
struct Rectangle {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

enum class Cull { none, back, front };
enum class DepthTest { off, nearer, nearer_or_equal };
enum class Blend {
    off,
    multiplied,  ///< in place of what the target holds, but multiplied by alpha: the frame holds them so
    over,        ///< colours not multiplied by alpha, onto a target that holds them multiplied
    over_premultiplied,
    multiply,
    screen,
    add,
};

/// The bits of the stencil: what earlier draws left there since the depth was cleared.
constexpr unsigned surface_mark = 1, line_mark = 2;

enum class Stencil {
    off,
    mark_surface,      ///< marks what is drawn as surface
    outside_surfaces,  ///< draws only where no surface was
    mark_line,         ///< marks what is drawn as line
    take_line_mark,    ///< draws only where a line was marked, and takes the mark away
};

/// Everything fixed that a draw depends on.
struct DrawState {
    DepthTest depth_test = DepthTest::off;
    bool write_depth = false;
    bool write_color = true;
    Blend blend = Blend::off;
    Cull cull = Cull::none;
    /// Pushes surfaces away from the eye so that lines on them show: glPolygonOffset's factor and units.
    float push_back = 0;
    Stencil stencil = Stencil::off;
    std::optional<Rectangle> within = std::nullopt;  ///< draw nothing outside
};

void apply(const DrawState& state);

/// Remembers the caller's bindings, viewport and fixed state, as far as drawing changes them, and puts them back at its
/// end. Drawing begins without the caller's scissor box.
class SavedState {
public:
    SavedState();
    ~SavedState();
    SavedState(const SavedState&) = delete;
    SavedState& operator=(const SavedState&) = delete;

private:
    struct Groups;
    std::unique_ptr<Groups> groups_;
};

}  // namespace croquis::gpu
