// The fixed-function state of a draw, said in one place instead of left over from the last one.
#pragma once

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
    multiplied,     ///< in place of what the target holds, but multiplied by alpha: the frame holds them so
    over,           ///< colours not multiplied by alpha, onto a target that holds them multiplied
    over_premultiplied,
    multiply,
    screen,
    add,
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
    std::optional<Rectangle> within = std::nullopt;  ///< draw nothing outside
};

void apply(const DrawState& state);

/// Remembers the caller's framebuffer, viewport, program and fixed state, and puts them back at its end.
class SavedState {
public:
    SavedState();
    ~SavedState();
    SavedState(const SavedState&) = delete;
    SavedState& operator=(const SavedState&) = delete;

private:
    int draw_framebuffer_ = 0;
    int read_framebuffer_ = 0;
    int program_ = 0;
    int vertex_array_ = 0;
    int viewport_[4] = {};
    bool depth_test_ = false;
    bool blend_ = false;
    bool cull_ = false;
    bool scissor_ = false;
    bool polygon_offset_ = false;
    unsigned char depth_mask_ = 1;
    unsigned char color_mask_[4] = {1, 1, 1, 1};
};

}  // namespace croquis::gpu
